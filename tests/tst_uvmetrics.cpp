// UV figures: hand-computed maps, and the figures of the independent uvmetrics program on real files.
#include "solver/metrics/uvmetrics.h"
#include "solver/metrics/uvoverlaps.h"
#include "support/meshbuilders.h"
#include "support/objuv.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tst_uvmetrics {

using namespace autocuts;
using namespace autocuts::metrics;

namespace {

constexpr double missing = missingFigure;

//! Equal to 1e-9 relative, or both missing.
bool same(double actual, double expected, double tolerance = 1e-9)
{
    if (std::isnan(actual) || std::isnan(expected))
        return std::isnan(actual) && std::isnan(expected);
    return std::abs(actual - expected) <= tolerance * std::max(1.0, std::abs(expected));
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string squareUv = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
const std::string cubePoints = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";

UvMetrics measure(const std::string &text, int textureSize = 1024)
{
    const test::ObjUv obj = test::parseObjUv(text);
    UvMetricsOptions options;
    options.textureSize = textureSize;
    return measureUv(*obj.mesh, obj.uv, options);
}

//! A value that a figure of the map must have.
struct Expected
{
    const char *name;
    double UvMetrics::*figure;
    double value;
};

struct ExpectedCount
{
    const char *name;
    int UvMetrics::*figure;
    int value;
};

struct Case
{
    const char *name;
    std::string text;
    std::vector<ExpectedCount> counts;
    std::vector<Expected> figures;
    std::int64_t overlapPairs = 0;
};

#define FIGURE(member) #member, &UvMetrics::member

std::vector<Case> cases()
{
    const double root2 = std::sqrt(2.0);
    const double pi = std::numbers::pi;
    std::vector<Case> list;
    list.push_back({"square",
                    square + squareUv + "f 1/1 2/2 3/3 4/4\n",
                    {{FIGURE(triangles), 2},
                     {FIGURE(charts), 1},
                     {FIGURE(flipped), 0},
                     {FIGURE(seamEdges), 0},
                     {FIGURE(boundaryEdges), 4},
                     {FIGURE(nonDiskCharts), 0}},
                    {{FIGURE(symDirichlet), 4},
                     {FIGURE(symDirichletMax), 4},
                     {FIGURE(l2Stretch), 1},
                     {FIGURE(packingUnit), 1},
                     {FIGURE(packingBox), 1},
                     {FIGURE(overlapAreaRatio), 0},
                     {FIGURE(minGutter), missing},
                     {FIGURE(borderGutter), 0},
                     {FIGURE(boundaryLength), 4}}});
    list.push_back({"seam along the diagonal",
                    square + squareUv + "vt 2 0\nvt 3 1\nvt 2 1\nf 1/1 2/2 3/3\nf 1/5 3/6 4/7\n",
                    {{FIGURE(charts), 2}, {FIGURE(seamEdges), 1}, {FIGURE(mirroredCharts), 0}},
                    {{FIGURE(seamLength), root2},
                     {FIGURE(seamNorm), root2 / std::sqrt(1 / pi)},
                     {FIGURE(symDirichlet), 4},
                     {FIGURE(packingUnit), 0.5}, // in two tiles
                     {FIGURE(borderGutter), 0},
                     {FIGURE(minGutter), 1}}});
    list.push_back({"half-cut edge",
                    square + squareUv + "vt 0.9 1.1\nf 1/1 2/2 3/3\nf 1/1 3/5 4/4\n",
                    {{FIGURE(charts), 2}},
                    {{FIGURE(seamLength), root2}}});
    const std::string fan = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\n"
                            "vt 0 0\nvt 1 0.1\nvt 0 1\nvt -1 0\nvt 0 -1\nvt 1 -0.1\n"
                            "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 1/1 4/4 5/5\nf 1/1 5/5 2/";
    list.push_back({"slit",
                    fan + "6\n",
                    {{FIGURE(charts), 1}, {FIGURE(nonDiskCharts), 0}},
                    {{FIGURE(seamLength), 1}, {FIGURE(overlapAreaRatio), 0}}});
    list.push_back({"fold: one triangle flipped over the other",
                    square + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/2\n",
                    {{FIGURE(charts), 1}, {FIGURE(flipped), 1}, {FIGURE(mirroredCharts), 0}},
                    {{FIGURE(flippedUvAreaRatio), 0.5}, {FIGURE(overlapAreaRatio), 0.5}},
                    1});
    list.push_back({"mirrored chart",
                    square + "vt 0 0\nvt -1 0\nvt -1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n",
                    {{FIGURE(mirroredCharts), 1}, {FIGURE(flipped), 0}},
                    {{FIGURE(symDirichlet), 4}}});
    const std::string twoSquares = square + "v 3 0 0\nv 4 0 0\nv 4 1 0\nv 3 1 0\n" + squareUv;
    list.push_back({"shifted squares",
                    twoSquares + "vt 0.5 0.5\nvt 1.5 0.5\nvt 1.5 1.5\nvt 0.5 1.5\n"
                                 "f 1/1 2/2 3/3 4/4\nf 5/5 6/6 7/7 8/8\n",
                    {{FIGURE(charts), 2}},
                    {{FIGURE(overlapAreaRatio), 0.125}, {FIGURE(minGutter), 0}},
                    2});
    list.push_back({"stacked squares",
                    twoSquares + "f 1/1 2/2 3/3 4/4\nf 5/1 6/2 7/3 8/4\n",
                    {{FIGURE(charts), 2}},
                    {{FIGURE(overlapAreaRatio), 0.5}, {FIGURE(packingUnit), 2}},
                    2});
    list.push_back({"squares apart",
                    twoSquares + "vt 1.125 0.5\nvt 2.125 0.5\nvt 2.125 1.5\nvt 1.125 1.5\n"
                                 "f 1/1 2/2 3/3 4/4\nf 5/5 6/6 7/7 8/8\n",
                    {},
                    {{FIGURE(minGutter), 0.125}, {FIGURE(minGutterTexels), 128}}});
    list.push_back({"two densities",
                    twoSquares + "vt 2 0\nvt 2.5 0\nvt 2.5 0.5\nvt 2 0.5\n"
                                 "f 1/1 2/2 3/3 4/4\nf 5/5 6/6 7/7 8/8\n",
                    {},
                    {{FIGURE(texelDensitySpread), 2},
                     {FIGURE(symDirichlet), 5},
                     {FIGURE(l2Stretch), std::sqrt(2.5 * 0.625)},
                     {FIGURE(angleDistortion), 1},
                     {FIGURE(areaDistortion), 2.05}}});
    list.push_back({"stretched by two",
                    square + "vt 0 0\nvt 2 0\nvt 2 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n",
                    {},
                    {{FIGURE(symDirichlet), 5},
                     {FIGURE(symDirichletP99), 5},
                     {FIGURE(symDirichletScale), std::pow(0.25, 0.25)},
                     {FIGURE(l2Stretch), std::sqrt(1.25)},
                     {FIGURE(angleDistortion), 2},
                     {FIGURE(areaDistortion), 1}}});
    list.push_back({"turned a little more, and a little less, than one degree; a diagonal is no border",
                    square + "vt 0 0\nvt 1 0.0176\nvt 1 1\nvt 0.0173 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n",
                    {},
                    {{FIGURE(axisAlignedShare),
                      (0.9827 + 0.9824 + std::hypot(0.0173, 1)) /
                          (0.9827 + 0.9824 + std::hypot(0.0173, 1) + std::hypot(1, 0.0176))}}});
    list.push_back({"sheared",
                    square + "vt 0 0\nvt 1 0\nvt 2 1\nvt 1 1\nf 1/1 2/2 3/3 4/4\n",
                    {},
                    {{FIGURE(symDirichlet), 6},
                     {FIGURE(axisAlignedShare), 2 / (2 + 2 * std::sqrt(2.0))},
                     {FIGURE(angleDistortion), (3 + std::sqrt(5.0)) / 2},
                     {FIGURE(l2Stretch), std::sqrt(1.5)}}});
    list.push_back({"collapsed triangle",
                    square + squareUv + "f 1/1 2/2 3/3\nf 1/4 3/4 4/4\n",
                    {{FIGURE(symDirichletInfinite), 1},
                     {FIGURE(uvDegenerate), 1},
                     {FIGURE(zeroUvCharts), 1},
                     {FIGURE(flipped), 0}},
                    {{FIGURE(symDirichletInfiniteAreaRatio), 0.5}, {FIGURE(symDirichlet), 4}}});
    list.push_back({"missing UVs",
                    square + "vt 0 0\nvt 1 0\nvt nan 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/2 4/4\n",
                    {{FIGURE(facesWithoutUv), 1},
                     {FIGURE(charts), 1},
                     {FIGURE(missingUvEdges), 1},
                     {FIGURE(seamEdges), 0}},
                    {{FIGURE(area3d), 1}, {FIGURE(uvArea), 0.5}}});
    list.push_back(
        {"no UVs at all",
         square + "f 1 2 3 4\n",
         {{FIGURE(facesWithoutUv), 1}, {FIGURE(charts), 0}},
         {{FIGURE(symDirichlet), missing}, {FIGURE(packingBox), missing}, {FIGURE(seamLength), 0}}});
    list.push_back(
        {"empty",
         "",
         {{FIGURE(faces), 0}, {FIGURE(triangles), 0}},
         {{FIGURE(symDirichlet), missing}, {FIGURE(seamNorm), missing}, {FIGURE(overlapAreaRatio), 0}}});
    list.push_back(
        {"zero-area triangle",
         square + "v 2 0 0\nv 3 0 0\n" + squareUv + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 2/2 5/2 6/2\n",
         {{FIGURE(zeroAreaTriangles), 1}, {FIGURE(symDirichletInfinite), 0}},
         {{FIGURE(symDirichlet), 4}}});
    list.push_back({"welded by position",
                    square + "v 0 0 0\nv 1 1 0\nv 0 1 -0\n" + squareUv +
                        "vt 0 0.000001\nvt 1 1.000001\nvt 0 1\nf 1/1 2/2 3/3\nf 5/5 6/6 7/7\n",
                    {{FIGURE(weldedVertices), 4}, {FIGURE(charts), 1}},
                    {{FIGURE(seamLength), 0}}});
    list.push_back({"further apart than the tolerance",
                    square + squareUv + "vt 0 0.000003\nvt 1 1.000003\nf 1/1 2/2 3/3\nf 1/5 3/6 4/4\n",
                    {{FIGURE(charts), 2}},
                    {{FIGURE(seamLength), root2}}});
    list.push_back(
        {"three triangles on one edge",
         "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nvt 0 -1\nvt 2 0\nvt 3 0\n"
         "vt 2 1\nf 1/1 2/2 3/3\nf 2/2 1/1 4/4\nf 1/5 2/6 5/7\n",
         {{FIGURE(nonManifoldEdges), 1}, {FIGURE(charts), 2}},
         {{FIGURE(seamLength), 0}, {FIGURE(nonManifoldSeamLength), 1}}});
    list.push_back(
        {"concave quad, negative indices",
         "v 0 0 0\nv 2 1 0\nv 4 0 0\nv 2 4 0\nvt 0 0\nvt 2 1\nvt 4 0\nvt 2 4\nf -4/-4 -3/-3 -2/-2 -1/-1\n",
         {{FIGURE(flipped), 0}},
         {{FIGURE(area3d), 6}, {FIGURE(symDirichlet), 4}}});
    list.push_back({"net of a cube",
                    cubePoints +
                        "vt 0 1\nvt 1 1\nvt 2 1\nvt 3 1\nvt 4 1\nvt 0 2\nvt 1 2\nvt 2 2\nvt 3 2\nvt 4 2\n"
                        "vt 0 0\nvt 1 0\nvt 0 3\nvt 1 3\n"
                        "f 1/1 2/2 6/7 5/6\nf 2/2 3/3 7/8 6/7\nf 3/3 4/4 8/9 7/8\nf 4/4 1/5 5/10 8/9\n"
                        "f 1/1 4/11 3/12 2/2\nf 5/6 6/7 7/14 8/13\n",
                    {{FIGURE(charts), 1},
                     {FIGURE(nonDiskCharts), 0},
                     {FIGURE(interiorEdges), 12},
                     {FIGURE(seamEdges), 7}},
                    {{FIGURE(seamLength), 7},
                     {FIGURE(seamNorm), 7 / std::sqrt(6 / pi)},
                     {FIGURE(symDirichlet), 4},
                     {FIGURE(packingBox), 0.5},
                     {FIGURE(packingSquare), 0.375}}});
    std::string annulus;
    const int x[] = {1, 0, -1, 0}, y[] = {0, 1, 0, -1};
    for (int i = 0; i < 4; ++i) {
        for (int k = 1; k <= 2; ++k) {
            const std::string place = std::to_string(k * x[i]) + " " + std::to_string(k * y[i]);
            annulus.append("v ").append(place).append(" 0\nvt ").append(place).append("\n");
        }
    }
    for (int i = 0; i < 4; ++i) {
        annulus += "f";
        for (int c : {2 * i + 1, 2 * i + 2, 2 * ((i + 1) % 4) + 2, 2 * ((i + 1) % 4) + 1})
            annulus.append(" ").append(std::to_string(c)).append("/").append(std::to_string(c));
        annulus += "\n";
    }
    list.push_back({"annulus",
                    annulus,
                    {{FIGURE(charts), 1}, {FIGURE(nonDiskCharts), 1}},
                    {{FIGURE(symDirichlet), 4}, {FIGURE(overlapAreaRatio), 0}}});
    // Polygons without a good fan. U, as it lies on the model; with the notch at other corners in the map, in
    // both directions; crossing itself there.
    const std::string uShape = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n";
    const std::string uFace = "f 1/1 2/2 3/3 4/4 5/5 6/6 7/7 8/8\n";
    list.push_back({"polygon without a fan",
                    uShape + "vt 0 0\nvt 3 0\nvt 3 3\nvt 2 3\nvt 2 1\nvt 1 1\nvt 1 3\nvt 0 3\n" + uFace,
                    {{FIGURE(triangles), 6}, {FIGURE(flipped), 0}},
                    {{FIGURE(uvArea), 7}, {FIGURE(symDirichlet), 4}, {FIGURE(overlapAreaRatio), 0}}});
    list.push_back({"polygon without a fan, other notch in the map",
                    uShape + "vt 3 3\nvt 2 3\nvt 2 1\nvt 1 1\nvt 1 3\nvt 0 3\nvt 0 0\nvt 3 0\n" + uFace,
                    {{FIGURE(triangles), 6}, {FIGURE(flipped), 0}},
                    {{FIGURE(uvArea), 7}, {FIGURE(overlapAreaRatio), 0}}});
    list.push_back({"polygon without a fan, other notch, mirrored",
                    uShape + "vt -3 3\nvt -2 3\nvt -2 1\nvt -1 1\nvt -1 3\nvt 0 3\nvt 0 0\nvt -3 0\n" + uFace,
                    {{FIGURE(flipped), 0}, {FIGURE(mirroredCharts), 1}},
                    {{FIGURE(uvArea), 7}, {FIGURE(overlapAreaRatio), 0}}});
    return list;
}

} // namespace

class TestUvMetrics : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void handComputed_data()
    {
        QTest::addColumn<int>("index");
        const auto list = cases();
        for (int i = 0; i < static_cast<int>(list.size()); ++i)
            QTest::newRow(list[i].name) << i;
    }

    void handComputed()
    {
        QFETCH(int, index);
        const Case item = cases()[index];
        const UvMetrics metrics = measure(item.text);
        for (const ExpectedCount &count : item.counts)
            QVERIFY2(metrics.*count.figure == count.value,
                     qPrintable(QStringLiteral("%1: %2 instead of %3")
                                    .arg(QString::fromLatin1(count.name))
                                    .arg(metrics.*count.figure)
                                    .arg(count.value)));
        for (const Expected &figure : item.figures)
            QVERIFY2(same(metrics.*figure.figure, figure.value),
                     qPrintable(QStringLiteral("%1: %2 instead of %3")
                                    .arg(QString::fromLatin1(figure.name))
                                    .arg(metrics.*figure.figure, 0, 'g', 12)
                                    .arg(figure.value, 0, 'g', 12)));
        QCOMPARE(metrics.overlapPairs, item.overlapPairs);
        QCOMPARE(metrics.overlapPairsSameChart,
                 item.name == std::string("fold: one triangle flipped over the other") ? item.overlapPairs
                                                                                       : 0);
    }

    void trianglesHaveTheirOwnFigures()
    {
        // The second square is half as large in UV: too small there, and the other too large.
        const UvMetrics metrics = measure(square + "v 3 0 0\nv 4 0 0\nv 4 1 0\nv 3 1 0\n" + squareUv +
                                          "vt 2 0\nvt 2.5 0\nvt 2.5 0.5\nvt 2 0.5\nf 1/1 2/2 3/3 4/4\nf 5/5 "
                                          "6/6 7/7\nf 5/5 7/7 8/7\nf 5 6 8\n");
        QCOMPARE(metrics.triangleSymDirichlet.size(), std::size_t(5));
        QVERIFY(metrics.triangleAreaStretch[0] > 0);
        QVERIFY(metrics.triangleAreaStretch[2] < 0);
        QVERIFY(std::isinf(metrics.triangleSymDirichlet[3]));
        QVERIFY(std::isnan(metrics.triangleSymDirichlet[4]));
        QCOMPARE(metrics.triangleSymDirichlet[0], metrics.triangleSymDirichlet[1]);
    }

    void flippedTrianglesAreMarked()
    {
        const UvMetrics metrics =
            measure(square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0.9 0.5\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
        QCOMPARE(metrics.flipped, 1);
        QCOMPARE(metrics.triangleFlipped, (std::vector<bool>{false, true}));
    }

    void figuresHaveTheOrderOfTheTriangles()
    {
        // Large enough for triangles in another order than their faces; some vertices go too far.
        const auto mesh = test::grid(70);
        QVERIFY(!std::is_sorted(mesh->triangleFace.begin(), mesh->triangleFace.end()));
        UvMatrix uv(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c) {
            uv.row(c) = mesh->cornerPosition(c).head<2>().transpose();
            if (mesh->cornerVertex[c] % 101 == 50)
                uv.row(c) += Vec2(0.03, 0.02).transpose();
        }
        const UvMetrics metrics = measureUv(*mesh, uv);
        QVERIFY(metrics.flipped > 10);
        for (int t = 0; t < mesh->triangleCount(); ++t) {
            const auto &corner = mesh->triangles[t];
            const double area = cross2(uv.row(corner[0]), uv.row(corner[1]), uv.row(corner[2]));
            QCOMPARE(bool(metrics.triangleFlipped[t]), area < 0);
        }
    }

    void stackedIslandsDoNotOverlap()
    {
        // Two copies of a square on each other, a third island beside them, and a fourth that covers the
        // third.
        const test::ObjUv obj = test::parseObjUv(
            square + "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 0 0 2\nv 1 0 2\nv 1 1 2\nv 0 1 2\nv 0 0 3\n"
                     "v 1 0 3\nv 1 1 3\nv 0 1 3\nvt 0 0\nvt .3 0\nvt .3 .3\nvt 0 .3\nvt .5 0\nvt .8 0\n"
                     "vt .8 .3\nvt .5 .3\nf 1/1 2/2 3/3 4/4\nf 5/1 6/2 7/3 8/4\nf 9/5 10/6 11/7 12/8\n"
                     "f 13/5 14/6 15/7 16/8\n");
        UvMetricsOptions options;
        options.faceFlags.resize(4);
        options.faceFlags[0].stack = options.faceFlags[1].stack = 3;
        const UvMetrics metrics = measureUv(*obj.mesh, obj.uv, options);
        QCOMPARE(metrics.stackedPairs, std::int64_t(2));
        QVERIFY(std::abs(metrics.packingUnit - 3 * 0.09) < 1e-12); // a stack covers its place once
        QCOMPARE(metrics.tiles.size(), std::size_t(1));
        QVERIFY(std::abs(metrics.tiles[0].efficiency - 3 * 0.09) < 1e-12);
        QCOMPARE(metrics.overlapPairs, std::int64_t(2));
        QCOMPARE(metrics.overlappingTriangles, std::int64_t(4));
        QVERIFY(same(metrics.overlapAreaRatio, 0.25));
        UvOverlapOptions overlaps;
        overlaps.faceFlags = options.faceFlags;
        const overlap::OverlapList list = findUvOverlaps(*obj.mesh, obj.uv, overlaps);
        QCOMPARE(list.pairs.size(), std::size_t(2));
        QCOMPARE(overlappingTriangles(*obj.mesh, obj.uv, overlaps), overlappingTriangles(list));
        for (const int t : overlappingTriangles(list))
            QVERIFY(obj.mesh->triangleFace[t] >= 2);
        overlaps.maxPairs = 1;
        QCOMPARE(findUvOverlaps(*obj.mesh, obj.uv, overlaps).pairs.size(), std::size_t(1));

        // In two stacks they do.
        options.faceFlags[1].stack = 4;
        QCOMPARE(measureUv(*obj.mesh, obj.uv, options).overlapPairs, std::int64_t(4));

        // Nothing but stacks: the gutter is that between the stacks.
        options.faceFlags[0].stack = options.faceFlags[1].stack = 3;
        options.faceFlags[2].stack = options.faceFlags[3].stack = 4;
        const UvMetrics stacks = measureUv(*obj.mesh, obj.uv, options);
        QCOMPARE(stacks.overlapPairs, std::int64_t(0));
        QVERIFY(same(stacks.minGutter, 0.2));

        // An island of a stack that covers itself overlaps.
        const test::ObjUv fold = test::parseObjUv(square + squareUv + "f 1/1 2/2 3/3\nf 1/1 3/3 4/2\n");
        options.faceFlags.assign(2, IslandFlags{.stack = 3});
        QCOMPARE(measureUv(*fold.mesh, fold.uv, options).overlapPairs, std::int64_t(1));
    }

    void partsCanBeLeftOut()
    {
        const test::ObjUv obj = test::parseObjUv(square + squareUv + "f 1/1 2/2 3/3\nf 1/2 3/3 4/4\n");
        UvMetricsOptions options;
        options.overlaps = false;
        options.gutter = false;
        const UvMetrics metrics = measureUv(*obj.mesh, obj.uv, options);
        QCOMPARE(metrics.overlapPairs, std::int64_t(-1));
        QVERIFY(std::isnan(metrics.overlapAreaRatio) && std::isnan(metrics.minGutter));
    }

    void wrongSizeIsRefused()
    {
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, measureUv(*test::triangle(), UvMatrix(2, 2)));
    }

    void agreesWithTheIndependentProgram_data()
    {
        QTest::addColumn<QString>("path");
        QStringList folders;
        const std::string meshes = test::meshFolder();
        if (!meshes.empty()) {
            const QDir root(QString::fromStdString(meshes));
            for (const QString &name : root.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
                folders << root.filePath(name);
            folders << root.filePath(QStringLiteral("../islands"));
        }
        if (qEnvironmentVariableIsSet("AUTOCUTS_UVMETRICS_FILES"))
            folders << qEnvironmentVariable("AUTOCUTS_UVMETRICS_FILES");
        for (const QString &folder : std::as_const(folders)) {
            for (const QString &file : QDir(folder).entryList({QStringLiteral("*.obj")}, QDir::Files))
                QTest::newRow(qPrintable(file)) << QDir(folder).filePath(file);
        }
        if (folders.isEmpty())
            QTest::newRow("no meshes") << QString();
    }

    void agreesWithTheIndependentProgram();
};

namespace {

//! Compares one figure with a field of the program's output; null means missing.
QString difference(const QJsonObject &judged, const char *name, double figure)
{
    const QJsonValue value = judged.value(QLatin1String(name));
    const double expected = value.isDouble() ? value.toDouble() : missing;
    if (same(figure, expected, 1e-6) && std::abs(figure - expected) <= 1e-6 * std::abs(expected) + 1e-12)
        return {};
    if (std::isnan(figure) && std::isnan(expected))
        return {};
    return QStringLiteral("%1: %2, the program says %3; ")
        .arg(QLatin1String(name))
        .arg(figure, 0, 'g', 10)
        .arg(expected, 0, 'g', 10);
}

QString differences(const QJsonObject &judged, const UvMetrics &m)
{
    const std::pair<const char *, double> figures[] = {
        {"faces", m.faces},
        {"triangles", m.triangles},
        {"vertices", m.vertices},
        {"welded_vertices", m.weldedVertices},
        {"zero_area_triangles", m.zeroAreaTriangles},
        {"faces_without_uv", m.facesWithoutUv},
        {"area_3d", m.area3d},
        {"charts", m.charts},
        {"non_disk_charts", m.nonDiskCharts},
        {"interior_edges", m.interiorEdges},
        {"boundary_edges", m.boundaryEdges},
        {"nonmanifold_edges", m.nonManifoldEdges},
        {"missing_uv_edges", m.missingUvEdges},
        {"seam_edges", m.seamEdges},
        {"seam_length", m.seamLength},
        {"seam_norm", m.seamNorm},
        {"boundary_length", m.boundaryLength},
        {"nonmanifold_seam_length", m.nonManifoldSeamLength},
        {"flipped", m.flipped},
        {"flipped_uv_area_ratio", m.flippedUvAreaRatio},
        {"uv_degenerate", m.uvDegenerate},
        {"mirrored_charts", m.mirroredCharts},
        {"sym_dirichlet", m.symDirichlet},
        {"sym_dirichlet_p99", m.symDirichletP99},
        {"sym_dirichlet_max", m.symDirichletMax},
        {"sym_dirichlet_infinite", m.symDirichletInfinite},
        {"sym_dirichlet_infinite_area_ratio", m.symDirichletInfiniteAreaRatio},
        {"sym_dirichlet_scale", m.symDirichletScale},
        {"l2_stretch", m.l2Stretch},
        {"angle_distortion", m.angleDistortion},
        {"area_distortion", m.areaDistortion},
        {"texel_density_spread", m.texelDensitySpread},
        {"zero_uv_charts", m.zeroUvCharts},
        {"overlap_area_ratio", m.overlapAreaRatio},
        {"overlap_pairs", double(m.overlapPairs)},
        {"overlap_pairs_same_chart", double(m.overlapPairsSameChart)},
        {"uv_area", m.uvArea},
        {"uv_min_u", m.uvMin.x()},
        {"uv_max_v", m.uvMax.y()},
        {"packing_bbox", m.packingBox},
        {"packing_square", m.packingSquare},
        {"packing_unit", m.packingUnit},
        {"min_gutter", m.minGutter},
        {"min_gutter_texels_1024", m.minGutterTexels},
        {"border_gutter", m.borderGutter}};
    QString all;
    for (const auto &[name, figure] : figures)
        all += difference(judged, name, figure);
    if (judged.value(QLatin1String("in_unit_square")).toBool() != m.inUnitSquare)
        all += QStringLiteral("in_unit_square");
    return all;
}

} // namespace

void TestUvMetrics::agreesWithTheIndependentProgram()
{
    QFETCH(QString, path);
    const QString program = qEnvironmentVariable("AUTOCUTS_UVMETRICS");
    if (program.isEmpty())
        QSKIP("AUTOCUTS_UVMETRICS does not name the uvmetrics program");
    if (path.isEmpty())
        QSKIP(test::noMeshes);
    QProcess process;
    process.start(program, {QStringLiteral("--json"), QStringLiteral("--margin"), path});
    QVERIFY(process.waitForFinished(60000));
    const QJsonObject judged = QJsonDocument::fromJson(process.readAllStandardOutput()).object();
    QVERIFY(!judged.isEmpty());

    const test::ObjUv obj = test::readObjUv(path.toStdString());
    UvMetricsOptions options;
    options.textureSize = 1024;
    const UvMetrics metrics = measureUv(*obj.mesh, obj.uv, options);
    QCOMPARE(differences(judged, metrics), QString());
}

QTEST_APPLESS_MAIN(TestUvMetrics)

} // namespace tst_uvmetrics

#include "tst_uvmetrics.moc"
