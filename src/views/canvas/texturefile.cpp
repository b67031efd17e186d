#include "views/canvas/texturefile.h"

#include "views/gl/picturereading.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

namespace autocuts {

void TextureFile::setPath(const QString &path)
{
    if (path == mPath)
        return;
    mPath = path;
    mPictures = {};
    Q_EMIT changed();
    if (path.isEmpty())
        return;
    // The result is passed to the GUI thread and ignored there when another file has been chosen.
    QThreadPool::globalInstance()->start([path, self = QPointer<TextureFile>(this)] {
        QStringList problems; // whoever set the path has looked whether there is a picture
        const auto takeOver = [path, self, pictures = readPictures({{path, {}, path}}, problems)] {
            if (!self || self->mPath != path)
                return;
            self->mPictures = pictures;
            Q_EMIT self->changed();
        };
        QMetaObject::invokeMethod(QCoreApplication::instance(), takeOver, Qt::QueuedConnection);
    });
}

} // namespace autocuts
