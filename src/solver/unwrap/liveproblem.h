// What a live solve works on: the document's state, and the problem of the part that may change.
#pragma once

#include "solver/preference/seampreference.h"
#include "solver/search/seamgraph.h"
#include "solver/straight/straightening.h"
#include "solver/unwrap/freepart.h"

#include <memory>
#include <optional>

namespace autocuts::unwrap {

class LiveProblem
{
public:
    //! Works on what the snapshot lets change. The seam graph of before is steered anew where that is the
    //! same, and made anew where only texel weights changed. \returns false when there was another part, or
    //! none: maps of that are of no use \throws std::runtime_error when nothing may change
    bool update(std::shared_ptr<const Snapshot> snapshot, int threads);
    //! Forgets the part; the next one is numbered anew.
    void reset();

    //! True when the last update changed texel weights: a map of before is right but for its sizes.
    bool hasNewSizes() const { return mHasNewSizes; }

    //! The whole mesh.
    const Snapshot &whole() const { return *mWhole; }
    const FreePart &part() const { return *mPart; }
    //! Of the part, with the seam preferences in its weights.
    const Snapshot &problem() const { return mProblem; }
    const std::shared_ptr<const Soup> &soup() const { return mSoup; }
    const std::shared_ptr<const search::SeamGraph> &graph() const { return mGraph; }
    //! Share of the area in parts that count as hard surfaces.
    double hardShare() const { return mHardShare; }
    //! What is to be straight.
    const straight::StraightPlan &plan() const { return mPlan; }
    //! Symmetric seams are asked for, and the part is symmetric.
    bool isSymmetric() const { return mProblem.settings.symmetry == SymmetryMode::On && mSymmetry; }
    //! Share of the part's area that has a mirror image, 0 where it is not symmetric; nothing when symmetric
    //! seams are not asked for.
    std::optional<double> mirroredArea() const;
    //! An unwrap in standard quality that begins anew finds the map of the part on a coarser mesh first.
    bool isForCoarse() const;

private:
    //! Where symmetric seams are left open, settles whether they stay so. \param same the part is as before
    void settleSymmetry(bool same);

    std::shared_ptr<const Snapshot> mWhole;
    preference::SeamPreference mPreference;
    std::optional<preference::MeshSymmetry> mSymmetry;
    std::shared_ptr<const UvMatrix> mJudgedMap; //!< of the document
    bool mHasSymmetricSeams = false;            //!< it has
    std::optional<FreePart> mPart;
    bool mHasNewSizes = false;
    Snapshot mProblem;
    straight::StraightPlan mPlan;
    double mHardShare = 0;
    std::shared_ptr<const Soup> mSoup;
    std::shared_ptr<const search::SeamGraph> mGraph;
};

} // namespace autocuts::unwrap
