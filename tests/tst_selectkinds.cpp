// Selecting what is alike or of one kind, and through the model.
#include "commands/setuvs.h"
#include "support/canvases.h"
#include "support/gridstudio.h"
#include "views/dialogs/numberdialog.h"
#include "views/selecting/edgekinds.h"
#include "views/selecting/islandkinds.h"
#include "views/selecting/similarfaces.h"

#include <QDoubleSpinBox>
#include <QTest>

#include <numeric>

namespace tst_selectkinds {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;
using test::GridStudio;

namespace {

//! A box of 1 x 2 x 3 with its upper side in two triangles: five quads and two triangles.
Scene boxScene()
{
    std::vector<Vec3> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(i & 1 ? 1 : 0, i & 2 ? 2 : 0, i & 4 ? 3 : 0);
    Scene scene = test::sceneOf(test::polygonMesh(
        points,
        {{0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}, {4, 5, 7}, {4, 7, 6}}));
    scene.materialNames = {u"stone"_s, u"wood"_s};
    scene.faceMaterial = {0, 1, 1, 0, 0, 1, -1};
    return scene;
}

Vec3 middleOf(const Document &document, int edge)
{
    const auto [a, b] = document.adjacency().edgeVertices(edge);
    return (document.mesh().positions.row(a) + document.mesh().positions.row(b)) / 2;
}

//! Answers the next dialogs with a number.
void answer(GridStudio &studio, double number)
{
    studio.answers.onDialog = [number](QDialog &dialog) {
        dialog.findChild<QDoubleSpinBox *>(u"number"_s)->setValue(number);
        return static_cast<int>(QDialog::Accepted);
    };
}

} // namespace

class TestSelectKinds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void facesOfOneKind_data()
    {
        QTest::addColumn<int>("likeness");
        QTest::addColumn<QList<int>>("from");
        QTest::addColumn<QList<int>>("to");
        const auto row = [](const char *name, FaceLikeness likeness, QList<int> from, QList<int> to) {
            QTest::newRow(name) << int(likeness) << from << to;
        };
        row("areas", FaceLikeness::Area, {1}, {1, 2});
        row("areas of two", FaceLikeness::Area, {0, 3}, {0, 3, 4});
        row("normals", FaceLikeness::Normal, {5}, {5, 6});
        row("opposite normals differ", FaceLikeness::Normal, {0}, {0});
        row("materials", FaceLikeness::Material, {2}, {1, 2, 5});
        row("no material", FaceLikeness::Material, {6}, {6});
        row("corners", FaceLikeness::Corners, {6}, {5, 6});
        row("quads", FaceLikeness::Corners, {0}, {0, 1, 2, 3, 4});
        row("shapes", FaceLikeness::Shape, {1}, {1, 2});
        row("shapes of two", FaceLikeness::Shape, {0, 3}, {0, 3, 4});
        row("mirrored or turned shapes", FaceLikeness::Shape, {6}, {5, 6});
        row("areas in no map", FaceLikeness::AreaInMap, {1}, {1});
        row("nothing", FaceLikeness::Area, {}, {});
    }

    void facesOfOneKind()
    {
        QFETCH(int, likeness);
        QFETCH(QList<int>, from);
        QFETCH(QList<int>, to);
        const Document document(boxScene());
        QCOMPARE(similarFaces(document, from, FaceLikeness(likeness)), to);
    }

    void facesWithoutAreaAreNoProblem()
    {
        const Document document(test::sceneOf(test::dirty()));
        QList<int> all(document.mesh().faceCount());
        std::iota(all.begin(), all.end(), 0);
        for (const auto likeness : {FaceLikeness::Area, FaceLikeness::Normal, FaceLikeness::Material,
                                    FaceLikeness::Corners, FaceLikeness::Shape, FaceLikeness::AreaInMap})
            QCOMPARE(similarFaces(document, all, likeness), all);
    }

    void edgesOfOneKind()
    {
        const Document document(boxScene());
        QCOMPARE(sharpEdges(document, 30).size(), 12);
        QCOMPARE(sharpEdges(document, 91).size(), 0);
        QVERIFY(borderEdges(document).isEmpty());
        const QList<int> outline = outlineEdges(document, {5, 6});
        QCOMPARE(outline.size(), 4);
        for (int edge : outline)
            QCOMPARE(middleOf(document, edge).z(), 3.0);
    }

    void seamsAndBorders()
    {
        GridStudio studio;
        studio.trigger("select.border");
        QCOMPARE(studio.selection().mode, SelectionMode::Edges);
        QCOMPARE(studio.selection().edges.size(), 16);
        studio.trigger("select.seams");
        QCOMPARE(studio.selection().edges.size(), 4);
        for (int edge : studio.selection().edges)
            QCOMPARE(middleOf(studio.document(), edge).x(), 0.5);
        studio.selectFaces({0, 1});
        studio.trigger("select.outline");
        QCOMPARE(studio.selection().edges.size(), 6);
        QVERIFY(studio.selection().faces.isEmpty());
        QCOMPARE(studio.entries(), 0);
    }

    void sharpEdgesAskForTheAngle()
    {
        GridStudio studio;
        studio.workspace.open(std::make_unique<Document>(boxScene()), {});
        studio.trigger("select.sharp");
        QVERIFY(studio.selection().isEmpty()); // cancelled
        answer(studio, 45);
        studio.trigger("select.sharp");
        QCOMPARE(studio.selection().edges.size(), 12);
        double offered = 0;
        studio.answers.onDialog = [&](QDialog &dialog) {
            offered = dialog.findChild<QDoubleSpinBox *>(u"number"_s)->value();
            return static_cast<int>(QDialog::Rejected);
        };
        studio.trigger("select.sharp");
        QCOMPARE(offered, 45.0); // the angle is kept
    }

    void islandsByFigures()
    {
        GridStudio studio;
        const QList<int> right{2, 3, 6, 7, 10, 11, 14, 15};
        studio.trigger("select.stretched");
        QVERIFY(studio.selection().isEmpty());
        // The right island is stretched to three times its width.
        UvMatrix uv = studio.document().uv();
        for (Eigen::Index c = 0; c < uv.rows(); ++c) {
            if (uv(c, 0) > 1)
                uv.row(c) = Eigen::RowVector2d(1.5 + (uv(c, 0) - 1.5) * 3, uv(c, 1) * 0.75);
        }
        pushCommand(std::make_unique<SetUvs>(studio.document(), UvEdit::Scale, uv));
        studio.trigger("select.stretched");
        QCOMPARE(studio.selection().faces, right);
        answer(studio, 20);
        studio.selectFaces({});
        studio.trigger("select.offDensity");
        QCOMPARE(studio.selection().faces, right);
        answer(studio, 80);
        studio.trigger("select.offDensity");
        QVERIFY(studio.selection().isEmpty());
        answer(studio, 2049);
        studio.trigger("select.small");
        QCOMPARE(studio.selection().faces, QList<int>({0, 1, 4, 5, 8, 9, 12, 13}));
        answer(studio, 2048);
        studio.trigger("select.small");
        QVERIFY(studio.selection().isEmpty());
    }

    void boxesReachThroughTheModel()
    {
        Canvases studio;
        openBox(studio);
        const QList<QPoint> all{{2, 2}, {497, 497}};
        Canvases::drag(studio.mesh, all);
        QCOMPARE(studio.document().selection().faces, QList<int>({5}));
        setXray(studio, true);
        Canvases::drag(studio.mesh, all);
        QCOMPARE(studio.document().selection().faces.size(), 6);
    }

    void clicksGoDeeper_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<bool>("xray");
        QTest::addColumn<QList<int>>("second");
        QTest::newRow("faces") << int(SelectionMode::Faces) << true << QList<int>{0};
        QTest::newRow("faces, opaque") << int(SelectionMode::Faces) << false << QList<int>{5};
    }

    void clicksGoDeeper()
    {
        QFETCH(int, mode);
        QFETCH(bool, xray);
        QFETCH(QList<int>, second);
        Canvases studio;
        openBox(studio);
        studio.select(SelectionMode(mode));
        setXray(studio, xray);
        const QPoint middle(250, 250);
        const auto click = [&](const QPoint &place) {
            QTest::mouseClick(&studio.mesh, Qt::LeftButton, {}, place, 600); // no double clicks
            return studio.document().selection().faces;
        };
        QCOMPARE(click(middle), QList<int>{5});
        QCOMPARE(click(middle), second);
        QCOMPARE(click(middle), QList<int>{5}); // round again
        click(middle);
        QCOMPARE(click(middle + QPoint(20, 0)), QList<int>{5}); // another place begins in front
    }

    void xrayIsSeen()
    {
        Canvases studio;
        openBox(studio);
        const QImage opaque = studio.mesh.picture();
        setXray(studio, true);
        const QImage seen = studio.mesh.picture();
        const auto luminance = [](const QImage &image, QPoint p) { return qGray(image.pixel(p)); };
        QVERIFY(std::abs(luminance(opaque, {250, 250}) - luminance(seen, {250, 250})) > 15);
        QVERIFY(opaque.copy(10, 10, 60, 30) != seen.copy(10, 10, 60, 30)); // the badge
    }

private:
    //! The unit cube of quads, the last of which looks at the viewer.
    static void openBox(Canvases &studio)
    {
        std::vector<Vec3> points;
        for (int i = 0; i < 8; ++i)
            points.emplace_back(i & 1 ? 1 : 0, i & 2 ? 1 : 0, i & 4 ? 1 : 0);
        studio.open(std::make_unique<Document>(test::sceneOf(test::polygonMesh(
            points, {{0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}, {4, 5, 7, 6}}))));
        studio.lookFromFront();
    }
    static void setXray(Canvases &studio, bool on)
    {
        ViewOptions options = studio.view.options();
        options.xray = on;
        studio.view.setOptions(options);
    }
};

QTEST_MAIN(TestSelectKinds)

} // namespace tst_selectkinds

#include "tst_selectkinds.moc"
