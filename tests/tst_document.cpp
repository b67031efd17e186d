// Document: its state, its invariants, island marks, revisions, and the snapshot for the solver.
#include "commands/changesettings.h"
#include "commands/editpins.h"
#include "commands/editrectangles.h"
#include "commands/edituvsets.h"
#include "commands/setislandflags.h"
#include "commands/setislandtag.h"
#include "commands/setseamstate.h"
#include "commands/setseamweights.h"
#include "commands/settexelweights.h"
#include "commands/setuvs.h"
#include "model/document/makesnapshot.h"
#include "model/plain/uvlayout.h"
#include "support/editsupport.h"

#include <QTest>

#include <functional>
#include <limits>
#include <numbers>

namespace tst_document {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

using Change = std::function<void(DocumentState &)>;

//! Ways to break a state, one invariant each.
std::vector<std::pair<const char *, Change>> damages()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    using S = DocumentState;
    return {
        {"no mesh", [](S &s) { s.scene.mesh.reset(); }},
        {"material missing", [](S &s) { s.scene.faceMaterial.pop_back(); }},
        {"material unknown", [](S &s) { s.scene.faceMaterial[0] = 0; }},
        {"hard edges missing", [](S &s) { s.scene.hardEdges.assign(3, true); }},
        {"no UV set", [](S &s) { s.scene.uvSets.clear(), s.uvScales.clear(); }},
        {"active set too high", [](S &s) { s.activeUvSet = 2; }},
        {"active set negative", [](S &s) { s.activeUvSet = -1; }},
        {"scales missing", [](S &s) { s.uvScales.pop_back(); }},
        {"scale zero", [](S &s) { s.uvScales[0] = 0; }},
        {"scale not a number", [=](S &s) { s.uvScales[0] = nan; }},
        {"UV rows missing", [](S &s) { s.scene.uvSets[1].uv.conservativeResize(3, 2); }},
        {"UV set without name", [](S &s) { s.scene.uvSets[1].name.clear(); }},
        {"two UV sets of one name", [](S &s) { s.scene.uvSets[1].name = s.scene.uvSets[0].name; }},
        {"UV set's name too long", [](S &s) { s.scene.uvSets[1].name.fill(u'x', maxNameLength + 1); }},
        {"seam states missing", [](S &s) { s.seams.states.pop_back(); }},
        {"seam state unknown", [](S &s) { s.seams.states[0] = PairState(3); }},
        {"seam weight negative", [](S &s) { s.seams.weights[0] = -1; }},
        {"seam weight not a number", [=](S &s) { s.seams.weights[0] = nan; }},
        {"seam weight too large", [](S &s) { s.seams.weights[0] = 2 * maxPaintedWeight; }},
        {"diagonal cut", [](S &s) { s.seams.states[2] = PairState::Cut; }},
        {"diagonal painted", [](S &s) { s.seams.weights[2] = 2; }},
        {"pins out of order", [](S &s) { std::swap(s.constraints.pins[0], s.constraints.pins[1]); }},
        {"two pins at a corner", [](S &s) { s.constraints.pins[1].corner = 3; }},
        {"pin nowhere", [](S &s) { s.constraints.pins[1].corner = 64; }},
        {"pin at infinity", [=](S &s) { s.constraints.pins[1].position.x() = nan; }},
        {"pin weight negative", [](S &s) { s.constraints.pins[1].weight = -1; }},
        {"rectangle id zero", [](S &s) { s.constraints.rectangles[0].id = 0; }},
        {"rectangles of one id", [](S &s) { s.constraints.rectangles[0].id = 4; }},
        {"rectangle turned", [](S &s) { s.constraints.rectangles[0].lower.x() = 2; }},
        {"rectangle's face unknown", [](S &s) { s.constraints.rectangles[0].faces = {16}; }},
        {"rectangle's faces unsorted",
         [](S &s) {
             s.constraints.rectangles[0].faces = {2, 1};
         }},
        {"flags missing", [](S &s) { s.marks.faceFlags.pop_back(); }},
        {"flag unknown", [](S &s) { s.marks.faceFlags[0].locked = 2; }},
        {"group negative", [](S &s) { s.marks.faceFlags[0].group = -1; }},
        {"tag without name", [](S &s) { s.marks.tags[0].name.clear(); }},
        {"tag without faces", [](S &s) { s.marks.tags[0].faces.clear(); }},
        {"tags of one name", [](S &s) { s.marks.tags.push_back(s.marks.tags[0]); }},
        {"lambda above one", [](S &s) { s.solveSettings.lambda = 1.5; }},
        {"delta zero", [](S &s) { s.solveSettings.delta = 0; }},
        {"energy unknown", [](S &s) { s.solveSettings.energy = DistortionEnergy(7); }},
        {"seam mode unknown", [](S &s) { s.solveSettings.seams = SeamMode(-1); }},
        {"sharp angle negative", [](S &s) { s.solveSettings.givenSeams.sharpAngle = -1; }},
        {"sharp angle not a number", [=](S &s) { s.solveSettings.givenSeams.sharpAngle = nan; }},
        {"margin negative", [](S &s) { s.packingSettings.margin = -1; }},
        {"tile before the first", [](S &s) { s.packingSettings.udimTile = 1000; }},
        {"selected face unknown", [](S &s) { s.selection.faces = {16}; }},
        {"selected edge is a diagonal", [](S &s) { s.selection.edges = {1}; }},
        {"selection mode unknown", [](S &s) { s.selection.mode = SelectionMode(4); }},
    };
}

//! Ways to change a state that leave it valid, one field each.
std::vector<std::pair<const char *, Change>> differences()
{
    using S = DocumentState;
    return {
        {"path", [](S &s) { s.scene.path += u'x'; }},
        {"format", [](S &s) { s.scene.format = u"ply"_s; }},
        {"mesh", [](S &s) { s.scene.mesh = test::grid(4, 0.001); }},
        {"object names", [](S &s) { s.scene.objectNames[0] += u'x'; }},
        {"material names", [](S &s) { s.scene.materialNames.push_back({}); }},
        {"face material", [](S &s) { s.scene.faceMaterial.clear(); }},
        {"hard edges", [](S &s) { s.scene.hardEdges.assign(s.scene.mesh->edgePairs.size(), false); }},
        {"UV", [](S &s) { s.scene.uvSets[0].uv(5, 1) += 1e-15; }},
        {"UV of another set", [](S &s) { s.scene.uvSets[1].uv(5, 1) = 0; }},
        {"UV set's name", [](S &s) { s.scene.uvSets[1].name = u"x"_s; }},
        {"notes", [](S &s) { s.scene.notes.push_back(u"x"_s); }},
        {"active set", [](S &s) { s.activeUvSet = 1; }},
        {"scale", [](S &s) { s.uvScales[1] = 2; }},
        {"seam state", [](S &s) { s.seams.states[0] = PairState::Free; }},
        {"seam weight", [](S &s) { s.seams.weights[0] = 0; }},
        {"pin", [](S &s) { s.constraints.pins[0].hard = false; }},
        {"pin's place", [](S &s) { s.constraints.pins[0].position.y() = 0; }},
        {"rectangle", [](S &s) { s.constraints.rectangles[0].weight = 3; }},
        {"rectangle's faces", [](S &s) { s.constraints.rectangles[0].faces = {}; }},
        {"rectangle's color", [](S &s) { s.constraints.rectangles[0].color = 0; }},
        {"flag", [](S &s) { s.marks.faceFlags[0].stack = 1; }},
        {"tag", [](S &s) { s.marks.tags[0].faces = {1}; }},
        {"solve settings", [](S &s) { s.solveSettings.seed = 9; }},
        {"packing settings", [](S &s) { s.packingSettings.keepScale = true; }},
        {"selection", [](S &s) { s.selection.faces = {}; }},
        {"selection mode", [](S &s) { s.selection.mode = SelectionMode::Edges; }},
        {"view state", [](S &s) { s.viewState = {}; }},
    };
}

void addRows(const std::vector<std::pair<const char *, Change>> &changes)
{
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < changes.size(); ++i)
        QTest::newRow(changes[i].first) << static_cast<int>(i);
}

} // namespace

class TestDocument : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initialState();
    void brokenStatesAreRefused_data() { addRows(damages()); }
    void brokenStatesAreRefused();
    void everyFieldIsCompared_data() { addRows(differences()); }
    void everyFieldIsCompared();
    void islandsFollowTheUvs();
    void marksSurviveCuttingAndJoining();
    void rulesOfMarks();
    void revisions();
    void snapshotUnits();
    void flagsHoldWhatHasAPlace();
    void snapshotOfPolygons();
    void scaleOfALayout();
};

void TestDocument::initialState()
{
    const Document document(test::sceneOf(test::grid(4)));
    QCOMPARE(document.validate(), QString());
    QCOMPARE(document.uvSets().size(), std::size_t(1));
    QCOMPARE(document.uvSets()[0].name, u"UVMap"_s);
    QCOMPARE(document.islands().count(), 0);
    QCOMPARE(document.uvScale(), defaultUvScale);
    QVERIFY(document.undoStack().isClean());

    Scene scene = test::sceneOf(test::grid(4));
    scene.uvSets = {{u"a"_s, test::splitLayout(*scene.mesh)}, {u"a"_s, emptyLayout(*scene.mesh)}, {}};
    scene.uvSets[2].uv = scene.uvSets[0].uv;
    const Document three(std::move(scene));
    QCOMPARE(three.validate(), QString());
    QCOMPARE(three.uvSets()[1].name, u"a.2"_s);
    QCOMPARE(three.uvSets()[2].name, u"UVMap"_s);
    QCOMPARE(three.islands().count(), 2);
}

void TestDocument::brokenStatesAreRefused()
{
    QFETCH(int, index);
    DocumentState state = test::gridDocument()->state();
    QVERIFY(Document::create(state).ok());
    damages()[index].second(state);
    const auto document = Document::create(state);
    QVERIFY(!document.ok());
    QVERIFY(!document.error().message.isEmpty());
}

void TestDocument::everyFieldIsCompared()
{
    QFETCH(int, index);
    const DocumentState state = test::gridDocument()->state();
    DocumentState other = test::gridDocument()->state();
    QVERIFY(state == other); // another mesh object with the same content
    differences()[index].second(other);
    QCOMPARE(other.validate(), QString());
    QVERIFY(!(state == other));
    const auto document = Document::create(other);
    QVERIFY(document.ok());
    QVERIFY(document.value()->state() == other);
}

void TestDocument::islandsFollowTheUvs()
{
    const auto document = test::layoutDocument(test::grid(4));
    const auto soupFollows = [&] {
        const SoupMap soup = SoupMap::of(document->mesh(), document->uv());
        const SoupMap &cached = document->soupMap();
        return cached.open == soup.open && cached.uv.rows() == soup.uv.rows() &&
               std::memcmp(cached.uv.data(), soup.uv.data(), sizeof(double) * soup.uv.size()) == 0;
    };
    QCOMPARE(document->islands().count(), 2);
    QVERIFY(soupFollows());
    UvMatrix uv = document->uv();
    for (int c = 0; c < 4; ++c)
        uv(c, 1) -= 3; // tears off the first face
    pushCommand(std::make_unique<SetUvs>(*document, UvEdit::Drag, uv));
    QCOMPARE(document->islands().count(), 3);
    QCOMPARE(document->islands().faces(0), std::vector<int>{0});
    QVERIFY(soupFollows());
    document->undoStack().undo();
    QCOMPARE(document->islands().count(), 2);
    QVERIFY(soupFollows());
    pushCommand(std::make_unique<ChooseUvSet>(*document, 1));
    QCOMPARE(document->islands().count(), 0);
    QCOMPARE(document->islands().islandOfFace(3), -1);
    QVERIFY(soupFollows());
    pushCommand(std::make_unique<DeleteUvSet>(*document, 1));
    QCOMPARE(document->islands().count(), 2);
    QVERIFY(soupFollows());
}

void TestDocument::marksSurviveCuttingAndJoining()
{
    const auto document = test::layoutDocument(test::grid(4));
    const auto flagsOf = [&](int island) {
        return document->marks().flagsOf(document->islands().faces(island));
    };
    const auto tagsOf = [&](int island) {
        return document->marks().tagsOf(document->islands().faces(island));
    };
    using Edit = SetIslandFlags::Edit;
    pushCommand(std::make_unique<SetIslandFlags>(*document, Edit::Lock, std::vector<int>{1}));
    pushCommand(std::make_unique<SetIslandFlags>(*document, Edit::Group, std::vector<int>{1}));
    pushCommand(std::make_unique<SetIslandTag>(*document, u"metal"_s, std::vector<int>{1}, true));
    const IslandFlags marked{.locked = 1, .group = 1};
    QVERIFY(flagsOf(1) == marked);
    QVERIFY(flagsOf(0) == IslandFlags());

    // Both pieces of a cut island keep its marks.
    UvMatrix uv = document->uv();
    for (int c = 40; c < 48; ++c)
        uv(c, 1) += 7; // faces 10 and 11, of island 1
    pushCommand(std::make_unique<SetUvs>(*document, UvEdit::Drag, uv));
    QVERIFY(document->islands().count() > 2);
    for (int island = 1; island < document->islands().count(); ++island) {
        QVERIFY(flagsOf(island) == marked);
        QCOMPARE(tagsOf(island), std::vector<QString>{u"metal"_s});
    }
    document->undoStack().undo();

    // Joined: of two equal halves the lock, the group and the tag win.
    uv = document->uv();
    for (int c = 0; c < uv.rows(); ++c)
        uv(c, 0) = document->mesh().cornerPosition(c).x();
    pushCommand(std::make_unique<SetUvs>(*document, UvEdit::Drag, uv));
    QCOMPARE(document->islands().count(), 1);
    QVERIFY(flagsOf(0) == marked);
    QCOMPARE(tagsOf(0), std::vector<QString>{u"metal"_s});
}

void TestDocument::rulesOfMarks()
{
    IslandMarks marks;
    marks.faceFlags.resize(8);
    for (int face : {0, 1, 2})
        marks.faceFlags[face].stack = 5;
    for (int face : {3, 4})
        marks.faceFlags[face].stack = 2;
    marks.faceFlags[5].stack = 9;
    marks.faceFlags[7].locked = 1;
    marks.tags = {{u"half"_s, {0, 1}}, {u"less"_s, {0}}, {u"none"_s, {7}}};
    QCOMPARE(marks.flagsOf({0, 1, 2, 3, 4}).stack, 5);
    QCOMPARE(marks.flagsOf({0, 5, 3}).stack, 2); // a tie: the smallest
    QCOMPARE(marks.flagsOf({0, 6}).stack, 5);    // "none" loses a tie
    QCOMPARE(marks.flagsOf({0, 6, 7}).stack, 0);
    QCOMPARE(marks.flagsOf({0, 1, 2, 7}).locked, 1); // one locked face is enough
    QCOMPARE(marks.flagsOf({0, 1, 2}).locked, 0);
    QCOMPARE(marks.tagsOf({0, 1, 2, 3}), std::vector<QString>{u"half"_s});
    QCOMPARE(marks.tagsOf({2, 3, 4}), std::vector<QString>());
}

void TestDocument::revisions()
{
    const auto document = test::gridDocument();
    // The parts of the token that a command renews.
    const auto renews = [&](std::unique_ptr<DocumentCommand> command) {
        const StateToken before = document->token();
        if (!pushCommand(std::move(command)))
            return document->token() == before ? u"nothing done"_s : u"token without a change"_s;
        const StateToken &after = document->token();
        QStringList parts;
        if (after.topology != before.topology)
            parts << u"topology"_s;
        if (after.uv != before.uv)
            parts << u"uv"_s;
        if (after.steering != before.steering)
            parts << u"steering"_s;
        return parts.join(u' ');
    };
    const IndexRanges pair = cornerPairsOfEdges(document->mesh(), std::vector<int>{30});
    const auto cut = [&] { return std::make_unique<SetSeamState>(*document, SetSeamState::Edit::Cut, pair); };
    QCOMPARE(renews(cut()), u"steering"_s);
    QCOMPARE(renews(cut()), u"nothing done"_s);
    QCOMPARE(renews(std::make_unique<SetSeamWeights>(*document, pair, std::vector<double>{2, 2})),
             u"steering"_s);
    QCOMPARE(renews(SetTexelWeights::uniform(*document, IndexRanges::all(3), 2)), u"steering"_s);
    QCOMPARE(renews(SetTexelWeights::uniform(*document, IndexRanges::all(3), 2)), u"nothing done"_s);
    QCOMPARE(renews(EditPins::unpin(*document, std::vector<int>{3})), u"steering"_s);
    SolveSettings solve;
    solve.lambda = 0.5;
    QCOMPARE(renews(std::make_unique<ChangeSettings>(*document, solve)), u"steering"_s);
    PackingSettings packing;
    packing.margin = 3;
    QCOMPARE(renews(std::make_unique<ChangeSettings>(*document, packing)), u""_s);
    UvMatrix uv = document->uv();
    uv(0, 0) = 9;
    QCOMPARE(renews(std::make_unique<SetUvs>(*document, UvEdit::Solve, uv)), u"uv"_s);
    QCOMPARE(renews(std::make_unique<SetUvs>(*document, UvEdit::Finish, uv, UvEditExtras{0, 2.0, {}})),
             u"uv"_s);
    QCOMPARE(renews(std::make_unique<ChooseUvSet>(*document, 1)), u"topology"_s);
    LayoutRectangle renamed = document->constraints().rectangles[0];
    renamed.name = u"x"_s;
    const auto rename = [&] {
        return std::make_unique<EditRectangles>(*document, EditRectangles::Edit::Rename,
                                                std::vector<LayoutRectangle>{renamed});
    };
    QCOMPARE(renews(rename()), u""_s);
    // Undo is a change like any other: a result for the state before it is out of date.
    const StateToken before = document->token();
    document->undoStack().setIndex(0);
    QVERIFY(!document->token().sameMap(before));
    QVERIFY(document->token().steering != before.steering);
    QVERIFY(document->token().uv > before.uv);
    // And no two documents share one.
    QVERIFY(!test::gridDocument()->token().sameMap(test::gridDocument()->token()));
}

void TestDocument::snapshotUnits()
{
    DocumentState state = test::gridDocument()->state();
    state.uvScales[0] = 0.25;
    state.solveSettings.start = StartMode::ExistingUv;
    state.constraints.rectangles[0].hard = true;
    const auto document = std::move(Document::create(std::move(state)).value());
    const MeshData &mesh = document->mesh();
    const Snapshot snapshot = makeSnapshot(*document);
    QCOMPARE(snapshot.mesh.get(), &mesh);
    QVERIFY(snapshot.token == document->token());
    QCOMPARE(snapshot.steering->pairState, document->seams().states);
    QCOMPARE(snapshot.steering->pairWeight, document->seams().weights);
    QVERIFY(snapshot.settings == document->solveSettings());

    std::size_t pinned = 0;
    for (const Pin &pin : snapshot.steering->pins) {
        const UvPin *own = document->constraints().pin(mesh.cornerOfSoup(pin.soupCorner));
        QVERIFY(own);
        QCOMPARE(pin.target, Vec2(own->position * 4));
        QCOMPARE(pin.hard, own->hard);
        QCOMPARE(pin.weight, own->weight);
        ++pinned;
    }
    std::size_t expected = 0;
    for (int s = 0; s < mesh.soupCornerCount(); ++s)
        expected += document->constraints().pin(mesh.cornerOfSoup(s)) != nullptr;
    QCOMPARE(pinned, expected);

    QCOMPARE(snapshot.steering->rectangles.size(), std::size_t(1)); // the other one has no faces
    QCOMPARE(snapshot.steering->rectangles[0].upper, Vec2(2, 2));
    QVERIFY(snapshot.steering->rectangles[0].hard);
    QCOMPARE(snapshot.steering->rectangles[0].soupCorners.size(), std::size_t(3 * 6));
    for (int s : snapshot.steering->rectangles[0].soupCorners) {
        const int face = mesh.triangleFace[s / 3];
        QVERIFY(face == 0 || face == 1 || face == 4);
    }
    QVERIFY(snapshot.startUv);
    QCOMPARE(snapshot.startUv->rows(), Eigen::Index(mesh.soupCornerCount()));
    QVERIFY(sameBits(documentUvs(*document, *snapshot.startUv), document->uv())); // 0.25 is exact

    SolveSettings rigid = document->solveSettings();
    rigid.start = StartMode::Rigid;
    pushCommand(std::make_unique<ChangeSettings>(*document, rigid));
    QVERIFY(!makeSnapshot(*document).startUv);
}

//! Locked islands of one UV set must not lock faces that have no UVs in another.
void TestDocument::flagsHoldWhatHasAPlace()
{
    const auto document = test::gridDocument();
    pushCommand(std::make_unique<SetIslandFlags>(*document, SetIslandFlags::Edit::Lock, std::vector<int>{0}));
    const auto locked = [&] {
        const Snapshot snapshot = makeSnapshot(*document);
        return std::ranges::count_if(snapshot.steering->faceFlags,
                                     [](const IslandFlags &flags) { return flags.locked != 0; });
    };
    QVERIFY(locked() > 0);
    pushCommand(std::make_unique<AddUvSet>(*document, u"Empty"_s, -1));
    QCOMPARE(locked(), 0);
    document->undoStack().undo();
    QVERIFY(locked() > 0);
}

void TestDocument::snapshotOfPolygons()
{
    // Of the soup corners of one corner the first one counts.
    const auto document = test::layoutDocument(test::quadCube());
    const MeshData &mesh = document->mesh();
    UvMatrix soup(mesh.soupCornerCount(), 2);
    for (int s = 0; s < mesh.soupCornerCount(); ++s)
        soup.row(s) << s, -s;
    const UvMatrix uv = documentUvs(*document, soup);
    std::vector<bool> seen(mesh.cornerCount(), false);
    for (int s = 0; s < mesh.soupCornerCount(); ++s) {
        const int c = mesh.cornerOfSoup(s);
        if (!seen[c])
            QCOMPARE(uv(c, 0), document->uvScale() * s);
        seen[c] = true;
    }
}

void TestDocument::scaleOfALayout()
{
    // A flat grid of area 1 laid out at half its size: a unit of the solver is 1 / sqrt(pi) of the mesh's.
    const auto mesh = test::grid(4);
    UvMatrix uv = 0.5 * test::splitLayout(*mesh);
    const double expected = 0.5 / std::sqrt(std::numbers::pi);
    QVERIFY(std::abs(layoutScale(*mesh, uv) - expected) < 1e-12);
    for (int c = 0; c < 16; ++c)
        uv(c, 0) = std::numeric_limits<double>::quiet_NaN(); // faces without UVs do not count
    QVERIFY(std::abs(layoutScale(*mesh, uv) - expected) < 1e-12);
    QCOMPARE(layoutScale(*mesh, emptyLayout(*mesh)), defaultUvScale);
    uv.setZero();
    QCOMPARE(layoutScale(*mesh, uv), defaultUvScale);
}

QTEST_GUILESS_MAIN(TestDocument)

} // namespace tst_document

#include "tst_document.moc"
