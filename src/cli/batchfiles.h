// The files that a job of the command line reads and writes: meshes and sessions alike.
#pragma once

#include "cli/clioptions.h"
#include "commands/journalrecorder.h"
#include "model/document/constraints.h"
#include "model/document/islands.h"
#include "model/document/scene.h"

#include <memory>

namespace autocuts {

//! Reads the input of a job and writes its output. A session that is read keeps its steering, and on writing
//! goes on with the new UVs as one more command; a session written from a mesh begins with that mesh.
class BatchFiles
{
public:
    //! A mesh file, or a session's model with its active UV set first. What the user should know about a
    //! session is among the notes.
    Result<Scene> read(const QString &path);
    //! Goes on with a document instead of a file. \param journal leads to its present state
    Scene take(std::unique_ptr<Document> document, Journal journal);

    //! Settings of the session that was read take the place of those that were not given; those that were are
    //! put into the session. Without a session nothing happens.
    void mergeSettings(CliOptions &options);

    //! What the solver starts from: the session's steering, or none. \pre the scene is what read() gave
    Result<Snapshot> snapshot(const Scene &scene, const SolveSettings &settings) const;

    //! Texture space per solver unit of the map: the session's, or that of the UVs.
    double uvScale(const Scene &scene) const;
    //! What the session says of its islands; nothing without a session.
    IslandMarks marks(const MeshData &mesh) const;
    //! A rectangle of the session by its name; null when there is none.
    const LayoutRectangle *rectangle(const QString &name) const;

    //! Writes the scene, of which only the first UV set has changed since it was read.
    //! \param options for the settings of a new session
    Result<Done> write(const Scene &scene, const CliOptions &options);

    //! What the format of the output cannot hold, one line each.
    static QStringList losses(const Scene &scene, const QString &path);

private:
    Result<Done> writeSession(const Scene &scene, const CliOptions &options);

    Scene mOriginal;                     //!< of a mesh file, as it was read
    std::unique_ptr<Document> mDocument; //!< of a session
    std::unique_ptr<JournalRecorder> mRecorder;
};

} // namespace autocuts
