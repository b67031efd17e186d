#include "views/canvas/texturefile.h"

#include "views/gl/picturereading.h"
#include "views/ui/pooltask.h"

#include <QPointer>

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
    const auto show = [path, self = QPointer<TextureFile>(this)](const Pictures &pictures) {
        if (!self || self->mPath != path)
            return;
        self->mPictures = pictures;
        Q_EMIT self->changed();
    };
    runOnPool(
        backgroundPool(),
        [path] {
            QStringList problems; // whoever set the path has looked whether there is a picture
            return readPictures({{path, {}, path}}, problems);
        },
        show, [show](const QString &) { show({}); });
}

} // namespace autocuts
