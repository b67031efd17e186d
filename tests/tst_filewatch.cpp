// The model's file, watched: saves of other programs re-link the model, once each, and nothing else does.
#include "commands/editpins.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/meshfile.h"
#include "support/editsupport.h"
#include "support/filedesk.h"
#include "views/control/files/filewatch.h"

#include <QFile>
#include <QSemaphore>

namespace tst_filewatch {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! A row of quads with UVs. \param height of their upper side
QByteArray strip(int quads, double height = 1)
{
    QByteArray text = "mtllib none.mtl\no Strip\n";
    for (int n = 0; n <= quads; ++n) {
        const QByteArray x = QByteArray::number(n);
        text += "v " + x + " 0 0\nv " + x + ' ' + QByteArray::number(height) + " 0\n";
        text += "vt " + QByteArray::number(n / 64.0) + " 0\nvt " + QByteArray::number(n / 64.0) + " 0.1\n";
    }
    for (int n = 0; n < quads; ++n) {
        text += 'f';
        for (int v : {2 * n + 1, 2 * n + 3, 2 * n + 4, 2 * n + 2})
            text += ' ' + QByteArray::number(v) + '/' + QByteArray::number(v);
        text += '\n';
    }
    return text;
}

//! Writes into the file itself, as programs do that know no better.
void saveInPlace(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("the file cannot be written");
}

//! A desk with an open model that is watched.
struct Watched
{
    QTemporaryDir folder;
    QString path = folder.filePath(u"model.obj"_s);
    test::FileDesk desk{folder};
    JobRunner jobs;
    FileWatch watch{desk.workspace, desk.solver, desk.files, jobs};
    QSignalSpy noticed{&desk.files, &FileController::noticed};
    QSignalSpy ended{&desk.files, &FileController::relinkEnded};

    explicit Watched(const FileWatch::Choice &choice = {true, false})
    {
        saveInPlace(path, strip(2));
        desk.files.open(path);
        if (!desk.rests() || desk.opened.count() != 1)
            qFatal("the model cannot be opened");
        watch.setChoice(choice);
    }
    int faces() { return desk.document().mesh().faceCount(); }
    //! True when the model becomes that of so many faces.
    bool becomes(int count)
    {
        return QTest::qWaitFor([&] { return faces() == count; }, test::patience);
    }
    //! The number of re-links.
    int entries() { return desk.document().undoStack().index(); }
};

} // namespace

class TestFileWatch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aSaveIsRelinked_data();
    void aSaveIsRelinked();
    void whatIsLostIsSaid();
    void ourOwnFilesCountForNothing();
    void aBrokenFile();
    void itIsExportedAgain();
    void notBesideAnotherFile();
    void itWaitsForJobs();
    void itPausesASolve();
    void editsWhileTheFileIsRead();
    void notWatched();
    void itIsRemembered();
    void savedWhileTheSessionWasClosed();
    void whereItIsExported();
};

void TestFileWatch::aSaveIsRelinked_data()
{
    QTest::addColumn<int>("way");
    QTest::newRow("in place") << 0;
    QTest::newRow("by another file that takes its place") << 1;
    QTest::newRow("removed and made anew") << 2;
    QTest::newRow("in pieces") << 3;
}

void TestFileWatch::aSaveIsRelinked()
{
    QFETCH(int, way);
    Watched watched;
    for (int quads = 3; quads < 5; ++quads) { // a file that took its place is watched, too
        const QByteArray text = strip(quads);
        if (way == 0)
            saveInPlace(watched.path, text);
        if (way == 1)
            QVERIFY(saveAtomically(watched.path, text));
        if (way == 2) {
            QVERIFY(QFile::remove(watched.path));
            saveInPlace(watched.path, text);
        }
        if (way == 3) {
            QFile file(watched.path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            for (qsizetype at = 0; at < text.size(); at += 40) {
                file.write(text.mid(at, 40));
                file.flush();
                QCoreApplication::processEvents();
            }
        }
        QVERIFY(watched.becomes(quads));
        QCOMPARE(watched.entries(), quads - 2);
    }
    QCOMPARE(watched.desk.failed.count(), 0);
    // UVs are kept, and undo brings the old model back.
    QVERIFY(watched.desk.document().uvSets().front().uv.topRows(8).allFinite());
    watched.desk.document().undoStack().undo();
    QCOMPARE(watched.faces(), 3);
    QCOMPARE(watched.ended.count(), 2);
}

void TestFileWatch::whatIsLostIsSaid()
{
    Watched watched;
    const UvMatrix before = watched.desk.document().uvSets().front().uv;
    saveInPlace(watched.path, strip(1));
    QVERIFY(watched.becomes(1));
    QCOMPARE(watched.noticed.count(), 1);
    QVERIFY(watched.noticed.first().first().toString().contains(u"model.obj"_s));
    QCOMPARE(UvMatrix(watched.desk.document().uvSets().front().uv), UvMatrix(before.topRows(4)));
}

void TestFileWatch::ourOwnFilesCountForNothing()
{
    Watched watched;
    watched.desk.files.exportMesh(watched.path);
    QVERIFY(watched.desk.rests());
    QCOMPARE(watched.desk.failed.count(), 0);
    // What another program saves after it is the only thing that is noticed.
    saveInPlace(watched.path, strip(3));
    QVERIFY(watched.becomes(3));
    QCOMPARE(watched.ended.count(), 1);
}

void TestFileWatch::aBrokenFile()
{
    Watched watched;
    saveInPlace(watched.path, "this is no model\n");
    QTRY_COMPARE(watched.desk.failed.count(), 1);
    const auto error = watched.desk.failed.first().first().value<Error>();
    QCOMPARE(error.file, watched.path);
    QVERIFY(!error.remedy.isEmpty());
    QCOMPARE(watched.faces(), 2);
    QVERIFY(watched.watch.choice().watches);
    saveInPlace(watched.path, strip(3));
    QVERIFY(watched.becomes(3));
    QCOMPARE(watched.desk.failed.count(), 1);
}

void TestFileWatch::itIsExportedAgain()
{
    Watched watched({true, true});
    const QString written = watched.folder.filePath(u"model_uv.obj"_s);
    QCOMPARE(watched.watch.exportPath(), written);
    QSignalSpy wrote(&watched.desk.files, &FileController::wrote);
    for (int quads = 3; quads < 5; ++quads) {
        saveInPlace(watched.path, strip(quads));
        QTRY_COMPARE(wrote.count(), quads - 2);
        const Result<Scene> scene = readMesh(written);
        QVERIFY(scene.ok());
        QCOMPARE(scene->mesh->faceCount(), quads);
        QVERIFY(scene->hasUv());
    }
    QCOMPARE(watched.ended.count(), 2);
    QCOMPARE(watched.faces(), 4);
}

//! The user was asked about the neighbour of one file. That of another is not replaced.
void TestFileWatch::notBesideAnotherFile()
{
    Watched watched({true, true});
    const QString other = watched.folder.filePath(u"other.obj"_s);
    const QString neighbour = watched.folder.filePath(u"other_uv.obj"_s);
    saveInPlace(other, strip(3));
    saveInPlace(neighbour, "# precious\n");
    watched.desk.files.relink(other);
    QVERIFY(watched.becomes(3));
    QTRY_VERIFY(!watched.watch.choice().exports);
    QVERIFY(watched.watch.choice().watches);
    QFile file(neighbour);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), "# precious\n");
}

void TestFileWatch::itWaitsForJobs()
{
    Watched watched;
    QSemaphore mayEnd;
    QStringList order;
    QVERIFY(watched.jobs.start(
        u"Job"_s, [&mayEnd](JobControl &) { return mayEnd.tryAcquire(1, test::patience); },
        [&order](bool) { order << u"job"_s; }));
    connect(&watched.desk.files, &FileController::relinkEnded, this, [&order] { order << u"re-link"_s; });
    QFileSystemWatcher other({watched.path});
    QSignalSpy seen(&other, &QFileSystemWatcher::fileChanged);
    saveInPlace(watched.path, strip(3));
    QTRY_VERIFY(seen.count() > 0);
    QCOMPARE(watched.faces(), 2);
    mayEnd.release();
    QVERIFY(watched.becomes(3));
    QCOMPARE(order, (QStringList{u"job"_s, u"re-link"_s}));
}

void TestFileWatch::itPausesASolve()
{
    Watched watched;
    watched.desk.solver.run();
    QVERIFY(watched.desk.solver.isRunning());
    saveInPlace(watched.path, strip(3));
    QVERIFY(watched.becomes(3));
    QVERIFY(!watched.desk.solver.isRunning());
    QCOMPARE(watched.desk.failed.count(), 0);
}

//! They are not lost, and nothing is refused.
void TestFileWatch::editsWhileTheFileIsRead()
{
    Watched watched;
    connect(&watched.desk.files.jobs(), &JobRunner::busyChanged, this, [&watched] {
        if (watched.desk.files.jobs().isBusy() && watched.entries() == 0)
            pushCommand(std::make_unique<EditPins>(watched.desk.document(), EditPins::Edit::Pin,
                                                   std::vector<UvPin>{{0, {0.5, 0.5}, true, 1}}));
    });
    saveInPlace(watched.path, strip(3));
    QVERIFY(watched.becomes(3));
    QCOMPARE(watched.desk.failed.count(), 0);
    QCOMPARE(watched.ended.count(), 2);
    QCOMPARE(watched.desk.document().constraints().pins.size(), std::size_t(1));
    QCOMPARE(watched.entries(), 2);
}

void TestFileWatch::notWatched()
{
    Watched watched;
    watched.watch.setChoice({});
    saveInPlace(watched.path, strip(5));
    watched.watch.setChoice({true, false});
    saveInPlace(watched.path, strip(3));
    QVERIFY(watched.becomes(3));
    QCOMPARE(watched.ended.count(), 1);
    // The next model is not watched unless its session says so.
    QSignalSpy changed(&watched.watch, &FileWatch::choiceChanged);
    watched.desk.files.openSample(u"torus"_s);
    QCOMPARE(changed.count(), 1);
    QVERIFY(watched.watch.choice() == FileWatch::Choice());
    QCOMPARE(watched.watch.exportPath(), QString());
}

void TestFileWatch::itIsRemembered()
{
    Watched watched({true, true});
    const QCborMap saved = watched.watch.toCbor();
    watched.watch.setChoice({});
    watched.watch.restore(saved);
    QVERIFY(watched.watch.choice() == (FileWatch::Choice{true, true}));
    // The file has not changed, so that only this counts.
    saveInPlace(watched.path, strip(3));
    QVERIFY(watched.becomes(3));
    QCOMPARE(watched.ended.count(), 1);
    watched.watch.restore({});
    QVERIFY(watched.watch.choice() == FileWatch::Choice());
}

void TestFileWatch::savedWhileTheSessionWasClosed()
{
    Watched watched;
    const QCborMap saved = watched.watch.toCbor();
    watched.watch.setChoice({});
    saveInPlace(watched.path, strip(3));
    watched.watch.restore(saved);
    QVERIFY(watched.becomes(3));
    QCOMPARE(watched.entries(), 1);
}

//! A format that is not written is exported in another.
void TestFileWatch::whereItIsExported()
{
    Watched watched;
    const QString off = watched.folder.filePath(u"plate.off"_s);
    saveInPlace(off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    watched.desk.files.open(off);
    QVERIFY(watched.desk.rests());
    QCOMPARE(watched.watch.exportPath(), watched.folder.filePath(u"plate_uv.obj"_s));
}

QTEST_MAIN(TestFileWatch)

} // namespace tst_filewatch

#include "tst_filewatch.moc"
