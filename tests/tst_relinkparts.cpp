// Re-linking a model whose parts were moved or deformed beside others that are gone or new.
#include "model/editing/relink.h"
#include "support/editsupport.h"

#include <QTest>

namespace tst_relinkparts {

using namespace autocuts;

namespace {

struct Polygons
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;

    Polygons() = default;
    explicit Polygons(const MeshData &mesh)
    {
        for (int v = 0; v < mesh.vertexCount(); ++v)
            points.push_back(mesh.positions.row(v));
        for (int f = 0; f < mesh.faceCount(); ++f)
            faces.emplace_back(mesh.cornerVertex.begin() + mesh.faceStart[f],
                               mesh.cornerVertex.begin() + mesh.faceStart[f + 1]);
    }
    Scene scene() const { return test::sceneOf(test::polygonMesh(points, faces)); }
};

} // namespace

class TestRelinkParts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void partsMovedBesideANewOne_data()
    {
        QTest::addColumn<double>("scale");
        QTest::addColumn<Vec3>("move");
        QTest::addColumn<double>("angle");
        QTest::addColumn<double>("stretch");
        QTest::newRow("moved") << 1.0 << Vec3(30, -5, 2) << 0.0 << 1.0;
        QTest::newRow("moved a little") << 1.0 << Vec3(0.1, 0, 0.05) << 0.0 << 1.0;
        QTest::newRow("scaled") << 3.7 << Vec3(0, 0, 0) << 0.0 << 1.0;
        QTest::newRow("turned") << 1.0 << Vec3(0, 0, 0) << 0.4 << 1.0;
        QTest::newRow("deformed") << 1.0 << Vec3(1, 0, 0) << 0.0 << 1.3;
        QTest::newRow("all") << 0.3 << Vec3(1, 2, 3) << -2.0 << 0.8;
    }

    //! An artist moves the model and adds an object before the next save: neither costs the map.
    void partsMovedBesideANewOne()
    {
        QFETCH(double, scale);
        QFETCH(Vec3, move);
        QFETCH(double, angle);
        QFETCH(double, stretch);
        const DocumentState state = test::gridDocument()->state();
        Polygons polygons(*state.scene.mesh);
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix();
        for (Vec3 &point : polygons.points)
            point = scale * (turn * Vec3(point.x(), stretch * point.y(), point.z())) + move;
        // The new object comes first, so that all numbers change.
        const std::vector<Vec3> added{{9, 0, 0}, {9, 1, 0}, {9, 1, 1}, {9, 0, 1}};
        for (auto &face : polygons.faces) {
            for (int &vertex : face)
                vertex += static_cast<int>(added.size());
        }
        polygons.points.insert(polygons.points.begin(), added.begin(), added.end());
        polygons.faces.insert(polygons.faces.begin(), {0, 1, 2, 3});
        const Relinked relinked = relinkDocument(state, polygons.scene());
        QCOMPARE(relinked.state.validate(), QString());
        QCOMPARE(relinked.report.faces, (Carried{16, 0}));
        QCOMPARE(relinked.report.seams.lost, 0);
        QCOMPARE(relinked.report.pins, (Carried{2, 0}));
        QCOMPARE(relinked.report.rectangleFaces.lost, 0);
        QCOMPARE(relinked.report.markedFaces, (Carried{1, 0}));
        QCOMPARE(relinked.report.newFaces, QList<int>{0});
        const UvMatrix &uv = relinked.state.scene.uvSets[0].uv;
        QVERIFY(uv.bottomRows(64) == state.scene.uvSets[0].uv);
        QVERIFY(uv.allFinite());
    }

    //! Many models have quads and boxes: their shape says which is which, and the nearest of none is none.
    void smallPartsOfOtherShapesAreOthers()
    {
        const auto rectangle = [](Polygons &polygons, double x, double width) {
            const auto first = static_cast<int>(polygons.points.size());
            for (const Vec3 &corner : {Vec3(0, 0, 0), Vec3(width, 0, 0), Vec3(width, 1, 0), Vec3(0, 1, 0)})
                polygons.points.push_back(corner + Vec3(x, 0, 0));
            polygons.faces.push_back({first, first + 1, first + 2, first + 3});
        };
        Polygons before, after;
        for (const int width : {1, 2, 3})
            rectangle(before, 5 * width, width);
        for (const int width : {7, 3, 1, 11})
            rectangle(after, 100 + 20 * width, width);
        const DocumentState state = test::layoutDocument(before.scene().mesh)->state();
        const Relinked relinked = relinkDocument(state, after.scene());
        QCOMPARE(relinked.report.faces, (Carried{2, 1}));
        const UvMatrix &was = state.scene.uvSets[0].uv, &is = relinked.state.scene.uvSets[0].uv;
        QVERIFY(is.middleRows(4, 4) == was.bottomRows(4) && is.middleRows(8, 4) == was.topRows(4));
    }
};

QTEST_APPLESS_MAIN(TestRelinkParts)

} // namespace tst_relinkparts

#include "tst_relinkparts.moc"
