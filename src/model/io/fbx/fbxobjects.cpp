#include "model/io/fbx/fbxobjects.h"

#include "model/document/materialcolor.h"
#include "model/io/fbx/fbxproperties.h"
#include "model/io/fbx/fbxtextures.h"

#include <algorithm>
#include <map>
#include <set>

namespace autocuts {

namespace {

//! What connections call an object: its number, or in version 6 its name.
QByteArray keyOf(const FbxValue &value)
{
    return value.kind == FbxValue::Kind::Text ? QByteArray(value.text.data(), std::ssize(value.text))
                                              : QByteArray::number(static_cast<qlonglong>(value.integer));
}

class ObjectReader
{
public:
    explicit ObjectReader(const FbxTree &tree) : mTree(tree), mTextures(tree) {}

    FbxObjects read();

private:
    enum class Class { Model, Geometry, Material, Texture };
    struct Entry
    {
        Class kind;
        int index; //!< of a model, a material or a texture; the node of a geometry
    };

    void readObject(int node);
    void connect(const FbxValue &child, const FbxValue &parent);
    void connectTexture(const std::vector<FbxValue> &connection);
    void readContents(std::string_view name, std::string_view kind, int node);

    bool inheritsOtherwise(const FbxModel &model) const;

    const FbxTree &mTree;
    FbxObjects mObjects;
    FbxTextures mTextures;
    std::vector<QByteArray> mTextureKeys; //!< of FbxObjects::textures
    std::map<QByteArray, Entry> mEntries; //!< the first object of each key
    std::set<QByteArray> mCurveNodes;     //!< keys of animated values
    int mStacks = 0;                      //!< number of animations
};

//! Version 6 calls the colour "Diffuse" as well.
QRgb diffuseColor(const FbxTree &tree, int material)
{
    const FbxProperties properties(tree, material);
    std::vector<double> color = properties.numbers("DiffuseColor");
    if (color.empty())
        color = properties.numbers("Diffuse");
    return color.size() < 3 ? 0 : materialColor(color[0], color[1], color[2]);
}

void ObjectReader::readContents(std::string_view name, std::string_view kind, int node)
{
    SourceContents &contents = mObjects.contents;
    contents.bones = contents.bones || kind == "Skin" || kind == "Cluster";
    const std::string_view skinning = mTree.text(mTree.child(node, "SkinningType"));
    contents.dualQuaternions =
        contents.dualQuaternions || skinning == "DualQuaternion" || skinning == "Blend";
    contents.shapeKeys =
        contents.shapeKeys || kind == "BlendShape" || kind == "Shape" || mTree.child(node, "Shape") >= 0;
    contents.animations = contents.animations || name == "AnimationCurve";
    if (name == "AnimationStack" && ++mStacks > 1)
        contents.severalAnimations = true;
    contents.lightsOrCameras = contents.lightsOrCameras || kind == "Light" || kind == "Camera";
    mObjects.surfaces = mObjects.surfaces || kind == "NurbsSurface" || kind == "Nurb";
    mObjects.curves = mObjects.curves || kind == "NurbsCurve" || kind == "Line";
    contents.shapesWithoutFaces = contents.shapesWithoutFaces || mObjects.surfaces || mObjects.curves ||
                                  kind == "TrimNurbsSurface" || kind == "Boundary";
    contents.stereoCameras = contents.stereoCameras || kind == "CameraStereo";
    mObjects.skeleton = mObjects.skeleton || kind == "LimbNode" || kind == "Limb";
    contents.embeddedTextures =
        contents.embeddedTextures || (name == "Video" && mTree.child(node, "Content") >= 0);
}

void ObjectReader::readObject(int node)
{
    const std::string_view name = mTree.name(node);
    const std::vector<FbxValue> values = mTree.values(node, 3);
    if (values.empty())
        return;
    readContents(name, values.back().kind == FbxValue::Kind::Text ? values.back().text : "", node);
    const bool numbered = values[0].kind != FbxValue::Kind::Text;
    const std::string_view called = numbered ? (values.size() > 1 ? values[1].text : "") : values[0].text;
    const QByteArray key = keyOf(values[0]);
    const bool hasPolygons = mTree.child(node, "PolygonVertexIndex") >= 0;
    if (name == "Model") {
        mEntries.try_emplace(key, Entry{Class::Model, static_cast<int>(mObjects.models.size())});
        FbxModel &model = mObjects.models.emplace_back();
        model.node = node;
        model.name = fbxObjectName(mTree, called);
        if (hasPolygons)
            model.geometries.push_back(node);
    } else if (name == "Geometry" && hasPolygons) {
        mEntries.try_emplace(key, Entry{Class::Geometry, node});
    } else if (name == "Material") {
        mEntries.try_emplace(key, Entry{Class::Material, static_cast<int>(mObjects.materialNames.size())});
        mObjects.materialNames.push_back(fbxObjectName(mTree, called));
        mObjects.materialColors.push_back(diffuseColor(mTree, node));
    } else if (name == "Texture") {
        mTextureKeys.push_back(key);
        mEntries.try_emplace(key, Entry{Class::Texture, static_cast<int>(mObjects.textures.size())});
        mObjects.textures.push_back({fbxObjectName(mTree, called), {}});
    } else if (name == "AnimationCurveNode") {
        mCurveNodes.insert(key);
    }
    mTextures.addObject(name, key, node);
}

void ObjectReader::connectTexture(const std::vector<FbxValue> &connection)
{
    const QByteArray parent = keyOf(connection[2]);
    const auto to = mEntries.find(parent);
    const bool toMaterial = to != mEntries.end() && to->second.kind == Class::Material;
    mTextures.connect(keyOf(connection[1]), parent, toMaterial ? to->second.index : -1,
                      connection.size() > 3 ? connection[3].text : std::string_view());
}

void ObjectReader::connect(const FbxValue &child, const FbxValue &parent)
{
    const auto from = mEntries.find(keyOf(child));
    if (from == mEntries.end())
        return;
    const Entry entry = from->second;
    const QByteArray parentKey = keyOf(parent);
    const auto to = mEntries.find(parentKey);
    const bool toModel = to != mEntries.end() && to->second.kind == Class::Model;
    if (entry.kind == Class::Model) {
        FbxModel &model = mObjects.models[static_cast<std::size_t>(entry.index)];
        const bool toRoot = to == mEntries.end() && (parentKey == "0" || parentKey == "Model::Scene" ||
                                                     parentKey.startsWith("Scene\0"));
        if (model.connected || (!toModel && !toRoot))
            return;
        model.connected = true;
        model.parent = toModel ? to->second.index : -1;
        mObjects.contents.hierarchy = mObjects.contents.hierarchy || toModel;
        return;
    }
    if (!toModel)
        return;
    FbxModel &model = mObjects.models[static_cast<std::size_t>(to->second.index)];
    std::vector<int> &list = entry.kind == Class::Geometry   ? model.geometries
                             : entry.kind == Class::Material ? model.materials
                                                             : model.textures;
    list.push_back(entry.index);
}

//! True where the scale of the parent does something else to a model than its matrix would.
bool ObjectReader::inheritsOtherwise(const FbxModel &model) const
{
    if (model.parent < 0)
        return false;
    constexpr int byAxes = 0, byMatrix = 1, never = 2;
    const int rule = FbxProperties(mTree, model.node).integer("InheritType", byAxes);
    const FbxModel &parent = mObjects.models[static_cast<std::size_t>(model.parent)];
    const Vec3 scale = FbxProperties(mTree, parent.node).vector("Lcl Scaling", Vec3::Ones());
    const double largest = scale.cwiseAbs().maxCoeff();
    const bool uneven = (scale.array() - scale.x()).abs().maxCoeff() > 1e-4 * largest;
    const bool scaled = (scale.array() - 1).abs().maxCoeff() > 1e-4;
    return rule != byMatrix && (uneven || (rule == never && scaled));
}

FbxObjects ObjectReader::read()
{
    const FbxTree &tree = mTree;
    const auto childrenOf = [&](int parent) {
        std::vector<int> children;
        for (int c = parent < 0 ? -1 : tree.nodes[static_cast<std::size_t>(parent)].firstChild; c >= 0;
             c = tree.nodes[static_cast<std::size_t>(c)].next)
            children.push_back(c);
        return children;
    };
    for (const int object : childrenOf(tree.child(0, "Objects")))
        readObject(object);
    for (const int connection : childrenOf(tree.child(0, "Connections"))) {
        const std::vector<FbxValue> values = tree.values(connection, 4);
        if (values.size() < 3 || values[0].kind != FbxValue::Kind::Text)
            continue;
        if (values.size() == 3 && values[0].text == "OO")
            connect(values[1], values[2]);
        if (values.size() > 3 && mCurveNodes.contains(keyOf(values[1])))
            mObjects.contents.otherAnimations |= !values[3].text.starts_with("Lcl ");
        connectTexture(values);
    }
    mObjects.materialTextures = mTextures.ofMaterials(mObjects.materialNames.size());
    mObjects.materialSets = mTextures.setsOfMaterials(mObjects.materialNames.size());
    for (const FbxModel &model : mObjects.models) {
        for (const int t : model.textures)
            mObjects.textures[static_cast<std::size_t>(t)].picture =
                mTextures.read(mTextureKeys[static_cast<std::size_t>(t)]);
    }
    for (const int take : childrenOf(tree.child(0, "Takes")))
        mObjects.contents.animations = mObjects.contents.animations || tree.child(take, "Model") >= 0;
    // Names of version 6 may be those of several objects, of which connections say nothing.
    for (FbxModel &model : mObjects.models)
        model.connected = model.connected || tree.version < 7000;
    mObjects.contents.otherScaling = std::ranges::any_of(
        mObjects.models, [this](const FbxModel &model) { return inheritsOtherwise(model); });
    return std::move(mObjects);
}

} // namespace

QString fbxObjectName(const FbxTree &tree, std::string_view text)
{
    if (const std::size_t end = text.find(std::string_view("\0\1", 2)); end != std::string_view::npos)
        text = text.substr(0, end);
    else if (const std::size_t colons = text.find("::"); colons != std::string_view::npos)
        text = text.substr(colons + 2);
    return tree.binary ? QString::fromUtf8(text.data(), std::ssize(text))
                       : QString::fromUtf8(unescapedFbx(text));
}

FbxObjects readFbxObjects(const FbxTree &tree)
{
    return ObjectReader(tree).read();
}

} // namespace autocuts
