#include "jobs/bakelight.h"

#include "jobs/jobtexts.h"
#include "jobs/lightmapfiles.h"
#include "model/io/outputs/fileclashes.h"

#include <algorithm>
#include <cmath>

namespace autocuts::jobs {

namespace {

bake::LightBakeSettings settingsOf(const LightChoice &choice, const PackingSettings &packing)
{
    bake::LightBakeSettings settings;
    settings.width = choice.textureSize > 0 ? choice.textureSize : packing.textureSize;
    settings.height = choice.textureSize > 0
                          ? std::max(1, static_cast<int>(std::lround(settings.width * packing.tileHeight())))
                          : packing.height();
    settings.samples = choice.samples;
    settings.bounces = choice.bounces;
    settings.direct = choice.direct;
    settings.indirect = choice.indirect;
    settings.value = choice.values;
    settings.denoise = choice.denoise;
    settings.margin = choice.dilation;
    return settings;
}

//! The share of the texels with light whose light is above 1.
double tooBright(const bake::LightBakeResult &baked)
{
    long long bright = 0, all = 0;
    for (std::size_t i = 0; i < baked.filled.size(); ++i) {
        const float *color = baked.picture.values.data() + 3 * i;
        all += baked.filled[i];
        bright += baked.filled[i] && std::max({color[0], color[1], color[2]}) > 1;
    }
    return all > 0 ? double(bright) / double(all) : 0;
}

} // namespace

Result<MadePictures> bakeLight(const PictureInput &input, int textureSet, const LightChoice &choice,
                               const bake::LightTilePreview &shown, const JobContext &context)
{
    const bake::LightBakeSettings settings = settingsOf(choice, input.packing);
    if (settings.width > maxLightMapSide || settings.height > maxLightMapSide)
        return Error{JobTexts::tr("light maps have at most %1 x %1 texels").arg(maxLightMapSide), {}, 0, {}};
    const Result<PictureDepth> depth = lightMapDepth(choice.path, choice.bits);
    if (!depth)
        return depth.error();
    context.enter(JobStage::Preparing);
    const double tileHeight = input.packing.tileHeight();
    QStringList missing;
    Result<LitSurface> surface = litSurface(input.model, choice.surface, textureSet, tileHeight, missing);
    if (!surface)
        return surface.error();
    const bake::LightJob job =
        bake::lightJobOf(std::move(surface).value(), choice.lights, settings, tileHeight);
    const auto pathOf = [&](int tile) { return lightMapPath(choice.path, tile, job.tiles.size() > 1); };
    QStringList pictures;
    for (const int tile : job.tiles)
        pictures << pathOf(tile);
    const Result<Done> fine =
        checkOutputs(pictures + input.alsoWritten, input.kept + QStringList{choice.surface.albedoFile});
    if (!fine)
        return fine.error();
    context.enter(JobStage::Working);
    FileSet files;
    Result<Done> added = Done{};
    double bright = 0;
    const bool clamped =
        depth.value() != PictureDepth::Float && !choice.path.endsWith(u".exr", Qt::CaseInsensitive);
    const auto sink = [&](int tile, bake::LightBakeResult &baked) {
        if (shown)
            shown(tile, baked.picture);
        if (clamped)
            bright = std::max(bright, tooBright(baked));
        added = addLightMap(std::move(baked.picture), pathOf(tile), depth.value(), files);
        return added.ok();
    };
    const bake::LightFigures figures = bake::runLightBake(job, sink, shown, context);
    if (!added)
        return added.error();
    if (const Result<Done> placed = files.putInPlace(); !placed)
        return placed.error();
    MadePictures made;
    made.stopped = figures.stopped;
    made.files = files.paths();
    made.texels = figures.texels;
    if (!missing.isEmpty())
        made.warnings.push_back({Remark::Kind::UnreadableTextures, 0, missing});
    // Single texels, as beside a lamp, are normal.
    constexpr double fewest = 0.01;
    if (bright >= fewest)
        made.warnings.push_back({Remark::Kind::LightCutOff, bright});
    return made;
}

} // namespace autocuts::jobs
