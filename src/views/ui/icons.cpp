// Icons are tinted by painting an SVG once and filling the painted area with a colour.
#include "views/ui/icons.h"

#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

//! Needed because the resources are in a static library, where the linker would drop them. Must be outside of
//! any namespace.
static void initResources()
{
    Q_INIT_RESOURCE(autocuts);
}

namespace autocuts {

namespace {

QString iconFile(const QString &name)
{
    [[maybe_unused]] static const bool initialized = (initResources(), true);
    return QStringLiteral(":/icons/%1.svg").arg(name);
}

QColor tint(QIcon::Mode mode)
{
    const QPalette palette = QGuiApplication::palette();
    switch (mode) {
    case QIcon::Disabled:
        return palette.color(QPalette::Disabled, QPalette::ButtonText);
    case QIcon::Selected:
        return palette.color(QPalette::Active, QPalette::HighlightedText);
    default:
        return palette.color(QPalette::Active, QPalette::ButtonText);
    }
}

enum class IconColors { Text, Accent, File };

//! Paints an SVG file at any size.
class SvgIconEngine final : public QIconEngine
{
public:
    SvgIconEngine(const QString &file, IconColors colors)
        : mFile(file), mTinted(colors != IconColors::File), mColors(colors)
    {}

    QIconEngine *clone() const override { return new SvgIconEngine(mFile, mColors); }
    QString key() const override { return QStringLiteral("autocuts-svg"); }

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State state) override
    {
        const qreal ratio = painter->device()->devicePixelRatio();
        painter->drawPixmap(rect, scaledPixmap((QSizeF(rect.size()) * ratio).toSize(), mode, state, ratio));
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        return scaledPixmap(size, mode, state, 1);
    }

    //! \param size in device pixels
    QPixmap scaledPixmap(const QSize &size, QIcon::Mode mode, QIcon::State, qreal ratio) override
    {
        const bool onAccent = mColors == IconColors::Accent && mode != QIcon::Disabled;
        const QColor color = mTinted ? tint(onAccent ? QIcon::Selected : mode) : QColor();
        const QString key = QStringLiteral("%1|%2x%3|%4|%5")
                                .arg(mFile)
                                .arg(size.width())
                                .arg(size.height())
                                .arg(mTinted ? qint64(color.rgba()) : -1 - qint64(mode == QIcon::Disabled))
                                .arg(ratio);
        QPixmap result;
        if (!QPixmapCache::find(key, &result)) {
            result = QPixmap::fromImage(rendered(size, color, mode));
            result.setDevicePixelRatio(ratio);
            QPixmapCache::insert(key, result);
        }
        return result;
    }

private:
    QImage rendered(const QSize &size, const QColor &color, QIcon::Mode mode) const
    {
        QImage image(size, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        if (size.isEmpty())
            return image;
        QPainter painter(&image);
        const int side = std::min(size.width(), size.height());
        const QRect square((size.width() - side) / 2, (size.height() - side) / 2, side, side);
        if (!mTinted && mode == QIcon::Disabled)
            painter.setOpacity(0.4);
        QSvgRenderer(mFile).render(&painter, square);
        if (mTinted) {
            painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
            painter.fillRect(image.rect(), color);
        }
        return image;
    }

    QString mFile;
    bool mTinted;
    IconColors mColors;
};

QIcon iconIn(IconColors colors, const QString &name)
{
    const QString file = iconFile(name);
    return QFile::exists(file) ? QIcon(new SvgIconEngine(file, colors)) : QIcon();
}

} // namespace

QIcon icon(const QString &name)
{
    return iconIn(IconColors::Text, name);
}

QIcon accentIcon(const QString &name)
{
    return iconIn(IconColors::Accent, name);
}

QIcon coloredIcon(const QString &name)
{
    return iconIn(IconColors::File, name);
}

QIcon applicationIcon()
{
    return coloredIcon(QStringLiteral("autocuts"));
}

QStringList iconNames()
{
    QStringList names = QDir(QFileInfo(iconFile(QStringLiteral("open"))).path()).entryList(QDir::Files);
    for (QString &name : names)
        name.chop(4);
    return names;
}

} // namespace autocuts
