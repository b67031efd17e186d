// Property test: long random sequences of commands, undo and redo on several meshes.
#include "commands/commandfactory.h"
#include "support/editsupport.h"
#include "support/objpolygons.h"
#include "support/randomedits.h"

#include <QTest>

namespace tst_commandproperty {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int steps = 10000;

test::MeshPtr meshNamed(const QString &name)
{
    if (name == u"quad cube")
        return test::quadCube();
    if (name == u"grid")
        return test::grid(6, 0.2);
    if (name == u"sphere")
        return test::sphere(8, 12);
    if (name == u"torus")
        return test::torus(12, 8);
    if (test::meshFolder().empty())
        return nullptr;
    return test::readObjPolygons(test::meshFolder() + "/polygons/suzanne.obj");
}

void addMeshes()
{
    QTest::addColumn<QString>("mesh");
    for (const char *name : {"quad cube", "grid", "sphere", "torus", "real"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

} // namespace

class TestCommandProperty : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void undoAllAndRedoAll_data() { addMeshes(); }
    void undoAllAndRedoAll();
    void replayGivesTheSameState_data() { addMeshes(); }
    void replayGivesTheSameState();
};

void TestCommandProperty::undoAllAndRedoAll()
{
    QFETCH(QString, mesh);
    const test::MeshPtr data = meshNamed(mesh);
    if (!data)
        QSKIP(test::noMeshes);
    const auto document = test::layoutDocument(data);
    UndoStack &stack = document->undoStack();
    const DocumentState first = document->state();
    test::RandomEdits edits(qHash(mesh, 7));
    test::Random &random = edits.random();
    int merged = 0;
    for (int step = 0; step < steps; ++step) {
        if (random.oneIn(5))
            edits.select(*document);
        const int before = stack.index();
        if (pushCommand(edits.next(*document)))
            merged += stack.index() <= before;
        if (const QString problem = document->validate(); !problem.isEmpty())
            QFAIL(qPrintable(u"step %1: %2"_s.arg(step).arg(problem)));
        if (!random.oneIn(6))
            continue;
        const DocumentState here = test::withoutSelection(document->state());
        const int index = stack.index();
        const int back = random.below(std::min(stack.index(), 8) + 1);
        for (int i = 0; i < back; ++i) {
            stack.undo();
            QCOMPARE(document->validate(), QString());
        }
        if (random.oneIn(3))
            continue; // the next command drops what was undone
        stack.setIndex(index);
        QVERIFY(test::withoutSelection(document->state()) == here);
    }
    const DocumentState last = test::withoutSelection(document->state());
    QCOMPARE(stack.releasedCount(), 0);
    QVERIFY(stack.count() > steps / 4);
    QVERIFY(merged > steps / 100);
    const int index = stack.index();
    stack.setIndex(0);
    QVERIFY(test::withoutSelection(document->state()) == first);
    stack.setIndex(index);
    QVERIFY(test::withoutSelection(document->state()) == last);
}

void TestCommandProperty::replayGivesTheSameState()
{
    QFETCH(QString, mesh);
    const test::MeshPtr data = meshNamed(mesh);
    if (!data)
        QSKIP(test::noMeshes);
    const auto document = test::layoutDocument(data);
    const auto second = test::layoutDocument(data);
    test::RandomEdits edits(qHash(mesh, 11));
    for (int step = 0; step < 1000; ++step)
        pushCommand(edits.next(*document));
    const UndoStack &stack = document->undoStack();
    for (int i = 0; i < stack.count(); ++i) {
        const auto &entry = static_cast<const DocumentCommand &>(*stack.command(i));
        const QCborMap map = QCborValue::fromCbor(entry.toCbor().toCborValue().toCbor()).toMap();
        auto command = makeCommand(map, *second);
        QVERIFY2(command.ok(), qPrintable(u"%1: %2"_s.arg(i).arg(entry.text())));
        QVERIFY(pushCommand(std::move(command.value())));
        QCOMPARE(second->undoStack().text(i), entry.text());
    }
    QVERIFY(second->state() == document->state());
}

QTEST_GUILESS_MAIN(TestCommandProperty)

} // namespace tst_commandproperty

#include "tst_commandproperty.moc"
