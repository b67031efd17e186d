#include "cli/batchfiles.h"

#include "commands/changesettings.h"
#include "commands/edituvsets.h"
#include "commands/makeunique.h"
#include "commands/newmap.h"
#include "jobs/othermodel.h"
#include "model/document/givenseams.h"
#include "model/document/makesnapshot.h"
#include "model/document/uvsetorder.h"
#include "model/io/meshes/exportlosses.h"
#include "model/io/meshes/instances.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "model/io/projects/projectscene.h"
#include "model/layouts/uvexport.h"
#include "model/pictures/texturefiles.h"
#include "model/plain/uvlayout.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

constexpr int thumbnailSize = 256;

UvEdit editOf(CliOptions::Command command, bool onlyPart)
{
    switch (command) {
    case CliOptions::Command::Pack:
        return UvEdit::Pack;
    case CliOptions::Command::Separate:
        return UvEdit::Separate;
    case CliOptions::Command::Finish:
        return onlyPart ? UvEdit::FinishSelection : UvEdit::Finish;
    case CliOptions::Command::Transfer:
        return UvEdit::Transfer;
    default:
        return onlyPart ? UvEdit::UnwrapSelection : UvEdit::Unwrap;
    }
}

//! The session settings for the options. Settings for which the command has no option are unchanged.
PackingSettings packingSettingsOf(const CliOptions &options, const PackingSettings &settings)
{
    PackingSettings result = options.unwrap.packing;
    result.margin = std::round(result.margin);
    if (options.command != CliOptions::Command::Pack)
        result.keepScale = settings.keepScale;
    return result;
}

} // namespace

Result<Scene> BatchFiles::read(const CliOptions &options, const std::atomic<bool> *stop)
{
    if (const Result<Done> found = readFile(options, stop); !found)
        return found.error();
    if (const Result<Done> chosen = chooseUvSet(options); !chosen)
        return chosen.error();
    if (options.makeUnique)
        makeUnique();
    Scene scene = activeFirst();
    scene.notes.insert(scene.notes.end(), mNotes.begin(), mNotes.end());
    return scene;
}

Result<Done> BatchFiles::readFile(const CliOptions &options, const std::atomic<bool> *stop)
{
    const QString &path = options.input;
    // Where a map is made, OBJ files and sessions are read to their end, which is soon, so that even then
    // there is one.
    const bool baking =
        options.command == CliOptions::Command::Bake || options.command == CliOptions::Command::LightBake;
    if (!isProjectPath(path)) {
        const bool isObj = path.endsWith(QLatin1String(".obj"), Qt::CaseInsensitive);
        Result<Scene> scene =
            readMesh(path, isObj && !baking ? nullptr : stop, options.unwrap.packing.tileHeight());
        if (!scene)
            return scene.error();
        mOriginal = std::move(scene).value();
        return Done();
    }
    Result<LoadedProject> project = loadProject(path, baking ? stop : nullptr);
    if (!project)
        return project.error();
    mNotes = project->notes;
    mWarnings = project->warnings;
    mDocument = std::make_unique<Document>(std::move(project->state));
    mRecorder = std::make_unique<JournalRecorder>(*mDocument, std::move(project->extras.journal));
    return Done();
}

void BatchFiles::makeUnique()
{
    if (!hasSharedMeshes(mDocument ? mDocument->state().scene : mOriginal))
        mNotes << QStringLiteral("no objects share a mesh that could be made unique");
    else if (mDocument)
        pushCommand(std::make_unique<MakeUnique>(*mDocument));
    else
        mOriginal.uniqueMeshes = true;
}

Result<Done> BatchFiles::chooseUvSet(const CliOptions &options)
{
    if (!options.uvSet.isEmpty()) {
        const Result<int> index = jobs::findUvSet(uvSets(), options.uvSet, options.input);
        if (!index)
            return index.error();
        mActiveSet = index.value();
        if (mDocument)
            pushCommand(std::make_unique<ChooseUvSet>(*mDocument, index.value()));
    }
    const QString &name = options.newUvSet;
    if (name.isEmpty())
        return Done();
    if (uniqueUvSetName(uvSets(), name) != name)
        return Error{QStringLiteral("a new UV set cannot be called \"%1\"").arg(name), options.input, 0,
                     QStringLiteral("The name is in use or too long: choose another one, or use --uv-set")};
    if (mDocument) {
        pushCommand(std::make_unique<AddUvSet>(*mDocument, name, mDocument->activeUvSet()));
        return Done();
    }
    std::vector<UvSet> &sets = mOriginal.uvSets;
    UvSet added{name, sets.empty() ? emptyLayout(*mOriginal.mesh) : sets[mActiveSet].uv};
    mActiveSet = static_cast<int>(sets.size());
    sets.push_back(std::move(added));
    return Done();
}

const std::vector<UvSet> &BatchFiles::uvSets() const
{
    return mDocument ? mDocument->uvSets() : mOriginal.uvSets;
}

DocumentState BatchFiles::modelOf(const Scene &scene) const
{
    DocumentState model;
    model.scene = scene;
    if (mDocument)
        model.textureSets = mDocument->state().textureSets;
    return model;
}

Scene BatchFiles::activeFirst() const
{
    Scene scene = mDocument ? mDocument->state().scene : mOriginal;
    if (mDocument)
        scene.mesh = mDocument->weightedMesh();
    putFirst(scene.uvSets, activeUvSet());
    return scene;
}

Scene BatchFiles::take(std::unique_ptr<Document> document, Journal journal)
{
    mRecorder.reset();
    // The journal has the document's history already.
    mDocument = std::make_unique<Document>(document->state());
    mRecorder = std::make_unique<JournalRecorder>(*mDocument, std::move(journal));
    return activeFirst();
}

void BatchFiles::mergeSettings(CliOptions &options)
{
    if (!mDocument)
        return;
    const auto merge = [&](const char *name, auto &option, const auto &setting) {
        if (!options.given.contains(QLatin1StringView(name)))
            option = setting;
    };
    const SolveSettings &solve = mDocument->solveSettings();
    merge("--max-distortion", options.unwrap.maxDistortion, solve.maxDistortion);
    options.settings.maxDistortion = options.unwrap.maxDistortion;
    merge("--init", options.settings.start, solve.start);
    merge("--weights", options.settings.weighting, solve.weighting);
    merge("--energy", options.settings.energy, solve.energy);
    merge("--solver", options.settings.solver, solve.solver);
    merge("--seed", options.settings.seed, solve.seed);
    merge("--for", options.settings.surface, solve.surface);
    merge("--flat", options.settings.flat, solve.flat);
    merge("--alike", options.settings.alike, solve.alike);
    merge("--creases", options.settings.creases, solve.creases);
    merge("--crease-strength", options.settings.creaseStrength, solve.creaseStrength);
    merge("--visibility", options.settings.visibility, solve.visibility);
    if (!options.given.contains(QLatin1StringView("--no-symmetry")))
        merge("--symmetry", options.settings.symmetry, solve.symmetry);
    merge("--align", options.settings.align, solve.align);
    merge("--mirror", options.settings.mirrorMaps, solve.mirrorMaps);
    merge("--world-up", options.settings.worldUp, solve.worldUp);
    merge("--seams", options.settings.seams, solve.seams);
    merge("--seams-from", options.settings.givenSeams, solve.givenSeams);
    options.settings.lambda = solve.lambda;
    options.settings.delta = solve.delta;
    options.settings.boxWeight = solve.boxWeight;
    const PackingSettings &settings = mDocument->packingSettings();
    packing::PackOptions &packing = options.unwrap.packing;
    merge("--texture-size", packing.textureSize, settings.textureSize);
    merge("--texture-size", packing.textureHeight, settings.textureHeight);
    merge("--margin", packing.margin, settings.margin);
    merge("--rotation", packing.rotation, settings.rotation);
    merge("--tile-border", packing.border, settings.border);
    merge("--pack-time", packing.effort, settings.effort);
    merge("--tile", packing.udimTile, settings.udimTile);
    if (!options.hasRectangle())
        options.packIntoTile();
    if (options.command == CliOptions::Command::Pack)
        merge("--keep-scale", packing.keepScale, settings.keepScale);
    pushCommand(
        std::make_unique<ChangeSettings>(*mDocument, options.settings, packingSettingsOf(options, settings)));
}

Result<Snapshot> BatchFiles::snapshot(const Scene &scene, const SolveSettings &settings,
                                      double tileHeight) const
{
    if (settings.start == StartMode::ExistingUv && !scene.hasUv())
        return Error{QStringLiteral("the file has no UVs to start from"), scene.path, 0,
                     QStringLiteral("Use --init rigid")};
    if (mDocument)
        return makeSnapshot(*mDocument);
    Snapshot snapshot;
    snapshot.mesh = scene.mesh;
    snapshot.settings = settings;
    snapshot.tileHeight = tileHeight;
    const UvMatrix *uv = scene.hasUv() ? &scene.uvSets.front().uv : nullptr;
    if (settings.start == StartMode::ExistingUv)
        snapshot.startUv = std::make_shared<const UvMatrix>(startUvFromCorners(*scene.mesh, *uv));
    if (settings.seams != SeamMode::Free)
        snapshot.editSteering().givenSeams = givenSeams(scene, uv, {}, settings.givenSeams);
    if (uv) {
        snapshot.uv = std::make_shared<const UvMatrix>(*uv);
        snapshot.uvScale = layoutScale(*scene.mesh, *uv);
    }
    return snapshot;
}

std::vector<IslandFlags> BatchFiles::islandFlags() const
{
    if (!mNewFlags.empty())
        return mNewFlags;
    return mDocument ? mDocument->marks().faceFlags : std::vector<IslandFlags>();
}

const LayoutRectangle *BatchFiles::rectangle(const QString &name) const
{
    if (!mDocument)
        return nullptr;
    const std::vector<LayoutRectangle> &all = mDocument->constraints().rectangles;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const LayoutRectangle &r) { return r.name == name; });
    return found == all.end() ? nullptr : &*found;
}

Result<Done> BatchFiles::write(const Scene &scene, const CliOptions &options)
{
    if (isProjectPath(options.output))
        return writeSession(scene, options);
    const double tileHeight = packingSettings(options).tileHeight();
    if (mDocument && !mDocument->state().textureSets.empty())
        return writeMesh(withChosenTextures(scene, mDocument->state().textureSets), options.output,
                         tileHeight);
    return writeMesh(scene, options.output, tileHeight);
}

Result<Done> BatchFiles::writeSession(const Scene &scene, const CliOptions &options)
{
    if (!mDocument) {
        DocumentState state = DocumentState::initial(mOriginal.mesh ? mOriginal : scene);
        if (mOriginal.mesh)
            state.activeUvSet = mActiveSet;
        state.solveSettings = options.settings;
        state.packingSettings = packingSettingsOf(options, state.packingSettings);
        Result<std::unique_ptr<Document>> document = Document::create(std::move(state));
        if (!document)
            return document.error();
        mDocument = std::move(document).value();
        mRecorder = std::make_unique<JournalRecorder>(*mDocument);
    }
    if (!scene.uvSets.empty())
        pushCommand(newMapCommand(*mDocument, editOf(options.command, !options.only.isEmpty()),
                                  scene.uvSets.front().uv, std::nullopt, mNewFlags));
    ProjectExtras extras;
    extras.journal = mRecorder->journal();
    LayoutOptions layout;
    layout.size = thumbnailSize;
    layout.tileHeight = mDocument->packingSettings().tileHeight();
    if (Result<QByteArray> picture = layoutPng(mDocument->mesh(), mDocument->uv(), layout))
        extras.thumbnail = std::move(picture).value();
    const Result<SavedProject> saved = saveProject(mDocument->state(), extras, options.output);
    if (!saved)
        return saved.error();
    if (!saved->warning.isEmpty())
        mWarnings << saved->warning;
    return Done();
}

QStringList BatchFiles::losses(const Scene &scene, const QString &path)
{
    if (isProjectPath(path))
        return sessionLosses(scene);
    return certainExportLosses(scene, QFileInfo(path).suffix().toLower());
}

} // namespace autocuts
