// The main window: both views, docked panels, menus, tool bars and status bar.
#pragma once

#include "views/actions/actionregistry.h"
#include "views/canvas/toolmanager.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/pictures/livebake.h"
#include "views/control/pictures/modelpictures.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/studiocontext.h"
#include "views/control/session/workspace.h"
#include "views/link/linkcontroller.h"
#include "views/state/viewstate.h"
#include "views/ui/questions.h"

#include <QMainWindow>

#include <memory>

class QSplitter;
class QToolBar;

namespace autocuts {

class Canvas;
class MenuBuilder;
class MeshView;
class NoticeBar;
class PanelDocks;
class StatusBar;
class StudioActions;
class UvView;
enum class ViewLayout;

//! Owns all objects that exist once per window.
class MainWindow final : public QMainWindow
{
    Q_OBJECT

public:
    //! \param recoveryFolder folder of the autosaves
    //! \param questions answers questions in tests; null: dialogs ask the user
    MainWindow(Preferences &preferences, const QString &recoveryFolder,
               std::unique_ptr<Questions> questions = nullptr);
    ~MainWindow() override;

    StudioContext context();
    StudioActions &actions() { return *mStudioActions; }
    MeshView &meshView() { return *mMeshView; }
    UvView &uvView() { return *mUvView; }
    ToolManager &tools() { return mTools; }
    LinkController &link() { return *mLink; }
    //! Arranges the window as at the first start. \param space of the screen
    void arrangeFor(const QSize &space);

protected:
    bool event(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void makeViews();
    void makePanels();
    void showMenu(Canvas &canvas, const QPointF &pixel);
    void makeMenus();
    QToolBar *makeToolBar();
    void arrangeToolBars();
    void connectMessages();
    void restoreLayout();
    QDockWidget *dock(const char *name) const;
    void foldLeftPanels();
    void sizePanels();
    void fitPanels();
    void showTitle();
    void showOpened();
    void showFoundTextures();
    void showFirstMap();
    bool takesKey(const QKeyEvent &key);
    QByteArray viewStateBytes() const;
    QImage thumbnail();
    void arrangeViews(ViewLayout layout);

    Preferences &mPreferences;
    std::unique_ptr<Questions> mQuestions;
    Workspace mWorkspace;
    ShownMap mShownMap;
    ViewState mViewState;
    ActionRegistry mActions;
    SolverController mSolver;
    MapController mMap;
    FileController mFiles;
    ModelPictures mPictures;
    LiveBake mLiveBake;
    ToolManager mTools;
    std::unique_ptr<StudioActions> mStudioActions;
    std::unique_ptr<LinkController> mLink;

    NoticeBar *mNotice = nullptr;
    QSplitter *mSplitter = nullptr;
    MeshView *mMeshView = nullptr;
    UvView *mUvView = nullptr;
    StatusBar *mStatusBar = nullptr;
    QToolBar *mMainBar = nullptr, *mOptionBar = nullptr;
    int mWidestOptions = 0; //!< of the tools used so far, in pixels
    QList<QDockWidget *> mDocks;
    PanelDocks *mPanels = nullptr;
    Pattern mOtherPattern = Pattern::None; //!< when the textures of a model took its place
    bool mNearOverlap = false;             //!< the UV view was moved to an overlap
    bool mSolverRan = false;               //!< at its last change of state
    bool mAwaitsMap = false;               //!< the model was opened without a map and has none yet
    std::unique_ptr<MenuBuilder> mMenus;
    bool mNarrow = false; //!< the panels are arranged for a narrow window
    //! The arrangements of panels in wide and in narrow windows: initially, and as the user left them last.
    //! Empty: not made yet.
    QByteArray mDefaults[2], mStates[2];
};

} // namespace autocuts
