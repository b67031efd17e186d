#include "solver/unwrap/liveproblem.h"

#include "solver/preference/surfacekind.h"
#include "solver/unwrap/coarsetofine.h"
#include "solver/unwrap/symmetricseams.h"

#include <stdexcept>

namespace autocuts::unwrap {

bool LiveProblem::update(std::shared_ptr<const Snapshot> snapshot, int threads)
{
    mWhole = std::move(snapshot);
    std::optional<FreePart> part = FreePart::of(*mWhole, mPart ? &*mPart : nullptr);
    if (!part)
        throw std::runtime_error("nothing may change: all islands are locked, pinned, stacked or grouped");
    const bool same = mPart && part->sameFaces(*mPart);
    mHasNewSizes = mPart && !same && part->hasOtherSizes(*mPart);
    mPart = std::move(part);
    mPlan = straight::StraightPlan::of(mPart->snapshot());
    mHardShare = preference::surfaceParts(*mPart->snapshot().mesh, mWhole->settings.surface).hardShare;
    mProblem = mPreference.applied(mPart->withoutRectangles(), threads);
    if (!same) {
        mSoup = Soup::build(mProblem.mesh);
        mGraph = nullptr;
        if (!mHasNewSizes)
            mSymmetry.reset();
    }
    settleSymmetry(same);
    if (mProblem.settings.symmetry == SymmetryMode::On && !mSymmetry)
        mSymmetry = preference::findSymmetry(*mProblem.mesh);
    const preference::MeshSymmetry *symmetry = isSymmetric() ? &*mSymmetry : nullptr;
    mGraph =
        mGraph ? mGraph->steeredBy(mProblem, symmetry) : search::SeamGraph::build(mSoup, mProblem, symmetry);
    return same || mHasNewSizes;
}

void LiveProblem::settleSymmetry(bool same)
{
    SymmetryMode &mode = mProblem.settings.symmetry;
    if (mode != SymmetryMode::Auto)
        return;
    if (!same)
        mJudgedMap = nullptr;
    const bool open = mWhole->uv && isSymmetryOpen(mProblem);
    if (open && mWhole->uv != mJudgedMap) {
        mJudgedMap = mWhole->uv;
        mHasSymmetricSeams = hasSymmetricSeams(mProblem);
    }
    mode = open && mHasSymmetricSeams ? SymmetryMode::On : SymmetryMode::Off;
}

void LiveProblem::reset()
{
    mPart.reset();
    mSymmetry.reset();
}

std::optional<double> LiveProblem::mirroredArea() const
{
    if (mProblem.settings.symmetry != SymmetryMode::On)
        return std::nullopt;
    return mSymmetry ? mSymmetry->matchedArea : 0;
}

bool LiveProblem::isForCoarse() const
{
    Snapshot anew = mProblem;
    anew.settings.start = StartMode::Rigid;
    return !isSymmetric() && suitsCoarseToFine(anew, {});
}

} // namespace autocuts::unwrap
