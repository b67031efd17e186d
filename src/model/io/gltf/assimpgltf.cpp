#include "model/io/gltf/assimpgltf.h"

#include "model/io/assimp/assimpmatrix.h"
#include "model/io/assimp/assimpscene.h"
#include "model/io/assimp/assimpsource.h"
#include "model/io/assimp/assimpviews.h"
#include "model/io/formats/materiallooks.h"
#include "model/io/formats/meshformats.h"
#include "model/io/gltf/gltfappender.h"
#include "model/io/gltf/gltflooks.h"
#include "model/io/gltf/gltfsource.h"
#include "model/io/gltf/gltfuvnames.h"

#include <Eigen/Geometry>

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace autocuts {

namespace {

Json numbersOf(const Vec3 &values)
{
    Json list = Json::array();
    for (const double value : values)
        list.push_back(static_cast<double>(static_cast<float>(value)));
    return list;
}

Json materialOf(const Scene &scene, int number, const aiMaterial &exported, const MaterialLooks &looks)
{
    Json material = Json::object();
    if (aiString name; exported.Get(AI_MATKEY_NAME, name) == AI_SUCCESS)
        material["name"] = QString::fromUtf8(name.C_Str()).toStdString();
    const TextureSet set = scene.fileSet(number);
    const auto factor = [&](TextureChannel channel) {
        const auto found = set.find(channel);
        return found == set.end() ? neutralValue(channel) : found->second.factor;
    };
    float opacity = 1;
    if (exported.Get(AI_MATKEY_OPACITY, opacity) != AI_SUCCESS || !(opacity >= 0 && opacity < 1))
        opacity = 1;
    Json color = numbersOf(looks.color(number));
    color.push_back(opacity);
    material["pbrMetallicRoughness"] = {{"baseColorFactor", color},
                                        {"metallicFactor", factor(TextureChannel::Metalness)},
                                        {"roughnessFactor", factor(TextureChannel::Roughness)}};
    if (opacity < 1)
        material["alphaMode"] = "BLEND";
    return material;
}

void addMaterials(GltfDocument &document, const Scene &scene, const aiScene &exported, const QString &path)
{
    MaterialLooks looks(scene, path);
    for (const char *key : {"materials", "textures", "images", "samplers"})
        document.json.erase(key);
    GltfPictures pictures(document, looks, path.endsWith(QLatin1String(".glb"), Qt::CaseInsensitive));
    Json materials = Json::array();
    for (unsigned m = 0; m < exported.mNumMaterials; ++m) {
        const int number = m < scene.materialNames.size() ? static_cast<int>(m) : -1;
        materials.push_back(materialOf(scene, number, *exported.mMaterials[m], looks));
        setGltfTextures(materials.back(), scene.fileSet(number), 0, pictures);
    }
    document.json["materials"] = std::move(materials);
}

//! Takes out the bytes that no buffer view has. Assimp's exporter leaves such bytes behind the joints of
//! skins, with whatever was in memory.
void removeUnusedBytes(GltfDocument &document)
{
    if (!document.json.contains("bufferViews"))
        return;
    std::vector<QByteArray> packed(document.buffers.size());
    for (Json &view : document.json["bufferViews"]) {
        const std::size_t number = requiredNumber(view, "buffer");
        const auto begin = static_cast<qsizetype>(wholeNumber(view, "byteOffset").value_or(0));
        const auto size = static_cast<qsizetype>(requiredNumber(view, "byteLength"));
        QByteArray &buffer = packed.at(number);
        buffer.append(-buffer.size() & 3, '\0');
        view["byteOffset"] = static_cast<std::size_t>(buffer.size());
        buffer.append(QByteArrayView(document.buffers[number]).sliced(begin, size));
    }
    for (std::size_t b = 0; b < packed.size(); ++b)
        document.json["buffers"][b]["byteLength"] = static_cast<std::size_t>(packed[b].size());
    document.buffers = std::move(packed);
}

//! The first node of this name, or null.
Json *nodeNamed(Json &root, const aiString &name)
{
    for (Json &node : root["nodes"]) {
        if (textOf(node, "name") == name.C_Str())
            return &node;
    }
    return nullptr;
}

void addCameras(Json &root, const aiScene &scene)
{
    root.erase("cameras");
    for (unsigned c = 0; c < scene.mNumCameras; ++c) {
        const aiCamera &from = *scene.mCameras[c];
        Json *node = nodeNamed(root, from.mName);
        if (!node)
            continue;
        const double aspect = from.mAspect > 0 ? from.mAspect : 16.0 / 9;
        const double near = from.mClipPlaneNear > 0 ? from.mClipPlaneNear : 0.1;
        Json camera{{"name", from.mName.C_Str()}};
        if (from.mOrthographicWidth > 0) {
            camera["type"] = "orthographic";
            camera["orthographic"] = {{"xmag", from.mOrthographicWidth},
                                      {"ymag", from.mOrthographicWidth / aspect},
                                      {"znear", near},
                                      {"zfar", std::max<double>(from.mClipPlaneFar, 2 * near)}};
        } else {
            const double wide =
                from.mHorizontalFOV > 0 && from.mHorizontalFOV < 3 ? from.mHorizontalFOV : 0.7;
            camera["type"] = "perspective";
            camera["perspective"] = {{"aspectRatio", aspect},
                                     {"yfov", 2 * std::atan(std::tan(wide / 2) / aspect)},
                                     {"znear", near}};
            if (from.mClipPlaneFar > near)
                camera["perspective"]["zfar"] = from.mClipPlaneFar;
        }
        (*node)["camera"] = member(root, "cameras").size();
        root["cameras"].push_back(std::move(camera));
    }
}

const char *lightType(aiLightSourceType type)
{
    switch (type) {
    case aiLightSource_DIRECTIONAL:
        return "directional";
    case aiLightSource_SPOT:
        return "spot";
    case aiLightSource_POINT:
        return "point";
    default:
        return nullptr;
    }
}

//! \param fromGltf the strengths are those of glTF already; other formats are taken as in watts
void addLights(Json &root, const aiScene &scene, bool fromGltf)
{
    Json lights = Json::array();
    for (unsigned l = 0; l < scene.mNumLights; ++l) {
        const aiLight &from = *scene.mLights[l];
        const char *type = lightType(from.mType);
        Json *node = nodeNamed(root, from.mName);
        if (!node || !type)
            continue;
        const Vec3 color(from.mColorDiffuse.r, from.mColorDiffuse.g, from.mColorDiffuse.b);
        const double strength = color.maxCoeff();
        const double sphere = from.mType == aiLightSource_DIRECTIONAL ? 1 : 4 * std::numbers::pi;
        Json light{{"name", from.mName.C_Str()},
                   {"type", type},
                   {"color", numbersOf(strength > 0 ? Vec3(color / strength) : Vec3(Vec3::Ones()))},
                   {"intensity", fromGltf ? strength : strength * lumensPerWatt / sphere}};
        if (from.mType == aiLightSource_SPOT) {
            const double outer = std::clamp<double>(from.mAngleOuterCone / 2, 0.01, std::numbers::pi / 2);
            light["spot"] = {
                {"innerConeAngle", std::clamp<double>(from.mAngleInnerCone / 2, 0, 0.99 * outer)},
                {"outerConeAngle", outer}};
        }
        (*node)["extensions"]["KHR_lights_punctual"] = {{"light", lights.size()}};
        lights.push_back(std::move(light));
    }
    if (lights.empty())
        return;
    root["extensions"]["KHR_lights_punctual"] = {{"lights", std::move(lights)}};
    Json &used = root["extensionsUsed"];
    if (std::find(used.begin(), used.end(), "KHR_lights_punctual") == used.end())
        used.push_back("KHR_lights_punctual");
}

//! Makes a skin without a mesh of the bones below each node, which is how glTF says that they are bones.
void addBareBones(GltfDocument &document, const aiScene &scene, const std::set<std::string> &bones)
{
    struct Skin
    {
        const aiNode *above;
        Json joints = Json::array();
        std::vector<float> matrices; //!< from the node above all to each bone
    };
    std::vector<Skin> skins;
    const Json &nodes = member(document.json, "nodes");
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const aiNode *node = scene.mRootNode->FindNode(textOf(nodes[n], "name").c_str());
        if (!node || !bones.contains(node->mName.C_Str()))
            continue;
        Eigen::Affine3d place = Eigen::Affine3d::Identity();
        for (; node && bones.contains(node->mName.C_Str()); node = node->mParent)
            place = Eigen::Affine3d(toEigen(node->mTransformation)) * place;
        const Eigen::Matrix4f back = place.inverse().matrix().cast<float>();
        if (!back.allFinite())
            continue;
        auto skin = std::ranges::find(skins, node, &Skin::above);
        if (skin == skins.end())
            skin = skins.insert(skins.end(), Skin{node, Json::array(), {}});
        skin->joints.push_back(n);
        skin->matrices.insert(skin->matrices.end(), back.data(), back.data() + back.size());
    }
    for (const Skin &skin : skins) {
        const std::size_t matrices = GltfAppender(document).addMatrices(skin.matrices);
        document.json["skins"].push_back({{"joints", skin.joints}, {"inverseBindMatrices", matrices}});
    }
}

//! Gives a node and those below it the transforms that Assimp leaves out: all whose numbers differ from those
//! of the identity by no more than .01, so that small distances and scales would be lost.
void completeTransforms(Json &nodes, std::size_t number, const aiNode &from, bool moves)
{
    const aiMatrix4x4 &matrix = from.mTransformation;
    Json &node = nodes[number];
    const bool isGiven = node.contains("matrix") || node.contains("translation") ||
                         node.contains("rotation") || node.contains("scale");
    if (!isGiven && moves && !toEigen(matrix).isIdentity(0)) { // programs move no matrices
        aiVector3D scale, place;
        aiQuaternion turn;
        matrix.Decompose(scale, turn, place);
        node["translation"] = {place.x, place.y, place.z};
        node["rotation"] = {turn.x, turn.y, turn.z, turn.w};
        node["scale"] = {scale.x, scale.y, scale.z};
    } else if (!isGiven && !toEigen(matrix).isIdentity(0)) {
        const Eigen::Matrix4f columns = toEigen(matrix).cast<float>();
        node["matrix"] = std::vector<float>(columns.data(), columns.data() + columns.size());
    }
    const Json children = member(node, "children");
    for (std::size_t c = 0; c < children.size() && c < from.mNumChildren; ++c)
        completeTransforms(nodes, children[c].get<std::size_t>(), *from.mChildren[c], moves);
}

void lowerNumbers(Json &value, std::size_t removed)
{
    if (value.is_number_unsigned() && value.get<std::size_t>() > removed)
        value = value.get<std::size_t>() - 1;
}

//! Takes out a root that only holds the others: programs would show it as an object.
void removePlainRoot(Json &root)
{
    Json &scene = root["scenes"][0];
    if (member(scene, "nodes").size() != 1)
        return;
    const std::size_t number = scene["nodes"][0].get<std::size_t>();
    Json &nodes = root["nodes"];
    for (const char *key :
         {"mesh", "camera", "skin", "matrix", "translation", "rotation", "scale", "extensions"}) {
        if (nodes[number].contains(key))
            return;
    }
    for (const Json &animation : member(root, "animations")) {
        for (const Json &channel : member(animation, "channels")) {
            if (member(channel, "target").value("node", std::size_t(-1)) == number)
                return;
        }
    }
    for (const Json &skin : member(root, "skins")) {
        const Json &joints = member(skin, "joints");
        if (skin.value("skeleton", std::size_t(-1)) == number ||
            std::find(joints.begin(), joints.end(), number) != joints.end())
            return;
    }
    scene["nodes"] = member(nodes[number], "children");
    nodes.erase(number);
    const auto lowerAll = [number](Json &list) {
        for (Json &index : list)
            lowerNumbers(index, number);
    };
    lowerAll(scene["nodes"]);
    for (Json &node : nodes) {
        if (node.contains("children"))
            lowerAll(node["children"]);
    }
    for (std::size_t s = 0; s < member(root, "skins").size(); ++s) {
        Json &skin = root["skins"][s];
        if (skin.contains("joints"))
            lowerAll(skin["joints"]);
        if (skin.contains("skeleton"))
            lowerNumbers(skin["skeleton"], number);
    }
    if (!root.contains("animations"))
        return;
    for (Json &animation : root["animations"]) {
        for (Json &channel : animation["channels"])
            lowerNumbers(channel["target"]["node"], number);
    }
}

//! ExportScene has given them names of its own.
void nameAnimations(Json &root, const Scene &scene)
{
    const auto *source = sourceOf<AssimpSource>(scene);
    if (!source || !root.contains("animations"))
        return;
    Json &animations = root["animations"];
    for (std::size_t a = 0; a < animations.size() && a < source->scene->mNumAnimations; ++a) {
        const aiString &name = source->scene->mAnimations[a]->mName;
        animations[a]["name"] = name.length > 0 ? name.C_Str() : "animation";
    }
}

} // namespace

void completeGltf(GltfDocument &document, const Scene &scene, const ExportScene &exported,
                  const QString &path)
{
    removeUnusedBytes(document);
    addMaterials(document, scene, *exported.get(), path);
    const aiScene &from = *exported.get();
    completeTransforms(document.json["nodes"], document.json["scenes"][0]["nodes"][0].get<std::size_t>(),
                       *from.mRootNode, from.mNumAnimations > 0);
    addCameras(document.json, *exported.get());
    addLights(document.json, *exported.get(), isGltfFormat(scene.format));
    addBareBones(document, *exported.get(), exported.bareBones());
    nameAnimations(document.json, scene);
    removePlainRoot(document.json);
    std::map<int, QString> names;
    for (const UvSet &set : scene.uvSets)
        names[static_cast<int>(names.size())] = set.name;
    setGltfUvNames(document.json, names);
    document.json["asset"]["generator"] = "Autocuts";
}

} // namespace autocuts
