// The studio as an artist works with it: real key and mouse events on the real window.
#include "model/document/makesnapshot.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "support/editsupport.h"
#include "support/patience.h"
#include "support/studiosession.h"
#include "views/actions/studioactions.h"
#include "views/canvas/axisgizmo.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"
#include "views/panels/noticebar.h"
#include "views/shell/startpage.h"
#include "views/shell/statusbar.h"

#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>

namespace tst_studio {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace autocuts::metrics;
using test::StudioSession;

class TestStudio : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theFirstScreenSaysWhatToDo()
    {
        StudioSession studio;
        QVERIFY(studio.document() == nullptr);
        QCOMPARE(studio.window.windowTitle(), QStringLiteral("Autocuts"));
        QVERIFY(!studio.action("file.save")->isEnabled());
        QVERIFY(!studio.action("uv.run")->isEnabled());
        QVERIFY(studio.action("file.open")->isEnabled());
    }

    void theFirstScreenOpensFiles()
    {
        StudioSession studio;
        auto *const page = studio.window.findChild<StartPage *>();
        auto *const recent = page->findChild<QListWidget *>(QStringLiteral("recentFiles"));
        QVERIFY(page->isVisible());
        QVERIFY(!recent->isVisible()); // there are none yet
        // A sample by its button, saved; the list then has it with its folder and a picture.
        auto *const sample = page->findChild<QPushButton *>(QStringLiteral("file.sample.bumpycube"));
        QTest::mouseClick(sample, Qt::LeftButton);
        QVERIFY(studio.jobsRest());
        QVERIFY(studio.document());
        QVERIFY(!page->isVisible());
        const QString path = studio.folder.filePath(QStringLiteral("first.acproj"));
        studio.context.files.save(path);
        QTRY_VERIFY(!studio.context.files.isSaving());
        studio.action("file.close")->trigger();
        QTRY_VERIFY(page->isVisible());
        QCOMPARE(page->size(), studio.window.centralWidget()->size());
        QTRY_VERIFY(recent->isVisible());
        QCOMPARE(recent->count(), 1);
        QVERIFY(recent->item(0)->text().startsWith(u"first.acproj\n"));
        QVERIFY(recent->item(0)->text().contains(QDir::toNativeSeparators(studio.folder.path())));
        QVERIFY(!recent->item(0)->icon().isNull());
        const auto middleOf = [recent] { return recent->visualItemRect(recent->item(0)).center(); };
        QTRY_VERIFY(recent->viewport()->rect().contains(middleOf()));
        // A click opens; the second one of a double click does no harm.
        const QPoint middle = middleOf();
        QTest::mouseClick(recent->viewport(), Qt::LeftButton, {}, middle);
        QTest::mouseClick(recent->viewport(), Qt::LeftButton, {}, middle);
        QTRY_VERIFY(studio.document());
        QCOMPARE(studio.context.workspace.sessionPath(), path);
        QVERIFY(!page->isVisible());
        // Files that are gone are not offered.
        studio.action("file.close")->trigger();
        QVERIFY(QFile::remove(path));
        studio.action("file.sample.torus")->trigger();
        QVERIFY(studio.jobsRest());
        studio.action("file.close")->trigger();
        QTRY_VERIFY(page->isVisible() && !recent->isVisible());
    }

    void aFieldGivesTheFocusBack()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        auto *const bound = studio.window.findChild<QDoubleSpinBox *>(QStringLiteral("bound"));
        const auto type = [&](const char *text) {
            bound->setFocus();
            bound->selectAll();
            QTest::keyClicks(bound, QLatin1StringView(text));
        };
        type("9");
        QTest::keyClick(bound, Qt::Key_Escape);
        QCOMPARE(bound->value(), 4.1);
        QCOMPARE(studio.document()->solveSettings().maxDistortion, 4.1);
        QVERIFY(!bound->hasFocus());
        type("4.2");
        QTest::keyClick(bound, Qt::Key_Return);
        QTRY_VERIFY(studio.window.focusWidget() == studio.window.findChild<UvView *>());
        QCOMPARE(studio.document()->solveSettings().maxDistortion, 4.2);
        QTest::keyClick(studio.window.focusWidget(), Qt::Key_Space);
        QVERIFY(studio.context.solver.isRunning());
        QCOMPARE(bound->value(), 4.2);
    }

    void theModelIsSeenFromItsSides()
    {
        StudioSession studio;
        studio.action("file.sample.torus")->trigger();
        QVERIFY(studio.jobsRest());
        auto *const view = studio.window.findChild<MeshView *>();
        const auto isSeenFrom = [view](ViewSide side) {
            return (view->camera().forward() + directionOf(side)).norm() < 1e-9;
        };
        view->setFocus();
        QTest::keyClick(view, Qt::Key_1, Qt::KeypadModifier);
        QVERIFY(isSeenFrom(ViewSide::Front));
        QTest::keyClick(view, Qt::Key_7, Qt::KeypadModifier | Qt::ControlModifier);
        QVERIFY(isSeenFrom(ViewSide::Bottom));
        QTest::keyClick(view, Qt::Key_5, Qt::KeypadModifier);
        QVERIFY(studio.context.view.options().orthographic);
        view->setCamera(OrbitCamera());
        const auto endOf = [view](ViewSide side) {
            for (const AxisEnd &end : axisEnds(view->rect(), view->camera())) {
                if (end.side == side)
                    return end.centre.toPoint();
            }
            return QPoint();
        };
        QTest::mouseClick(view, Qt::LeftButton, {}, endOf(ViewSide::Left));
        QVERIFY(isSeenFrom(ViewSide::Left));
        // The end that points at the viewer looks from behind; a second click at once does so, too.
        QTest::mouseDClick(view, Qt::LeftButton, {}, endOf(ViewSide::Left));
        QVERIFY(isSeenFrom(ViewSide::Right));
        QVERIFY(studio.document()->selection().isEmpty());
        QCOMPARE(studio.document()->undoStack().count(), 0);
    }

    void messagesEndWithWhatTheyAreAbout()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        studio.press(Qt::Key_U);
        QVERIFY(studio.jobsRest());
        auto *const bar = studio.window.findChild<StatusBar *>();
        QVERIFY(bar->shownText().contains(u"Unwrapped"));
        studio.action("edit.undo")->trigger();
        QVERIFY(!bar->shownText().contains(u"Unwrapped"));
        studio.press(Qt::Key_U);
        QVERIFY(studio.jobsRest());
        QVERIFY(bar->shownText().contains(u"Unwrapped"));
        studio.press(Qt::Key_Space);
        QVERIFY(studio.context.solver.isRunning());
        QVERIFY(!bar->shownText().contains(u"Unwrapped"));
        studio.press(Qt::Key_Space);
        QVERIFY(studio.solverRests());
    }

    void pointAndCommaAreDecimal_data()
    {
        QTest::addColumn<QLocale>("locale");
        QTest::newRow("English") << QLocale(QLocale::English);
        QTest::newRow("German") << QLocale(QLocale::German);
    }
    void pointAndCommaAreDecimal()
    {
        QFETCH(QLocale, locale);
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        auto *const bound = studio.window.findChild<QDoubleSpinBox *>(QStringLiteral("bound"));
        bound->setLocale(locale);
        const std::pair<const char *, double> inputs[] = {{"4.25", 4.25}, {"4,3", 4.3}};
        for (const auto &[text, value] : inputs) {
            bound->setFocus();
            bound->selectAll();
            QTest::keyClicks(bound, QLatin1StringView(text));
            QTest::keyClick(bound, Qt::Key_Return);
            QCOMPARE(studio.document()->solveSettings().maxDistortion, value);
        }
    }

    void aRightClickOffersWhatFits()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        auto *const view = studio.window.findChild<MeshView *>();
        const auto openMenu = [&]() -> QMenu * {
            QTest::mouseClick(view, Qt::RightButton, {}, view->rect().center());
            auto *const menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
            return menu && menu->objectName() == QLatin1String("contextMenu") ? menu : nullptr;
        };
        // As an entry of its own, or one menu deeper.
        const auto offers = [&](QMenu *menu, const char *id) {
            const QList<QMenu *> submenus = menu->findChildren<QMenu *>() << menu;
            return std::any_of(submenus.begin(), submenus.end(), [&](const QMenu *submenu) {
                return submenu->actions().contains(studio.action(id));
            });
        };
        // Edges: the one under the mouse is selected.
        studio.action("select.edges")->trigger();
        QTest::mouseMove(view, view->rect().center());
        studio.action("select.all")->trigger();
        QMenu *menu = openMenu();
        QVERIFY(menu);
        QVERIFY(offers(menu, "uv.cut") && !offers(menu, "uv.lock") && offers(menu, "view.frameSelected"));
        menu->close();
        studio.action("select.none")->trigger();
        studio.action("select.faces")->trigger();
        menu = openMenu();
        QVERIFY(menu);
        QCOMPARE(studio.document()->selection().faces.size(), 1);
        QVERIFY(offers(menu, "select.linked"));
        QVERIFY(!offers(menu, "uv.packSelection")); // there is no map yet
        menu->close();
        // A click on a part of the selection keeps it whole.
        studio.action("select.all")->trigger();
        const qsizetype all = studio.document()->selection().faces.size();
        menu = openMenu();
        QVERIFY(menu);
        QCOMPARE(studio.document()->selection().faces.size(), all);
        menu->close();
        // With a map there is the most to offer.
        studio.context.map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(studio.jobsRest());
        menu = openMenu();
        QVERIFY(menu);
        QVERIFY(offers(menu, "uv.packSelection") && offers(menu, "uv.lock"));
        QVERIFY2(menu->actions().size() <= StudioSession::mostRows,
                 qPrintable(QString::number(menu->actions().size())));
        menu->close();
        // A drag with the right button is none.
        QTest::mousePress(view, Qt::RightButton, {}, view->rect().center());
        QTest::mouseMove(view, view->rect().center() + QPoint(60, 0));
        QTest::mouseRelease(view, Qt::RightButton, {}, view->rect().center() + QPoint(60, 0));
        QVERIFY(!QApplication::activePopupWidget());
    }

    //! The key makes the map that the button beside the chosen quality makes.
    void theKeyUnwrapsAsThePanelSays()
    {
        StudioSession studio;
        studio.setQuality(unwrap::UnwrapQuality::Standard);
        studio.action("file.sample.bumpycube")->trigger();
        auto *const quality = studio.window.findChild<QComboBox *>(QStringLiteral("quality"));
        QVERIFY(quality);
        quality->setFocus();
        QTest::keyClick(quality, Qt::Key_Home);
        QCOMPARE(quality->currentText(), QStringLiteral("Draft"));
        studio.press(Qt::Key_U);
        QVERIFY(studio.jobsRest());
        const UvMatrix byKey = studio.document()->uv();
        QVERIFY(byKey.allFinite());
        studio.document()->undoStack().undo();
        studio.context.map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(studio.jobsRest());
        QVERIFY(studio.document()->uv() == byKey);
    }

    void anActionIsFoundByName()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        int shown = 0;
        bool uniform = true;
        studio.answers->onDialog = [&](QDialog &dialog) {
            auto *const field = dialog.findChild<QLineEdit *>();
            auto *const list = dialog.findChild<QListWidget *>();
            dialog.show();
            QTest::keyClicks(field, QStringLiteral("sel all"));
            shown = list->count();
            for (int row = 1; row < shown; ++row)
                uniform = uniform && list->sizeHintForRow(row) == list->sizeHintForRow(0);
            QTest::keyClick(field, Qt::Key_Return);
            return dialog.result();
        };
        studio.press(Qt::Key_F3);
        QVERIFY(shown >= 1 && shown < 10);
        QVERIFY(uniform);
        QVERIFY(!studio.document()->selection().isEmpty());
        // What cannot be run now is not run.
        studio.answers->onDialog = [&](QDialog &dialog) {
            dialog.show();
            QTest::keyClicks(dialog.findChild<QLineEdit *>(), QStringLiteral("pack all islands xyz"));
            QTest::keyClick(dialog.findChild<QLineEdit *>(), Qt::Key_Return);
            return dialog.result();
        };
        const int entries = studio.document()->undoStack().count();
        studio.press(Qt::Key_F3);
        QCOMPARE(studio.document()->undoStack().count(), entries);
    }

    //! Open, run, steer, pause, undo, redo, save, close, reopen, finish, pack, export.
    void aSessionFromOpenToExport()
    {
        StudioSession studio;
        const QString project = studio.folder.filePath(QStringLiteral("Würfel 1.acproj"));
        const QString mesh = studio.folder.filePath(QStringLiteral("cube with map.obj"));

        studio.action("file.sample.bumpycube")->trigger();
        QVERIFY(studio.document());
        QVERIFY(!studio.context.workspace.isModified());

        // Steer by hand while it runs.
        studio.action("uv.budget")->trigger();
        QCOMPARE(studio.context.solver.mode(), SolveMode::Manual);
        studio.press(Qt::Key_Right);
        studio.press(Qt::Key_Right);
        QVERIFY(studio.document()->solveSettings().lambda > 0);
        studio.press(Qt::Key_Space);
        QVERIFY(studio.context.solver.isRunning());
        QVERIFY(studio.runsTo(10));
        const double delta = studio.document()->solveSettings().delta;
        for (int i = 0; i < 6; ++i)
            studio.press(Qt::Key_Down);
        QCOMPARE(studio.document()->solveSettings().delta, delta / 64);
        studio.press(Qt::Key_Up);
        QCOMPARE(studio.document()->solveSettings().delta, delta / 32);
        const double lambda = studio.document()->solveSettings().lambda;
        studio.press(Qt::Key_Left);
        QVERIFY(studio.document()->solveSettings().lambda < lambda);
        QVERIFY(studio.context.solver.isRunning());
        QTRY_COMPARE_WITH_TIMEOUT(studio.context.solver.status().delta, delta / 32, test::patience);
        QVERIFY(studio.runsTo(studio.context.solver.status().iteration + 30));
        studio.press(Qt::Key_Space);
        QVERIFY(studio.solverRests());
        QVERIFY(hasUvs(*studio.document()));
        const UvMatrix settled = studio.document()->uv();

        // The run is one entry.
        studio.press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!hasUvs(*studio.document()));
        studio.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(studio.document()->uv() == settled);

        // Save, close, reopen.
        studio.answers->filesToSave << project;
        studio.press(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!studio.context.workspace.isModified(), test::patience);
        QVERIFY2(studio.answers->errors.isEmpty(),
                 qPrintable(studio.answers->errors.join(QLatin1Char('\n'))));
        const DocumentState saved = studio.document()->state();
        studio.press(Qt::Key_W, Qt::ControlModifier);
        QVERIFY(studio.document() == nullptr);
        QCOMPARE(studio.answers->unsavedAsked, 0);
        studio.answers->filesToOpen << project;
        studio.press(Qt::Key_O, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(studio.document(), test::patience);
        QVERIFY(studio.document()->uv() == settled);
        QVERIFY(studio.document()->solveSettings() == saved.solveSettings);
        QCOMPARE(studio.context.preferences.recentFiles().value(0), project);

        // Finish, pack, export.
        studio.press(Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(studio.jobsRest());
        studio.press(Qt::Key_P);
        QVERIFY(studio.jobsRest());
        QVERIFY(studio.measured());
        const UvMetrics &metrics = studio.context.map.figures()->metrics;
        QCOMPARE(metrics.flipped, 0);
        QCOMPARE(metrics.overlapPairs, 0);
        QVERIFY(metrics.inUnitSquare);
        QVERIFY(studio.context.workspace.isModified());
        studio.context.files.exportMesh(mesh);
        QVERIFY(studio.jobsRest());
        const Result<Scene> written = readMesh(mesh);
        QVERIFY(written);
        QVERIFY((written->uvSets.front().uv - studio.document()->uv()).cwiseAbs().maxCoeff() < 1e-6);

        // Leaving asks, and can be cancelled.
        studio.answers->unsaved = Questions::Unsaved::Cancel;
        QVERIFY(!studio.window.close());
        QCOMPARE(studio.answers->unsavedAsked, 1);
        studio.answers->unsaved = Questions::Unsaved::Save;
        QVERIFY(studio.window.close());
        const Result<LoadedProject> kept = loadProject(project);
        QVERIFY(kept);
        QVERIFY(kept->extras.journal.has_value());
        QVERIFY(!kept->extras.thumbnail.isEmpty());
    }

    void quittingDuringARunAsksAtOnce()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        studio.press(Qt::Key_Space);
        QVERIFY(QTest::qWaitFor([&] { return studio.context.solver.map() != nullptr; }, test::patience));
        studio.answers->unsaved = Questions::Unsaved::Cancel;
        studio.press(Qt::Key_Q, Qt::ControlModifier);
        QCOMPARE(studio.answers->unsavedAsked, 1);
        QVERIFY(studio.window.isVisible());
        QVERIFY(studio.context.solver.isRunning());
        // Saved first: what the solver has found is in the file.
        const QString path = studio.folder.filePath(QStringLiteral("quit.acproj"));
        studio.answers->filesToSave = QStringList{path};
        studio.answers->unsaved = Questions::Unsaved::Save;
        studio.press(Qt::Key_Q, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!studio.window.isVisible(), test::patience);
        QCOMPARE(studio.answers->unsavedAsked, 2);
        const Result<LoadedProject> saved = loadProject(path);
        QVERIFY(saved);
        QVERIFY(saved->state.scene.uvSets.front().uv.allFinite());
    }

    void quittingDuringARunCanDiscard()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        studio.press(Qt::Key_Space);
        QVERIFY(QTest::qWaitFor([&] { return studio.context.solver.map() != nullptr; }, test::patience));
        studio.answers->unsaved = Questions::Unsaved::Discard;
        studio.press(Qt::Key_Q, Qt::ControlModifier);
        QVERIFY(!studio.window.isVisible());
        QCOMPARE(studio.answers->unsavedAsked, 1);
    }

    void whatAJobMadeIsSavedForRecovery()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        studio.context.map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(studio.jobsRest());
        const QDir recovery(studio.folder.filePath(QStringLiteral("recovery")));
        const auto files = [&] { return recovery.entryList({QStringLiteral("*.acproj")}, QDir::Files); };
        QTRY_COMPARE_WITH_TIMEOUT(files().size(), 1, test::patience);
        const Result<LoadedProject> project = loadProject(recovery.filePath(files().front()));
        QVERIFY(project);
        QVERIFY(project->state.scene.uvSets.front().uv == studio.document()->uv());
    }

    void keysReachTheWindowFromPanels()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        for (QDockWidget *dock : studio.window.findChildren<QDockWidget *>()) {
            dock->raise();
            QCoreApplication::processEvents();
            for (QWidget *control : dock->findChildren<QWidget *>()) {
                const auto *combo = qobject_cast<QComboBox *>(control);
                const bool takesKeys = qobject_cast<QAbstractSpinBox *>(control) ||
                                       qobject_cast<QTableView *>(control) || (combo && !combo->isEditable());
                if (!takesKeys || !control->isVisible() || !control->isEnabled())
                    continue;
                control->setFocus();
                if (!control->hasFocus())
                    continue;
                QAction *const run = studio.action("uv.run");
                QObject::disconnect(run, &QAction::triggered, nullptr, nullptr);
                QSignalSpy runs(run, &QAction::triggered);
                QTest::keyClick(control, Qt::Key_Space);
                QVERIFY2(runs.count() == 1, qPrintable(dock->windowTitle() + control->objectName()));
                if (!qobject_cast<QAbstractSpinBox *>(control))
                    continue;
                QSignalSpy chosen(studio.action("tool.select"), &QAction::triggered);
                QTest::keyClick(control, Qt::Key_Q);
                QVERIFY2(chosen.count() == 1, qPrintable(dock->windowTitle() + control->objectName()));
            }
        }
    }

    void whatIsSaidOfAMapEndsWithIt()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        studio.context.map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(studio.jobsRest());
        const auto *const notice = studio.window.findChild<NoticeBar *>();
        const QString said = QStringLiteral("too much stretch");
        Q_EMIT studio.context.map.failed(said);
        QCOMPARE(notice->message(), said);
        studio.document()->undoStack().undo();
        QCOMPARE(notice->message(), QString());
        studio.document()->undoStack().redo();
        // The next job begins.
        Q_EMIT studio.context.map.failed(said);
        studio.context.map.pack(PackScope::All);
        QCOMPARE(notice->message(), QString());
        QVERIFY(studio.jobsRest());
        // A live solve begins.
        Q_EMIT studio.context.map.failed(said);
        studio.context.solver.run();
        QCOMPARE(notice->message(), QString());
        studio.context.solver.pause();
        QVERIFY(studio.solverRests());
        // What is said of a file stays.
        Q_EMIT studio.context.files.noticed(said, {});
        studio.document()->undoStack().undo();
        QCOMPARE(notice->message(), said);
    }

    void undoDuringARunTakesTheRunBack()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        studio.press(Qt::Key_Space);
        QVERIFY(studio.runsTo(10));
        // There may be nothing to undo yet but the run itself.
        studio.action("edit.undo")->trigger();
        QVERIFY(studio.solverRests());
        QTRY_VERIFY_WITH_TIMEOUT(!hasUvs(*studio.document()), test::patience);
        QVERIFY(studio.document()->undoStack().canRedo());
    }

    void filesCanBeDropped()
    {
        const QString path =
            QString::fromStdString(test::meshFolder()) + QStringLiteral("/organic/cathead.obj");
        if (!QFileInfo::exists(path))
            QSKIP(test::noMeshes);
        StudioSession studio;
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&studio.window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&studio.window, &drop);
        QTRY_VERIFY_WITH_TIMEOUT(studio.document(), test::patience);
        QVERIFY(studio.window.windowTitle().startsWith(QStringLiteral("cathead.obj")));
    }

    void aBrokenFileLosesNothing()
    {
        StudioSession studio;
        studio.action("file.sample.torus")->trigger();
        const Document *before = studio.document();
        const QString broken = studio.folder.filePath(QStringLiteral("broken.obj"));
        QFile file(broken);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("v 0 0 0\nf 1 2 3\n");
        file.close();
        studio.answers->filesToOpen << broken;
        studio.action("file.open")->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(studio.answers->errors.size(), 1, test::patience);
        QVERIFY2(studio.answers->errors.front().contains(QStringLiteral("broken.obj:2")),
                 qPrintable(studio.answers->errors.front()));
        QCOMPARE(studio.document(), before);
    }
};

QTEST_MAIN(TestStudio)

} // namespace tst_studio

#include "tst_studio.moc"
