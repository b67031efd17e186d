#include "views/control/lightjobs.h"

#include "model/io/fileclashes.h"
#include "model/io/setjournal.h"
#include "solver/bake/lightjob.h"
#include "views/control/jobtexts.h"

#include <QCoreApplication>
#include <QDir>
#include <QThread>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! The longer side of the pictures that views get; a finer one would make the views wait.
constexpr int largestShown = 2048;

//! As in a file of 8 bits. Black texels are mostly those without a value.
QImage shownImage(const Picture &picture)
{
    const int step = (std::max(picture.width, picture.height) + largestShown - 1) / largestShown;
    QImage image(picture.width / step, picture.height / step, QImage::Format_RGB32);
    const auto part = [](float value) {
        return value > 0 ? static_cast<int>(255 * std::min(1.0F, srgbFromLinear(value)) + 0.5F) : 0;
    };
    for (int y = 0; y < image.height(); ++y) {
        auto *line = reinterpret_cast<QRgb *>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x) {
            const std::span<const float> texel = picture.at(x * step, y * step);
            line[x] = qRgb(part(texel[0]), part(texel[1]), part(texel[2]));
        }
    }
    return image;
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

bake::LightBakeSettings settingsOf(const LightChoice &choice, const PackingSettings &packing)
{
    bake::LightBakeSettings settings;
    settings.width = choice.textureSize > 0 ? choice.textureSize : packing.textureSize;
    settings.height =
        std::clamp(static_cast<int>(std::lround(settings.width * packing.tileHeight())), 1, maxLightMapSide);
    settings.samples = choice.samples;
    settings.bounces = choice.bounces;
    settings.direct = choice.direct;
    settings.indirect = choice.indirect;
    settings.value = static_cast<bake::LightValue>(choice.values);
    settings.denoise = choice.denoise;
    settings.margin = choice.dilation;
    return settings;
}

} // namespace

MapJobResult lightBakeJob(const DocumentState &model, int textureSet, const MapInput &input,
                          const LightChoice &choice, const LightReceiver &shown, JobControl &control)
{
    MapJobResult result;
    const PackingSettings &packing = input.packing;
    const Result<PictureDepth> depth = lightMapDepth(choice.path, choice.bits);
    QStringList missing;
    Result<LitSurface> surface = litSurface(model, choice.surface, textureSet, packing.tileHeight(), missing);
    if (!depth || !surface) {
        result.problem = (depth ? surface.error() : depth.error()).toString();
        return result;
    }
    const bake::LightJob job = bake::lightJobOf(std::move(surface).value(), choice.lights,
                                                settingsOf(choice, packing), packing.tileHeight());
    QStringList pictures;
    for (const int tile : job.tiles)
        pictures << lightMapPath(choice.path, tile, job.tiles.size() > 1);
    const Result<Done> fine = checkOutputs(pictures, filesOfSession(model, input.sessionPath, true) +
                                                         QStringList{choice.surface.albedoFile});
    if (!fine) {
        result.problem = fine.error().toString();
        return result;
    }
    const QStringList ended = endBrokenSets({choice.path});
    FileSet written;
    double bright = 0;
    const auto sink = [&](int tile, bake::LightBakeResult &baked) {
        if (shown)
            shown(tile, shownImage(baked.picture));
        if (depth.value() != PictureDepth::Float && !choice.path.endsWith(u".exr", Qt::CaseInsensitive))
            bright = std::max(bright, tooBright(baked));
        const QString path = lightMapPath(choice.path, tile, job.tiles.size() > 1);
        const Result<Done> added = addLightMap(std::move(baked.picture), path, depth.value(), written);
        if (!added)
            result.problem = added.error().toString();
        return added.ok();
    };
    bake::LightTilePreview preview;
    if (shown)
        preview = [&shown](int tile, const Picture &picture) { shown(tile, shownImage(picture)); };
    const JobContext context(
        &control.stop(), std::max(1, QThread::idealThreadCount()),
        [&control](const JobProgress &progress) { control.setProgress(progress.fraction); });
    const bake::LightFigures figures = bake::runLightBake(job, sink, preview, context);
    if (!result.problem.isEmpty())
        return result;
    if (const Result<Done> placed = written.putInPlace(); !placed) {
        result.problem = placed.error().toString();
        return result;
    }
    const QString files = QDir::toNativeSeparators(written.paths().join(QStringLiteral(", ")));
    if (figures.stopped) {
        result.problem = files.isEmpty() ? JobTexts::tr("Cancelled: no light was baked")
                                         : JobTexts::tr("Cancelled: %1 has what was found so far").arg(files);
        return result;
    }
    result.message = JobTexts::tr("Baked light into %1").arg(files);
    QStringList warnings = ended;
    if (!missing.isEmpty())
        warnings << JobTexts::tr("Textures that cannot be read: %1").arg(missing.join(QStringLiteral(", ")));
    if (!warnings.isEmpty())
        result.problem = result.message + QStringLiteral(". ") + warnings.join(QStringLiteral(". "));
    // Single texels, as beside a lamp, are not worth a word.
    constexpr double fewest = 0.01;
    if (bright >= fewest)
        result.problem =
            JobTexts::tr("%1. In %2 % of the texels light is above 1 and was cut off: EXR keeps it, or "
                         "take weaker lights")
                .arg(result.problem.isEmpty() ? result.message : result.problem)
                .arg(100 * bright, 0, 'f', 0);
    return result;
}

} // namespace autocuts
