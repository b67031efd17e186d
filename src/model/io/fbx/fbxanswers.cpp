// What an FbxSource says of its file.
#include "model/io/fbx/fbxassimpscene.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/fbx/fbxrewriter.h"
#include "model/io/fbx/fbxsource.h"
#include "model/io/fbx/fbxuniquemeshes.h"
#include "model/io/files/savefile.h"
#include "model/io/formats/tilescaling.h"

#include <QCoreApplication>

#include <algorithm>

namespace autocuts {

namespace {

constexpr int firstVersionOfAssimp = 7100; //!< that Assimp reads

Result<Done> writeRewrittenFbx(const Scene &scene, const QString &path)
{
    return saveAtomically(path, rewriteFbx(*sourceOf<FbxSource>(scene), scene));
}

} // namespace

bool FbxSource::isOf(const MeshData &mesh) const
{
    return corners == mesh.cornerCount();
}

SceneWriter FbxSource::rewriter(const QString &suffix) const
{
    return suffix == QLatin1String("fbx") ? writeRewrittenFbx : nullptr;
}

QStringList FbxSource::rewritingLosses(const Scene &scene) const
{
    if (!hasUnequalInstances(*this, scene) || (scene.uniqueMeshes && hasCopyableGeometries(*this)))
        return {};
    return {QCoreApplication::translate(
        "ExportLosses", "objects that share a mesh have one map in the file: that of the first one whose "
                        "UVs were changed is written, unless the meshes are made unique")};
}

Scene FbxSource::asRewritten(const Scene &scene, double tileHeight) const
{
    Scene result = scene;
    if (sharedMeshes(scene.uniqueMeshes).empty() || !hasUnequalInstances(*this, scene))
        return result;
    Result<Scene> file = parseFbx(rewriteFbx(*this, scaledForFile(scene, tileHeight)), scene.path);
    if (!file)
        return result;
    scaleFromFile(file.value(), tileHeight);
    for (UvSet &set : result.uvSets) {
        const auto same = [&set](const UvSet &other) { return other.name == set.name; };
        const auto found = std::ranges::find_if(file->uvSets, same);
        if (found != file->uvSets.end() && found->uv.rows() == set.uv.rows())
            set.uv = found->uv;
    }
    return result;
}

std::vector<SharedMesh> FbxSource::sharedMeshes(bool unique) const
{
    if (unique && hasCopyableGeometries(*this))
        return {};
    return severalTimesShown(std::vector<SharedMesh>(uses.begin(), uses.end()));
}

Result<std::shared_ptr<const FileSource>> FbxSource::withUniqueMeshes(const QString &path) const
{
    if (!hasCopyableGeometries(*this))
        return std::shared_ptr<const FileSource>();
    Result<QByteArray> made = withUniqueGeometries(*this, path);
    if (!made)
        return made.error();
    const Result<Scene> file = parseFbx(std::move(made).value(), path);
    if (!file)
        return file.error();
    return std::static_pointer_cast<const FileSource>(file->source);
}

std::vector<UvSet> FbxSource::uvSets(const Scene &scene) const
{
    Result<Scene> read = parseFbx(bytes, scene.path);
    return read ? std::move(read->uvSets) : std::vector<UvSet>();
}

FileSource::ByAssimp FbxSource::readByAssimp() const
{
    return version < firstVersionOfAssimp ? ByAssimp::Never : ByAssimp::Perhaps;
}

std::optional<Scene> FbxSource::asAssimpReads(const Scene &scene) const
{
    return version < firstVersionOfAssimp ? std::nullopt : fbxAsAssimpReads(scene, *this);
}

} // namespace autocuts
