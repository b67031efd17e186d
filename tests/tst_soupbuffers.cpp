// What the graphics card is given: positions, UVs, colours and lines, heat-maps and their colours.
#include "model/document/islandcolor.h"
#include "model/plain/flippedtriangles.h"
#include "model/plain/uvlayout.h"
#include "solver/metrics/uvmetrics.h"
#include "support/editsupport.h"
#include "support/meshbuilders.h"
#include "views/gl/buried.h"
#include "views/gl/colormap.h"
#include "views/gl/soupbuffers.h"
#include "views/gl/texeldensity.h"
#include "views/ui/preferences.h"

#include <QTest>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <set>

namespace tst_soupbuffers {

using namespace autocuts;
using namespace autocuts::metrics;
using test::MeshPtr;

namespace {

//! UVs from x and y, squeezed and sheared so that all triangles are stretched differently.
UvMatrix unevenLayout(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        const Vec3 p = mesh.cornerPosition(c);
        uv.row(c) << p.x() + 0.4 * p.x() * p.x() + 0.2 * p.y(), p.y() * (0.6 + 0.3 * p.x());
    }
    return uv;
}

//! All that the functions want, for one mesh and layout.
struct Scenery
{
    explicit Scenery(const MeshPtr &m, const UvMatrix &cornerUv)
        : mesh(*m), keep(m), topology(mesh), uv(soupUv(mesh, cornerUv)), seams(Seams::allFree(mesh)),
          separation(mesh.cornerPairCount(), 0), islands(mesh.faceCount(), 0), flipped(mesh.triangleCount())
    {}

    std::vector<FaceTexel> faces() const
    {
        return faceTexels({mesh,
                           uv,
                           options,
                           colors,
                           false,
                           QColor(10, 20, 30),
                           stretch,
                           islands,
                           seams.weights,
                           selectedFaces,
                           overlapping,
                           flipped,
                           density,
                           rightDensity,
                           {},
                           {},
                           vertexColors});
    }
    std::vector<SideTexel> sides() const
    {
        return sideTexels({mesh, topology, uv, separation, seams, options, selectedEdges, givenSeams});
    }

    const MeshData &mesh;
    MeshPtr keep;
    SoupTopology topology;
    UvMatrix uv;
    Seams seams;
    ViewOptions options;
    ViewColors colors = ViewColors::of(PreferenceValues(), false);
    TriangleStretch stretch;
    std::vector<float> separation, density;
    double rightDensity = 1;
    std::vector<int> islands, selectedFaces, selectedEdges, overlapping;
    std::vector<bool> flipped, givenSeams;
    CornerColors vertexColors;
};

quint8 style(SideStyle s)
{
    return static_cast<quint8>(s);
}

} // namespace

class TestSoupBuffers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! Not as infinitely small.
    void facesWithoutUvsHaveNoHeat()
    {
        const MeshPtr mesh = test::grid(2);
        UvMatrix uv = UvMatrix::Zero(mesh->cornerCount(), 2);
        for (int c = 0; c < mesh->cornerCount(); ++c)
            uv.row(c) = mesh->cornerPosition(c).head<2>();
        uv.topRows(mesh->faceStart[1]).setConstant(std::nan(""));
        Scenery scenery(mesh, uv);
        scenery.stretch = StretchMeter(*mesh).measure(scenery.uv);
        scenery.density.assign(std::size_t(mesh->triangleCount()), 1);
        for (const Coloring coloring :
             {Coloring::SignedStretch, Coloring::StretchMagnitude, Coloring::Density}) {
            scenery.options.coloring = coloring;
            const std::vector<FaceTexel> faces = scenery.faces();
            QCOMPARE(faces.front().red, quint8(10));
            QVERIFY(faces.back().red != 10);
        }
    }

    void topologyNamesEverySideOnce()
    {
        const MeshPtr mesh = test::dirty();
        const MeshAdjacency adjacency(*mesh);
        const SoupTopology topology(*mesh);
        QCOMPARE(static_cast<int>(topology.edgeSides.size()), adjacency.edgeCount());
        int diagonals = 0;
        for (int side = 0; side < mesh->soupCornerCount(); ++side) {
            const int edge = topology.sideEdge[side];
            if (edge < 0) {
                ++diagonals;
                continue;
            }
            QVERIFY(topology.edgeSides[edge][0] == side || topology.edgeSides[edge][1] == side);
            QCOMPARE(adjacency.edgeOfCorner(mesh->cornerOfSoup(side)), edge);
        }
        int expected = 0;
        for (const EdgePair &pair : mesh->edgePairs)
            expected += 2 * pair.diagonal;
        QVERIFY(expected > 0);
        QCOMPARE(diagonals, expected);
    }

    void verticesAreInTheFrame()
    {
        const MeshPtr mesh = test::dirty(); // far from the origin
        const MeshFrame frame = MeshFrame::of(*mesh);
        const auto vertices = soupVertices(*mesh, {}, frame);
        double farthest = 0;
        for (const SoupVertex &vertex : vertices) {
            const Eigen::Vector3f p(vertex.position.data()), n(vertex.normal.data());
            farthest = std::max<double>(farthest, p.norm());
            QVERIFY(std::abs(n.norm() - 1) < 1e-5f);
        }
        QVERIFY(farthest <= 1.00001 && farthest > 0.5);
        QVERIFY(frame.lower.y() < frame.upper.y());
    }

    void normalsAreSmoothButNotOverCreases()
    {
        const MeshPtr cube = test::quadCube(), sphere = test::sphere(24, 40);
        const auto sharp = soupVertices(*cube, {}, MeshFrame::of(*cube));
        for (const SoupVertex &vertex : sharp) {
            const Eigen::Vector3f n(vertex.normal.data());
            QVERIFY(std::abs(n.cwiseAbs().maxCoeff() - 1) < 1e-6f);
        }
        const auto smooth = soupVertices(*sphere, {}, MeshFrame::of(*sphere));
        for (const SoupVertex &vertex : smooth) {
            const Eigen::Vector3f n(vertex.normal.data()), p(vertex.position.data());
            QVERIFY(n.dot(p.normalized()) > 0.99f);
        }
    }

    void uvsWithoutValueAreMarked()
    {
        UvMatrix uv(6, 2);
        uv << 0, 0, 1, 0, 0, 1, 2, 3, std::numeric_limits<double>::quiet_NaN(), 1, 4, 5;
        const std::vector<float> buffer = soupUvs(uv);
        QCOMPARE(buffer.size(), 12u);
        QCOMPARE(buffer[2], 1.0f);
        for (int i = 6; i < 12; ++i)
            QCOMPARE(buffer[i], noUv);
        uv(4, 0) = 1e300; // would be infinite
        QCOMPARE(soupUvs(uv)[7], noUv);
    }

    void islandsOfTheLiveMap()
    {
        const MeshPtr mesh = test::grid(2);
        std::vector<float> separation(mesh->cornerPairCount(), 0.49f);
        QCOMPARE(liveIslands(*mesh, separation), (std::vector<int>{0, 0, 0, 0}));
        for (std::size_t e = 0; e < mesh->edgePairs.size(); ++e) {
            if (!mesh->edgePairs[e].diagonal)
                separation[2 * e] = 0.5f; // one end is enough
        }
        QCOMPARE(liveIslands(*mesh, separation), (std::vector<int>{0, 1, 2, 3}));
    }

    void ghostsJoinWhatIsNearlyJoined()
    {
        const MeshPtr mesh = test::grid(1); // two triangles and a diagonal
        UvMatrix uv = soupUv(*mesh, test::splitLayout(*mesh));
        const EdgePair &pair = mesh->edgePairs[0];
        uv.row(pair.corner[0][1]) += Vec2(0.2, 0).transpose();
        uv.row(pair.corner[1][1]) += Vec2(0, 0.4).transpose();
        const std::vector<float> separation{0.49f, 0.5f};
        const UvMatrix ghost = ghostUv(*mesh, uv, separation);
        for (int which = 0; which < 2; ++which) {
            const Vec2 middle = 0.5 * (uv.row(pair.corner[0][0]) + uv.row(pair.corner[0][1]));
            QVERIFY((Vec2(ghost.row(pair.corner[0][which])) - middle).norm() < 1e-12);
            QCOMPARE(Vec2(ghost.row(pair.corner[1][which])), Vec2(uv.row(pair.corner[1][which])));
        }
    }

    void flippedIsAgainstTheIsland()
    {
        const MeshPtr mesh = test::grid(2);
        const std::vector<int> one{0, 0, 0, 0};
        UvMatrix uv = soupUv(*mesh, test::splitLayout(*mesh));
        QCOMPARE(flippedTriangles(*mesh, uv, one), std::vector<bool>(8, false));
        UvMatrix mirrored = uv;
        mirrored.col(0) *= -1;
        QCOMPARE(flippedTriangles(*mesh, mirrored, one), std::vector<bool>(8, false));
        uv.row(3).swap(uv.row(4));
        const std::vector<bool> flipped = flippedTriangles(*mesh, uv, one);
        for (int t = 0; t < 8; ++t)
            QCOMPARE(flipped[t], t == 1);
        QCOMPARE(flippedTriangles(*mesh, uv, std::vector<int>{-1, -1, -1, -1}), std::vector<bool>(8, false));
    }

    void stretchIsThatOfTheFigures_data()
    {
        QTest::addColumn<MeshPtr>("mesh");
        QTest::newRow("grid") << test::grid(6, 0.3);
        QTest::newRow("cube") << test::cube();
        QTest::newRow("dirty") << test::dirty();
    }

    void stretchIsThatOfTheFigures()
    {
        QFETCH(MeshPtr, mesh);
        const UvMatrix cornerUv = unevenLayout(*mesh);
        UvMetricsOptions options;
        options.overlaps = options.gutter = false;
        const UvMetrics metrics = measureUv(*mesh, cornerUv, options);
        const TriangleStretch stretch = StretchMeter(*mesh).measure(soupUv(*mesh, cornerUv));
        int compared = 0;
        for (int t = 0; t < mesh->triangleCount(); ++t) {
            const double expected = metrics.triangleSymDirichlet[t];
            if (std::isnan(expected)) {
                QVERIFY(std::isnan(stretch.dirichlet[t]));
                continue;
            }
            if (!std::isfinite(expected)) {
                QVERIFY(stretch.dirichlet[t] > 1e6f);
                continue;
            }
            ++compared;
            QVERIFY(std::abs(stretch.dirichlet[t] - expected) <= 1e-5 * expected);
            QVERIFY(std::abs(stretch.areaLog2[t] - metrics.triangleAreaStretch[t] / std::log(2.0)) < 1e-5);
        }
        QVERIFY(compared > 2);
    }

    void stretchOfNothing()
    {
        const MeshPtr mesh = test::cube();
        const TriangleStretch stretch = StretchMeter(*mesh).measure(
            UvMatrix::Constant(mesh->soupCornerCount(), 2, std::numeric_limits<double>::quiet_NaN()));
        for (float value : stretch.dirichlet)
            QVERIFY(std::isnan(value));
        const TriangleStretch flat = StretchMeter(*mesh).measure(UvMatrix::Zero(mesh->soupCornerCount(), 2));
        for (float value : flat.areaLog2)
            QVERIFY(!std::isfinite(value));
    }

    void facesHaveColoursAndMarks()
    {
        const MeshPtr mesh = test::grid(2);
        Scenery scenery(mesh, test::splitLayout(*mesh));
        scenery.selectedFaces = {2};
        scenery.overlapping = {0, 3, 99};
        scenery.flipped[7] = true;
        scenery.uv.row(4).setConstant(std::numeric_limits<double>::quiet_NaN());
        std::vector<FaceTexel> faces = scenery.faces();
        for (int t = 0; t < 8; ++t) {
            QCOMPARE(faces[t].red, 10);
            QCOMPARE(faces[t].green, 20);
            QCOMPARE(faces[t].blue, 30);
            const int marks = (t / 2 == 2 ? FaceTexel::Selected : 0) |
                              (t == 0 || t == 3 ? FaceTexel::Overlapping : 0) |
                              (t == 7 ? FaceTexel::Flipped : 0) | (t == 1 ? FaceTexel::WithoutUv : 0);
            QCOMPARE(static_cast<int>(faces[t].marks), marks);
        }
        scenery.options.problems = false;
        faces = scenery.faces();
        QCOMPARE(faces[7].marks, 0);
        QCOMPARE(faces[0].marks, 0);
    }

    void facesFollowTheColouring()
    {
        const MeshPtr mesh = test::grid(2);
        Scenery scenery(mesh, test::splitLayout(*mesh));
        const auto colorOf = [&](int t) {
            const FaceTexel texel = scenery.faces()[t];
            return qRgb(texel.red, texel.green, texel.blue);
        };
        scenery.options.coloring = Coloring::Islands;
        scenery.islands = {0, 1, -1, 3};
        QCOMPARE(colorOf(0), islandColor(0));
        QCOMPARE(colorOf(2), islandColor(1));
        QCOMPARE(colorOf(4), qRgb(10, 20, 30));

        scenery.stretch = {std::vector<float>(8, 0.5f), std::vector<float>(8, 6.0f)};
        scenery.stretch.areaLog2[1] = std::numeric_limits<float>::quiet_NaN();
        scenery.options.coloring = Coloring::SignedStretch;
        scenery.options.stretchClamp = 2;
        QCOMPARE(colorOf(0), heatColor(HeatMap::SignedStretch, false, 0.25));
        QCOMPARE(colorOf(1), heatColorOfNothing());
        scenery.options.coloring = Coloring::StretchMagnitude;
        scenery.options.magnitudeClamp = 8;
        QCOMPARE(colorOf(0), heatColor(HeatMap::Magnitude, false, 0.5));

        scenery.options.coloring = Coloring::PaintWeights;
        for (std::size_t e = 0; e < mesh->edgePairs.size(); ++e) {
            const EdgePair &pair = mesh->edgePairs[e];
            if (!pair.diagonal &&
                (mesh->triangleFace[pair.triangle[0]] == 0 || mesh->triangleFace[pair.triangle[1]] == 0))
                scenery.seams.weights[2 * e] = scenery.seams.weights[2 * e + 1] = 10;
        }
        const QRgb painted = colorOf(0), between = colorOf(2), other = colorOf(6);
        QCOMPARE(painted, paintColor(10, qRgb(10, 20, 30)));
        QVERIFY(qRed(painted) > qRed(between) && qRed(between) > qRed(other));
        QCOMPARE(other, qRgb(10, 20, 30));

        scenery.options.coloring = Coloring::VertexColors;
        QCOMPARE(colorOf(0), qRgb(10, 20, 30));
        scenery.vertexColors.assign(std::size_t(mesh->cornerCount()), CornerColor::fromSrgb(1, 0.2, 0));
        scenery.vertexColors[std::size_t(mesh->triangles[3][1])] = {};
        QCOMPARE(colorOf(0), qRgb(255, 51, 0));
        QCOMPARE(colorOf(3), qRgb(10, 20, 30));
    }

    void linesFollowTheSeparation()
    {
        const MeshPtr mesh = test::quadCube();
        Scenery scenery(mesh, unevenLayout(*mesh));
        int pairIndex = 0;
        while (mesh->edgePairs[pairIndex].diagonal)
            ++pairIndex;
        const EdgePair &pair = mesh->edgePairs[pairIndex];
        scenery.separation[2 * pairIndex] = 1;
        scenery.separation[2 * pairIndex + 1] = 0.25f;
        const std::vector<SideTexel> sides = scenery.sides();
        int diagonals = 0;
        for (std::size_t s = 0; s < sides.size(); ++s) {
            const int edge = scenery.topology.sideEdge[s];
            if (edge < 0) {
                ++diagonals;
                QCOMPARE(sides[s], SideTexel());
                continue;
            }
            QCOMPARE(sides[s].base, style(SideStyle::Wire));
            QCOMPARE(sides[s].top, style(edge == pairIndex ? SideStyle::Seam : SideStyle::None));
        }
        QCOMPARE(diagonals, 12);
        // The opacity belongs to the end, from whichever side it is seen.
        for (int which = 0; which < 2; ++which) {
            const SideTexel &texel = sides[3 * pair.triangle[which] + pair.side(which)];
            const bool forwards = pair.corner[0][which] == 3 * pair.triangle[which] + pair.side(which);
            QCOMPARE(texel.opacity[forwards ? 0 : 1], 255);
            QCOMPARE(texel.opacity[forwards ? 1 : 0], 64);
        }
    }

    void linesFollowSteeringAndSelection()
    {
        const MeshPtr mesh = test::quadCube();
        Scenery scenery(mesh, unevenLayout(*mesh));
        std::vector<int> edges;
        for (int e = 0; e < static_cast<int>(mesh->edgePairs.size()); ++e) {
            if (!mesh->edgePairs[e].diagonal)
                edges.push_back(e);
        }
        scenery.seams.states[2 * edges[0]] = PairState::Cut; // half
        scenery.seams.states[2 * edges[1]] = scenery.seams.states[2 * edges[1] + 1] = PairState::Joined;
        scenery.selectedEdges = {edges[2]};
        const auto at = [&](int edge) { return scenery.sides()[scenery.topology.edgeSides[edge][0]]; };
        QCOMPARE(at(edges[0]).top, style(SideStyle::ForcedCut));
        // The map is closed there, and opens.
        QCOMPARE(at(edges[0]).opacity[0] + at(edges[0]).opacity[1], 90);
        scenery.separation[2 * edges[0] + 1] = 1;
        QCOMPARE(at(edges[0]).opacity[0] + at(edges[0]).opacity[1], 255);
        scenery.uv.setConstant(std::numeric_limits<double>::quiet_NaN()); // without a map nothing is closed
        scenery.separation[2 * edges[0] + 1] = 0;
        QCOMPARE(at(edges[0]).opacity[0] + at(edges[0]).opacity[1], 255);
        scenery.uv = soupUv(*mesh, unevenLayout(*mesh));
        QCOMPARE(at(edges[1]).top, style(SideStyle::Joined));
        QCOMPARE(at(edges[1]).opacity[1], 255);
        QCOMPARE(at(edges[2]).top, style(SideStyle::Selected));
        scenery.options.steering = false;
        scenery.options.wireframe = false;
        QCOMPARE(at(edges[0]), SideTexel());
        QCOMPARE(at(edges[2]).top, style(SideStyle::Selected));
    }

    void givenSeamsAreShown()
    {
        const MeshPtr mesh = test::quadCube();
        Scenery scenery(mesh, emptyUv(*mesh));
        std::vector<int> edges;
        for (int e = 0; e < static_cast<int>(mesh->edgePairs.size()); ++e) {
            if (!mesh->edgePairs[e].diagonal)
                edges.push_back(e);
        }
        scenery.givenSeams.assign(mesh->edgePairs.size(), false);
        for (int i : {0, 1, 2})
            scenery.givenSeams[edges[i]] = true;
        scenery.seams.states[2 * edges[1]] = scenery.seams.states[2 * edges[1] + 1] = PairState::Cut;
        scenery.selectedEdges = {edges[2]};
        const auto at = [&](int i, int which) {
            return scenery.sides()[scenery.topology.edgeSides[edges[i]][which]];
        };
        const SideTexel given{style(SideStyle::Wire), {255, 255}, style(SideStyle::Given)};
        QCOMPARE(at(0, 0), given);
        QCOMPARE(at(0, 1), given);
        QCOMPARE(at(1, 0).top, style(SideStyle::ForcedCut));
        QCOMPARE(at(2, 0).top, style(SideStyle::Selected));
        QCOMPARE(at(3, 0).top, style(SideStyle::None));
        scenery.options.steering = false;
        QCOMPARE(at(0, 0).top, style(SideStyle::None));
    }

    void straightEdgesAreDrawnBelowSeams()
    {
        const MeshPtr mesh = test::grid(2);
        Scenery scenery(mesh, emptyUv(*mesh));
        int edge = 0;
        while (mesh->edgePairs[edge].diagonal)
            ++edge;
        scenery.seams.straight[2 * edge] = scenery.seams.straight[2 * edge + 1] = 1;
        scenery.seams.states[2 * edge] = scenery.seams.states[2 * edge + 1] = PairState::Cut;
        const auto at = [&](int which) { return scenery.sides()[scenery.topology.edgeSides[edge][which]]; };
        for (int which : {0, 1}) {
            QCOMPARE(at(which).base, style(SideStyle::Straight));
            QCOMPARE(at(which).top, style(SideStyle::ForcedCut));
        }
        scenery.options.steering = false;
        QVERIFY(at(0).base != style(SideStyle::Straight));
    }

    //! Of a tall stack, the uppermost layers are drawn, what is selected among them.
    void whatLiesBelowManyLayersIsNotDrawn()
    {
        constexpr int squares = 20;
        UvMatrix uv(6 * squares, 2);
        for (int i = 0; i < squares; ++i)
            uv.middleRows(6 * i, 6) << 0, 0, 3, 0, 3, 3, 0, 0, 3, 3, 0, 3;
        std::vector<FaceTexel> texels(2 * squares);
        for (const int t : {0, 1})
            texels[t].marks = FaceTexel::Selected;
        texels[2 * squares - 1].marks = texels[2 * squares - 2].marks = FaceTexel::Hidden;
        markBuried(uv, texels);
        for (int t = 0; t < 2 * squares; ++t) {
            const int square = t / 2;
            const bool drawn = square == 0 || square >= squares - drawnLayers;
            QCOMPARE((texels[t].marks & FaceTexel::Buried) == 0, drawn);
        }
    }

    void mapsThatCoverThemselvesSeldomAreDrawnWhole()
    {
        constexpr int squares = drawnLayers + 4;
        UvMatrix uv(6 * squares, 2);
        for (int i = 0; i < squares; ++i) // beside a small stack there is much room
            uv.middleRows(6 * i, 6) << 0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1;
        uv.bottomRows(6) *= 2;
        std::vector<FaceTexel> texels(2 * squares);
        markBuried(uv, texels);
        QVERIFY(texels == std::vector<FaceTexel>(2 * squares));
    }

    void noSeamsWithoutUvs()
    {
        const MeshPtr mesh = test::grid(2);
        Scenery scenery(mesh, emptyUv(*mesh));
        scenery.separation.assign(mesh->cornerPairCount(), 1);
        int borders = 0;
        for (const SideTexel &texel : scenery.sides()) {
            QCOMPARE(texel.top, 0);
            borders += texel.base == style(SideStyle::Border);
        }
        QCOMPARE(borders, 8);
    }

    void heatMapsAreClampedAndContinuous_data()
    {
        QTest::addColumn<HeatMap>("map");
        QTest::addColumn<bool>("colorBlind");
        QTest::addColumn<double>("low");
        QTest::newRow("signed") << HeatMap::SignedStretch << false << -1.0;
        QTest::newRow("signed, colour-blind") << HeatMap::SignedStretch << true << -1.0;
        QTest::newRow("density") << HeatMap::Density << false << -1.0;
        QTest::newRow("magnitude") << HeatMap::Magnitude << false << 0.0;
        QTest::newRow("magnitude, colour-blind") << HeatMap::Magnitude << true << 0.0;
    }

    void heatMapsAreClampedAndContinuous()
    {
        QFETCH(HeatMap, map);
        QFETCH(bool, colorBlind);
        QFETCH(double, low);
        const double infinity = std::numeric_limits<double>::infinity();
        QCOMPARE(heatColor(map, colorBlind, -infinity), heatColor(map, colorBlind, low));
        QCOMPARE(heatColor(map, colorBlind, infinity), heatColor(map, colorBlind, 1));
        QCOMPARE(heatColor(map, colorBlind, std::nan("")), heatColorOfNothing());
        QRgb before = heatColor(map, colorBlind, low);
        for (double value = low; value <= 1; value += (1 - low) / 400) {
            const QRgb color = heatColor(map, colorBlind, value);
            QVERIFY(std::abs(qRed(color) - qRed(before)) + std::abs(qGreen(color) - qGreen(before)) +
                        std::abs(qBlue(color) - qBlue(before)) <
                    12);
            before = color;
        }
        const QGradientStops stops = heatStops(map, colorBlind);
        QCOMPARE(stops.first().second.rgb(), heatColor(map, colorBlind, low));
        QCOMPARE(stops.last().second.rgb(), heatColor(map, colorBlind, 1));
        QCOMPARE(stops.last().first, 1.0);
    }

    void densitiesAreInTexels()
    {
        const MeshPtr mesh = test::grid(2);
        UvMatrix uv = soupUv(*mesh, test::splitLayout(*mesh)); // as large as the model
        uv.middleRows(0, 6) *= 0.5;                            // face 0
        uv(6, 0) = std::numeric_limits<double>::quiet_NaN();
        const std::vector<float> densities = texelDensities(*mesh, uv, 1000);
        QCOMPARE(densities[0], 500.0f);
        QVERIFY(std::isnan(densities[2]));
        QCOMPARE(densities[3], 1000.0f);
        QCOMPARE(medianDensity(*mesh, densities), 1000.0);
        QVERIFY(std::isnan(medianDensity(*mesh, std::vector<float>(8, std::nanf("")))));
        Scenery scenery(mesh, test::splitLayout(*mesh));
        scenery.options.coloring = Coloring::Density;
        scenery.options.densityClamp = 2;
        scenery.density = densities;
        scenery.rightDensity = 1000;
        const std::vector<FaceTexel> faces = scenery.faces();
        const auto colorOf = [&](int t) { return qRgb(faces[t].red, faces[t].green, faces[t].blue); };
        QCOMPARE(colorOf(0), heatColor(HeatMap::Density, false, -0.5));
        QCOMPARE(colorOf(2), heatColorOfNothing());
        QCOMPARE(colorOf(3), heatColor(HeatMap::Density, false, 0));
    }

    void heatMapsRunThroughWhiteAndFromBlueToRed()
    {
        for (const HeatMap map : {HeatMap::SignedStretch, HeatMap::Density}) {
            const QRgb none = heatColor(map, false, 0);
            QVERIFY(qRed(none) > 235 && qGreen(none) > 235 && qBlue(none) > 235);
            QVERIFY(qRed(heatColor(map, false, -1)) > qBlue(heatColor(map, false, -1)) + 80);
            QVERIFY(qBlue(heatColor(map, false, 1)) > qRed(heatColor(map, false, 1)) + 60);
        }
        QVERIFY(qBlue(heatColor(HeatMap::Magnitude, false, 0)) > 150);
        QVERIFY(qRed(heatColor(HeatMap::Magnitude, false, 1)) > 150);
        // For colour-blind eyes lightness alone tells the values of the magnitude apart.
        int before = -1;
        for (double value = 0; value <= 1.0001; value += 0.05) {
            const int lightness = qGray(heatColor(HeatMap::Magnitude, true, value));
            QVERIFY(lightness > before);
            before = lightness;
        }
    }

    void islandsDiffer()
    {
        for (int i = 0; i < 200; ++i) {
            const QColor a(islandColor(i));
            for (int j = i + 1; j < i + 6; ++j) {
                const QColor b(islandColor(j));
                const int difference = std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
                                       std::abs(a.blue() - b.blue());
                QVERIFY2(difference > 40, qPrintable(QStringLiteral("%1 %2").arg(i).arg(j)));
            }
        }
    }

private:
    static UvMatrix emptyUv(const MeshData &mesh)
    {
        return UvMatrix::Constant(mesh.cornerCount(), 2, std::numeric_limits<double>::quiet_NaN());
    }
};

QTEST_APPLESS_MAIN(TestSoupBuffers)

} // namespace tst_soupbuffers

#include "tst_soupbuffers.moc"
