// Gestures: what merges, what vanishes, what comes back; and rules of single commands.
#include "commands/commandfactory.h"
#include "commands/edituvsets.h"
#include "commands/islandtransform.h"
#include "commands/setseamweights.h"
#include "support/commandcases.h"
#include "support/editsupport.h"

#include <QTest>

namespace tst_gestures {

using namespace autocuts;
using namespace autocuts::test;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Steps of one gesture that are to become one entry.
struct MergeCase
{
    const char *name;
    std::vector<Make> steps;
    Make back;        //!< returns to the start (null: cannot be)
    const char *text; //!< without translations, so with "1 edges"
};

std::vector<MergeCase> mergeCases()
{
    using Rect = EditRectangles::Edit;
    const auto moveTo = [](double u) {
        return rectangle(Rect::Move, 1, [u](LayoutRectangle &r) { r.lower.x() = u, r.upper.x() = u + 0.5; });
    };
    const auto pinTo = [](double u) { return pins(EditPins::Edit::Move, {{3, {u, 0.5}, true, 1}}); };
    const auto lambda = [](double l) { return solve([l](SolveSettings &s) { s.lambda = l; }); };
    const auto margin = [](int m) { return packing([m](PackingSettings &s) { s.margin = m; }); };
    const auto setTo = [](int i) { return [i](Document &d) { return std::make_unique<ChooseUvSet>(d, i); }; };
    const auto draw = [](Document &d) { return EditRectangles::add(d, named(u"new"_s)); };
    const auto drag = rectangle(Rect::Resize, 1, [](LayoutRectangle &r) { r.upper = {3, 3}; });
    const auto enlarge = [](Document &d) {
        LayoutRectangle r = *d.constraints().rectangle(2);
        r.upper = {4, 4};
        return std::make_unique<EditRectangles>(d, Rect::Resize, std::vector<LayoutRectangle>{r});
    };
    using Seam = SetSeamState::Edit;
    return {
        {"cut stroke",
         {seams(Seam::Cut, 30, 1), seams(Seam::Cut, 30, 2), seams(Seam::Cut, 20, 2)},
         nullptr,
         "Cut 4 edges"},
        {"paint stroke",
         {paint(64, 2, 2), paint(65, 3, 3), paint(64, 1, 4)},
         paint(64, 4, 1),
         "Paint 2 edges"},
        {"rectangle drag", {moveTo(1), moveTo(2), moveTo(3)}, moveTo(0), "Move 1 rectangles"},
        {"rectangle resize",
         {drag},
         rectangle(Rect::Resize, 1,
                   [](LayoutRectangle &r) {
                       r.upper = {0.5, 0.5};
                   }),
         "Resize 1 rectangles"},
        {"draw rectangle", {draw, enlarge}, nullptr, "Add rectangle"},
        {"pin drag", {pinTo(1), pinTo(2)}, pinTo(0.25), "Move 1 pins"},
        {"vertex drag",
         {uvs(UvEdit::Drag, 7, 1, {1, {}, {}}), uvs(UvEdit::Drag, 8, 2, {1, {}, {}}),
          uvs(UvEdit::Drag, 7, 3, {1, {}, {}}), uvs(UvEdit::Drag, 8, 1.5, {1, {}, {}})},
         uvs(UvEdit::Drag, 7, 0.25, {1, {}, {}}),
         "Drag 1 vertices"},
        {"solver run",
         {uvs(UvEdit::Solve, 7, 1), uvs(UvEdit::Solve, 9, 2), uvs(UvEdit::Solve, 9, 3)},
         nullptr,
         "Solve"},
        {"lambda slider", {lambda(0.1), lambda(0.2), lambda(0.3)}, lambda(0), "Change lambda"},
        {"margin slider", {margin(1), margin(2)}, margin(8), "Change margin"},
        {"UV set list", {setTo(1)}, setTo(0), "Choose UV set"},
    };
}

} // namespace

class TestGestures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void gestureIsOneEntry_data();
    void gestureIsOneEntry();
    void gesturesStayApart_data() { gestureIsOneEntry_data(); }
    void gesturesStayApart();
    void escapeLeavesNothing_data() { gestureIsOneEntry_data(); }
    void escapeLeavesNothing();
    void slidersOfTwoPropertiesStayApart();

    void diagonalsAreNeverCut();
    void halfCut();
    void islandDragReturnsExactly();
    void lockedIslandsStay();
    void undoBringsBackTheSelection();
    void deletedUvSetComesBackWithItsContent();
    void rectangleIdsAreUsedAgain();
};

void TestGestures::gestureIsOneEntry_data()
{
    QTest::addColumn<int>("index");
    const auto all = mergeCases();
    for (std::size_t i = 0; i < all.size(); ++i)
        QTest::newRow(all[i].name) << static_cast<int>(i);
}

void TestGestures::gestureIsOneEntry()
{
    QFETCH(int, index);
    const MergeCase c = mergeCases()[index];
    const auto document = gridDocument();
    UndoStack &stack = document->undoStack();
    pushCommand(flags(SetIslandFlags::Edit::Group, {1})(*document));
    const DocumentState before = document->state();
    const quint64 gesture = stack.newGesture();
    const auto step = [&](const Make &make) {
        auto command = make(*document);
        command->setGesture(gesture);
        return pushCommand(std::move(command));
    };
    for (const Make &make : c.steps)
        QVERIFY(step(make));
    const DocumentState after = document->state();
    QCOMPARE(stack.count(), 2);
    QCOMPARE(stack.undoText(), QString::fromLatin1(c.text));
    stack.undo();
    QVERIFY(document->state() == before);
    stack.redo();
    QVERIFY(document->state() == after);
    if (!c.back)
        return;
    step(c.back);
    if (QByteArray(c.name) == "vertex drag")
        step(uvs(UvEdit::Drag, 8, 1.5, {1, {}, {}}));
    QVERIFY(document->state() == before);
    QCOMPARE(stack.count(), 1); // a gesture that returns to its start leaves no entry
    QCOMPARE(stack.index(), 1);
}

void TestGestures::gesturesStayApart()
{
    QFETCH(int, index);
    const MergeCase c = mergeCases()[index];
    const auto document = gridDocument();
    UndoStack &stack = document->undoStack();
    for (const Make &make : c.steps) {
        auto command = make(*document);
        command->setGesture(stack.newGesture());
        QVERIFY(pushCommand(std::move(command)));
    }
    QCOMPARE(stack.count(), static_cast<int>(c.steps.size()));
    // Nor do commands without a gesture merge.
    const auto second = gridDocument();
    for (const Make &make : c.steps)
        QVERIFY(pushCommand(make(*second)));
    QCOMPARE(second->undoStack().count(), static_cast<int>(c.steps.size()));
}

void TestGestures::escapeLeavesNothing()
{
    QFETCH(int, index);
    const MergeCase c = mergeCases()[index];
    const auto document = gridDocument();
    UndoStack &stack = document->undoStack();
    pushCommand(flags(SetIslandFlags::Edit::Group, {1})(*document));
    const DocumentState before = document->state();
    const quint64 gesture = stack.newGesture();
    for (const Make &make : c.steps) {
        auto command = make(*document);
        command->setGesture(gesture);
        pushCommand(std::move(command));
    }
    QVERIFY(!cancelGesture(*document, gesture + 1));
    QVERIFY(cancelGesture(*document, gesture));
    QVERIFY(document->state() == before);
    QCOMPARE(stack.count(), 1);
    QVERIFY(!stack.canRedo());
    QVERIFY(!cancelGesture(*document, gesture));
    stack.undo();
    QVERIFY(stack.canRedo());
}

void TestGestures::slidersOfTwoPropertiesStayApart()
{
    const auto document = gridDocument();
    const quint64 gesture = document->undoStack().newGesture();
    const auto step = [&](const Make &make) {
        auto command = make(*document);
        command->setGesture(gesture);
        pushCommand(std::move(command));
    };
    step(solve([](SolveSettings &s) { s.lambda = 0.5; }));
    step(solve([](SolveSettings &s) { s.delta = 0.5; }));
    step(packing([](PackingSettings &s) { s.margin = 3; }));
    QCOMPARE(document->undoStack().count(), 3);
}

void TestGestures::diagonalsAreNeverCut()
{
    const auto document = layoutDocument(quadCube());
    const MeshData &mesh = document->mesh();
    const IndexRanges all = IndexRanges::all(mesh.cornerPairCount());
    QVERIFY(pushCommand(std::make_unique<SetSeamState>(*document, SetSeamState::Edit::Cut, all)));
    QCOMPARE(document->undoStack().undoText(), u"Cut 12 edges"_s);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const bool diagonal = mesh.edgePairs[e].diagonal;
        QVERIFY(document->seams().edgeIs(static_cast<int>(e), diagonal ? PairState::Free : PairState::Cut));
    }
    const std::vector<double> two(all.count(), 2.0);
    QVERIFY(pushCommand(std::make_unique<SetSeamWeights>(*document, all, two)));
    QCOMPARE(document->validate(), QString());
    // Nor through the journal.
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        if (!mesh.edgePairs[e].diagonal)
            continue;
        IndexRanges pair;
        pair.append(static_cast<int>(2 * e));
        const QCborMap map{{"id"_L1, 1},
                           {"edit"_L1, 1},
                           {"ranges"_L1, packedRanges(pair)},
                           {"bits"_L1, QByteArray("\x01\x01", 2)}};
        QVERIFY(!makeCommand(map, *document).ok());
    }
}

void TestGestures::halfCut()
{
    const auto document = layoutDocument(cube());
    IndexRanges pair;
    int edge = 0;
    while (document->mesh().edgePairs[edge].diagonal)
        ++edge;
    pair.append(2 * edge + 1);
    QVERIFY(pushCommand(std::make_unique<SetSeamState>(*document, SetSeamState::Edit::Cut, pair)));
    QCOMPARE(document->seams().states[2 * edge], PairState::Free);
    QCOMPARE(document->seams().states[2 * edge + 1], PairState::Cut);
    QCOMPARE(document->undoStack().undoText(), UndoText::tr("Cut %n edges", nullptr, 1));
}

void TestGestures::islandDragReturnsExactly()
{
    const auto document = layoutDocument(grid(4));
    const DocumentState before = document->state();
    const IslandTransform gesture(*document, UvEdit::Move, {0, 1});
    for (double u : {0.1, 0.3, 0.7, 1.0 / 3})
        QVERIFY(pushCommand(gesture.command(moved(u, 3 * u))));
    QCOMPARE(document->undoStack().count(), 1);
    QCOMPARE(document->uv()(0, 0), before.scene.uvSets[0].uv(0, 0) + 1.0 / 3);
    QVERIFY(pushCommand(gesture.command(Eigen::Affine2d::Identity())));
    QVERIFY(document->state() == before);
    QCOMPARE(document->undoStack().count(), 0);
}

void TestGestures::lockedIslandsStay()
{
    const auto document = gridDocument(); // with a locked face in the second island
    const DocumentState before = document->state();
    QVERIFY(!IslandTransform(*document, UvEdit::Move, {1}).canMove());
    QVERIFY(pushCommand(transform(UvEdit::Move, moved(1, 2), {0, 1})(*document)));
    QCOMPARE(document->undoStack().undoText(), UndoText::tr("Move %n islands", nullptr, 1));
    const UvMatrix &was = before.scene.uvSets[0].uv;
    for (int c = 0; c < document->mesh().cornerCount(); ++c) {
        const bool second = document->islands().islandOfFace(c / 4) == 1;
        const Vec2 shift = (document->uv().row(c) - was.row(c)).transpose();
        QCOMPARE(shift, second ? Vec2(0, 0) : Vec2(1, 2));
    }
    QCOMPARE(document->constraints().pin(3)->position, Vec2(1.25, 2.5)); // travels with its island
    QCOMPARE(document->constraints().pin(40)->position, Vec2(1.5, 0.5));
}

void TestGestures::undoBringsBackTheSelection()
{
    const auto document = gridDocument();
    Selection used;
    used.mode = SelectionMode::Edges;
    used.edges = {0, 2};
    document->setSelection(used);
    pushCommand(seams(SetSeamState::Edit::Cut, 30, 2)(*document));
    document->undoStack().setClean();
    document->setSelection({});
    QVERIFY(document->undoStack().isClean()); // selecting does not dirty the file
    QCOMPARE(document->undoStack().count(), 1);
    document->undoStack().undo();
    QVERIFY(document->selection() == used);
    document->setSelection({});
    document->undoStack().redo();
    QVERIFY(document->selection() == used);
}

void TestGestures::deletedUvSetComesBackWithItsContent()
{
    const auto document = layoutDocument(grid(20, 0.1)); // large enough to be packed
    const DocumentState before = document->state();
    QVERIFY(pushCommand(std::make_unique<DeleteUvSet>(*document, 0)));
    QCOMPARE(document->activeUvSet(), 0);
    QCOMPARE(document->uvSets().size(), std::size_t(1));
    QVERIFY(!DeleteUvSet(*document, 0).hasAnyChanges()); // the last one stays
    QVERIFY(pushCommand(std::make_unique<AddUvSet>(*document, QString())));
    QCOMPARE(document->uvSets()[1].name, u"UVMap"_s);
    document->undoStack().setIndex(0);
    QVERIFY(document->state() == before);
}

void TestGestures::rectangleIdsAreUsedAgain()
{
    const auto document = gridDocument(); // has 1 and 4
    for (int id : {2, 3, 5}) {
        QVERIFY(pushCommand(EditRectangles::add(*document, {})));
        QVERIFY(document->constraints().rectangle(id));
    }
    LayoutRectangle turned;
    turned.lower = {1, 0};
    turned.upper = {0, 1};
    QVERIFY(pushCommand(EditRectangles::add(*document, turned)));
    QCOMPARE(document->constraints().rectangle(6)->lower, Vec2(0, 0));
    QCOMPARE(document->constraints().rectangle(6)->upper, Vec2(1, 1));
}

QTEST_GUILESS_MAIN(TestGestures)

} // namespace tst_gestures

#include "tst_gestures.moc"
