// The part of the drag tool that tears definite maps.
#include "commands/setseamstate.h"
#include "views/control/editing/tearing.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/tools/dragtool.h"

#include <utility>

namespace autocuts {

namespace {

//! How often its length or width a triangle is stretched or squeezed before the map tears, and before the
//! user is told that it will. Chosen by hand.
constexpr double mostStrain = 4, warningStrain = 2.5;
//! Pixels that the mouse has to be ahead of a map that can follow no further. Chosen by hand.
constexpr double tearDistance = 40;

} // namespace

//! True when a pull is past what the map bears. \param resistance by how many pixels the map stays behind
bool DragTool::tearsAt(double strain, double resistance)
{
    if (!mTorn.empty() || !mClosed.empty() || !reachesAround())
        return false;
    setStrained(strain > warningStrain || resistance > 0);
    return strain > mostStrain || resistance > tearDistance;
}

void DragTool::setStrained(bool strained)
{
    if (std::exchange(mStrained, strained) != strained)
        Q_EMIT hintChanged();
}

//! Tears the definite map of a running solve when it is past what it bears.
void DragTool::tearLive()
{
    const ShownMap &shown = context().shownMap;
    if (mState != State::Drag || !mLive || shown.isSoup() || shown.uv().rows() != mUv.rows())
        return;
    std::vector<int> inCircle;
    for (const int corner : mReach.corners) {
        if (mReach.weight[corner] > 0)
            inCircle.push_back(corner);
    }
    if (tearsAt(strainOf(mUv, shown.uv(), inCircle)) && tear())
        apply();
}

bool DragTool::tear()
{
    Document &document = *context().workspace.document();
    const std::optional<TornPart> part = tornPart(document, mSeparation, mReach.weight);
    if (!part)
        return false;
    if (!mLive)
        cancelGesture(document, mGesture); // the deformed map is not what tears
    mTorn = part->edges;
    mHandles = part->soupCorners;
    for (const int edge : mTorn)
        mSeparation[2 * edge] = mSeparation[2 * edge + 1] = 1;
    if (mLive) {
        auto command = std::make_unique<SetSeamState>(document, SetSeamState::Edit::Cut,
                                                      cornerPairsOfEdges(document.mesh(), mTorn));
        command->setGesture(mGesture);
        pushCommand(std::move(command));
    }
    updateReach();
    findGaps();
    setStrained(false);
    Q_EMIT hintChanged();
    return true;
}

} // namespace autocuts
