#include "solver/unwrap/freepart.h"

#include "model/plain/udimtiles.h"
#include "model/plain/unionfind.h"
#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "solver/base/seamedmap.h"
#include "solver/metrics/uvmetrics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::unwrap {

namespace {

// Numbers in this file without another source were chosen by hand.

bool isFree(const IslandFlags &flags)
{
    return flags.locked == 0 && flags.stack == 0 && flags.group == 0;
}

constexpr double leastBound = 4.0001;   // that a search may be given
constexpr double sameDistortion = 1e-9; // what a map may differ by that is measured again
constexpr double atPin = 1e-7;          // distance from a pin, in texture space, of a corner that is at it

//! Per face: true when hard pins hold all its corners, where the map has them. Empty when there is no map.
std::vector<bool> pinnedFaces(const Snapshot &snapshot)
{
    if (!snapshot.uv)
        return {};
    const MeshData &mesh = *snapshot.mesh;
    std::vector<char> atRest(mesh.soupCornerCount(), 0);
    for (const Pin &pin : snapshot.steering->pins) {
        const Vec2 uv = snapshot.uv->row(mesh.cornerOfSoup(pin.soupCorner)).transpose();
        atRest[pin.soupCorner] = pin.hard && (snapshot.uvScale * pin.target - uv).norm() <= atPin;
    }
    std::vector<bool> pinned(mesh.faceCount());
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const auto corners = mesh.soupCornersOf(face);
        pinned[face] = std::all_of(corners.begin(), corners.end(), [&](int c) { return atRest[c] != 0; });
    }
    return pinned;
}

//! Per face: true when a job may change it. \param pinned see pinnedFaces()
std::vector<bool> freeFaces(const Snapshot &snapshot, const std::vector<bool> &pinned)
{
    std::vector<bool> faces(snapshot.mesh->faceCount(), true);
    if (snapshot.scope)
        faces = snapshot.scope->faces;
    if (!snapshot.uv)
        return faces;
    const std::vector<IslandFlags> &flags = snapshot.steering->faceFlags;
    if (std::all_of(flags.begin(), flags.end(), isFree) && std::ranges::count(pinned, true) == 0)
        return faces;
    for (const std::vector<int> &island : findCharts(*snapshot.mesh, *snapshot.uv).faces()) {
        if (isFree(flagsOf(flags, island)) &&
            !std::ranges::all_of(island, [&](int face) { return pinned[face]; }))
            continue;
        for (const int face : island)
            faces[face] = false;
    }
    return faces;
}

//! The snapshot of a job on the whole mesh.
Snapshot withoutBounds(const Snapshot &whole)
{
    Snapshot snapshot = whole;
    snapshot.scope = nullptr;
    if (!whole.steering->faceFlags.empty())
        snapshot.editSteering().faceFlags.clear();
    return snapshot;
}

//! True when the same faces may change.
bool sameBounds(const Snapshot &a, const Snapshot &b)
{
    return a.mesh == b.mesh && a.scope == b.scope && a.token.sameMap(b.token) && !a.uv == !b.uv &&
           a.steering->faceFlags == b.steering->faceFlags;
}

} // namespace

std::optional<FreePart> FreePart::of(const Snapshot &snapshot, const FreePart *previous)
{
    FreePart part;
    part.mPinned = pinnedFaces(snapshot);
    const bool same = previous && sameBounds(previous->mWhole, snapshot) && part.mPinned == previous->mPinned;
    const std::vector<bool> faces = same ? previous->mFaces : freeFaces(snapshot, part.mPinned);
    part.mFaces = faces;
    part.mWhole = snapshot;
    part.mSnapshot = withoutBounds(snapshot);
    if (std::find(faces.begin(), faces.end(), true) == faces.end())
        return std::nullopt;
    if (std::find(faces.begin(), faces.end(), false) != faces.end()) {
        part.mPart = same ? previous->mPart : partOf(*snapshot.mesh, faces);
        if (!(part.mPart.mesh->area > 0))
            return std::nullopt;
        part.mUnit = std::sqrt(snapshot.mesh->area / part.mPart.mesh->area);
        part.mSnapshot.mesh = part.mPart.mesh;
        part.mSnapshot.uvScale = snapshot.uvScale / part.mUnit;
        part.addSteering(snapshot);
        part.addBorders(snapshot, faces);
        part.addObstacles(snapshot, faces);
        if (same) {
            part.mDistortionBefore = previous->mDistortionBefore;
            part.mDistortionOfRest = previous->mDistortionOfRest;
        } else if (snapshot.uv) {
            part.measureBefore();
        }
    }
    part.cutImpliedSeams();
    part.decideGivenSeams();
    return part;
}

bool FreePart::hasOtherSizes(const FreePart &other) const
{
    const MeshData &own = *mSnapshot.mesh, &before = *other.mSnapshot.mesh;
    return own.texelWeight != before.texelWeight && samePolygons(own, before);
}

Snapshot FreePart::withoutRectangles() const
{
    Snapshot snapshot = mSnapshot;
    if (!snapshot.steering->rectangles.empty())
        snapshot.editSteering().rectangles.clear();
    return snapshot;
}

void FreePart::addSteering(const Snapshot &whole)
{
    const Steering &from = *whole.steering;
    auto steering = std::make_shared<Steering>();
    for (const int e : mPart.edgePair) {
        for (int end = 0; end < 2; ++end) {
            if (!from.pairState.empty())
                steering->pairState.push_back(from.pairState[2 * e + end]);
            if (!from.pairWeight.empty())
                steering->pairWeight.push_back(from.pairWeight[2 * e + end]);
        }
        if (!from.givenSeams.empty())
            steering->givenSeams.push_back(from.givenSeams[e]);
    }
    std::vector<int> inPart(whole.mesh->soupCornerCount(), -1);
    for (int c = 0; c < mPart.mesh->soupCornerCount(); ++c)
        inPart[mPart.soupCornerOf(c)] = c;
    for (Pin pin : from.pins) {
        pin.soupCorner = inPart[pin.soupCorner];
        pin.target *= mUnit;
        if (pin.soupCorner >= 0)
            steering->pins.push_back(pin);
    }
    for (UvRectangle box : from.rectangles) {
        box.lower *= mUnit;
        box.upper *= mUnit;
        for (int &corner : box.soupCorners)
            corner = inPart[corner];
        std::erase(box.soupCorners, -1);
        if (!box.soupCorners.empty())
            steering->rectangles.push_back(std::move(box));
    }
    std::vector<int> edgeInPart(whole.mesh->edgePairs.size(), -1);
    for (std::size_t e = 0; e < mPart.edgePair.size(); ++e)
        edgeInPart[mPart.edgePair[e]] = static_cast<int>(e);
    for (std::vector<int> loop : from.straightLoops) {
        for (int &edge : loop)
            edge = edgeInPart[edge];
        std::erase(loop, -1);
        steering->straightLoops.push_back(std::move(loop));
    }
    mSnapshot.steering = std::move(steering);
    if (whole.startUv)
        mSnapshot.startUv = std::make_shared<const UvMatrix>(mUnit * partRows(*whole.startUv));
    if (whole.uv)
        mSnapshot.uv = std::make_shared<const UvMatrix>(partUv(*whole.uv));
}

//! Pins the corners of the part that share a UV vertex with a face outside of it.
void FreePart::addBorders(const Snapshot &whole, const std::vector<bool> &faces)
{
    if (!whole.uv || !whole.scope || !whole.scope->attached)
        return;
    const MeshData &mesh = *whole.mesh;
    const UvTopology topology = findUvTopology(mesh, *whole.uv);
    std::vector<int> outsideFace(mesh.cornerCount(), -1); // per UV vertex, given by its root
    for (int face = 0; face < mesh.faceCount(); ++face) {
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
            if (!faces[face] && topology.faceHasUv[face])
                outsideFace[topology.cornerRoot[c]] = face;
        }
    }
    Steering &steering = mSnapshot.editSteering();
    std::vector<bool> attached(mPart.corner.size(), false);
    for (int face = 0; face < mPart.mesh->faceCount(); ++face) {
        for (int c = mPart.mesh->faceStart[face]; c < mPart.mesh->faceStart[face + 1]; ++c) {
            const int corner = mPart.corner[c];
            const int outside = outsideFace[topology.cornerRoot[corner]];
            attached[c] = outside >= 0 && whole.uv->row(corner).allFinite();
            if (attached[c])
                mAttached.push_back({c, face, outside});
        }
    }
    std::erase_if(steering.pins, [&](const Pin &pin) {
        return attached[mPart.mesh->cornerOfSoup(pin.soupCorner)]; // the border is law
    });
    for (int s = 0; s < mPart.mesh->soupCornerCount(); ++s) {
        const int corner = mPart.mesh->cornerOfSoup(s);
        if (attached[corner])
            steering.pins.push_back(
                {s, whole.uv->row(mPart.corner[corner]).transpose() / mSnapshot.uvScale, true, 1});
    }
}

//! Everything outside of the part that packing may not move either.
void FreePart::addObstacles(const Snapshot &whole, const std::vector<bool> &faces)
{
    if (!whole.uv)
        return;
    const MeshData &mesh = *whole.mesh;
    std::vector<bool> stays(mesh.faceCount(), false);
    const std::vector<IslandFlags> &flags = whole.steering->faceFlags;
    for (const std::vector<int> &island : findCharts(mesh, *whole.uv).faces()) {
        const bool locked = !flags.empty() && flagsOf(flags, island).locked != 0;
        for (const int face : island)
            stays[face] = !faces[face] && (locked || (whole.scope && !whole.scope->faces[face]));
    }
    const double scale = 1 / mSnapshot.uvScale;
    std::vector<Obstacle> obstacles;
    std::vector<int> obstacleOf(mesh.triangleCount(), -1);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (!stays[mesh.triangleFace[t]])
            continue;
        Obstacle obstacle;
        for (int k = 0; k < 3; ++k)
            obstacle.corner[k] = scale * Vec2(whole.uv->row(mesh.triangles[t][k]));
        obstacle.isOpen = {true, true, true};
        if (!(cross2(obstacle.corner[0], obstacle.corner[1], obstacle.corner[2]) > 0))
            continue; // turned over: not a place that a map could fill
        obstacleOf[t] = static_cast<int>(obstacles.size());
        obstacles.push_back(obstacle);
    }
    const std::vector<bool> open = openCornerPairs(mesh, *whole.uv);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const int a = obstacleOf[pair.triangle[0]], b = obstacleOf[pair.triangle[1]];
        if (a >= 0 && b >= 0 && !open[2 * e] && !open[2 * e + 1])
            obstacles[a].isOpen[pair.side(0)] = obstacles[b].isOpen[pair.side(1)] = false;
    }
    // Whatever reaches the inner triangles has to cross the others.
    std::erase_if(obstacles, [](const Obstacle &o) { return !o.isOpen[0] && !o.isOpen[1] && !o.isOpen[2]; });
    if (!obstacles.empty())
        mSnapshot.obstacles = std::make_shared<const std::vector<Obstacle>>(std::move(obstacles));
}

double FreePart::seamLengthOfRest() const
{
    const MeshData &mesh = *mWhole.mesh;
    if (isWhole() || !mWhole.uv)
        return 0;
    const std::vector<bool> open = openCornerPairs(mesh, *mWhole.uv);
    double length = 0;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const auto [a, b] = mesh.edgePairs[e].triangle;
        const bool changes = mFaces[mesh.triangleFace[a]] && mFaces[mesh.triangleFace[b]];
        length += !changes && (open[2 * e] || open[2 * e + 1]) ? mesh.edgePairs[e].length : 0;
    }
    return length / std::sqrt(mesh.area / std::numbers::pi) + windingSeamLength(mesh) -
           windingSeamLength(*mPart.mesh) / mUnit;
}

void FreePart::measureBefore()
{
    const UvMatrix &uv = *mWhole.uv;
    mDistortionBefore = metrics::measureShapes(*mWhole.mesh, uv, mWhole.tileHeight).tileDirichlet;
    std::vector<bool> stays = mFaces;
    stays.flip();
    const MeshPart rest = partOf(*mWhole.mesh, stays);
    UvMatrix restUv(rest.mesh->cornerCount(), 2);
    for (int c = 0; c < rest.mesh->cornerCount(); ++c)
        restUv.row(c) = uv.row(rest.corner[c]);
    mDistortionOfRest = metrics::measureShapes(*rest.mesh, restUv, mWhole.tileHeight).tileDirichlet;
}

double FreePart::boundBeside(double maxDistortion) const
{
    if (!(mDistortionBefore <= maxDistortion + sameDistortion) || !(mDistortionOfRest > maxDistortion))
        return maxDistortion;
    const double area = mPart.mesh->area, rest = mWhole.mesh->area - area;
    return std::max(maxDistortion - rest / area * (mDistortionOfRest - maxDistortion), leastBound);
}

double FreePart::boundOf(double maxDistortion, double before) const
{
    return mDistortionBefore <= maxDistortion + sameDistortion
               ? std::max(maxDistortion, before + sameDistortion)
               : maxDistortion;
}

//! Cuts the edges between faces of different rectangles or UDIM tiles, unless the user joined them.
void FreePart::cutImpliedSeams()
{
    const MeshData &mesh = *mSnapshot.mesh;
    std::vector<std::vector<int>> places(mesh.faceCount()); // tile and rectangles of each face
    if (mWhole.keepTiles && mWhole.uv) {
        const std::vector<int> tiles = udimTiles(*mWhole.mesh, *mWhole.uv, mWhole.tileHeight);
        for (int face = 0; face < mesh.faceCount(); ++face)
            places[face].push_back(-tiles[isWhole() ? face : mPart.face[face]]);
    }
    const std::vector<UvRectangle> &boxes = mSnapshot.steering->rectangles;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (const int corner : boxes[i].soupCorners) {
            std::vector<int> &place = places[mesh.triangleFace[corner / 3]];
            if (place.empty() || place.back() != static_cast<int>(i))
                place.push_back(static_cast<int>(i));
        }
    }
    std::vector<std::size_t> implied;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const auto [a, b] = mesh.edgePairs[e].triangle;
        if (places[mesh.triangleFace[a]] != places[mesh.triangleFace[b]] && !mSnapshot.isJoined(e))
            implied.push_back(e);
    }
    if (implied.empty())
        return;
    std::vector<PairState> &states = mSnapshot.editSteering().pairState;
    states.resize(mesh.cornerPairCount(), PairState::Free);
    for (const std::size_t e : implied)
        states[2 * e] = states[2 * e + 1] = PairState::Cut;
}

//! Makes given seams cuts and, where only these may be seams, all other edges joins.
void FreePart::decideGivenSeams()
{
    const SeamMode mode = mSnapshot.settings.seams;
    if (mode == SeamMode::Free)
        return;
    const MeshData &mesh = *mSnapshot.mesh;
    Steering &steering = mSnapshot.editSteering();
    steering.pairState.resize(mesh.cornerPairCount(), PairState::Free);
    for (std::size_t p = 0; p < steering.pairState.size(); ++p) {
        PairState &state = steering.pairState[p];
        if (state != PairState::Free || mesh.edgePairs[p / 2].diagonal)
            continue;
        if (!steering.givenSeams.empty() && steering.givenSeams[p / 2])
            state = PairState::Cut;
        else if (mode == SeamMode::Only)
            state = PairState::Joined;
    }
}

UvMatrix FreePart::wholeUv(const UvMatrix &uv) const
{
    if (isWhole())
        return uv;
    UvMatrix whole = mWhole.uv ? *mWhole.uv : emptyLayout(*mWhole.mesh);
    for (std::size_t c = 0; c < mPart.corner.size(); ++c)
        whole.row(mPart.corner[c]) = uv.row(static_cast<Eigen::Index>(c));
    for (const Attachment &attached : mAttached)
        whole.row(mPart.corner[attached.corner]) = mWhole.uv->row(mPart.corner[attached.corner]);
    return whole;
}

UvMatrix FreePart::partUv(const UvMatrix &whole) const
{
    if (isWhole())
        return whole;
    UvMatrix uv(mPart.mesh->cornerCount(), 2);
    for (std::size_t c = 0; c < mPart.corner.size(); ++c)
        uv.row(static_cast<Eigen::Index>(c)) = whole.row(mPart.corner[c]);
    return uv;
}

std::vector<bool> FreePart::wholeCut(const std::vector<bool> &cut) const
{
    if (isWhole())
        return cut;
    const MeshData &mesh = *mWhole.mesh;
    const std::vector<bool> open = openCornerPairs(mesh, mWhole.uv ? *mWhole.uv : emptyLayout(mesh));
    std::vector<bool> whole(mesh.edgePairs.size());
    for (std::size_t e = 0; e < whole.size(); ++e)
        whole[e] = open[2 * e] || open[2 * e + 1];
    for (std::size_t e = 0; e < cut.size(); ++e)
        whole[mPart.edgePair[e]] = cut[e];
    return whole;
}

ChartMap FreePart::wholeCharts(const ChartMap &charts) const
{
    if (isWhole())
        return charts;
    ChartMap whole{std::vector<int>(mWhole.mesh->faceCount(), -1), 0};
    if (mWhole.uv)
        whole = findCharts(*mWhole.mesh, *mWhole.uv);
    const int before = whole.count;
    for (std::size_t f = 0; f < mPart.face.size(); ++f)
        whole.faceChart[mPart.face[f]] = before + charts.faceChart[f];
    UnionFind united(before + charts.count);
    for (const Attachment &attached : mAttached)
        united.unite(before + charts.faceChart[attached.face], whole.faceChart[attached.outsideFace]);
    // Charts that lay wholly inside the part are gone: the others are numbered again.
    const std::vector<int> label = united.labels().first;
    std::vector<int> number(label.size(), -1);
    whole.count = 0;
    for (int &chart : whole.faceChart) {
        if (chart < 0)
            continue;
        int &n = number[label[chart]];
        if (n < 0)
            n = whole.count++;
        chart = n;
    }
    return whole;
}

int FreePart::wholeSoupCorner(int soupCorner) const
{
    return isWhole() ? soupCorner : mPart.soupCornerOf(soupCorner);
}

UvMatrix FreePart::partRows(const UvMatrix &soupRows) const
{
    if (isWhole())
        return soupRows;
    UvMatrix rows(mPart.mesh->soupCornerCount(), 2);
    for (int c = 0; c < mPart.mesh->soupCornerCount(); ++c)
        rows.row(c) = soupRows.row(mPart.soupCornerOf(c));
    return rows;
}

UvMatrix FreePart::wholeRows(const UvMatrix &rows) const
{
    if (isWhole())
        return rows;
    UvMatrix whole =
        soupUv(*mWhole.mesh, mWhole.uv ? *mWhole.uv : emptyLayout(*mWhole.mesh)) / mWhole.uvScale;
    for (int c = 0; c < mPart.mesh->soupCornerCount(); ++c)
        whole.row(mPart.soupCornerOf(c)) = rows.row(c) / mUnit;
    return whole;
}

std::vector<float> FreePart::wholePairs(const std::vector<float> &pairs) const
{
    if (isWhole())
        return pairs;
    const std::vector<bool> open =
        openCornerPairs(*mWhole.mesh, mWhole.uv ? *mWhole.uv : emptyLayout(*mWhole.mesh));
    std::vector<float> whole(open.begin(), open.end());
    for (std::size_t e = 0; e < mPart.edgePair.size(); ++e) {
        for (int end = 0; end < 2; ++end)
            whole[2 * mPart.edgePair[e] + end] = pairs[2 * e + end];
    }
    return whole;
}

} // namespace autocuts::unwrap
