#include "views/control/bakejobs.h"

#include "model/document/shadedscene.h"
#include "model/io/bakefiles.h"
#include "model/io/fileclashes.h"
#include "model/io/meshfile.h"
#include "model/io/projectfile.h"
#include "model/io/setjournal.h"
#include "model/io/transfersource.h"
#include "model/plain/udimtiles.h"
#include "model/transfer/surfacedistance.h"
#include "views/control/cageproposal.h"
#include "views/control/jobtexts.h"

#include <QCoreApplication>
#include <QDir>
#include <QThread>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

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

//! Takes the positions of a cage from a file.
Result<Done> readCage(const QString &path, const MeshData &low, const std::atomic<bool> &stop,
                      bake::CageSettings &cage, QStringList &files, QStringList &warnings)
{
    const Result<DocumentState> read = readDetailed(path, stop, warnings);
    if (!read)
        return read.error();
    files << filesOfSession(read.value(), path, true);
    const MeshData &mesh = *read->scene.mesh;
    if (mesh.faceStart != low.faceStart || mesh.cornerVertex != low.cornerVertex)
        return Error{JobTexts::tr("the cage has other faces than the model"), path, 0,
                     JobTexts::tr("Make it by moving the vertices of the model")};
    cage.positions = mesh.positions;
    return Done{};
}

//! The texture sets of the model with the pictures that were baked.
std::vector<TextureSet> setsWith(const DocumentState &model, const std::map<QString, QString> &pictures,
                                 bool greenDown)
{
    std::vector<TextureSet> sets = model.textureSets;
    std::set<int> materials(model.scene.faceMaterial.begin(), model.scene.faceMaterial.end());
    if (materials.empty())
        materials.insert(-1);
    constexpr std::pair<const char *, TextureChannel> channels[]{{"normal", TextureChannel::Normal},
                                                                 {"ao", TextureChannel::Occlusion},
                                                                 {"color", TextureChannel::BaseColor}};
    for (const int material : materials) {
        const auto place = static_cast<std::size_t>(material) + 1; // -1, without a material, is the first one
        sets.resize(std::max(sets.size(), place + 1));
        for (const auto &[name, channel] : channels) {
            const auto picture = pictures.find(QLatin1StringView(name));
            if (picture == pictures.end())
                continue;
            ChannelPicture fresh;
            fresh.picture.file = picture->second;
            fresh.flipped = greenDown && channel == TextureChannel::Normal;
            sets[place][channel] = fresh;
        }
    }
    return sets;
}

//! What a bake did not find, one line each.
QStringList faultsOf(const bake::BakeFigures &figures)
{
    // Single texels at borders are not worth a word.
    constexpr double fewestPercent = 0.1;
    const auto percent = [&](long long texels) { return 100 * double(texels) / double(figures.texels); };
    QStringList faults;
    if (percent(figures.missed) >= fewestPercent)
        faults << JobTexts::tr(
                      "%1 % of the texels found nothing of the detailed model: a larger cage reaches farther")
                      .arg(percent(figures.missed), 0, 'f', 1);
    if (percent(figures.overlapped) >= fewestPercent)
        faults << JobTexts::tr("%1 % of the texels are shared by several faces and show the first one")
                      .arg(percent(figures.overlapped), 0, 'f', 1);
    return faults;
}

//! The files that a bake must not replace.
QStringList filesToKeep(const DocumentState &model, const QString &sessionPath, const BakeChoice &choice,
                        const QStringList &pictures)
{
    QStringList kept = filesOfSession(model, sessionPath, true);
    // Colours that an earlier bake put on this model are made anew from the detailed one.
    for (const TextureSet &set : model.textureSets) {
        const auto color = set.find(TextureChannel::BaseColor);
        if (!choice.high.isEmpty() && color != set.end() && pictures.contains(color->second.picture.file))
            kept.removeAll(color->second.picture.file);
    }
    return kept;
}

PictureDepth depthOf(int bits)
{
    return bits == 8 ? PictureDepth::Eight : bits == 16 ? PictureDepth::Sixteen : PictureDepth::Float;
}

} // namespace

Result<bake::BakeJob> makeBakeJob(const DocumentState &model, const PackingSettings &packing,
                                  const BakeChoice &choice, const std::atomic<bool> &stop, QStringList &files,
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
    job.settings.rays.reach = choice.reach;
    job.settings.rays.curvatureRadius = choice.curvatureRadius;
    job.settings.rays.thicknessLimit = choice.thicknessLimit;
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
                "%n faces are not baked as a whole: they have no UVs, or their islands reach over the "
                "border of their tile",
                nullptr, tiles.facesOutside);
    }
    const auto takeColors = [&](const DocumentState &source, ShadedSurface &surface) {
        QStringList missing;
        bool plain = false;
        if (choice.maps.contains(QLatin1StringView(bake::nameOf(bake::MapKind::Color))))
            plain = !addColors(source, static_cast<ColorSource>(choice.colors), surface, missing);
        if (plain)
            warnings << JobTexts::tr(
                "The model has no colours of the chosen kind: those of its materials are "
                "baked");
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
    files << filesOfSession(high.value(), choice.high, true);
    job.kind = bake::SourceKind::Detailed;
    job.high = shadedSurface(high->scene);
    if (const QString moved = placeLike(*job.high, job.low); !moved.isEmpty())
        warnings << moved;
    takeColors(high.value(), *job.high);
    if (!choice.cageFile.isEmpty()) {
        const Result<Done> cage =
            readCage(choice.cageFile, *scene.mesh, stop, job.settings.cage, files, warnings);
        if (!cage)
            return cage.error();
    } else if (!choice.ownCage) {
        const std::optional<double> measured = transfer::proposedCage(*job.low.mesh, *job.high->mesh, stop);
        if (!measured && !stop)
            warnings << JobTexts::tr("The detailed model is nowhere near this one: the cage is %1 % of its "
                                     "diagonal")
                            .arg(100 * bake::CageSettings().distance);
        job.settings.cage.distance = measured.value_or(bake::CageSettings().distance);
    }
    if (choice.byName) {
        const QStringList alone = pairObjects(job.low, scene.objectNames, *job.high, high->scene.objectNames);
        if (!alone.isEmpty())
            warnings << JobTexts::tr("No object of the detailed model belongs to: %1")
                            .arg(alone.join(QStringLiteral(", ")));
    }
    return job;
}

Result<double> proposedCage(const DocumentState &model, const QString &high, const std::atomic<bool> &stop)
{
    QStringList warnings;
    const Result<DocumentState> read = readDetailed(high, stop, warnings);
    if (!read)
        return read.error();
    const ShadedSurface low = shadedSurface(model.scene);
    ShadedSurface detailed = shadedSurface(read->scene);
    placeLike(detailed, low);
    const std::optional<double> cage = transfer::proposedCage(*low.mesh, *detailed.mesh, stop);
    if (!cage)
        return Error{JobTexts::tr("the detailed model is nowhere near this one"), high, 0,
                     JobTexts::tr("Choose the model that belongs to this one")};
    return *cage;
}

MapJobResult bakeJob(const DocumentState &model, const MapInput &input, const BakeChoice &choice,
                     JobControl &control)
{
    MapJobResult result;
    QStringList warnings = endBrokenSets({choice.folder, choice.high});
    QStringList read;
    const Result<bake::BakeJob> job =
        makeBakeJob(model, input.packing, choice, control.stop(), read, warnings);
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
        checkOutputs(pictures, read + filesToKeep(model, input.sessionPath, choice, pictures));
    if (!fine) {
        result.problem = fine.error().toString();
        return result;
    }
    FileSet written;
    std::map<QString, QString> shown; // a picture of each map, by its name
    const auto sink = [&](std::size_t map, int tile, const Picture &picture) {
        const QString path = pathOf(job->settings.maps[map], tile);
        const Result<Done> added = addPicture(picture, path, depthOf(choice.bits), written);
        shown.try_emplace(QString::fromStdString(std::string(bake::nameOf(job->settings.maps[map].kind))),
                          path);
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
    if (choice.isPutOn())
        result.textures = MadeTextures{model.textureSets, setsWith(model, shown, choice.greenDown)};
    warnings += faultsOf(figures);
    if (!warnings.isEmpty())
        result.problem = result.message + QStringLiteral(". ") + warnings.join(QStringLiteral(". "));
    return result;
}

} // namespace autocuts
