// How a map gives way to the next one while the solver runs: islands glide, what was cut anew fades.
#include "commands/settexelweights.h"
#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "support/editsupport.h"
#include "support/meshbuilders.h"
#include "support/patience.h"
#include "views/control/session/islandglide.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <numbers>

namespace tst_islandglide {

using namespace autocuts;

namespace {

constexpr int side = 4; // faces along one side of the grid

//! A flat map of the grid whose columns from `split` on are turned by an angle, scaled and moved.
UvMatrix splitMap(const MeshData &mesh, int split, double angle, double scale, const Vec2 &shift)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) = mesh.positions.row(mesh.cornerVertex[c]).head<2>();
    const Eigen::Rotation2Dd turn(angle);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        Vec2 centre = Vec2::Zero();
        for (int c = 4 * face; c < 4 * face + 4; ++c)
            centre += 0.25 * Vec2(uv.row(c));
        for (int c = 4 * face; c < 4 * face + 4 && centre.x() > double(split) / side; ++c)
            uv.row(c) = scale * (turn * Vec2(uv.row(c))) + shift;
    }
    return uv;
}

std::unique_ptr<Document> documentOf(const test::MeshPtr &mesh, const UvMatrix &map)
{
    Scene scene = test::sceneOf(mesh);
    scene.uvSets.push_back({QStringLiteral("map"), map});
    return std::make_unique<Document>(std::move(scene));
}

std::vector<float> separationOf(const MeshData &mesh, const UvMatrix &uv)
{
    std::vector<float> separation;
    for (const bool open : openCornerPairs(mesh, uv))
        separation.push_back(open ? 1.f : 0.f);
    return separation;
}

IslandGlide glideBetween(const MeshData &mesh, const UvMatrix &before, const UvMatrix &after)
{
    const UvMatrix from = soupUv(mesh, before), to = soupUv(mesh, after);
    const std::vector<float> open = separationOf(mesh, before), openAfter = separationOf(mesh, after);
    return {mesh, {from, open}, {to, openAfter}};
}

} // namespace

class TestIslandGlide : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void islandsWhoseSeamsStayedMoveAsAWhole()
    {
        const auto mesh = test::grid(side);
        const UvMatrix before = splitMap(*mesh, 2, 0.3, 1, {1.5, 0});
        const UvMatrix after = splitMap(*mesh, 2, 0.3 + std::numbers::pi / 2, 1.44, {2, 2});
        const IslandGlide glide = glideBetween(*mesh, before, after);
        QCOMPARE(glide.movingCount(), 1); // the other one is where it was
        const UvMatrix from = soupUv(*mesh, before), to = soupUv(*mesh, after);
        QVERIFY((glide.at(0) - from).cwiseAbs().maxCoeff() < 1e-12);
        QVERIFY((glide.at(1) - to).cwiseAbs().maxCoeff() < 1e-12);
        // Half-way, each edge of the moving island has the mean scale, as half of a similarity does.
        const UvMatrix half = glide.at(0.5);
        for (int s = 0; s < mesh->soupCornerCount(); s += 3) {
            const double scale =
                (half.row(s + 1) - half.row(s)).norm() / (from.row(s + 1) - from.row(s)).norm();
            QVERIFY2(std::abs(scale - 1) < 1e-12 || std::abs(scale - 1.2) < 1e-12,
                     qPrintable(QString::number(scale)));
        }
    }

    void islandsThatWereCutAnewStay()
    {
        const auto mesh = test::grid(side);
        const UvMatrix before = splitMap(*mesh, 2, 0, 1, {1, 0}), after = splitMap(*mesh, 3, 0, 1, {2, 1});
        const IslandGlide glide = glideBetween(*mesh, before, after);
        QCOMPARE(glide.movingCount(), 0);
        QCOMPARE(glide.at(0.5), soupUv(*mesh, before));
    }

    void theShownMapIsTheNextOneAtOnce()
    {
        const test::MeshPtr mesh = test::grid(side);
        const UvMatrix before = splitMap(*mesh, 2, 0, 1, {1.5, 0}), after = splitMap(*mesh, 2, 1, 1, {3, 2});
        Workspace workspace;
        workspace.open(documentOf(mesh, before), {});
        ShownMap shown(workspace);
        QSignalSpy changed(&shown, &ShownMap::changed), fading(&shown, &ShownMap::ghostChanged);
        double strength = 1;
        connect(&shown, &ShownMap::ghostChanged, this, [&] {
            QCOMPARE(shown.uv(), soupUv(*mesh, after));
            if (shown.ghost().rows() == 0)
                return;
            QVERIFY(shown.ghostStrength() < strength);
            strength = shown.ghostStrength();
        });
        shown.showMap(after);
        QCOMPARE(shown.uv(), soupUv(*mesh, after));
        QCOMPARE(shown.ghost(), soupUv(*mesh, before));
        QVERIFY(QTest::qWaitFor([&] { return shown.ghost().rows() == 0; }, test::patience));
        QVERIFY(!fading.isEmpty());
        QCOMPARE(changed.size(), 1); // the map itself is uploaded once
    }

    //! Whatever has changed since it was last asked for: the map, or the texel weights.
    void theStretchIsThatOfTheShownMap()
    {
        const test::MeshPtr mesh = test::grid(side);
        const UvMatrix even = splitMap(*mesh, 2, 0, 1, {1.5, 0}), uneven = splitMap(*mesh, 2, 0, 2, {3, 2});
        Workspace workspace;
        workspace.open(documentOf(mesh, even), {});
        Document &document = *workspace.document();
        ShownMap shown(workspace);
        const auto isMeasured = [&](const UvMatrix &map) {
            const TriangleStretch expected =
                StretchMeter(*document.weightedMesh()).measure(soupUv(*mesh, map));
            return shown.stretch().areaLog2 == expected.areaLog2 &&
                   shown.stretch().dirichlet == expected.dirichlet;
        };
        QVERIFY(isMeasured(even));
        shown.showMap(uneven);
        QVERIFY(isMeasured(uneven));
        pushCommand(SetTexelWeights::uniform(document, IndexRanges::all(2), 3));
        QVERIFY(isMeasured(uneven));
        shown.showDocument();
        QVERIFY(isMeasured(even));
        document.undoStack().undo();
        QVERIFY(isMeasured(even));
    }
};

QTEST_MAIN(TestIslandGlide)

} // namespace tst_islandglide

#include "tst_islandglide.moc"
