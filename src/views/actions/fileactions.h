// The File menu, and the questions before work would be lost.
#pragma once

#include "views/control/studiocontext.h"

#include <QObject>

#include <functional>

namespace autocuts {

class MenuBuilder;
class Questions;

//! Opens, saves and exports what the user chooses. Every way to leave a session settles the solver first and
//! asks about unsaved changes.
class FileActions final : public QObject
{
    Q_OBJECT

public:
    FileActions(const StudioContext &context, Questions &questions, QObject *parent = nullptr);

    //! Adds the recent files to their menu and keeps them.
    void fillRecentMenu(MenuBuilder &menus);
    //! Opens a mesh or a session from wherever it came: command line, drag and drop, recent files.
    void openFile(const QString &path);
    //! Offers what a crash left behind; shows nothing when there is none.
    void offerRecovery();
    //! For the window's closeEvent. False when the user cancelled, or when a solve has to be settled first:
    //! then the window is closed again once it is.
    bool mayClose();
    //! Saves under the session's own name, or asks for one.
    void save();
    void saveAs();

private:
    void connectActions();
    void leaveSession(const std::function<void()> &then);
    bool mayLeave();
    void askOpen();
    void askRelink();
    void askExportMesh();
    void askExportLayout();
    void showRecent();
    QString proposedPath(const QString &suffix) const;
    void rememberFolder(const QString &path);

    StudioContext mContext;
    Questions &mQuestions;
    class QMenu *mRecentMenu = nullptr;
};

} // namespace autocuts
