#include "views/control/mapjobs/transferjobs.h"

#include "jobs/jobtexts.h"
#include "jobs/transferuvs.h"

namespace autocuts {

MapJobResult transferUvsJob(const MapInput &input, const jobs::TransferChoice &choice,
                            const std::vector<UvSet> &sets, JobControl &control)
{
    MapJobResult result;
    result.edit = UvEdit::Transfer;
    jobs::TransferInput model;
    model.mesh = input.snapshot.mesh;
    model.uv = input.uv;
    model.uvSets = sets;
    model.faceFlags = input.marks.faceFlags;
    model.tileHeight = input.packing.tileHeight();
    if (choice.onlySelection) {
        model.faces.assign(static_cast<std::size_t>(model.mesh->faceCount()), false);
        for (const int face : input.selectedFaces)
            model.faces[std::size_t(face)] = true;
    }
    const Result<jobs::TransferOutcome> outcome = jobs::transferUvs(model, choice, contextOf(control));
    if (control.stop() || (outcome && outcome->made.stopped)) {
        result.problem = JobTexts::tr("Cancelled: the map stays as it is");
        return result;
    }
    if (!outcome) {
        result.problem = outcome.error().toString();
        return result;
    }
    result.uv = outcome->made.uv;
    result.message = JobTexts::tr("UVs transferred: %1").arg(outcome->made.summary());
    if (!outcome->warnings.empty()) {
        result.problem = result.message + QStringLiteral(". ") +
                         jobs::textsOf(outcome->warnings).join(QStringLiteral(". "));
        result.problemItems.mode = SelectionMode::Faces;
        result.problemItems.faces = outcome->made.unmatched;
    }
    return result;
}

} // namespace autocuts
