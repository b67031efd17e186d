#include "views/control/live/livepacker.h"

#include "model/plain/udimtiles.h"
#include "solver/base/cutmesh.h"
#include "solver/packing/packing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace autocuts {

namespace {

//! CPU seconds for one arrangement. Chosen by hand, like the constants below; their effect has not been
//! measured.
constexpr double packEffort = 0.03;
//! A piece that has grown by more than this share gets a new place.
constexpr double growth = 0.05;
//! Share of the square that the pieces fill at first, and the factor by which the square grows until they
//! fit.
constexpr double firstFill = 0.55, widening = 1.2;
constexpr int mostWidenings = 6;

using Boxes = std::vector<Eigen::AlignedBox2d>;

CutFlags cutsOf(const MeshData &mesh, const std::vector<float> &separation)
{
    CutFlags cut(mesh.edgePairs.size());
    for (std::size_t e = 0; e < cut.size(); ++e)
        cut[e] = !mesh.edgePairs[e].diagonal && std::max(separation[2 * e], separation[2 * e + 1]) >= 0.5f;
    return cut;
}

Boxes boxesOf(const std::vector<int> &piece, std::size_t count, const UvMatrix &uv)
{
    Boxes boxes(count);
    for (std::size_t t = 0; t < piece.size(); ++t) {
        for (int k = 0; k < 3; ++k)
            boxes[piece[t]].extend(Vec2(uv.row(3 * static_cast<Eigen::Index>(t) + k).transpose()));
    }
    return boxes;
}

//! The pieces for the packer. The corners of one UV vertex are placed at their mean.
std::vector<packing::PackIsland> packIslandsOf(const MeshData &mesh, const CutMesh &state, const UvMatrix &uv)
{
    std::vector<Vec2> sum(state.uvVertexCount, Vec2::Zero());
    std::vector<int> count(state.uvVertexCount), local(state.uvVertexCount, -1);
    for (std::size_t c = 0; c < state.uvVertex.size(); ++c) {
        sum[state.uvVertex[c]] += uv.row(static_cast<Eigen::Index>(c)).transpose();
        ++count[state.uvVertex[c]];
    }
    std::vector<packing::PackIsland> islands(state.chartCount);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        packing::PackIsland &island = islands[state.chart[t]];
        std::array<int, 3> triangle;
        for (int k = 0; k < 3; ++k) {
            const int vertex = state.uvVertex[3 * t + k];
            if (local[vertex] < 0) {
                local[vertex] = static_cast<int>(island.points.size());
                island.points.push_back(sum[vertex] / count[vertex]);
            }
            triangle[k] = local[vertex];
        }
        island.triangles.push_back(triangle);
        for (int k = 0; k < 3; ++k) {
            if (state.neighbour[3 * t + k] < 0)
                island.boundary.push_back({triangle[k], triangle[(k + 1) % 3]});
        }
    }
    return islands;
}

//! False when the pieces are different ones, or one of them has grown.
bool stillFits(const LiveArrangement &arrangement, const MeshData &mesh, const CutMesh &state,
               const UvMatrix &uv)
{
    if (arrangement.piece != state.chart)
        return false;
    const Boxes boxes = boxesOf(state.chart, state.chartCount, uv);
    for (std::size_t p = 0; p < boxes.size(); ++p) {
        const Vec2 limit = (1 + growth) * arrangement.extent[p];
        if ((boxes[p].sizes().array() > limit.array()).any())
            return false;
    }
    return mesh.triangleCount() > 0;
}

//! Per piece: the tile of most of its faces. \param faceTiles empty: there are none
std::vector<int> tilesOf(const MeshData &mesh, const CutMesh &state, const std::vector<int> &faceTiles)
{
    std::vector<std::map<int, double>> areas(state.chartCount); // by tile
    for (int t = 0; t < mesh.triangleCount() && !faceTiles.empty(); ++t)
        areas[state.chart[t]][faceTiles[mesh.triangleFace[t]]] += mesh.triangleArea[t];
    std::vector<int> tiles;
    for (const auto &own : areas) {
        const auto most = std::max_element(own.begin(), own.end(),
                                           [](const auto &a, const auto &b) { return a.second < b.second; });
        tiles.push_back(most == own.end() ? 0 : most->first);
    }
    return tiles;
}

//! Arranges some pieces around a point, beside all that are locked, and locks them there.
//! \returns false when there is no room, or when stopped
bool arrangeAround(const Vec2 &middle, const std::vector<int> &pieces, const Boxes &boxes,
                   const PackingSettings &packing, std::vector<packing::PackIsland> &islands,
                   LiveArrangement &result, const std::atomic<bool> &stop)
{
    std::vector<packing::PackIsland> present;
    double area = 0;
    for (const int p : pieces) {
        present.push_back(islands[p]);
        area += boxes[p].volume();
    }
    for (const packing::PackIsland &island : islands) {
        if (island.locked)
            present.push_back(island);
    }
    packing::PackOptions settings;
    settings.textureSize = packing.textureSize;
    settings.margin = packing.margin;
    settings.rotation = PackRotation::None;
    settings.keepScale = true;
    settings.effort = packEffort;
    double side = std::max(1.0, std::sqrt(area / firstFill));
    for (int tries = 0; tries < mostWidenings && !stop; ++tries, side *= widening) {
        settings.lower = middle - Vec2::Constant(side / 2);
        settings.upper = middle + Vec2::Constant(side / 2);
        const packing::PackResult packed = packing::packIslands(present, settings, &stop);
        if (!packed.complete)
            continue;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            packing::PackIsland &island = islands[pieces[i]];
            const Vec2 &way = packed.placements[i].translation;
            for (Vec2 &point : island.points)
                point += way;
            island.locked = true;
            result.middle[pieces[i]] += way;
        }
        return true;
    }
    return false;
}

} // namespace

std::optional<LiveArrangement> LivePacker::makeArrangement(const MeshData &mesh,
                                                           const std::vector<bool> &heldFaces,
                                                           const std::vector<int> &faceTiles,
                                                           const PackingSettings &packing,
                                                           const std::vector<float> &separation,
                                                           const UvMatrix &uv, const std::atomic<bool> &stop)
{
    const CutMesh state(mesh, cutsOf(mesh, separation));
    if (state.chartCount < 2 || state.chartCount > mostPieces)
        return std::nullopt;
    LiveArrangement result;
    result.piece = state.chart;
    result.held.assign(state.chartCount, 0);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (heldFaces[mesh.triangleFace[t]])
            result.held[state.chart[t]] = 1;
    }
    const Boxes boxes = boxesOf(state.chart, state.chartCount, uv);
    for (const Eigen::AlignedBox2d &box : boxes)
        result.extent.push_back(box.sizes());
    std::vector<packing::PackIsland> islands = packIslandsOf(mesh, state, uv);
    const std::vector<int> tiles = tilesOf(mesh, state, faceTiles);
    for (int p = 0; p < state.chartCount; ++p) {
        islands[p].locked = result.held[p] != 0;
        result.middle.push_back(boxes[p].center());
    }
    for (const int tile : std::set<int>(tiles.begin(), tiles.end())) {
        std::vector<int> pieces;
        for (int p = 0; p < state.chartCount; ++p) {
            if (tiles[p] == tile && result.held[p] == 0)
                pieces.push_back(p);
        }
        const int number = tile > 0 ? tile : PackingSettings::firstTile;
        if (!pieces.empty() && !arrangeAround(udimTile(number, packing.tileHeight()).center(), pieces, boxes,
                                              packing, islands, result, stop))
            return std::nullopt;
    }
    return result;
}

LivePacker::LivePacker(QObject *parent) : QObject(parent)
{
    mSince.start();
}

void LivePacker::reset()
{
    mJobs.abandon();
    mArrangement.reset();
}

void LivePacker::arrange(const Document &document, const std::vector<float> &separation, UvMatrix &uv)
{
    const std::shared_ptr<const MeshData> &mesh = document.weightedMesh();
    const Constraints &constraints = document.constraints();
    const PackingSettings &packing = document.packingSettings();
    if (!mJobs.isBusy() && (!mArrangement || mSince.elapsed() >= packInterval)) {
        mSince.restart();
        std::vector<bool> held(mesh->faceCount());
        const MeshData &data = *mesh;
        for (const UvPin &pin : constraints.pins) {
            const auto next = std::upper_bound(data.faceStart.begin(), data.faceStart.end(), pin.corner);
            held[next - data.faceStart.begin() - 1] = true;
        }
        for (const LayoutRectangle &rectangle : constraints.rectangles) {
            for (int face : rectangle.faces)
                held[face] = true;
        }
        mJobs.start(
            tr("Packing"),
            [=, last = mArrangement, place = uv,
             map = document.uv()](JobControl &control) -> std::optional<LiveArrangement> {
                if (last && stillFits(*last, *mesh, CutMesh(*mesh, cutsOf(*mesh, separation)), place))
                    return last;
                const std::vector<int> tiles = packing.udimTile == PackingSettings::firstTile
                                                   ? udimTiles(*mesh, map, packing.tileHeight())
                                                   : std::vector<int>();
                return makeArrangement(*mesh, held, tiles, packing, separation, place, control.stop());
            },
            [this](std::optional<LiveArrangement> made) {
                if (made == mArrangement)
                    return;
                mArrangement = std::move(made);
                Q_EMIT arranged();
            });
    }
    if (!mArrangement || mArrangement->piece.size() * 3 != static_cast<std::size_t>(uv.rows()))
        return;
    const Boxes boxes = boxesOf(mArrangement->piece, mArrangement->middle.size(), uv);
    for (std::size_t t = 0; t < mArrangement->piece.size(); ++t) {
        const int piece = mArrangement->piece[t];
        if (mArrangement->held[piece])
            continue;
        const Vec2 move = mArrangement->middle[piece] - boxes[piece].center();
        uv.middleRows(3 * static_cast<Eigen::Index>(t), 3).rowwise() += move.transpose();
    }
}

} // namespace autocuts
