#include "solver/unwrap/liveplacing.h"

#include "model/plain/uvlayout.h"
#include "solver/definite/seamopening.h"
#include "solver/unwrap/keptscale.h"
#include "solver/unwrap/oldplaces.h"

#include <algorithm>
#include <cmath>

namespace autocuts::unwrap {

namespace {

double areaOf(const MeshData &mesh, const UvMatrix &uv)
{
    double area = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const auto &[a, b, c] = mesh.triangles[t];
        area += 0.5 * cross2(Vec2(uv.row(a)), Vec2(uv.row(b)), Vec2(uv.row(c)));
    }
    return area;
}

//! Makes islands larger whose rectangles have become much larger than they are.
void growIntoRectangles(const MeshData &mesh, const ChartMap &charts, PackJob pack, UvMatrix &uv)
{
    constexpr double leastGain = 1.1; // of the area; less is not worth that islands move
    pack.fillRectangles = true;
    UvMatrix larger = uv;
    if (packCharts(mesh, charts, pack, larger) && areaOf(mesh, larger) > leastGain * areaOf(mesh, uv))
        uv = std::move(larger);
}

//! Packs islands that are not where they belong. The others stay as long as these find room, with a smaller
//! margin if need be: while a solve runs, islands that jump are worse than a small margin, and none is worse
//! than these.
//! \param gap that islands keep; afterwards, that for which there was room
bool packMisplacedCalmly(const MeshData &mesh, const ChartMap &charts, PackJob pack, UvMatrix &uv,
                         double &gap)
{
    const double smallest = pack.gap / 4;
    for (; pack.gap > 0 && pack.gap >= smallest; pack.gap /= 2) {
        if (packOnlyMisplaced(mesh, charts, pack, uv)) {
            gap = pack.gap;
            return true;
        }
    }
    pack.gap = smallest;
    return packMisplaced(mesh, charts, pack, uv);
}

} // namespace

void LivePlacing::beginWith(const FreePart &part)
{
    mBefore.reset();
    if (part.snapshot().uv)
        mBefore = takenFrom(part, *part.snapshot().uv);
    mBegun = mBefore;
}

void LivePlacing::reset()
{
    mBefore.reset();
    mBegun.reset();
    mPutByHand.clear();
    mBeforeDrag.clear();
    mDrags = false;
    mGap.reset();
}

void LivePlacing::returnTo(const FreePart &part, const UvMatrix &uv)
{
    mPutByHand = mBeforeDrag;
    mDrags = false;
    mBefore = takenFrom(part, uv);
}

LivePlacing::Before LivePlacing::takenFrom(const FreePart &part, const UvMatrix &uv)
{
    const Snapshot &own = part.snapshot();
    ChartMap charts = findCharts(*own.mesh, uv);
    const double scale = own.placesIslands() ? own.uvScale : layoutScale(*own.mesh, uv);
    std::vector<double> scales = faceScales(*own.mesh, charts, uv, scale, own.tileHeight);
    return {own.mesh, uv, std::move(charts), std::move(scales)};
}

namespace {

//! Per face: length in texture space of one solver unit, from the areas of its chart. The shape counts as if
//! it had the area of the model.
std::vector<double> scalesOf(const MeshData &mesh, const ChartMap &charts, const UvMatrix &shape,
                             const UvMatrix &placed)
{
    std::vector<double> inShape(charts.count, 0), inTexture(charts.count, 0);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int chart = charts.faceChart[mesh.triangleFace[t]];
        if (chart < 0)
            continue;
        const auto &corners = mesh.triangles[t];
        const auto area = [&](const UvMatrix &uv) {
            return cross2(Vec2(uv.row(corners[0])), Vec2(uv.row(corners[1])), Vec2(uv.row(corners[2])));
        };
        inShape[chart] += area(shape);
        inTexture[chart] += area(placed);
    }
    const double unit = layoutScale(mesh, shape);
    std::vector<double> scales;
    for (const int chart : charts.faceChart) // without area, not a number
        scales.push_back(chart < 0 ? std::nan("") : unit * std::sqrt(inTexture[chart] / inShape[chart]));
    return scales;
}

} // namespace

//! Notes which islands the user drags. \param charts of the whole map
void LivePlacing::noteDrags(const MeshData &mesh, const ChartMap &charts, const std::vector<int> &corners)
{
    std::vector<bool> dragged(charts.count, false);
    const bool drags = !corners.empty();
    for (const int corner : corners) {
        if (const int chart = charts.faceChart[mesh.triangleFace[corner / 3]]; chart >= 0)
            dragged[chart] = true;
    }
    if (drags && !mDrags)
        mBeforeDrag = mPutByHand;
    mDrags = drags;
    if (drags)
        mPutByHand.resize(charts.faceChart.size());
    for (std::size_t face = 0; drags && face < mPutByHand.size(); ++face) {
        if (const int chart = charts.faceChart[face]; chart >= 0 && dragged[chart])
            mPutByHand[face] = true;
    }
}

UvMatrix LivePlacing::place(const Snapshot &snapshot, const FreePart &part, const Soup &soup,
                            const SeamedMap &map, const packing::PackOptions &options, bool afresh,
                            const std::vector<int> &dragged, PackRotation turns)
{
    const Snapshot own = part.withoutRectangles();
    // True when some islands are where they belong, so that the scale is given.
    const bool stays = !part.isWhole() || snapshot.placesIslands();
    if (afresh && !stays) {
        mBefore.reset();
        mBegun.reset();
    } else if (!mBefore || !samePolygons(*mBefore->mesh, *own.mesh)) {
        beginWith(part);
        mGap.reset();
    }
    const MeshData &mesh = *own.mesh;
    const CutMesh state(mesh, map.cut);
    const ChartMap charts = chartsOf(mesh, state);
    UvMatrix shape = cornerUv(soup, map);
    definite::openCuts(own, shape);
    PackJob pack = steeredPackJob(snapshot, options);
    pack.options.effort = std::min(pack.options.effort, packing::hurriedEffort);
    pack.options.keepScale = false;
    pack.keepScaleIfPossible = stays || mBefore;
    pack.hurry = PackHurry::WhenStopped;
    if (const double margin = marginGap(options); !mGap || mMargin != margin) {
        mMargin = margin;
        mGap = mBegun ? keptGap(*snapshot.mesh, pack, *snapshot.uv) : margin;
    }
    noteDrags(*snapshot.mesh, part.wholeCharts(charts), dragged);
    for (std::size_t face = 0; face < mPutByHand.size(); ++face)
        pack.stays[face] = pack.stays[face] || mPutByHand[face];
    // Once the user has put islands somewhere, they are as near to each other as it comes.
    pack.gap = std::ranges::find(mPutByHand, true) == mPutByHand.end() ? *mGap : 0;
    mHadRoom = true;
    mShrank = false;
    const std::vector<bool> held = heldCharts(own, state);
    std::vector<double> given;
    UvMatrix uv;
    if (mBefore) {
        pack.density = packing::DensityBasis::Given;
        given = chartScales(mesh, charts, mBefore->scale, own.uvScale);
        uv = placeAgain(snapshot, part, charts, shape, pack, turns, held);
    } else {
        uv = part.wholeUv((stays ? own.uvScale : 1) * shape);
        mHadRoom = packCharts(*snapshot.mesh, part.wholeCharts(charts), pack, uv);
    }
    UvMatrix partUv = part.partUv(uv);
    std::vector<double> scales = scalesOf(mesh, charts, shape, partUv);
    // What pins hold gets its scale back when they let go.
    for (std::size_t face = 0; face < scales.size() && !held.empty() && !given.empty(); ++face) {
        if (const int chart = charts.faceChart[face]; chart >= 0 && held[chart])
            scales[face] = given[chart];
    }
    mBefore = Before{own.mesh, std::move(partUv), charts, std::move(scales)};
    return uv;
}

//! The whole map with the charts where those of another map were, at the scales that these had.
//! \param shape per corner, solver units
UvMatrix LivePlacing::placedBy(const Before &before, const FreePart &part, const ChartMap &charts,
                               const UvMatrix &shape, PackRotation turns, const std::vector<bool> &held) const
{
    const MeshData &mesh = *part.snapshot().mesh;
    const double unit = layoutScale(mesh, shape); // 1 where it has the area of the model
    std::vector<double> scales = chartScales(mesh, charts, before.scale, part.snapshot().uvScale);
    for (std::size_t chart = 0; chart < scales.size(); ++chart)
        scales[chart] = !held.empty() && held[chart] ? part.snapshot().uvScale : scales[chart] / unit;
    UvMatrix scaled = shape;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        for (int c = mesh.faceStart[face]; charts.faceChart[face] >= 0 && c < mesh.faceStart[face + 1]; ++c)
            scaled.row(c) *= scales[charts.faceChart[face]];
    }
    return part.wholeUv(atOldPlaces(mesh, charts, held, {before.uv, before.charts}, turns, scaled));
}

//! Places a map in relation to the ones before: as at the beginning where all fits there, else as last.
//! \param shape per corner, solver units
UvMatrix LivePlacing::placeAgain(const Snapshot &snapshot, const FreePart &part, const ChartMap &charts,
                                 const UvMatrix &shape, const PackJob &pack, PackRotation turns,
                                 const std::vector<bool> &held)
{
    const ChartMap whole = part.wholeCharts(charts);
    const bool byHand = std::ranges::find(mPutByHand, true) != mPutByHand.end();
    if (mBegun && !byHand && !onlyRectangles(pack) && samePolygons(*mBegun->mesh, *part.snapshot().mesh)) {
        UvMatrix uv = placedBy(*mBegun, part, charts, shape, turns, held);
        if (liesFree(*snapshot.mesh, whole, pack, uv))
            return uv;
    }
    UvMatrix uv = placedBy(*mBefore, part, charts, shape, turns, held);
    const double size = layoutScale(*snapshot.mesh, uv);
    if (onlyRectangles(pack) && liesFree(*snapshot.mesh, whole, pack, uv))
        growIntoRectangles(*snapshot.mesh, whole, pack, uv);
    else
        mHadRoom = packMisplacedCalmly(*snapshot.mesh, whole, pack, uv, *mGap);
    const bool hasTiles = std::ranges::any_of(pack.tiles, [](int tile) { return tile > 0; });
    const bool sizeIsGiven = hasTiles || snapshot.placesIslands() || !part.isWhole();
    mShrank = sizeIsGiven && isSmaller(*snapshot.mesh, uv, size);
    return uv;
}

} // namespace autocuts::unwrap
