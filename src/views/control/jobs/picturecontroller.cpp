#include "views/control/jobs/picturecontroller.h"

#include "commands/edituvsets.h"
#include "model/document/makesnapshot.h"
#include "model/document/uvsetorder.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/mapjobs/mapjobs.h"
#include "views/control/mapjobs/picturejobs.h"
#include "views/control/session/workspace.h"

#include <QImage>

#include <memory>

namespace autocuts {

PictureController::PictureController(Workspace &workspace, SolverController &solver, MapController &map,
                                     QObject *parent)
    : QObject(parent), mWorkspace(workspace), mSolver(solver), mMap(map)
{}

void PictureController::bake(const jobs::BakeChoice &choice)
{
    const Document *document = mWorkspace.document();
    if (!document || document->uvSets().empty())
        return;
    mMap.startJob(tr("Baking"), [choice, model = activeFirst(document->state())](const MapInput &input,
                                                                                 JobControl &control) {
        return bakeJob(model, input, choice, control);
    });
}

void PictureController::carryTextures(const jobs::CarryChoice &choice)
{
    // The textures are for the map that a running solve leaves.
    mSolver.whenPaused([this, choice] {
        const Document *document = mWorkspace.document();
        if (!document)
            return;
        const auto given = std::make_shared<const CarryInput>(
            CarryInput{document->state(), mWorkspace.recorder().pending()});
        mMap.startJob(tr("Carrying textures over"),
                      [choice, given](const MapInput &input, JobControl &control) {
                          return carryJob(*given, input.sessionPath, choice, control);
                      });
    });
}

void PictureController::bakeLight(const jobs::LightChoice &choice, const TileReceiver &shown)
{
    mSolver.whenPaused([this, choice, shown] {
        Document *document = mWorkspace.document();
        if (!document || mMap.jobs().isBusy() || !hasUvs(*document))
            return;
        if (choice.uvSet == jobs::LightChoice::newSet) {
            mMap.addLightmapSet([this, choice, shown] { startLightBake(choice, shown, true); });
            return;
        }
        const bool other =
            choice.uvSet != document->activeUvSet() && choice.uvSet < std::ssize(document->uvSets());
        if (other)
            pushCommand(std::make_unique<ChooseUvSet>(*document, choice.uvSet));
        startLightBake(choice, shown, other);
    });
}

//! Bakes into the active UV set. \param other it is not the one that was active before: that is said
void PictureController::startLightBake(const jobs::LightChoice &choice, const TileReceiver &shown, bool other)
{
    const Document &document = *mWorkspace.document();
    // The textures of materials are for the first UV set of the file.
    const int textureSet = document.activeUvSet() == 0 ? 0 : 1;
    const QString set = other ? document.uvSets()[document.activeUvSet()].name : QString();
    mMap.startJob(
        tr("Baking light"),
        [choice, model = activeFirst(document.state()), textureSet, set, shown](const MapInput &input,
                                                                                JobControl &control) {
            MapJobResult result = lightBakeJob(model, textureSet, input, choice, shown, control);
            for (QString *text : {&result.message, &result.problem}) {
                if (!set.isEmpty() && !text->isEmpty())
                    *text = tr("%1. The UV set %2 is the active one now").arg(*text, set);
            }
            return result;
        },
        choice.uvSet == jobs::LightChoice::newSet); // without that set, the picture is for nothing
}

} // namespace autocuts
