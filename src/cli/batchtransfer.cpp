// The command that takes UVs from another model, UV set or object.
#include "cli/batchscope.h"
#include "cli/mapmaking.h"
#include "model/document/transferjob.h"
#include "model/io/meshfile.h"
#include "model/io/projectfile.h"
#include "model/plain/uvlayout.h"

#include <algorithm>

namespace autocuts {

namespace {

//! A model with its UV sets in the order of the file.
struct SourceModel
{
    std::shared_ptr<const MeshData> mesh;
    std::vector<UvSet> uvSets;
    int activeSet = 0;
    std::vector<QString> objectNames;
    QString path;
};

Result<SourceModel> readSource(const QString &path, double tileHeight)
{
    if (isProjectPath(path)) {
        Result<LoadedProject> project = loadProject(path);
        if (!project)
            return project.error();
        Scene &scene = project->state.scene;
        return SourceModel{scene.mesh, std::move(scene.uvSets), project->state.activeUvSet,
                           std::move(scene.objectNames), path};
    }
    Result<Scene> scene = readMesh(path, nullptr, tileHeight);
    if (!scene)
        return scene.error();
    return SourceModel{scene->mesh, std::move(scene->uvSets), 0, std::move(scene->objectNames), path};
}

Result<Done> chooseFrom(const CliOptions &options, SourceModel model, TransferJob &job)
{
    if (!options.fromUvSet.isEmpty()) {
        const Result<int> set = BatchFiles::findUvSet(model.uvSets, options.fromUvSet, model.path);
        if (!set)
            return set.error();
        model.activeSet = set.value();
    }
    if (!options.fromObject.isEmpty()) {
        const auto found =
            std::find(model.objectNames.begin(), model.objectNames.end(), options.fromObject);
        if (found == model.objectNames.end())
            return Error{QStringLiteral("there is no object \"%1\"").arg(options.fromObject), model.path, 0,
                         QStringLiteral("Check its name in the file")};
        job.sourceObject = static_cast<int>(found - model.objectNames.begin());
    }
    job.source = model.mesh;
    job.sourceUv =
        model.uvSets.empty() ? emptyLayout(*model.mesh) : std::move(model.uvSets[model.activeSet].uv);
    job.sourceName = model.path;
    return Done();
}

} // namespace

Result<MadeMap> MapMaking::transfer(Scene &scene) const
{
    TransferJob job;
    job.mesh = scene.mesh;
    job.uv = scene.uvSets.empty() ? emptyLayout(*scene.mesh) : scene.uvSets.front().uv;
    job.match = mOptions.match;
    const auto scope = batchScope(mOptions, scene);
    if (!scope)
        return scope.error();
    if (scope.value())
        job.faces = scope.value()->faces;
    keepLocked(job, mFiles.islandFlags());
    Result<SourceModel> model =
        mOptions.from.isEmpty()
            ? SourceModel{scene.mesh, mFiles.uvSets(), mFiles.activeUvSet(), scene.objectNames, mOptions.input}
            : readSource(mOptions.from, mOptions.unwrap.packing.tileHeight());
    if (!model)
        return model.error();
    if (const Result<Done> chosen = chooseFrom(mOptions, std::move(model).value(), job); !chosen)
        return chosen.error();
    const Result<TransferredUvs> made = runTransfer(
        job, {[this] { return mJob.stopped(); }, [this](double fraction) { mJob.report(fraction); }});
    if (!made)
        return made.error();
    MadeMap outcome;
    if (made->stopped) {
        outcome.warnings << QStringLiteral("stopped before the UVs were transferred: the map stays as it is");
        return outcome;
    }
    if (scene.uvSets.empty())
        scene.uvSets.push_back({QStringLiteral("UVMap"), {}});
    scene.uvSets.front().uv = made->uv;
    outcome.transfer = made->figures;
    outcome.notes << made->summary();
    outcome.warnings << made->warnings();
    return outcome;
}

} // namespace autocuts
