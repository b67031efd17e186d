// The command that takes UVs from another model, UV set or object.
#include "cli/batchscope.h"
#include "cli/mapmaking.h"
#include "jobs/othermodel.h"
#include "jobs/transferuvs.h"
#include "model/io/outputs/fileclashes.h"
#include "model/plain/uvlayout.h"

namespace autocuts {

namespace {

using From = jobs::TransferChoice::From;

//! What the options name; without a file, the sets and objects of the input.
Result<jobs::TransferChoice> choiceOf(const CliOptions &options, const BatchFiles &files, const Scene &scene)
{
    jobs::TransferChoice choice;
    choice.match = options.match;
    choice.path = options.from;
    choice.fileUvSet = options.fromUvSet;
    choice.fileObject = options.fromObject;
    if (!options.from.isEmpty())
        return choice;
    choice.from = From::UvSet;
    choice.uvSet = files.activeUvSet();
    if (!options.fromUvSet.isEmpty()) {
        const Result<int> set = jobs::findUvSet(files.uvSets(), options.fromUvSet, options.input);
        if (!set)
            return set.error();
        choice.uvSet = set.value();
    }
    if (!options.fromObject.isEmpty()) {
        const Result<int> object = jobs::findObject(scene.objectNames, options.fromObject, options.input);
        if (!object)
            return object.error();
        choice.object = object.value();
    }
    return choice;
}

} // namespace

Result<MadeMap> MapMaking::transfer(Scene &scene) const
{
    const auto scope = batchScope(mOptions, scene);
    if (!scope)
        return scope.error();
    const Result<jobs::TransferChoice> choice = choiceOf(mOptions, mFiles, scene);
    if (!choice)
        return choice.error();
    jobs::TransferInput input;
    input.mesh = scene.mesh;
    input.uv = scene.uvSets.empty() ? emptyLayout(*scene.mesh) : scene.uvSets.front().uv;
    input.uvSets = mFiles.uvSets();
    if (scope.value())
        input.faces = scope.value()->faces;
    input.faceFlags = mFiles.islandFlags();
    input.written = withTiles(mOptions.layout) + QStringList{mOptions.output, mOptions.report};
    input.tileHeight = mOptions.unwrap.packing.tileHeight();
    Result<jobs::TransferOutcome> transferred = jobs::transferUvs(input, choice.value(), mJob);
    if (!transferred)
        return transferred.error();
    MadeMap outcome;
    outcome.warnings = jobs::textsOf(transferred->warnings);
    jobs::TransferredUvs &made = transferred->made;
    if (made.stopped) {
        outcome.warnings << QStringLiteral("stopped before the UVs were transferred: the map stays as it is");
        return outcome;
    }
    if (scene.uvSets.empty())
        scene.uvSets.push_back({QStringLiteral("UVMap"), {}});
    scene.uvSets.front().uv = std::move(made.uv);
    outcome.transfer = made.figures;
    outcome.notes << made.summary();
    return outcome;
}

} // namespace autocuts
