#include "model/io/transfersource.h"

#include "model/document/documentstate.h"
#include "model/io/fileclashes.h"
#include "model/io/meshfile.h"
#include "model/io/projectfile.h"
#include "model/plain/uvlayout.h"

#include <QFileInfo>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

UvMatrix TransferSource::uv() const
{
    return uvSets.empty() ? emptyLayout(*mesh) : uvSets[activeSet].uv;
}

QStringList lossesOf(const QString &path, const QStringList &warnings)
{
    QStringList losses;
    for (const QString &warning : warnings)
        losses << QFileInfo(path).fileName() + u": "_s + warning;
    return losses;
}

Error withLosses(Error error, const QStringList &losses)
{
    if (!losses.isEmpty())
        error.message += u" ("_s + losses.join(u"; "_s) + u')';
    return error;
}

Result<TransferSource> readTransferSource(const QString &path, const std::atomic<bool> *stop,
                                          double tileHeight)
{
    if (isProjectPath(path)) {
        Result<LoadedProject> project = loadProject(path, stop);
        if (!project)
            return project.error();
        QStringList files = filesOfSession(project->state, path);
        Scene &scene = project->state.scene;
        return TransferSource{scene.mesh,
                              std::move(scene.uvSets),
                              project->state.activeUvSet,
                              std::move(scene.objectNames),
                              path,
                              lossesOf(path, project->warnings),
                              std::move(files)};
    }
    Result<Scene> scene = readMesh(path, stop, tileHeight);
    if (!scene)
        return scene.error();
    DocumentState model;
    model.scene = std::move(scene).value();
    QStringList files = filesOfSession(model, path);
    return TransferSource{
        model.scene.mesh, std::move(model.scene.uvSets), 0, std::move(model.scene.objectNames), path, {},
        std::move(files)};
}

} // namespace autocuts
