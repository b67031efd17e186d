// What the command line says of a map: the text and the JSON count the same, warnings of new maps.
#include "support/cliruns.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace tst_mapreporting {

using namespace autocuts;

namespace {

QJsonObject jsonOf(const QByteArray &text)
{
    return QJsonDocument::fromJson(text).object();
}

} // namespace

class TestMapReporting : public QObject, private test::OwnFolder
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(mFolder.isValid()); }

    void textAndJsonCountTheSame_data()
    {
        QTest::addColumn<QByteArray>("obj");
        QTest::addColumn<int>("flipped");
        QTest::addColumn<int>("overlapping");
        // A U has no corner from which a fan is good.
        const QByteArray points = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n";
        const QByteArray face = "f 1/1 2/2 3/3 4/4 5/5 6/6 7/7 8/8\n";
        QTest::newRow("polygon without a fan")
            << points + "vt 0 0\nvt .3 0\nvt .3 .3\nvt .2 .3\nvt .2 .1\nvt .1 .1\nvt .1 .3\nvt 0 .3\n" + face
            << 0 << 0;
        QTest::newRow("fold") << QByteArray("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                            "f 1/1 2/2 3/3\nf 1/1 3/3 4/2\n")
                              << 1 << 2;
    }

    void textAndJsonCountTheSame()
    {
        QFETCH(QByteArray, obj);
        QFETCH(int, flipped);
        QFETCH(int, overlapping);
        const QString in = file("counts.obj", obj);
        const QString text = test::runInProcess({QStringLiteral("check"), in}).out;
        const QJsonObject json =
            jsonOf(test::runInProcess({QStringLiteral("check"), in, QStringLiteral("--json")}).out.toUtf8());
        QCOMPARE(json.value(QLatin1String("flipped")).toInt(-1), flipped);
        QCOMPARE(json.value(QLatin1String("overlapping_triangles")).toInt(-1), overlapping);
        QCOMPARE(text.contains(QLatin1String("problem: 1 triangle is flipped")), flipped == 1);
        QCOMPARE(text.contains(QLatin1String("problem: 2 triangles overlap")), overlapping == 2);
        QCOMPARE(text.contains(QLatin1String("no problems found")), flipped + overlapping == 0);
    }

    void facesWithoutAreaInTheMapAreSaid()
    {
        // Beside a square, one so small that doubles cannot hold its place in the map.
        const QString in = file("scales.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1e-40 0 1\n"
                                              "v 1e-40 1e-40 1\nv 0 1e-40 1\nf 1 2 3 4\nf 5 6 7 8\n");
        const QString report = at("scales.json");
        const test::CliRun r =
            test::runInProcess({QStringLiteral("unwrap"), in, QStringLiteral("-o"), at("scales_uv.obj"),
                                QStringLiteral("--report"), report, QStringLiteral("--quality=draft")});
        QCOMPARE(r.code, 0);
        QVERIFY2(r.err.contains(QLatin1String("warning: 1 face has no area in the map")), qPrintable(r.err));
        const QJsonObject json = jsonOf(test::readBytes(report));
        QCOMPARE(json.value(QLatin1String("faces_without_uv_area")).toInt(-1), 1);
        QCOMPARE(json.value(QLatin1String("status")).toString(), QStringLiteral("done"));
    }
};

QTEST_GUILESS_MAIN(TestMapReporting)

} // namespace tst_mapreporting

#include "tst_mapreporting.moc"
