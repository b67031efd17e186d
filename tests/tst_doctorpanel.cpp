// The mesh doctor: what it lists, and what a click on a number selects.
#include "support/panelongrid.h"
#include "views/panels/doctorpanel.h"
#include "views/selecting/findings.h"

#include <QLabel>
#include <QSignalSpy>

#include <limits>

namespace tst_doctorpanel {

using namespace autocuts;
using test::Bench;
using test::child;

class TestDoctorPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findingsAreListed()
    {
        Bench<DoctorPanel> bench;
        QVERIFY(bench.followed());
        const QString fine = bench.text("notes");
        QVERIFY(!fine.isEmpty() && !fine.contains(QChar(u'•')));
        bench.workspace.open(std::make_unique<Document>(test::sceneOf(test::dirty())), {}, std::nullopt,
                             {QStringLiteral("Line 7 was skipped")});
        QVERIFY(bench.followed());
        const QString notes = bench.text("notes");
        QVERIFY(notes.contains(QStringLiteral("Line 7 was skipped")));
        QVERIFY(notes.contains(QStringLiteral("duplicated face")));
        QCOMPARE(notes.count(QStringLiteral("duplicated face")), 1);
    }

    void polygonsThatMeetThemselvesAreSelected()
    {
        Bench<DoctorPanel> bench;
        const std::string name = "finding" + std::to_string(int(Finding::PolygonsThatMeetThemselves));
        QVERIFY(bench.followed());
        QCOMPARE(bench.text(name.c_str()), QStringLiteral("0"));
        const auto mesh =
            test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {0, 1, 2, 1}});
        bench.workspace.open(std::make_unique<Document>(test::sceneOf(mesh)), {}, std::nullopt, {});
        QVERIFY(bench.followed());
        QVERIFY(bench.text("notes").contains(QStringLiteral("1 polygon meets itself (face 2)")));
        QVERIFY(bench.text(name.c_str()).contains(QStringLiteral(">1<")));
        const QSignalSpy frames(&bench.panel, &DoctorPanel::frameSelectionRequested);
        auto *const count = child<QLabel>(bench.panel, name.c_str());
        count->setFocus();
        QTest::mouseClick(count, Qt::LeftButton, {}, {count->width() - 4, count->height() / 2});
        QCOMPARE(bench.document().selection().faces, QList<int>{1});
        QCOMPARE(frames.count(), 1);
    }

    void findingsAreSelected()
    {
        // Three faces on the edge 0 1, two of them looking to different sides, and one without UVs.
        const auto mesh = test::polygonMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                                            {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}});
        Scene scene = test::sceneOf(mesh);
        UvMatrix uv = UvMatrix::Constant(9, 2, std::numeric_limits<double>::quiet_NaN());
        uv.topRows(6) << 0, 0, 1, 0, 1, 1, 2, 0, 3, 0, 2, -3;
        scene.uvSets = {{QStringLiteral("UV"), uv}};
        const Document document(std::move(scene));
        const auto count = [&](Finding finding) {
            const Selection selection = elementsOf(document, finding);
            return selection.faces.size() + selection.edges.size();
        };
        QVERIFY(count(Finding::NonManifoldEdges) >= 2); // its sides that could not be paired are edges, too
        QCOMPARE(count(Finding::BoundaryEdges), 6);
        QCOMPARE(elementsOf(document, Finding::FacesWithoutUv).faces, QList<int>{2});
        QCOMPARE(elementsOf(document, Finding::MirroredIslands).faces, QList<int>{1});
        QCOMPARE(elementsOf(document, Finding::MostStretched).faces, QList<int>{1});
        QCOMPARE(count(Finding::PolygonsThatMeetThemselves), 0);
        QCOMPARE(count(Finding::CollapsedTriangles), 0);
    }
};

QTEST_MAIN(TestDoctorPanel)

} // namespace tst_doctorpanel

#include "tst_doctorpanel.moc"
