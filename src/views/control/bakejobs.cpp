#include "views/control/bakejobs.h"

#include "model/document/shadedscene.h"
#include "model/io/bakefiles.h"
#include "model/io/fileclashes.h"
#include "model/io/meshfile.h"
#include "model/io/projectfile.h"
#include "model/io/setjournal.h"
#include "model/io/transfersource.h"
#include "model/plain/udimtiles.h"
#include "views/control/jobtexts.h"

#include <QCoreApplication>
#include <QDir>
#include <QThread>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

Result<DocumentState> readDetailed(const QString &path, const std::atomic<bool> &stop, QStringList &warnings)
{
    if (!isProjectPath(path)) {
        Result<Scene> scene = readMesh(path, &stop);
        if (!scene)
            return scene.error();
        DocumentState model;
        model.scene = std::move(scene).value();
        return model;
    }
    Result<LoadedProject> project = loadProject(path, &stop);
    if (!project)
        return project.error();
    warnings << lossesOf(path, project->warnings);
    return std::move(project->state);
}

PictureDepth depthOf(int bits)
{
    return bits == 8 ? PictureDepth::Eight : bits == 16 ? PictureDepth::Sixteen : PictureDepth::Float;
}

} // namespace

Result<bake::BakeJob> makeBakeJob(const DocumentState &model, const PackingSettings &packing,
                                  const BakeChoice &choice, const std::atomic<bool> &stop,
                                  QStringList &warnings)
{
    const Scene &scene = model.scene;
    bake::BakeJob job;
    for (const auto &[name, kind] : bake::mapNames()) {
        if (choice.maps.contains(QLatin1StringView(name)))
            job.settings.maps.push_back({kind, 0});
    }
    job.settings.grid.width = choice.width > 0 ? choice.width : packing.textureSize;
    job.settings.grid.height =
        choice.width > 0 ? std::max(1, static_cast<int>(std::lround(choice.width * packing.tileHeight())))
                         : packing.height();
    job.settings.grid.perSide = choice.samplesPerSide;
    job.settings.rays.rays = choice.rays;
    job.settings.cage.distance = choice.cage;
    job.settings.cage.direction = static_cast<bake::CageDirection>(choice.direction);
    job.margin = choice.dilation;
    job.greenDown = choice.greenDown;
    job.floats = choice.suffix == QLatin1String("exr");
    job.low = shadedSurface(scene, packing.tileHeight());
    if (job.low.uv.rows() > 0) {
        const BakedTiles tiles = tilesToBake(*scene.mesh, job.low.uv, packing.tileHeight());
        job.tiles = tiles.numbers;
        if (tiles.facesOutside > 0)
            warnings << JobTexts::tr(
                "%n faces are not baked: they have no UVs, or their islands cross the border "
                "of a tile",
                nullptr, tiles.facesOutside);
    }
    const auto takeColors = [&](const DocumentState &source, ShadedSurface &surface) {
        QStringList missing;
        if (choice.maps.contains(QLatin1StringView(bake::nameOf(bake::MapKind::Color))))
            addColors(source, ColorSource::Auto, surface, missing);
        if (!missing.isEmpty())
            warnings
                << JobTexts::tr("Textures that cannot be read: %1").arg(missing.join(QStringLiteral(", ")));
    };
    if (choice.high.isEmpty()) {
        takeColors(model, job.low);
        return job;
    }
    const Result<DocumentState> high = readDetailed(choice.high, stop, warnings);
    if (!high)
        return high.error();
    job.kind = bake::SourceKind::Detailed;
    job.high = shadedSurface(high->scene);
    if (const QString moved = placeLike(*job.high, job.low); !moved.isEmpty())
        warnings << moved;
    takeColors(high.value(), *job.high);
    if (choice.byName) {
        const QStringList alone = pairObjects(job.low, scene.objectNames, *job.high, high->scene.objectNames);
        if (!alone.isEmpty())
            warnings << JobTexts::tr("No object of the detailed model belongs to: %1")
                            .arg(alone.join(QStringLiteral(", ")));
    }
    return job;
}

MapJobResult bakeJob(const DocumentState &model, const MapInput &input, const BakeChoice &choice,
                     JobControl &control)
{
    MapJobResult result;
    QStringList warnings = endBrokenSets({choice.folder, choice.high});
    const Result<bake::BakeJob> job = makeBakeJob(model, input.packing, choice, control.stop(), warnings);
    if (!job) {
        result.problem =
            control.stop() ? JobTexts::tr("Cancelled: nothing was baked") : job.error().toString();
        return result;
    }
    const auto pathOf = [&](const bake::MapRequest &map, int tile) {
        return bakedPath(choice.folder, model.scene.path, QLatin1StringView(bake::nameOf(map.kind)), tile,
                         job->tiles.size() > 1, choice.suffix);
    };
    QStringList pictures;
    for (const bake::MapRequest &map : job->settings.maps) {
        for (const int tile : job->tiles)
            pictures << pathOf(map, tile);
    }
    const Result<Done> fine =
        checkOutputs(pictures, filesOfSession(model, input.sessionPath, true) + QStringList{choice.high});
    if (!fine) {
        result.problem = fine.error().toString();
        return result;
    }
    FileSet written;
    const auto sink = [&](std::size_t map, int tile, const Picture &picture) {
        const Result<Done> added =
            addPicture(picture, pathOf(job->settings.maps[map], tile), depthOf(choice.bits), written);
        if (!added)
            result.problem = added.error().toString();
        return added.ok();
    };
    const JobContext context(
        &control.stop(), std::max(1, QThread::idealThreadCount()),
        [&control](const JobProgress &progress) { control.setProgress(progress.fraction); });
    const bake::BakeFigures figures = bake::runBake(job.value(), sink, context);
    if (!result.problem.isEmpty())
        return result;
    if (const Result<Done> placed = written.putInPlace(); !placed) {
        result.problem = placed.error().toString();
        return result;
    }
    const auto count = static_cast<int>(written.paths().size());
    const QString folder = QDir::toNativeSeparators(choice.folder);
    if (figures.stopped) {
        result.problem =
            count == 0
                ? JobTexts::tr("Cancelled: nothing was baked")
                : JobTexts::tr("Cancelled: %n pictures were finished in %1", nullptr, count).arg(folder);
        return result;
    }
    result.message = JobTexts::tr("Baked %n pictures into %1", nullptr, count).arg(folder);
    // Single texels at borders are not worth a word.
    constexpr double fewestPercent = 0.1;
    const auto percent = [&](long long texels) { return 100 * double(texels) / double(figures.texels); };
    if (percent(figures.missed) >= fewestPercent)
        warnings
            << JobTexts::tr(
                   "%1 % of the texels found nothing of the detailed model: a larger cage reaches farther")
                   .arg(percent(figures.missed), 0, 'f', 1);
    if (percent(figures.overlapped) >= fewestPercent)
        warnings << JobTexts::tr("%1 % of the texels are shared by several faces and show the first one")
                        .arg(percent(figures.overlapped), 0, 'f', 1);
    if (!warnings.isEmpty())
        result.problem = result.message + QStringLiteral(". ") + warnings.join(QStringLiteral(". "));
    return result;
}

} // namespace autocuts
