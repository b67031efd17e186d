#include "model/io/assimpmatch.h"

#include "model/io/assimpreader.h"
#include "model/io/savefile.h"
#include "model/transfer/facematch.h"

#include <QTemporaryDir>

#include <algorithm>
#include <limits>

namespace autocuts {

namespace {

//! Positions closer than this share of the largest coordinate are equal: Assimp computes with single
//! precision. Chosen by hand.
constexpr double tolerance = 2e-5;

//! The scene of Assimp with the UV sets of another one; nothing when not all faces of that are found.
std::optional<Scene> withUvsOf(const Scene &scene, Scene assimp)
{
    const FaceMatch match = matchFaces(*assimp.mesh, *scene.mesh, tolerance);
    const auto matched = std::count_if(match.face.begin(), match.face.end(), [](int f) { return f >= 0; });
    if (matched != scene.mesh->faceCount())
        return {};
    assimp.path = scene.path;
    assimp.format = scene.format;
    assimp.uvSets.clear();
    for (const UvSet &set : scene.uvSets) {
        UvMatrix uv =
            UvMatrix::Constant(assimp.mesh->cornerCount(), 2, std::numeric_limits<double>::quiet_NaN());
        for (std::size_t c = 0; c < match.corner.size(); ++c) {
            if (match.corner[c] >= 0)
                uv.row(static_cast<Eigen::Index>(c)) = set.uv.row(match.corner[c]);
        }
        assimp.uvSets.push_back({set.name, std::move(uv)});
    }
    return assimp;
}

} // namespace

std::optional<Scene> asAssimpReads(const Scene &scene, const QByteArray &bytes, const QString &suffix)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("model.") + suffix);
    if (!folder.isValid() || !saveAtomically(path, bytes))
        return {};
    Result<Scene> read = readWithAssimp(path, nullptr);
    return read ? withUvsOf(scene, std::move(read).value()) : std::nullopt;
}

} // namespace autocuts
