// Places the islands of an unwrap's map.
#pragma once

#include "solver/straight/straightening.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/unwrapoptions.h"

namespace autocuts::unwrap {

//! Packs the islands of a map as the snapshot's steering and settings say. With AutoY or AutoZ,
//! and nothing else that says how islands lie, they are packed a second time: turned
//! so that the direction is up, see straight/upright.h. That layout is taken where it costs at most 5 % of
//! the texel density.
class UnwrapPlacing
{
public:
    //! \param snapshot the whole mesh \param part of it, to which maps belong. All must outlive this.
    UnwrapPlacing(const Snapshot &snapshot, const FreePart &part, const straight::StraightPlan &plan,
                  const UnwrapOptions &options)
        : mSnapshot(snapshot), mPart(part), mPlan(plan), mOptions(options)
    {}

    //! Sets uv, flags, packed, madeSmaller and upright of a result. \param map of the part
    void place(const Soup &soup, const SeamedMap &map, PackHurry hurry, const JobContext &job,
               UnwrapResult &result) const;

private:
    enum class MayTurn { AsSet, No }; // whether packing turns islands

    bool staysInPlace() const;
    bool keepsScale() const;
    bool mayTurn() const;
    UvMatrix partUv(const Soup &soup, const SeamedMap &map) const;
    void pack(const Soup &soup, const SeamedMap &map, MayTurn turning, PackHurry hurry, const JobContext &job,
              UnwrapResult &result) const;
    void turnUpright(const Soup &soup, const SeamedMap &map, const JobContext &job,
                     UnwrapResult &result) const;

    const Snapshot &mSnapshot;
    const FreePart &mPart;
    const straight::StraightPlan &mPlan;
    const UnwrapOptions &mOptions;
};

} // namespace autocuts::unwrap
