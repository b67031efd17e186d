// Selecting with a lasso and with a brush, in both views.
#include "support/canvases.h"
#include "support/editsupport.h"

#include <QTest>

namespace tst_selectshapes {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

class TestSelectShapes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mStudio = Canvases::onGrid(4);
        mStudio->lookFromFront();
    }
    void cleanup() { mStudio.reset(); }

    void lassoTakesWhatItEncloses_data() { views(); }

    void lassoTakesWhatItEncloses()
    {
        QFETCH(bool, map);
        use(u"lasso"_s);
        mStudio->select(SelectionMode::Faces);
        // A triangle with its right angle at face 0; the long side passes between face 5 and the others.
        const QPoint right = at(map, 1), up = at(map, 4), corner = at(map, 0);
        const QPoint outU = (right - corner) * 2 / 3, outV = (up - corner) * 2 / 3;
        Canvases::drag(canvas(map),
                       {corner - outU - outV, right + outU * 7 / 4 - outV, up - outU + outV * 7 / 4});
        QCOMPARE(faces(), QList<int>({0, 1, 4}));
        // Shift adds, Ctrl takes away.
        const QPoint far = at(map, 13);
        Canvases::drag(canvas(map),
                       {far - outU - outV, far + outU - outV, far + outU + outV, far - outU + outV},
                       Qt::ShiftModifier);
        QCOMPARE(faces(), QList<int>({0, 1, 4, 13}));
        Canvases::drag(canvas(map),
                       {corner - outU / 2 - outV, corner + outU / 2 - outV, up + outU / 2 + outV / 2,
                        up - outU / 2 + outV / 2},
                       Qt::ControlModifier);
        QCOMPARE(faces(), QList<int>({1, 13}));
        QCOMPARE(mStudio->document().undoStack().count(), 0);
    }

    void brushTakesWhatItPasses_data() { views(); }

    void brushTakesWhatItPasses()
    {
        QFETCH(bool, map);
        use(u"selectBrush"_s);
        mStudio->select(SelectionMode::Faces);
        Canvases::drag(canvas(map), {at(map, 0), at(map, 4), at(map, 8), at(map, 9)});
        QCOMPARE(faces(), QList<int>({0, 4, 8, 9}));
        Canvases::drag(canvas(map), {at(map, 12), at(map, 13)}, Qt::ShiftModifier);
        QCOMPARE(faces(), QList<int>({0, 4, 8, 9, 12, 13}));
        Canvases::drag(canvas(map), {at(map, 4), at(map, 8)}, Qt::ControlModifier);
        QCOMPARE(faces(), QList<int>({0, 9, 12, 13}));
        // A click is a click, and a stroke can be taken back.
        QTest::mouseClick(&canvas(map), Qt::LeftButton, {}, at(map, 5));
        QCOMPARE(faces(), QList<int>({5}));
        QTest::mousePress(&canvas(map), Qt::LeftButton, {}, at(map, 0));
        Canvases::moveMouse(canvas(map), at(map, 1), Qt::LeftButton);
        QVERIFY(faces().contains(1));
        QTest::keyClick(&canvas(map), Qt::Key_Escape);
        QCOMPARE(faces(), QList<int>({5}));
    }

    void brushHasASize()
    {
        use(u"selectBrush"_s);
        mStudio->select(SelectionMode::Faces);
        for (int i = 0; i < 12; ++i)
            Canvases::turnWheel(mStudio->uv, at(true, 0), 120, Qt::ShiftModifier);
        Canvases::drag(mStudio->uv, {at(true, 0), at(true, 0) + QPoint(6, 0)});
        QVERIFY(faces().size() > 2); // 24 pixels have become 75, a face has 50
        mStudio->select(SelectionMode::Edges);
        Canvases::drag(mStudio->uv, {at(true, 5), at(true, 5) + QPoint(6, 0)});
        QVERIFY(!mStudio->document().selection().edges.isEmpty() && faces().isEmpty());
    }

private:
    void views()
    {
        QTest::addColumn<bool>("map");
        QTest::newRow("model") << false;
        QTest::newRow("map") << true;
    }
    Canvas &canvas(bool map)
    {
        return map ? static_cast<Canvas &>(mStudio->uv) : static_cast<Canvas &>(mStudio->mesh);
    }
    //! The middle of a face.
    QPoint at(bool map, int face)
    {
        return (Canvases::middle(canvas(map), 2 * face) + Canvases::middle(canvas(map), 2 * face + 1)) / 2;
    }
    const QList<int> &faces() { return mStudio->document().selection().faces; }
    void use(const QString &id)
    {
        mStudio->tools.setTool(id);
        QCOMPARE(mStudio->tools.tool()->id(), id);
    }

    std::unique_ptr<Canvases> mStudio;
};

QTEST_MAIN(TestSelectShapes)

} // namespace tst_selectshapes

#include "tst_selectshapes.moc"
