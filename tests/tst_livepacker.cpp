// Islands shown beside each other while the solver runs.
#include "commands/editpins.h"
#include "support/patience.h"
#include "support/pieces.h"
#include "views/control/live/livepacker.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include "model/plain/uvlayout.h"

#include <QTest>

#include <cmath>

namespace tst_livepacker {

using namespace autocuts;
using namespace autocuts::homotopy;

namespace {

Eigen::AlignedBox2d boxOf(const UvMatrix &soup, int part)
{
    Eigen::AlignedBox2d box;
    const int corners = 6 * test::partFaces;
    for (int c = part * corners; c < (part + 1) * corners; ++c)
        box.extend(Vec2(soup.row(c).transpose()));
    return box;
}

bool apart(const UvMatrix &soup, int parts)
{
    for (int a = 0; a < parts; ++a) {
        for (int b = 0; b < a; ++b) {
            const Eigen::AlignedBox2d common = boxOf(soup, a).intersection(boxOf(soup, b));
            if (!common.isEmpty() && common.volume() > 0.5 * boxOf(soup, a).volume())
                return false;
        }
    }
    return true;
}

} // namespace

class TestLivePacker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void piecesAreLaidApart()
    {
        const auto document = test::partsDocument({{}, {}, {}});
        const MeshData &mesh = document->mesh();
        const UvMatrix soup = soupUv(mesh, document->uv());
        std::vector<bool> held(mesh.faceCount());
        held[4] = true; // of the second part
        const std::vector<float> joined(mesh.cornerPairCount(), 0.1f);
        const std::atomic<bool> stop = false;
        const auto made =
            LivePacker::makeArrangement(mesh, held, {}, document->packingSettings(), joined, soup, stop);
        QVERIFY(made);
        QCOMPARE(made->middle.size(), std::size_t(3));
        QCOMPARE(made->held, (std::vector<char>{0, 1, 0}));
        QVERIFY((made->middle[1] - boxOf(soup, 1).center()).norm() < 1e-12);
        UvMatrix moved = soup;
        for (int t = 0; t < mesh.triangleCount(); ++t)
            moved.middleRows(3 * t, 3).rowwise() +=
                (made->middle[made->piece[t]] - boxOf(soup, made->piece[t]).center()).transpose();
        QVERIFY(apart(moved, 3) && !apart(soup, 3));
        // A cut inside a part makes another piece of it; too many pieces, or one, are left alone.
        const std::vector<float> open(mesh.cornerPairCount(), 0.9f);
        const auto more =
            LivePacker::makeArrangement(mesh, held, {}, document->packingSettings(), open, soup, stop);
        QVERIFY(more);
        QCOMPARE(more->middle.size(), std::size_t(9));
        const auto one = test::partsDocument({{}});
        QVERIFY(!LivePacker::makeArrangement(one->mesh(), std::vector<bool>(3), {}, one->packingSettings(),
                                             std::vector<float>(one->mesh().cornerPairCount()),
                                             soupUv(one->mesh(), one->uv()), stop));
    }

    //! The pieces of each tile lie around it.
    void piecesStayByTheirTiles()
    {
        const auto document = test::partsDocument({{}, {}, {}, {}});
        const MeshData &mesh = document->mesh();
        const UvMatrix soup = soupUv(mesh, document->uv());
        std::vector<int> tiles;
        for (int face = 0; face < mesh.faceCount(); ++face)
            tiles.push_back(face / test::partFaces < 2 ? 1001 : 1003);
        const std::atomic<bool> stop = false;
        const auto made = LivePacker::makeArrangement(
            mesh, std::vector<bool>(mesh.faceCount()), tiles, document->packingSettings(),
            std::vector<float>(mesh.cornerPairCount(), 0.1f), soup, stop);
        QVERIFY(made);
        for (int part = 0; part < 4; ++part)
            QCOMPARE(std::floor(made->middle[part].x()), part < 2 ? 0.0 : 2.0);
        UvMatrix moved = soup;
        for (int t = 0; t < mesh.triangleCount(); ++t)
            moved.middleRows(3 * t, 3).rowwise() +=
                (made->middle[made->piece[t]] - boxOf(soup, made->piece[t]).center()).transpose();
        QVERIFY(apart(moved, 4));
    }

    void nothingButTheViewChanges()
    {
        Workspace workspace;
        ShownMap shown(workspace);
        SolverController solver(workspace, shown);
        workspace.open(test::partsDocument({{}, {}, {}, {}}), {});
        Document &document = *workspace.document();
        const UvMatrix before = document.uv();
        solver.setMode(SolveMode::Manual);
        QVERIFY(!solver.livePacking());
        solver.setLivePacking(true);
        solver.run();
        QVERIFY(QTest::qWaitFor([&] { return shown.isLive() && apart(shown.uv(), 4); }, test::patience));
        QVERIFY(solver.soup());
        QVERIFY(!apart(solver.soup()->soupUv, 4));
        QCOMPARE(document.undoStack().count(), 0);
        // Each triangle is only moved, and those of one part alike.
        const UvMatrix way = shown.uv() - document.uvScale() * solver.soup()->soupUv;
        for (int c = 0; c < way.rows(); ++c)
            QVERIFY((way.row(c) - way.row(c / (6 * test::partFaces) * 6 * test::partFaces)).norm() < 1e-9);
        solver.setLivePacking(false);
        QVERIFY(!apart(shown.uv(), 4));
        solver.setLivePacking(true);
        solver.pause();
        QVERIFY(QTest::qWaitFor([&] { return !solver.isPausing(); }, test::patience));
        QVERIFY(!shown.isLive());
        QVERIFY(document.undoStack().count() <= 1);
        while (document.undoStack().canUndo())
            document.undoStack().undo();
        QVERIFY(document.uv() == before);
    }
};

QTEST_MAIN(TestLivePacker)

} // namespace tst_livepacker

#include "tst_livepacker.moc"
