// Sessions as files: .acproj.
//
// One CBOR map (projectblocks.h) with the format's name and version, then blocks with a checksum each: the
// model itself, every UV set at full precision, the steering, the settings, the selection, the view, a
// thumbnail and the journal. The same session gives the same bytes.
#pragma once

#include "model/document/documentstate.h"
#include "model/document/journal.h"
#include "model/document/result.h"
#include "model/io/projectblocks.h"

#include <optional>

namespace autocuts {

//! Suffix of project files, lower case.
inline constexpr const char *projectSuffix = "acproj";

//! True when the path's suffix is that of project files, in any case.
bool isProjectPath(const QString &path);

//! What a session holds besides its state.
struct ProjectExtras
{
    std::optional<Journal> journal; //!< its scene is that of the state
    QByteArray thumbnail;           //!< PNG, may be empty
    QString sessionPath;            //!< in recovery files: the file that the user knows the session by
};

//! A session as read.
struct LoadedProject
{
    DocumentState state;  //!< valid
    ProjectExtras extras; //!< a journal begins with a valid state
    QStringList lost;     //!< what was damaged and has been left out: "the seams", ...
    QStringList notes;    //!< what the user should know, `lost` included; one line each
};

//! Makes project files. Keeps the packed model, the largest part, for the next time.
class ProjectWriter
{
public:
    QByteArray bytes(const DocumentState &state, const ProjectExtras &extras);

private:
    std::shared_ptr<const MeshData> mMesh; //!< that mModel was made from
    PackedBlock mModel;
};

//! Saves a session. The file and its two backups, PATH.1 (the one before) and PATH.2, are changed so that at
//! every moment, also when the program is killed, the file is there and whole.
Result<Done> saveProject(const DocumentState &state, const ProjectExtras &extras, const QString &path);
//! The same for bytes that a ProjectWriter made.
Result<Done> saveProjectBytes(const QByteArray &bytes, const QString &path);

//! Opens a session. Of a damaged file everything that is whole is given back, unless the model is damaged.
Result<LoadedProject> loadProject(const QString &path);
//! The same from bytes in memory; `path` is for messages.
Result<LoadedProject> parseProject(const QByteArray &bytes, const QString &path);

//! What a list of sessions shows.
struct ProjectSummary
{
    QByteArray thumbnail;
    QString sessionPath;
};

//! Reads only the summary.
Result<ProjectSummary> loadProjectSummary(const QString &path);

} // namespace autocuts
