// A label that is shortened when there is little space.
#pragma once

#include <QWidget>

namespace autocuts {

//! Shows one line, shortened by an ellipsis when it does not fit; the full text is then in the tooltip.
class ElidedLabel final : public QWidget
{
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget *parent = nullptr);

    const QString &text() const { return mText; }
    void setText(const QString &text);

    //! Limits the width to that of the text, up to this value. Otherwise the label takes all available space.
    void setWidest(int width);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void updateToolTip();

    QString mText;
    int mWidest = 0; //!< 0: no limit
};

} // namespace autocuts
