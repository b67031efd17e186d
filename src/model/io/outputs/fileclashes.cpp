#include "model/io/files/filecalls.h"
#include "model/io/meshes/formatcalls.h"
#include "model/io/projects/projectfile.h"
#include "model/pictures/texturefiles.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSet>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

struct ErrorTexts
{
    Q_DECLARE_TR_FUNCTIONS(FileErrors)
};

} // namespace

QByteArray fileKey(const QString &path)
{
    const QFileInfo info(path);
    if (const FileStamp stamp = FileStamp::of(path); stamp.exists())
        return QByteArray::number(stamp.device) + ':' + QByteArray::number(stamp.number);
    const QString folder = QFileInfo(info.absolutePath()).canonicalFilePath();
    return QDir(folder.isEmpty() ? info.absolutePath() : folder).filePath(info.fileName()).toUtf8();
}

Result<Done> checkOutputs(const QStringList &written, const QStringList &kept)
{
    QSet<QByteArray> taken;
    for (const QString &path : kept) {
        if (!path.isEmpty())
            taken.insert(fileKey(path));
    }
    for (const QString &path : written) {
        if (path.isEmpty())
            continue;
        const QByteArray key = fileKey(path);
        if (taken.contains(key))
            return Error{ErrorTexts::tr("this would overwrite another file that is read or written"), path, 0,
                         ErrorTexts::tr("Give it a name of its own")};
        taken.insert(key);
    }
    return Done{};
}

QStringList filesBeside(const DocumentState &model, bool onlyBaseColors)
{
    const Scene &scene = model.scene;
    QStringList files;
    if (const FileSource *source = sourceOf(scene))
        files << source->filesBeside(scene.path);
    FolderNames folders;
    for (int material = -1; material < std::ssize(scene.materialNames); ++material) {
        for (const auto &[channel, entry] : model.textureSet(material)) {
            if (!entry.picture.content.isEmpty() || (onlyBaseColors && channel != TextureChannel::BaseColor))
                continue;
            const bool chosen = isChosenTexture(model, material, channel);
            const QString path = texturePath(entry.picture.file, chosen, scene.path, &folders);
            for (const TextureTile &tile : textureTiles(path, &folders))
                files << tile.path;
        }
    }
    files.removeDuplicates();
    files.removeIf([](const QString &path) { return !QFileInfo::exists(path); });
    return files;
}

QStringList filesOfSession(const DocumentState &model, const QString &sessionPath, bool onlyBaseColors)
{
    return QStringList{sessionPath, model.scene.path} + filesBeside(model, onlyBaseColors);
}

QStringList filesWrittenBeside(const QString &path, const Scene &scene)
{
    if (isProjectPath(path))
        return {path + u".1"_s, path + u".2"_s, path + u".new"_s};
    const FormatCalls &format = callsOf(QFileInfo(path).suffix().toLower());
    return format.filesBeside ? format.filesBeside(scene, path) : QStringList();
}

QStringList withTiles(const QString &path)
{
    if (path.isEmpty())
        return {};
    QStringList files{path};
    const QFileInfo info(path);
    for (const TextureTile &tile :
         textureTiles(info.dir().filePath(info.completeBaseName() + u".<UDIM>."_s + info.suffix())))
        files << tile.path;
    files.removeDuplicates();
    return files;
}

} // namespace autocuts
