#include "model/io/fbx/fbxnewobjects.h"

namespace autocuts {

FbxNewNode fbxLeaf(const char *name, FbxNewValue value)
{
    return {name, {std::move(value)}, {}, false};
}

FbxNewNode fbxProperty(const char *name, const char *type, const char *label, std::vector<FbxNewValue> values)
{
    FbxNewNode node{"P", {QByteArray(name), QByteArray(type), QByteArray(label), QByteArray()}, {}, false};
    node.values.insert(node.values.end(), values.begin(), values.end());
    return node;
}

FbxNewNode fbxNumber(const char *name, double value)
{
    return fbxProperty(name, "double", "Number", {value});
}

FbxNewNode fbxVector(const char *name, const char *type, const Vec3 &value)
{
    return fbxProperty(name, type, "", {value.x(), value.y(), value.z()});
}

FbxNewNode fbxProperties(std::vector<FbxNewNode> properties)
{
    return {"Properties70", {}, std::move(properties), true};
}

std::int64_t FbxNewObjects::add(const QByteArray &kind, const QString &name, const QByteArray &subclass,
                                std::vector<FbxNewNode> children)
{
    // Names end in the class; that of nodes' attributes is another word than the node's.
    const QByteArray shown = kind == "Deformer" && subclass == "Cluster" ? QByteArray("SubDeformer")
                             : kind == "AnimationStack"                  ? QByteArray("AnimStack")
                             : kind == "AnimationLayer"                  ? QByteArray("AnimLayer")
                             : kind == "AnimationCurveNode"              ? QByteArray("AnimCurveNode")
                             : kind == "AnimationCurve"                  ? QByteArray("AnimCurve")
                                                                         : kind;
    const std::int64_t id = mNext++;
    ++mCounts[kind];
    mObjects.children.push_back(
        {kind, {id, name.toUtf8() + QByteArray("\0\1", 2) + shown, subclass}, std::move(children), true});
    return id;
}

void FbxNewObjects::connect(std::int64_t child, std::int64_t parent, const QByteArray &property)
{
    FbxNewNode node{"C", {QByteArray(property.isEmpty() ? "OO" : "OP"), child, parent}, {}, false};
    if (!property.isEmpty())
        node.values.push_back(property);
    mConnections.children.push_back(std::move(node));
}

FbxNewNode FbxNewObjects::definitions() const
{
    FbxNewNode node{"Definitions", {}, {fbxLeaf("Version", std::int32_t(100))}, true};
    std::vector<std::pair<QByteArray, int>> types{{"GlobalSettings", 1}};
    types.insert(types.end(), mCounts.begin(), mCounts.end());
    int count = 0;
    for (const auto &[type, number] : types)
        count += number;
    node.children.push_back(fbxLeaf("Count", std::int32_t(count)));
    for (const auto &[type, number] : types)
        node.children.push_back({"ObjectType", {type}, {fbxLeaf("Count", std::int32_t(number))}, true});
    return node;
}

} // namespace autocuts
