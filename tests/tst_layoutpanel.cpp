// The panel that places and arranges islands by numbers: fields, gestures, pivots, captions that are dragged.
#include "commands/setislandflags.h"
#include "commands/setuvs.h"
#include "support/editsupport.h"
#include "support/panelbench.h"
#include "support/timers.h"
#include "views/panels/layoutpanel.h"
#include "views/state/viewstate.h"
#include "views/ui/scrublabel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>

namespace tst_layoutpanel {

using namespace autocuts;
using test::child;

namespace {

//! The four faces of a grid of quads as islands: unit squares with lower left corners (0, 0), (2, 0) and so
//! on.
UvMatrix looseSquares(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int first = mesh.faceStart[face];
        const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (int k = 0; k < 4; ++k)
            uv.row(first + k) = (corners[k] + Vec2(2.0 * face, 0)).transpose();
    }
    return uv;
}

struct LayoutBench : test::PanelBench
{
    LayoutPanel panel{context};

    LayoutBench()
    {
        workspace.open(test::layoutDocument(test::grid(2)), {});
        pushCommand(std::make_unique<SetUvs>(document(), UvEdit::Move, looseSquares(document().mesh())));
        stack().clear();
        select({0, 1});
        ToolSettings tools = context.view.tools();
        tools.unit = LengthUnit::Uv;
        context.view.setTools(tools);
        const bool shown = test::showPanel(panel) && test::isUpToDate(panel);
        Q_ASSERT(shown);
        Q_UNUSED(shown);
    }
    void select(const QList<int> &faces)
    {
        Selection selection;
        selection.mode = SelectionMode::Islands;
        selection.faces = faces;
        document().setSelection(selection);
    }
    QDoubleSpinBox *field(const char *name) { return child<QDoubleSpinBox>(panel, name); }
    double shown(const char *name)
    {
        return QTest::qWaitFor([this] { return panel.isUpToDate(); }) ? field(name)->value() : qQNaN();
    }
    //! Types a number and Enter.
    void type(const char *name, const QString &text)
    {
        QDoubleSpinBox *box = field(name);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Return);
        QVERIFY(test::timersRest(panel)); // the gesture is over
    }
    Eigen::AlignedBox2d box(int island) { return document().islands().box(island); }
};

bool near(const Vec2 &a, const Vec2 &b)
{
    return (a - b).norm() < 1e-9;
}

} // namespace

class TestLayoutPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void numbersAreThoseOfTheBox()
    {
        LayoutBench bench;
        QCOMPARE(bench.shown("positionU"), 1.5);
        QCOMPARE(bench.shown("positionV"), 0.5);
        QCOMPARE(bench.shown("width"), 3.0);
        QCOMPARE(bench.shown("height"), 1.0);
        child<QComboBox>(bench.panel, "unit")->setCurrentIndex(1);
        Q_EMIT child<QComboBox>(bench.panel, "unit")->activated(1);
        QCOMPARE(bench.shown("width"), 3.0 * bench.document().packingSettings().textureSize);
        bench.select({});
        QTRY_VERIFY(!bench.field("width")->isEnabled());
    }

    void anotherModelTakesTheNumbersAway()
    {
        LayoutBench bench;
        QCOMPARE(bench.shown("width"), 3.0);
        bench.workspace.open(test::layoutDocument(test::grid(2)), {});
        QTRY_VERIFY(bench.panel.isUpToDate());
        for (const char *name : {"positionU", "positionV", "width", "height"})
            QCOMPARE(bench.field(name)->text(), QString());
        bench.select({0});
        QVERIFY(bench.shown("width") > 0);
        QVERIFY(!bench.field("width")->text().isEmpty());
    }

    void typedNumbersMoveScaleAndTurn()
    {
        LayoutBench bench;
        bench.type("positionU", QStringLiteral("2.5"));
        QVERIFY(near(bench.box(0).min(), {1, 0}) && near(bench.box(1).min(), {3, 0}));
        bench.type("width", QStringLiteral("6"));
        QVERIFY(near(bench.box(0).min(), {-0.5, -0.5}) && near(bench.box(1).max(), {5.5, 1.5}));
        child<QCheckBox>(bench.panel, "proportions")->click();
        bench.type("height", QStringLiteral("1"));
        QVERIFY(near(bench.box(0).sizes(), {2, 1}));
        bench.type("turn", QStringLiteral("90"));
        QVERIFY(near(bench.box(0).sizes(), {1, 2}));
        QCOMPARE(bench.shown("turn"), 0.0);
        QCOMPARE(bench.stack().count(), 4);
        for (int i = 0; i < 4; ++i)
            bench.stack().undo();
        QVERIFY(bench.document().uv() == looseSquares(bench.document().mesh()));
        QTRY_COMPARE(bench.shown("width"), 3.0);
    }

    void pivots_data()
    {
        QTest::addColumn<int>("pivot");
        QTest::addColumn<QPointF>(
            "first"); // lower left corner of the first island when it is half as large again
        QTest::newRow("centre") << int(Pivot::Centre) << QPointF(-0.75, -0.25);
        QTest::newRow("corner") << int(Pivot::Corner) << QPointF(0, 0);
        QTest::newRow("cursor") << int(Pivot::Cursor) << QPointF(-1.5, -0.5);
        QTest::newRow("individual") << int(Pivot::Individual) << QPointF(-0.25, -0.25);
    }
    void pivots()
    {
        QFETCH(int, pivot);
        QFETCH(QPointF, first);
        LayoutBench bench;
        bench.view.setTools({Pivot(pivot), Vec2(3, 1), SnapTo::Nothing, LengthUnit::Uv});
        QTRY_COMPARE(child<QComboBox>(bench.panel, "pivot")->currentIndex(), pivot);
        bench.type("width", QStringLiteral("4.5"));
        QVERIFY(near(bench.box(0).min(), {first.x(), first.y()}));
        QVERIFY(near(bench.box(0).sizes(), {1.5, 1.5}));
    }

    //! All steps of dragging a caption are one entry, and Ctrl makes them smaller.
    void captionsAreDragged()
    {
        LayoutBench bench;
        ScrubLabel *caption = nullptr;
        for (ScrubLabel *label : bench.panel.findChildren<ScrubLabel *>()) {
            if (label->buddy() == bench.field("positionU"))
                caption = label;
        }
        QVERIFY(caption);
        QTest::mousePress(caption, Qt::LeftButton, {}, {2, 2});
        for (int x = 2; x <= 82; x += 8)
            QTest::mouseMove(caption, {x, 2});
        QTest::mouseRelease(caption, Qt::LeftButton, {}, {82, 2});
        QCOMPARE(ScrubLabel::gesture(), quint64(0));
        QTRY_COMPARE(bench.shown("positionU"), 1.7);
        QCOMPARE(bench.stack().count(), 1);
        QVERIFY(test::timersRest(bench.panel)); // the gesture is over
        bench.stack().undo();
        QVERIFY(bench.document().uv() == looseSquares(bench.document().mesh()));
    }

    void lockedIslandsStay()
    {
        LayoutBench bench;
        pushCommand(std::make_unique<SetIslandFlags>(bench.document(), SetIslandFlags::Edit::Lock,
                                                     std::vector<int>{0}));
        QTRY_COMPARE(bench.shown("width"), 1.0);
        bench.type("positionU", QStringLiteral("5"));
        QVERIFY(near(bench.box(0).min(), {0, 0}));
        QVERIFY(near(bench.box(1).center(), {5, 0.5}));
        bench.select({0});
        QTRY_VERIFY(!bench.field("width")->isEnabled());
    }
};

QTEST_MAIN(TestLayoutPanel)

} // namespace tst_layoutpanel

#include "tst_layoutpanel.moc"
