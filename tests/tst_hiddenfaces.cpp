// Hidden faces in the document: selection, undo, journal, session file and re-linking.
#include "commands/commandfactory.h"
#include "commands/hidefaces.h"
#include "model/editing/relink.h"
#include "model/io/projects/projectfile.h"
#include "support/editsupport.h"

#include <QTest>

namespace tst_hiddenfaces {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

void hide(Document &document, const QList<int> &faces, bool hidden = true)
{
    QVERIFY(pushCommand(HideFaces::change(document, faces, hidden)));
}

} // namespace

class TestHiddenFaces : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsHiddenIsNotSelected()
    {
        const auto document = test::layoutDocument(test::grid(2));
        Selection all;
        all.faces = {0, 1, 2, 3};
        const MeshAdjacency &adjacency = document->adjacency();
        for (int edge = 0; edge < adjacency.edgeCount(); ++edge) {
            if (!adjacency.isDiagonal(edge))
                all.edges << edge;
        }
        for (int corner = 0; corner < document->mesh().cornerCount(); ++corner)
            all.corners << corner;
        document->setSelection(all);
        QCOMPARE(document->selection().edges.size(), 12);

        hide(*document, {0, 1});
        const Selection &rest = document->selection();
        QCOMPARE(rest.faces, QList<int>({2, 3}));
        QCOMPARE(rest.corners, QList<int>({8, 9, 10, 11, 12, 13, 14, 15}));
        QCOMPARE(rest.edges.size(), 7); // those of two quads
        for (int edge : rest.edges) {
            const auto faces = adjacency.edgeFaces(edge);
            QVERIFY(faces[0] >= 2 || faces[1] >= 2);
        }
        document->setSelection(all);
        QCOMPARE(document->selection(), rest);
        QCOMPARE(document->validate(), QString());
    }

    void undoShowsAndSelectsAgain()
    {
        const auto document = test::gridDocument();
        const DocumentState before = document->state();
        const StateToken token = document->token();
        hide(*document, {2, 5});
        QCOMPARE(document->selection().faces, QList<int>({1, 3}));
        QVERIFY(document->hidden()[2] && document->hidden()[5] && !document->hidden()[0]);
        QVERIFY(document->token() == token); // no result of a job depends on it
        QCOMPARE(document->undoStack().text(0), u"Hide 2 faces"_s);
        document->undoStack().undo();
        QVERIFY(document->state() == before);
        QVERIFY(document->hidden().empty());
        document->undoStack().redo();
        QCOMPARE(document->state().hiddenFaces, QList<int>({2, 5}));
        QCOMPARE(document->selection().faces, QList<int>({1, 3}));
        hide(*document, {5}, false);
        QCOMPARE(document->undoStack().text(1), UndoText::tr("Show %n faces", nullptr, 1));
        QVERIFY(pushCommand(HideFaces::others(*document, {0, 1})));
        QCOMPARE(document->state().hiddenFaces.size(), 14);
        QVERIFY(!pushCommand(HideFaces::others(*document, {0, 1, 2})));
        QVERIFY(pushCommand(std::make_unique<HideFaces>(*document, QList<int>())));
        QCOMPARE(document->undoStack().text(3), u"Show all faces"_s);
    }

    void damagedCommandsAreRefused()
    {
        const auto document = test::gridDocument();
        const QCborMap good = HideFaces::change(*document, {3}, true)->toCbor();
        QVERIFY(makeCommand(good, *document).ok());
        QCborMap bad = good;
        bad[u"faces"_s] = packedIntegers(std::vector<int>{16});
        QVERIFY(!makeCommand(bad, *document).ok());
        bad[u"faces"_s] = packedIntegers(std::vector<int>{3, 2});
        QVERIFY(!makeCommand(bad, *document).ok());
    }

    void sessionsKeepThem()
    {
        const auto document = test::gridDocument();
        ProjectWriter writer;
        const QByteArray older = writer.bytes(document->state(), {});
        QVERIFY(parseProject(older, u"a"_s)->state.hiddenFaces.isEmpty());
        hide(*document, {0, 9});
        const Result<LoadedProject> loaded = parseProject(writer.bytes(document->state(), {}), u"a"_s);
        QVERIFY(loaded.ok() && loaded->lost.isEmpty());
        QVERIFY(loaded->state == document->state());
        const Document opened(loaded->state);
        QVERIFY(opened.hidden()[9]);
    }

    void anotherModelHasItsOwn()
    {
        const auto document = test::gridDocument();
        hide(*document, {0, 9});
        const Relinked same = relinkDocument(document->state(), test::sceneOf(test::grid(4, 0.2)));
        QCOMPARE(same.state.hiddenFaces, QList<int>({0, 9}));
        const Relinked other = relinkDocument(document->state(), test::sceneOf(test::quadCube()));
        QVERIFY(other.state.hiddenFaces.isEmpty());
    }
};

QTEST_APPLESS_MAIN(TestHiddenFaces)

} // namespace tst_hiddenfaces

#include "tst_hiddenfaces.moc"
