#include "model/io/assimp/assimpmatch.h"

#include "model/io/files/savefile.h"
#include "model/io/formats/modelunits.h"
#include "model/transfer/facematch.h"

#include <QTemporaryDir>

#include <algorithm>
#include <limits>
#include <map>

namespace autocuts {

namespace {

//! Positions closer than this share of the largest coordinate are equal: Assimp computes with single
//! precision. Chosen by hand.
constexpr double tolerance = 2e-5;

template <typename T>
T elementOf(const std::vector<T> &list, int index)
{
    return index >= 0 && index < std::ssize(list) ? list[static_cast<std::size_t>(index)] : T();
}

//! Gives Assimp's materials and objects what the scene says of those with the same faces.
void takeMaterials(Scene &assimp, const Scene &scene, const FaceMatch &match)
{
    std::vector<int> materials(assimp.materialNames.size(), -1);
    std::vector<int> objects(assimp.objectNames.size(), -1);
    for (std::size_t f = 0; f < match.face.size(); ++f) {
        const int face = match.face[f];
        if (face < 0)
            continue;
        objects[static_cast<std::size_t>(assimp.mesh->faceObject[f])] =
            scene.mesh->faceObject[static_cast<std::size_t>(face)];
        if (assimp.faceMaterial[f] >= 0 && !scene.faceMaterial.empty())
            materials[static_cast<std::size_t>(assimp.faceMaterial[f])] =
                scene.faceMaterial[static_cast<std::size_t>(face)];
    }
    assimp.materialColors.resize(materials.size());
    assimp.materialTextures.resize(materials.size());
    assimp.materialSets.resize(materials.size());
    for (std::size_t m = 0; m < materials.size(); ++m) {
        if (materials[m] < 0)
            continue;
        assimp.materialNames[m] = scene.materialNames[static_cast<std::size_t>(materials[m])];
        assimp.materialColors[m] = elementOf(scene.materialColors, materials[m]);
        assimp.materialTextures[m] = elementOf(scene.materialTextures, materials[m]);
        assimp.materialSets[m] = elementOf(scene.materialSets, materials[m]);
    }
    for (std::size_t o = 0; o < objects.size(); ++o) {
        if (const QString name = elementOf(scene.objectNames, objects[o]); !name.isEmpty())
            assimp.objectNames[o] = name;
    }
}

//! The faces of each object, by its name; objects of one name are left out.
std::map<QString, std::vector<int>> facesOfObjects(const Scene &scene, const MeshData &mesh)
{
    std::map<QString, int> count;
    for (const QString &name : scene.objectNames)
        ++count[name];
    std::map<QString, std::vector<int>> faces;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const QString name = elementOf(scene.objectNames, mesh.faceObject[f]);
        if (count[name] == 1)
            faces[name].push_back(f);
    }
    return faces;
}

double farthest(const MeshData &mesh)
{
    return mesh.positions.size() == 0 ? 0 : tolerance * mesh.positions.cwiseAbs().maxCoeff();
}

//! True where each vertex lies where that of the same number does.
bool isSamePlace(const MeshData &a, const MeshData &b)
{
    return (a.positions - b.positions).rowwise().norm().maxCoeff() <= farthest(b);
}

//! True where the corners of two faces lie in the same places, in the same order.
bool isSameFace(const MeshData &a, int faceA, const MeshData &b, int faceB, double far)
{
    const int beginA = a.faceStart[faceA], beginB = b.faceStart[faceB];
    const int count = a.faceStart[faceA + 1] - beginA;
    if (b.faceStart[faceB + 1] - beginB != count)
        return false;
    for (int c = 0; c < count; ++c) {
        const Vec3 between =
            a.positions.row(a.cornerVertex[beginA + c]) - b.positions.row(b.cornerVertex[beginB + c]);
        if (!(between.norm() <= far))
            return false;
    }
    return true;
}

//! Matches objects of which not all faces are matched by the order of the faces. Faces of flat objects, which
//! lie in the same places, cannot be told apart otherwise.
void matchInOrder(const Scene &assimp, const Scene &scene, const MeshData &mesh, FaceMatch &match)
{
    const double far = farthest(mesh);
    const std::map<QString, std::vector<int>> theirs = facesOfObjects(assimp, *assimp.mesh);
    for (const auto &[name, faces] : facesOfObjects(scene, mesh)) {
        const auto other = theirs.find(name);
        const bool open = other != theirs.end() && other->second.size() == faces.size() &&
                          std::ranges::any_of(other->second, [&](int f) { return match.face[f] < 0; });
        if (!open || !std::ranges::equal(other->second, faces, [&](int a, int b) {
                return isSameFace(*assimp.mesh, a, mesh, b, far);
            }))
            continue;
        for (std::size_t f = 0; f < faces.size(); ++f) {
            const int face = other->second[f], begin = assimp.mesh->faceStart[face];
            match.face[face] = faces[f];
            for (int c = begin; c < assimp.mesh->faceStart[face + 1]; ++c)
                match.corner[c] = mesh.faceStart[faces[f]] + c - begin;
        }
    }
}

//! The scene of Assimp with the UV sets of another one; nothing when not all faces of that are found.
std::optional<Scene> withUvsOf(const Scene &scene, Scene assimp)
{
    MeshData mesh = *scene.mesh; // only its polygons are looked at
    mesh.positions = inUnits(mesh.positions, unitsOf(scene), {});
    FaceMatch match = matchFaces(*assimp.mesh, mesh, tolerance);
    // Objects of one kind may be there in another order.
    if (match.sameTopology && !isSamePlace(*assimp.mesh, mesh))
        match = matchFacesInPlace(*assimp.mesh, mesh, tolerance);
    if (std::ranges::find(match.face, -1) != match.face.end())
        matchInOrder(assimp, scene, mesh, match);
    const auto matched = std::count_if(match.face.begin(), match.face.end(), [](int f) { return f >= 0; });
    if (matched != scene.mesh->faceCount())
        return {};
    assimp.path = scene.path;
    assimp.format = scene.format;
    takeMaterials(assimp, scene, match);
    if (scene.cornerColors) {
        CornerColors colors(static_cast<std::size_t>(assimp.mesh->cornerCount()));
        for (std::size_t c = 0; c < match.corner.size(); ++c) {
            if (match.corner[c] >= 0)
                colors[c] = (*scene.cornerColors)[static_cast<std::size_t>(match.corner[c])];
        }
        assimp.cornerColors = std::make_shared<const CornerColors>(std::move(colors));
    }
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

std::optional<Scene> asAssimpReads(const Scene &scene, const QByteArray &bytes, const QString &suffix,
                                   const Eigen::Matrix4d &placement, const CompleteScene &complete)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("model.") + suffix);
    if (!folder.isValid() || !saveAtomically(path, bytes))
        return {};
    Result<Scene> read = readWithAssimp(path, nullptr, placement, complete);
    return read ? withUvsOf(scene, std::move(read).value()) : std::nullopt;
}

} // namespace autocuts
