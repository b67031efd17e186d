#include "solver/bake/carrying.h"

#include "model/plain/parallel.h"
#include "model/plain/sharpsampling.h"
#include "model/plain/udimtiles.h"
#include "solver/bake/dilation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace autocuts::bake {

namespace {

//! The area of a triangle in the map, in tiles; not finite without UVs.
double mapArea(const ShadedSurface &surface, int triangle)
{
    const auto &corners = surface.mesh->triangles[triangle];
    const Vec2 a = surface.uv.row(corners[0]), b = surface.uv.row(corners[1]), c = surface.uv.row(corners[2]);
    return std::abs(cross2(a, b, c)) / 2 / surface.tileHeight;
}

//! The sum of the areas of the faces that have UVs. \param faces empty: all
double mapArea(const ShadedSurface &surface, const std::vector<bool> &faces)
{
    double sum = 0;
    for (int t = 0; t < surface.mesh->triangleCount(); ++t) {
        const double area = mapArea(surface, t);
        if (std::isfinite(area) && (faces.empty() || faces[surface.mesh->triangleFace[t]]))
            sum += area;
    }
    return sum;
}

double pixels(const TiledPicture &picture)
{
    double most = picture.repeated ? double(picture.repeated->width) * picture.repeated->height : 0;
    for (const auto &[tile, one] : picture.tiles)
        most = std::max(most, double(one->width) * one->height);
    return most;
}

//! Per triangle of the source: the side of a new texel in old ones.
std::vector<float> stretches(const CarryModel &model, const CarryTexture &texture)
{
    const double before = pixels(texture.picture), after = double(texture.width) * texture.height;
    const auto stretch = [&](double areaBefore, double areaAfter) {
        const double side = std::sqrt(areaBefore * before / (areaAfter * after));
        return std::isfinite(side) ? static_cast<float>(side) : 1.0F;
    };
    const int triangles = model.source.mesh->triangleCount();
    if (!model.sameTriangles)
        return std::vector<float>(std::size_t(triangles),
                                  stretch(mapArea(model.source, {}), mapArea(model.low, texture.faces)));
    std::vector<float> result;
    for (int t = 0; t < triangles; ++t)
        result.push_back(stretch(mapArea(model.source, t), mapArea(model.low, t)));
    return result;
}

//! The map without the faces for which `wanted` is false.
UvMatrix onlyFaces(const ShadedSurface &surface,
                   const std::function<bool(int start, int count, int face)> &wanted)
{
    const MeshData &mesh = *surface.mesh;
    UvMatrix uv = surface.uv;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int start = mesh.faceStart[f], count = mesh.faceStart[f + 1] - start;
        if (!wanted(start, count, f))
            uv.middleRows(start, count).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return uv;
}

//! Marks the texels of a tile whose middles lie in islands.
void markInside(const MeshData &mesh, const UvMatrix &uv, const TexelGrid &grid,
                std::vector<std::uint8_t> &inside, const JobContext &context)
{
    const TexelSurface texels(mesh, uv, grid);
    if (texels.isEmpty())
        return;
    parallelFor(texels.bandCount(), context.threads(), [&](int band) {
        if (context.stopped())
            return;
        TexelRows rows;
        texels.makeBand(band, rows);
        for (std::size_t i = 0; i < rows.inside.size(); ++i) {
            if (rows.inside[i])
                inside[std::size_t(rows.first) * grid.width + i] = 1;
        }
    });
}

//! The mean difference of neighbouring texels.
struct Jumps
{
    double sum = 0;
    long long count = 0;

    void add(std::span<const float> a, std::span<const float> b)
    {
        for (std::size_t k = 0; k < std::min<std::size_t>(3, a.size()); ++k) {
            if (std::isfinite(a[k] - b[k]))
                sum += std::abs(a[k] - b[k]);
        }
        ++count;
    }
    double mean() const { return count > 0 ? sum / double(count) : 0; }
};

//! True when the values jump at the borders of islands as they do nowhere inside: they have no margin.
bool hasNoMargin(const Picture &picture, const std::vector<std::uint8_t> &inside, const JobContext &context)
{
    Jumps within, across;
    const auto compare = [&](int x, int y, int right, int down) {
        if (right >= picture.width || down >= picture.height)
            return;
        const int both =
            inside[std::size_t(y) * picture.width + x] + inside[std::size_t(down) * picture.width + right];
        if (both > 0)
            (both == 2 ? within : across).add(picture.at(x, y), picture.at(right, down));
    };
    for (int y = 0; y < picture.height && !context.stopped(); ++y) {
        for (int x = 0; x < picture.width; ++x) {
            compare(x, y, x + 1, y);
            compare(x, y, x, y + 1);
        }
    }
    // Chosen by hand: borders of well filled islands are about as rough as their insides.
    constexpr double rougher = 3, rounding = 2.0 / 255;
    return across.mean() > rougher * within.mean() + rounding;
}

//! A picture whose texels beside islands have the nearest value of an island, so that samples near borders
//! see nothing of the gaps; the same picture where its islands have margins. \param tiles that show the
//! picture
std::shared_ptr<const Picture> filledBeside(const std::shared_ptr<const Picture> &picture,
                                            const MeshData &mesh, const UvMatrix &uv,
                                            const std::vector<Eigen::AlignedBox2d> &tiles,
                                            const JobContext &context)
{
    std::vector<std::uint8_t> inside(std::size_t(picture->width) * picture->height, 0);
    for (const Eigen::AlignedBox2d &tile : tiles)
        markInside(mesh, uv, {picture->width, picture->height, tile, 1}, inside, context);
    if (!hasNoMargin(*picture, inside, context))
        return picture;
    auto filled = std::make_shared<Picture>(*picture);
    dilate(*filled, inside, static_cast<int>(4 * mostStretch), context);
    return filled;
}

//! The tiles in which a map lies; nothing when they are many: then the picture repeats on purpose.
std::vector<Eigen::AlignedBox2d> tilesOf(const UvMatrix &uv, double tileHeight)
{
    constexpr double most = 16;
    Eigen::AlignedBox2d box;
    for (Eigen::Index i = 0; i < uv.rows(); ++i) {
        if (uv.row(i).array().isFinite().all())
            box.extend(Vec2(uv(i, 0), uv(i, 1) / tileHeight));
    }
    std::vector<Eigen::AlignedBox2d> tiles;
    if (box.isEmpty())
        return tiles;
    // UVs on a border belong to the tile inside of it.
    constexpr double rounding = 1e-6;
    const Vec2 first = (box.min().array() + rounding).floor(), end = (box.max().array() - rounding).ceil();
    if (!((end - first).prod() <= most))
        return tiles;
    for (double y = first.y(); y < end.y(); ++y) {
        for (double x = first.x(); x < end.x(); ++x)
            tiles.emplace_back(Vec2(x, y * tileHeight), Vec2(x + 1, (y + 1) * tileHeight));
    }
    return tiles;
}

TiledPicture filledBeside(const CarryModel &model, const CarryTexture &texture, const JobContext &context)
{
    TiledPicture result = texture.picture;
    const ShadedSurface &source = model.source;
    const UvMatrix uv = onlyFaces(source, [&](int, int, int face) {
        return !model.sameTriangles || texture.faces.empty() || texture.faces[face];
    });
    for (auto &[tile, picture] : result.tiles)
        picture = filledBeside(picture, *source.mesh, uv, {udimTile(tile, source.tileHeight)}, context);
    if (!result.repeated)
        return result;
    if (const auto tiles = tilesOf(uv, source.tileHeight); !tiles.empty())
        result.repeated = filledBeside(result.repeated, *source.mesh, uv, tiles, context);
    return result;
}

} // namespace

BakeFigures carryTexture(const CarryModel &model, const CarryTexture &texture,
                         const std::function<bool(int tile, const Picture &picture)> &sink,
                         const JobContext &context)
{
    BakeJob job;
    job.low = model.low;
    job.low.uv = onlyFaces(model.low, [&](int start, int count, int face) {
        return (texture.faces.empty() || texture.faces[face]) &&
               (!model.sameTriangles || model.source.uv.middleRows(start, count).array().isFinite().all());
    });
    job.high = model.source;
    // One for all materials: the faces say where it is.
    job.high->textures = {{texture.kind, {filledBeside(model, texture, context)}, stretches(model, texture)}};
    job.kind = model.sameTriangles ? SourceKind::SameTriangles : SourceKind::Detailed;
    job.settings.maps = {{MapKind::Texture, 0}};
    job.settings.cage = model.cage;
    job.settings.grid.width = texture.width;
    job.settings.grid.height = texture.height;
    job.tiles = tilesToBake(*job.low.mesh, job.low.uv, job.low.tileHeight).numbers;
    job.margin = model.margin;
    job.floats = texture.floats;
    return runBake(
        job, [&sink](std::size_t, int tile, const Picture &picture) { return sink(tile, picture); }, context);
}

} // namespace autocuts::bake
