#include "jobs/lightmapfiles.h"

#include "jobs/jobtexts.h"

#include <QFileInfo>

namespace autocuts::jobs {

using namespace Qt::Literals::StringLiterals;

namespace {

bool isExr(const QString &path)
{
    return path.endsWith(u".exr"_s, Qt::CaseInsensitive);
}

} // namespace

Result<PictureDepth> lightMapDepth(const QString &path, int bits)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    const bool floats = isExr(path);
    if (!floats && suffix != u"png" && suffix != u"tif" && suffix != u"tiff" && suffix != u"tga")
        return Error{JobTexts::tr("light is baked into exr, png, tif and tga files"), path, 0,
                     JobTexts::tr("Choose a file name that ends in .exr, .png, .tif or .tga")};
    const QFileInfo folder(QFileInfo(path).absolutePath());
    if (!folder.isDir() || !folder.isWritable())
        return Error{JobTexts::tr("the folder for the picture does not exist or cannot be written"), path, 0,
                     JobTexts::tr("Check its permissions or choose another one")};
    return pictureDepth(suffix, bits);
}

QString lightMapPath(const QString &path, int tile, bool several)
{
    const QFileInfo file(path);
    return several ? path.chopped(file.suffix().size()) + QString::number(tile) + u'.' + file.suffix() : path;
}

Result<Done> addLightMap(Picture picture, const QString &path, PictureDepth depth, FileSet &files)
{
    if (!isExr(path)) {
        for (float &value : picture.values)
            value = value == 0 ? 0 : srgbFromLinear(value); // most texels of an unfinished one are black
    }
    return addPicture(picture, path, depth, files);
}

} // namespace autocuts::jobs
