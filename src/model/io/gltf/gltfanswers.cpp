// What a GltfSource says of its file.
#include "model/io/assimp/assimpmatch.h"
#include "model/io/assimp/assimpsource.h"
#include "model/io/formats/meshformats.h"
#include "model/io/gltf/gltfnodes.h"
#include "model/io/gltf/gltfreader.h"
#include "model/io/gltf/gltfsource.h"
#include "model/io/gltf/gltfuniquemeshes.h"
#include "model/io/gltf/gltfwriter.h"

#include <QCborMap>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

#include <algorithm>

namespace autocuts {

bool GltfSource::isOf(const MeshData &mesh) const
{
    return !pieces.empty() && pieces.back().firstFace + pieces.back().faceCount == mesh.faceCount();
}

SceneWriter GltfSource::rewriter(const QString &suffix) const
{
    return isGltfFormat(suffix) ? writeGltf : nullptr;
}

QStringList GltfSource::rewritingLosses(const Scene &scene) const
{
    return gltfLosses(*this, scene);
}

std::vector<SharedMesh> GltfSource::sharedMeshes(bool unique) const
{
    MeshesByPlace meshes;
    for (const GltfPiece &piece : pieces) {
        if (unique)
            break;
        SharedMesh &mesh = meshes[{piece.mesh, piece.primitive}];
        mesh.faceCount = piece.faceCount;
        mesh.instances.push_back({piece.firstFace, piece.mirrored});
    }
    return severalTimesShown(std::move(meshes));
}

Result<std::shared_ptr<const FileSource>> GltfSource::withUniqueMeshes(const QString &path) const
{
    try {
        const Result<Scene> read = parseGltf(autocuts::withUniqueMeshes(file), path);
        if (!read)
            return read.error();
        auto unique = std::make_shared<GltfSource>(*sourceOf<GltfSource>(read.value()));
        unique->firstCopy = 0;
        for (const GltfPiece &piece : pieces)
            unique->firstCopy = std::max(unique->firstCopy, piece.mesh + 1);
        return std::shared_ptr<const FileSource>(std::move(unique));
    } catch (const GltfError &e) {
        return Error{QStringLiteral("the meshes cannot be made unique: %1").arg(QString::fromUtf8(e.what())),
                     path, 0, QStringLiteral("Save it in another format, for example as OBJ")};
    }
}

std::vector<UvSet> GltfSource::uvSets(const Scene &scene) const
{
    Result<Scene> read = parseGltf(file, scene.path);
    return read ? std::move(read->uvSets) : std::vector<UvSet>();
}

QStringList GltfSource::filesBeside(const QString &path) const
{
    QStringList files;
    for (const auto &[uri, bytes] : file.outer)
        files << QFileInfo(path).dir().filePath(QUrl::fromPercentEncoding(uri));
    return files;
}

QByteArray GltfSource::bytesForSession() const
{
    QCborMap outer;
    for (const auto &[uri, bytes] : file.outer)
        outer[QString::fromUtf8(uri)] = bytes;
    const QCborMap map{{QLatin1String("main"), file.main}, {QLatin1String("outer"), outer}};
    return map.toCborValue().toCbor();
}

std::optional<Scene> GltfSource::asAssimpReads(const Scene &scene) const
{
    try {
        const GltfFile glb{sourceAsGlb(*this), {}};
        const auto complete = [&](aiScene &, AssimpSource &made) {
            GltfFile opened = glb;
            made.limbs = jointNames(openGltf(opened).json);
        };
        return autocuts::asAssimpReads(scene, glb.main, QStringLiteral("glb"), Eigen::Matrix4d::Identity(),
                                       complete);
    } catch (const GltfError &) {
        return {};
    }
}

} // namespace autocuts
