// What the benchmark programs understand and print.
#include "bench/benchoptions.h"
#include "bench/benchreport.h"
#include "bench/subdivide.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace tst_bench {

using namespace autocuts;
using namespace autocuts::unwrap;

class TestBench : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void optionsAreUnderstood()
    {
        std::string problem;
        const auto options =
            bench::readOptions({"a.obj", "--threads", "2", "--json", "b.obj", "--map", "draft"}, problem);
        QVERIFY(options);
        QCOMPARE(options->files, (std::vector<std::string>{"a.obj", "b.obj"}));
        QCOMPARE(options->threads, 2);
        QVERIFY(options->json);
        QVERIFY(options->exact);
        QVERIFY(options->map == UnwrapQuality::Draft);
    }

    void nonsenseIsRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("nothing") << QStringList{};
        QTest::newRow("unknown") << QStringList{QStringLiteral("a.obj"), QStringLiteral("--fast")};
        QTest::newRow("no number") << QStringList{QStringLiteral("a.obj"), QStringLiteral("--threads")};
        QTest::newRow("zero") << QStringList{QStringLiteral("a.obj"), QStringLiteral("--threads"),
                                             QStringLiteral("0")};
        QTest::newRow("quality") << QStringList{QStringLiteral("a.obj"), QStringLiteral("--map"),
                                                QStringLiteral("x")};
    }
    void nonsenseIsRefused()
    {
        QFETCH(QStringList, arguments);
        std::vector<std::string> list;
        for (const QString &argument : arguments)
            list.push_back(argument.toStdString());
        std::string problem;
        QVERIFY(!bench::readOptions(list, problem));
        QVERIFY(!problem.empty());
    }

    void reportsAreJson()
    {
        bench::MeshReport report;
        report.mesh = "a \"b\".obj";
        report.triangles = 12;
        report.steps.exact = 30;
        report.steps.fast = 2;
        report.races = {{1e-3, {100, 5, 10, 12}}, {2.4e-4, {100, 4, 10, 11}}};
        report.exactSoupMap = bench::MapReport{7, 4.1, 3};
        const auto json =
            QJsonDocument::fromJson(QByteArray::fromStdString(bench::asJson({report, report}, 2)));
        QVERIFY(json.isArray());
        QCOMPARE(json.array().size(), 2);
        const QJsonObject first = json.array()[0].toObject();
        QCOMPARE(first[QStringLiteral("triangles")].toInt(), 12);
        QCOMPARE(first[QStringLiteral("step_ratio")].toDouble(), 15.0);
        QCOMPARE(first[QStringLiteral("energy_ratio")].toDouble(), 20.0);
        QCOMPARE(first[QStringLiteral("step_ms_exact")].toDouble(), 30.0);
        QCOMPARE(first[QStringLiteral("step_ms_fast")].toDouble(), 2.0);
        QCOMPARE(first[QStringLiteral("exact_soup_map_seconds")].toDouble(), 7.0);
        QVERIFY(!first.contains(QStringLiteral("map_seconds")));
    }

    void subdividingKeepsTheSurface()
    {
        const auto mesh = test::cube();
        const auto fine = bench::subdivided(*mesh);
        QCOMPARE(fine->triangleCount(), 48);
        QVERIFY(std::abs(fine->area - mesh->area) < 1e-12);
        QCOMPARE(fine->boundarySides.size(), 0u);
        QCOMPARE(fine->componentCount, 1);
    }
};

QTEST_APPLESS_MAIN(TestBench)

} // namespace tst_bench

#include "tst_bench.moc"
