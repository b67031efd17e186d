// The properties of an object of an FBX file.
#pragma once

#include "model/io/fbx/fbxtree.h"
#include "model/plain/types.h"

#include <cmath>
#include <map>
#include <string_view>
#include <vector>

namespace autocuts {

//! The properties of an object: the children "P" of "Properties70", or "Property" of "Properties60".
class FbxProperties
{
public:
    FbxProperties(const FbxTree &tree, int object) : mTree(tree)
    {
        int list = tree.child(object, "Properties70");
        if (list < 0)
            list = tree.child(object, "Properties60");
        for (int p = list < 0 ? -1 : node(list).firstChild; p >= 0; p = node(p).next)
            mNodes.try_emplace(tree.text(p), p);
    }

    //! The numbers of the property of this name; empty when there is none.
    std::vector<double> numbers(std::string_view name) const
    {
        std::vector<double> result;
        const auto found = mNodes.find(name);
        if (found == mNodes.end())
            return result;
        for (const FbxValue &value : mTree.values(found->second, 8)) {
            if (value.kind == FbxValue::Kind::Integer || value.kind == FbxValue::Kind::Number)
                result.push_back(value.number);
        }
        return result;
    }
    Vec3 vector(std::string_view name, const Vec3 &otherwise) const
    {
        const std::vector<double> values = numbers(name);
        const Vec3 vector = values.size() < 3 ? otherwise : Vec3(values[0], values[1], values[2]);
        return vector.allFinite() ? vector : otherwise;
    }
    int integer(std::string_view name, int otherwise) const
    {
        const std::vector<double> values = numbers(name);
        return values.empty() || !(std::abs(values[0]) < 1e9) ? otherwise : static_cast<int>(values[0]);
    }

private:
    const FbxNode &node(int index) const { return mTree.nodes[static_cast<std::size_t>(index)]; }

    const FbxTree &mTree;
    std::map<std::string_view, int> mNodes; //!< the first one of each name
};

} // namespace autocuts
