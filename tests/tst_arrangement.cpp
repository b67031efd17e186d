// Laying out islands as pieces: what is computed, without the window.
#include "commands/setislandflags.h"
#include "commands/stackislands.h"
#include "model/document/document.h"
#include "model/editing/arrangement.h"
#include "model/plain/chartcopies.h"
#include "support/pieces.h"

#include <QTest>

#include <numbers>
#include <numeric>

namespace tst_arrangement {

using namespace autocuts;
using test::PartPlace;

namespace {

constexpr double pi = std::numbers::pi;

//! Pieces with these boxes, each of one island.
std::vector<IslandPiece> boxes(const std::vector<std::array<double, 4>> &sides)
{
    std::vector<IslandPiece> pieces;
    for (const auto &[left, bottom, right, top] : sides) {
        const int number = static_cast<int>(pieces.size());
        pieces.push_back({{number}, {Vec2(left, bottom), Vec2(right, top)}, false});
    }
    return pieces;
}

Eigen::AlignedBox2d moved(const IslandPiece &piece, const Eigen::Affine2d &by)
{
    return {Vec2(by * piece.box.min()), Vec2(by * piece.box.max())};
}

bool near(const Vec2 &a, const Vec2 &b)
{
    return (a - b).norm() < 1e-12;
}

} // namespace

class TestArrangement : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void alignmentMovesOneSide_data()
    {
        QTest::addColumn<int>("to");
        QTest::addColumn<QPointF>("low"); //!< of the second box, which was at (0.4, 0.6)
        QTest::newRow("left") << int(AlignTo::Left) << QPointF(0, 0.6);
        QTest::newRow("right") << int(AlignTo::Right) << QPointF(0.8, 0.6);
        QTest::newRow("bottom") << int(AlignTo::Bottom) << QPointF(0.4, 0.1);
        QTest::newRow("top") << int(AlignTo::Top) << QPointF(0.4, 0.8);
        QTest::newRow("centre u") << int(AlignTo::CentreU) << QPointF(0.4, 0.6);
        QTest::newRow("centre v") << int(AlignTo::CentreV) << QPointF(0.4, 0.45);
    }

    void alignmentMovesOneSide()
    {
        QFETCH(int, to);
        QFETCH(QPointF, low);
        const auto pieces = boxes({{0, 0.1, 0.3, 0.2}, {0.4, 0.6, 0.6, 0.8}, {0.7, 0.5, 1, 1}});
        const auto transforms = alignedPieces(pieces, AlignTo(to), 1);
        const Vec2 place = moved(pieces[1], transforms[1]).min();
        QVERIFY2(near(place, Vec2(low.x(), low.y())),
                 qPrintable(QString::number(place.x()) + u' ' + QString::number(place.y())));
        for (const Eigen::Affine2d &transform : transforms)
            QVERIFY(transform.linear() == Eigen::Matrix2d::Identity());
    }

    void lockedPiecesSayWhere()
    {
        auto pieces = boxes({{0, 0, 0.1, 0.1}, {0.5, 0.5, 0.7, 0.7}});
        pieces[1].locked = true;
        const auto transforms = alignedPieces(pieces, AlignTo::Left, 1);
        QVERIFY(near(moved(pieces[0], transforms[0]).min(), {0.5, 0}));
        QVERIFY(near(moved(pieces[1], transforms[1]).min(), {0.5, 0.5}));
    }

    void onePieceGoesToTheSideOfItsTile()
    {
        const auto pieces = boxes({{1.2, 2.3, 1.4, 2.4}});
        QVERIFY(near(moved(pieces[0], alignedPieces(pieces, AlignTo::Right, 1)[0]).max(), {2, 2.4}));
        QVERIFY(near(moved(pieces[0], alignedPieces(pieces, AlignTo::Top, 1)[0]).max(), {1.4, 3}));
    }

    void distances()
    {
        const auto pieces = boxes({{0, 0, 0.1, 1}, {0.8, 0, 1, 1}, {0.15, 0, 0.45, 1}, {0.2, 0, 0.3, 1}});
        const auto centres = distributedPieces(pieces, Distribute::CentresU);
        QVERIFY(near(centres[0].translation(), Vec2::Zero()) && near(centres[1].translation(), Vec2::Zero()));
        // From 0.05 to 0.9 in the order 0, 3, 2, 1.
        QCOMPARE(moved(pieces[3], centres[3]).center().x(), 0.05 + 0.85 / 3);
        QCOMPARE(moved(pieces[2], centres[2]).center().x(), 0.05 + 2 * 0.85 / 3);
        const auto gaps = distributedPieces(pieces, Distribute::GapsU);
        const double gap = (1 - 0.1 - 0.2 - 0.3 - 0.1) / 3;
        QCOMPARE(moved(pieces[3], gaps[3]).min().x(), 0.1 + gap);
        QCOMPARE(moved(pieces[2], gaps[2]).min().x(), 0.2 + 2 * gap);
        for (const auto &transform : distributedPieces(pieces, Distribute::GapsV))
            QCOMPARE(transform.translation().x(), 0.0);
        const auto two = boxes({{0, 0, 1, 1}, {3, 0, 4, 1}});
        QVERIFY(near(distributedPieces(two, Distribute::GapsU)[1].translation(), Vec2::Zero()));
    }

    void mirroringIsItsOwnInverse()
    {
        const auto pieces = boxes({{0.1, 0.2, 0.5, 0.4}});
        const Eigen::Affine2d u = mirroredPiece(pieces[0], 0), v = mirroredPiece(pieces[0], 1);
        QVERIFY(near(u * Vec2(0.1, 0.25), {0.5, 0.25}) && near(v * Vec2(0.1, 0.25), {0.1, 0.35}));
        QVERIFY((u * u).matrix().isIdentity(1e-15));
        QVERIFY(u.linear().determinant() < 0);
    }

    void smallestBoxTurnsBack_data()
    {
        QTest::addColumn<double>("degrees");
        for (const double degrees : {0.0, 10.0, -30.0, 44.0, 60.0, 100.0, 179.0})
            QTest::addRow("%g", degrees) << degrees;
    }

    void smallestBoxTurnsBack()
    {
        QFETCH(double, degrees);
        std::vector<Vec2> points;
        for (const Vec2 &p : {Vec2(0, 0), Vec2(3, 0), Vec2(3, 1), Vec2(1, 0.5), Vec2(0, 1), Vec2(2, 0.2)})
            points.push_back(Eigen::Rotation2Dd(degrees * pi / 180) * p);
        const double expected = std::remainder(-degrees * pi / 180, pi / 2);
        QVERIFY(std::abs(turnToSmallestBox(points) - expected) < 1e-9);
        points.emplace_back(std::nan(""), 0);
        QVERIFY(std::abs(turnToSmallestBox(points) - expected) < 1e-9);
        const std::vector<Vec2> same(4, Vec2(1, 2));
        QCOMPARE(turnToSmallestBox(same), 0.0);
        QCOMPARE(turnToSmallestBox({}), 0.0);
    }

    void directionsTurnToTheAxes()
    {
        const Vec2 along(std::cos(0.2), std::sin(0.2)), across(-along.y(), along.x());
        QVERIFY(std::abs(turnToDirections(std::vector{along, Vec2(2 * across), Vec2(-along)}) + 0.2) < 1e-12);
        // The longer ones decide.
        const std::vector<Vec2> mixed{Vec2(100, 0), Vec2(0.1, 0.02)};
        QVERIFY(std::abs(turnToDirections(mixed)) < 1e-3);
        QCOMPARE(turnToDirections({}), 0.0);
    }

    void scatterKeepsItsLimits()
    {
        const auto pieces = boxes({{0, 0, 0.1, 0.1}, {0.5, 0.5, 0.7, 0.7}, {0.2, 0.1, 0.3, 0.4}});
        ScatterRanges ranges{0.05, 0.3, 0.25, 7};
        const auto first = scatteredPieces(pieces, ranges), second = scatteredPieces(pieces, ranges);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            QVERIFY(first[i].matrix() == second[i].matrix());
            const Vec2 way = first[i] * pieces[i].box.center() - pieces[i].box.center();
            QVERIFY(way.cwiseAbs().maxCoeff() <= 0.05 && way.norm() > 1e-6);
            const double scale = std::sqrt(first[i].linear().determinant());
            QVERIFY(scale >= 1 / 1.25 && scale <= 1.25 && std::abs(scale - 1) > 1e-6);
            QVERIFY(std::abs(std::atan2(first[i].linear()(1, 0), first[i].linear()(0, 0))) <= 0.3);
        }
        // Alone or with others, a piece gets the same.
        QVERIFY(scatteredPieces(std::span(pieces).subspan(1, 1), ranges)[0].matrix() == first[1].matrix());
        ranges.seed = 8;
        QVERIFY(scatteredPieces(pieces, ranges)[0].matrix() != first[0].matrix());
        QVERIFY(scatteredPieces(pieces, {})[0].matrix().isIdentity(1e-12));
    }

    void groupsAndStacksAreOnePiece()
    {
        const auto document = test::partsDocument({{}, {{1, 0}}, {{2, 0}}, {{3, 0}}});
        pushCommand(
            std::make_unique<SetIslandFlags>(*document, SetIslandFlags::Edit::Group, std::vector<int>{0, 2}));
        pushCommand(
            std::make_unique<SetIslandFlags>(*document, SetIslandFlags::Edit::Lock, std::vector<int>{2}));
        const auto pieces = islandPieces(document->islands(), document->marks(), {0, 1});
        QCOMPARE(pieces.size(), std::size_t(2));
        QCOMPARE(pieces[0].islands, std::vector<int>({0, 2}));
        QVERIFY(pieces[0].locked && !pieces[1].locked);
        QVERIFY(near(pieces[0].box.min(), {0, 0}) && near(pieces[0].box.max(), {2.25, 0.2}));
    }

    void copiesAreFound()
    {
        const auto document =
            test::partsDocument({{}, {{1, 0}, 2.1, 0.7}, {{2, 0}, 0, 1, true}, {{0, 1}, 0, 2}});
        const std::vector<AlikeCharts> kinds = findAlikeCharts(document->mesh(), document->adjacency(),
                                                               document->islands().charts(), {1, 3, 0, 2});
        QCOMPARE(kinds.size(), std::size_t(1));
        QCOMPARE(kinds[0].original, 1);
        QCOMPARE(kinds[0].copies.size(), std::size_t(3));
        std::vector<int> own(test::partCorners), first(test::partCorners);
        std::iota(own.begin(), own.end(), test::partCorners);
        std::iota(first.begin(), first.end(), 0);
        for (const ChartCopy &copy : kinds[0].copies) {
            QCOMPARE(copy.mirrored, copy.chart == 2);
            QCOMPARE(copy.corner.size(), own.size());
            if (copy.chart != 0)
                continue;
            QCOMPARE(copy.corner, first);
            QCOMPARE(copy.source, own); // the same order of corners
        }
    }

    void stacksLieOnEachOther()
    {
        const auto document =
            test::partsDocument({{}, {{1, 0}, 2.1, 0.7}, {{2, 0}, 0, 1, true}, {{0, 1}, 1}});
        const DocumentState before = document->state();
        const auto found = StackIslands::copiesAmong(*document, {0, 1, 2, 3});
        QCOMPARE(found.stacks, (std::vector<std::vector<int>>{{0, 1, 2, 3}}));
        QCOMPARE(found.mirrored, 1);
        QCOMPARE(StackIslands::copiesAmong(*document, {3}).stacks, found.stacks);
        QVERIFY(pushCommand(StackIslands::stack(*document, found.stacks)));
        const auto rows = [&](int part) {
            return document->uv().middleRows(part * test::partCorners, test::partCorners);
        };
        QVERIFY(rows(1) == rows(0) && rows(3) == rows(0));
        const auto area = [&](int island) {
            double sum = 0;
            for (const int face : document->islands().faces(island)) {
                const int first = document->mesh().faceStart[face];
                for (int c = first + 2; c < document->mesh().faceStart[face + 1]; ++c)
                    sum += cross2(Vec2(document->uv().row(first)), Vec2(document->uv().row(c - 1)),
                                  Vec2(document->uv().row(c)));
            }
            return sum;
        };
        QVERIFY(document->islands().box(2).isApprox(document->islands().box(0)));
        QVERIFY(area(0) > 0 && area(2) < 0);
        QCOMPARE(document->islands().count(), 4);
        const auto stackOf = [&](int island) {
            return document->marks().flagsOf(document->islands().faces(island)).stack;
        };
        QVERIFY(stackOf(0) > 0 && stackOf(1) == stackOf(0) && stackOf(3) == stackOf(0) &&
                stackOf(2) == stackOf(0));
        QCOMPARE(document->undoStack().count(), 1);
        QCOMPARE(document->undoStack().undoText(), QStringLiteral("Stack 4 islands"));
        const DocumentState stacked = document->state();
        document->undoStack().undo();
        QVERIFY(document->state() == before);
        document->undoStack().redo();
        QVERIFY(document->state() == stacked);

        QVERIFY(pushCommand(StackIslands::unstack(*document, {0, 1, 2, 3})));
        QVERIFY(stackOf(0) == 0 && stackOf(1) == 0 && stackOf(2) == 0 && stackOf(3) == 0);
        QVERIFY(area(2) > 0);
        for (int a = 0; a < 4; ++a) {
            for (int b = 0; b < a; ++b)
                QVERIFY(!document->islands().box(a).intersects(document->islands().box(b)));
        }
        document->undoStack().undo();
        QVERIFY(document->state() == stacked);
    }

    //! A stack or group that others have left is none.
    void noneIsAStackAlone()
    {
        using Edit = SetIslandFlags::Edit;
        const auto document = test::partsDocument({{}, {{1, 0}}, {{2, 0}}, {{3, 0}}});
        const auto push = [&](Edit edit, const std::vector<int> &islands) {
            QVERIFY(pushCommand(std::make_unique<SetIslandFlags>(*document, edit, islands)));
        };
        const auto flags = [&](int island) {
            return document->marks().flagsOf(document->islands().faces(island));
        };
        push(Edit::Stack, {0, 1, 2});
        push(Edit::Group, {2, 3});
        pushCommand(StackIslands::stack(*document, {{0, 1}}));
        QVERIFY(flags(0).stack > 0 && flags(0).stack == flags(1).stack && flags(2).stack == 0);
        push(Edit::Ungroup, {3});
        QCOMPARE(flags(2).group, 0);
        document->undoStack().undo();
        QVERIFY(flags(2).group > 0 && flags(2).group == flags(3).group);
        push(Edit::Stack, {3}); // one alone may be marked for others to come
        QVERIFY(flags(3).stack > 0);
    }

    void lockedCopiesSayWhere()
    {
        const auto document = test::partsDocument({{}, {{1, 0}}, {{2, 0}}});
        pushCommand(
            std::make_unique<SetIslandFlags>(*document, SetIslandFlags::Edit::Lock, std::vector<int>{1}));
        const auto found = StackIslands::copiesAmong(*document, {0, 1, 2});
        QCOMPARE(found.stacks, (std::vector<std::vector<int>>{{1, 0, 2}}));
        const Eigen::AlignedBox2d place = document->islands().box(1);
        pushCommand(StackIslands::stack(*document, found.stacks));
        for (int island = 0; island < 3; ++island)
            QVERIFY(near(document->islands().box(island).min(), place.min()));
    }
};

QTEST_GUILESS_MAIN(TestArrangement)

} // namespace tst_arrangement

#include "tst_arrangement.moc"
