#include "model/io/formats/materiallooks.h"

#include "model/io/files/meshlimits.h"
#include "model/io/files/savefile.h"
#include "model/io/formats/meshformats.h"
#include "model/pictures/texturefiles.h"
#include "model/plain/picture.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace autocuts {

namespace {

constexpr double unsaidColor = 0.8; //!< as most programs have it

QString plainName(const QString &name)
{
    return QFileInfo(QString(name).replace(u'\\', u'/')).completeBaseName();
}

} // namespace

QString pictureSuffix(const QByteArray &content, const QString &name)
{
    if (content.startsWith("\x89PNG"))
        return QStringLiteral("png");
    if (content.startsWith("\xff\xd8\xff"))
        return QStringLiteral("jpg");
    const QString suffix = QFileInfo(QString(name).replace(u'\\', u'/')).suffix().toLower();
    return suffix.isEmpty() ? QStringLiteral("png") : suffix;
}

Vec3 MaterialLooks::color(int material) const
{
    const bool known = material >= 0 && material < std::ssize(mScene.materialColors);
    const QRgb color = known ? mScene.materialColors[static_cast<std::size_t>(material)] : 0;
    const bool textured = !picture(material, TextureChannel::BaseColor).picture.isEmpty();
    // In FBX and Collada a picture takes the place of the colour; elsewhere it is multiplied by it.
    const bool replaced = mScene.format == QLatin1String("fbx") || mScene.format == QLatin1String("dae");
    if (color == 0 || (textured && replaced))
        return Vec3::Constant(textured ? 1 : unsaidColor);
    Vec3 result(qRed(color) / 255.0, qGreen(color) / 255.0, qBlue(color) / 255.0);
    if (isGltfFormat(mScene.format)) {
        for (double &share : result)
            share = static_cast<double>(linearFromSrgb(static_cast<float>(share)));
    }
    return result;
}

ChannelPicture MaterialLooks::picture(int material, TextureChannel channel) const
{
    const TextureSet set = mScene.fileSet(material);
    const auto found = set.find(channel);
    return found == set.end() ? ChannelPicture() : found->second;
}

QString MaterialLooks::pathOf(const SceneTexture &picture) const
{
    if (!picture.content.isEmpty() || picture.isEmpty())
        return {};
    const QString file = picture.file;
    return QDir::isAbsolutePath(file) && QFileInfo(file).isFile() &&
                   QFileInfo(file).absolutePath() == QFileInfo(mOutput).absolutePath()
               ? file
               : findTexture(file, mScene.path);
}

QByteArray MaterialLooks::contentOf(const SceneTexture &picture) const
{
    if (!picture.content.isEmpty())
        return picture.content;
    const QString path = pathOf(picture);
    if (path.isEmpty())
        return {};
    const Result<QByteArray> content = loadFile(path, maxMeshFileSize);
    return content ? content.value() : QByteArray();
}

QString MaterialLooks::fileOf(const SceneTexture &picture)
{
    const QFileInfo output(mOutput);
    if (picture.content.isEmpty()) {
        const QString path = pathOf(picture);
        return path.isEmpty() ? QString(picture.file).replace(u'\\', u'/')
                              : output.absoluteDir().relativeFilePath(QFileInfo(path).absoluteFilePath());
    }
    for (const auto &[path, content] : mFiles) {
        if (content == picture.content)
            return QFileInfo(path).fileName();
    }
    const auto fits = [&](const QString &path) {
        if (std::ranges::find(mFiles, path, [](const auto &file) { return file.first; }) != mFiles.end())
            return false;
        if (!QFileInfo::exists(path))
            return true;
        const Result<QByteArray> there = loadFile(path, maxMeshFileSize);
        return there && there.value() == picture.content;
    };
    const QString name =
        plainName(picture.file).isEmpty() ? QStringLiteral("picture") : plainName(picture.file);
    const QString stem = output.absoluteDir().filePath(output.completeBaseName() + u'_' + name);
    const QString suffix = u'.' + pictureSuffix(picture.content, picture.file);
    QString path = stem + suffix;
    for (int number = 2; !fits(path); ++number)
        path = stem + u'_' + QString::number(number) + suffix;
    mFiles.emplace_back(path, picture.content);
    return QFileInfo(path).fileName();
}

QStringList MaterialLooks::placeAll()
{
    for (int m = 0; m < std::ssize(mScene.materialNames); ++m) {
        for (const auto &[channel, entry] : mScene.fileSet(m)) {
            if (!entry.picture.content.isEmpty())
                fileOf(entry.picture);
        }
    }
    QStringList paths;
    for (const auto &[path, content] : mFiles)
        paths << path;
    return paths;
}

Result<Done> MaterialLooks::addFiles(FileSet &files) const
{
    for (const auto &[path, content] : mFiles) {
        if (QFileInfo::exists(path))
            continue; // with this content
        if (Result<Done> added = files.add(path, content); !added)
            return added;
    }
    return Done{};
}

QStringList MaterialLooks::missing() const
{
    QStringList names;
    for (int m = 0; m < std::ssize(mScene.materialNames); ++m) {
        for (const auto &[channel, entry] : mScene.fileSet(m)) {
            if (!entry.picture.isEmpty() && entry.picture.content.isEmpty() &&
                pathOf(entry.picture).isEmpty())
                names << QFileInfo(QString(entry.picture.file).replace(u'\\', u'/')).fileName();
        }
    }
    names.removeDuplicates();
    return names;
}

} // namespace autocuts
