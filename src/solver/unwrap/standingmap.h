// The map before a job, as what the job has to beat: a good map never gets worse.
#pragma once

#include "solver/packing/packing.h"
#include "solver/unwrap/candidates.h"
#include "solver/unwrap/freepart.h"

namespace autocuts::unwrap {

//! What a map is worth, with each island at its own scale; nothing when it is not valid.
//! \param problem of the part, with the seam preferences in its weights
//! \param uv per corner of the whole mesh, texture space
[[nodiscard]] std::optional<Candidate> worthOf(const FreePart &part, const std::shared_ptr<const Soup> &soup,
                                               const Snapshot &problem, const UvMatrix &uv);

//! How far a map fulfils the steering that is wished for but not required.
struct Wishes
{
    //! How far soft pins are from their places: the sum of their weights times the squared distances, solver
    //! units. 0 without soft pins.
    double pull = 0;
    //! Share of the borders of islands along the axes, where that is asked for, otherwise 0.
    double aligned = 0;

    //! \param uv per corner, texture space
    static Wishes of(const Snapshot &snapshot, const UvMatrix &uv);
    //! True when one of both is noticeably better than in another map.
    bool isBetterThan(const Wishes &other) const;
};

struct StandingMap
{
    Candidate worth;
    //! Its islands are where they belong. Otherwise only their shapes may stay.
    bool inPlace = false;
    Wishes wishes{};
};

//! The snapshot's map, if its islands may keep their shapes: it is valid, edges are open that are to be cut,
//! its cuts are symmetric where that is asked for, it lies in place if there are wishes, and nothing else is
//! asked for that is not measured: mirrored maps, an upright map, another energy. Whether it obeys pins,
//! joins, straight loops and given seams, unmetSteering() tells. Nothing when stopped.
[[nodiscard]] std::optional<StandingMap>
standingMap(const Snapshot &snapshot, const FreePart &part, const std::shared_ptr<const Soup> &soup,
            const Snapshot &problem, const packing::PackOptions &packing, const JobContext &job = {});

//! True when a map is better: within the bound it has noticeably cheaper seams, or seams that are not dearer
//! and less distortion.
[[nodiscard]] bool beats(Candidate map, Candidate standing, double maxDistortion);
//! \param problem with the seam preferences in its weights
[[nodiscard]] bool beats(const SeamedMap &map, const Soup &soup, const Snapshot &problem,
                         const Candidate &standing, double maxDistortion);

} // namespace autocuts::unwrap
