// Project files that are damaged or contradict themselves: what is whole opens, and the rest is named.
#include "support/editsupport.h"
#include "support/sessions.h"

#include <QTest>

#include <algorithm>

namespace tst_projecterrors {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! The bytes of a session in which the content of one block is damaged in the file.
QByteArray withDamagedBlock(const test::Session &session, const QByteArray &name)
{
    QByteArray bytes = test::bytesOf(session);
    const QByteArray content = readContainer(bytes, projectVersion, {}).value().parts.at(name);
    const PackedBlock block = packBlock(name, content, name != "thumbnail" && name != "journal");
    const qsizetype at = bytes.indexOf(block.checksum);
    bytes[at + 3] = static_cast<char>(bytes[at + 3] ^ 16);
    return bytes;
}

} // namespace

class TestProjectErrors : public QObject
{
    Q_OBJECT

private Q_SLOTS:
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
    void unknownBlocksAreSkipped();
    void partsThatAreLeftOutAreCounted();
    void contentsHaveALimit();
    void uvSetsWithImpossibleNumbers();
};

void TestProjectErrors::damagedBlock_data()
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

void TestProjectErrors::damagedBlock()
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

void TestProjectErrors::missingUvSet()
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
    const QByteArray none = test::repacked(test::bytesOf(session), [](PartMap &parts) {
        parts.erase("uv.0");
        parts.erase("uv.1");
    });
    const Result<LoadedProject> empty = parseProject(none, {});
    QVERIFY(empty.ok());
    QCOMPARE(empty->lost, QStringList{u"the UV sets"_s});
    QCOMPARE(empty->state.scene.uvSets.size(), std::size_t(1));
    QVERIFY(!empty->state.scene.hasUv());
}

void TestProjectErrors::exchangedBlocks()
{
    const test::Session session = test::cubeSession();
    const ProjectParts container = readContainer(test::bytesOf(session), projectVersion, {}).value();
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

void TestProjectErrors::truncated()
{
    const test::Session session = test::gridSession(6, 60, 2);
    const QByteArray bytes = test::bytesOf(session);
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

void TestProjectErrors::noSession_data()
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

void TestProjectErrors::noSession()
{
    QFETCH(QByteArray, bytes);
    const Result<LoadedProject> loaded = parseProject(bytes, u"x.acproj"_s);
    QVERIFY(!loaded.ok());
    QVERIFY(!loaded.error().message.isEmpty());
    QCOMPARE(loaded.error().file, u"x.acproj"_s);
}

void TestProjectErrors::contradictions_data()
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

void TestProjectErrors::contradictions()
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
    const QByteArray bytes = test::repacked(test::bytesOf({stateFor(3), {}}),
                                            [&](PartMap &parts) { parts[part] = large.at(from); });
    const Result<LoadedProject> loaded = parseProject(bytes, {});
    QVERIFY(loaded.ok());
    QCOMPARE(loaded->state.validate(), QString());
    if (!lost.isEmpty())
        QCOMPARE(loaded->lost, QStringList{lost});
    else
        QVERIFY2(loaded->notes.join(u'\n').contains(u"seams do not fit the model"),
                 qPrintable(loaded->notes.join(u'\n')));
}

void TestProjectErrors::bombIsRefused()
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

void TestProjectErrors::unknownBlocksAreSkipped()
{
    // Of a name that is not read, not even the size matters.
    PackedBlock unknown = packBlock("future", QByteArray(1000000, 'x'));
    const auto isView = [](const QByteArray &name) { return name == "view"; };
    const QByteArray bytes = containerBytes(projectVersion, {unknown, packBlock("view", "v")});
    const ProjectParts parts = readContainer(bytes, projectVersion, {}, isView).value();
    QCOMPARE(parts.parts.size(), std::size_t(1));
    QVERIFY(parts.damaged.empty());

    // Through the session: 600 MB of an unknown block, more than all contents together may have.
    unknown = packBlock("future", QByteArray(qsizetype(600) << 20, '\0'));
    QByteArray session = test::bytesOf(test::cubeSession());
    const QByteArray more = containerBytes(projectVersion, {unknown});
    // Both are maps of known length: the block follows the two entries of the head.
    const qsizetype head = more.indexOf("future") - 1;
    session[0] = static_cast<char>(session[0] + 1);
    const Result<LoadedProject> loaded = parseProject(session + more.mid(head), {});
    QVERIFY2(loaded.ok(), loaded ? "" : qPrintable(loaded.error().toString()));
    QVERIFY(loaded->lost.isEmpty());
    QCOMPARE(loaded->warnings.size(), 1);
    QVERIFY(loaded->warnings.front().contains(u"\"future\" is unknown"));
}

//! A file can name any number of parts.
void TestProjectErrors::partsThatAreLeftOutAreCounted()
{
    std::vector<PackedBlock> more{packBlock("view", "again")};
    for (int i = 0; i < 20; ++i)
        more.push_back(packBlock("future" + QByteArray::number(i), "x"));
    const QByteArray parts = containerBytes(projectVersion, more);
    QByteArray session = test::bytesOf(test::cubeSession());
    QCOMPARE(session[0], char(0xa0 | (session[0] & 0x1f))); // a map of few entries: its length is in one byte
    const int entries = (session[0] & 0x1f) + int(more.size());
    session.replace(0, 1, QByteArray("\xb8") + char(entries));
    const Result<LoadedProject> loaded = parseProject(session + parts.mid(parts.indexOf("view") - 1), {});
    QVERIFY2(loaded.ok(), loaded ? "" : qPrintable(loaded.error().toString()));
    QCOMPARE(loaded->warnings.size(), 6);
    QVERIFY2(loaded->warnings.front().contains(u"\"view\" is there twice"),
             qPrintable(loaded->warnings.front()));
    QVERIFY2(loaded->warnings.back().startsWith(u"16 more parts"), qPrintable(loaded->warnings.back()));
}

void TestProjectErrors::contentsHaveALimit()
{
    // Five blocks of 150 MB that are all zeros: 750 MB from less than one.
    std::vector<PackedBlock> blocks;
    const QByteArray content(qsizetype(150) << 20, '\0');
    blocks.assign(5, packBlock("uv.0", content));
    // Of one name only the first is read.
    QCOMPARE(readContainer(containerBytes(projectVersion, blocks), projectVersion, {}).value().parts.size(),
             std::size_t(1));
    blocks.clear();
    for (int i = 0; i < 5; ++i)
        blocks.push_back(packBlock("uv." + QByteArray::number(i), content));
    const auto refused = readContainer(containerBytes(projectVersion, blocks), projectVersion, u"a.acproj"_s);
    QVERIFY(!refused.ok());
    QVERIFY(refused.error().message.contains(u"far larger"_s));
    QCOMPARE(refused.error().file, u"a.acproj"_s);
    QVERIFY(!refused.error().remedy.isEmpty());
}

void TestProjectErrors::uvSetsWithImpossibleNumbers()
{
    const QByteArray bytes = test::bytesOf(test::cubeSession());
    for (const char *name : {"uv.2147483647", "uv.99999999999", "uv.-1", "uv.x", "uv.01"}) {
        const QByteArray changed =
            test::repacked(bytes, [&](PartMap &parts) { parts[name] = parts.at("uv.0"); });
        const Result<LoadedProject> loaded = parseProject(changed, {});
        QVERIFY(loaded.ok());
        QCOMPARE(loaded->lost, QStringList{u"a UV set with an impossible number"_s});
        QCOMPARE(loaded->state.scene.uvSets.size(), std::size_t(2));
    }
}

QTEST_GUILESS_MAIN(TestProjectErrors)

} // namespace tst_projecterrors

#include "tst_projecterrors.moc"
