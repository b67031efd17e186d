#include "solver/bake/bakejob.h"

#include "model/plain/udimtiles.h"
#include "solver/bake/dilation.h"
#include "solver/bake/encoding.h"
#include "solver/bake/seamevening.h"

#include <algorithm>

namespace autocuts::bake {

namespace {

Projection projectionOf(const BakeJob &job, const Frame &frame, const JobContext &context)
{
    switch (job.kind) {
    case SourceKind::None:
        return {job.low, job.low, frame, context};
    case SourceKind::SameTriangles:
        return {job.low, *job.high, frame, context,
                std::ranges::any_of(job.settings.maps,
                                    [](const MapRequest &map) { return sendsRays(map.kind); })};
    case SourceKind::Detailed:
        break;
    }
    return {job.low, *job.high, frame, job.settings.cage, context};
}

//! Splits the maps into passes that fit into the memory.
std::vector<std::vector<std::size_t>> passesOf(const BakeJob &job, const ShadedSurface &source)
{
    const std::size_t texels = std::size_t(job.settings.grid.width) * job.settings.grid.height;
    std::vector<std::vector<std::size_t>> passes;
    std::size_t used = 0;
    for (std::size_t m = 0; m < job.settings.maps.size(); ++m) {
        const std::size_t bytes = texels * sizeof(float) * channelsOf(source, job.settings.maps[m]);
        if (passes.empty() || used + bytes > job.memory) {
            passes.emplace_back();
            used = 0;
        }
        passes.back().push_back(m);
        used += bytes;
    }
    return passes;
}

//! Maps whose values go on across seams. Colours may end at one by right, and IDs have no mean.
constexpr bool isEvened(MapKind kind)
{
    return kind != MapKind::Color && kind != MapKind::MaterialId && kind != MapKind::Texture;
}

//! Makes of what was found a picture for a file.
void finishMap(const BakeJob &job, const Eigen::AlignedBox2d &tile, const MapRequest &request,
               TextureKind kind, std::vector<std::uint8_t> filled, const Encoding &encoding, Picture &picture,
               SeamDifference &difference, const JobContext &context)
{
    if (isEvened(request.kind))
        evenSeams(job.low, tile, isInTangentSpace(request.kind), filled, picture, context);
    dilate(picture, filled, job.margin, context);
    encode(picture, request, kind, filled, encoding);
    if (context.stopped() || job.floats || request.kind == MapKind::MaterialId)
        return;
    const bool isTexture = kind == TextureKind::Normal || kind == TextureKind::NormalDirectX;
    compareSides(job.low, tile, picture,
                 isTexture || isInTangentSpace(request.kind) ? SeamValues::TangentNormals
                                                             : SeamValues::Numbers,
                 isTexture ? kind == TextureKind::NormalDirectX : job.greenDown, difference);
}

} // namespace

Encoding encodingOf(const BakeJob &job, const Frame &frame)
{
    Encoding encoding;
    encoding.floats = job.floats;
    encoding.greenDown = job.greenDown;
    encoding.heightRange = std::max(1e-300, job.settings.cage.distance * frame.size);
    Eigen::AlignedBox3d box;
    for (const int vertex : job.low.mesh->cornerVertex)
        box.extend(Vec3(job.low.mesh->positions.row(vertex)));
    if (!box.isEmpty()) {
        encoding.positionLow = box.min();
        encoding.positionRange = std::max(1e-300, box.sizes().maxCoeff());
    }
    return encoding;
}

BakeFigures runBake(const BakeJob &job, const MapSink &sink, const JobContext &context)
{
    BakeFigures figures;
    figures.seams.resize(job.settings.maps.size());
    const Frame frame = Frame::of(*job.low.mesh);
    const Projection projection = projectionOf(job, frame, context);
    const ShadedSurface &source = projection.source();
    const Encoding encoding = encodingOf(job, frame);
    const auto passes = passesOf(job, source);
    const double parts = double(passes.size()) * double(job.tiles.size());
    double part = 0;
    for (const int tile : job.tiles) {
        for (const std::vector<std::size_t> &pass : passes) {
            BakeSettings settings = job.settings;
            settings.grid.tile = udimTile(tile, job.low.tileHeight);
            settings.maps.clear();
            for (const std::size_t m : pass)
                settings.maps.push_back(job.settings.maps[m]);
            BakeResult baked = bakeTile(job.low, projection, frame, settings,
                                        context.part(part / parts, (part + 1) / parts));
            part += 1;
            if (&pass == &passes.front()) {
                figures.texels += baked.texels;
                figures.missed += baked.missed;
                figures.overlapped += baked.overlapped;
            }
            for (std::size_t i = 0; i < pass.size() && !context.stopped(); ++i) {
                const MapRequest &request = settings.maps[i];
                const TextureKind kind = request.kind == MapKind::Texture
                                             ? source.textures[request.texture].kind
                                             : TextureKind::Linear;
                finishMap(job, settings.grid.tile, request, kind, baked.filled, encoding, baked.maps[i],
                          figures.seams[pass[i]], context);
                if (!context.stopped() && !sink(pass[i], tile, baked.maps[i]))
                    return figures;
                baked.maps[i] = {};
            }
            if (context.stopped()) {
                figures.stopped = true;
                return figures;
            }
        }
    }
    return figures;
}

} // namespace autocuts::bake
