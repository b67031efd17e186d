#include "model/io/assimp/assimpjoining.h"

#include "model/io/files/xmlspans.h"

#include <assimp/scene.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace autocuts {

namespace {

using MeshList = std::vector<const aiMesh *>;

//! The values of all meshes one after the other; null when none has some. \param listOf null for none
template <typename Value, typename ListOf>
Value *joinedValues(const MeshList &meshes, unsigned count, const Value &missing, const ListOf &listOf)
{
    if (std::ranges::none_of(meshes, [&](const aiMesh *mesh) { return listOf(*mesh) != nullptr; }))
        return nullptr;
    auto *values = new Value[count];
    Value *next = values;
    for (const aiMesh *mesh : meshes) {
        const Value *from = listOf(*mesh);
        next = from ? std::copy_n(from, mesh->mNumVertices, next)
                    : std::fill_n(next, mesh->mNumVertices, missing);
    }
    return values;
}

void joinVertices(aiMesh &joined, const MeshList &meshes)
{
    for (const aiMesh *mesh : meshes)
        joined.mNumVertices += mesh->mNumVertices;
    const unsigned count = joined.mNumVertices;
    joined.mVertices =
        joinedValues(meshes, count, aiVector3D(), [](const aiMesh &mesh) { return mesh.mVertices; });
    if (std::ranges::all_of(meshes, [](const aiMesh *mesh) { return mesh->HasNormals(); }))
        joined.mNormals =
            joinedValues(meshes, count, aiVector3D(), [](const aiMesh &mesh) { return mesh.mNormals; });
    for (unsigned c = 0; c < AI_MAX_NUMBER_OF_COLOR_SETS; ++c)
        joined.mColors[c] = joinedValues(meshes, count, aiColor4D(1, 1, 1, 1),
                                         [c](const aiMesh &mesh) { return mesh.mColors[c]; });
    for (unsigned t = 0; t < AI_MAX_NUMBER_OF_TEXTURECOORDS; ++t) {
        joined.mTextureCoords[t] = joinedValues(meshes, count, aiVector3D(),
                                                [t](const aiMesh &mesh) { return mesh.mTextureCoords[t]; });
        for (const aiMesh *mesh : meshes)
            joined.mNumUVComponents[t] = std::max(joined.mNumUVComponents[t], mesh->mNumUVComponents[t]);
    }
}

void joinFaces(aiMesh &joined, const MeshList &meshes)
{
    for (const aiMesh *mesh : meshes)
        joined.mNumFaces += mesh->mNumFaces;
    joined.mFaces = new aiFace[joined.mNumFaces];
    aiFace *next = joined.mFaces;
    unsigned first = 0;
    for (const aiMesh *mesh : meshes) {
        joined.mPrimitiveTypes |= mesh->mPrimitiveTypes;
        for (unsigned f = 0; f < mesh->mNumFaces; ++f, ++next) {
            *next = mesh->mFaces[f];
            for (unsigned k = 0; k < next->mNumIndices; ++k)
                next->mIndices[k] += first;
        }
        first += mesh->mNumVertices;
    }
}

void joinBones(aiMesh &joined, const MeshList &meshes)
{
    std::vector<const aiBone *> bones;
    std::map<std::string, std::vector<aiVertexWeight>> weights;
    unsigned first = 0;
    for (const aiMesh *mesh : meshes) {
        for (unsigned b = 0; b < mesh->mNumBones; ++b) {
            const aiBone &bone = *mesh->mBones[b];
            const auto [own, isNew] = weights.try_emplace(bone.mName.C_Str());
            if (isNew)
                bones.push_back(&bone);
            for (unsigned w = 0; w < bone.mNumWeights; ++w)
                own->second.emplace_back(bone.mWeights[w].mVertexId + first, bone.mWeights[w].mWeight);
        }
        first += mesh->mNumVertices;
    }
    if (bones.empty())
        return;
    joined.mBones = new aiBone *[bones.size()];
    for (const aiBone *from : bones) {
        const std::vector<aiVertexWeight> &own = weights[from->mName.C_Str()];
        auto *bone = new aiBone;
        bone->mName = from->mName;
        bone->mOffsetMatrix = from->mOffsetMatrix;
        bone->mNumWeights = static_cast<unsigned>(own.size());
        bone->mWeights = new aiVertexWeight[own.size()];
        std::ranges::copy(own, bone->mWeights);
        joined.mBones[joined.mNumBones++] = bone;
    }
}

//! True when all have bones or none, and a bone is bound to all in the same way.
bool areBoundAlike(const MeshList &meshes)
{
    std::map<std::string, aiMatrix4x4> offsets;
    for (const aiMesh *mesh : meshes) {
        if (mesh->HasBones() != meshes.front()->HasBones())
            return false;
        for (unsigned b = 0; b < mesh->mNumBones; ++b) {
            const aiBone &bone = *mesh->mBones[b];
            const auto [own, isNew] = offsets.try_emplace(bone.mName.C_Str(), bone.mOffsetMatrix);
            if (!isNew && !own->second.Equal(bone.mOffsetMatrix, 1e-4F))
                return false;
        }
    }
    return true;
}

//! The joined mesh of a node that has several; null when it stays as it is.
std::unique_ptr<aiMesh> joinedMesh(const MeshList &meshes)
{
    if (meshes.size() < 2 || !areBoundAlike(meshes))
        return nullptr;
    auto joined = std::make_unique<aiMesh>();
    joined->mName = meshes.front()->mName;
    joined->mMaterialIndex = meshes.front()->mMaterialIndex;
    joinVertices(*joined, meshes);
    joinFaces(*joined, meshes);
    joinBones(*joined, meshes);
    return joined;
}

void forEachNode(aiNode &node, const auto &use)
{
    use(node);
    for (unsigned c = 0; c < node.mNumChildren; ++c)
        forEachNode(*node.mChildren[c], use);
}

//! The first part that has the material of a part.
std::size_t firstAlike(const std::vector<MaterialPart> &parts, std::size_t part)
{
    const auto alike = std::ranges::find(parts, parts[part].material, &MaterialPart::material);
    return static_cast<std::size_t>(alike - parts.begin());
}

//! What the polygons of a part call their material.
std::string symbolOf(const std::vector<MaterialPart> &parts, std::size_t part)
{
    const std::size_t first = firstAlike(parts, part);
    return first == 0 ? "defaultMaterial" : "material" + std::to_string(first);
}

//! The position behind so many words.
std::size_t behindWords(std::string_view text, std::size_t at, std::size_t count)
{
    constexpr std::string_view space = " \t\r\n";
    for (; count > 0; --count) {
        const std::size_t word = text.find_first_not_of(space, at);
        at = word == std::string_view::npos ? text.size()
                                            : std::min(text.size(), text.find_first_of(space, word));
    }
    return at;
}

std::size_t sumOfWords(std::string_view text)
{
    std::size_t sum = 0, number = 0;
    for (const char c : text) {
        const bool isDigit = c >= '0' && c <= '9';
        sum += isDigit ? 0 : number;
        number = isDigit ? 10 * number + static_cast<std::size_t>(c - '0') : 0;
    }
    return sum + number;
}

//! One list of polygons as several, one for each part.
std::string splitPolygons(const XmlElement &list, const std::vector<MaterialPart> &parts)
{
    const XmlElement *sizes = list.child("vcount"), *corners = list.child("p");
    std::string inputs, text;
    for (const XmlElement &child : list.children) {
        if (child.name == "input")
            inputs += std::string(child.whole);
    }
    std::size_t size = 0, corner = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const std::size_t sizeEnd = behindWords(sizes->content, size, parts[p].faces);
        const std::string_view own = sizes->content.substr(size, sizeEnd - size);
        const std::size_t cornerEnd = behindWords(corners->content, corner, sumOfWords(own));
        text += "<polylist count=\"" + std::to_string(parts[p].faces) + "\" material=\"" +
                symbolOf(parts, p) + "\">" + inputs + "<vcount>" + std::string(own) + "</vcount><p>" +
                std::string(corners->content.substr(corner, cornerEnd - corner)) +
                "</p></polylist>\n        ";
        size = sizeEnd;
        corner = cornerEnd;
    }
    return text;
}

void forEachIn(const XmlElement &element, const auto &use)
{
    use(element);
    for (const XmlElement &child : element.children)
        forEachIn(child, use);
}

//! The elements that give the other parts of a mesh their materials. \param first that of the first part
std::string otherMaterials(const XmlElement &first, const std::vector<MaterialPart> &parts,
                           const std::vector<std::string> &materials)
{
    std::string text;
    for (std::size_t p = 1; p < parts.size(); ++p) {
        if (firstAlike(parts, p) == p && parts[p].material < materials.size())
            text += "<instance_material symbol=\"" + symbolOf(parts, p) + "\" target=\"#" +
                    materials[parts[p].material] + "\">" + std::string(first.content) +
                    "</instance_material>";
    }
    return text;
}

} // namespace

MaterialParts joinMeshes(aiScene &scene)
{
    MaterialParts parts;
    std::vector<std::unique_ptr<aiMesh>> old, kept;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        old.emplace_back(scene.mMeshes[m]);
    forEachNode(*scene.mRootNode, [&](aiNode &node) {
        MeshList meshes;
        for (unsigned m = 0; m < node.mNumMeshes; ++m)
            meshes.push_back(old[node.mMeshes[m]].get());
        if (std::unique_ptr<aiMesh> joined = joinedMesh(meshes)) {
            std::vector<MaterialPart> &own = parts.emplace_back();
            for (const aiMesh *mesh : meshes)
                own.push_back({mesh->mNumFaces, mesh->mMaterialIndex});
            node.mNumMeshes = 1;
            node.mMeshes[0] = static_cast<unsigned>(kept.size());
            kept.push_back(std::move(joined));
            return;
        }
        for (unsigned m = 0; m < node.mNumMeshes; ++m) {
            parts.emplace_back();
            kept.push_back(std::move(old[node.mMeshes[m]]));
            node.mMeshes[m] = static_cast<unsigned>(kept.size() - 1);
        }
    });
    delete[] scene.mMeshes;
    scene.mNumMeshes = static_cast<unsigned>(kept.size());
    scene.mMeshes = new aiMesh *[kept.size()];
    std::ranges::transform(kept, scene.mMeshes, [](std::unique_ptr<aiMesh> &mesh) { return mesh.release(); });
    return parts;
}

std::string withMaterials(std::string_view text, const MaterialParts &parts)
{
    const auto isJoined = [](const std::vector<MaterialPart> &own) { return !own.empty(); };
    const std::optional<XmlElement> root =
        std::ranges::any_of(parts, isJoined) ? xmlSpans(text) : std::nullopt;
    const XmlElement *geometries = root ? root->child("library_geometries") : nullptr;
    const XmlElement *library = root ? root->child("library_materials") : nullptr;
    // Assimp writes a geometry for each mesh, in their order.
    if (!geometries || !library || geometries->children.size() != parts.size())
        return std::string(text);
    std::vector<std::string> materials;
    for (const XmlElement &material : library->children)
        materials.emplace_back(material.attribute("id"));
    std::vector<TextEdit> edits;
    std::map<std::string, const std::vector<MaterialPart> *> ofUrl;
    for (std::size_t g = 0; g < parts.size(); ++g) {
        const XmlElement &geometry = geometries->children[g];
        const XmlElement *mesh = geometry.child("mesh");
        const XmlElement *list = mesh ? mesh->child("polylist") : nullptr;
        if (parts[g].empty() || !list || !list->child("vcount") || !list->child("p"))
            continue;
        const std::string_view whole = list->whole;
        edits.push_back({whole.data(), whole.data() + whole.size(), splitPolygons(*list, parts[g])});
        const std::string id(geometry.attribute("id"));
        ofUrl["#" + id] = ofUrl["#" + id + "-skin"] = &parts[g];
    }
    const XmlElement *scenes = root->child("library_visual_scenes");
    const auto bind = [&](const XmlElement &instance) {
        const auto own = ofUrl.find(std::string(instance.attribute("url")));
        const bool places = instance.name == "instance_geometry" || instance.name == "instance_controller";
        if (!places || own == ofUrl.end())
            return;
        forEachIn(instance, [&](const XmlElement &element) {
            const char *end = element.whole.data() + element.whole.size();
            if (element.name == "instance_material")
                edits.push_back({end, end, otherMaterials(element, *own->second, materials)});
        });
    };
    if (scenes)
        forEachIn(*scenes, bind);
    return edited(text, std::move(edits));
}

} // namespace autocuts
