// The commands of the command line in this process: what they write, report and refuse.
#include "model/io/meshes/meshfile.h"
#include "solver/metrics/uvmetrics.h"
#include "support/cliruns.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include <cmath>

namespace tst_cli {

using namespace autocuts;
using namespace autocuts::metrics;

namespace {

QJsonObject jsonOf(const QByteArray &text)
{
    return QJsonDocument::fromJson(text).object();
}

UvMetrics measured(const QString &path)
{
    const Result<Scene> scene = readMesh(path);
    if (!scene || !scene.value().hasUv())
        return {};
    return measureUv(*scene.value().mesh, scene.value().uvSets.front().uv);
}

//! Lines that are neither vt nor f.
QByteArrayList otherLines(const QByteArray &obj)
{
    QByteArrayList lines;
    QByteArray text = obj;
    text.replace("\\\n", "");
    for (const QByteArray &line : text.split('\n')) {
        if (!line.startsWith("vt ") && !line.startsWith("f "))
            lines << line;
    }
    return lines;
}

bool near(double a, double b)
{
    return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b)) + 1e-12;
}

//! Two unit squares of quads on one place in the UVs, one square outside of the unit square, and a face
//! without UVs.
const char *const messyObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                             "v 2 0 0\nv 3 0 0\nv 3 1 0\nv 2 1 0\n"
                             "v 4 0 0\nv 5 0 0\nv 5 1 0\nv 4 1 0\n"
                             "v 6 0 0\nv 7 0 0\nv 7 1 0\n"
                             "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                             "vt -5 7\nvt -3 7\nvt -3 9\nvt -5 9\n"
                             "f 1/1 2/2 3/3 4/4\nf 5/1 6/2 7/3 8/4\nf 9/5 10/6 11/7 12/8\nf 13 14 15\n";

//! A strip of four quads that lies folded on itself in the UVs: the last quad on the first.
const char *const foldedObj =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 4 0 0\n"
    "v 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\nv 4 1 0\n"
    "vt 0 0\nvt .3 0\nvt .3 .3\nvt 0 .3\nvt .6 0\nvt .6 .3\nvt .2 .1\nvt .2 .2\n"
    "vt .1 .05\nvt .1 .25\n"
    "f 1/1 2/2 7/3 6/4\nf 2/2 3/5 8/6 7/3\nf 3/5 4/7 9/8 8/6\nf 4/7 5/9 10/10 9/8\n";

} // namespace

class TestCli : public QObject, private test::OwnFolder
{
    Q_OBJECT

private:
    static test::CliRun draft(const QString &in, const QString &out, const QStringList &more = {})
    {
        return test::runInProcess(QStringList{QStringLiteral("unwrap"), in, QStringLiteral("-o"), out,
                                              QStringLiteral("--quality=draft"),
                                              QStringLiteral("--pack-time=0.05")} +
                                  more);
    }
    static test::CliRun run(const char *command, const QString &in, const QString &out,
                            const QStringList &more = {})
    {
        return test::runInProcess(QStringList{QString::fromLatin1(command), in, QStringLiteral("-o"), out} +
                                  more);
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(mFolder.isValid()); }

    void unwrapChangesUvsOnly()
    {
        const QString in = file("cube.obj", test::quadCubeObj()), out = at("cube_uv.obj");
        const test::CliRun r = draft(in, out);
        QCOMPARE(r.code, 0);
        QCOMPARE(r.err, QString());
        QVERIFY(r.out.contains(QLatin1String("sym_dirichlet")));
        QVERIFY(r.out.contains(QLatin1String("no problems found")));
        QCOMPARE(otherLines(test::readBytes(out)), otherLines(test::quadCubeObj()));
        const UvMetrics m = measured(out);
        QCOMPARE(m.facesWithoutUv, 0);
        QCOMPARE(m.flipped, 0);
        QCOMPARE(m.overlapPairs, std::int64_t(0));
        QVERIFY(m.inUnitSquare);
        QVERIFY(m.symDirichlet <= 4.1);
        QVERIFY(m.charts == 1 || m.minGutterTexels >= 8 * (1 - 1e-6));
    }

    //! glTF has numbers for UV sets; what we write keeps their names.
    void aSetOfAGltfFileIsFoundByItsName()
    {
        Scene scene = readMesh(file("two.obj", QByteArray(foldedObj))).value();
        const UvMatrix uv = scene.uvSets.front().uv;
        scene.uvSets.push_back({QStringLiteral("Lightmap"), 0.5 * uv});
        for (const char *format : {"glb", "gltf"}) {
            const QString in = at("two.") + QLatin1String(format),
                          out = at("packed.") + QLatin1String(format);
            QVERIFY(writeMesh(scene, in).ok());
            const test::CliRun r =
                run("separate", in, out, {QStringLiteral("--uv-set"), QStringLiteral("Lightmap")});
            QVERIFY2(r.code == 0, qPrintable(r.err));
            const Scene before = readMesh(in).value(), after = readMesh(out).value();
            QCOMPARE(after.uvSets.size(), std::size_t(2));
            QCOMPARE(after.uvSets[0].uv, before.uvSets[0].uv);
            QCOMPARE(after.uvSets[1].name, QStringLiteral("Lightmap"));
            QCOMPARE_NE(after.uvSets[1].uv, before.uvSets[1].uv);
        }
        QCOMPARE(run("separate", at("two.glb"), at("packed.glb"), {QStringLiteral("--uv-set=Dirt")}).code, 1);
    }

    void sameCommandSameBytes()
    {
        const QString in = file("sheet.obj", test::sheetObj(6));
        QByteArray obj, png, svg;
        for (int i = 0; i < 2; ++i) {
            const QString threads = QStringLiteral("--threads=%1").arg(1 + 2 * i);
            QCOMPARE(draft(in, at("a.obj"), {QStringLiteral("--layout"), at("a.png"), threads}).code, 0);
            QCOMPARE(draft(in, at("a.obj"), {QStringLiteral("--layout"), at("a.svg"), threads}).code, 0);
            const QByteArray files[] = {test::readBytes(at("a.obj")), test::readBytes(at("a.png")),
                                        test::readBytes(at("a.svg"))};
            QVERIFY(files[1].startsWith("\x89PNG") && files[2].contains("<svg"));
            QVERIFY(i == 0 || (files[0] == obj && files[1] == png && files[2] == svg));
            obj = files[0], png = files[1], svg = files[2];
        }
    }

    void reportSaysWhatTheFileHolds_data()
    {
        QTest::addColumn<QByteArray>("obj");
        QTest::newRow("cube") << test::quadCubeObj();
        QTest::newRow("sheet") << test::sheetObj(6);
    }
    void reportSaysWhatTheFileHolds()
    {
        QFETCH(QByteArray, obj);
        const QString in = file("r.obj", obj), out = at("r_uv.obj"), json = at("r.json");
        QCOMPARE(draft(in, out, {QStringLiteral("--report"), json, QStringLiteral("--quiet")}).code, 0);
        const QJsonObject report = jsonOf(test::readBytes(json));
        for (const char *key :
             {"triangles", "charts", "seam_length", "seam_norm", "sym_dirichlet", "sym_dirichlet_max",
              "flipped", "overlap_pairs", "overlap_area_ratio", "packing_efficiency", "min_gutter_texels",
              "seconds", "iterations", "lambda", "delta", "status"})
            QVERIFY2(report.contains(QLatin1String(key)), key);
        QCOMPARE(report.value(QLatin1String("status")).toString(), QStringLiteral("done"));
        QCOMPARE(report.value(QLatin1String("texture_size")).toInt(), 2048);
        const UvMetrics m = measured(out);
        const std::pair<const char *, double> figures[] = {{"triangles", m.triangles},
                                                           {"charts", m.charts},
                                                           {"seam_length", m.seamLength},
                                                           {"seam_norm", m.seamNorm},
                                                           {"sym_dirichlet", m.symDirichlet},
                                                           {"sym_dirichlet_max", m.symDirichletMax},
                                                           {"flipped", m.flipped},
                                                           {"overlap_pairs", double(m.overlapPairs)},
                                                           {"overlap_area_ratio", m.overlapAreaRatio},
                                                           {"packing_efficiency", m.packingUnit},
                                                           {"l2_stretch", m.l2Stretch},
                                                           {"angle_distortion", m.angleDistortion}};
        for (const auto &[key, value] : figures) {
            const double said = report.value(QLatin1String(key)).toDouble(NAN);
            QVERIFY2(near(said, value),
                     qPrintable(QStringLiteral("%1: %2, %3").arg(QLatin1String(key)).arg(said).arg(value)));
        }
        if (m.charts > 1)
            QVERIFY(near(report.value(QLatin1String("min_gutter_texels")).toDouble(), m.minGutterTexels));
        compareWithJudge(report, out);
    }

    void everyUnwrapOptionRuns_data()
    {
        QTest::addColumn<QStringList>("options");
        for (const char *line :
             {"--init tutte", "--init random --seed 5", "--weights count", "--energy amips", "--solver exact",
              "--lambda 0.3", "--no-pack", "--allow-overlaps", "--rotation none",
              "--rotation 90 --margin 20 --texture-size 512",
              "--time-limit 0.001 --lambda 0.2 --quality best"})
            QTest::newRow(line) << QString::fromLatin1(line).split(QLatin1Char(' '));
    }
    void everyUnwrapOptionRuns()
    {
        QFETCH(QStringList, options);
        const QString in = file("o.obj", test::sheetObj(4)), out = at("o_uv.obj");
        const test::CliRun r = draft(in, out, options);
        QVERIFY2(r.code == 0, qPrintable(r.err));
        const UvMetrics m = measured(out);
        QCOMPARE(m.facesWithoutUv, 0);
        QCOMPARE(m.flipped, 0);
        QVERIFY(m.inUnitSquare);
        QCOMPARE(r.out.contains(QLatin1String("time_limit")),
                 options.contains(QLatin1String("--time-limit")));
    }

    void existingUvsAreAStart()
    {
        const QString in = file("e.obj", test::sheetObj(4));
        const test::CliRun none = draft(in, at("e1.obj"), {QStringLiteral("--init=uv")});
        QCOMPARE(none.code, 1);
        QVERIFY2(none.err.contains(QLatin1String("no UVs to start from")), qPrintable(none.err));
        QCOMPARE(draft(in, at("e1.obj")).code, 0);
        QCOMPARE(draft(at("e1.obj"), at("e2.obj"), {QStringLiteral("--init=uv")}).code, 0);
        QCOMPARE(measured(at("e2.obj")).flipped, 0);
    }

    void packWorksOnAnyUvs()
    {
        const QString in = file("messy.obj", messyObj), out = at("messy_packed.obj");
        const test::CliRun r = run("pack", in, out, {QStringLiteral("--pack-time=0.05")});
        QVERIFY2(r.code == 0, qPrintable(r.err));
        QVERIFY(r.out.contains(QLatin1String("problem: 1 face has no UVs")));
        const UvMetrics before = measured(in), m = measured(out);
        QVERIFY(!before.inUnitSquare);
        QCOMPARE(before.overlapPairs, std::int64_t(2)); // two squares of two triangles on one place
        QVERIFY(m.inUnitSquare);
        QCOMPARE(m.overlapPairs, std::int64_t(0));
        QCOMPARE(m.charts, 3);
        QCOMPARE(m.facesWithoutUv, 1);
        QVERIFY(m.minGutterTexels >= 8 * (1 - 1e-6));
        QVERIFY(near(m.texelDensitySpread, 1));
        QCOMPARE(otherLines(test::readBytes(out)), otherLines(messyObj));
    }

    void keepingTheScaleKeepsIt()
    {
        const QString in = file("sheet.obj", test::sheetObj(4));
        QCOMPARE(draft(in, at("k.obj")).code, 0);
        const QStringList keep{QStringLiteral("--keep-scale"), QStringLiteral("--margin=1")};
        QCOMPARE(run("pack", at("k.obj"), at("k2.obj"), keep).code, 0);
        QVERIFY(near(measured(at("k2.obj")).uvArea, measured(at("k.obj")).uvArea));
        // Two squares as large as the whole bin.
        const test::CliRun r = run("pack", file("messy.obj", messyObj), at("k3.obj"), keep);
        QCOMPARE(r.code, 1);
        QVERIFY2(r.err.contains(QLatin1String("do not fit")), qPrintable(r.err));
        QVERIFY(!QFileInfo::exists(at("k3.obj")));
    }

    void separateTakesOverlapsApart()
    {
        const QString in = file("folded.obj", foldedObj), out = at("unfolded.obj");
        const test::CliRun r = run("separate", in, out);
        QVERIFY2(r.code == 0, qPrintable(r.err));
        QVERIFY(measured(in).overlapPairsSameChart > 0);
        const UvMetrics m = measured(out);
        QCOMPARE(m.overlapPairs, std::int64_t(0));
        QCOMPARE(m.charts, 2);
        QVERIFY(m.inUnitSquare);
        QVERIFY(m.minGutterTexels >= 8 * (1 - 1e-6));
        // Islands on each other, UVs outside of the square and faces without UVs are no obstacle.
        QCOMPARE(run("separate", file("messy.obj", messyObj), at("messy_apart.obj")).code, 0);
        QCOMPARE(measured(at("messy_apart.obj")).overlapPairs, std::int64_t(0));
    }

    void finishMakesAMapUsable()
    {
        for (const char *name : {"folded", "messy"}) {
            const QByteArray obj = qstrcmp(name, "folded") == 0 ? foldedObj : messyObj;
            const QString in = file(qPrintable(QString::fromLatin1(name) + QLatin1String(".obj")), obj);
            const QString out = at("finished.obj");
            const test::CliRun r = run("finish", in, out, {QStringLiteral("--max-distortion=4.2")});
            QVERIFY2(r.code == 0, qPrintable(r.err));
            QVERIFY(measured(in).overlapPairs > 0);
            const UvMetrics m = measured(out);
            QCOMPARE(m.overlapPairs, std::int64_t(0));
            QCOMPARE(m.flipped, 0);
            QVERIFY(m.inUnitSquare);
            QVERIFY(m.symDirichlet <= 4.2);
        }
        const test::CliRun none =
            run("finish", file("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), at("no.obj"));
        QCOMPARE(none.code, 1);
        QVERIFY2(none.err.contains(QLatin1String("has no UVs")), qPrintable(none.err));
    }

    void separateLeavesGoodMapsAlone()
    {
        QCOMPARE(draft(file("sheet.obj", test::sheetObj(4)), at("s.obj")).code, 0);
        const test::CliRun r = run("separate", at("s.obj"), at("s2.obj"));
        QCOMPARE(r.code, 0);
        QVERIFY2(r.out.contains(QLatin1String("no overlaps")), qPrintable(r.out));
        QCOMPARE(test::readBytes(at("s2.obj")), test::readBytes(at("s.obj")));
    }

    void checkTellsWhatIsWrong()
    {
        const auto check = [](const QString &path, const QStringList &more = {}) {
            return test::runInProcess(QStringList{QStringLiteral("check"), path} + more);
        };
        const test::CliRun messy = check(file("messy.obj", messyObj));
        QCOMPARE(messy.code, 0);
        for (const char *part : {"problem: 1 face has no UVs", "problem: 4 triangles overlap",
                                 "problem: the UVs leave the unit square", "at 2048 x 2048 texels"})
            QVERIFY2(messy.out.contains(QLatin1String(part)), qPrintable(messy.out));
        const test::CliRun folded = check(file("folded.obj", foldedObj));
        QVERIFY2(folded.out.contains(QLatin1String("triangles overlap")), qPrintable(folded.out));
        const test::CliRun bare =
            check(file("cube.obj", test::quadCubeObj()), {QStringLiteral("--texture-size=512")});
        QVERIFY2(bare.out.contains(QLatin1String("problem: the file has no UVs")), qPrintable(bare.out));

        const QJsonObject json = jsonOf(check(at("messy.obj"), {QStringLiteral("--json")}).out.toUtf8());
        QCOMPARE(json.value(QLatin1String("faces_without_uv")).toInt(), 1);
        QCOMPARE(json.value(QLatin1String("in_unit_square")).toBool(true), false);
        QCOMPARE(json.value(QLatin1String("input")).toString(), at("messy.obj"));
    }

    void convertGivesTheSameBytes()
    {
        for (const QByteArray &obj : {test::quadCubeObj(), QByteArray(messyObj), test::sheetObj(3)}) {
            const QString in = file("c.obj", obj);
            const test::CliRun r = run("convert", in, at("c2.obj"));
            QCOMPARE(r.code, 0);
            QCOMPARE(r.out + r.err, QString());
            QCOMPARE(test::readBytes(at("c2.obj")), obj);
            QCOMPARE(run("convert", in, in).code, 0);
            QCOMPARE(test::readBytes(in), obj);
        }
    }

    void otherFormatsSayWhatIsLost_data()
    {
        QTest::addColumn<QString>("lost");
        QTest::newRow("glb") << QStringLiteral("polygons are split");
        QTest::newRow("ply") << QStringLiteral("single precision");
        QTest::newRow("dae") << QStringLiteral("groups and smoothing groups");
        QTest::newRow("fbx") << QStringLiteral("comments and groups");
    }
    void otherFormatsSayWhatIsLost()
    {
        QFETCH(QString, lost);
        const QString in = file("l.obj", test::quadCubeObj());
        const QString out = at(QByteArray("l.").append(QTest::currentDataTag()).constData());
        const test::CliRun r = draft(in, out);
        QVERIFY2(r.code == 0, qPrintable(r.err));
        QVERIFY2(r.err.contains(lost), qPrintable(r.err));
        const Result<Scene> back = readMesh(out);
        QVERIFY(back.ok() && back.value().hasUv());
    }

    void samplesAreWritten()
    {
        QCOMPARE(run("sample", QStringLiteral("machine"), at("machine.obj")).code, 0);
        QVERIFY(test::readBytes(at("machine.obj")).count("\nf ") > 300);
        const test::CliRun r = run("sample", QStringLiteral("teapot"), at("teapot.obj"));
        QCOMPARE(r.code, 1);
        QVERIFY2(r.err.contains(QLatin1String("machine")), qPrintable(r.err));
        QVERIFY(!QFileInfo::exists(at("teapot.obj")));
    }

    void stoppedCommandsStillWrite_data()
    {
        QTest::addColumn<QByteArray>("obj");
        QTest::newRow("unwrap") << test::sheetObj(6);
        QTest::newRow("pack") << QByteArray(messyObj);
        QTest::newRow("separate") << QByteArray(foldedObj);
    }
    void stoppedCommandsStillWrite()
    {
        QFETCH(QByteArray, obj);
        const QString in = file("t.obj", obj), out = at("t_out.obj");
        const test::CliRun r = run(QTest::currentDataTag(), in, out,
                                   {QStringLiteral("--time-limit=0.001"), QStringLiteral("--pack-time=5")});
        QVERIFY2(r.code == 0, qPrintable(r.err));
        QVERIFY(QFileInfo::exists(out));
        QCOMPARE(measured(out).facesWithoutUv, QByteArrayView(QTest::currentDataTag()) == "pack" ? 1 : 0);
        QVERIFY(measured(out).flipped <= measured(in).flipped);
    }

private:
    //! The neutral judge on the same file, when $AUTOCUTS_UVMETRICS names it.
    static void compareWithJudge(const QJsonObject &report, const QString &path)
    {
        const QString judge = qEnvironmentVariable("AUTOCUTS_UVMETRICS");
        if (judge.isEmpty())
            return;
        const test::CliRun r =
            test::runProgram(judge, {QStringLiteral("--json"), QStringLiteral("--margin"), path});
        QCOMPARE(r.code, 0);
        const QJsonObject figures = jsonOf(r.out.toUtf8());
        for (const char *key :
             {"triangles", "charts", "seam_length", "seam_norm", "sym_dirichlet", "sym_dirichlet_max",
              "sym_dirichlet_p99", "sym_dirichlet_infinite", "sym_dirichlet_scale", "flipped",
              "overlap_pairs", "l2_stretch", "angle_distortion", "area_distortion", "texel_density_spread",
              "packing_bbox"}) {
            const double said = report.value(QLatin1String(key)).toDouble(NAN);
            const double judged = figures.value(QLatin1String(key)).toDouble(NAN);
            QVERIFY2(near(said, judged),
                     qPrintable(
                         QStringLiteral("%1: %2, judged %3").arg(QLatin1String(key)).arg(said).arg(judged)));
        }
        QVERIFY(near(report.value(QLatin1String("packing_efficiency")).toDouble(),
                     figures.value(QLatin1String("packing_unit")).toDouble()));
    }
};

QTEST_GUILESS_MAIN(TestCli)

} // namespace tst_cli

#include "tst_cli.moc"
