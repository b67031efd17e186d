// A button for choosing a colour.
#pragma once

#include "model/plain/shadedsurface.h"

#include <QColor>
#include <QPushButton>

namespace autocuts {

//! Shows a colour and opens a dialog to choose another one.
class ColorButton final : public QPushButton
{
    Q_OBJECT

public:
    //! \param title title of the colour dialog
    explicit ColorButton(const QString &title, QWidget *parent = nullptr);

    const QColor &color() const { return mColor; }
    void setColor(const QColor &color);
    //! In linear light; a part above 1 is shown as 1.
    Vec3f linear() const;
    void setLinear(const Vec3f &color);

Q_SIGNALS:
    void colorChanged();

private:
    void choose();

    QString mTitle;
    QColor mColor;
};

} // namespace autocuts
