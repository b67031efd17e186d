#include "views/ui/colorbutton.h"

#include "model/plain/picture.h"

#include <QColorDialog>
#include <QPixmap>

#include <algorithm>

namespace autocuts {

ColorButton::ColorButton(const QString &title, QWidget *parent) : QPushButton(parent), mTitle(title)
{
    setIconSize({40, 16});
    setAutoDefault(false);
    connect(this, &QPushButton::clicked, this, &ColorButton::choose);
}

Vec3f ColorButton::linear() const
{
    const auto part = [](int value) { return linearFromSrgb(static_cast<float>(value) / 255); };
    return {part(mColor.red()), part(mColor.green()), part(mColor.blue())};
}

void ColorButton::setLinear(const Vec3f &color)
{
    const auto part = [](float value) { return std::clamp(srgbFromLinear(value), 0.0F, 1.0F); };
    setColor(QColor::fromRgbF(part(color.x()), part(color.y()), part(color.z())));
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
