// Changes the UV sets of one geometry of an FBX file.
#pragma once

#include "model/io/fbx/fbxeditor.h"
#include "model/io/fbx/fbxuvdata.h"

#include <QString>

#include <map>

namespace autocuts {

//! A whole LayerElementUV.
FbxNewNode newUvElement(int index, const QString &name, FbxUvData data);
//! A layer that names a LayerElementUV.
FbxNewNode newUvLayer(int layer, int index);

//! The LayerElementUV nodes of a geometry and the entries of its Layer nodes that name them. Collects the
//! changes; finish() gives them to the editor.
class FbxUvElements
{
public:
    FbxUvElements(const FbxTree &tree, int geometry, FbxEditor &editor);

    void rename(int element, const QString &name) { mChanges[element].name = name; }
    void setData(int element, FbxUvData data) { mChanges[element].data = std::move(data); }
    void remove(int element) { mRemoved.push_back(element); }
    //! A new set. It takes the place of one that is removed, or else comes behind all others.
    void add(const QString &name, FbxUvData data) { mAdded.push_back({name, std::move(data)}); }
    void finish();

private:
    struct Change
    {
        std::optional<QString> name;
        std::optional<FbxUvData> data;
    };
    void setChild(int element, std::string_view name, FbxNewValue value);
    void change(int element, Change change);
    void takeOut();
    bool isRemoved(std::int64_t number) const;
    std::optional<std::int64_t> numberAfterGaps(int node) const;
    void insert(std::size_t first);
    bool layerHasUv(int layer) const;
    int lastElement() const;
    std::int64_t nextIndex(std::string_view name) const;

    const FbxTree &mTree;
    int mGeometry;
    FbxEditor &mEditor;
    std::map<int, Change> mChanges;
    std::vector<int> mRemoved;
    std::vector<int> mReplaced; //!< written anew as a whole, with their final numbers
    std::vector<Change> mAdded;
};

} // namespace autocuts
