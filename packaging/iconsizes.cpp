// iconsizes SVG FOLDER SIZE...: draws the program's icon as FOLDER/SIZE.png, for desktops that want pixels.
#include <QCoreApplication>
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

int main(int argc, char *argv[])
{
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments().mid(1);
    QSvgRenderer drawing(arguments.value(0));
    if (!drawing.isValid())
        return 1;
    for (const QString &size : arguments.mid(2)) {
        QImage picture(size.toInt(), size.toInt(), QImage::Format_ARGB32);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        drawing.render(&painter);
        painter.end();
        if (!picture.save(QDir(arguments[1]).filePath(size + QStringLiteral(".png"))))
            return 1;
    }
    return 0;
}
