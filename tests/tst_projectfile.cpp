// Project files: what is saved comes back.
#include "commands/replay.h"
#include "model/io/files/savefile.h"
#include "model/io/obj/objwriter.h"
#include "model/io/projects/projectfile.h"
#include "model/io/projects/projectmigration.h"
#include "model/io/projects/projectscene.h"
#include "model/samples/samples.h"
#include "support/editsupport.h"
#include "support/sessions.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <functional>

#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/resource.h>
#ifdef Q_OS_LINUX
#include <sys/mount.h>
#endif
#endif

namespace tst_projectfile {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

QByteArray fileBytes(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

test::Session sessionNamed(const QString &name)
{
    if (name == u"cube")
        return test::cubeSession();
    if (name == u"grid")
        return test::gridSession(6, 0, 1);
    if (name == u"edited grid")
        return test::gridSession(6, 60, 2);
    if (name == u"edited twice")
        return test::gridSession(5, 200, 3);
    if (name == u"dirty")
        return {test::layoutDocument(test::dirty())->state(), {}};
    return {DocumentState::initial(makeSample(name).value()), {}};
}

void compareScenes(const Scene &a, const Scene &b)
{
    QCOMPARE(a.path, b.path);
    QCOMPARE(a.format, b.format);
    QCOMPARE(a.objectNames, b.objectNames);
    QCOMPARE(a.materialNames, b.materialNames);
    QCOMPARE(a.faceMaterial, b.faceMaterial);
    QCOMPARE(a.hardEdges, b.hardEdges);
    QCOMPARE(a.notes, b.notes);
    QCOMPARE(a.mesh->faceStart, b.mesh->faceStart);
    QCOMPARE(a.mesh->cornerVertex, b.mesh->cornerVertex);
    QCOMPARE(a.mesh->faceObject, b.mesh->faceObject);
    QVERIFY(a.mesh->positions == b.mesh->positions);
    QCOMPARE(objBytes(a), objBytes(b));
}

void compareStates(const DocumentState &a, const DocumentState &b)
{
    QCOMPARE(a.activeUvSet, b.activeUvSet);
    QCOMPARE(a.uvScales, b.uvScales);
    QCOMPARE(a.scene.uvSets.size(), b.scene.uvSets.size());
    QVERIFY(a.seams.states == b.seams.states);
    QCOMPARE(a.seams.weights, b.seams.weights);
    QVERIFY(a.seams.straight == b.seams.straight);
    QVERIFY(a.constraints.pins == b.constraints.pins);
    QVERIFY(a.constraints.rectangles == b.constraints.rectangles);
    QVERIFY(a.marks == b.marks);
    QVERIFY(a.solveSettings == b.solveSettings);
    QVERIFY(a.packingSettings == b.packingSettings);
    QVERIFY(a.selection == b.selection);
    QCOMPARE(a.viewState, b.viewState);
    QVERIFY(a == b);
}

} // namespace

class TestProjectFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void loadingStops();
    void roundTrip_data();
    void roundTrip();
    void objSourceComesBack();
    void otherFormatsAreNoted();
    void seamSettingsComeBack();
    void hardEdgesAreChecked();
    void writerKeepsTheModel();
    void everyVersionOpens_data();
    void everyVersionOpens();
    void newerVersionIsRefused();
    void migrationsRunInOrder();
    void migrationsFail();
    void backups();
    void aBackupThatFailsIsSaid();
    void manyUvSetsOfOneName();
    void backupsThroughLink();
    void failedSaveKeepsBackups();
    void aFullDiskIsNamed();
    void summary();
};

void TestProjectFile::loadingStops()
{
    const test::Session session = sessionNamed(u"cube"_s);
    const std::atomic<bool> stop = true;
    const Result<LoadedProject> loaded =
        parseProject(ProjectWriter().bytes(session.state, session.extras), u"a.acproj"_s, &stop);
    QVERIFY(!loaded.ok());
    QCOMPARE(loaded.error().message, u"reading was cancelled"_s);
}

void TestProjectFile::roundTrip_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"cube", "grid", "edited grid", "edited twice", "dirty"})
        QTest::newRow(name) << QString::fromLatin1(name);
    for (const QString &name : sampleNames())
        QTest::newRow(qPrintable(name)) << name;
}

void TestProjectFile::roundTrip()
{
    QFETCH(QString, name);
    test::Session session = sessionNamed(name);
    const std::vector<EdgePair> &edges = session.state.scene.mesh->edgePairs;
    for (std::size_t e = 0; e < edges.size(); e += 3)
        session.state.seams.straight[2 * e] = session.state.seams.straight[2 * e + 1] = !edges[e].diagonal;
    QCOMPARE(session.state.validate(), QString());
    QTemporaryDir folder;
    const QString path = folder.filePath(u"ä b.acproj"_s);
    QVERIFY(saveProject(session.state, session.extras, path).ok());
    const Result<LoadedProject> loaded = loadProject(path);
    QVERIFY2(loaded.ok(), loaded.ok() ? "" : qPrintable(loaded.error().toString()));
    QCOMPARE(loaded->lost, QStringList());
    compareScenes(loaded->state.scene, session.state.scene);
    compareStates(loaded->state, session.state);
    const ProjectExtras &extras = loaded->extras;
    QCOMPARE(extras.thumbnail, session.extras.thumbnail);
    QCOMPARE(extras.sessionPath, session.extras.sessionPath);
    QCOMPARE(extras.journal.has_value(), session.extras.journal.has_value());
    if (extras.journal) {
        QVERIFY(extras.journal->initial == session.extras.journal->initial);
        QCOMPARE(extras.journal->commands, session.extras.journal->commands);
    }
    QCOMPARE(loaded->state.validate(), QString());
    QCOMPARE(ProjectWriter().bytes(loaded->state, loaded->extras), fileBytes(path));
}

void TestProjectFile::objSourceComesBack()
{
    const test::Session session = test::cubeSession();
    const LoadedProject loaded = parseProject(test::bytesOf(session), {}).value();
    QVERIFY(loaded.notes.isEmpty());
    const QByteArray text = objBytes(loaded.state.scene);
    QVERIFY(text.startsWith("# a cube\nmtllib cube.mtl\no Würfel\n"));
    QVERIFY(text.contains("\ns 1\n"));
    QVERIFY(sessionLosses(session.state.scene).isEmpty());
}

void TestProjectFile::otherFormatsAreNoted()
{
    const LoadedProject loaded = parseProject(test::bytesOf(test::gridSession(3, 0, 1)), {}).value();
    QCOMPARE(loaded.notes.size(), 1);
    QVERIFY2(loaded.notes.first().contains(u"ply file, not its normals"), qPrintable(loaded.notes.first()));
}

void TestProjectFile::seamSettingsComeBack()
{
    test::Session session = test::cubeSession();
    SolveSettings &settings = session.state.solveSettings;
    settings.seams = SeamMode::Only;
    settings.givenSeams = {
        .cuts = false, .map = true, .sharp = true, .hard = false, .materials = true, .sharpAngle = 12.5};
    QVERIFY(parseProject(test::bytesOf(session), {}).value().state.solveSettings == settings);
    // Files of older programs have none of this, and files of other programs may have nonsense.
    const auto reread = [&](const std::function<void(QCborMap &)> &change) {
        const QByteArray bytes = test::repacked(test::bytesOf(session), [&](PartMap &parts) {
            QCborMap all = QCborValue::fromCbor(parts["settings"]).toMap();
            QCborMap solve = all["solve"_L1].toMap();
            change(solve);
            all["solve"_L1] = solve;
            parts["settings"] = all.toCborValue().toCbor();
        });
        return parseProject(bytes, {}).value();
    };
    const SolveSettings old = reread([](QCborMap &solve) {
                                  solve.remove("seams"_L1), solve.remove("givenSeams"_L1);
                              }).state.solveSettings;
    QCOMPARE(old.seams, SeamMode::Free);
    QVERIFY(old.givenSeams == GivenSeamOptions());
    QCOMPARE(old.lambda, settings.lambda);
    const QStringList lost{u"the settings"_s};
    QCOMPARE(reread([](QCborMap &solve) { solve["seams"_L1] = 3; }).lost, lost);
    QCOMPARE(reread([](QCborMap &solve) { solve["givenSeams"_L1] = true; }).lost, lost);
    QCOMPARE(reread([](QCborMap &solve) { solve["givenSeams"_L1] = QCborMap(); }).lost, lost);
}

void TestProjectFile::hardEdgesAreChecked()
{
    const test::Session session = test::gridSession(3, 0, 1);
    const auto reread = [&](const std::function<void(QCborMap &)> &change) {
        return parseProject(test::repacked(test::bytesOf(session),
                                           [&](PartMap &parts) {
                                               QCborMap map = QCborValue::fromCbor(parts["polygons"]).toMap();
                                               change(map);
                                               parts["polygons"] = map.toCborValue().toCbor();
                                           }),
                            {});
    };
    QCOMPARE(reread([](QCborMap &) {})->state.scene.hardEdges, session.state.scene.hardEdges);
    QVERIFY(reread([](QCborMap &map) { map.remove("hardSides"_L1); })->state.scene.hardEdges.empty());
    const QString damaged = u"the model in the session is damaged"_s;
    for (const QByteArray &bits : {QByteArray(), QByteArray(5, '\xff'), QByteArray(4, '\0')})
        QCOMPARE(reread([&](QCborMap &map) { map["hardSides"_L1] = bits; }).error().message, damaged);
}

void TestProjectFile::writerKeepsTheModel()
{
    ProjectWriter writer;
    const test::Session cube = test::cubeSession();
    const test::Session grid = test::gridSession(4, 10, 5);
    for (const test::Session *session : {&cube, &cube, &grid, &cube})
        QVERIFY(writer.bytes(session->state, session->extras) == test::bytesOf(*session));
}

void TestProjectFile::everyVersionOpens_data()
{
    QTest::addColumn<int>("version");
    for (int version = 1; version <= projectVersion; ++version)
        QTest::addRow("%d", version) << version;
}

void TestProjectFile::everyVersionOpens()
{
    QFETCH(int, version);
    const QString folder = QStringLiteral(AUTOCUTS_SOURCE_DIR "/tests/data/");
    const Result<LoadedProject> loaded = loadProject(folder + u"session-v%1.acproj"_s.arg(version));
    QVERIFY2(loaded.ok(), loaded.ok() ? "" : qPrintable(loaded.error().toString()));
    QCOMPARE(loaded->lost, QStringList());
    const test::Session expected = test::cubeSession();
    compareScenes(loaded->state.scene, expected.state.scene);
    compareStates(loaded->state, expected.state);
    QCOMPARE(loaded->extras.thumbnail, expected.extras.thumbnail);
    QCOMPARE(loaded->extras.journal->commands.size(), std::size_t(1));
    const Result<std::unique_ptr<Document>> replayed = replay(*loaded->extras.journal);
    QVERIFY(replayed.ok());
    QVERIFY(sameWork(replayed.value()->state(), expected.state));
}

void TestProjectFile::newerVersionIsRefused()
{
    const QByteArray bytes = test::repacked(
        test::bytesOf(test::cubeSession()), [](PartMap &) {}, projectVersion + 1);
    const Result<LoadedProject> loaded = parseProject(bytes, u"new.acproj"_s);
    QVERIFY(!loaded.ok());
    QVERIFY(loaded.error().message.contains(
        u"saved by a newer Autocuts (its format is 3, this one reads up to 2)"));
    QCOMPARE(loaded.error().file, u"new.acproj"_s);
    QCOMPARE(loaded.error().remedy, u"Install a newer Autocuts"_s);
}

void TestProjectFile::migrationsRunInOrder()
{
    QCOMPARE(static_cast<int>(projectMigrations().size()), projectVersion - 1);
    const auto adding = [](char letter) {
        return [letter](PartMap &parts) {
            parts["text"].append(letter);
            return true;
        };
    };
    const std::vector<Migration> migrations{adding('a'), adding('b'), adding('c')};
    const std::vector<QByteArray> expected{"abc", "bc", "c", ""};
    for (int version = 1; version <= 4; ++version) {
        PartMap parts{{"text", ""}};
        QVERIFY(migrateParts(parts, version, migrations));
        QCOMPARE(parts.at("text"), expected[version - 1]);
    }
    PartMap parts;
    QVERIFY(!migrateParts(parts, 5, migrations));
}

void TestProjectFile::migrationsFail()
{
    bool reached = false;
    const std::vector<Migration> migrations{[](PartMap &) { return false; },
                                            [&](PartMap &) { return reached = true; }};
    PartMap parts;
    QVERIFY(!migrateParts(parts, 1, migrations));
    QVERIFY(!reached);
    QVERIFY(migrateParts(parts, 2, migrations));
    QVERIFY(reached);
}

void TestProjectFile::backups()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.acproj"_s);
    test::Session session = test::gridSession(3, 0, 1);
    const auto saveNumber = [&](int number) {
        session.state.viewState = QByteArray::number(number);
        return saveProject(session.state, session.extras, path).ok();
    };
    const auto numberIn = [](const QString &file) {
        return loadProject(file).value().state.viewState.toInt();
    };
    QVERIFY(saveNumber(1));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{u"a.acproj"_s});
    QVERIFY(saveNumber(2));
    QCOMPARE(numberIn(path), 2);
    QCOMPARE(numberIn(path + u".1"_s), 1);
    QVERIFY(saveNumber(3) && saveNumber(4));
    QCOMPARE(numberIn(path), 4);
    QCOMPARE(numberIn(path + u".1"_s), 3);
    QCOMPARE(numberIn(path + u".2"_s), 2);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 3);
}

void TestProjectFile::aBackupThatFailsIsSaid()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.acproj"_s);
    test::Session session = test::gridSession(3, 0, 1);
    const auto save = [&](int number) {
        session.state.viewState = QByteArray::number(number);
        return saveProject(session.state, session.extras, path);
    };
    const auto numberIn = [](const QString &file) {
        return loadProject(file).value().state.viewState.toInt();
    };
    // A folder is where the backup should be.
    QVERIFY(QDir(folder.path()).mkpath(u"a.acproj.1/full"_s));
    QVERIFY(QDir(folder.path()).mkpath(u"a.acproj.2/full"_s));
    QVERIFY(save(1).value().warning.isEmpty());
    const Result<SavedProject> saved = save(2);
    QVERIFY(saved.ok());
    QVERIFY(!saved->warning.isEmpty());
    QCOMPARE(numberIn(path), 2);
    QCOMPARE(numberIn(path + u".new"_s), 1);
    // The next save still makes a backup of what could not be kept then.
    for (const QString &name : {u"a.acproj.1"_s, u"a.acproj.2"_s})
        QVERIFY(QDir(folder.filePath(name)).removeRecursively());
    QVERIFY(save(3).value().warning.isEmpty());
    QCOMPARE(numberIn(path), 3);
    QCOMPARE(numberIn(path + u".1"_s), 2);
    QCOMPARE(numberIn(path + u".2"_s), 1);
    QVERIFY(!QFile::exists(path + u".new"_s));
}

void TestProjectFile::manyUvSetsOfOneName()
{
    DocumentState state = test::gridSession(3, 0, 1).state;
    state.scene.uvSets.resize(1);
    state.scene.uvSets.front().name = u"UVMap"_s;
    state.scene.uvSets.resize(500, state.scene.uvSets.front());
    const DocumentState made = DocumentState::initial(std::move(state.scene));
    QCOMPARE(made.scene.uvSets.front().name, u"UVMap"_s);
    QCOMPARE(made.scene.uvSets[1].name, u"UVMap.2"_s);
    QCOMPARE(made.scene.uvSets.back().name, u"UVMap.500"_s);
    QCOMPARE(made.validate(), QString());
}

void TestProjectFile::backupsThroughLink()
{
    QTemporaryDir folder, other;
    const QString path = folder.filePath(u"a.acproj"_s);
    const QString target = other.filePath(u"real.acproj"_s);
    test::Session session = test::gridSession(3, 0, 1);
    QVERIFY(saveProject(session.state, session.extras, target).ok());
    QVERIFY(QFile::link(target, path));
    session.state.viewState = QByteArrayLiteral("new");
    QVERIFY(saveProject(session.state, session.extras, path).ok());
    QVERIFY(QFileInfo(path).isSymLink());
    QCOMPARE(loadProject(target).value().state.viewState, QByteArrayLiteral("new"));
    QCOMPARE(loadProject(path + u".1"_s).value().state.viewState, QByteArray(300, 'v'));
}

void TestProjectFile::failedSaveKeepsBackups()
{
#ifdef Q_OS_UNIX
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.acproj"_s);
    test::Session session = test::gridSession(3, 0, 1);
    QVERIFY(saveProject(session.state, session.extras, path).ok());
    QVERIFY(saveProject(session.state, session.extras, path).ok());
    const QByteArray before = fileBytes(path + u".1"_s);
    // As on a full disk: no file may grow beyond this.
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit unlimited;
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &unlimited), 0);
    rlimit limit = unlimited;
    limit.rlim_cur = 500;
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &limit), 0);
    const bool saved = saveProject(session.state, session.extras, path).ok();
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &unlimited), 0);
    QVERIFY(!saved);
    QCOMPARE(fileBytes(path), before);
    QCOMPARE(fileBytes(path + u".1"_s), before);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
#else
    QSKIP("There is no limit on the size of files here");
#endif
}

void TestProjectFile::aFullDiskIsNamed()
{
#ifdef Q_OS_LINUX
    QTemporaryDir folder;
    const QByteArray disk = QFile::encodeName(folder.path());
    if (mount("none", disk.constData(), "tmpfs", 0, "size=16k") != 0)
        QSKIP("This user may not mount a small disk");
    const Result<Done> saved = saveAtomically(folder.filePath(u"a"_s), QByteArray(100'000, 'a'));
    QCOMPARE(umount(disk.constData()), 0);
    QVERIFY(!saved.ok());
    QCOMPARE(saved.error().message, u"there is no space left on the disk"_s);
#else
    QSKIP("Needs a small disk");
#endif
}

void TestProjectFile::summary()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.acproj"_s);
    const test::Session session = test::cubeSession();
    QVERIFY(saveProject(session.state, session.extras, path).ok());
    const Result<ProjectSummary> read = loadProjectSummary(path);
    QVERIFY(read.ok());
    QCOMPARE(read->thumbnail, session.extras.thumbnail);
    QCOMPARE(read->sessionPath, session.extras.sessionPath);
    QCOMPARE(read->modelPath, session.state.scene.path);
    QVERIFY(!loadProjectSummary(folder.filePath(u"none.acproj"_s)).ok());
}

QTEST_GUILESS_MAIN(TestProjectFile)

} // namespace tst_projectfile

#include "tst_projectfile.moc"
