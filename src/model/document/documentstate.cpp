#include "model/document/documentstate.h"

#include "model/document/uvsetnames.h"
#include "model/plain/settingsproperties.h"
#include "model/plain/texelweights.h"
#include "model/plain/uvlayout.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace autocuts {

namespace {

bool sameMesh(const std::shared_ptr<const MeshData> &a, const std::shared_ptr<const MeshData> &b)
{
    return a == b || (a && b && samePolygons(*a, *b));
}

bool sameUvSets(const std::vector<UvSet> &a, const std::vector<UvSet> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const UvSet &x, const UvSet &y) {
        return x.name == y.name && sameBits(x.uv, y.uv);
    });
}

bool sameColors(const std::shared_ptr<const CornerColors> &a, const std::shared_ptr<const CornerColors> &b)
{
    return a == b || (a && b && *a == *b);
}

bool sameScene(const Scene &a, const Scene &b)
{
    return a.path == b.path && a.format == b.format && sameMesh(a.mesh, b.mesh) &&
           a.objectNames == b.objectNames && a.materialNames == b.materialNames &&
           a.faceMaterial == b.faceMaterial && a.materialColors == b.materialColors &&
           a.materialTextures == b.materialTextures && a.materialSets == b.materialSets &&
           a.hardEdges == b.hardEdges && sameColors(a.cornerColors, b.cornerColors) &&
           sameUvSets(a.uvSets, b.uvSets) && a.notes == b.notes && a.uniqueMeshes == b.uniqueMeshes;
}

QString validateMaterials(const Scene &scene)
{
    const std::vector<int> &materials = scene.faceMaterial;
    if (!materials.empty() && static_cast<int>(materials.size()) != scene.mesh->faceCount())
        return QStringLiteral("The materials do not fit the mesh");
    if (scene.materialColors.size() > scene.materialNames.size())
        return QStringLiteral("There are more colours than materials");
    if (scene.materialTextures.size() > scene.materialNames.size())
        return QStringLiteral("There are more textures than materials");
    if (const QString problem = validateTextureSets(scene.materialSets, scene.materialNames.size());
        !problem.isEmpty())
        return problem;
    const auto exists = [&](int m) { return m >= -1 && m < static_cast<int>(scene.materialNames.size()); };
    if (!std::all_of(materials.begin(), materials.end(), exists))
        return QStringLiteral("A face has an unknown material");
    return {};
}

QString validateUvSets(const DocumentState &state)
{
    const std::vector<UvSet> &sets = state.scene.uvSets;
    if (state.activeUvSet < 0 || state.activeUvSet >= static_cast<int>(sets.size()))
        return QStringLiteral("The active UV set does not exist");
    if (state.uvScales.size() != sets.size())
        return QStringLiteral("The scales do not fit the UV sets");
    std::set<QString> names;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        if (sets[i].uv.rows() != state.scene.mesh->cornerCount())
            return QStringLiteral("UV set %1 does not fit the mesh").arg(i);
        if (!std::isfinite(state.uvScales[i]) || state.uvScales[i] <= 0)
            return QStringLiteral("The scale of UV set %1 is not positive").arg(i);
        if (sets[i].name.isEmpty() || sets[i].name.size() > maxNameLength ||
            !names.insert(sets[i].name).second)
            return QStringLiteral("UV set %1 has no name of its own").arg(i);
    }
    return {};
}

} // namespace

DocumentState DocumentState::initial(Scene scene)
{
    DocumentState state;
    state.scene = std::move(scene);
    const MeshData &mesh = *state.scene.mesh;
    std::vector<UvSet> sets = std::move(state.scene.uvSets);
    state.scene.uvSets.clear();
    if (sets.empty())
        sets.push_back({{}, emptyLayout(mesh)});
    UvSetNames names;
    for (UvSet &set : sets) {
        set.name = names.take(set.name.isEmpty() ? QStringLiteral("UVMap") : set.name);
        state.uvScales.push_back(layoutScale(mesh, set.uv));
        state.scene.uvSets.push_back(std::move(set));
    }
    state.seams = Seams::allFree(mesh);
    state.marks = IslandMarks::none(mesh);
    return state;
}

QString DocumentState::validate() const
{
    if (!scene.mesh)
        return QStringLiteral("There is no mesh");
    const MeshData &mesh = *scene.mesh;
    if (!scene.hardEdges.empty() && scene.hardEdges.size() != mesh.edgePairs.size())
        return QStringLiteral("The hard edges do not fit the mesh");
    if (scene.cornerColors && std::ssize(*scene.cornerColors) != mesh.cornerCount())
        return QStringLiteral("The vertex colours do not fit the mesh");
    if (!areTexelWeights(texelWeights, mesh.faceCount()))
        return QStringLiteral("The painted texel density is damaged");
    if (!isValid(solveSettings))
        return QStringLiteral("A setting of the solver is out of range");
    if (!packingSettings.isValid())
        return QStringLiteral("A setting of packing is out of range");
    if (!isIndexSet(hiddenFaces, mesh.faceCount()))
        return QStringLiteral("The hidden faces do not fit the mesh");
    for (const QString &problem :
         {validateMaterials(scene), validateTextureSets(textureSets, scene.materialNames.size() + 1),
          validateUvSets(*this), seams.validate(mesh), constraints.validate(mesh), marks.validate(mesh),
          selection.validate(mesh)}) {
        if (!problem.isEmpty())
            return problem;
    }
    return {};
}

TextureSet DocumentState::textureSet(int material) const
{
    const auto place = static_cast<std::size_t>(material + 1);
    const TextureSet file = scene.fileSet(material);
    TextureSet own = place < textureSets.size() ? textureSets[place] : TextureSet();
    for (auto &[channel, entry] : own) {
        const auto found = file.find(channel);
        if (entry.fromModel)
            entry.picture = found == file.end() ? SceneTexture() : found->second.picture;
    }
    return overlaid(file, own);
}

bool operator==(const DocumentState &a, const DocumentState &b)
{
    return sameScene(a.scene, b.scene) && a.activeUvSet == b.activeUvSet && a.uvScales == b.uvScales &&
           a.seams == b.seams && a.constraints == b.constraints && a.marks == b.marks &&
           a.texelWeights == b.texelWeights && a.hiddenFaces == b.hiddenFaces &&
           a.textureSets == b.textureSets && a.solveSettings == b.solveSettings &&
           a.packingSettings == b.packingSettings && a.selection == b.selection && a.viewState == b.viewState;
}

QString uniqueUvSetName(const std::vector<UvSet> &sets, const QString &wanted)
{
    UvSetNames names;
    for (const UvSet &set : sets)
        names.insert(set.name);
    return names.take(wanted);
}

} // namespace autocuts
