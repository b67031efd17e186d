#include "views/control/carryjobs.h"

#include "commands/replay.h"
#include "model/document/carriedsurface.h"
#include "model/document/shadedscene.h"
#include "model/io/carriedtextures.h"
#include "model/io/fileclashes.h"
#include "model/io/meshfile.h"
#include "model/io/projectfile.h"
#include "model/io/setjournal.h"
#include "model/io/transfersource.h"
#include "model/plain/udimtiles.h"
#include "model/plain/uvlayout.h"
#include "solver/bake/carrying.h"
#include "views/control/jobtexts.h"

#include <QCoreApplication>
#include <QDir>
#include <QThread>

#include <algorithm>

namespace autocuts {

namespace {

using From = CarryChoice::From;

//! The scene with one of its UV sets as the first one.
Scene withSet(const DocumentState &state, int set)
{
    Scene scene = state.scene;
    if (set >= 0 && set < std::ssize(scene.uvSets))
        std::swap(scene.uvSets.front(), scene.uvSets[std::size_t(set)]);
    return scene;
}

Result<Scene> readFile(const QString &path, double tileHeight, const std::atomic<bool> &stop,
                       QStringList &losses)
{
    if (!isProjectPath(path))
        return readMesh(path, &stop, tileHeight);
    const Result<LoadedProject> project = loadProject(path, &stop);
    if (!project)
        return project.error();
    losses = lossesOf(path, project->warnings);
    return withSet(project->state, project->state.activeUvSet);
}

//! The model with the map that the textures are for, as its first set.
Result<Scene> sourceScene(const CarryInput &input, const CarryChoice &choice, const std::atomic<bool> &stop,
                          QStringList &losses)
{
    switch (choice.from) {
    case From::UvSet:
        return withSet(input.state, choice.uvSet);
    case From::File:
        return readFile(choice.file, input.state.packingSettings.tileHeight(), stop, losses);
    case From::Textures:
        break;
    }
    std::optional<UvMatrix> map = mapOfTextures(input.journal.finished());
    if (!map || map->rows() != input.state.scene.mesh->cornerCount())
        return Error{JobTexts::tr("the history does not know for which map the textures are"),
                     {},
                     0,
                     JobTexts::tr("Choose the file or the UV set that has it")};
    Scene scene = input.state.scene;
    scene.uvSets.front().uv = std::move(*map);
    return scene;
}

bool sameMap(const Scene &a, const Scene &b)
{
    return samePolygons(*a.mesh, *b.mesh) && sameBits(a.uvSets.front().uv, b.uvSets.front().uv);
}

MapJobResult failed(const QString &problem)
{
    MapJobResult result;
    result.problem = problem;
    return result;
}

//! What is not as wished, one line each.
QStringList warningsOf(const CarryPlan &plan, const CarriedFiles &files, const bake::BakeFigures &figures,
                       int facesOutside)
{
    QStringList warnings;
    if (!plan.missing.isEmpty())
        warnings
            << JobTexts::tr("Pictures that are not there: %1").arg(plan.missing.join(QStringLiteral(", ")));
    warnings += files.problems;
    if (facesOutside > 0)
        warnings << JobTexts::tr("%n faces get nothing: they have no UVs, or their islands cross the border "
                                 "of a tile",
                                 nullptr, facesOutside);
    // Single texels at borders are not worth a word.
    constexpr double fewestPercent = 0.1;
    const auto percent = [&](long long texels) { return 100 * double(texels) / double(figures.texels); };
    if (percent(figures.missed) >= fewestPercent)
        warnings << JobTexts::tr("%1 % of the texels found nothing of the other model")
                        .arg(percent(figures.missed), 0, 'f', 1);
    if (percent(figures.overlapped) >= fewestPercent)
        warnings << JobTexts::tr("%1 % of the texels are shared by several faces and show the first one")
                        .arg(percent(figures.overlapped), 0, 'f', 1);
    return warnings;
}

} // namespace

MapJobResult carryJob(const CarryInput &input, const QString &sessionPath, const CarryChoice &choice,
                      JobControl &control)
{
    const QString cancelled = JobTexts::tr("Cancelled: no picture was written");
    const double tileHeight = input.state.packingSettings.tileHeight();
    const Scene scene = withSet(input.state, input.state.activeUvSet);
    QStringList losses;
    const QStringList ended = endBrokenSets({choice.folder, choice.file});
    const Result<Scene> before = sourceScene(input, choice, control.stop(), losses);
    if (control.stop())
        return failed(cancelled);
    if (!before)
        return failed(before.error().toString());
    if (!before->hasUv())
        return failed(
            (QStringList{JobTexts::tr("The other model has no UVs")} + losses).join(QStringLiteral(". ")));
    if (sameMap(before.value(), scene))
        return failed(choice.from == From::Textures
                          ? JobTexts::tr("As far as the history knows, the textures fit this map already: "
                                         "choose the file or the UV set that they are for")
                          : JobTexts::tr("The textures fit this map already"));
    CarriedSurface source = carriedSurface(before.value(), scene, tileHeight);
    bake::CarryModel model{shadedSurface(scene, tileHeight), std::move(source.surface), source.sameTriangles,
                           bake::CageSettings(), choice.margin};
    const BakedTiles tiles = tilesToBake(*scene.mesh, model.low.uv, tileHeight);
    const CarryPlan plan =
        planCarrying(input.state, {choice.folder, choice.suffix, tiles.numbers.size() > 1, choice.format});
    DocumentState other;
    other.scene = before.value();
    const Result<Done> fine =
        checkOutputs(plan.existingFiles(), filesOfSession(input.state, sessionPath, true) +
                                               filesOfSession(other, choice.file, true));
    if (!fine)
        return failed(fine.error().toString());
    const JobContext context(
        &control.stop(), std::max(1, QThread::idealThreadCount()),
        [&control](const JobProgress &progress) { control.setProgress(progress.fraction); });
    const double count = double(plan.pictures.size());
    int done = 0;
    bake::BakeFigures figures;
    const auto bake = [&](const CarrySource &picture, const auto &sink) {
        const int width = choice.size > 0 ? choice.size : picture.width;
        const int height =
            choice.size > 0 ? std::max(1, int(std::lround(choice.size * tileHeight))) : picture.height;
        const bake::CarryTexture texture{picture.picture, picture.kind, picture.faces,
                                         width,           height,       picture.depth == PictureDepth::Float};
        figures.add(bake::carryTexture(model, texture, sink, context.part(done / count, (done + 1) / count)));
    };
    const Result<CarriedFiles> carried = carryPictures(
        plan, scene.faceMaterial, bake,
        {[&control] { return control.stop().load(); }, [&done](int pictures) { done = pictures; }});
    if (!carried)
        return failed(carried.error().toString());
    if (carried->stopped)
        return failed(cancelled);
    MapJobResult result;
    result.textures = MadeTextures{input.state.textureSets, carriedSets(input.state, carried->plan)};
    result.message =
        JobTexts::tr("Carried %n pictures over into %1", nullptr, static_cast<int>(carried->files.size()))
            .arg(QDir::toNativeSeparators(choice.folder));
    const QStringList warnings =
        ended + losses + warningsOf(plan, carried.value(), figures, tiles.facesOutside);
    if (!warnings.isEmpty())
        result.problem = result.message + QStringLiteral(". ") + warnings.join(QStringLiteral(". "));
    return result;
}

} // namespace autocuts
