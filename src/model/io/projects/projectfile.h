// Session files (.acproj).
//
// A file is one CBOR map (projectblocks.h): the name and version of the format, then blocks with their own
// checksums. The blocks hold the model, every UV set at full precision, the steering, the settings, the
// selection, the view, a thumbnail and the journal. The same session always gives the same bytes.
#pragma once

#include "model/document/documentstate.h"
#include "model/document/journal.h"
#include "model/document/result.h"
#include "model/io/projects/projectblocks.h"

#include <atomic>
#include <optional>

namespace autocuts {

//! Lower-case suffix of project files.
inline constexpr const char *projectSuffix = "acproj";

//! True when the suffix of the path is that of project files, in upper or lower case.
bool isProjectPath(const QString &path);

//! The data of a session besides its state.
struct ProjectExtras
{
    std::optional<Journal> journal; //!< its scene is that of the state
    QByteArray thumbnail;           //!< PNG; may be empty
    QString sessionPath;            //!< in recovery files, the file that the user saved the session to
};

//! A session read from a file.
struct LoadedProject
{
    DocumentState state;  //!< valid
    ProjectExtras extras; //!< when there is a journal, its initial state is valid
    QStringList lost;     //!< damaged data that was left out, for example "the seams"
    QStringList warnings; //!< what the session has lost, for the user; one line each
    QStringList notes;    //!< notes for the user, the warnings first; one line each
};

//! Makes project files. Caches the compressed model, which is the largest block.
class ProjectWriter
{
public:
    QByteArray bytes(const DocumentState &state, const ProjectExtras &extras);

private:
    std::shared_ptr<const MeshData> mMesh;    //!< the mesh that mModel was made from
    std::map<QByteArray, PackedBlock> mModel; //!< its blocks by name
};

//! The result of a save that succeeded.
struct SavedProject
{
    QString warning; //!< why there is no backup of the file before; empty when there is
};

//! Saves a session and keeps two backups: PATH.1, the file before, and PATH.2, the one before that. A
//! complete file exists under the path at every moment, even when the program is killed. The backups are
//! changed when the new session is safely in place; until then the file before is also PATH.new.
Result<SavedProject> saveProject(const DocumentState &state, const ProjectExtras &extras,
                                 const QString &path);
//! Saves bytes that a ProjectWriter made.
Result<SavedProject> saveProjectBytes(const QByteArray &bytes, const QString &path);

//! Loads a session. Everything undamaged is recovered from a damaged file, unless the model is damaged.
//! \param stop ends the loading with an Error at the next step when it becomes true; null: never
Result<LoadedProject> loadProject(const QString &path, const std::atomic<bool> *stop = nullptr);
//! Loads a session from bytes in memory; `path` is used in messages.
Result<LoadedProject> parseProject(const QByteArray &bytes, const QString &path,
                                   const std::atomic<bool> *stop = nullptr);

//! What a list of sessions shows about one of them.
struct ProjectSummary
{
    QByteArray thumbnail;
    QString sessionPath;
    QString modelPath; //!< the model's file; empty for a sample
};

//! Reads the summary only.
Result<ProjectSummary> loadProjectSummary(const QString &path);

} // namespace autocuts
