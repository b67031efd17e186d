#include "views/ui/colorbutton.h"

#include <QColorDialog>
#include <QPixmap>

namespace autocuts {

ColorButton::ColorButton(const QString &title, QWidget *parent) : QPushButton(parent), mTitle(title)
{
    setIconSize({40, 16});
    setAutoDefault(false);
    connect(this, &QPushButton::clicked, this, &ColorButton::choose);
}

void ColorButton::setColor(const QColor &color)
{
    if (color == mColor)
        return;
    mColor = color;
    QPixmap swatch(iconSize() * devicePixelRatioF());
    swatch.setDevicePixelRatio(devicePixelRatioF());
    swatch.fill(color);
    setIcon(swatch);
    setText(QLatin1Char(' ') + color.name().toUpper());
    Q_EMIT colorChanged();
}

void ColorButton::choose()
{
    const QColor chosen = QColorDialog::getColor(mColor, this, mTitle);
    if (chosen.isValid())
        setColor(chosen);
}

} // namespace autocuts
