// The File menu, and the questions before unsaved work would be lost.
#pragma once

#include "model/io/projects/autosave.h"
#include "views/control/files/filewatch.h"
#include "views/control/session/studiocontext.h"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

class QMenu;

namespace autocuts {

class Document;
class MenuBuilder;
struct LayoutPicture;
class Questions;

//! The kinds of files that can be opened, as for QFileDialog.
QStringList openFilters();

//! The pictures of the document's map, one for each tile in use. \param path .png or .svg
//! \param faces per face: it is drawn; empty: all are
std::vector<LayoutPicture> layoutPictures(const Document &document, const QString &path,
                                          const std::vector<bool> &faces);

//! Opens, saves and exports files chosen by the user. Before a session is closed in any way, the solver is
//! paused and the user is asked about unsaved changes.
class FileActions final : public QObject
{
    Q_OBJECT

public:
    FileActions(const StudioContext &context, Questions &questions, QObject *parent = nullptr);

    //! Adds the recent files to their menu and keeps the menu up to date.
    void fillRecentMenu(MenuBuilder &menus);
    FileWatch &watch() { return mWatch; }
    //! Opens a mesh or a session from the command line, by drag and drop, or from the recent files. Offers
    //! what a crash has left of work on it first.
    void openFile(const QString &path);
    //! Offers to recover sessions after a crash; shows nothing when there are none.
    void offerRecovery();
    //! For the window's closeEvent. Asks at once. False when the user cancelled, or when what a running solve
    //! has found is to be saved first; the window is then closed after that.
    bool mayClose();
    //! Asks about a running job and unsaved changes before another model is opened. False: the session stays.
    //! \pre no solve runs
    bool mayLeave();
    //! Saves to the session's file, or asks for one.
    void save();
    void saveAs();

private:
    void connectActions();
    void leaveSession(const std::function<void()> &then);
    bool mayEndJob();
    bool mayLeaveChanges();
    std::optional<RecoverableSession> chosenForRecovery(const QString &path);
    void askOpen();
    void askRelink();
    void askExportAgain();
    void showWatch();
    void askChanged(const QString &path);
    void askExportMesh();
    void askExportLayout();
    void askExportReport();
    bool confirmReplacing(const std::vector<LayoutPicture> &pictures);
    void showRecent();
    QString proposedPath(const QString &suffix) const;
    void rememberFolder(const QString &path);

    StudioContext mContext;
    Questions &mQuestions;
    FileWatch mWatch;
    QMenu *mRecentMenu = nullptr;
};

} // namespace autocuts
