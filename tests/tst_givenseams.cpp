// Given seams: what each source finds, what files say about hard edges, and how the document keeps up.
#include "commands/changesettings.h"
#include "commands/edituvsets.h"
#include "commands/setseamstate.h"
#include "commands/setseamweights.h"
#include "commands/setuvs.h"
#include "model/document/givenseams.h"
#include "model/document/makesnapshot.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/obj/objreader.h"
#include "model/plain/edgeangles.h"
#include "model/plain/uvlayout.h"
#include "support/editsupport.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace tst_givenseams {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr GivenSeamOptions nothing{.cuts = false, .map = false};

//! The options with only one source.
GivenSeamOptions only(bool GivenSeamOptions::*source)
{
    GivenSeamOptions options = nothing;
    options.*source = true;
    return options;
}

//! The faces on both sides of the edges, as "0-1 2-3"; the lower first, ascending.
QString sides(const MeshData &mesh, const std::vector<bool> &edges)
{
    QStringList list;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto [low, high] = std::minmax(mesh.triangleFace[mesh.edgePairs[e].triangle[0]],
                                             mesh.triangleFace[mesh.edgePairs[e].triangle[1]]);
        if (edges[e])
            list << u"%1-%2"_s.arg(low).arg(high);
    }
    list.sort();
    return list.join(u' ');
}

//! The edge pair between two faces.
int edgeOf(const MeshData &mesh, int a, int b)
{
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const int p = mesh.triangleFace[mesh.edgePairs[e].triangle[0]],
                  q = mesh.triangleFace[mesh.edgePairs[e].triangle[1]];
        if ((p == a && q == b) || (p == b && q == a))
            return static_cast<int>(e);
    }
    return -1;
}

//! A strip of four quads, bent by 20, 40 and 90 degrees at its edges, with a UV per corner that keeps the
//! first two and the last two quads together.
Scene bentStrip()
{
    std::vector<Vec3> points;
    double x = 0, z = 0, angle = 0;
    for (double bend : {0.0, 20.0, 40.0, 90.0, 0.0}) {
        points.emplace_back(x, 0, z);
        points.emplace_back(x, 1, z);
        angle += bend * std::numbers::pi / 180;
        x += std::cos(angle), z += std::sin(angle);
    }
    Scene scene =
        test::sceneOf(test::polygonMesh(points, {{0, 2, 3, 1}, {2, 4, 5, 3}, {4, 6, 7, 5}, {6, 8, 9, 7}}));
    UvMatrix uv(16, 2);
    for (int f = 0; f < 4; ++f) {
        const double left = f + (f >= 2);
        uv.middleRows(4 * f, 4) << left, 0, left + 1, 0, left + 1, 1, left, 1;
    }
    scene.uvSets.push_back({u"map"_s, uv});
    scene.materialNames = {u"iron"_s, u"wood"_s};
    scene.faceMaterial = {-1, 0, 0, 1};
    scene.hardEdges.assign(scene.mesh->edgePairs.size(), false);
    scene.hardEdges[static_cast<std::size_t>(edgeOf(*scene.mesh, 0, 1))] = true;
    return scene;
}

//! The states in which these edges are cut at one end or joined at one end.
std::vector<PairState> halfCut(const MeshData &mesh, const std::vector<int> &cut,
                               const std::vector<int> &joined = {})
{
    std::vector<PairState> states(mesh.cornerPairCount(), PairState::Free);
    for (int edge : cut)
        states[static_cast<std::size_t>(2 * edge + 1)] = PairState::Cut;
    for (int edge : joined)
        states[static_cast<std::size_t>(2 * edge)] = PairState::Joined;
    return states;
}

//! Four quads in a row, with lines of an OBJ file before each of them.
Scene quadRow(const QStringList &before, bool normals = false)
{
    QByteArray text = "v 0 0 0\nv 0 1 0\n";
    for (int i = 1; i <= 4; ++i)
        text += "v " + QByteArray::number(i) + " 0 0\nv " + QByteArray::number(i) + " 1 0\n";
    for (int i = 0; i < 4; ++i) {
        text += before[i].toLatin1();
        text += "f";
        for (int k : {1, 3, 4, 2}) {
            text += ' ' + QByteArray::number(2 * i + k);
            // The normals of one quad: those of its left side and those of its right side.
            if (normals)
                text += "//" + QByteArray::number(k <= 2 ? -2 : -1);
        }
        text += '\n';
    }
    return parseObj(text, u"row.obj"_s).value();
}

} // namespace

class TestGivenSeams : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anglesOfEdges()
    {
        const Scene scene = bentStrip();
        const std::vector<double> angles = edgeAngles(*scene.mesh);
        const auto degrees = [&](int a, int b) {
            return angles[static_cast<std::size_t>(edgeOf(*scene.mesh, a, b))] * 180 / std::numbers::pi;
        };
        QVERIFY(std::abs(degrees(0, 1) - 20) < 1e-9);
        QVERIFY(std::abs(degrees(1, 2) - 40) < 1e-9);
        QVERIFY(std::abs(degrees(2, 3) - 90) < 1e-9);
        // Diagonals and faces without area are flat.
        for (const char *name : {"quad cube", "dirty"}) {
            const test::MeshPtr mesh = test::meshNamed(QString::fromLatin1(name));
            const std::vector<double> all = edgeAngles(*mesh);
            for (std::size_t e = 0; e < all.size(); ++e)
                QVERIFY(std::isfinite(all[e]) && (all[e] == 0 || !mesh->edgePairs[e].diagonal));
        }
    }

    void everySource_data()
    {
        QTest::addColumn<GivenSeamOptions>("options");
        QTest::addColumn<QString>("expected");
        GivenSeamOptions flat = only(&GivenSeamOptions::sharp), square = flat;
        flat.sharpAngle = 0;
        square.sharpAngle = 90;
        GivenSeamOptions all{true, true, true, true, true, 89};
        QTest::newRow("none") << nothing << u""_s;
        QTest::newRow("cuts") << only(&GivenSeamOptions::cuts) << u"1-2"_s;
        QTest::newRow("map") << only(&GivenSeamOptions::map) << u"1-2"_s;
        QTest::newRow("sharp") << only(&GivenSeamOptions::sharp) << u"1-2 2-3"_s;
        QTest::newRow("sharp at 0") << flat << u"0-1 1-2 2-3"_s;
        QTest::newRow("sharp at 90") << square << u""_s; // more than that is needed
        QTest::newRow("hard") << only(&GivenSeamOptions::hard) << u"0-1"_s;
        QTest::newRow("materials") << only(&GivenSeamOptions::materials) << u"0-1 2-3"_s;
        QTest::newRow("standard") << GivenSeamOptions() << u"1-2"_s;
        QTest::newRow("all") << all << u"0-1 1-2 2-3"_s;
    }
    void everySource()
    {
        QFETCH(GivenSeamOptions, options);
        QFETCH(QString, expected);
        const Scene scene = bentStrip();
        const std::vector<PairState> states = halfCut(*scene.mesh, {edgeOf(*scene.mesh, 1, 2)});
        const std::vector<bool> given = givenSeams(scene, &scene.uvSets[0].uv, states, options);
        QCOMPARE(given.size(), scene.mesh->edgePairs.size());
        QCOMPARE(sides(*scene.mesh, given), expected);
    }

    void withoutDataThereIsNothing()
    {
        Scene scene = bentStrip();
        scene.hardEdges.clear();
        scene.faceMaterial.clear();
        GivenSeamOptions options{true, true, false, true, true, 30};
        const std::vector<bool> none(scene.mesh->edgePairs.size(), false);
        QCOMPARE(givenSeams(scene, nullptr, {}, options), none);
        const UvMatrix empty = emptyLayout(*scene.mesh);
        QCOMPARE(givenSeams(scene, &empty, {}, options), none);
    }

    void seamsOfAMapNeedUvsOnBothSides()
    {
        const Scene scene = bentStrip();
        UvMatrix uv = scene.uvSets[0].uv;
        uv.row(13).setConstant(std::numeric_limits<double>::quiet_NaN()); // of the last quad
        QCOMPARE(sides(*scene.mesh, givenSeams(scene, &uv, {}, only(&GivenSeamOptions::map))), u"1-2"_s);
        uv.row(12).setConstant(std::numeric_limits<double>::quiet_NaN()); // at its border to the third
        QCOMPARE(sides(*scene.mesh, givenSeams(scene, &uv, {}, only(&GivenSeamOptions::map))), u"1-2"_s);
        uv.middleRows(8, 4).col(0).array() -= 1; // stitched to the second quad
        QCOMPARE(sides(*scene.mesh, givenSeams(scene, &uv, {}, only(&GivenSeamOptions::map))), u""_s);
        uv(8, 1) -= 0.5; // apart at one end
        QCOMPARE(sides(*scene.mesh, givenSeams(scene, &uv, {}, only(&GivenSeamOptions::map))), u"1-2"_s);
    }

    void joinsWinButOverCuts()
    {
        const Scene scene = bentStrip();
        const int second = edgeOf(*scene.mesh, 1, 2), third = edgeOf(*scene.mesh, 2, 3);
        const std::vector<PairState> states = halfCut(*scene.mesh, {third}, {second, third});
        GivenSeamOptions options{true, true, true, true, true, 10};
        QCOMPARE(sides(*scene.mesh, givenSeams(scene, &scene.uvSets[0].uv, states, options)), u"0-1 2-3"_s);
    }

    void diagonalsAreNeverGiven()
    {
        // A cube of quads, each with other materials, UVs and hard edges at everything.
        Scene scene = test::sceneOf(test::quadCube());
        const MeshData &mesh = *scene.mesh;
        scene.materialNames = {u"a"_s, u"b"_s, u"c"_s, u"d"_s, u"e"_s, u"f"_s};
        scene.faceMaterial = {0, 1, 2, 3, 4, 5};
        scene.hardEdges.assign(mesh.edgePairs.size(), true);
        UvMatrix uv(mesh.cornerCount(), 2);
        for (int c = 0; c < mesh.cornerCount(); ++c)
            uv.row(c) << c, c * c;
        const std::vector<PairState> states(mesh.cornerPairCount(), PairState::Cut);
        const std::vector<bool> given = givenSeams(scene, &uv, states, {true, true, true, true, true, 0});
        QCOMPARE(std::count(given.begin(), given.end(), true), 12);
        for (std::size_t e = 0; e < given.size(); ++e)
            QCOMPARE(bool(given[e]), !mesh.edgePairs[e].diagonal);
    }

    void smoothingGroups_data()
    {
        QTest::addColumn<QStringList>("before");
        QTest::addColumn<QString>("expected");
        QTest::newRow("nothing said") << QStringList{u""_s, u""_s, u""_s, u""_s} << u""_s;
        QTest::newRow("one group") << QStringList{u"s 1\n"_s, u""_s, u""_s, u""_s} << u""_s;
        QTest::newRow("two groups") << QStringList{u"s 1\n"_s, u""_s, u"s 2\n"_s, u""_s} << u"1-2"_s;
        QTest::newRow("same again") << QStringList{u"s 4\n"_s, u"s 5\n"_s, u"s 4\n"_s, u"s 4\n"_s}
                                    << u"0-1 1-2"_s;
        QTest::newRow("off") << QStringList{u"s 1\n"_s, u""_s, u"s off\n"_s, u""_s} << u"1-2 2-3"_s;
        QTest::newRow("zero") << QStringList{u"s 0\n"_s, u""_s, u"s 3\n"_s, u""_s} << u"0-1 1-2"_s;
        QTest::newRow("all off") << QStringList{u"s off\n"_s, u""_s, u""_s, u""_s} << u"0-1 1-2 2-3"_s;
        QTest::newRow("on") << QStringList{u"s on\n"_s, u""_s, u"s 1 # the same\n"_s, u""_s} << u""_s;
        QTest::newRow("no number") << QStringList{u"s 1\n"_s, u""_s, u"s\n"_s, u"s 1\n"_s} << u"1-2 2-3"_s;
        QTest::newRow("large") << QStringList{u"s 4294967296\n"_s, u"s 4294967297\n"_s, u""_s, u""_s}
                               << u"0-1"_s;
        QTest::newRow("from the middle on") << QStringList{u""_s, u""_s, u"s 1\n"_s, u""_s} << u"1-2"_s;
        QTest::newRow("skipped face")
            << QStringList{u"s 1\n"_s, u"f 1 1 1\ns 2\nf 1 2\n"_s, u"s 1\n"_s, u""_s} << u"0-1 1-2"_s;
        QTest::newRow("across objects")
            << QStringList{u"s 1\no a\n"_s, u""_s, u"o b\n"_s, u"s 2\n"_s} << u"2-3"_s;
    }
    void smoothingGroups()
    {
        QFETCH(QStringList, before);
        QFETCH(QString, expected);
        const Scene scene = quadRow(before);
        QCOMPARE(sides(*scene.mesh, scene.hardEdges), expected);
        QCOMPARE(scene.hardEdges.empty(), !before.join(QString()).contains(u"s "_s));
    }

    void normalsOfObjFiles()
    {
        // Before each quad, the normals of its left and of its right side.
        const Scene scene = quadRow({u"vn 0 0 1\nvn 0 0 2\n"_s,        // of any length
                                     u"vn 0 0.001 1\nvn 0 1 0\n"_s,    // rounded
                                     u"vn 0 0 1\nvn 1 0 0\n"_s,        // another one
                                     u"vn nothing 0 0\nvn 0 0 1\n"_s}, // damaged: nothing is said
                                    true);
        QCOMPARE(sides(*scene.mesh, scene.hardEdges), u"1-2"_s);
        // Where a hard edge ends inside of a smooth surface, the normals agree at that end.
        const Scene oneEnd = parseObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                                      "vn 0 0 1\nvn 0 1 0\n"
                                      "f 1//1 2//1 3//1 4//1\nf 2//1 5//1 6//1 3//2\n",
                                      u"end.obj"_s)
                                 .value();
        QCOMPARE(sides(*oneEnd.mesh, oneEnd.hardEdges), u"0-1"_s);
    }

    void normalsOfOtherFormats()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"row.ply"_s);
        // Three quads in a row: vertices are split, with another normal, between the second and the third.
        QByteArray text = "ply\nformat ascii 1.0\nelement vertex 10\nproperty float x\nproperty float y\n"
                          "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                          "element face 3\nproperty list uchar int vertex_indices\nend_header\n";
        for (const char *column : {"0", "1", "2"})
            text += QByteArray(column) + " 0 0 0 0 1\n" + column + " 1 0 0 0 1\n";
        for (const char *column : {"2", "3"})
            text += QByteArray(column) + " 0 0 1 0 0\n" + column + " 1 0 1 0 0\n";
        text += "4 0 2 3 1\n4 2 4 5 3\n4 6 8 9 7\n";
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        file.close();
        const Result<Scene> scene = readMesh(path);
        QVERIFY2(scene.ok(), scene.ok() ? "" : qPrintable(scene.error().toString()));
        QCOMPARE(sides(*scene->mesh, scene->hardEdges), u"1-2"_s);
    }

    void theDocumentKeepsUp()
    {
        const auto document = std::make_unique<Document>(bentStrip());
        const MeshData &mesh = document->mesh();
        const auto given = [&] { return sides(mesh, document->givenSeams()); };
        const auto set = [&](const std::function<void(SolveSettings &)> &change) {
            SolveSettings settings = document->solveSettings();
            change(settings);
            pushCommand(std::make_unique<ChangeSettings>(*document, settings));
        };
        QVERIFY(document->givenSeams().empty());
        QVERIFY(makeSnapshot(*document).steering->givenSeams.empty());
        set([](SolveSettings &s) { s.seams = SeamMode::Keep; });
        QCOMPARE(given(), u"1-2"_s);
        pushCommand(
            std::make_unique<SetSeamState>(*document, SetSeamState::Edit::Cut,
                                           cornerPairsOfEdges(mesh, std::vector<int>{edgeOf(mesh, 0, 1)})));
        QCOMPARE(given(), u"0-1 1-2"_s);
        QCOMPARE(makeSnapshot(*document).steering->givenSeams, document->givenSeams());
        UvMatrix uv = document->uv();
        uv.bottomRows(8).col(0).array() -= 1; // stitched
        pushCommand(std::make_unique<SetUvs>(*document, UvEdit::Drag, uv));
        QCOMPARE(given(), u"0-1"_s);
        set([](SolveSettings &s) { s.givenSeams.sharp = true; });
        QCOMPARE(given(), u"0-1 1-2 2-3"_s);
        set([](SolveSettings &s) { s.givenSeams.sharpAngle = 45; });
        QCOMPARE(given(), u"0-1 2-3"_s);
        document->undoStack().setIndex(1);
        QCOMPARE(given(), u"1-2"_s);
        pushCommand(std::make_unique<AddUvSet>(*document, u"empty"_s));
        QCOMPARE(given(), u""_s);
        document->undoStack().undo();
        QCOMPARE(given(), u"1-2"_s);
        set([](SolveSettings &s) { s.seams = SeamMode::Free; });
        QVERIFY(document->givenSeams().empty());
    }

    void eventsThatMatter()
    {
        QVERIFY(changesGivenSeams(UvEvent(0, UvEvent::Values, {})));
        QVERIFY(changesGivenSeams(UvSetEvent(UvSetEvent::Change::Activated, 0)));
        QVERIFY(changesGivenSeams(SeamEvent(SeamEvent::State | SeamEvent::Weight, {})));
        QVERIFY(!changesGivenSeams(SeamEvent(SeamEvent::Weight, {})));
        for (int property : {SeamModeProperty, SeamSourcesProperty, SharpAngleProperty})
            QVERIFY(changesGivenSeams(SolveSettingsEvent(property | LambdaProperty)));
        QVERIFY(!changesGivenSeams(SolveSettingsEvent(LambdaProperty | SymmetryProperty)));
        QVERIFY(!changesGivenSeams(PackingSettingsEvent(MarginProperty)));
        QVERIFY(!changesGivenSeams(PinEvent({})));
    }
};

QTEST_GUILESS_MAIN(TestGivenSeams)

} // namespace tst_givenseams

#include "tst_givenseams.moc"
