// UndoStack: the memory limit, the saved mark, and what a thousand steps take.
#include "commands/setseamstate.h"
#include "commands/setuvs.h"
#include "commands/xordelta.h"
#include "support/editsupport.h"
#include "support/randomedits.h"

#include <QTest>

#include <numeric>

namespace tst_undostack {

using namespace autocuts;

namespace {

//! A step that changes every UV of the document; corners of one vertex stay together.
std::unique_ptr<DocumentCommand> smoothStep(Document &document, double amount)
{
    UvMatrix uv = document.uv();
    for (int c = 0; c < document.mesh().cornerCount(); ++c) {
        const int vertex = document.mesh().cornerVertex[c];
        uv(c, 0) += amount * std::sin(double(vertex));
        uv(c, 1) += amount * std::cos(double(vertex));
    }
    return std::make_unique<SetUvs>(document, UvEdit::Solve, uv);
}

} // namespace

class TestUndoStack : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void memoryIsCountedAndGivenBack();
    void oldestEntriesGiveWay();
    void savedMarkBelowTheLimitIsLost();
    void mergingStopsAtTheSavedMark();
    void largeStepsArePacked();
    void thousandStepsFitIntoMemory();
    void packedDeltasAreExact_data();
    void packedDeltasAreExact();
};

void TestUndoStack::memoryIsCountedAndGivenBack()
{
    const auto document = test::layoutDocument(test::grid(10));
    UndoStack &stack = document->undoStack();
    QCOMPARE(stack.memoryUsed(), 0);
    QVERIFY(pushCommand(smoothStep(*document, 0.1)));
    const qint64 one = stack.memoryUsed();
    QVERIFY(one >= 16 * document->mesh().cornerCount());
    QVERIFY(pushCommand(smoothStep(*document, 0.2)));
    QVERIFY(stack.memoryUsed() > one);
    stack.undo();
    stack.undo();
    const IndexRanges pair = cornerPairsOfEdges(document->mesh(), std::vector<int>{0});
    QVERIFY(pushCommand(std::make_unique<SetSeamState>(*document, SetSeamState::Edit::Cut, pair)));
    QVERIFY(stack.memoryUsed() < 100); // the two steps were dropped
    stack.clear();
    QCOMPARE(stack.memoryUsed(), 0);
}

void TestUndoStack::oldestEntriesGiveWay()
{
    const auto document = test::layoutDocument(test::grid(10));
    UndoStack &stack = document->undoStack();
    std::vector<DocumentState> states{document->state()};
    int given = 0;
    connect(&stack, &UndoStack::aboutToRelease, this, [&](const UndoEntry &entry) {
        // A journal can still read what is about to go.
        QVERIFY(!static_cast<const DocumentCommand &>(entry).toCbor().isEmpty());
        QCOMPARE(&entry, stack.command(stack.releasedCount()));
        ++given;
    });
    stack.setMemoryLimit(40000);
    for (int i = 0; i < 30; ++i) {
        QVERIFY(pushCommand(smoothStep(*document, 0.1 + i)));
        QVERIFY(stack.memoryUsed() <= 40000);
        states.push_back(document->state());
    }
    const int released = stack.releasedCount();
    QVERIFY(released > 5);
    QVERIFY(released < 29);
    QCOMPARE(given, released);
    QCOMPARE(stack.count(), 30);

    for (int i = 30; i > released; --i) {
        QVERIFY(document->state() == states[i]);
        QVERIFY(stack.canUndoFurther());
        stack.undo();
    }
    QVERIFY(document->state() == states[released]);
    QVERIFY(!stack.canUndoFurther());
    stack.undo(); // takes the entry off and changes nothing
    QVERIFY(document->state() == states[released]);
    stack.setIndex(0);
    QVERIFY(document->state() == states[released]);
    QCOMPARE(stack.releasedCount(), 0);
    QCOMPARE(stack.count(), 30 - released);
    stack.setIndex(stack.count());
    QVERIFY(document->state() == states[30]);

    stack.setMemoryLimit(0); // the newest one always stays
    QCOMPARE(stack.releasedCount(), stack.count() - 1);
    stack.undo();
    QVERIFY(document->state() == states[29]);
}

void TestUndoStack::savedMarkBelowTheLimitIsLost()
{
    const auto document = test::layoutDocument(test::grid(10));
    UndoStack &stack = document->undoStack();
    QVERIFY(stack.isClean());
    for (int i = 0; i < 4; ++i)
        pushCommand(smoothStep(*document, 1 + i));
    stack.setMemoryLimit(0);
    stack.setIndex(0);
    QVERIFY(!stack.isClean()); // not the state that was saved
    // A mark above the released entries stays.
    pushCommand(smoothStep(*document, 7));
    stack.setClean();
    pushCommand(smoothStep(*document, 8));
    QVERIFY(!stack.isClean());
    stack.undo();
    QVERIFY(stack.isClean());
}

void TestUndoStack::mergingStopsAtTheSavedMark()
{
    const auto document = test::layoutDocument(test::grid(4));
    UndoStack &stack = document->undoStack();
    const quint64 gesture = stack.newGesture();
    for (int i = 0; i < 4; ++i) {
        auto command = smoothStep(*document, 1 + i);
        command->setGesture(gesture);
        pushCommand(std::move(command));
        if (i == 1)
            stack.setClean();
    }
    QCOMPARE(stack.count(), 2);
    stack.undo();
    QVERIFY(stack.isClean());
}

void TestUndoStack::largeStepsArePacked()
{
    // 50 x 50 quads: 10,000 corners of 2,601 vertices.
    const auto document = test::layoutDocument(test::grid(50, 0.2));
    const DocumentState first = document->state();
    UndoStack &stack = document->undoStack();
    for (int i = 0; i < 101; ++i)
        pushCommand(smoothStep(*document, 0.01 * (i + 1)));
    const double perStep = double(stack.memoryUsed() - 16 * 10000) / 100;
    QVERIFY2(perStep < 20 * 2651, qPrintable(QString::number(perStep)));
    const DocumentState last = document->state();
    stack.setIndex(0);
    QVERIFY(document->state() == first);
    stack.setIndex(101);
    QVERIFY(document->state() == last);
}

void TestUndoStack::thousandStepsFitIntoMemory()
{
    // A hundred steps that each change all UVs of 50,000 triangles; a thousand have to stay below 500 MB.
    const auto document = test::layoutDocument(test::grid(158, 0.2));
    QVERIFY(document->mesh().triangleCount() > 49900);
    for (int i = 0; i < 100; ++i)
        pushCommand(smoothStep(*document, 0.001 * (i + 1)));
    QCOMPARE(document->undoStack().releasedCount(), 0);
    QVERIFY(10 * document->undoStack().memoryUsed() < UndoStack::defaultMemoryLimit);
}

void TestUndoStack::packedDeltasAreExact_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("distinct");
    QTest::addColumn<int>("step");
    QTest::addColumn<bool>("ordered");
    for (bool ordered : {false, true}) {
        QTest::addRow("one %d", ordered) << 1 << 1 << 1 << ordered;
        QTest::addRow("all equal %d", ordered) << 5000 << 1 << 1 << ordered;
        QTest::addRow("few %d", ordered) << 5000 << 10 << 1 << ordered;
        QTest::addRow("noise %d", ordered) << 5000 << 5000 << 1 << ordered;
        QTest::addRow("every third %d", ordered) << 5000 << 100 << 3 << ordered;
    }
}

void TestUndoStack::packedDeltasAreExact()
{
    QFETCH(int, count);
    QFETCH(int, distinct);
    QFETCH(int, step);
    QFETCH(bool, ordered);
    test::Random random(5);
    std::vector<double> before(count), after(count);
    std::vector<int> order(count);
    for (int i = 0; i < count; ++i) {
        before[i] = random.unit();
        after[i] = i % step == 0 ? double(1 + random.below(distinct)) : before[i];
        order[i] = count - 1 - i;
    }
    const std::span<const int> used = ordered ? std::span<const int>(order) : std::span<const int>();
    XorDelta delta = XorDelta::between<double>(before.data(), IndexRanges::all(count), after);
    QCOMPARE(delta.indices().count(), (count + step - 1) / step);
    const auto check = [&](const XorDelta &d) {
        const std::vector<double> values = d.applied(before.data());
        const std::vector<double> back = d.applied(after.data());
        std::size_t next = 0;
        d.indices().forEach([&](int i) {
            QCOMPARE(values[next], after[i]);
            QCOMPARE(back[next++], before[i]);
        });
    };
    check(delta);
    QCborMap map;
    delta.write(map, used);
    CborReader reader(map);
    check(XorDelta::read(reader, sizeof(double), count, used));
    QVERIFY(!reader.failed());
    CborReader smaller(map);
    const int tooFew = (count - 1) / step * step; // the last index that differs
    std::vector<int> shortOrder(ordered ? tooFew : 0);
    std::iota(shortOrder.begin(), shortOrder.end(), 0);
    XorDelta::read(smaller, sizeof(double), tooFew, shortOrder);
    QVERIFY(smaller.failed());
    delta.pack(std::make_shared<std::pmr::unsynchronized_pool_resource>(), used);
    check(delta);
    XorDelta twice = delta;
    twice.combine(delta);
    QVERIFY(twice.isEmpty());
}

QTEST_GUILESS_MAIN(TestUndoStack)

} // namespace tst_undostack

#include "tst_undostack.moc"
