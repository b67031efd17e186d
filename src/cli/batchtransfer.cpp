// The command that takes UVs from another model, UV set or object.
#include "cli/batchscope.h"
#include "cli/mapmaking.h"
#include "cli/outputcheck.h"
#include "model/document/transferjob.h"
#include "model/io/transfersource.h"
#include "model/plain/uvlayout.h"

#include <algorithm>

namespace autocuts {

namespace {

Result<Done> chooseFrom(const CliOptions &options, TransferSource model, TransferJob &job)
{
    if (!options.fromUvSet.isEmpty()) {
        const Result<int> set = BatchFiles::findUvSet(model.uvSets, options.fromUvSet, model.path);
        if (!set)
            return set.error();
        model.activeSet = set.value();
    }
    if (!options.fromObject.isEmpty()) {
        const auto found = std::find(model.objectNames.begin(), model.objectNames.end(), options.fromObject);
        if (found == model.objectNames.end())
            return Error{QStringLiteral("there is no object \"%1\"").arg(options.fromObject), model.path, 0,
                         QStringLiteral("Check its name in the file")};
        job.sourceObject = static_cast<int>(found - model.objectNames.begin());
    }
    job.source = model.mesh;
    job.sourceUv = model.uv();
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
    Result<TransferSource> model =
        mOptions.from.isEmpty()
            ? TransferSource{scene.mesh, mFiles.uvSets(), mFiles.activeUvSet(), scene.objectNames,
                             mOptions.input}
            : readTransferSource(mOptions.from, nullptr, mOptions.unwrap.packing.tileHeight());
    if (!model)
        return model.error();
    if (const Result<Done> fine = checkClashes(mOptions, mFiles.modelOf(scene), {}, model->files); !fine)
        return fine.error();
    const QStringList sourceWarnings = model->warnings;
    if (const Result<Done> chosen = chooseFrom(mOptions, std::move(model).value(), job); !chosen)
        return withLosses(chosen.error(), sourceWarnings);
    const Result<TransferredUvs> made = runTransfer(
        job, {[this] { return mJob.stopped(); }, [this](double fraction) { mJob.report(fraction); }});
    if (!made)
        return withLosses(made.error(), sourceWarnings);
    MadeMap outcome;
    outcome.warnings << sourceWarnings;
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
