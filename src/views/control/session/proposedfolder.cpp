#include "views/control/session/proposedfolder.h"

#include "views/control/session/workspace.h"
#include "views/ui/preferences.h"

#include <QFileInfo>

namespace autocuts {

namespace {

//! The folder of the first of these files that has one.
QString folderOf(const QStringList &files, const QString &otherwise)
{
    for (const QString &file : files) {
        if (const QString folder = QFileInfo(file).path(); isFolder(folder))
            return folder;
    }
    return otherwise;
}

QString modelPath(const Workspace &workspace)
{
    const Document *document = workspace.document();
    return document ? document->state().scene.path : QString();
}

} // namespace

bool isFolder(const QString &path)
{
    const QFileInfo info(path);
    return info.isAbsolute() && info.isDir();
}

QString proposedFolder(const Workspace &workspace, const Preferences &preferences)
{
    return folderOf({workspace.sessionPath(), modelPath(workspace)}, preferences.lastFolder());
}

QString modelFolder(const Workspace &workspace, const Preferences &preferences)
{
    return folderOf({modelPath(workspace)}, proposedFolder(workspace, preferences));
}

} // namespace autocuts
