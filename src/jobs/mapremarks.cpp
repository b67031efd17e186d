#include "jobs/mapremarks.h"

#include "model/plain/uvlayout.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/preference/meshsymmetry.h"

#include <algorithm>

namespace autocuts::jobs {

namespace {

using Kind = Remark::Kind;

//! Share of the area from which a mesh counts as symmetric. Chosen by hand.
constexpr double nearlyAll = 0.999;

void add(Remarks &remarks, Kind kind, const std::vector<int> &items)
{
    if (!items.empty())
        remarks.push_back({kind, 0, {}, items});
}

void append(Remarks &remarks, const Remarks &more)
{
    remarks.insert(remarks.end(), more.begin(), more.end());
}

Remark aboveBound(double distortion, double bound)
{
    return {Kind::AboveBound, distortion, {}, {}, bound};
}

//! Whether a map of a stopped job is straight. \param straight see unwrap::UnwrapResult
void addStraight(const std::optional<bool> &straight, MapRemarks &remarks)
{
    if (straight)
        *straight ? remarks.notes.push_back({Kind::Straight})
                  : remarks.problems.push_back({Kind::NotStraight});
}

//! Says it where faces that have to stay lie on others: no job takes them apart.
void addHeldOverlaps(const Snapshot &snapshot, const UvMatrix &uv, MapRemarks &remarks)
{
    const Steering &steering = *snapshot.steering;
    const bool stacks =
        std::ranges::any_of(steering.faceFlags, [](const IslandFlags &f) { return f.stack != 0; });
    const bool holds =
        std::ranges::any_of(steering.pins, &Pin::hard) ||
        std::ranges::any_of(steering.faceFlags, [](const IslandFlags &f) { return f.locked != 0; });
    if (holds && !stacks && uv.rows() > 0 && !overlap::findOverlaps(soupUv(*snapshot.mesh, uv)).pairs.empty())
        remarks.problems.push_back({Kind::HeldOverlaps});
}

void addSymmetry(const Snapshot &snapshot, const unwrap::UnwrapResult &made, MapRemarks &remarks)
{
    const auto symmetry = preference::findSymmetry(*snapshot.mesh);
    if (symmetry && made.symmetry)
        remarks.notes.push_back({Kind::SymmetricSeams, *made.symmetry});
    if (snapshot.settings.symmetry != SymmetryMode::On)
        return;
    if (made.symmetryMissed)
        remarks.problems.push_back({Kind::NoSymmetricCuts});
    append(remarks.problems, remarksOnSymmetry(symmetry ? symmetry->matchedArea : 0));
}

} // namespace

Remark noRoom(bool keepsScale)
{
    return {keepsScale ? Kind::NoRoomAtScale : Kind::NoRoom};
}

Remarks remarksOn(const unwrap::UnmetSteering &unmet)
{
    Remarks remarks;
    add(remarks, Kind::UnmetPins, unmet.pins);
    add(remarks, Kind::UnmetJoins, unmet.joins);
    add(remarks, Kind::BentLoops, unmet.bent);
    add(remarks, Kind::MissingSeams, unmet.missingSeams);
    add(remarks, Kind::UnmetRectangles, unmet.rectangles);
    return remarks;
}

Remarks remarksOnSymmetry(double mirrored)
{
    if (mirrored == 0)
        return {{Kind::NotSymmetric}};
    return mirrored >= nearlyAll ? Remarks() : Remarks{{Kind::PartlySymmetric, mirrored}};
}

MapRemarks remarksOn(const Snapshot &snapshot, const unwrap::UnwrapOptions &options,
                     const unwrap::UnwrapResult &made)
{
    MapRemarks remarks;
    if (made.nothingFree) {
        remarks.problems.push_back({Kind::NothingFree});
        return remarks;
    }
    if (made.nothingGained)
        remarks.notes.push_back({Kind::NothingGained});
    if (made.upright)
        remarks.notes.push_back({Kind::Upright});
    if (options.pack && !made.packed)
        remarks.problems.push_back(noRoom(options.packing.keepScale));
    if (made.madeSmaller)
        remarks.problems.push_back({Kind::MadeSmaller});
    if (made.onlyPatches)
        remarks.problems.push_back({made.stopped ? Kind::PatchesSoFar : Kind::OnlyPatches});
    append(remarks.problems, remarksOn(made.unmet));
    if (!made.withinBound)
        remarks.problems.push_back(
            aboveBound(metrics::measureShapes(*snapshot.mesh, made.uv, snapshot.tileHeight).tileDirichlet,
                       options.maxDistortion));
    if (made.stopped)
        addStraight(made.straight, remarks);
    if (made.symmetry || made.symmetryMissed)
        addSymmetry(snapshot, made, remarks);
    addHeldOverlaps(snapshot, made.uv, remarks);
    return remarks;
}

MapRemarks remarksOn(const unwrap::FinishInput &input, const unwrap::FinishResult &made, bool stopped)
{
    MapRemarks remarks;
    if (made.nothingFree)
        remarks.problems.push_back({Kind::NothingFree});
    else if (made.uv.rows() == 0)
        remarks.problems.push_back({Kind::MapCancelled});
    if (!remarks.problems.empty())
        return remarks;
    if (made.nothingGained)
        remarks.notes.push_back({Kind::NothingGained});
    if (made.notReplaced > 0)
        remarks.notes.push_back({Kind::NotReplaced, double(made.notReplaced)});
    if (made.noRoom)
        remarks.problems.push_back(noRoom(input.packing.keepScale));
    if (made.madeSmaller)
        remarks.problems.push_back({Kind::MadeSmaller});
    append(remarks.problems, remarksOn(made.unmet));
    if (made.heldTogether)
        remarks.problems.push_back({Kind::HeldTogether});
    if (!made.withinBound)
        remarks.problems.push_back(aboveBound(made.distortion, input.maxDistortion));
    if (stopped)
        addStraight(made.straight, remarks);
    addHeldOverlaps(input.snapshot, made.uv, remarks);
    return remarks;
}

MapRemarks remarksOn(const Snapshot &snapshot, bool keepsScale, const unwrap::SeparateResult &made)
{
    using Outcome = unwrap::SeparateResult::Outcome;
    switch (made.outcome) {
    case Outcome::Done: {
        MapRemarks remarks{{{Kind::EdgesCut, double(made.newSeams)}}, {}};
        if (made.unresolvedPairs > 0)
            remarks.problems.push_back({Kind::StaysOverlapped, double(made.unresolvedPairs)});
        addHeldOverlaps(snapshot, made.uv, remarks);
        return remarks;
    }
    case Outcome::NoOverlaps:
        return {{{Kind::NoOverlaps}}, {}};
    case Outcome::Stopped:
        return {{}, {{Kind::MapCancelled}}};
    case Outcome::NoRoom:
        return {{}, {noRoom(keepsScale)}};
    case Outcome::NothingFree:
        return {{}, {{Kind::NothingFree}}};
    }
    return {};
}

} // namespace autocuts::jobs
