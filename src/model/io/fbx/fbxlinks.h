// The objects of an FBX file by their numbers, and what is connected to what.
#pragma once

#include "model/io/fbx/fbxtree.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace autocuts {

//! A connection between two objects, or from an object to a property of another one.
struct FbxLink
{
    std::int64_t child = 0;
    std::string_view property; //!< of the parent; empty without one
};

//! The objects and connections of a file of version 7. Views and nodes belong to the tree.
class FbxLinks
{
public:
    explicit FbxLinks(const FbxTree &tree);

    //! The node of an object; -1 without one.
    int node(std::int64_t id) const;
    //! What is connected to an object, in the order of the file.
    const std::vector<FbxLink> &to(std::int64_t parent) const;
    //! The numbers of the objects of a class, such as "Model", in the order of the file.
    std::vector<std::int64_t> objects(std::string_view name) const;
    //! The kind of an object, such as "LimbNode".
    std::string_view kind(std::int64_t id) const;
    //! The models that have a name of their own, by that name.
    std::map<std::string, std::int64_t> modelsByName() const;

private:
    const FbxTree &mTree;
    std::map<std::int64_t, int> mNodes;
    std::vector<std::int64_t> mOrder;
    std::map<std::int64_t, std::vector<FbxLink>> mLinks; //!< by the number of the parent
};

} // namespace autocuts
