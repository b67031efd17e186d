#include "cli/batchbake.h"

#include "cli/letgo.h"
#include "cli/outputcheck.h"
#include "model/document/carriedsurface.h"
#include "model/document/shadedscene.h"
#include "model/io/bakefiles.h"
#include "model/io/carriedtextures.h"
#include "model/io/fileclashes.h"
#include "model/io/pictures/picturesize.h"
#include "model/io/savefile.h"
#include "model/io/texturefiles.h"
#include "model/io/transfersource.h"
#include "model/plain/chart.h"
#include "model/plain/udimtiles.h"
#include "model/transfer/surfacedistance.h"
#include "solver/bake/carrying.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>

#include <algorithm>
#include <map>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

Result<Done> checkSize(int width, int height)
{
    if (width <= maxPictureSide && height <= maxPictureSide && qint64(width) * height <= maxPicturePixels)
        return Done{};
    return Error{u"pictures of %1 x %2 texels are too large"_s.arg(width).arg(height),
                 {},
                 0,
                 u"Bake at most %1 x %1, and use UDIM tiles for more"_s.arg(maxPictureSide)};
}

Result<Done> makeFolder(const QString &folder)
{
    if (!QDir().mkpath(folder) || !QFileInfo(folder).isWritable())
        return Error{u"the folder for the pictures cannot be written"_s, folder, 0,
                     u"Check its permissions or choose another one"_s};
    return Done{};
}

//! \param files gets what it reads
Result<Scene> readScene(const CliOptions &options, const QString &path, const QString &uvSet,
                        BatchFiles &files, const std::atomic<bool> &stop)
{
    CliOptions other = options;
    other.command = CliOptions::Command::Bake; // that a stop ends the reading
    other.input = path;
    other.uvSet = uvSet;
    other.newUvSet.clear();
    return files.read(other, &stop);
}

//! A model that is baked from.
struct SourceModel
{
    DocumentState model;
    ShadedSurface surface;
    QStringList files; //!< that it was read from
    QStringList warnings;
};

Result<SourceModel> readSource(const CliOptions &options, const QString &path, const std::atomic<bool> &stop)
{
    const auto read = [=](const std::atomic<bool> &own) -> Result<SourceModel> {
        BatchFiles files;
        const Result<Scene> scene = readScene(options, path, {}, files, own);
        if (!scene)
            return scene.error();
        DocumentState model = files.modelOf(scene.value());
        QStringList beside = filesOfSession(model, path, true);
        return SourceModel{std::move(model), shadedSurface(scene.value()), std::move(beside),
                           lossesOf(path, files.warnings())};
    };
    std::optional<Result<SourceModel>> model = unlessStopped(stop, read);
    return model ? std::move(*model) : readingCancelled(path);
}

//! Prepares what every bake needs of the model that is baked into.
Result<bake::BakeJob> jobOf(const CliOptions &options, const Scene &scene, QStringList &warnings)
{
    if (!scene.hasUv())
        return Error{u"the model has no UV map to bake into"_s, options.input, 0, u"Unwrap it first"_s};
    const PackingSettings &packing = options.unwrap.packing;
    bake::BakeJob job = options.bake.job;
    job.settings.grid.width = packing.textureSize;
    job.settings.grid.height = packing.height();
    if (const Result<Done> small = checkSize(packing.textureSize, packing.height()); !small)
        return small.error();
    job.low = shadedSurface(scene, packing.tileHeight());
    const BakedTiles tiles = tilesToBake(*scene.mesh, job.low.uv, packing.tileHeight());
    job.tiles = tiles.numbers;
    if (tiles.facesOutside > 0)
        warnings
            << u"%1 faces are without UVs or belong to islands that cross the border of their tile: what "
               "lies outside of the baked tiles is not baked"_s.arg(tiles.facesOutside);
    return job;
}

Result<PictureDepth> depthOf(const CliOptions::Baking &options)
{
    const bool floats = options.suffix == u"exr"_s;
    const int bits = options.bits.value_or(floats ? 32 : 8);
    const bool fits = floats ? bits >= 16 : options.suffix == u"tga"_s ? bits == 8 : bits <= 16;
    if (!fits)
        return Error{u"%1 files have no numbers of %2 bits"_s.arg(options.suffix).arg(bits),
                     {},
                     0,
                     u"Choose other --bits or another --format"_s};
    return bits == 8 ? PictureDepth::Eight : bits == 16 ? PictureDepth::Sixteen : PictureDepth::Float;
}

//! \param files gets those that it was read from
Result<Done> readCage(const CliOptions &options, const Scene &scene, const std::atomic<bool> &stop,
                      bake::CageSettings &cage, QStringList &files, QStringList &warnings)
{
    BatchFiles cageFiles;
    const Result<Scene> read = readScene(options, options.bake.cageFile, {}, cageFiles, stop);
    if (!read)
        return read.error();
    files << filesOfSession(cageFiles.modelOf(read.value()), options.bake.cageFile, true);
    warnings << lossesOf(options.bake.cageFile, cageFiles.warnings());
    const MeshData &mesh = *read->mesh;
    if (mesh.faceStart != scene.mesh->faceStart || mesh.cornerVertex != scene.mesh->cornerVertex)
        return Error{u"the cage has other faces than the model"_s, options.bake.cageFile, 0,
                     u"Make it by moving the vertices of the model"_s};
    cage.positions = mesh.positions;
    return Done{};
}

//! The cage of the options for a detailed model.
Result<Done> takeCage(const CliOptions &options, const Scene &scene, const std::atomic<bool> &stop,
                      bake::BakeJob &job, BakeOutcome &outcome, QStringList &read)
{
    bake::CageSettings &cage = job.settings.cage;
    if (!options.bake.cageFile.isEmpty())
        return readCage(options, scene, stop, cage, read, outcome.warnings);
    if (options.bake.proposedCage) {
        const std::optional<double> measured = transfer::proposedCage(*job.low.mesh, *job.high->mesh, stop);
        if (!measured && !stop)
            outcome.warnings << u"the detailed model is nowhere near the input: the cage is %1 of its "
                                "diagonal"_s.arg(cage.distance);
        cage.distance = measured.value_or(cage.distance);
    }
    outcome.cage = cage.distance;
    return Done{};
}

//! Gives the surface the colours that a map of colours needs.
void takeColors(const CliOptions &options, const DocumentState &model, ShadedSurface &surface,
                QStringList &warnings)
{
    const auto isColor = [](const bake::MapRequest &map) { return map.kind == bake::MapKind::Color; };
    if (std::ranges::none_of(options.bake.job.settings.maps, isColor))
        return;
    QStringList missing;
    if (!addColors(model, options.bake.colorFrom, surface, missing))
        warnings
            << u"the model has no colours of the kind that --color-from names: those of its materials are "
               "baked"_s;
    if (!missing.isEmpty())
        warnings << u"textures that cannot be read: %1"_s.arg(missing.join(u", "_s));
}

void warnOfFaults(const bake::BakeFigures &figures, BakeOutcome &outcome)
{
    outcome.figures = figures;
    if (figures.missed > 0)
        outcome.warnings << u"%1 of %2 texels found nothing of the detailed model: a larger --cage reaches "
                            "farther"_s.arg(figures.missed)
                                .arg(figures.texels);
    if (figures.overlapped > 0)
        outcome.warnings << u"%1 of %2 texels are shared by several faces (islands that overlap or are "
                            "stacked): they show the first one"_s.arg(figures.overlapped)
                                .arg(figures.texels);
}

} // namespace

QJsonObject BakeOutcome::json() const
{
    QJsonObject seams;
    for (const auto &[map, difference] : seamDifferences)
        seams.insert(map, difference);
    QJsonObject report{{u"files"_s, QJsonArray::fromStringList(files)},
                       {u"texels"_s, figures.texels},
                       {u"texels_missed"_s, figures.missed},
                       {u"texels_overlapping"_s, figures.overlapped},
                       {u"seam_differences"_s, seams},
                       {u"notes"_s, QJsonArray::fromStringList(warnings)}};
    if (cage)
        report.insert(u"cage"_s, *cage);
    return report;
}

Result<BakeOutcome> bakeMaps(const CliOptions &options, const BatchFiles &files, const Scene &scene,
                             const std::atomic<bool> &stop, const JobContext &context)
{
    BakeOutcome outcome;
    const Result<PictureDepth> depth = depthOf(options.bake);
    if (!depth)
        return depth.error();
    Result<bake::BakeJob> job = jobOf(options, scene, outcome.warnings);
    if (!job)
        return job.error();
    job->floats = options.bake.suffix == u"exr"_s;
    QStringList read;
    if (!options.bake.high.isEmpty()) {
        Result<SourceModel> high = readSource(options, options.bake.high, stop);
        if (!high)
            return high.error();
        outcome.warnings << high->warnings;
        read << high->files;
        job->kind = bake::SourceKind::Detailed;
        job->high = std::move(high->surface);
        if (const QString moved = placeLike(*job->high, job->low); !moved.isEmpty())
            outcome.warnings << moved;
        takeColors(options, high->model, *job->high, outcome.warnings);
        if (options.bake.byName) {
            const QStringList alone =
                pairObjects(job->low, scene.objectNames, *job->high, high->model.scene.objectNames);
            if (!alone.isEmpty())
                outcome.warnings << u"no object of the detailed model belongs to: %1"_s.arg(
                    alone.join(u", "_s));
        }
        if (const Result<Done> cage = takeCage(options, scene, stop, job.value(), outcome, read); !cage)
            return cage.error();
    }
    if (options.bake.high.isEmpty())
        takeColors(options, files.modelOf(scene), job->low, outcome.warnings);
    const auto pathOf = [&](std::size_t map, int tile) {
        return bakedPath(options.output, options.input,
                         QLatin1StringView(bake::nameOf(job->settings.maps[map].kind)), tile,
                         job->tiles.size() > 1, options.bake.suffix);
    };
    QStringList pictures;
    for (std::size_t map = 0; map < job->settings.maps.size(); ++map) {
        for (const int tile : job->tiles)
            pictures << pathOf(map, tile);
    }
    if (const Result<Done> fine = checkClashes(options, files.modelOf(scene), pictures, read); !fine)
        return fine.error();
    if (const Result<Done> made = makeFolder(options.output); !made)
        return made.error();
    FileSet written;
    Result<Done> added = Done{};
    const auto sink = [&](std::size_t map, int tile, const Picture &picture) {
        added = addPicture(picture, pathOf(map, tile), depth.value(), written);
        return added.ok();
    };
    warnOfFaults(bake::runBake(job.value(), sink, context), outcome);
    for (std::size_t m = 0; m < job->settings.maps.size(); ++m) {
        if (const std::optional<double> mean = outcome.figures.seams[m].mean())
            outcome.seamDifferences[QLatin1StringView(bake::nameOf(job->settings.maps[m].kind))] =
                255 * *mean;
    }
    if (!added)
        return added.error();
    if (const Result<Done> placed = written.putInPlace(); !placed)
        return placed.error();
    outcome.files = written.paths();
    return outcome;
}

namespace {

//! The materials of an old model on the faces of the new one.
std::vector<int> materialsOf(const Scene &old, const Scene &scene)
{
    if (samePolygons(*old.mesh, *scene.mesh))
        return old.faceMaterial;
    std::map<QString, int> places; // the first of each name
    for (std::size_t material = 0; material < old.materialNames.size(); ++material)
        places.try_emplace(old.materialNames[material], int(material));
    std::vector<int> materials;
    for (const int material : scene.faceMaterial) {
        const QString name = material < 0 ? QString() : scene.materialNames[std::size_t(material)];
        const auto found = places.find(name);
        const int only = old.materialNames.size() == 1 ? 0 : -1;
        materials.push_back(found == places.end() ? only : found->second);
    }
    return materials;
}

//! A model whose texture sets are carried over: the new one, or the old one where the new one has none.
DocumentState texturedModel(const Scene &scene, const BatchFiles &files, const Scene &old,
                            const BatchFiles &oldFiles)
{
    DocumentState model = files.modelOf(scene);
    if (hasTextures(model))
        return model;
    model = oldFiles.modelOf(old);
    model.scene.faceMaterial = materialsOf(old, scene);
    return model;
}

} // namespace

Result<BakeOutcome> carryTextures(const CliOptions &options, const BatchFiles &files, const Scene &scene,
                                  const std::atomic<bool> &stop, const JobContext &context)
{
    BakeOutcome outcome;
    const Result<bake::BakeJob> prepared = jobOf(options, scene, outcome.warnings);
    if (!prepared)
        return prepared.error();
    const QString from = options.from.isEmpty() ? options.input : options.from;
    BatchFiles oldFiles;
    const Result<Scene> old = readScene(options, from, options.fromUvSet, oldFiles, stop);
    if (!old)
        return old.error();
    const QStringList losses =
        options.from.isEmpty() ? QStringList() : lossesOf(from, oldFiles.warnings()); // the input's are said
    if (!old->hasUv())
        return withLosses({u"the model has no UV map that its textures could be for"_s, from, 0, {}}, losses);
    outcome.warnings << losses;
    const DocumentState state = texturedModel(scene, files, old.value(), oldFiles);
    const CarryTarget target{options.output, {}, prepared->tiles.size() > 1, {}};
    const bool ofMaterials = options.bake.textures == QStringList{u"all"_s};
    const CarryPlan plan =
        ofMaterials ? planCarrying(state, target) : planCarrying(options.bake.textures, target);
    if (!plan.missing.isEmpty() && (plan.pictures.empty() || !ofMaterials))
        return Error{u"there is no such picture"_s, plan.missing.front(), 0, u"Check its name"_s};
    // Those that are not there yet overwrite nothing.
    const QStringList read = filesOfSession(oldFiles.modelOf(old.value()), from, true);
    if (const Result<Done> fine = checkClashes(options, state, plan.existingFiles(), read); !fine)
        return fine.error();
    if (const Result<Done> made = makeFolder(options.output); !made)
        return made.error();
    if (!plan.missing.isEmpty())
        outcome.warnings << u"textures that cannot be read: %1"_s.arg(plan.missing.join(u", "_s));

    CarriedSurface source = carriedSurface(old.value(), scene, options.unwrap.packing.tileHeight());
    const bake::CarryModel model{prepared->low, std::move(source.surface), source.sameTriangles,
                                 prepared->settings.cage, prepared->margin};
    const bool sized = options.given.contains(u"--texture-size"_s);
    const double count = double(plan.pictures.size());
    int done = 0;
    bake::BakeFigures figures;
    const auto bake = [&](const CarrySource &picture, const auto &sink) {
        const bake::CarryTexture texture{picture.picture,
                                         picture.kind,
                                         picture.faces,
                                         sized ? options.unwrap.packing.textureSize : picture.width,
                                         sized ? options.unwrap.packing.height() : picture.height,
                                         picture.depth == PictureDepth::Float};
        figures.add(bake::carryTexture(model, texture, sink, context.part(done / count, (done + 1) / count)));
    };
    const Result<CarriedFiles> carried = carryPictures(
        plan, state.scene.faceMaterial, bake,
        {[&context] { return context.stopped(); }, [&done](int pictures) { done = pictures; }, !ofMaterials});
    if (!carried)
        return carried.error();
    outcome.files = carried->files;
    if (carried->stopped)
        outcome.warnings << u"stopped before all pictures were finished: none was written"_s;
    for (const QString &problem : carried->problems)
        outcome.warnings << problem;
    warnOfFaults(figures, outcome);
    return outcome;
}

} // namespace autocuts
