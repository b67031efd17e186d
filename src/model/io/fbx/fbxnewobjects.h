// The objects of a new FBX file and their connections.
#pragma once

#include "model/io/fbx/fbxeditor.h"
#include "model/plain/types.h"

#include <QString>

#include <map>

namespace autocuts {

//! A node with one value.
FbxNewNode fbxLeaf(const char *name, FbxNewValue value);
//! An entry of Properties70.
FbxNewNode fbxProperty(const char *name, const char *type, const char *label,
                       std::vector<FbxNewValue> values);
FbxNewNode fbxNumber(const char *name, double value);
FbxNewNode fbxVector(const char *name, const char *type, const Vec3 &value);
FbxNewNode fbxProperties(std::vector<FbxNewNode> properties);

//! Collects objects. They get numbers in their order.
class FbxNewObjects final
{
public:
    //! \param name the user's \param kind the class, as in "Geometry" \param subclass as in "Mesh"
    std::int64_t add(const QByteArray &kind, const QString &name, const QByteArray &subclass,
                     std::vector<FbxNewNode> children);
    //! \param property of the parent; empty: the object itself
    void connect(std::int64_t child, std::int64_t parent, const QByteArray &property = {});

    FbxNewNode definitions() const;
    FbxNewNode takeObjects() { return std::move(mObjects); }
    FbxNewNode takeConnections() { return std::move(mConnections); }

private:
    std::int64_t mNext = 1'000'000;
    std::map<QByteArray, int> mCounts;
    FbxNewNode mObjects{"Objects", {}, {}, true};
    FbxNewNode mConnections{"Connections", {}, {}, true};
};

} // namespace autocuts
