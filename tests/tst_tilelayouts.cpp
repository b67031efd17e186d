// Layouts of several UDIM tiles: which tile an island belongs to, and that jobs leave it there.
#include "model/document/scenegroups.h"
#include "model/plain/udimtiles.h"
#include "model/plain/uvlayout.h"
#include "model/samples/samples.h"
#include "solver/base/cornerat.h"
#include "solver/base/rigidfit.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/unwrap/aligning.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/liveplacing.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/unwrap.h"
#include "support/steeredjobs.h"

#include <QTest>

#include <set>

namespace tst_tilelayouts {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! A rectangle in texture space.
struct Rectangle
{
    double x, y, width, height;
};

//! A layout of rectangles, each an island of one quad.
struct Rectangles
{
    test::MeshPtr mesh;
    UvMatrix uv;

    explicit Rectangles(const std::vector<Rectangle> &rectangles)
    {
        std::vector<Vec3> points;
        std::vector<std::vector<int>> faces;
        for (const Rectangle &r : rectangles) {
            const int first = static_cast<int>(points.size());
            const double z = first;
            points.insert(points.end(),
                          {{0, 0, z}, {r.width, 0, z}, {r.width, r.height, z}, {0, r.height, z}});
            faces.push_back({first, first + 1, first + 2, first + 3});
        }
        mesh = test::polygonMesh(points, faces);
        uv.resize(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            const Rectangle &r = rectangles[c / 4];
            uv.row(c) = mesh->cornerPosition(c).head<2>().transpose() + Eigen::RowVector2d(r.x, r.y);
        }
    }
};

//! The sample machine, unwrapped in draft, a tile for each of its materials.
struct Machine
{
    Snapshot snapshot;
    ChartMap charts;

    Machine()
    {
        const Scene scene = makeSample(u"machine"_s).value();
        snapshot.mesh = scene.mesh;
        unwrap::UnwrapOptions options;
        options.quality = unwrap::UnwrapQuality::Draft;
        UvMatrix uv = unwrap::unwrapMesh(snapshot, options).uv;
        charts = findCharts(*scene.mesh, uv);
        unwrap::PackJob pack = unwrap::steeredPackJob(snapshot, options.packing);
        pack.tiles =
            tilesOfGroups(sceneGroups(scene, SceneKind::Materials), charts, PackingSettings::firstTile);
        ok = unwrap::packCharts(*scene.mesh, charts, pack, uv);
        setUv(uv);
        snapshot.keepTiles = true;
    }

    void setUv(const UvMatrix &uv)
    {
        snapshot.uv = std::make_shared<const UvMatrix>(uv);
        snapshot.uvScale = layoutScale(*snapshot.mesh, uv);
    }
    std::vector<int> tiles() const { return udimTiles(*snapshot.mesh, *snapshot.uv, 1); }
    //! Changes the island of some face of a tile by an affine map of texture space about the middle of its
    //! box. \returns its faces
    std::vector<int> change(int tile, const Eigen::Matrix2d &linear, const Vec2 &move)
    {
        const std::vector<int> before = tiles();
        const auto found = std::find(before.begin(), before.end(), tile);
        const std::vector<int> faces = charts.faces()[charts.faceChart[found - before.begin()]];
        UvMatrix uv = *snapshot.uv;
        Eigen::AlignedBox2d box;
        for (const int face : faces) {
            for (int c = snapshot.mesh->faceStart[face]; c < snapshot.mesh->faceStart[face + 1]; ++c)
                box.extend(Vec2(uv.row(c)));
        }
        for (const int face : faces) {
            for (int c = snapshot.mesh->faceStart[face]; c < snapshot.mesh->faceStart[face + 1]; ++c)
                uv.row(c) = box.center() + move + linear * (Vec2(uv.row(c)) - box.center());
        }
        setUv(uv);
        return faces;
    }

    bool ok = false;
};

const Machine &machine()
{
    static const Machine made;
    return made;
}

//! Texels per unit of the model, at 2048 texels, of some faces.
double densityOf(const MeshData &mesh, const UvMatrix &uv, const std::vector<bool> &faces)
{
    double uvArea = 0, target = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (!faces[mesh.triangleFace[t]])
            continue;
        const auto &[a, b, c] = mesh.triangles[t];
        uvArea += std::abs(cross2(Vec2(uv.row(a)), Vec2(uv.row(b)), Vec2(uv.row(c)))) / 2;
        target += mesh.targetArea(t);
    }
    return 2048 * std::sqrt(uvArea / target);
}

//! How the islands lie that have the same faces in both maps.
struct Kept
{
    int all = 0, inPlace = 0, turned = 0;
};

Kept keptIslands(const MeshData &mesh, const UvMatrix &before, const UvMatrix &after)
{
    const auto old = findCharts(mesh, before).faces(), now = findCharts(mesh, after).faces();
    Kept kept;
    for (const std::vector<int> &faces : now) {
        if (std::find(old.begin(), old.end(), faces) == old.end())
            continue;
        std::vector<PointMatch> matches;
        for (const int face : faces) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                matches.push_back({after.row(c).transpose(), before.row(c).transpose()});
        }
        const RigidMotion motion = fitRigid(matches);
        ++kept.all;
        kept.inPlace += (motion.fixedCentre - motion.movingCentre).norm() < 5e-3;
        kept.turned +=
            std::abs(std::atan2(motion.s, motion.c)) > M_PI / 18; // new shapes of a few faces differ
    }
    return kept;
}

std::vector<bool> facesOfTile(const std::vector<int> &tiles, int tile)
{
    std::vector<bool> faces;
    for (const int own : tiles)
        faces.push_back(own == tile);
    return faces;
}

} // namespace

class TestTileLayouts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void islandsBelongToTiles_data()
    {
        QTest::addColumn<QList<double>>("rectangles");
        QTest::addColumn<QList<int>>("tiles"); // of findTiles()
        QTest::addColumn<bool>("hasTiles");
        const QList<double> home{0.1, 0.1, 0.8, 0.8};
        const auto with = [&](std::initializer_list<double> other) { return home + QList<double>(other); };
        QTest::newRow("inside") << with({1.2, 0.1, 0.5, 0.5}) << QList<int>{1001, 1002} << true;
        QTest::newRow("a little over the border")
            << with({1.6, 0.1, 0.5, 0.5}) << QList<int>{1001, 1002} << true;
        QTest::newRow("over two tiles") << with({2.2, 0.7, 0.5, 0.5}) << QList<int>{1001, 1003} << true;
        QTest::newRow("the same, lower") << with({2.2, 0.8, 0.5, 0.5}) << QList<int>{1001, 1013} << true;
        QTest::newRow("over four tiles") << with({1.75, 0.75, 0.5, 0.5}) << QList<int>{1001, 1002} << true;
        QTest::newRow("below the bottom row")
            << with({3.2, 0.1, 0.6, 0.6, 3.2, -0.7, 0.5, 0.5}) << QList<int>{1001, 1004, 1004} << true;
        QTest::newRow("below an empty tile") << with({3.2, -0.7, 0.5, 0.5}) << QList<int>{1001, 1001} << true;
        QTest::newRow("left of the first column, beside an empty tile")
            << with({-0.7, 1.2, 0.5, 0.5}) << QList<int>{1001, 1001} << true;
        QTest::newRow("right of the last column")
            << with({9.2, 0.2, 0.6, 0.6, 10.2, 0.2, 0.5, 0.5}) << QList<int>{1001, 1010, 1010} << true;
        QTest::newRow("alone, over the border")
            << QList<double>{3.6, 0.1, 0.5, 0.5} << QList<int>{1004} << true;
        QTest::newRow("alone, over two tiles")
            << QList<double>{3.75, 0.1, 0.5, 0.5} << QList<int>{0} << false;
        QTest::newRow("a texture that repeats") << QList<double>{0, 0, 8, 8} << QList<int>{0} << false;
        QTest::newRow("twice along a wall") << with({0, 0, 2, 1}) << QList<int>{1001, 0} << false;
        QTest::newRow("a wall and windows")
            << QList<double>{0, 0, 8, 3, 0.1, 0.1, 0.4, 0.4, 2.1, 0.1, 0.4, 0.4} << QList<int>{0, 1001, 1003}
            << false;
        QTest::newRow("over very many tiles") << QList<double>{-1e6, 0, 2e6, 1e6} << QList<int>{0} << false;
        QTest::newRow("further out than whole numbers reach")
            << with({1e30, 1e30, 1, 1}) << QList<int>{1001, 1001} << true;
        QTest::newRow("too large, in a layout of tiles")
            << QList<double>{0, 0, 1, 1, 1, 0, 1, 1, 2, 0, 1, 1, 3, 0, 1.25, 1}
            << QList<int>{1001, 1002, 1003, 1004} << true;
    }

    void islandsBelongToTiles()
    {
        QFETCH(QList<double>, rectangles);
        QFETCH(QList<int>, tiles);
        QFETCH(bool, hasTiles);
        std::vector<Rectangle> places;
        for (qsizetype i = 0; i < rectangles.size(); i += 4)
            places.push_back({rectangles[i], rectangles[i + 1], rectangles[i + 2], rectangles[i + 3]});
        for (const double height : {1.0, 0.5}) { // of a tile
            std::vector<Rectangle> squeezed = places;
            for (Rectangle &r : squeezed) {
                r.y *= height;
                r.height *= height;
            }
            const Rectangles layout(squeezed);
            const ChartMap charts = findCharts(*layout.mesh, layout.uv);
            const TileLayout found = findTiles(*layout.mesh, charts, layout.uv, height);
            QCOMPARE(QList<int>(found.tile.begin(), found.tile.end()), tiles);
            QCOMPARE(found.hasTiles, hasTiles);
            const std::vector<int> stays = udimTiles(*layout.mesh, layout.uv, height);
            QCOMPARE(QList<int>(stays.begin(), stays.end()), hasTiles ? tiles : QList<int>(tiles.size(), 0));
            for (std::size_t i = 0; i < squeezed.size(); ++i) {
                const Rectangle &r = squeezed[i];
                const bool inside =
                    tiles[int(i)] > 0 &&
                    udimTile(tiles[int(i)], height)
                        .contains(Eigen::AlignedBox2d(Vec2(r.x, r.y), Vec2(r.x + r.width, r.y + r.height)));
                QCOMPARE(bool(found.sticksOut[i]), !inside);
            }
        }
    }

    void aPackBringsIslandsBack_data()
    {
        QTest::addColumn<int>("tile");
        QTest::addColumn<double>("angle");
        QTest::addColumn<double>("right");
        QTest::addColumn<double>("up");
        QTest::newRow("turned") << 1004 << 45.0 << 0.0 << 0.0;
        QTest::newRow("a quarter of a tile to the right") << 1004 << 0.0 << 0.25 << 0.0;
        QTest::newRow("to the left") << 1004 << 0.0 << -0.25 << 0.0;
        // In 1004 there may be only one island: what lies below then belongs to another tile.
        QTest::newRow("below the bottom row") << 1002 << 0.0 << 0.0 << -0.9;
    }

    //! Of the islands, one reaches over the border: that one comes back, and all others stay in their tiles.
    void aPackBringsIslandsBack()
    {
        QFETCH(int, tile);
        QFETCH(double, angle);
        QFETCH(double, right);
        QFETCH(double, up);
        Machine moved = machine();
        QVERIFY(moved.ok);
        const std::vector<int> before = moved.tiles();
        QCOMPARE(usedTiles(before).size(), std::size_t(4));
        const std::vector<int> island =
            moved.change(tile, Eigen::Rotation2Dd(angle * M_PI / 180).toRotationMatrix(), Vec2(right, up));
        QVERIFY(moved.tiles() == before); // although it may stick out
        for (const bool alone : {false, true}) {
            unwrap::PackJob pack = unwrap::steeredPackJob(moved.snapshot, {});
            if (alone) {
                pack.movable.assign(moved.snapshot.mesh->faceCount(), false);
                for (const int face : island)
                    pack.movable[face] = true;
                pack.options.keepScale = true;
                pack.options.margin = 0;
            }
            UvMatrix uv = *moved.snapshot.uv;
            QVERIFY(unwrap::packCharts(*moved.snapshot.mesh, moved.charts, pack, uv));
            const TileLayout after = findTiles(*moved.snapshot.mesh, moved.charts, uv, 1);
            QVERIFY(after.ofFaces(moved.charts) == before);
            QVERIFY(std::find(after.sticksOut.begin(), after.sticksOut.end(), true) == after.sticksOut.end());
        }
    }

    void jobsLeaveTilesAndScales_data()
    {
        QTest::addColumn<int>("job");
        for (std::size_t job = 0; job < test::steeredJobs().size(); ++job)
            QTest::newRow(test::steeredJobs()[job].name) << int(job);
    }

    void jobsLeaveTilesAndScales()
    {
        QFETCH(int, job);
        const Machine &before = machine();
        const MeshData &mesh = *before.snapshot.mesh;
        const std::vector<int> tiles = before.tiles();
        const UvMatrix after = test::steeredJobs()[std::size_t(job)].run(before.snapshot).uv;
        QCOMPARE(after.rows(), before.snapshot.uv->rows());
        const std::vector<int> now = udimTiles(mesh, after, 1);
        QVERIFY(now == tiles);
        const QString name = QString::fromLatin1(test::steeredJobs()[std::size_t(job)].name);
        for (const int tile : usedTiles(tiles)) {
            const std::vector<bool> faces = facesOfTile(tiles, tile);
            const double was = densityOf(mesh, *before.snapshot.uv, faces),
                         is = densityOf(mesh, after, faces);
            const QByteArray text = u"%1: %2, %3"_s.arg(tile).arg(was).arg(is).toUtf8();
            if (name == u"live"_s || name == u"finish"_s)
                QVERIFY2(std::abs(is / was - 1) < 0.02, text.constData());
        }
        if (name == u"finish"_s) { // only what does not fit any more is moved
            const Kept kept = keptIslands(mesh, *before.snapshot.uv, after);
            const QByteArray text = u"%1 islands, %2 in place, %3 turned"_s.arg(kept.all)
                                        .arg(kept.inPlace)
                                        .arg(kept.turned)
                                        .toUtf8();
            QVERIFY2(kept.turned == 0 && kept.inPlace >= kept.all - 3 && kept.all > 20, text.constData());
        }
        // Nothing is stretched by the tiles having densities of their own.
        metrics::UvMetricsOptions options;
        options.overlaps = options.gutter = false;
        QVERIFY(metrics::measureUv(mesh, after, options).tileDirichlet < 4.1 + 1e-9);
    }

    void islandsKeepTheirScale_data()
    {
        QTest::addColumn<int>("job");
        QTest::addColumn<bool>("keepScale");
        QTest::newRow("live") << 4 << false;
        QTest::newRow("finish") << 1 << false;
        QTest::newRow("unwrap, islands keep their scale") << 0 << true;
    }

    //! One island was made smaller by hand.
    void islandsKeepTheirScale()
    {
        QFETCH(int, job);
        QFETCH(bool, keepScale);
        Machine scaled = machine();
        const MeshData &mesh = *scaled.snapshot.mesh;
        const double was = densityOf(mesh, *scaled.snapshot.uv, facesOfTile(scaled.tiles(), 1002));
        std::vector<bool> island(mesh.faceCount(), false);
        for (const int face : scaled.change(1002, 0.5 * Eigen::Matrix2d::Identity(), Vec2(0, 0)))
            island[face] = true;
        const double small = densityOf(mesh, *scaled.snapshot.uv, island);
        QVERIFY(small < 0.6 * was);
        UvMatrix after;
        if (keepScale) {
            unwrap::UnwrapOptions options;
            options.quality = unwrap::UnwrapQuality::Draft;
            options.packing.keepScale = true;
            const unwrap::UnwrapResult made = unwrap::unwrapMesh(scaled.snapshot, options);
            QVERIFY(made.packed);
            after = made.uv;
        } else {
            after = test::steeredJobs()[std::size_t(job)].run(scaled.snapshot).uv;
        }
        const double is = densityOf(mesh, after, island);
        double factor = 1;
        if (keepScale) {
            // Where a tile has no room for new charts, all of its islands get smaller, by one factor.
            std::vector<bool> others = facesOfTile(scaled.tiles(), 1002);
            for (std::size_t face = 0; face < others.size(); ++face)
                others[face] = others[face] && !island[face];
            factor = densityOf(mesh, after, others) / densityOf(mesh, *scaled.snapshot.uv, others);
            QVERIFY2(factor < 1.02 && factor > 0.9, qPrintable(QString::number(factor)));
        }
        QVERIFY2(std::abs(is / small / factor - 1) < 0.02, qPrintable(u"%1 to %2"_s.arg(small).arg(is)));
        QVERIFY(udimTiles(mesh, after, 1) == scaled.tiles());
    }

    //! The islands of a map in a plain file get one texel density.
    void plainFilesGetOneDensity()
    {
        const Rectangles layout({{0.1, 0.1, 0.3, 0.3}, {0.6, 0.1, 0.3, 0.3}});
        Snapshot snapshot;
        snapshot.mesh = layout.mesh;
        UvMatrix uv = layout.uv;
        for (int c = 0; c < 4; ++c)
            uv.row(c) *= 0.5;
        snapshot.uv = std::make_shared<const UvMatrix>(uv);
        snapshot.uvScale = layoutScale(*layout.mesh, uv);
        const UvMatrix after = unwrap::finishMap({.snapshot = snapshot}).uv;
        const auto side = [&](int corner) { return (after.row(corner + 1) - after.row(corner)).norm(); };
        QVERIFY2(std::abs(side(0) / side(4) - 1) < 1e-6,
                 qPrintable(u"%1 and %2"_s.arg(side(0)).arg(side(4))));
    }

    //! Islands that touch do not end the margins of the others.
    void touchingIslandsLeaveOthersTheirMargin()
    {
        // Two that touch, and two at half of the margin.
        const double margin = packing::PackOptions().margin / packing::PackOptions().textureSize;
        const Rectangles layout({{0.1, 0.1, 0.2, 0.2},
                                 {0.3, 0.1, 0.2, 0.2},
                                 {0.1, 0.5, 0.2, 0.2},
                                 {0.3 + margin / 2, 0.5, 0.2, 0.2}});
        const unwrap::PackJob pack;
        const double gap = unwrap::keptGap(*layout.mesh, pack, layout.uv);
        QVERIFY2(std::abs(gap / margin - 0.5) < 1e-5, qPrintable(QString::number(gap / margin)));
    }

    //! A live map that has no room makes all islands of the tile smaller; when the next one fits again, it is
    //! where the first one was, as large as that.
    void liveMapsReturnToTheirPlaces()
    {
        const Rectangles layout({{0.02, 0.02, 0.46, 0.46},
                                 {0.52, 0.02, 0.46, 0.46},
                                 {0.02, 0.52, 0.46, 0.46},
                                 {0.52, 0.52, 0.46, 0.46}});
        Snapshot snapshot;
        snapshot.mesh = layout.mesh;
        snapshot.keepTiles = true;
        snapshot.uv = std::make_shared<const UvMatrix>(layout.uv);
        snapshot.uvScale = layoutScale(*layout.mesh, layout.uv);
        const auto soup = Soup::build(snapshot.mesh);
        const auto map =
            seamedMapOf(*soup, layout.uv / snapshot.uvScale, CutFlags(layout.mesh->edgePairs.size()));
        QVERIFY(map);
        unwrap::LivePlacing placing;
        const unwrap::FreePart part = *unwrap::FreePart::of(snapshot);
        const auto place = [&](const SeamedMap &shown) {
            return placing.place(snapshot, part, *soup, shown, {}, false);
        };
        QVERIFY((place(*map) - layout.uv).cwiseAbs().maxCoeff() < 1e-9);
        SeamedMap larger = *map;
        for (int c = 0; c < 6; ++c) // the first island
            cornerAt(larger.x, c) *= 1.4;
        QVERIFY((place(larger) - layout.uv).cwiseAbs().maxCoeff() > 0.01);
        QVERIFY((place(*map) - layout.uv).cwiseAbs().maxCoeff() < 1e-9);
    }

    //! An island that is dragged onto another one while solving stays there after the drag; the other one
    //! gives way, in the same tile.
    void draggedIslandsStay()
    {
        const Rectangles layout({{1.1, 0.1, 0.3, 0.3}, {1.6, 0.1, 0.3, 0.3}, {0.1, 0.1, 0.8, 0.8}});
        Snapshot snapshot;
        snapshot.mesh = layout.mesh;
        snapshot.keepTiles = true;
        snapshot.uv = std::make_shared<const UvMatrix>(layout.uv);
        snapshot.uvScale = layoutScale(*layout.mesh, layout.uv);
        const auto soup = Soup::build(snapshot.mesh);
        const auto map =
            seamedMapOf(*soup, layout.uv / snapshot.uvScale, CutFlags(layout.mesh->edgePairs.size()));
        QVERIFY(map);
        unwrap::LivePlacing placing;
        const auto place = [&](const Snapshot &now, const SeamedMap &shown, const std::vector<int> &dragged) {
            return placing.place(now, *unwrap::FreePart::of(now), *soup, shown, {}, false, dragged);
        };
        QVERIFY((place(snapshot, *map, {}) - layout.uv).cwiseAbs().maxCoeff() < 1e-9);
        Snapshot held = snapshot;
        SeamedMap moved = *map;
        std::vector<int> dragged;
        for (int c = 0; c < 6; ++c) { // the two triangles of the first island
            dragged.push_back(c);
            cornerAt(moved.x, c).x() += 0.4 / snapshot.uvScale;
            held.editSteering().pins.push_back({c, Vec2(cornerAt(moved.x, c)), false, 1});
        }
        place(held, moved, dragged);
        for (int round = 0; round < 2; ++round) { // the drag is over
            const UvMatrix after = place(snapshot, *map, {});
            QVERIFY(((after - layout.uv).topRows(4).rowwise() - Eigen::RowVector2d(0.4, 0)).norm() < 1e-6);
            QVERIFY(((after - layout.uv).middleRows(4, 4)).norm() > 0.1);
            QVERIFY((after - layout.uv).bottomRows(4).norm() < 1e-9);
            QCOMPARE(metrics::measureUv(*layout.mesh, after).overlapPairs, 0);
            QVERIFY(udimTiles(*layout.mesh, after, 1) == udimTiles(*layout.mesh, layout.uv, 1));
        }
    }

    //! The islands of a tile are aligned: none lies on another one, and packing does not turn them away.
    void alignedIslandsStayAligned()
    {
        Machine aligned = machine();
        const MeshData &mesh = *aligned.snapshot.mesh;
        const std::vector<int> tiles = aligned.tiles();
        unwrap::AlignInput input;
        input.snapshot = aligned.snapshot;
        input.snapshot.scope = std::make_shared<const JobScope>(JobScope{facesOfTile(tiles, 1002)});
        const unwrap::AlignResult made = unwrap::alignIslands(input);
        QVERIFY(made.uv.rows() > 0 && !made.noRoom);
        metrics::UvMetricsOptions options;
        options.gutter = false;
        QCOMPARE(metrics::measureUv(mesh, made.uv, options).overlapPairs, 0);
        QVERIFY(udimTiles(mesh, made.uv, 1) == tiles);
        const auto share = [&](const UvMatrix &uv) {
            UvMatrix own = uv;
            for (int face = 0; face < mesh.faceCount(); ++face) {
                for (int c = mesh.faceStart[face]; tiles[face] != 1002 && c < mesh.faceStart[face + 1]; ++c)
                    own.row(c).setConstant(std::nan(""));
            }
            return metrics::measureUv(mesh, own, options).axisAlignedShare;
        };
        const double straight = share(made.uv);
        QVERIFY(straight > share(*aligned.snapshot.uv));
        aligned.setUv(made.uv);
        auto &flags = aligned.snapshot.editSteering().faceFlags;
        flags.resize(mesh.faceCount());
        for (int face = 0; face < mesh.faceCount(); ++face)
            flags[face].aligned = tiles[face] == 1002;
        UvMatrix packed = made.uv;
        QVERIFY(unwrap::packCharts(mesh, findCharts(mesh, packed),
                                   unwrap::steeredPackJob(aligned.snapshot, {}), packed));
        QVERIFY2(std::abs(share(packed) - straight) < 1e-3,
                 qPrintable(u"%1 to %2"_s.arg(straight).arg(share(packed))));
    }
};

QTEST_GUILESS_MAIN(TestTileLayouts)

} // namespace tst_tilelayouts

#include "tst_tilelayouts.moc"
