#include "cli/batchlight.h"

#include "cli/outputcheck.h"
#include "model/io/litscene.h"
#include "solver/bake/lightjob.h"

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

Result<BakeOutcome> bakeLights(const CliOptions &options, const BatchFiles &files, const Scene &scene,
                               const std::atomic<bool> &, const JobContext &context)
{
    const PackingSettings &texture = options.unwrap.packing;
    if (texture.textureSize > maxLightMapSide || texture.height() > maxLightMapSide)
        return Error{u"light maps have at most %1 x %1 texels"_s.arg(maxLightMapSide), {}, 0, {}};
    const Result<PictureDepth> depth = lightMapDepth(options.output, options.light.bits);
    if (!depth)
        return depth.error();
    QStringList missing;
    // The textures of materials are for the first UV set of the file.
    Result<LitSurface> surface = litSurface(files.modelOf(scene), options.light.surface,
                                            files.activeUvSet() == 0 ? 0 : 1, texture.tileHeight(), missing);
    if (!surface)
        return surface.error();
    bake::LightBakeSettings settings = options.light.settings;
    settings.width = texture.textureSize;
    settings.height = texture.height();
    const bake::LightJob job =
        bake::lightJobOf(std::move(surface).value(), options.light.lights, settings, texture.tileHeight());
    QStringList pictures;
    for (const int tile : job.tiles)
        pictures << lightMapPath(options.output, tile, job.tiles.size() > 1);
    if (const Result<Done> fine = checkClashes(options, files.modelOf(scene), pictures); !fine)
        return fine.error();
    BakeOutcome outcome;
    if (!missing.isEmpty())
        outcome.warnings << u"textures that cannot be read: %1"_s.arg(missing.join(u", "_s));
    FileSet written;
    Result<Done> added = Done{};
    const auto sink = [&](int tile, bake::LightBakeResult &baked) {
        const QString path = lightMapPath(options.output, tile, job.tiles.size() > 1);
        added = addLightMap(std::move(baked.picture), path, depth.value(), written);
        return added.ok();
    };
    const bake::LightFigures figures = bake::runLightBake(job, sink, {}, context);
    outcome.figures.stopped = figures.stopped;
    outcome.figures.texels = figures.texels;
    if (!added)
        return added.error();
    if (const Result<Done> placed = written.putInPlace(); !placed)
        return placed.error();
    outcome.files = written.paths();
    return outcome;
}

} // namespace autocuts
