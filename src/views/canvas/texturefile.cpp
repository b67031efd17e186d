#include "views/canvas/texturefile.h"

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
    // The result is handed over through the thread that this object lives in; a receiver that is gone, or
    // wants another file by then, drops it.
    QThreadPool::globalInstance()->start([path, self = QPointer<TextureFile>(this), thread = this->thread()] {
        auto messenger = std::make_unique<QObject>();
        messenger->moveToThread(thread);
        QImage image = readPicture(path);
        QObject *target = messenger.release();
        QMetaObject::invokeMethod(
            target,
            [path, self, image = std::move(image), target] {
                target->deleteLater();
                if (!self || self->mPath != path)
                    return;
                self->mImage = image;
                Q_EMIT self->changed();
            },
            Qt::QueuedConnection);
    });
}

} // namespace autocuts
