// Where seams should rather run: along creases, in hidden places, symmetrically; and no chart too small.
#include "model/document/cborvalues.h"
#include "model/io/meshes/meshfile.h"
#include "model/plain/edgeangles.h"
#include "model/samples/samples.h"
#include "solver/base/random.h"
#include "solver/preference/creases.h"
#include "solver/preference/meshsymmetry.h"
#include "solver/preference/openness.h"
#include "solver/preference/seampreference.h"
#include "solver/preference/surfacekind.h"
#include "solver/search/seamsearch.h"
#include "solver/search/seamseeds.h"
#include "solver/search/tutte.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"
#include "support/props.h"

#include <Eigen/Geometry>

#include <QTest>

#include <cmath>
#include <numbers>

namespace tst_preference {

using namespace autocuts;
using namespace autocuts::preference;
using namespace autocuts::search;
using namespace autocuts::unwrap;
using test::MeshPtr;

namespace {

MeshPtr sample(const char *name)
{
    return makeSample(QString::fromLatin1(name)).value().mesh;
}

//! The mesh with its points moved.
MeshPtr moved(const MeshData &mesh, const std::function<Vec3(const Vec3 &)> &move)
{
    PositionMatrix positions = mesh.positions;
    for (Eigen::Index v = 0; v < positions.rows(); ++v)
        positions.row(v) = move(positions.row(v));
    return MeshData::build(positions, mesh.faceStart, mesh.cornerVertex, mesh.faceObject);
}

//! The mesh with cubes of an edge length beside it.
MeshPtr withCubes(const MeshData &mesh, int count, double edge)
{
    test::props::Model model;
    for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v)
        model.points.push_back(mesh.positions.row(v));
    for (int f = 0; f < mesh.faceCount(); ++f)
        model.faces.emplace_back(mesh.cornerVertex.begin() + mesh.faceStart[f],
                                 mesh.cornerVertex.begin() + mesh.faceStart[f + 1]);
    for (int i = 0; i < count; ++i)
        model.add(test::props::box({2 + 2 * i * edge, 0, 0}, Vec3::Constant(edge)));
    return model.mesh();
}

UnwrapResult draft(const MeshPtr &mesh, const SolveSettings &settings, int threads = 2)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    snapshot.settings = settings;
    UnwrapOptions options;
    options.quality = UnwrapQuality::Draft;
    options.pack = false;
    return unwrapMesh(snapshot, options, {nullptr, threads});
}

//! Share of the seam length with both ends on the cube's edges or one mesh edge away from them. The sample's
//! bumps leave the cube's edges where they are: two coordinates there are 1 or -1.
double shareAtCubeEdges(const MeshData &mesh, const CutFlags &cut)
{
    std::vector<bool> near(mesh.vertexCount(), false);
    const auto isOnEdge = [&](int v) {
        int count = 0;
        for (int i = 0; i < 3; ++i)
            count += std::abs(std::abs(mesh.positions(v, i)) - 1) < 1e-9;
        return count >= 2;
    };
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        for (int k = 0; k < 3; ++k) {
            if (isOnEdge(mesh.vertexOfSoup(3 * t + k))) {
                for (int j = 0; j < 3; ++j)
                    near[mesh.vertexOfSoup(3 * t + j)] = true;
            }
        }
    }
    double all = 0, there = 0;
    for (std::size_t e = 0; e < cut.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        all += cut[e] ? pair.length : 0;
        if (cut[e] && near[mesh.vertexOfSoup(pair.corner[0][0])] &&
            near[mesh.vertexOfSoup(pair.corner[1][0])])
            there += pair.length;
    }
    return there / all;
}

double meanOpenness(const MeshData &mesh, const CutFlags &cut)
{
    const std::vector<double> openness = edgeOpenness(mesh, 2);
    double all = 0, sum = 0;
    for (std::size_t e = 0; e < cut.size(); ++e) {
        all += cut[e] ? mesh.edgePairs[e].length : 0;
        sum += cut[e] ? mesh.edgePairs[e].length * openness[e] : 0;
    }
    return sum / all;
}

} // namespace

class TestPreference : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anglesAreThoseOfThePolygons()
    {
        for (const double angle : edgeAngles(*test::quadCube()))
            QVERIFY(angle == 0 || std::abs(angle - std::numbers::pi / 2) < 1e-12);
        // A quad that is bent along its diagonal, beside another one.
        const MeshPtr bent = test::polygonMesh(
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}, {2, 0, 0}, {2, 1, 1}}, {{0, 1, 2, 3}, {1, 4, 5, 2}});
        const std::vector<double> angles = edgeAngles(*bent);
        for (std::size_t e = 0; e < angles.size(); ++e)
            QCOMPARE(angles[e] == 0, bent->edgePairs[e].diagonal);
    }

    void hardSurfacesAreTold_data()
    {
        QTest::addColumn<MeshPtr>("mesh");
        QTest::addColumn<bool>("creased");
        QTest::addColumn<bool>("hard");
        QTest::newRow("bumpycube") << sample("bumpycube") << true << false;
        QTest::newRow("machine") << sample("machine") << true << true;
        QTest::newRow("cube") << test::cube() << true << true;
        QTest::newRow("character") << sample("character") << false << false;
        QTest::newRow("torus") << sample("torus") << false << false;
        QTest::newRow("sphere") << test::sphere(12, 16) << false << false;
        QTest::newRow("one triangle") << test::triangle() << false << false;
        const std::string folder = test::meshFolder();
        if (folder.empty()) {
            QTest::newRow("real meshes") << MeshPtr() << false << false;
            return;
        }
        for (const char *name : {"cow_param_closed", "gargoyle_i_f10000", "girl1", "octopus", "bishop_part"})
            QTest::newRow(name)
                << readMesh(QString::fromStdString(folder + "/organic/" + name + ".obj")).value().mesh
                << false << false;
        QTest::newRow("truck")
            << readMesh(QString::fromStdString(folder + "/irregular/truck.obj")).value().mesh << true << true;
    }
    void hardSurfacesAreTold()
    {
        QFETCH(MeshPtr, mesh);
        QFETCH(bool, creased);
        QFETCH(bool, hard);
        if (!mesh)
            QSKIP(test::noMeshes);
        const SurfaceParts parts = surfaceParts(*mesh);
        QCOMPARE(parts.creasedShare > 0.5, creased);
        QCOMPARE(parts.hardShare > 0.5, hard);
        SolveSettings settings;
        settings.align = CreaseMode::Auto;
        QCOMPARE(decidedForAll(settings, mesh).creases, creased ? CreaseMode::On : CreaseMode::Off);
        QCOMPARE(decidedForAll(settings, mesh).align, hard ? CreaseMode::On : CreaseMode::Off);
        for (const SurfaceKind kind : {SurfaceKind::Organic, SurfaceKind::HardSurface}) {
            settings.surface = kind;
            QCOMPARE(surfaceParts(*mesh, kind).hardShare, kind == SurfaceKind::HardSurface ? 1.0 : 0.0);
            QCOMPARE(creasedParts(settings, *mesh).empty(), kind == SurfaceKind::Organic);
            QCOMPARE(alignedParts(settings, *mesh).empty(), kind == SurfaceKind::Organic);
        }
        settings.creases = settings.align = CreaseMode::Off;
        QVERIFY(creasedParts(settings, *mesh).empty() && alignedParts(settings, *mesh).empty());
    }

    //! A character with a box: only the box has seams along sharp edges, and runs along the axes.
    void partsAreJudgedOneByOne()
    {
        using namespace test::props;
        Model scene = sphere(8, 1);
        scene.add(box({3, 0, 0}, {1, 2, 1}));
        Snapshot snapshot;
        snapshot.mesh = scene.mesh();
        snapshot.settings.align = CreaseMode::Auto;
        const SurfaceParts parts = surfaceParts(*snapshot.mesh);
        QCOMPARE(parts.hard, (std::vector<bool>{false, true}));
        QVERIFY(parts.hardShare > 0.2 && parts.hardShare < 0.8);
        const Snapshot preferred = SeamPreference().applied(snapshot);
        QVERIFY(preferred.aligned);
        QCOMPARE(*preferred.aligned, parts.hard);
        const std::vector<double> angles = edgeAngles(*snapshot.mesh);
        for (std::size_t e = 0; e < angles.size(); ++e) {
            const EdgePair &pair = snapshot.mesh->edgePairs[e];
            const bool isOnBox = snapshot.mesh->component[pair.triangle[0]] == 1;
            if (!pair.diagonal)
                QCOMPARE(preferred.edgeWeight(e) < 0.5, isOnBox && angles[e] > 1);
        }
        snapshot.settings.surface = SurfaceKind::Organic;
        const Snapshot organic = SeamPreference().applied(snapshot);
        QVERIFY(!organic.aligned && !organic.rigid);
        QVERIFY(organic.steering == snapshot.steering);
    }

    void weightsMultiplyIntoThePaintedOnes()
    {
        Snapshot snapshot;
        snapshot.mesh = sample("bumpycube");
        snapshot.editSteering().pairWeight.assign(snapshot.mesh->cornerPairCount(), 3.0);
        SeamPreference preference;
        const std::vector<double> angles = edgeAngles(*snapshot.mesh);
        const Snapshot weighted = preference.applied(snapshot);
        for (std::size_t e = 0; e < angles.size(); ++e) {
            const double expected = angles[e] > 1.2 ? 3 * 0.2 : 3;
            if (angles[e] > 1.2 || angles[e] < 0.3)
                QVERIFY(std::abs(weighted.edgeWeight(e) - expected) < 1e-12);
        }
        snapshot.settings.creases = CreaseMode::Off;
        QVERIFY(preference.applied(snapshot).steering == snapshot.steering);
        snapshot.settings.creases = CreaseMode::On;
        snapshot.settings.creaseStrength = 0;
        QVERIFY(preference.applied(snapshot).steering == snapshot.steering);
    }

    //! Only inside of flat faces: not at their borders, nor on a side that unrolls, nor where faces are free.
    void tearingAFlatFaceCostsMore()
    {
        test::props::Model model;
        model.add(test::props::column(32, 1, 1, 3, 4));
        const int side = static_cast<int>(model.faces.size());
        for (int x = 0; x <= 3; ++x) {
            for (int y = 0; y <= 3; ++y)
                model.points.emplace_back(5 + x, y, 0);
        }
        const int first = static_cast<int>(model.points.size()) - 16;
        for (int x = 0; x < 3; ++x) {
            for (int y = 0; y < 3; ++y) {
                const int low = first + 4 * x + y;
                model.faces.push_back({low, low + 4, low + 5, low + 1});
            }
        }
        Snapshot snapshot;
        snapshot.mesh = model.mesh();
        snapshot.settings.creases = CreaseMode::Off;
        const Snapshot preferred = SeamPreference().applied(snapshot);
        QVERIFY(preferred.rigid);
        int torn = 0;
        for (std::size_t e = 0; e < snapshot.mesh->edgePairs.size(); ++e) {
            const EdgePair &pair = snapshot.mesh->edgePairs[e];
            const bool inSheet = snapshot.mesh->triangleFace[pair.triangle[0]] >= side && !pair.diagonal;
            torn += inSheet;
            if (inSheet)
                QCOMPARE(preferred.edgeWeight(e), 1.5);
            else if (!pair.diagonal && std::abs(edgeAngles(*snapshot.mesh)[e]) > 0.1)
                QCOMPARE(preferred.edgeWeight(e), 1.0);
        }
        QCOMPARE(torn, 12);
        snapshot.settings.flat = FlatMode::Free;
        QVERIFY(SeamPreference().applied(snapshot).steering->pairWeight.empty());
    }

    void cutsFollowTheCubesEdges()
    {
        const MeshPtr mesh = sample("bumpycube");
        SolveSettings settings;
        const UnwrapResult with = draft(mesh, settings);
        QVERIFY(with.distortion <= 4.1);
        QVERIFY(shareAtCubeEdges(*mesh, with.cut) >= 0.9);
        settings.creases = CreaseMode::Off;
        QVERIFY(shareAtCubeEdges(*mesh, draft(mesh, settings).cut) < 0.9);
    }

    void opennessIsWhatIsSeen()
    {
        // A floor and a wall: from their common edge a quarter of space is seen.
        const MeshPtr corner = test::polygonMesh(
            {{0, 0, 0}, {0, 1, 0}, {9, 0, 0}, {9, 1, 0}, {0, 0, 9}, {0, 1, 9}}, {{0, 2, 3, 1}, {0, 1, 5, 4}});
        const std::vector<double> openness = vertexOpenness(*corner);
        QVERIFY(std::abs(openness[0] - std::sqrt(0.5)) < 0.3); // half of the rays fly past the ends
        QVERIFY(openness[2] > 0.9);
        for (const double open : vertexOpenness(*test::grid(6)))
            QCOMPARE(open, 1.0);
        for (const double open : vertexOpenness(*test::cube()))
            QCOMPARE(open, 1.0);
        const MeshPtr character = sample("character");
        const std::vector<double> one = vertexOpenness(*character, 1);
        QVERIFY(one == vertexOpenness(*character, 3));
        QVERIFY(*std::min_element(one.begin(), one.end()) < 0.5);
        QVERIFY(*std::max_element(one.begin(), one.end()) > 0.95);
    }

    void seamsGoWhereTheyAreHidden()
    {
        const MeshPtr mesh = sample("character");
        SolveSettings settings;
        const UnwrapResult open = draft(mesh, settings);
        settings.visibility = 1;
        const UnwrapResult hidden = draft(mesh, settings);
        QVERIFY(hidden.distortion <= 4.1);
        QVERIFY(meanOpenness(*mesh, hidden.cut) < meanOpenness(*mesh, open.cut) - 0.05);
    }

    void symmetryIsFound_data()
    {
        QTest::addColumn<MeshPtr>("mesh");
        QTest::addColumn<Vec3>("normal"); // zero: not symmetric
        const MeshPtr character = sample("character");
        const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, -1).normalized());
        QTest::newRow("character") << character << Vec3(1, 0, 0);
        QTest::newRow("turned") << moved(*character, [&](const Vec3 &p) { return Vec3(turn * p); })
                                << Vec3(turn * Vec3(1, 0, 0));
        QTest::newRow("far away") << moved(*character, [&](const Vec3 &p) {
            return Vec3(p + Vec3(1e4, 3, 7));
        }) << Vec3(1, 0, 0);
        QTest::newRow("sheared") << moved(*character, [](const Vec3 &p) {
            return Vec3(p.x() + 0.3 * p.y() + 0.2 * p.z() * p.z(), p.y(), p.z() + 0.1 * p.x());
        }) << Vec3(0, 0, 0);
        QTest::newRow("one triangle") << test::triangle() << Vec3(0, 0, 0);
    }
    void symmetryIsFound()
    {
        QFETCH(MeshPtr, mesh);
        QFETCH(Vec3, normal);
        const std::optional<MeshSymmetry> found = findSymmetry(*mesh);
        QCOMPARE(found.has_value(), normal.norm() > 0.5);
        if (!found)
            return;
        QVERIFY(std::abs(found->normal.dot(normal)) > 1 - 1e-6);
        for (std::size_t e = 0; e < found->mirrorEdge.size(); ++e) {
            const int other = found->mirrorEdge[e];
            QVERIFY(other < 0 || found->mirrorEdge[other] == static_cast<int>(e));
            QVERIFY(other < 0 || std::abs(mesh->edgePairs[e].length - mesh->edgePairs[other].length) < 1e-3);
        }
    }

    //! Sculpts are never exact, and a part of this one has no mirror image.
    void nearlySymmetricIsFound()
    {
        const MeshPtr mesh = sample("character");
        const auto sculpted = [](const Vec3 &p) {
            const double noise = 0.004 * std::sin(91 * p.y() + 57 * p.z() + 31 * p.x());
            const bool pulled = p.x() > 0 && p.y() > 1.75;
            return Vec3(p.x() + noise, p.y() + noise, p.z() + (pulled ? 0.2 : 0.0));
        };
        const MeshPtr nearly = moved(*mesh, sculpted);
        QVERIFY(!findSymmetry(*nearly, Exactness::Exact));
        const std::optional<MeshSymmetry> found = findSymmetry(*nearly);
        QVERIFY(found.has_value());
        QVERIFY(std::abs(found->normal.x()) > 0.99);
        QVERIFY(found->matchedArea > 0.75 && found->matchedArea < 0.999);
        QCOMPARE(findSymmetry(*mesh)->matchedArea, 1.0);
        const std::atomic<bool> stop = true;
        QVERIFY(!findSymmetry(*mesh, Exactness::Loose, JobContext(&stop)));
        // The images are the vertices nearest to the mirrored ones, of all.
        const MeshData &m = *nearly;
        const auto mirrored = [&](int v) {
            const Vec3 p = m.positions.row(v);
            return Vec3(p - 2 * found->normal.dot(p - found->point) * found->normal);
        };
        for (int v = 0; v < m.vertexCount(); ++v) {
            const int image = found->mirrorVertex[v];
            const double least =
                (m.positions.rowwise() - mirrored(v).transpose()).rowwise().norm().minCoeff();
            QVERIFY(image < 0 || (Vec3(m.positions.row(image)) - mirrored(v)).norm() < least + 1e-9);
        }
        SolveSettings settings;
        settings.symmetry = SymmetryMode::On;
        const UnwrapResult result = draft(nearly, settings);
        QVERIFY(result.symmetry && *result.symmetry > 0);
    }

    //! Where a side has other points, the image of a path has gaps. Pieces of it within a chart would shrink
    //! to points in its embedding, from which no search recovers.
    void imagesOfCutsHangTogether()
    {
        int points = 0;
        const MeshPtr mesh = moved(*sample("character"), [&](const Vec3 &p) {
            const bool pulled = p.x() > 0.01 && ++points % 40 == 0;
            return Vec3(p.x(), p.y(), p.z() + (pulled ? 0.15 : 0.0));
        });
        const std::optional<MeshSymmetry> symmetry = findSymmetry(*mesh);
        QVERIFY(symmetry.has_value());
        QVERIFY2(symmetry->matchedArea < 0.97, qPrintable(QString::number(symmetry->matchedArea)));
        Snapshot snapshot;
        snapshot.mesh = mesh;
        const auto soup = Soup::build(mesh);
        const auto graph = SeamGraph::build(soup, snapshot, &*symmetry);
        for (std::uint64_t seed = 0; seed < 6; ++seed) {
            SeedOptions options;
            options.seed = seed;
            const std::vector<char> cut = fewCuts(*graph, options);
            const CutMesh charts(*mesh, {cut.begin(), cut.end()});
            QCOMPARE(std::ssize(charts.boundaryLoops()), std::ptrdiff_t(charts.chartCount));
        }
    }

    //! What is said of the cuts is so.
    void freeCutsAreSaid_data()
    {
        QTest::addColumn<MeshPtr>("mesh");
        QTest::addColumn<double>("bound");
        QTest::newRow("met") << sample("character") << 4.1;
        QTest::newRow("missed") << test::sphere(8, 10) << 4.00001;
    }
    void freeCutsAreSaid()
    {
        QFETCH(const MeshPtr, mesh);
        QFETCH(const double, bound);
        Snapshot snapshot;
        snapshot.mesh = mesh;
        snapshot.settings.symmetry = SymmetryMode::On;
        UnwrapOptions options;
        options.quality = UnwrapQuality::Draft;
        options.maxDistortion = bound;
        options.pack = false;
        const UnwrapResult result = unwrapMesh(snapshot, options, {nullptr, 2});
        QCOMPARE(*result.symmetry < 0.95, result.symmetryMissed);
    }

    //! Triangles that are split the other way on the other side.
    void otherDiagonalsAreSymmetric()
    {
        const MeshPtr quads = test::quadCube();
        std::vector<std::vector<int>> faces;
        std::vector<Vec3> points;
        for (int v = 0; v < quads->vertexCount(); ++v)
            points.push_back(quads->positions.row(v));
        for (int f = 0; f < quads->faceCount(); ++f) {
            const int *c = &quads->cornerVertex[static_cast<std::size_t>(quads->faceStart[f])];
            faces.push_back({c[0], c[1], c[2]});
            faces.push_back({c[0], c[2], c[3]});
        }
        const std::optional<MeshSymmetry> found = findSymmetry(*test::polygonMesh(points, faces));
        QVERIFY(found.has_value());
        QCOMPARE(found->matchedArea, 1.0);
    }

    void cutsAreSymmetric()
    {
        const MeshPtr mesh = sample("character");
        SolveSettings settings;
        settings.symmetry = SymmetryMode::On;
        const UnwrapResult result = draft(mesh, settings);
        QVERIFY(result.distortion <= 4.1);
        QVERIFY(result.symmetry && *result.symmetry > 0.99);
        QCOMPARE(*result.symmetry, symmetricShare(*mesh, *findSymmetry(*mesh), result.cut));
        QVERIFY(draft(mesh, settings, 1).uv == result.uv);
        settings.symmetry = SymmetryMode::Off;
        const UnwrapResult other = draft(mesh, settings);
        QVERIFY(!other.symmetry);
        QVERIFY(symmetricShare(*mesh, *findSymmetry(*mesh), other.cut) < 0.9);
    }

    void flatRegionsOfRoughSurfacesAreAccidents()
    {
        Random random(3);
        const auto noisy = [&](double noise) {
            return moved(*test::sphere(60, 80),
                         [&](const Vec3 &p) { return p * (1 + noise * random.uniform()); });
        };
        const MeshPtr rough = noisy(0.04), smooth = noisy(0);
        QVERIFY(isRough(*rough, edgeAngles(*rough)));
        QVERIFY(!isRough(*smooth, edgeAngles(*smooth)));
        const MeshPtr few = test::sphere(12, 16); // has larger angles, because its triangles are few
        QVERIFY(!isRough(*few, edgeAngles(*few)));
        // Small cubes beside: of a smooth model they are parts, of a rough one debris.
        for (const MeshPtr &mesh : {rough, smooth}) {
            Snapshot snapshot;
            snapshot.mesh = withCubes(*mesh, 5, 0.1);
            QCOMPARE(SeamPreference().applied(snapshot).rigid == nullptr, mesh == rough);
            QCOMPARE(decidedForAll({}, snapshot.mesh).flat, mesh == rough ? FlatMode::Free : FlatMode::Rigid);
        }
        Snapshot cubes;
        cubes.mesh = withCubes(*rough, 50, 1);
        QVERIFY(SeamPreference().applied(cubes).rigid != nullptr);
    }

    void whatIsNotSymmetricIsSaid()
    {
        const MeshPtr sheared = moved(*test::sphere(10, 12), [](const Vec3 &p) {
            return Vec3(p.x() + 0.4 * p.y() * p.z(), p.y() + 0.2 * p.x() * p.x(), p.z() * (1 + 0.3 * p.z()));
        });
        SolveSettings settings;
        settings.symmetry = SymmetryMode::On;
        QCOMPARE(draft(sheared, settings).symmetry, std::optional(0.0));
    }

    void smallChartsAreAbsorbed()
    {
        Snapshot snapshot;
        snapshot.mesh = test::sphere(30, 40);
        const auto soup = Soup::build(snapshot.mesh);
        const auto graph = SeamGraph::build(soup, snapshot);
        SeamedMap map;
        SeedOptions seed;
        seed.paths = 4;
        const std::vector<char> cut = fewCuts(*graph, seed);
        map.cut.assign(cut.begin(), cut.end());
        for (const int t : {100, 900, 2000}) {
            for (int k = 0; k < 3; ++k)
                map.cut[graph->edgeOf[3 * t + k]] = true;
        }
        map.x = tutteEmbedding(*soup, CutMesh(*snapshot.mesh, map.cut));
        QCOMPARE(map.validate(*soup), std::string());
        CutState state = CutState::from(graph, map);
        SeamSearch search(state, 1, {});
        search.relaxAll(30);
        const int before = state.smallParts;
        QVERIFY(before >= 3);
        search.absorbSmallCharts();
        QCOMPARE(state.smallParts, 0);
        QCOMPARE(state.map().validate(*soup), std::string());
        QVERIFY(state.loopsAreInOrder() && !state.boundariesOverlap());
    }

    void settingsAreSaved()
    {
        SolveSettings settings;
        settings.creases = CreaseMode::On;
        settings.creaseStrength = 0.25;
        settings.visibility = 0.5;
        settings.symmetry = SymmetryMode::On;
        settings.maxDistortion = 4.3;
        settings.align = CreaseMode::On;
        settings.mirrorMaps = true;
        settings.worldUp = WorldUp::Z;
        settings.flat = FlatMode::Free;
        CborReader reader(toCbor(settings));
        QVERIFY(readSolveSettings(reader) == settings);
        QVERIFY(!reader.failed());
        for (const char *name : {"creaseStrength", "visibility", "maxDistortion", "align", "mirrorMaps",
                                 "worldUp", "flat", "symmetricSeams"}) {
            QCborMap map = toCbor(settings);
            map[QLatin1StringView(name)] = 1.5;
            CborReader bad(map);
            readSolveSettings(bad);
            QVERIFY(bad.failed());
        }
        // Sessions of before know nothing of it.
        CborReader old(QCborMap{});
        QVERIFY(readSolveSettings(old) == SolveSettings());
    }
};

QTEST_GUILESS_MAIN(TestPreference)

} // namespace tst_preference

#include "tst_preference.moc"
