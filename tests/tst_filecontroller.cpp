// Files of the studio: opened and written off the GUI thread, recovered after a crash, never half done.
#include "commands/changesettings.h"
#include "commands/editpins.h"
#include "commands/replay.h"
#include "commands/setseamstate.h"
#include "commands/setuvs.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/meshfile.h"
#include "model/plain/uvlayout.h"
#include "support/editsupport.h"
#include "support/filedesk.h"
#include "support/meshbuilders.h"

#include <QDir>
#include <QRegularExpression>

namespace tst_filecontroller {

using namespace autocuts;

namespace {

//! With edits.
struct Desk : test::FileDesk
{
    using FileDesk::FileDesk;

    void openLargeGrid() { workspace.open(std::make_unique<Document>(test::sceneOf(test::grid(200))), {}); }
    //! Cuts the edge of that number among those that are no diagonals.
    void cutAnEdge(int number = 0, quint64 gesture = 0)
    {
        int pair = 0;
        for (;; ++pair) {
            if (!document().mesh().edgePairs[static_cast<std::size_t>(pair)].diagonal && number-- == 0)
                break;
        }
        auto command =
            std::make_unique<SetSeamState>(document(), SetSeamState::Edit::Cut,
                                           cornerPairsOfEdges(document().mesh(), std::vector<int>{pair}));
        command->setGesture(gesture);
        pushCommand(std::move(command));
    }
    void pinACorner()
    {
        pushCommand(std::make_unique<EditPins>(document(), EditPins::Edit::Pin,
                                               std::vector<UvPin>{{0, {0.5, 0.5}, true, 1}}));
    }
};

} // namespace

class TestFileController : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aSampleIsSavedAndOpenedAgain()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("Сцена 1.acproj"));
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        QCOMPARE(desk.opened.count(), 1);
        desk.cutAnEdge();
        QVERIFY(desk.workspace.isModified());
        desk.files.save(path);
        QVERIFY(desk.rests());
        QVERIFY(!desk.workspace.isModified());
        QCOMPARE(desk.workspace.sessionPath(), path);
        const DocumentState saved = desk.document().state();
        desk.files.close();
        QVERIFY(!desk.workspace.document());
        desk.files.open(path);
        QVERIFY(desk.rests());
        QCOMPARE(desk.opened.count(), 2);
        QVERIFY(desk.document().state() == saved);
        QCOMPARE(desk.preferences.recentFiles(), QStringList{path});
    }

    void aFailedSaveKeepsTheOldFile()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        desk.cutAnEdge();
        desk.files.save(folder.filePath(QStringLiteral("no such folder/a.acproj")));
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), 1);
        QVERIFY(desk.workspace.isModified());
        QVERIFY(desk.workspace.sessionPath().isEmpty());
    }

    void aFailedSaveOfWhatIsSavedChangesNothing()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        desk.files.save(folder.filePath(QStringLiteral("no such folder/a.acproj")));
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), 1);
        QVERIFY(!desk.workspace.isModified());
    }

    void eventsGoOnDuringASave()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.acproj"));
        Desk desk(folder);
        desk.openLargeGrid();
        desk.cutAnEdge();
        const DocumentState saved = desk.document().state();
        QStringList order;
        connect(&desk.files, &FileController::done, this, [&] { order << QStringLiteral("saved"); });
        QMetaObject::invokeMethod(
            &desk.files,
            [&] {
                order << QStringLiteral("event");
                QVERIFY(desk.files.isSaving());
                desk.pinACorner();
            },
            Qt::QueuedConnection);
        desk.files.save(path);
        order << QStringLiteral("begun");
        QVERIFY(desk.workspace.isModified());
        QVERIFY(desk.rests());
        QCOMPARE(order,
                 (QStringList{QStringLiteral("begun"), QStringLiteral("event"), QStringLiteral("saved")}));
        // The file has the state as it was when the save began, and so has the saved mark.
        const Result<LoadedProject> loaded = loadProject(path);
        QVERIFY(loaded);
        QVERIFY(loaded->state == saved);
        QVERIFY(sameWork(replay(*loaded->extras.journal).value()->state(), saved));
        QVERIFY(desk.workspace.isModified());
        QCOMPARE(desk.document().constraints().pins.size(), std::size_t(1));
        desk.document().undoStack().undo();
        QVERIFY(!desk.workspace.isModified());
        QVERIFY(desk.document().state() == saved);
    }

    void aGestureIsNotMergedAcrossASave()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        const quint64 gesture = desk.document().undoStack().newGesture();
        desk.cutAnEdge(0, gesture);
        const Seams saved = desk.document().seams();
        desk.files.save(folder.filePath(QStringLiteral("a.acproj")));
        desk.cutAnEdge(1, gesture);
        QVERIFY(desk.rests());
        QVERIFY(desk.workspace.isModified());
        desk.document().undoStack().undo();
        QVERIFY(desk.document().seams() == saved);
        QVERIFY(!desk.workspace.isModified());
    }

    void savesKeepTheirOrder()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.acproj"));
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        std::vector<Seams> saved;
        for (int edge : {0, 1, 2}) {
            desk.cutAnEdge(edge);
            saved.push_back(desk.document().seams());
            desk.files.save(path);
        }
        QVERIFY(desk.rests());
        QCOMPARE(desk.done.count(), 3);
        QVERIFY(!desk.workspace.isModified());
        QVERIFY(loadProject(path).value().state.seams == saved[2]);
        QVERIFY(loadProject(path + QStringLiteral(".1")).value().state.seams == saved[1]);
        QVERIFY(loadProject(path + QStringLiteral(".2")).value().state.seams == saved[0]);
        // Of a failure in between only the last save counts.
        desk.cutAnEdge(3);
        desk.files.save(folder.filePath(QStringLiteral("no such folder/a.acproj")));
        desk.files.save(path);
        QVERIFY(desk.rests());
        QVERIFY(!desk.workspace.isModified());
        desk.cutAnEdge(4);
        desk.files.save(path);
        desk.cutAnEdge(5);
        desk.files.save(folder.filePath(QStringLiteral("no such folder/a.acproj")));
        QVERIFY(desk.rests());
        QVERIFY(desk.workspace.isModified());
    }

    void closingLeavesNothingToRecover()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        desk.cutAnEdge();
        desk.files.saveForRecoveryNow();
        QVERIFY(desk.files.isSaving());
        desk.files.close();
        QVERIFY(recoveryFiles(folder).empty());
        desk.files.openSample(QStringLiteral("torus"));
        desk.cutAnEdge();
        desk.files.saveForRecoveryNow();
        desk.document().undoStack().undo(); // back to what is saved
        QVERIFY(desk.rests());
        QVERIFY(recoveryFiles(folder).empty());
    }

    void theDefaultsOfThePreferencesHold()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        PreferenceValues values = desk.preferences.values();
        values.textureSize = 512;
        values.margin = 3;
        values.maxDistortion = 4.2;
        values.undoMemoryMb = 64;
        desk.preferences.setValues(values);
        desk.files.openSample(QStringLiteral("torus"));
        QCOMPARE(desk.document().packingSettings().textureSize, 512);
        QCOMPARE(desk.document().packingSettings().margin, 3);
        QCOMPARE(desk.document().solveSettings().maxDistortion, 4.2);
        QCOMPARE(desk.document().undoStack().memoryLimit(), qint64(64) * 1024 * 1024);
    }

    void savingLetsTheSolverRun()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        desk.cutAnEdge();
        desk.solver.run();
        QVERIFY(QTest::qWaitFor([&] { return desk.solver.map() != nullptr; }, test::patience));
        const QString path = folder.filePath(QStringLiteral("a.acproj"));
        const UvMatrix map = desk.solver.map()->uv;
        desk.files.save(path);
        QVERIFY(desk.solver.isRunning());
        QCOMPARE(desk.document().undoStack().count(), 1);
        QVERIFY(desk.rests());
        // The file has the map that was shown, as a last entry of the history.
        const Result<LoadedProject> loaded = loadProject(path);
        QVERIFY(loaded.ok());
        QVERIFY(sameBits(loaded->state.scene.uvSets.front().uv, map));
        const Journal &journal = *loaded->extras.journal;
        QCOMPARE(journal.commands.size(), std::size_t(2));
        QVERIFY(sameWork(replay(journal).value()->state(), loaded->state));
        QCOMPARE(desk.workspace.recorder().journal().commands.size(), std::size_t(1));
    }

    void theDistortionBudgetBelongsToTheSession()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        SolveSettings settings = desk.document().solveSettings();
        settings.maxDistortion = 4.3;
        pushCommand(std::make_unique<ChangeSettings>(desk.document(), settings));
        const QString session = folder.filePath(QStringLiteral("a.acproj"));
        desk.files.save(session);
        QVERIFY(desk.rests());
        desk.files.openSample(QStringLiteral("bumpycube"));
        QCOMPARE(desk.document().solveSettings().maxDistortion, 4.1);
        desk.files.open(session);
        QVERIFY(desk.rests());
        QCOMPARE(desk.document().solveSettings().maxDistortion, 4.3);
    }

    void aCrashedSessionComesBack()
    {
        QTemporaryDir folder;
        const QString recovery = folder.filePath(QStringLiteral("recovery"));
        const QString kept = folder.filePath(QStringLiteral("kept"));
        QVERIFY(QDir().mkpath(kept));
        DocumentState state;
        {
            Desk desk(folder);
            desk.files.openSample(QStringLiteral("torus"));
            desk.files.save(folder.filePath(QStringLiteral("a.acproj")));
            QVERIFY(desk.rests());
            desk.cutAnEdge();
            desk.files.saveForRecoveryNow();
            QVERIFY(desk.rests());
            state = desk.document().state();
            // What a crash would leave: the session ends in order here, so its file is put aside.
            const QStringList files = QDir(recovery).entryList({QStringLiteral("*.acproj")}, QDir::Files);
            QCOMPARE(files.size(), 1);
            QVERIFY(QFile::copy(recovery + QLatin1Char('/') + files.front(),
                                kept + QLatin1Char('/') + files.front()));
        }
        QVERIFY(QDir(recovery).entryList({QStringLiteral("*.acproj")}, QDir::Files).isEmpty());
        const QStringList left = QDir(kept).entryList(QDir::Files);
        QVERIFY(QFile::rename(kept + QLatin1Char('/') + left.front(),
                              recovery + QLatin1Char('/') + left.front()));

        Desk desk(folder);
        const std::vector<RecoverableSession> sessions = desk.files.recoverable();
        QCOMPARE(sessions.size(), std::size_t(1));
        QCOMPARE(sessions.front().sessionPath, folder.filePath(QStringLiteral("a.acproj")));
        desk.files.recover(sessions.front());
        QVERIFY(desk.rests());
        QCOMPARE(desk.opened.count(), 1);
        QVERIFY(desk.document().state().seams == state.seams);
        QVERIFY(desk.workspace.isModified()); // it is saved nowhere else
        QCOMPARE(desk.document().undoStack().cleanIndex(), -1);
        QCOMPARE(desk.workspace.sessionPath(), sessions.front().sessionPath);
    }

    void aSolveInProgressIsInTheRecoveryFile()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        desk.solver.run();
        QVERIFY(QTest::qWaitFor([&] { return desk.solver.status().iteration > 3; }, test::patience));
        desk.files.saveForRecoveryNow();
        desk.files.waitForSaves();
        const std::vector<QString> files = recoveryFiles(folder);
        QCOMPARE(files.size(), std::size_t(1));
        const Result<LoadedProject> project = loadProject(files.front());
        QVERIFY(project);
        QVERIFY(project->state.scene.uvSets.front().uv.allFinite());
        QVERIFY(desk.solver.isRunning());
        QVERIFY(!desk.document().uv().allFinite());
    }

    void whatASolveFoundIsSavedWhenItEnds()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        desk.solver.run();
        QVERIFY(QTest::qWaitFor([&] { return desk.solver.map() != nullptr; }, test::patience));
        desk.solver.pause();
        QVERIFY(QTest::qWaitFor([&] { return !desk.solver.isPausing(); }, test::patience));
        QTRY_COMPARE_WITH_TIMEOUT(recoveryFiles(folder).size(), std::size_t(1), test::patience);
        const Result<LoadedProject> project = loadProject(recoveryFiles(folder).front());
        QVERIFY(project);
        QVERIFY(sameBits(project->state.scene.uvSets.front().uv, desk.document().uv()));
    }

    void theHistoryComesBack()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        std::vector<DocumentState> states{desk.document().state()};
        for (int edge = 0; edge < 5; ++edge) {
            desk.cutAnEdge(5 * edge);
            states.push_back(desk.document().state());
        }
        const QString session = folder.filePath(QStringLiteral("a.acproj"));
        // Saved and opened again twice, with edits and undo between.
        for (int round = 0; round < 2; ++round) {
            desk.files.save(session);
            QVERIFY(desk.rests());
            desk.files.openSample(QStringLiteral("bumpycube"));
            desk.files.open(session);
            QVERIFY(desk.rests());
            QVERIFY(!desk.workspace.isModified());
            UndoStack &stack = desk.document().undoStack();
            QCOMPARE(stack.index(), int(states.size()) - 1);
            for (int i = stack.index() - 1; i >= 0; --i) {
                stack.undo();
                QVERIFY(sameWork(desk.document().state(), states[std::size_t(i)]));
            }
            QVERIFY(desk.workspace.isModified());
            while (stack.canRedo())
                stack.redo();
            QVERIFY(!desk.workspace.isModified());
            stack.undo();
            states.pop_back();
            desk.cutAnEdge(100);
            states.push_back(desk.document().state());
        }
    }

    void aModelIsExchanged()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        const QString changed = folder.filePath(QStringLiteral("changed.obj"));
        desk.files.exportMesh(changed);
        QVERIFY(desk.rests());
        desk.cutAnEdge();
        const Seams seams = desk.document().seams();
        desk.files.relink(changed);
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), 0);
        QVERIFY(desk.document().seams() == seams);
        QVERIFY(desk.workspace.isModified());
        QCOMPARE(desk.document().undoStack().undoText(), QStringLiteral("Re-link to changed.obj"));
        // The journal begins with the re-linked state.
        desk.cutAnEdge(1);
        const Journal journal = desk.workspace.recorder().journal();
        QCOMPARE(journal.commands.size(), std::size_t(1));
        QVERIFY(journal.initial.seams == seams);
        QVERIFY(sameWork(replay(journal).value()->state(), desk.document().state()));
        desk.document().undoStack().undo();
        desk.files.relink(folder.filePath(QStringLiteral("missing.obj")));
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), 1);
        QVERIFY(desk.document().seams() == seams);
    }

    void anExchangeIsOneEntry()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        const QString whole = folder.filePath(QStringLiteral("whole.obj"));
        desk.files.exportMesh(whole);
        QVERIFY(desk.rests());
        // An edge between faces that go.
        const MeshData &mesh = desk.document().mesh();
        int edge = 0;
        for (const EdgePair &pair : mesh.edgePairs) {
            if (!pair.diagonal && mesh.triangleFace[pair.triangle[0]] < 200 &&
                mesh.triangleFace[pair.triangle[1]] < 200)
                break;
            edge += !pair.diagonal;
        }
        desk.cutAnEdge(edge);
        // An entry about every corner of the old model, the newest one when the model is exchanged.
        UvMatrix uv(mesh.cornerCount(), 2);
        for (int c = 0; c < uv.rows(); ++c)
            uv.row(c) << 1e-4 * c, 0.5 + 1e-5 * ((7919 * c) % 1000);
        pushCommand(std::make_unique<SetUvs>(desk.document(), UvEdit::Move, uv));
        const DocumentState before = desk.document().state();
        // The first 200 faces are gone, and one is new.
        QByteArray text;
        int faces = 0;
        QFile from(whole);
        QVERIFY(from.open(QIODevice::ReadOnly));
        for (const QByteArray &line : from.readAll().split('\n')) {
            if (!line.startsWith("f ") || ++faces > 200)
                text += line + '\n';
        }
        const QString changed = folder.filePath(QStringLiteral("changed.obj"));
        QVERIFY(saveAtomically(changed, text + "v 9 9 9\nv 9 9 8\nv 9 8 9\nf -1 -2 -3\n"));

        QSignalSpy noticed(&desk.files, &FileController::noticed);
        QSignalSpy replaced(&desk.workspace, &Workspace::documentReplaced);
        desk.files.relink(changed);
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), 0);
        const DocumentState after = desk.document().state();
        QCOMPARE(after.scene.mesh->faceCount(), before.scene.mesh->faceCount() - 199);
        QCOMPARE(noticed.count(), 1);
        const QString message = noticed.first().at(0).toString();
        QVERIFY2(message.contains(u"200 of") &&
                     message.contains(QRegularExpression(QStringLiteral("new faces [^:]*: 1\\b"))),
                 qPrintable(message));
        QVERIFY2(message.contains(u"cut, joined, painted or straight edges are lost"), qPrintable(message));
        QCOMPARE(noticed.first().at(1).value<Selection>().faces.size(), 1);
        QCOMPARE(replaced.count(), 1);
        QCOMPARE(desk.document().validate(), QString());

        const auto journalIsTrue = [&] {
            const auto replayed = replay(desk.workspace.recorder().journal());
            return replayed && sameWork(replayed.value()->state(), desk.document().state());
        };
        QVERIFY(journalIsTrue());
        desk.document().undoStack().undo();
        QVERIFY(desk.document().state() == before);
        QCOMPARE(replaced.count(), 2);
        QVERIFY(journalIsTrue());
        desk.document().undoStack().undo(); // the edits of the old model
        desk.document().undoStack().undo();
        QVERIFY(desk.document().state().seams != before.seams);
        QVERIFY(!desk.document().uv().allFinite());
        QVERIFY(journalIsTrue());
        desk.document().undoStack().redo();
        desk.document().undoStack().redo();
        QVERIFY(desk.document().state() == before);
        desk.document().undoStack().redo();
        QVERIFY(desk.document().state() == after);
        desk.cutAnEdge(1);
        QVERIFY(journalIsTrue());
    }

    void anExchangeDoesNotLoseEdits()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        const QString changed = folder.filePath(QStringLiteral("changed.obj"));
        desk.files.exportMesh(changed);
        QVERIFY(desk.rests());
        desk.cutAnEdge(0);
        desk.files.relink(changed);
        desk.cutAnEdge(1);
        const DocumentState edited = desk.document().state();
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), 1);
        const auto error = desk.failed.first().first().value<Error>();
        QVERIFY2(error.message.contains(QStringLiteral("was edited")), qPrintable(error.message));
        QVERIFY(!error.remedy.isEmpty());
        QVERIFY(desk.document().state() == edited);
        QCOMPARE(desk.document().undoStack().index(), 2);
        QCOMPARE(desk.workspace.recorder().journal().commands.size(), std::size_t(2));
        // Nor does it take the place of another document, or of none.
        desk.files.relink(changed);
        desk.files.openSample(QStringLiteral("bumpycube"));
        const Document *other = desk.workspace.document();
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), 2);
        QCOMPARE(desk.workspace.document(), other);
        desk.files.relink(changed);
        desk.files.close();
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), 3);
        QVERIFY(!desk.workspace.document());
    }

    void readingCanBeCancelled()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        const QString path = folder.filePath(QStringLiteral("t.obj"));
        desk.files.exportMesh(path);
        QVERIFY(desk.rests());
        const Document *before = desk.workspace.document();
        desk.files.open(path);
        desk.files.jobs().cancel();
        QVERIFY(!desk.files.jobs().isBusy());
        QTRY_COMPARE_WITH_TIMEOUT(Task::threads(), 0, test::patience);
        QCOMPARE(desk.workspace.document(), before);
    }

private:
    static std::vector<QString> recoveryFiles(const QTemporaryDir &folder)
    {
        std::vector<QString> result;
        const QDir recovery(folder.filePath(QStringLiteral("recovery")));
        for (const QString &file : recovery.entryList({QStringLiteral("*.acproj")}, QDir::Files))
            result.push_back(recovery.filePath(file));
        return result;
    }
};

QTEST_GUILESS_MAIN(TestFileController)

} // namespace tst_filecontroller

#include "tst_filecontroller.moc"
