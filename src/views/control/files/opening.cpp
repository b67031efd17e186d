#include "views/control/files/opening.h"

#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "model/layouts/meshdoctor.h"
#include "views/gl/meshdrawing.h"
#include "views/ui/preferences.h"

namespace autocuts {

namespace {

//! What takes long of a document that was read, on the thread that reads it.
std::shared_ptr<const MeshDrawing> prepared(const Document &document, const std::atomic<bool> &stop)
{
    if (stop)
        return nullptr;
    (void)document.islands(); // cached, like the next
    (void)document.soupMap();
    (void)document.adjacency();
    const Scene &scene = document.state().scene;
    return std::make_shared<const MeshDrawing>(scene.mesh, scene.hardEdges);
}

} // namespace

Result<LoadedSession> loadSession(const QString &path, QThread *thread, const std::atomic<bool> &stop)
{
    Result<LoadedProject> project = loadProject(path, &stop);
    if (!project)
        return project.error();
    const QStringList notes = project->notes + meshDoctorNotes(project->state.scene.mesh->report);
    LoadedSession loaded{
        restoredSession(std::move(project->state), std::move(project->extras.journal), thread, &stop),
        notes,
        {}};
    loaded.drawing = prepared(*loaded.session.document, stop);
    return loaded;
}

Result<NewDocument> newDocument(Scene scene, const PreferenceValues &preferences,
                                const std::function<void(DocumentState &)> &prepare)
{
    NewDocument made;
    made.notes = QStringList(scene.notes.begin(), scene.notes.end());
    made.notes += meshDoctorNotes(scene.mesh->report);
    DocumentState state = DocumentState::initial(std::move(scene));
    state.solveSettings.maxDistortion = preferences.maxDistortion;
    state.packingSettings.textureSize = preferences.textureSize;
    state.packingSettings.margin = preferences.margin;
    if (prepare)
        prepare(state);
    Result<std::unique_ptr<Document>> document = Document::create(std::move(state));
    if (!document)
        return document.error();
    made.document = std::move(document).value();
    return made;
}

Result<NewDocument> readModel(const QString &path, const PreferenceValues &preferences, QThread *thread,
                              const std::atomic<bool> &stop)
{
    Result<Scene> scene = readMesh(path, &stop);
    if (!scene)
        return scene.error();
    Result<NewDocument> made = newDocument(std::move(scene).value(), preferences);
    if (!made)
        return made;
    made->drawing = prepared(*made->document, stop);
    made->document->undoStack().moveToThread(thread);
    made->document->moveToThread(thread);
    return made;
}

} // namespace autocuts
