#include "views/shell/mainwindow.h"

#include "model/document/makesnapshot.h"
#include "views/actions/menubuilder.h"
#include "views/actions/studioactions.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"
#include "views/link/linkbutton.h"
#include "views/panels/doctorpanel.h"
#include "views/panels/historypanel.h"
#include "views/panels/islandpanel.h"
#include "views/panels/layoutpanel.h"
#include "views/panels/noticebar.h"
#include "views/panels/overlappanel.h"
#include "views/panels/packpanel.h"
#include "views/panels/scenepanel.h"
#include "views/panels/seampanel.h"
#include "views/panels/solverpanel.h"
#include "views/panels/texturepanel.h"
#include "views/panels/uvsetpanel.h"
#include "views/panels/viewpanel.h"
#include "views/shell/contextmenu.h"
#include "views/shell/paneldocks.h"
#include "views/shell/startpage.h"
#include "views/shell/statusbar.h"
#include "views/shell/tooloptionbar.h"
#include "views/shell/viewbuttons.h"
#include "views/tools/studiotools.h"
#include "views/ui/decimalkeys.h"
#include "views/ui/icons.h"
#include "views/ui/inputguard.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"

#include <QApplication>
#include <QCborMap>
#include <QCborValue>
#include <QCloseEvent>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLayout>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSplitter>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace autocuts {

namespace {

constexpr int sessionThumbnailSide = 256; //!< pixels of the longer side
//! Pixels; in narrower windows the panels of the left begin closed (View > Panels opens them).
constexpr int leastForBothSides = 1400;

//! The path when a drag has exactly one file; empty otherwise.
QString draggedFile(const QMimeData &data)
{
    const QList<QUrl> urls = data.urls();
    return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

} // namespace

MainWindow::MainWindow(Preferences &preferences, const QString &recoveryFolder,
                       std::unique_ptr<Questions> questions)
    : mPreferences(preferences), mQuestions(questions ? std::move(questions) : std::make_unique<Questions>()),
      mShownMap(mWorkspace), mActions(preferences), mSolver(mWorkspace, mShownMap),
      mMap(mWorkspace, mSolver, mShownMap), mFiles(mWorkspace, mSolver, preferences, recoveryFolder),
      mPictures(mWorkspace, mViewState), mLiveBake(mWorkspace, mShownMap), mTools(context())
{
    mQuestions->setWindow(this);
    new DecimalKeys(this);
    addStudioTools(mTools, context());
    setWindowIcon(applicationIcon());
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    mStudioActions = std::make_unique<StudioActions>(context(), *mQuestions, mTools, recoveryFolder);
    mLink = std::make_unique<LinkController>(context(), [this] { return mStudioActions->file().mayLeave(); });
    makeViews();
    makePanels();
    makeMenus();
    connectMessages();
    auto *start = new StartPage(context(), centralWidget());
    connect(start, &StartPage::openRequested, &mStudioActions->file(), &FileActions::openFile);
    connect(&mWorkspace, &Workspace::documentReplaced, this, &MainWindow::showTitle);
    connect(&mWorkspace, &Workspace::historyChanged, this, &MainWindow::showTitle);
    connect(&mWorkspace, &Workspace::historyChanged, this, &MainWindow::showFirstMap);
    connect(&mFiles, &FileController::opened, this, &MainWindow::showOpened);
    mFiles.setThumbnailSource([this] { return thumbnail(); });
    mMap.setHiddenQuestion([this](qsizetype hidden) -> std::optional<JobReach> {
        switch (mQuestions->askHidden(hidden)) {
        case Questions::Hidden::OnlyShown:
            return JobReach::Shown;
        case Questions::Hidden::All:
            return JobReach::All;
        case Questions::Hidden::Cancel:
            break;
        }
        return std::nullopt;
    });
    mFiles.setViewStateSource([this] { return viewStateBytes(); });
    showTitle();
    restoreLayout();
}

MainWindow::~MainWindow()
{
    // Destroyed here, because QWidget's destructor would delete panels and views after the members that they
    // use.
    for (QDockWidget *dock : mDocks)
        delete dock;
    delete mStatusBar;
    mLink.reset(); // it answers programs about a document that is still there
    delete mSplitter;
}

StudioContext MainWindow::context()
{
    return {mWorkspace, mShownMap, mViewState, mPreferences, mSolver,
            mMap,       mFiles,    mActions,   mPictures,    mLiveBake};
}

void MainWindow::makeViews()
{
    const StudioContext canvas = context();
    mSplitter = new QSplitter(this);
    mSplitter->setObjectName(QStringLiteral("views"));
    mMeshView = new MeshView(canvas, mTools, mSplitter);
    mUvView = new UvView(canvas, mTools, mSplitter);
    addViewButtons(*mMeshView, *mUvView, mActions);
    mUvView->setEmptyHint([this] {
        return tr("%1 makes one, %2 solves live")
            .arg(mActions.nameWithKeys("uv.unwrap"), mActions.nameWithKeys("uv.run"));
    });
    mSplitter->setSizes({1000, 1000});
    mSplitter->setChildrenCollapsible(false);
    auto *centre = new QWidget;
    auto *column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(mSplitter);
    mNotice = new NoticeBar(mWorkspace, centre);
    setCentralWidget(centre);
    // What gives the focus back to the middle gives it to the view that had it last, as long as there are
    // views.
    centre->setFocusProxy(mUvView);
    connect(qApp, &QApplication::focusChanged, mSplitter, [this, centre](QWidget *, QWidget *now) {
        if (now == mMeshView || now == mUvView)
            centre->setFocusProxy(now);
    });

    for (Canvas *view : std::initializer_list<Canvas *>{mMeshView, mUvView}) {
        view->setCover(mNotice);
        connect(mNotice, &NoticeBar::placed, view, qOverload<>(&QWidget::update));
        connect(view, &Canvas::menuRequested, this,
                [this, view](const QPointF &pixel) { showMenu(*view, pixel); });
    }

    ViewActions &view = mStudioActions->view();
    connect(&view, &ViewActions::layoutChosen, this, &MainWindow::arrangeViews);
    const auto frameBoth = [this](void (Canvas::*frame)()) {
        (mMeshView->*frame)();
        (mUvView->*frame)();
    };
    connect(&view, &ViewActions::frameAll, this, [=] { frameBoth(&Canvas::frameAll); });
    connect(&view, &ViewActions::lookFrom, mMeshView, &MeshView::lookFrom);
    connect(&view, &ViewActions::frameSelected, this, [=] { frameBoth(&Canvas::frameSelection); });
}

void MainWindow::showMenu(Canvas &canvas, const QPointF &pixel)
{
    selectUnderMouse(context(), canvas, canvas.pick(pixel));
    auto *menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("contextMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillContextMenu(*menu, context());
    menu->popup(canvas.mapToGlobal(pixel.toPoint()));
}

void MainWindow::makePanels()
{
    const StudioContext studio = context();
    const auto add = [this](const char *name, const QString &title, QWidget *panel, Qt::DockWidgetArea area) {
        auto *dock = new QDockWidget(title, this);
        dock->setObjectName(QLatin1String(name));
        dock->setWidget(panel);
        addDockWidget(area, dock);
        mDocks.append(dock);
        return dock;
    };
    QDockWidget *view = add("view", tr("View"), new ViewPanel(studio), Qt::LeftDockWidgetArea);
    QDockWidget *scene =
        add("scene", tr("Scene"), new ScenePanel(studio, *mQuestions), Qt::LeftDockWidgetArea);
    QDockWidget *history = add("history", tr("History"), new HistoryPanel(studio), Qt::LeftDockWidgetArea);
    auto *doctorPanel = new DoctorPanel(studio);
    QDockWidget *doctor = add("doctor", tr("Mesh doctor"), doctorPanel, Qt::LeftDockWidgetArea);
    connect(doctorPanel, &DoctorPanel::frameSelectionRequested, mActions.action("view.frameSelected"),
            &QAction::trigger);
    QDockWidget *uvSets = add("uvSets", tr("UV sets"), new UvSetPanel(studio), Qt::LeftDockWidgetArea);
    auto *solverPanel = new SolverPanel(studio, *mQuestions);
    add("solver", tr("Unwrap"), solverPanel, Qt::RightDockWidgetArea);
    connect(solverPanel, &SolverPanel::said, this,
            [this](const QString &message) { mStatusBar->showText(message); });
    QDockWidget *islands = add("islands", tr("Islands"), new IslandPanel(studio), Qt::RightDockWidgetArea);
    QDockWidget *arranging = add("layout", tr("Layout"), new LayoutPanel(studio), Qt::RightDockWidgetArea);
    QDockWidget *seams = add("seams", tr("Seams"), new SeamPanel(studio), Qt::RightDockWidgetArea);
    QDockWidget *packing = add("packing", tr("Packing"), new PackPanel(studio), Qt::RightDockWidgetArea);
    auto *texturePanel = new TexturePanel(studio, *mQuestions);
    QDockWidget *textures = add("textures", tr("Textures"), texturePanel, Qt::LeftDockWidgetArea);
    connect(texturePanel, &TexturePanel::said, this,
            [this](const QString &message) { mStatusBar->showText(message); });
    auto *overlapPanel = new OverlapPanel(studio);
    QDockWidget *overlaps = add("overlaps", tr("Overlaps"), overlapPanel, Qt::RightDockWidgetArea);
    connect(overlapPanel, &OverlapPanel::frameSelectionRequested, this, [this] {
        mUvView->frameSelection();
        mNearOverlap = true;
    });
    // A new map may have nothing where the view looked at an overlap.
    connect(&mMap, &MapController::done, this, [this] {
        if (std::exchange(mNearOverlap, false))
            mUvView->frameAll();
    });

    tabifyDockWidget(view, scene);
    tabifyDockWidget(scene, textures);
    view->raise();
    tabifyDockWidget(history, uvSets);
    tabifyDockWidget(uvSets, doctor);
    history->raise();
    tabifyDockWidget(islands, arranging);
    tabifyDockWidget(arranging, seams);
    tabifyDockWidget(seams, packing);
    tabifyDockWidget(packing, overlaps);
    islands->raise();
    resizeDocks({view, history}, {560, 340}, Qt::Vertical);
    mPanels = new PanelDocks(*this, mDocks);

    mStatusBar = new StatusBar(studio, this);
    setStatusBar(mStatusBar);
    mStatusBar->addPermanentWidget(new LinkButton(*mLink));
    connect(&mTools, &ToolManager::hintChanged, mStatusBar, &StatusBar::setHint);
}

void MainWindow::makeMenus()
{
    mMenus = std::make_unique<MenuBuilder>(mActions, *menuBar());
    mStudioActions->file().fillRecentMenu(*mMenus);
    QMenu *panels = mMenus->menu(QStringLiteral("View/Panels"));
    QAction *const before = panels->actions().value(0);
    mPanels->addTo(*panels, before, mActions);

    QToolBar *const bar = mMainBar = addToolBar(tr("Main tool bar"));
    bar->setObjectName(QStringLiteral("mainToolBar"));
    bar->setMovable(false);
    fillToolBar(mActions, *bar);
    QToolBar *const options = mOptionBar = new ToolOptionBar(context(), mTools);
    options->setObjectName(QStringLiteral("toolOptionsBar"));
    options->setMovable(false);
    addToolBar(options);
    connect(&mTools, &ToolManager::toolChanged, this, &MainWindow::arrangeToolBars);
    for (QToolBar *toolBar : {bar, options, makeToolBar()}) {
        panels->insertAction(before, toolBar->toggleViewAction());
        mActions.addOther(toolBar->toggleViewAction(), panels->objectName());
    }
    // Added to the window so that all shortcuts work wherever the focus is, also when the menu bar is hidden.
    addActions(QList<QAction *>(mActions.actions().begin(), mActions.actions().end()));
    connect(&mStudioActions->view(), &ViewActions::togglePanels, mPanels, &PanelDocks::toggle);
    connect(&mStudioActions->view(), &ViewActions::resetPanels, this,
            [this] { restoreState(mDefaults[mNarrow]); });
    connect(mActions.action("view.fullScreen"), &QAction::toggled, this,
            [this](bool full) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, full)); });
}

//! The options get a row of their own in a window too narrow for those of a tool that was used, as high as
//! the highest of them, so that nothing is hidden and the views do not jump with every tool.
void MainWindow::arrangeToolBars()
{
    if (!mOptionBar)
        return;
    mWidestOptions = std::max(mWidestOptions, mOptionBar->sizeHint().width());
    mOptionBar->setMinimumHeight(std::max(mOptionBar->minimumHeight(), mOptionBar->sizeHint().height()));
    const bool fits = mMainBar->sizeHint().width() + mWidestOptions <= width();
    if (fits == !toolBarBreak(mOptionBar))
        return;
    if (fits)
        removeToolBarBreak(mOptionBar);
    else
        insertToolBarBreak(mOptionBar);
}

//! The tool bar beside the views. An action "tool.x" activates the tool "x".
QToolBar *MainWindow::makeToolBar()
{
    auto *bar = new QToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("toolsToolBar"));
    bar->setMovable(false);
    addToolBar(Qt::LeftToolBarArea, bar);
    for (QAction *action : mActions.actions()) {
        const ActionInfo &info = mActions.info(action);
        if (QLatin1String(info.group) != QLatin1String("tool"))
            continue;
        bar->addAction(action);
        const QString tool = QString::fromLatin1(info.id).section(QLatin1Char('.'), 1);
        connect(action, &QAction::triggered, this, [this, tool] { mTools.choose(tool); });
    }
    const auto showTool = [this] {
        const QString id = QStringLiteral("tool.") + mTools.tool()->id();
        mActions.action(id.toLatin1().constData())->setChecked(true);
    };
    connect(&mTools, &ToolManager::toolChanged, this, showTool);
    showTool();
    return bar;
}

void MainWindow::connectMessages()
{
    const auto say = [this](const QString &message) { mStatusBar->showText(message); };
    // What an earlier job did is not what the map is now.
    const auto forget = [this] { mStatusBar->showText({}); };
    connect(&mWorkspace, &Workspace::historyChanged, this, forget);
    connect(&mMap, &MapController::done, this, say);
    // What took long to make is not to be lost.
    connect(&mMap, &MapController::done, &mFiles, &FileController::saveChangesForRecovery);
    connect(&mMap, &MapController::failed, &mFiles, &FileController::saveChangesForRecovery);
    connect(&mStudioActions->islands(), &IslandActions::said, this, say);
    connect(&mSolver, &SolverController::said, this, say);
    connect(&mFiles, &FileController::done, this, say);
    connect(mLink.get(), &LinkController::said, this, say);
    connect(mLink.get(), &LinkController::failed, mNotice,
            [this](const Error &error) { mNotice->showNotice(error.toString()); });
    // What is said of a map or a job ends with that map, or when the next job begins.
    const auto ofMap = std::make_shared<bool>(false);
    const auto showOfMap = [this, ofMap](const QString &message, const Selection &items) {
        *ofMap = true;
        mNotice->showNotice(message, items);
    };
    const auto endOfMap = [this, ofMap] {
        if (std::exchange(*ofMap, false))
            mNotice->showNotice({});
    };
    connect(&mMap, &MapController::failed, mNotice, showOfMap);
    connect(&mMap, &MapController::done, mNotice, [this] { mNotice->showNotice({}); });
    connect(&mMap.jobs(), &JobRunner::busyChanged, mNotice, [this, endOfMap] {
        if (mMap.jobs().isBusy())
            endOfMap();
    });
    connect(&mWorkspace, &Workspace::changed, mNotice, endOfMap);
    connect(&mSolver, &SolverController::stateChanged, this, [this, forget, endOfMap] {
        const bool ran = std::exchange(mSolverRan, mSolver.isRunning());
        if (ran || !mSolverRan)
            return;
        forget();
        endOfMap();
    });
    connect(&mSolver, &SolverController::foundProblems, mNotice, showOfMap);
    connect(&mSolver, &SolverController::failed, mNotice, [this](const QString &message) {
        mNotice->showNotice(tr("The solver stopped: %1").arg(message));
    });
    connect(&mFiles, &FileController::noticed, mNotice, &NoticeBar::showNotice);
    connect(&mPictures, &ModelPictures::noticed, mNotice,
            [this](const QString &message) { mNotice->showNotice(message); });
    connect(&mFiles, &FileController::failed, this,
            [this](const Error &error) { mQuestions->showError(error); });
}

void MainWindow::arrangeFor(const QSize &space)
{
    // The panels need less room since they are tabs.
    layout()->activate();
    if (mDefaults[0].isEmpty())
        mDefaults[0] = saveState();
    // As large as the screen allows, with room for the frame of the window.
    resize(QSize(1680, 960).boundedTo(0.94 * space));
    mNarrow = width() < leastForBothSides;
    if (mNarrow)
        foldLeftPanels();
    sizePanels();
    mDefaults[mNarrow] = saveState();
    mPanels->setVersion(mNarrow);
}

//! In narrow windows the views get the larger part, too: the panels of the left are closed, and opened they
//! are tabs on the right.
void MainWindow::foldLeftPanels()
{
    for (QDockWidget *left : mDocks) {
        if (dockWidgetArea(left) != Qt::LeftDockWidgetArea)
            continue;
        tabifyDockWidget(dock("overlaps"), left);
        left->hide();
    }
    dock("islands")->raise();
}

QDockWidget *MainWindow::dock(const char *name) const
{
    return findChild<QDockWidget *>(QLatin1String(name));
}

void MainWindow::sizePanels()
{
    resizeDocks({dock("view"), dock("solver")},
                {std::min(290, width() * 22 / 100), std::min(370, width() * 40 / 100)}, Qt::Horizontal);
    // What the Unwrap panel needs while its advanced part is folded; the panels below get the rest.
    const int unwrapHeight = std::min(490, height() * 65 / 100);
    resizeDocks({dock("solver"), dock("islands")}, {unwrapHeight, height() - unwrapHeight}, Qt::Vertical);
}

//! Arranges the panels for the width that the window has now. Narrow and wide windows have an arrangement
//! each.
void MainWindow::fitPanels()
{
    const bool narrow = width() < leastForBothSides;
    if (!mPanels || mDefaults[0].isEmpty() || narrow == mNarrow || !mPanels->isAnyShown())
        return;
    mStates[mNarrow] = saveState();
    mNarrow = narrow;
    mPanels->setVersion(narrow);
    if (!mStates[narrow].isEmpty()) {
        restoreState(mStates[narrow]);
        return;
    }
    if (!mDefaults[narrow].isEmpty())
        restoreState(mDefaults[narrow]);
    else
        foldLeftPanels();
    sizePanels();
    mDefaults[narrow] = saveState();
}

void MainWindow::restoreLayout()
{
    arrangeFor(screen()->availableSize());
    restoreGeometry(mPreferences.windowGeometry());
    fitPanels();
    restoreState(mPreferences.windowState(), mNarrow); // the screen may have been another one
}

void MainWindow::showTitle()
{
    const QString name = mWorkspace.name();
    setWindowTitle(name.isEmpty() ? tr("Autocuts") : tr("%1[*] - Autocuts").arg(name));
    setWindowModified(mWorkspace.isModified());
    setWindowFilePath(mWorkspace.sessionPath());
}

void MainWindow::showOpened()
{
    const QCborMap saved = QCborValue::fromCbor(mWorkspace.document()->viewState()).toMap();
    if (saved.contains(QStringLiteral("options")))
        mViewState.setOptions(ViewOptions::fromCbor(saved.value(QStringLiteral("options")).toMap()));
    else
        showFoundTextures();
    if (const QCborValue bake = saved.value(QStringLiteral("bake")); bake.isMap())
        mStudioActions->bake().setChoice(jobs::BakeChoice::fromCbor(bake.toMap()));
    if (const QCborValue light = saved.value(QStringLiteral("light")); light.isMap())
        mStudioActions->bake().setLight(jobs::LightChoice::fromCbor(light.toMap()));
    mStudioActions->file().watch().restore(saved.value(QStringLiteral("watch")).toMap());
    mAwaitsMap = !hasUvs(*mWorkspace.document());
    mMeshView->restoreViewState(saved.value(QStringLiteral("mesh")).toMap());
    mUvView->restoreViewState(saved.value(QStringLiteral("uv")).toMap());
    mStatusBar->showText(mWorkspace.notes().isEmpty()
                             ? tr("Opened %1").arg(mWorkspace.name())
                             : tr("Opened %1: see the mesh doctor").arg(mWorkspace.name()));
    if (mPreferences.values().solveOnOpen && mAwaitsMap)
        mSolver.run();
}

//! Colours, limits and X-ray were chosen for the model before. The pattern that the user chose comes back
//! with a model without textures.
void MainWindow::showFoundTextures()
{
    ViewOptions options = mViewState.options();
    options.coloring = Coloring::Plain;
    options.xray = false;
    options.shownChannel = -1;
    options.densityTarget = 0;
    const bool found = mPreferences.values().showTextures && mPictures.count() > 0;
    const bool shown = options.pattern == Pattern::Materials || options.pattern == Pattern::Physical;
    if (found && !shown)
        mOtherPattern = options.pattern;
    if (found)
        options.pattern = mPictures.hasSets() ? Pattern::Physical : Pattern::Materials;
    else if (shown)
        options.pattern = mOtherPattern;
    mViewState.setOptions(options);
}

//! The first map of a model is seen on a checkerboard, unless another pattern is chosen.
void MainWindow::showFirstMap()
{
    if (!mAwaitsMap || !mWorkspace.document() || !hasUvs(*mWorkspace.document()))
        return;
    mAwaitsMap = false;
    ViewOptions options = mViewState.options();
    if (options.pattern == Pattern::None)
        options.pattern = Pattern::Checker;
    mViewState.setOptions(options);
}

QByteArray MainWindow::viewStateBytes() const
{
    QCborMap map;
    map[QStringLiteral("options")] = mViewState.options().toCbor();
    map[QStringLiteral("mesh")] = mMeshView->viewState();
    map[QStringLiteral("uv")] = mUvView->viewState();
    map[QStringLiteral("bake")] = mStudioActions->bake().choice().toCbor();
    map[QStringLiteral("watch")] = mStudioActions->file().watch().toCbor();
    if (const jobs::LightChoice *light = mStudioActions->bake().light())
        map[QStringLiteral("light")] = light->toCbor();
    return map.toCborValue().toCbor();
}

QImage MainWindow::thumbnail()
{
    return mMeshView->picture().scaled(sessionThumbnailSide, sessionThumbnailSide, Qt::KeepAspectRatio,
                                       Qt::SmoothTransformation);
}

void MainWindow::arrangeViews(ViewLayout layout)
{
    mMeshView->setVisible(layout != ViewLayout::OnlyUv);
    mUvView->setVisible(layout != ViewLayout::Only3d);
    if (layout != ViewLayout::Both)
        centralWidget()->setFocusProxy(mMeshView->isHidden() ? static_cast<QWidget *>(mUvView) : mMeshView);
}

bool MainWindow::event(QEvent *event)
{
    // Comes here when nothing that has the focus wants the key.
    if (event->type() == QEvent::ShortcutOverride && takesKey(*static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    return QMainWindow::event(event);
}

//! True for a key that is not to trigger an action. A key whose action is disabled says why.
bool MainWindow::takesKey(const QKeyEvent &key)
{
    // In a field, and away from the views, Tab goes on to the next one.
    const bool overView = mMeshView->underMouse() || mUvView->underMouse();
    if (key.key() == Qt::Key_Tab && (!overView || isField(focusWidget())) &&
        !qobject_cast<const Canvas *>(focusWidget()))
        return true;
    // Keys of the tool work wherever the focus is, as those of actions do; the view gets the focus back.
    if (const AbstractTool *tool = mTools.tool(); tool && mWorkspace.document() && tool->wantsKey(key) &&
                                                  !qobject_cast<const Canvas *>(focusWidget())) {
        centralWidget()->setFocus();
        return true;
    }
    const QAction *action = mActions.disabledActionOf(QKeySequence(key.keyCombination()));
    if (action && !key.isAutoRepeat())
        mStatusBar->showText(actionTitle(mActions.info(action)) + QStringLiteral(": ") +
                             mActions.whyDisabled(action));
    return false;
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!mStudioActions->file().mayClose()) {
        event->ignore();
        return;
    }
    mPreferences.setWindowLayout(saveGeometry(), mPanels->arrangement());
    mFiles.close();
    event->accept();
}

void MainWindow::resizeEvent(QResizeEvent *event)
{
    QMainWindow::resizeEvent(event);
    fitPanels();
    arrangeToolBars(); // arrangements of panels hold those of tool bars, too
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event)
{
    if (!draggedFile(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent *event)
{
    const QString file = draggedFile(*event->mimeData());
    if (file.isEmpty())
        return;
    event->acceptProposedAction();
    mStudioActions->file().openFile(file);
}

} // namespace autocuts
