// Two windows at one session: neither replaces what the other has saved without asking.
#include "commands/changesettings.h"
#include "model/io/files/savefile.h"
#include "model/io/files/sessionlock.h"
#include "model/io/projects/projectfile.h"
#include "support/studiosession.h"
#include "views/actions/actionregistry.h"
#include "views/control/files/filecontroller.h"
#include "views/control/session/workspace.h"
#include "views/panels/noticebar.h"

#include <QAction>
#include <QFile>
#include <QProcess>
#include <QSignalSpy>
#include <QSysInfo>
#include <QTest>

#include <memory>

namespace tst_twostudios {

using namespace autocuts;
using test::StudioSession;

namespace {

using Changed = Questions::Changed;

//! A change of the session by which the tests know whose it is.
void setMargin(StudioSession &studio, double margin)
{
    PackingSettings settings = studio.document()->packingSettings();
    settings.margin = margin;
    pushCommand(std::make_unique<ChangeSettings>(*studio.document(), settings));
}

bool isSaved(StudioSession &studio)
{
    studio.context.files.waitForSaves();
    QCoreApplication::processEvents(); // questions come after the save has ended
    QCoreApplication::processEvents();
    return !studio.context.workspace.isModified();
}

double marginOnDisk(const QString &path)
{
    const Result<LoadedProject> loaded = loadProject(path);
    return loaded ? loaded->state.packingSettings.margin : -1;
}

} // namespace

class TestTwoStudios : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stampsTellFilesApart()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a"));
        const auto write = [](const QString &to, const char *text) {
            QFile file(to);
            return file.open(QIODevice::WriteOnly) && file.write(text) > 0;
        };
        QVERIFY(!FileStamp::of(path).exists());
        QVERIFY(write(path, "one"));
        const FileStamp first = FileStamp::of(path);
        QVERIFY(first.exists());
        QCOMPARE(FileStamp::of(path), first);
        QVERIFY(write(path, "longer"));
        QVERIFY(!(FileStamp::of(path) == first));
        // Another file of the same size in its place.
        const FileStamp second = FileStamp::of(path);
        QVERIFY(write(folder.filePath(QStringLiteral("b")), "longer"));
        QVERIFY(QFile::rename(path, folder.filePath(QStringLiteral("old"))));
        QVERIFY(QFile::rename(folder.filePath(QStringLiteral("b")), path));
        QVERIFY(!(FileStamp::of(path) == second));
    }

    void theSecondSaveAsks_data()
    {
        QTest::addColumn<int>("answer");
        QTest::addColumn<double>("onDisk");
        QTest::addColumn<double>("shown");
        QTest::newRow("cancel") << int(Changed::Cancel) << 7.0 << 5.0;
        QTest::newRow("overwrite") << int(Changed::Overwrite) << 5.0 << 5.0;
        QTest::newRow("save as") << int(Changed::SaveAs) << 7.0 << 5.0;
        QTest::newRow("reload") << int(Changed::Reload) << 7.0 << 7.0;
    }
    void theSecondSaveAsks()
    {
        QFETCH(int, answer);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("shared.acproj"));
        const QString other = folder.filePath(QStringLiteral("mine.acproj"));
        StudioSession first;
        first.context.files.openSample(QStringLiteral("bumpycube"));
        first.answers->filesToSave = {path};
        first.action("file.save")->trigger();
        QVERIFY(isSaved(first));
        StudioSession second;
        second.context.files.open(path);
        QVERIFY(second.jobsRest());
        QVERIFY(second.document());
        setMargin(second, 7);
        second.action("file.save")->trigger();
        QVERIFY(isSaved(second));
        QCOMPARE(second.answers->changedAsked, 0);
        // A second save of the same window is its own.
        setMargin(second, 6);
        setMargin(second, 7);
        second.action("file.save")->trigger();
        QVERIFY(isSaved(second));
        QCOMPARE(second.answers->changedAsked, 0);

        setMargin(first, 5);
        first.answers->changed = Changed(answer);
        first.answers->filesToSave = {other};
        first.action("file.save")->trigger();
        const bool saved = isSaved(first);
        QCOMPARE(first.answers->changedAsked, 1);
        QVERIFY(first.jobsRest());
        first.context.files.waitForSaves();
        QCOMPARE(saved || !first.context.workspace.isModified(), Changed(answer) != Changed::Cancel);
        QTEST(marginOnDisk(path), "onDisk");
        QTEST(first.document()->packingSettings().margin, "shown");
        QCOMPARE(QFile::exists(other), Changed(answer) == Changed::SaveAs);
        QCOMPARE(first.context.workspace.sessionPath(), Changed(answer) == Changed::SaveAs ? other : path);
        QCOMPARE(first.answers->errors, QStringList());
        // Nothing is asked again about what has been decided.
        if (Changed(answer) == Changed::Cancel)
            return;
        setMargin(first, 9);
        first.action("file.save")->trigger();
        QVERIFY(isSaved(first));
        QCOMPARE(first.answers->changedAsked, 1);
    }

    void aFileThatIsGoneIsWrittenAnew()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("gone.acproj"));
        StudioSession studio;
        studio.context.files.openSample(QStringLiteral("bumpycube"));
        studio.context.files.save(path);
        QVERIFY(isSaved(studio));
        QVERIFY(QFile::remove(path));
        setMargin(studio, 5);
        QSignalSpy done(&studio.context.files, &FileController::done);
        studio.action("file.save")->trigger();
        QVERIFY(isSaved(studio));
        QCOMPARE(studio.answers->changedAsked, 0);
        QCOMPARE(marginOnDisk(path), 5.0);
        QVERIFY2(done.last().first().toString().contains(QStringLiteral("gone")),
                 qPrintable(done.last().first().toString()));
    }

    //! The file is gone, and so would be all work.
    void closingASessionWhoseFileIsGoneAsks_data()
    {
        QTest::addColumn<int>("answer");
        QTest::addColumn<bool>("closes");
        QTest::newRow("save") << int(Questions::Unsaved::Save) << true;
        QTest::newRow("discard") << int(Questions::Unsaved::Discard) << true;
        QTest::newRow("cancel") << int(Questions::Unsaved::Cancel) << false;
    }
    void closingASessionWhoseFileIsGoneAsks()
    {
        QFETCH(int, answer);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("gone.acproj"));
        StudioSession studio;
        studio.context.files.openSample(QStringLiteral("bumpycube"));
        studio.context.files.save(path);
        QVERIFY(isSaved(studio));
        QVERIFY(QFile::remove(path));
        studio.answers->unsaved = Questions::Unsaved(answer);
        QTEST(studio.window.close(), "closes");
        QCOMPARE(studio.answers->unsavedAsked, 1);
        QCOMPARE(QFile::exists(path), Questions::Unsaved(answer) == Questions::Unsaved::Save);
    }

    //! Save, asked for at the exit, replaces no foreign change: the window stays and asks about that.
    void closingWithAForeignChange_data()
    {
        QTest::addColumn<int>("answer");
        QTest::newRow("cancel") << int(Changed::Cancel);
        QTest::newRow("overwrite") << int(Changed::Overwrite);
        QTest::newRow("reload") << int(Changed::Reload);
    }
    void closingWithAForeignChange()
    {
        QFETCH(int, answer);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("shared.acproj"));
        StudioSession first;
        first.context.files.openSample(QStringLiteral("bumpycube"));
        first.context.files.save(path);
        QVERIFY(isSaved(first));
        StudioSession second;
        second.context.files.open(path);
        QVERIFY(second.jobsRest());
        setMargin(second, 7);
        second.action("file.save")->trigger();
        QVERIFY(isSaved(second));

        setMargin(first, 5);
        first.answers->unsaved = Questions::Unsaved::Save;
        first.answers->changed = Changed(answer);
        QVERIFY(!first.window.close());
        QTRY_COMPARE(first.answers->changedAsked, 1);
        QVERIFY(first.jobsRest());
        const bool decided = isSaved(first);
        QCOMPARE(marginOnDisk(path), Changed(answer) == Changed::Overwrite ? 5.0 : 7.0);
        QCOMPARE(first.document()->packingSettings().margin, Changed(answer) == Changed::Reload ? 7.0 : 5.0);
        QCOMPARE(decided, Changed(answer) != Changed::Cancel);
        first.answers->unsaved = Questions::Unsaved::Discard;
        QVERIFY(first.window.close());
        QCOMPARE(first.answers->changedAsked, 1);
    }

    void theOtherOneIsNamed()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("shared.acproj"));
        const QString lock = folder.filePath(QStringLiteral(".shared.acproj.lock"));
        {
            StudioSession studio;
            studio.context.files.openSample(QStringLiteral("bumpycube"));
            studio.context.files.save(path);
            QVERIFY(isSaved(studio));
            QVERIFY(QFile::exists(lock));
            studio.context.files.open(path); // its own lock is no other's
            QVERIFY(studio.jobsRest());
            QVERIFY(QFile::exists(lock));
            QCOMPARE(studio.context.workspace.notes(), QStringList());
            studio.context.files.close();
            QVERIFY(!QFile::exists(lock));
        }
        // Another program, which lives.
        QProcess other;
        other.start(QStringLiteral("sleep"), {QStringLiteral("60")});
        QVERIFY(other.waitForStarted());
        QFile file(lock);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::number(other.processId()) + "\nsleep\n" +
                   QSysInfo::machineHostName().toUtf8() + '\n' + QSysInfo::machineUniqueId() + '\n' +
                   QSysInfo::bootUniqueId() + '\n');
        file.close();
        StudioSession studio;
        studio.context.files.open(path);
        QVERIFY(studio.jobsRest());
        QCOMPARE(studio.context.workspace.notes().size(), 1);
        QVERIFY2(studio.context.workspace.notes().first().contains(QStringLiteral("sleep")),
                 qPrintable(studio.context.workspace.notes().first()));
        // Where it is seen: the panel with the notes may be closed.
        const auto *notice = studio.window.findChild<NoticeBar *>();
        QVERIFY(notice->isVisible());
        QCOMPARE(notice->message(), studio.context.workspace.notes().first());
        QVERIFY(studio.measured());
        QCOMPARE(notice->message(), studio.context.workspace.notes().first());
        other.kill();
        other.waitForFinished();
        // What a crash left behind counts for nothing.
        studio.context.files.close();
        studio.context.files.open(path);
        QVERIFY(studio.jobsRest());
        QCOMPARE(studio.context.workspace.notes(), QStringList());
        QCOMPARE(notice->message(), QString());
    }

    //! Pictures of which a killed program had replaced none, beside the model that is opened.
    void whatAKilledProgramLeftIsEndedAndSaid()
    {
        const QTemporaryDir folder;
        const auto write = [&folder](const QString &name, const QByteArray &bytes) {
            return saveAtomically(folder.filePath(name), bytes).ok();
        };
        QVERIFY(write(QStringLiteral("model.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        QVERIFY(write(QStringLiteral("ao.png.12345678.new"), "new"));
        QVERIFY(
            write(QStringLiteral(".autocuts-12345678.set"), R"([{"name":"ao.png","before":"-1 0 0 0"}])"));
        StudioSession studio;
        studio.context.files.open(folder.filePath(QStringLiteral("model.obj")));
        QVERIFY(studio.jobsRest());
        QVERIFY(QFile::exists(folder.filePath(QStringLiteral("ao.png"))));
        const QString said = studio.window.findChild<NoticeBar *>()->message();
        QVERIFY2(said.contains(QStringLiteral("ao.png")), qPrintable(said));
    }
};

QTEST_MAIN(TestTwoStudios)

} // namespace tst_twostudios

#include "tst_twostudios.moc"
