// The part of the drag tool for running solves.
#include "commands/setseamstate.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/tools/dragtool.h"

#include <algorithm>
#include <set>

namespace autocuts {

namespace {

//! Spring constants of dragged corners and of corners outside the circle; a vertex of the energy has a
//! stiffness of about 1. Chosen by hand.
constexpr double pullWeight = 100, stayWeight = 0.1;

} // namespace

//! Pulls the dragged corners, and holds the corners of their islands outside the circle in their places.
//! Other islands stay by themselves, each at its own scale.
void DragTool::pull(const Vec2 &way)
{
    std::vector<Pin> pulls;
    std::vector<int> dragged;
    const Document &document = *context().workspace.document();
    const auto islandOf = [&](int corner) {
        return document.islands().islandOfFace(document.mesh().triangleFace[corner / 3]);
    };
    std::set<int> islands;
    for (const int corner : mReach.corners) {
        if (mReach.weight[corner] == 1)
            islands.insert(islandOf(corner));
    }
    for (int corner : mReach.corners) {
        const Vec2 place = mUv.row(corner);
        if (mReach.weight[corner] == 1) {
            pulls.push_back({corner, place + way, false, pullWeight});
            dragged.push_back(corner);
        } else if (mReach.weight[corner] == 0 && islands.contains(islandOf(corner))) {
            pulls.push_back({corner, place, false, stayWeight});
        }
    }
    context().solver.setPulls(std::move(pulls), std::move(dragged));
}

void DragTool::keepSeams()
{
    Document &document = *context().workspace.document();
    const MeshData &mesh = document.mesh();
    const std::vector<float> &separation = context().shownMap.separation();
    const auto isInCircle = [&](int pair) {
        const auto &corners = mesh.edgePairs[pair / 2].corner[pair % 2];
        return mReach.weight[corners[0]] > 0 || mReach.weight[corners[1]] > 0;
    };
    std::vector<int> joined;
    for (const Gap &gap : mClosed)
        joined.push_back(gap.pair);
    std::sort(joined.begin(), joined.end());
    joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
    IndexRanges pairs;
    for (int pair : joined)
        pairs.append(pair);
    for (int pair = 0; joined.empty() && pair < mesh.cornerPairCount(); ++pair) {
        if (mSeparation[pair] < 0.5f && separation[pair] >= 0.5f && isInCircle(pair) &&
            document.seams().states[pair] == PairState::Free)
            pairs.append(pair);
    }
    mShutting = joined;
    const auto edit = joined.empty() ? SetSeamState::Edit::Cut : SetSeamState::Edit::Join;
    pushCommand(std::make_unique<SetSeamState>(document, edit, pairs));
}

void DragTool::letGoWhenShut()
{
    if (mShutting.empty() || mState == State::Drag)
        return;
    const std::vector<float> &separation = context().shownMap.separation();
    const auto isOpen = [&](int pair) { return separation[pair] >= 0.5f; };
    const bool waits = --mPatience > 0 && !context().solver.status().converged;
    if (!waits || !std::any_of(mShutting.begin(), mShutting.end(), isOpen))
        letGo();
}

void DragTool::letGo()
{
    mShutting.clear();
    context().solver.setPulls({});
}

} // namespace autocuts
