// Connected parts of a mesh that are copies of each other: one of each kind is cut, the others get its map.
#pragma once

#include "model/plain/meshpart.h"
#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"

#include <optional>
#include <vector>

namespace autocuts::unwrap {

//! The parts of a problem. Copies have the same lengths; where flat faces keep their shape, parts of such
//! faces may differ by 5 %: distortion and seams of those hardly do. Parts that the user steers (cuts, joins,
//! weights, straight loops), or whose texel weights differ, are no copies: each is cut on its own.
class AlikeParts
{
public:
    //! \returns nothing when there are no copies, or when the settings ask for
    //! something that differs between copies: to leave alike parts alone, hidden seams, a map to start from,
    //! places of islands; or when the job is stopped
    static std::optional<AlikeParts> of(const Snapshot &snapshot, const JobContext &job = {});

    //! The problem without the copies. What stands for copies counts as often as there are copies, so that
    //! the bound on the distortion means the same.
    const Snapshot &snapshot() const { return mSnapshot; }
    //! The map of the whole mesh, in which copies lie on each other. Mirrored copies have a mirrored map.
    //! Parts that are nearly copies, by up to 5 %, are relaxed, so that their flat faces keep their own
    //! shape. \param map of the mesh of snapshot()
    SeamedMap expanded(const SeamedMap &map, const JobContext &job = {}) const;
    //! The seams of the expanded map. \param cut of the mesh of snapshot() \param whole the soup of all parts
    double seamLength(const CutFlags &cut, const Soup &whole) const;

    //! A map of the whole mesh in which all copies of a part have the map of one of them, but not of a near
    //! copy: that with the cheapest seams, or where that misses the bound, one with less stretch. \param
    //! preferred of the whole mesh, with the preferences in its weights \param mu energy that one unit of
    //! seam cost is worth \param bound on the distortion \returns the map as it was when the bound would be
    //! missed, or seams cost 5 % more, or when stopped
    SeamedMap unified(const SeamedMap &map, const Snapshot &preferred, double mu, double bound,
                      const JobContext &job = {}) const;

private:
    class Finder;

    std::vector<int> kinds() const;
    SeamedMap chosenMap(const SeamedMap &map, const std::vector<int> &kind,
                        const std::vector<int> &donor) const;

    void relaxNearCopies(SeamedMap &map, const JobContext &job) const;

    std::shared_ptr<const MeshData> mWhole;
    MeshPart mPart;
    Snapshot mSnapshot;
    // Of the whole mesh. What is not in a copy is its own source.
    std::vector<int> mSourceCorner, mSourceEdge; //!< per corner and per edge pair: those of the part
    std::vector<bool> mMirrored;                 //!< per face
    MeshPart mNear;                              //!< what is nearly a copy; null mesh: nothing
    SolveSettings mSettings;
};

} // namespace autocuts::unwrap
