#include "model/io/fbxtwin.h"

#include "model/document/facematch.h"
#include "model/io/assimpreader.h"
#include "model/io/savefile.h"

#include <QTemporaryDir>

#include <algorithm>
#include <limits>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Positions closer than this share of the largest coordinate are equal: Assimp computes with single
//! precision.
constexpr double twinTolerance = 2e-5;

std::optional<Scene> foundTwin(const Scene &scene, const FbxSource &source)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"model.fbx"_s);
    if (!folder.isValid() || !saveAtomically(path, source.bytes))
        return {};
    Result<Scene> read = readWithAssimp(path, nullptr);
    if (!read)
        return {};
    Scene twin = std::move(read).value();
    const FaceMatch match = matchFaces(*twin.mesh, *scene.mesh, twinTolerance);
    const auto matched = std::count_if(match.face.begin(), match.face.end(), [](int f) { return f >= 0; });
    if (matched != scene.mesh->faceCount())
        return {};
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    twin.uvSets.clear();
    for (const UvSet &set : scene.uvSets) {
        UvMatrix uv = UvMatrix::Constant(twin.mesh->cornerCount(), 2, nan);
        for (std::size_t c = 0; c < match.corner.size(); ++c) {
            if (match.corner[c] >= 0)
                uv.row(static_cast<Eigen::Index>(c)) = set.uv.row(match.corner[c]);
        }
        twin.uvSets.push_back({set.name, std::move(uv)});
    }
    twin.path = scene.path;
    return twin;
}

} // namespace

std::optional<Scene> assimpTwin(const Scene &scene, const FbxSource &source)
{
    // Assimp reads files from version 7.1 on.
    std::optional<Scene> twin = source.version >= 7100 ? foundTwin(scene, source) : std::nullopt;
    source.twin = twin ? FbxTwin::Found : FbxTwin::None;
    return twin;
}

} // namespace autocuts
