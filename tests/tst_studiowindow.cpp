// The window at every size: what fits, what stays in sight, what is kept.
#include "jobs/lightchoice.h"
#include "support/studiosession.h"
#include "views/canvas/mapoverlays.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"
#include "views/panels/noticebar.h"
#include "views/ui/dialogsize.h"

#include <QAbstractSpinBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QPushButton>
#include <QScreen>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace tst_studiowindow {

using namespace autocuts;
using test::StudioSession;

class TestStudioWindow : public QObject
{
    Q_OBJECT

    static QDockWidget *dock(const StudioSession &studio, const char *name)
    {
        return studio.window.findChild<QDockWidget *>(QLatin1StringView(name));
    }

private Q_SLOTS:
    void theWindowFitsASmallScreen()
    {
        StudioSession studio;
        // 1280 x 720, and 1920 x 1080 at twice the scale.
        QVERIFY2(studio.window.minimumSizeHint().width() <= 960,
                 qPrintable(QString::number(studio.window.minimumSizeHint().width())));
        QVERIFY2(studio.window.minimumSizeHint().height() <= 500,
                 qPrintable(QString::number(studio.window.minimumSizeHint().height())));
        Preferences preferences{studio.folder.filePath(QStringLiteral("other.ini"))};
        const MainWindow window(preferences, studio.folder.filePath(QStringLiteral("other")));
        const QSize space = window.screen()->availableSize();
        QVERIFY(window.width() < space.width() && window.height() < space.height());
        QVERIFY2(window.minimumHeight() <= 500, qPrintable(QString::number(window.minimumHeight())));
    }

    //! Narrow windows have the panels on one side, whatever the size at the start was.
    void panelsFollowTheWidth()
    {
        StudioSession studio;
        studio.window.arrangeFor({1920, 1080});
        const auto onTheLeft = [&] {
            return studio.window.dockWidgetArea(dock(studio, "history")) == Qt::LeftDockWidgetArea &&
                   !dock(studio, "history")->isHidden();
        };
        QTRY_VERIFY(onTheLeft());
        studio.window.resize(1280, 700);
        QTRY_VERIFY(!onTheLeft());
        studio.window.resize(1700, 900);
        QTRY_VERIFY(onTheLeft());
        // What was saved in a wide window is not for a narrow one.
        studio.preferences.setWindowLayout(studio.window.saveGeometry(), studio.window.saveState(0));
        MainWindow next(studio.preferences, studio.folder.filePath(QStringLiteral("next")));
        next.arrangeFor({1280, 800});
        QVERIFY(next.findChild<QDockWidget *>(QStringLiteral("history"))->isHidden());
    }

    //! Messages lie over the views, which stay where they are.
    void messagesMoveNothing()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        QVERIFY(studio.jobsRest());
        QWidget &view = studio.window.uvView();
        const auto place = [&] {
            QCoreApplication::processEvents();
            return QRect(view.mapTo(&studio.window, QPoint(0, 0)), view.size());
        };
        const QRect before = place();
        auto *notice = studio.window.findChild<NoticeBar *>();
        notice->showNotice(QStringLiteral("This could not be done. Try something else"));
        QTRY_VERIFY(notice->isVisible() && notice->height() > 10);
        QCOMPARE(place(), before);
        QCOMPARE(notice->width(), studio.window.centralWidget()->width());
        studio.window.resize(studio.window.size() + QSize(-40, 0));
        QTRY_COMPARE(notice->width(), studio.window.centralWidget()->width());
    }

    void sessionsRememberTheWatchedFile()
    {
        StudioSession studio;
        const QString model = studio.folder.filePath(QStringLiteral("cube.obj"));
        const QString session = studio.folder.filePath(QStringLiteral("cube.acproj"));
        studio.action("file.sample.bumpycube")->trigger();
        studio.context.files.exportMesh(model);
        QVERIFY(studio.jobsRest());
        studio.answers->filesToOpen = {model, session};
        studio.action("file.open")->trigger();
        QVERIFY(studio.jobsRest());
        studio.action("file.watch")->trigger();
        studio.action("file.exportAgain")->trigger();
        studio.answers->filesToSave = {session};
        studio.action("file.save")->trigger();
        studio.context.files.waitForSaves();
        studio.action("file.sample.torus")->trigger();
        QVERIFY(!studio.action("file.watch")->isChecked() && !studio.action("file.exportAgain")->isChecked());
        studio.action("file.open")->trigger();
        QVERIFY(studio.jobsRest());
        QVERIFY(studio.action("file.watch")->isChecked() && studio.action("file.exportAgain")->isChecked());
    }

    void theViewsGetTheWidth_data()
    {
        QTest::addColumn<QSize>("screen");
        QTest::addColumn<double>("share");
        QTest::newRow("1280 x 800") << QSize(1280, 800) << .6;
        QTest::newRow("1920 x 1080 at twice the scale") << QSize(960, 540) << .5;
    }

    void theViewsGetTheWidth()
    {
        QFETCH(const QSize, screen);
        QFETCH(const double, share);
        StudioSession studio;
        studio.window.arrangeFor(screen);
        const auto views = [&] { return studio.window.meshView().width() + studio.window.uvView().width(); };
        QTRY_VERIFY2(views() >= share * studio.window.width(), qPrintable(QString::number(views())));
        for (const char *name : {"view", "scene", "textures", "history", "uvSets", "doctor"})
            QVERIFY2(dock(studio, name)->isHidden(), name);
        // Opened, they take nothing from the views.
        const int before = views();
        dock(studio, "view")->toggleViewAction()->trigger();
        QTRY_VERIFY(!dock(studio, "view")->visibleRegion().isEmpty());
        QVERIFY(views() >= before - 20);
    }

    void aKeyHidesAndBringsBackAllPanels()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        dock(studio, "history")->hide();
        const auto shown = [&] {
            QStringList names;
            for (const QDockWidget *panel : studio.window.findChildren<QDockWidget *>()) {
                if (!panel->isHidden())
                    names << panel->objectName();
            }
            return names;
        };
        const QStringList before = shown();
        const int width = studio.window.uvView().width();
        QVERIFY(before.size() > 5);
        studio.window.uvView().setFocus();
        studio.press(Qt::Key_Tab);
        QCOMPARE(shown(), QStringList());
        QTRY_VERIFY(studio.window.uvView().width() > width + 200);
        studio.press(Qt::Key_Tab);
        QCOMPARE(shown(), before);
        QTRY_COMPARE(studio.window.uvView().width(), width);
        // In a panel it goes on to the next field.
        auto *const field = dock(studio, "solver")->findChild<QAbstractSpinBox *>();
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Tab);
        QVERIFY(!field->hasFocus());
        QCOMPARE(shown(), before);
        // In a list as well, but not while the mouse is over a view.
        auto *const list = dock(studio, "islands")->findChild<QTableView *>();
        for (const bool overView : {false, true}) {
            QWidget *const at = overView ? static_cast<QWidget *>(&studio.window.uvView()) : list;
            QTest::mouseMove(at);
            QTRY_COMPARE(studio.window.uvView().underMouse(), overView);
            list->setFocus();
            QTest::keyClick(list, Qt::Key_Tab);
            QCOMPARE(shown().isEmpty(), overView);
        }
    }

    void hiddenPanelsComeBackAtTheNextStart()
    {
        QTemporaryDir folder;
        Preferences preferences(folder.filePath(QStringLiteral("autocuts.ini")));
        {
            MainWindow window(preferences, folder.path(), std::make_unique<test::Answers>());
            window.show();
            window.context().actions.action("view.panels")->trigger();
            QVERIFY(window.findChild<QDockWidget *>(QStringLiteral("solver"))->isHidden());
            QVERIFY(window.close());
        }
        const MainWindow window(preferences, folder.path(), std::make_unique<test::Answers>());
        QVERIFY(!window.findChild<QDockWidget *>(QStringLiteral("solver"))->isHidden());
    }

    void tabsHaveTheirNameOnce()
    {
        StudioSession studio;
        QVERIFY(dock(studio, "islands")->titleBarWidget());
        QVERIFY(!dock(studio, "solver")->titleBarWidget());
        dock(studio, "islands")->setFloating(true);
        QTRY_VERIFY(!dock(studio, "islands")->titleBarWidget());
        for (const char *name : {"seams", "packing", "overlaps"})
            dock(studio, name)->hide();
        QTRY_VERIFY(!dock(studio, "layout")->titleBarWidget()); // no tab without another one
    }

    void buttonsOverTheViewsShowAndHide_data()
    {
        QTest::addColumn<bool ViewOptions::*>("field");
        QTest::newRow("view.wireframe") << &ViewOptions::wireframe;
        QTest::newRow("view.seams") << &ViewOptions::seams;
        QTest::newRow("view.steering") << &ViewOptions::steering;
        QTest::newRow("view.problems") << &ViewOptions::problems;
        QTest::newRow("view.grid") << &ViewOptions::grid;
        QTest::newRow("view.smoothShading") << &ViewOptions::smoothShading;
        QTest::newRow("view.orthographic") << &ViewOptions::orthographic;
        QTest::newRow("view.xray") << &ViewOptions::xray;
        QTest::newRow("view.fillIslands") << &ViewOptions::fillIslands;
        QTest::newRow("view.islandMarks") << &ViewOptions::islandMarks;
        QTest::newRow("view.islandNumbers") << &ViewOptions::islandNumbers;
        QTest::newRow("view.rulers") << &ViewOptions::rulers;
        QTest::newRow("view.followMap") << &ViewOptions::followMap;
        QTest::newRow("view.livePacking") << &ViewOptions::livePacking;
    }

    void buttonsOverTheViewsShowAndHide()
    {
        QFETCH(bool ViewOptions::*, field);
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        auto *const button = studio.window.centralWidget()->findChild<QToolButton *>(
            QLatin1StringView(QTest::currentDataTag()));
        QVERIFY(button && button->isVisible() && !button->icon().isNull());
        ViewOptions expected = studio.context.view.options();
        expected.*field = !(expected.*field);
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(studio.context.view.options() == expected);
        QCOMPARE(button->isChecked(), expected.*field);
    }

    void theFirstMapIsSeenOnACheckerboard()
    {
        StudioSession studio;
        const auto pattern = [&] { return studio.context.view.options().pattern; };
        studio.action("file.sample.machine")->trigger();
        QCOMPARE(pattern(), Pattern::None);
        studio.action("uv.unwrap")->trigger();
        QVERIFY(studio.jobsRest());
        QCOMPARE(pattern(), Pattern::Checker);
        // Only once.
        studio.action("view.pattern.none")->trigger();
        studio.action("edit.undo")->trigger();
        studio.action("edit.redo")->trigger();
        QCOMPARE(pattern(), Pattern::None);
    }

    //! What a heat-map or X-ray shows was asked of the model before; how things are drawn stays.
    void whatIsSeenBeginsAnewWithTheNextModel()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        ViewOptions options = studio.context.view.options();
        options.coloring = Coloring::Density;
        options.densityTarget = 123;
        options.xray = true;
        options.rulers = false;
        options.smoothShading = true;
        studio.context.view.setOptions(options);
        studio.action("file.sample.torus")->trigger();
        const ViewOptions next = studio.context.view.options();
        QCOMPARE(next.coloring, Coloring::Plain);
        QCOMPARE(next.densityTarget, 0.0);
        QVERIFY(!next.xray && !next.rulers && next.smoothShading);
    }

    void menusFitOnSmallScreens()
    {
        const StudioSession studio;
        for (const QMenu *menu : studio.window.menuBar()->findChildren<QMenu *>()) {
            const qsizetype rows = menu->actions().size();
            QVERIFY2(rows <= StudioSession::mostRows, qPrintable(menu->objectName() + QString::number(rows)));
        }
    }

    void nothingIsHiddenInNarrowWindows()
    {
        StudioSession studio;
        auto *const bar = studio.window.findChild<QToolBar *>(QStringLiteral("mainToolBar"));
        auto *const options = studio.window.findChild<QToolBar *>(QStringLiteral("toolOptionsBar"));
        studio.action("file.sample.bumpycube")->trigger();
        studio.action("tool.paint")->trigger();
        for (const int width : {1000, 1600, 1000}) {
            studio.window.resize(width, 700);
            QTRY_COMPARE(studio.window.width(), width);
            QTRY_COMPARE(studio.window.toolBarBreak(options), width < 1200);
            QTRY_VERIFY(bar->width() >= bar->sizeHint().width());
            QTRY_VERIFY(options->width() >= options->sizeHint().width());
        }
        // Not in turns with the tools.
        QTRY_VERIFY(options->height() > 0);
        const int height = options->height();
        for (const char *tool : {"tool.select", "tool.move", "tool.paint"}) {
            studio.action(tool)->trigger();
            QCoreApplication::processEvents();
            QVERIFY(studio.window.toolBarBreak(options));
            QTRY_COMPARE(options->height(), height);
        }
    }

    //! What is said of the map before ends with an edit, but not what that edit has ended.
    void aJobThatAnEditEndsIsMissed()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        studio.context.map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(studio.jobsRest());
        const int entries = studio.document()->undoStack().index();
        QVERIFY(entries > 0);
        studio.context.map.unwrap(unwrap::UnwrapQuality::Best);
        QTRY_VERIFY(studio.context.map.jobs().isBusy());
        studio.action("edit.undo")->trigger();
        QTRY_VERIFY(!studio.context.map.jobs().isBusy());
        const auto *notice = studio.window.findChild<NoticeBar *>();
        QTRY_VERIFY2(notice->message().contains(QStringLiteral("was ended")), qPrintable(notice->message()));
        QCOMPARE(studio.document()->undoStack().index(), entries - 1);
    }

    //! Its picture would be for a map that is not there any more.
    void aLightBakeThatAnEditEndsIsMissed()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        studio.context.map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(studio.jobsRest());
        const QTemporaryDir folder;
        jobs::LightChoice choice;
        choice.uvSet = jobs::LightChoice::newSet;
        choice.samples = 1 << 16;
        choice.path = folder.filePath(QStringLiteral("light.png"));
        studio.window.actions().bake().pictures().bakeLight(choice, {});
        QTRY_COMPARE(studio.context.map.jobs().title(), QStringLiteral("Baking light"));
        QTRY_VERIFY(studio.context.map.jobs().isBusy());
        studio.action("edit.undo")->trigger();
        QTRY_VERIFY(!studio.context.map.jobs().isBusy());
        const auto *notice = studio.window.findChild<NoticeBar *>();
        QTRY_VERIFY2(notice->message().contains(QStringLiteral("was ended")), qPrintable(notice->message()));
        QVERIFY(!QFileInfo::exists(choice.path));
    }

    //! It takes back what is under way, not what was done before.
    void undoEndsAGesture()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        studio.action("tool.paint")->trigger();
        Canvas &view = studio.window.meshView();
        QVERIFY(!view.picture().isNull());
        const QPoint middle = view.rect().center();
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, middle);
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, middle);
        const UndoStack &stack = studio.document()->undoStack();
        QCOMPARE(stack.count(), 1);
        const DocumentState painted = studio.document()->state();
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, middle + QPoint(10, 10));
        QTest::mouseMove(&view, middle + QPoint(60, 30));
        QVERIFY(studio.window.tools().tool()->isBusy());
        QVERIFY(!(studio.document()->state() == painted));
        studio.action("edit.undo")->trigger();
        QVERIFY(!studio.window.tools().tool()->isBusy());
        QVERIFY(studio.document()->state() == painted);
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, middle + QPoint(60, 30));
        QCOMPARE(stack.index(), 1);
        studio.action("edit.undo")->trigger();
        QTRY_COMPARE(stack.index(), 0);
    }

    void theWholeMapStaysInView()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        UvView &view = studio.window.uvView();
        const auto isSeen = [&](const Vec2 &place) {
            return QRectF(view.rect()).contains(view.camera().toScreen(place));
        };
        studio.window.resize(1500, 800);
        QTRY_COMPARE(studio.window.width(), 1500);
        studio.action("view.frameAll")->trigger();
        studio.window.resize(1100, 600);
        QTRY_COMPARE(studio.window.width(), 1100);
        QTRY_VERIFY(isSeen(Vec2(0, 0)) && isSeen(Vec2(1, 1)));
        // A view that the user moved stays.
        MapCamera camera = view.camera();
        camera.setScale(3 * camera.scale());
        view.setCamera(camera);
        studio.window.resize(1300, 700);
        QTRY_COMPARE(studio.window.width(), 1300);
        QCOMPARE(view.camera().scale(), camera.scale());
    }

    void rulersCutNoNumbers()
    {
        const ViewColors colors = ViewColors::of({}, true);
        MapCamera camera;
        const QSize size(300, 300);
        camera.setViewSize(size);
        const auto drawn = [&](double scale) {
            camera.setScale(scale);
            QImage image(size, QImage::Format_RGB32);
            image.fill(Qt::black);
            QPainter painter(&image);
            drawRulers(painter, image.rect(), colors, camera, 1000);
            return image;
        };
        // At the right and the upper end only marks may be, never a part of a number.
        for (double scale = 100; scale < 200; scale += 3) {
            const QImage image = drawn(scale);
            for (int i = 0; i < rulerSize - 9; ++i) {
                QCOMPARE(image.pixel(299, i), image.pixel(299, 0));
                QCOMPARE(image.pixel(i, rulerSize), image.pixel(0, rulerSize));
            }
        }
    }

    void dialogsFitOnTheScreen()
    {
        QWidget dialog;
        const QSize screen = dialog.screen()->availableSize();
        resizeOnScreen(dialog, {100000, 300});
        QVERIFY(dialog.width() < screen.width());
        QCOMPARE(dialog.height(), 300);
    }

    //! Also where the style sheet makes widgets larger, which they only know when they are shown.
    void dialogsHaveRoomForTheirContent()
    {
        QWidget dialog;
        auto *layout = new QVBoxLayout(&dialog);
        auto *button = new QPushButton(QStringLiteral("Go"));
        layout->addWidget(button);
        dialog.setStyleSheet(QStringLiteral("QPushButton { min-width: 333px; min-height: 77px; }"));
        resizeToContent(dialog);
        const QSize size = dialog.size();
        QVERIFY(size.width() > 333 && size.height() > 77);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QCOMPARE(dialog.size(), size);
        QVERIFY(button->width() >= 333 && button->height() >= 77);
    }

    void theWindowsLayoutIsKept()
    {
        QTemporaryDir folder;
        const QString ini = folder.filePath(QStringLiteral("autocuts.ini"));
        {
            Preferences preferences(ini);
            MainWindow window(preferences, folder.path(), std::make_unique<test::Answers>());
            window.show();
            QVERIFY(QTest::qWaitForWindowExposed(&window));
            window.findChild<QDockWidget *>(QStringLiteral("history"))->hide();
            QVERIFY(window.close());
        }
        Preferences preferences(ini);
        MainWindow window(preferences, folder.path(), std::make_unique<test::Answers>());
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(window.findChild<QDockWidget *>(QStringLiteral("history"))->isHidden());
        QVERIFY(!window.findChild<QDockWidget *>(QStringLiteral("solver"))->isHidden());
    }
};

QTEST_MAIN(TestStudioWindow)

} // namespace tst_studiowindow

#include "tst_studiowindow.moc"
