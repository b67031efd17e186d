#include "views/canvas/texturefile.h"

#include <QCoreApplication>
#include <QImageReader>
#include <QPointer>
#include <QThreadPool>

namespace autocuts {

namespace {

QImage readPicture(const QString &path)
{
    QImageReader reader(path);
    reader.setAutoTransform(true);
    return reader.read();
}

} // namespace

void TextureFile::setPath(const QString &path)
{
    if (path == mPath)
        return;
    mPath = path;
    mImage = QImage();
    Q_EMIT changed();
    if (path.isEmpty())
        return;
    // The result is passed to the GUI thread and ignored there when another file has been chosen.
    QThreadPool::globalInstance()->start([path, self = QPointer<TextureFile>(this)] {
        const auto takeOver = [path, self, image = readPicture(path)] {
            if (!self || self->mPath != path)
                return;
            self->mImage = image;
            Q_EMIT self->changed();
        };
        QMetaObject::invokeMethod(QCoreApplication::instance(), takeOver, Qt::QueuedConnection);
    });
}

} // namespace autocuts
