// Joins the UV sets of the geometries of an FBX file to UV sets of the scene.
#pragma once

#include "model/document/scene.h"

#include <set>

namespace autocuts {

//! Every geometry has UV sets of its own; the scene has one list for all. Sets of one name belong together,
//! as they do for artists. A set whose name no geometry before has used joins the set in the same place of
//! the list, unless its geometry has a set there already: "UVMap" of one object and "map1" of another are
//! both their first maps. Otherwise it begins a new set.
class FbxUvSets
{
public:
    //! The scene has at most this many sets; it keeps a damaged file from taking much memory.
    static constexpr int maxSets = 64;

    //! For each UV set of a geometry the index of the scene's set, -1 when there are too many.
    std::vector<int> join(const std::vector<QString> &names);

    //! The names of the scene's sets, all different.
    std::vector<QString> names() const;

private:
    struct Set
    {
        QString name;
        std::set<QString> joined; //!< names in the file
    };
    int named(const QString &name, const std::set<int> &taken) const;
    int added(const QString &name);

    std::vector<Set> mSets;
};

} // namespace autocuts
