// Where file dialogs of a session begin.
#pragma once

#include <QString>

namespace autocuts {

class Preferences;
class Workspace;

//! For new files: beside the session, beside the model where the session has no file or its folder is gone,
//! or else the folder that was used last.
QString proposedFolder(const Workspace &workspace, const Preferences &preferences);
//! For files that belong to the model, such as its textures: beside it; where it is not there,
//! proposedFolder().
QString modelFolder(const Workspace &workspace, const Preferences &preferences);
//! Whether it is a whole path to a folder that is there. Models of samples and moved sessions have none.
bool isFolder(const QString &path);

} // namespace autocuts
