#include "views/control/transferjobs.h"

#include "model/document/transferjob.h"
#include "model/io/transfersource.h"
#include "views/control/jobtexts.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace autocuts {

namespace {

Result<Done> fillSource(const TransferChoice &choice, const std::vector<UvSet> &sets, const MapInput &input,
                        JobControl &control, TransferJob &job, QStringList &warnings)
{
    if (choice.from == TransferChoice::From::File) {
        const Result<TransferSource> source =
            readTransferSource(choice.path, &control.stop(), input.packing.tileHeight());
        if (!source)
            return source.error();
        job.source = source->mesh;
        job.sourceUv = source->uv();
        job.sourceName = choice.path;
        warnings << source->warnings;
        return Done();
    }
    job.source = input.snapshot.mesh;
    job.sourceUv = input.uv;
    if (choice.from == TransferChoice::From::Object)
        job.sourceObject = choice.object;
    else if (choice.uvSet >= 0 && choice.uvSet < static_cast<int>(sets.size()))
        job.sourceUv = sets[choice.uvSet].uv;
    return Done();
}

MapJobResult transferFailed(const QString &problem)
{
    MapJobResult result;
    result.edit = UvEdit::Transfer;
    result.problem = problem;
    return result;
}

} // namespace

MapJobResult transferUvsJob(const MapInput &input, const TransferChoice &choice,
                            const std::vector<UvSet> &sets, JobControl &control)
{
    const QString stoppedText = JobTexts::tr("Cancelled: the map stays as it is");
    TransferJob job;
    QStringList warnings;
    const Result<Done> filled = fillSource(choice, sets, input, control, job, warnings);
    if (control.stop())
        return transferFailed(stoppedText);
    if (!filled)
        return transferFailed(filled.error().toString());
    job.mesh = input.snapshot.mesh;
    job.uv = input.uv;
    job.match = choice.match;
    if (choice.onlySelection) {
        job.faces.assign(static_cast<std::size_t>(job.mesh->faceCount()), false);
        for (int face : input.selectedFaces)
            job.faces[face] = true;
    }
    keepLocked(job, input.marks.faceFlags);
    const Result<TransferredUvs> made =
        runTransfer(job, {[&control] { return control.stop().load(); },
                          [&control](double fraction) { control.setProgress(fraction); }});
    if (!made)
        return transferFailed(withLosses(made.error(), warnings).toString());
    if (made->stopped)
        return transferFailed(stoppedText);
    MapJobResult result;
    result.edit = UvEdit::Transfer;
    result.uv = made->uv;
    result.message = JobTexts::tr("UVs transferred: %1").arg(made->summary());
    warnings << made->warnings();
    if (!warnings.isEmpty()) {
        result.problem = result.message + QStringLiteral(". ") + warnings.join(QStringLiteral(". "));
        result.problemItems.mode = SelectionMode::Faces;
        result.problemItems.faces = made->unmatched;
    }
    return result;
}

} // namespace autocuts
