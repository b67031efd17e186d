// The command line on a part of a model (--only) and with given seams (--seams).
#include "cli/batchscope.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "model/plain/chart.h"
#include "model/plain/udimtiles.h"
#include "support/cliruns.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace tst_cliscope {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Six unit quads in three objects, of two each: "left" and "right" flat, "roof" bent by 90 degrees. The
//! materials are "red" in the first quad of each, and "blue". In the map each object is one island, 0.2 wide,
//! and "roof" lies on "left".
QByteArray partsObj()
{
    QByteArray text;
    int vertex = 0, uv = 0;
    for (const char *name : {"left", "right", "roof"}) {
        const bool roof = QByteArray(name) == "roof";
        const double left = QByteArray(name) == "right" ? 0.6 : 0.1;
        text += "o " + QByteArray(name) + '\n';
        for (int column = 0; column <= 2; ++column) {
            for (int row = 0; row <= 1; ++row) {
                const int x = roof && column == 2 ? 1 : column, z = roof && column == 2 ? 1 : 0;
                text += "v " + QByteArray::number(vertex + x) + ' ' + QByteArray::number(row) + ' ' +
                        QByteArray::number(z) + "\nvt " + QByteArray::number(left + 0.1 * column) + ' ' +
                        QByteArray::number(0.1 + 0.1 * row) + '\n';
            }
        }
        for (int column = 0; column < 2; ++column) {
            text += column == 0 ? "usemtl red\nf" : "usemtl blue\nf";
            for (int k : {1, 3, 4, 2})
                text += ' ' + QByteArray::number(vertex + 2 * column + k) + '/' +
                        QByteArray::number(uv + 2 * column + k);
            text += '\n';
        }
        vertex += 6;
        uv += 6;
    }
    return text;
}

} // namespace

class TestCliScope : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(test::writeBytes(file("parts.obj"), partsObj()));
        mBefore = readMesh(file("parts.obj")).value();
        QCOMPARE(findCharts(*mBefore.mesh, mBefore.uvSets[0].uv).count, 3);
    }

    void packMovesOnlyTheScope_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("moved"); // faces
        QTest::newRow("island") << QStringList{u"--only=islands:2"_s} << u"23"_s;
        QTest::newRow("islands") << QStringList{u"--only=islands:3,1"_s} << u"0145"_s;
        QTest::newRow("object") << QStringList{u"--only=objects:roof"_s} << u"45"_s;
        QTest::newRow("union") << QStringList{u"--only=objects:left"_s, u"--only=islands:2"_s} << u"0123"_s;
        QTest::newRow("objects") << QStringList{u"--only=objects:left,right"_s} << u"0123"_s;
        QTest::newRow("part of islands")
            << QStringList{u"--only=materials:red"_s, u"--only=objects:left"_s} << u"01"_s;
        QTest::newRow("cut off") << QStringList{u"--only=materials:red"_s, u"--border=free"_s} << u"024"_s;
        QTest::newRow("by name") << QStringList{u"--objects=roof"_s, u"--objects=left"_s} << u"0145"_s;
        QTest::newRow("everything") << QStringList{u"--only=materials:red,blue"_s} << u"012345"_s;
        QTest::newRow("beginnings") << QStringList{u"--only=objects:r*"_s} << u"2345"_s;
        QTest::newRow("any letter") << QStringList{u"--only=objects:r?of,?eft"_s} << u"0145"_s;
    }
    void packMovesOnlyTheScope()
    {
        QFETCH(QStringList, options);
        QFETCH(QString, moved);
        const test::CliRun made = run("pack", "packed.obj", options);
        QVERIFY2(made.code == 0, qPrintable(made.err));
        const Scene after = readMesh(file("packed.obj")).value();
        QCOMPARE(movedFaces(after), moved);
    }

    //! Objects that share an edge, and a level of detail in the same place with the same UVs.
    void objectsThatTouchGetTilesOfTheirOwn()
    {
        QVERIFY(test::writeBytes(file("touch.obj"),
                                 "o a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                                 "vt 0 0\nvt .5 0\nvt .5 .5\nvt 0 .5\nvt 1 0\nvt 1 .5\n"
                                 "f 1/1 2/2 3/3 4/4\no b\nf 2/2 5/5 6/6 3/3\n"
                                 "o lod1\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 7/1 8/5 9/6 10/4\n"));
        const test::CliRun made =
            test::runInProcess({u"pack"_s, file("touch.obj"), u"-o"_s, file("touched.obj"), u"--per=object"_s,
                                u"--report"_s, file("touched.json")});
        QVERIFY2(made.code == 0, qPrintable(made.err));
        const Scene after = readMesh(file("touched.obj")).value();
        const UvMatrix &uv = after.uvSets[0].uv;
        const ChartMap charts = findCharts(*after.mesh, uv);
        QCOMPARE(charts.count, 3);
        QCOMPARE(islandTiles(*after.mesh, charts, uv, 1), std::vector<int>({1001, 1002, 1003}));
        const QJsonObject report = QJsonDocument::fromJson(test::readBytes(file("touched.json"))).object();
        QCOMPARE(report.value(u"overlap_pairs"_s).toInt(-1), 0);
    }

    //! Files of other programs may give several objects one name.
    void equalNamesHaveNumbers()
    {
        Scene scene = readMesh(file("parts.obj")).value();
        scene.objectNames = {u"lid"_s, u"lid"_s, u"roof"_s};
        CliOptions options;
        const auto faces = [&](const QString &name) {
            options.only.objects = QStringList{name};
            return batchScope(options, scene).value()->faces;
        };
        QCOMPARE(faces(u"lid"_s), std::vector<bool>({true, true, true, true, false, false}));
        QCOMPARE(faces(u"lid#1"_s), std::vector<bool>({true, true, false, false, false, false}));
        QCOMPARE(faces(u"lid#2"_s), std::vector<bool>({false, false, true, true, false, false}));
        options.only.objects = QStringList{u"lid#3"_s};
        const auto none = batchScope(options, scene);
        QVERIFY(!none);
        QVERIFY2(none.error().remedy.contains(u"lid#1, lid#2, roof"_s), qPrintable(none.error().remedy));
    }

    void eachGetsATile_data()
    {
        QTest::addColumn<QString>("command");
        QTest::addColumn<QString>("per");
        QTest::addColumn<QList<int>>("tiles"); // of the faces
        for (const char *command : {"pack", "unwrap", "finish", "separate"})
            QTest::addRow("%s objects", command) << QString::fromLatin1(command) << u"object"_s
                                                 << QList<int>{1003, 1003, 1004, 1004, 1005, 1005};
        // Unwrapping cuts between the materials; packing leaves each island to the first of two.
        QTest::newRow("unwrap materials")
            << u"unwrap"_s << u"material"_s << QList<int>{1003, 1004, 1003, 1004, 1003, 1004};
        QTest::newRow("pack materials")
            << u"pack"_s << u"material"_s << QList<int>{1003, 1003, 1003, 1003, 1003, 1003};
    }
    void eachGetsATile()
    {
        QFETCH(QString, command);
        QFETCH(QString, per);
        QFETCH(QList<int>, tiles);
        const test::CliRun made = run(command.toLatin1().constData(), "tiles.obj",
                                      {u"--per"_s, per, u"--tile=1003"_s, u"--layout"_s, file("tiles.png")});
        QVERIFY2(made.code == 0, qPrintable(made.err));
        const Scene after = readMesh(file("tiles.obj")).value();
        const std::vector<int> found = udimTiles(*after.mesh, after.uvSets[0].uv, 1);
        QCOMPARE(QList<int>(found.begin(), found.end()), tiles);
        for (int tile = 1003; tile <= 1005; ++tile)
            QCOMPARE(QFile::exists(file(qPrintable(u"tiles.%1.png"_s.arg(tile)))), tiles.contains(tile));
        for (int tile = 1003; tile <= 1005; ++tile)
            QFile::remove(file(qPrintable(u"tiles.%1.png"_s.arg(tile))));
    }

    void aPictureOfAPart()
    {
        const auto picture = [&](const QStringList &options) {
            const test::CliRun made =
                run("pack", "part.obj",
                    QStringList{u"--layout"_s, file("part.svg"), u"--keep-scale"_s} + options);
            QFile svg(file("part.svg"));
            return made.code == 0 && svg.open(QIODevice::ReadOnly) ? svg.readAll().size() : 0;
        };
        const auto one = picture({u"--objects=left"_s}), all = picture({u"--objects=left,right,roof"_s});
        QVERIFY(one > 0 && one < all);
    }

    void checkMeasuresAPart()
    {
        const auto check = [&](const QStringList &options) {
            const test::CliRun made =
                test::runInProcess(QStringList{u"check"_s, file("parts.obj"), u"--json"_s} + options);
            return QJsonDocument::fromJson(made.out.toUtf8()).object();
        };
        const QJsonObject all = check({}), left = check({u"--only=objects:left"_s}),
                          two = check({u"--only=islands:1"_s, u"--materials=red"_s});
        QCOMPARE(all.value(u"faces"_s).toInt(), 6);
        QVERIFY(all.value(u"overlap_pairs"_s).toInt() > 0); // the roof lies on it
        QCOMPARE(left.value(u"faces"_s).toInt(), 2);
        QCOMPARE(left.value(u"charts"_s).toInt(), 1);
        QCOMPARE(left.value(u"overlap_pairs"_s).toInt(-1), 0);
        QCOMPARE(left.value(u"objects"_s).toArray().size(), 1);
        QCOMPARE(left.value(u"materials"_s).toArray().size(), 2);
        QCOMPARE(two.value(u"faces"_s).toInt(), 4);
        QVERIFY(check({u"--only=objects:none"_s}).isEmpty());
    }

    void reportsListObjectsAndMaterials()
    {
        const test::CliRun made = run("pack", "listed.obj", {u"--report"_s, file("listed.json")});
        QVERIFY2(made.code == 0, qPrintable(made.err));
        QFile json(file("listed.json"));
        QVERIFY(json.open(QIODevice::ReadOnly));
        const QJsonObject report = QJsonDocument::fromJson(json.readAll()).object();
        const QJsonArray objects = report.value(u"objects"_s).toArray();
        QCOMPARE(objects.size(), 3);
        const QJsonObject roof = objects[2].toObject();
        QCOMPARE(roof.value(u"name"_s).toString(), u"roof"_s);
        QCOMPARE(roof.value(u"faces"_s).toInt(), 2);
        QCOMPARE(roof.value(u"charts"_s).toInt(), 1);
        QVERIFY(std::abs(roof.value(u"sym_dirichlet"_s).toDouble() - 4) < 1e-6);
        QVERIFY(roof.value(u"texel_density"_s).toDouble() > 0);
        double used = 0;
        for (const QJsonValue &object : objects)
            used += object.toObject().value(u"packing_efficiency"_s).toDouble();
        QVERIFY(std::abs(used - report.value(u"packing_efficiency"_s).toDouble()) < 1e-9);
        const QJsonArray materials = report.value(u"materials"_s).toArray();
        QCOMPARE(materials.size(), 2);
        QCOMPARE(materials[0].toObject().value(u"faces"_s).toInt(), 3);
        QCOMPARE(materials[0].toObject().value(u"charts"_s).toInt(), 3);
    }

    void separateLeavesTheRest()
    {
        // A map that lies on itself, twice: "left" and "right" are folded.
        QByteArray text = partsObj();
        for (const QByteArray &line : {QByteArray("vt 0.3 "), QByteArray("vt 0.8 ")})
            text.replace(line, line.startsWith("vt 0.3") ? "vt 0.15 " : "vt 0.65 ");
        QVERIFY(test::writeBytes(file("folded.obj"), text));
        const Scene folded = readMesh(file("folded.obj")).value();
        const test::CliRun made = test::runInProcess(
            {u"separate"_s, file("folded.obj"), u"-o"_s, file("apart.obj"), u"--only=objects:right"_s});
        QVERIFY2(made.code == 0, qPrintable(made.err));
        QVERIFY2(made.out.contains(u"Edges cut to take overlaps apart: 1\n"_s), qPrintable(made.out));
        const Scene after = readMesh(file("apart.obj")).value();
        for (int c = 0; c < 24; ++c)
            QCOMPARE(sameUv(after, folded, c), c < 8 || c >= 16);
        QCOMPARE(findCharts(*after.mesh, after.uvSets[0].uv).count, 4);
    }

    void mistakesNameWhatExists_data()
    {
        QTest::addColumn<QString>("command");
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *command, const char *only, const char *message) {
            QTest::newRow(only) << QString::fromLatin1(command) << QStringList{QString::fromLatin1(only)}
                                << QString::fromLatin1(message);
        };
        row("pack", "--only=objects:left,tree",
            "there is no object \"tree\". The file has the objects: left, right, roof");
        row("unwrap", "--only=materials:green",
            "there is no material \"green\". The file has the materials: blue, red");
        row("finish", "--only=islands:4", "there is no island 4. The map has the islands 1 to 3");
        row("separate", "--only=materials:blue", "no island lies as a whole in what --only names");
    }
    void mistakesNameWhatExists()
    {
        QFETCH(QString, command);
        QFETCH(QStringList, options);
        QFETCH(QString, message);
        const test::CliRun made = run(command.toLatin1().constData(), "no.obj", options);
        QCOMPARE(made.code, 1);
        QVERIFY2(made.err.contains(message), qPrintable(made.err));
        QCOMPARE(made.err.count(u'\n'), 1);
        QVERIFY(!QFile::exists(file("no.obj")));
    }

    void filesWithoutNamesOrUvs()
    {
        QVERIFY(test::writeBytes(file("sheet.obj"), test::sheetObj(2)));
        const auto fails = [&](const char *only, const char *message) {
            const test::CliRun made = test::runInProcess(
                {u"unwrap"_s, file("sheet.obj"), u"-o"_s, file("no.obj"), QString::fromLatin1(only)});
            QCOMPARE(made.code, 1);
            QVERIFY2(made.err.contains(QString::fromLatin1(message)), qPrintable(made.err));
        };
        fails("--only=objects:a", "there is no object \"a\". The file names no objects");
        fails("--only=materials:a", "there is no material \"a\". The file names no materials");
        fails("--only=islands:1", "the file has no UVs, so there are no islands");
    }

    void givenSeamsAreCounted_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<int>("count");
        const auto row = [](const char *name, const QStringList &from, int count) {
            QTest::newRow(name) << from << count;
        };
        row("standard", {}, 0);
        row("sharp", {u"--seams-from=sharp"_s}, 1);
        row("materials", {u"--seams-from=uv,materials"_s}, 3);
        row("blunt", {u"--seams-from=sharp:91,objects,hard"_s}, 0);
    }
    void givenSeamsAreCounted()
    {
        QFETCH(QStringList, options);
        QFETCH(int, count);
        const test::CliRun made = run("unwrap", "out.acproj", QStringList{u"--seams=keep"_s} + options);
        QVERIFY2(made.code == 0, qPrintable(made.err));
        QVERIFY2(made.out.contains(u"note: given seams: %1\n"_s.arg(count)), qPrintable(made.out));
        QCOMPARE(made.err.contains(u"there are no given seams"_s), count == 0);
        // The session keeps the choice; a job on the session has it, too.
        LoadedProject project = loadProject(file("out.acproj")).value();
        QCOMPARE(project.state.solveSettings.seams, SeamMode::Keep);
        project.state.scene.uvSets[0].uv = mBefore.uvSets[0].uv;
        QVERIFY(saveProject(project.state, {}, file("again.acproj")).ok());
        const test::CliRun again =
            test::runInProcess({u"unwrap"_s, file("again.acproj"), u"-o"_s, file("again.obj"),
                                u"--quality=draft"_s, u"--pack-time=0"_s});
        QVERIFY2(again.out.contains(u"note: given seams: %1\n"_s.arg(count)), qPrintable(again.out));
    }

    //! Two triangles back to back need a seam that is not given. The largest bound is no exception.
    void onlyGivenSeamsWithTheLargestBound()
    {
        QFile obj(file("backs.obj"));
        QVERIFY(obj.open(QIODevice::WriteOnly));
        obj.write("v -.54 .05 .69\nv -.68 .02 -1.21\nv .11 .07 -1.39\nv 1.07 .91 -1.67\nv 1.3 -.37 -.27\n"
                  "v -.91 -.11 -.67\nf 3 1 5\nf 4 3 1\nf 2 4 6\nf 4 3 2\nf 4 2 3\n");
        obj.close();
        for (const char *bound : {"4.1", "1000000"}) {
            const test::CliRun made = test::runInProcess(
                {u"unwrap"_s, obj.fileName(), u"-o"_s, file("flat.obj"), u"--quality=draft"_s,
                 u"--seams=only"_s, u"--max-distortion"_s, QString::fromLatin1(bound)});
            QVERIFY2(made.out.contains(u"no problems found"), qPrintable(made.out));
        }
    }

    void sourcesWithoutAModeAreNoticed()
    {
        const test::CliRun made = run("unwrap", "out.obj", {u"--seams-from=sharp"_s});
        QCOMPARE(made.code, 0);
        QVERIFY2(made.err.contains(u"--seams-from does nothing without"_s), qPrintable(made.err));
        QVERIFY(!made.out.contains(u"given seams"_s));
    }

private:
    QString file(const char *name) const { return mFolder.filePath(QString::fromLatin1(name)); }

    test::CliRun run(const char *command, const char *out, const QStringList &options) const
    {
        QStringList words{QString::fromLatin1(command), file("parts.obj"), u"-o"_s, file(out),
                          u"--pack-time=0.05"_s};
        if (words[0] == u"unwrap")
            words << u"--quality=draft"_s;
        return test::runInProcess(words + options);
    }

    static bool sameUv(const Scene &a, const Scene &b, int corner)
    {
        return a.uvSets[0].uv.row(corner) == b.uvSets[0].uv.row(corner);
    }

    //! The faces whose UVs changed, at each corner.
    QString movedFaces(const Scene &after) const
    {
        QString faces;
        for (int f = 0; f < 6; ++f) {
            int moved = 0;
            for (int c = 4 * f; c < 4 * f + 4; ++c)
                moved += !sameUv(after, mBefore, c);
            faces += moved == 4 ? QString::number(f) : moved > 0 ? u"?"_s : u""_s;
        }
        return faces;
    }

    QTemporaryDir mFolder;
    Scene mBefore;
};

QTEST_GUILESS_MAIN(TestCliScope)

} // namespace tst_cliscope

#include "tst_cliscope.moc"
