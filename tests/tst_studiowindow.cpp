// The window at every size: what fits, what stays in sight, what is kept.
#include "support/studiosession.h"
#include "views/canvas/mapoverlays.h"
#include "views/canvas/uvview.h"
#include "views/ui/dialogsize.h"

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QScreen>
#include <QTest>
#include <QToolBar>

using namespace autocuts;
using test::StudioSession;

class TestStudioWindow : public QObject
{
    Q_OBJECT

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
        studio.action("tool.select")->trigger();
        QVERIFY(studio.window.toolBarBreak(options));
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
#include "tst_studiowindow.moc"
