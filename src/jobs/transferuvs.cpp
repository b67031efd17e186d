#include "jobs/transferuvs.h"

#include "jobs/jobtexts.h"
#include "jobs/othermodel.h"
#include "model/io/outputs/fileclashes.h"
#include "model/plain/uvlayout.h"

#include <algorithm>

namespace autocuts::jobs {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Takes the map and the object that a choice names from a file.
Result<Done> takeFrom(const OtherModel &file, const TransferChoice &choice, TransferJob &job)
{
    const Scene &scene = file.state.scene;
    int set = file.state.activeUvSet;
    if (!choice.fileUvSet.isEmpty()) {
        const Result<int> found = findUvSet(scene.uvSets, choice.fileUvSet, choice.path);
        if (!found)
            return withLosses(found.error(), file);
        set = found.value();
    }
    if (!choice.fileObject.isEmpty()) {
        const Result<int> found = findObject(scene.objectNames, choice.fileObject, choice.path);
        if (!found)
            return withLosses(found.error(), file);
        job.sourceObject = found.value();
    }
    job.source = scene.mesh;
    job.sourceUv = scene.uvSets.empty() ? emptyLayout(*scene.mesh) : scene.uvSets[std::size_t(set)].uv;
    job.sourceName = choice.path;
    return Done{};
}

} // namespace

Result<int> findObject(const std::vector<QString> &names, const QString &name, const QString &path)
{
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        return Error{JobTexts::tr("there is no object \"%1\"").arg(name), path, 0,
                     JobTexts::tr("Check its name in the file")};
    return static_cast<int>(found - names.begin());
}

Result<TransferOutcome> transferUvs(const TransferInput &input, const TransferChoice &choice,
                                    const JobContext &context)
{
    context.enter(JobStage::Preparing);
    TransferJob job;
    job.mesh = job.source = input.mesh;
    job.uv = job.sourceUv = input.uv;
    job.match = choice.match;
    job.faces = input.faces;
    keepLocked(job, input.faceFlags);
    TransferOutcome outcome;
    std::optional<OtherModel> file;
    if (choice.from == TransferChoice::From::File) {
        Result<OtherModel> read = readOtherModel(choice.path, input.tileHeight, context);
        if (!read)
            return read.error();
        file = std::move(read).value();
        if (const Result<Done> fine = checkOutputs(input.written, filesOfSession(file->state, choice.path));
            !fine)
            return fine.error();
        if (const Result<Done> taken = takeFrom(*file, choice, job); !taken)
            return taken.error();
        outcome.warnings = file->warnings;
    } else {
        job.sourceObject = choice.object;
        if (choice.from == TransferChoice::From::UvSet && choice.uvSet >= 0 &&
            choice.uvSet < std::ssize(input.uvSets))
            job.sourceUv = input.uvSets[std::size_t(choice.uvSet)].uv;
    }
    Result<TransferredUvs> made =
        runTransfer(job, {[&context] { return context.stopped(); },
                          [&context](double fraction) { context.report(fraction); }});
    if (!made)
        return file ? withLosses(made.error(), *file) : made.error();
    outcome.made = std::move(made).value();
    addSaid(outcome.warnings, outcome.made.warnings());
    return outcome;
}

} // namespace autocuts::jobs
