// Project files: what is saved comes back, and what is damaged is found.
#include "commands/replay.h"
#include "model/io/objwriter.h"
#include "model/io/projectfile.h"
#include "model/io/projectmigration.h"
#include "model/io/projectscene.h"
#include "model/samples/samples.h"
#include "support/editsupport.h"
#include "support/sessions.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>

#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/resource.h>
#endif

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

QByteArray fileBytes(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArray bytesOf(const test::Session &session)
{
    return ProjectWriter().bytes(session.state, session.extras);
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
    QVERIFY(a.constraints.pins == b.constraints.pins);
    QVERIFY(a.constraints.rectangles == b.constraints.rectangles);
    QVERIFY(a.marks == b.marks);
    QVERIFY(a.solveSettings == b.solveSettings);
    QVERIFY(a.packingSettings == b.packingSettings);
    QVERIFY(a.selection == b.selection);
    QCOMPARE(a.viewState, b.viewState);
    QVERIFY(a == b);
}

//! The bytes of a session after a change of its parts, with checksums that fit again.
QByteArray repacked(const QByteArray &bytes, const std::function<void(PartMap &)> &change,
                    int version = projectVersion)
{
    PartMap parts = readContainer(bytes, projectVersion, {}).value().parts;
    change(parts);
    std::vector<PackedBlock> blocks;
    for (const auto &[name, content] : parts)
        blocks.push_back(packBlock(name, content));
    return containerBytes(version, blocks);
}

//! The bytes of a session in which the content of one block is damaged in the file.
QByteArray withDamagedBlock(const test::Session &session, const QByteArray &name)
{
    QByteArray bytes = bytesOf(session);
    const QByteArray content = readContainer(bytes, projectVersion, {}).value().parts.at(name);
    const PackedBlock block = packBlock(name, content, name != "thumbnail" && name != "journal");
    const qsizetype at = bytes.indexOf(block.checksum);
    bytes[at + 3] = static_cast<char>(bytes[at + 3] ^ 16);
    return bytes;
}

} // namespace

class TestProjectFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
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
    void damagedBlock_data();
    void damagedBlock();
    void missingUvSet();
    void exchangedBlocks();
    void truncated();
    void noSession_data();
    void noSession();
    void contradictions_data();
    void contradictions();
    void bombIsRefused();
    void backups();
    void backupsThroughLink();
    void failedSaveKeepsBackups();
    void summary();
};

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
    const test::Session session = sessionNamed(name);
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
    const LoadedProject loaded = parseProject(bytesOf(session), {}).value();
    QVERIFY(loaded.notes.isEmpty());
    const QByteArray text = objBytes(loaded.state.scene);
    QVERIFY(text.startsWith("# a cube\nmtllib cube.mtl\no Würfel\n"));
    QVERIFY(text.contains("\ns 1\n"));
    QVERIFY(sessionLosses(session.state.scene).isEmpty());
}

void TestProjectFile::otherFormatsAreNoted()
{
    const LoadedProject loaded = parseProject(bytesOf(test::gridSession(3, 0, 1)), {}).value();
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
    QVERIFY(parseProject(bytesOf(session), {}).value().state.solveSettings == settings);
    // Files of older programs have none of this, and files of other programs may have nonsense.
    const auto reread = [&](const std::function<void(QCborMap &)> &change) {
        const QByteArray bytes = repacked(bytesOf(session), [&](PartMap &parts) {
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
        return parseProject(repacked(bytesOf(session),
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
        QVERIFY(writer.bytes(session->state, session->extras) == bytesOf(*session));
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
    const QByteArray bytes = repacked(
        bytesOf(test::cubeSession()), [](PartMap &) {}, projectVersion + 1);
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

void TestProjectFile::damagedBlock_data()
{
    QTest::addColumn<QByteArray>("block");
    QTest::addColumn<QString>("lost");
    const auto row = [](const char *block, const char *lost) {
        QTest::newRow(block) << QByteArray(block) << QString::fromLatin1(lost);
    };
    row("scene", "the names of objects and materials");
    row("seams", "the seams");
    row("constraints", "the pins and rectangles");
    row("marks", "the marks of the islands");
    row("settings", "the settings");
    row("selection", "the selection");
    row("view", "the view");
    row("uvSets", "the list of UV sets");
    row("thumbnail", "the thumbnail");
    row("sessionPath", "the session's own path");
    row("journal", "the journal");
    row("journalStart", "the journal");
    row("obj", "");
}

void TestProjectFile::damagedBlock()
{
    QFETCH(QByteArray, block);
    QFETCH(QString, lost);
    test::Session session = test::cubeSession();
    const Result<LoadedProject> loaded = parseProject(withDamagedBlock(session, block), u"x.acproj"_s);
    if (lost.isEmpty()) {
        QVERIFY(!loaded.ok());
        QCOMPARE(loaded.error().message, u"the model in the session is damaged"_s);
        return;
    }
    QVERIFY(loaded.ok());
    QCOMPARE(loaded->lost, QStringList{lost});
    QCOMPARE(loaded->notes, QStringList{lost + u": damaged in the session, left out"_s});
    QCOMPARE(loaded->state.validate(), QString());
    // All the rest is there.
    DocumentState &state = session.state;
    if (block == "seams")
        state.seams = Seams::allFree(*state.scene.mesh);
    else if (block == "constraints")
        state.constraints = {};
    else if (block == "marks")
        state.marks = IslandMarks::none(*state.scene.mesh);
    else if (block == "settings")
        state.solveSettings = {}, state.packingSettings = {};
    else if (block == "selection")
        state.selection = {};
    else if (block == "view")
        state.viewState.clear();
    else if (block == "uvSets")
        state.activeUvSet = 0;
    else if (block == "scene")
        state.scene.path = u"x.acproj"_s;
    QVERIFY(loaded->state == state);
    QCOMPARE(loaded->extras.journal.has_value(), !block.startsWith("journal"));
}

void TestProjectFile::missingUvSet()
{
    const test::Session session = test::cubeSession();
    const auto &sets = session.state.scene.uvSets;
    const Result<LoadedProject> first = parseProject(withDamagedBlock(session, "uv.0"), {});
    QVERIFY(first.ok());
    QCOMPARE(first->lost, QStringList{u"the UV sets before \"lightmap ☀\""_s});
    QCOMPARE(first->state.scene.uvSets.size(), std::size_t(1));
    QCOMPARE(first->state.scene.uvSets[0].name, sets[1].name);
    QCOMPARE(first->state.activeUvSet, 0);
    QCOMPARE(first->state.uvScales, std::vector<double>{session.state.uvScales[1]});
    const Result<LoadedProject> second = parseProject(withDamagedBlock(session, "uv.1"), {});
    QVERIFY(second.ok());
    QCOMPARE(second->lost, QStringList{u"the last UV sets"_s});
    QCOMPARE(second->state.scene.uvSets[0].name, sets[0].name);
    const QByteArray none = repacked(bytesOf(session), [](PartMap &parts) {
        parts.erase("uv.0");
        parts.erase("uv.1");
    });
    const Result<LoadedProject> empty = parseProject(none, {});
    QVERIFY(empty.ok());
    QCOMPARE(empty->lost, QStringList{u"the UV sets"_s});
    QCOMPARE(empty->state.scene.uvSets.size(), std::size_t(1));
    QVERIFY(!empty->state.scene.hasUv());
}

void TestProjectFile::exchangedBlocks()
{
    const test::Session session = test::cubeSession();
    const ProjectParts container = readContainer(bytesOf(session), projectVersion, {}).value();
    std::vector<PackedBlock> blocks;
    for (const auto &[name, content] : container.parts)
        blocks.push_back(packBlock(name, content));
    std::reverse(blocks.begin(), blocks.end());
    const Result<LoadedProject> reversed = parseProject(containerBytes(projectVersion, blocks), {});
    QVERIFY(reversed.ok());
    QVERIFY(reversed->lost.isEmpty());
    QVERIFY(reversed->state == session.state);
    // The content of one block under the name of another.
    const auto named = [&](const char *name) {
        return std::find_if(blocks.begin(), blocks.end(),
                            [&](const auto &block) { return block.name == name; });
    };
    std::swap(named("seams")->name, named("marks")->name);
    const Result<LoadedProject> swapped = parseProject(containerBytes(projectVersion, blocks), {});
    QVERIFY(swapped.ok());
    QCOMPARE(swapped->lost, (QStringList{u"the seams"_s, u"the marks of the islands"_s}));
}

void TestProjectFile::truncated()
{
    const test::Session session = test::gridSession(6, 60, 2);
    const QByteArray bytes = bytesOf(session);
    int opened = 0;
    for (qsizetype size = 0; size < bytes.size(); size += 7) {
        const Result<LoadedProject> loaded = parseProject(bytes.left(size), {});
        opened += loaded.ok();
        if (!loaded.ok())
            QCOMPARE(opened, 0); // once the model is whole it opens
        else
            QCOMPARE(loaded->notes.first(), u"the session is cut off or damaged in the middle"_s);
    }
    QVERIFY(opened > 10);
}

void TestProjectFile::noSession_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("text") << QByteArray("v 0 0 0\nv 1 0 0\n");
    QTest::newRow("zeros") << QByteArray(1000, '\0');
    QTest::newRow("break") << QByteArray(1000, '\xff');
    QTest::newRow("array") << QByteArray("\x82\x01\x02");
    QTest::newRow("other map") << QByteArray("\xa1\x66\x66ormat\x61\x61");
    QTest::newRow("version of zero") << containerBytes(0, {});
    QTest::newRow("version below zero") << containerBytes(-3, {});
    QTest::newRow("deep") << QByteArray(100000, '\x81');
    QTest::newRow("huge map") << QByteArray("\xbb\xff\xff\xff\xff\xff\xff\xff\xff");
    QTest::newRow("huge text") << QByteArray("\xa3\x7b\x7f\xff\xff\xff\xff\xff\xff\xff"
                                             "abc");
    QTest::newRow("no blocks") << containerBytes(projectVersion, {});
}

void TestProjectFile::noSession()
{
    QFETCH(QByteArray, bytes);
    const Result<LoadedProject> loaded = parseProject(bytes, u"x.acproj"_s);
    QVERIFY(!loaded.ok());
    QVERIFY(!loaded.error().message.isEmpty());
    QCOMPARE(loaded.error().file, u"x.acproj"_s);
}

void TestProjectFile::contradictions_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("part");
    QTest::addColumn<QString>("lost");
    // The parts of a larger grid instead of its own.
    QTest::newRow("UVs") << QByteArray("uv.0") << QByteArray("uv.0") << u"the UV sets before \"lightmap\""_s;
    QTest::newRow("seams") << QByteArray("seams") << QByteArray("seams") << QString();
    QTest::newRow("constraints") << QByteArray("constraints") << QByteArray("constraints")
                                 << u"the pins and rectangles"_s;
    QTest::newRow("marks") << QByteArray("marks") << QByteArray("marks") << u"the marks of the islands"_s;
    QTest::newRow("selection") << QByteArray("selection") << QByteArray("selection") << u"the selection"_s;
    QTest::newRow("other kind") << QByteArray("marks") << QByteArray("seams") << u"the seams"_s;
}

void TestProjectFile::contradictions()
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, part);
    QFETCH(QString, lost);
    const auto stateFor = [](int n) {
        DocumentState state = test::layoutDocument(test::grid(n))->state();
        const MeshData &mesh = *state.scene.mesh;
        for (int p = 0; p < mesh.cornerPairCount(); ++p) {
            if (!mesh.edgePairs[p / 2].diagonal)
                state.seams.states[p] = PairState::Cut;
        }
        state.constraints.pins = {{mesh.cornerCount() - 1, {0, 0}, true, 1}};
        state.marks.faceFlags.back().locked = 1;
        state.selection.faces = {mesh.faceCount() - 1};
        return state;
    };
    const PartMap large = statePartsOf(stateFor(5), StateScope::Session);
    const QByteArray bytes =
        repacked(bytesOf({stateFor(3), {}}), [&](PartMap &parts) { parts[part] = large.at(from); });
    const Result<LoadedProject> loaded = parseProject(bytes, {});
    QVERIFY(loaded.ok());
    QCOMPARE(loaded->state.validate(), QString());
    if (!lost.isEmpty())
        QCOMPARE(loaded->lost, QStringList{lost});
    else
        QVERIFY2(loaded->notes.join(u'\n').contains(u"seams do not fit the model"),
                 qPrintable(loaded->notes.join(u'\n')));
}

void TestProjectFile::bombIsRefused()
{
    // A size that no stream of this length can give, and a stream that gives more than its size says.
    const QByteArray content(1000000, 'x');
    PackedBlock block = packBlock("view", content);
    PackedBlock large = packBlock("seams", content);
    block.size = qint64(1) << 40;
    large.size = 10;
    const ProjectParts parts =
        readContainer(containerBytes(projectVersion, {block, large}), projectVersion, {}).value();
    QVERIFY(parts.parts.empty());
    QCOMPARE(parts.damaged.size(), std::size_t(2));
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
    QVERIFY(!loadProjectSummary(folder.filePath(u"none.acproj"_s)).ok());
}

QTEST_GUILESS_MAIN(TestProjectFile)
#include "tst_projectfile.moc"
