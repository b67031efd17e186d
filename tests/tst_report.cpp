// The JSON report and the sentences of the mesh doctor.
#include "model/layouts/meshdoctor.h"
#include "model/layouts/report.h"
#include "support/meshbuilders.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace tst_report {

using namespace autocuts;

namespace {

//! Keys of the outermost object, in the order of the text.
QStringList keysInOrder(const QByteArray &json)
{
    QStringList keys;
    for (const QByteArray &line : json.split('\n')) {
        if (line.startsWith("  \"") && line.contains("\": "))
            keys << QString::fromUtf8(line.mid(3, line.indexOf('"', 3) - 3));
    }
    return keys;
}

} // namespace

class TestReport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allKeysAreThereInOrder()
    {
        const QByteArray empty = reportJson({});
        MapReport full;
        full.triangles = 12;
        full.seamLength = 7.25;
        full.notes = {QStringLiteral("a note")};
        full.mesh = test::cube()->report;
        const QStringList keys = keysInOrder(empty);
        QCOMPARE(keysInOrder(reportJson(full)), keys);
        const QStringList stable =
            QStringLiteral("triangles charts seam_length seam_norm sym_dirichlet "
                           "sym_dirichlet_max flipped overlap_pairs overlap_area_ratio "
                           "packing_efficiency min_gutter_texels seconds iterations lambda "
                           "delta status")
                .split(QLatin1Char(' '));
        QCOMPARE(keys.mid(0, stable.size()), stable);
        const QJsonObject object = QJsonDocument::fromJson(empty).object();
        QCOMPARE(object.size(), keys.size());
        for (const QString &key : stable)
            QVERIFY(object.value(key).isNull());
        QVERIFY(empty.endsWith("}\n"));
    }

    void valuesReadBackExactly()
    {
        MapReport report;
        report.triangles = 5804;
        report.charts = 0;
        report.seamNorm = 0.1 + 0.2;
        report.symDirichlet = 4.1;
        report.overlapPairs = qint64(5000000000);
        report.overlapAreaRatio = 1.25e-17;
        report.symDirichletMax = std::numeric_limits<double>::infinity();
        report.status = QStringLiteral("time_limit");
        report.input = QStringLiteral("C:\\\u043C\u043E\u0434\u0435\u043B\u044C \"a\"\n\t.obj");
        report.inUnitSquare = true;
        report.notes = {QStringLiteral("one"), QStringLiteral("two")};
        MeshReport mesh;
        mesh.nonManifoldEdges = 47;
        mesh.area = 1.5;
        report.mesh = mesh;
        QJsonParseError error;
        const QByteArray json = reportJson(report);
        const QJsonObject object = QJsonDocument::fromJson(json, &error).object();
        QCOMPARE(error.error, QJsonParseError::NoError);
        const auto value = [&](const char *key) { return object.value(QLatin1String(key)); };
        QCOMPARE(value("triangles").toInteger(), qint64(5804));
        QCOMPARE(value("charts").toInteger(-1), qint64(0));
        QVERIFY(value("seam_norm").toDouble() == 0.1 + 0.2);
        QVERIFY(value("overlap_area_ratio").toDouble() == 1.25e-17);
        QVERIFY(json.contains("\"sym_dirichlet\": 4.1,"));
        QCOMPARE(value("overlap_pairs").toInteger(), qint64(5000000000));
        QVERIFY(value("sym_dirichlet_max").isNull());
        QCOMPARE(value("status").toString(), report.status);
        QCOMPARE(value("input").toString(), report.input);
        QCOMPARE(value("in_unit_square").toBool(), true);
        QCOMPARE(value("notes").toArray().size(), 2);
        QCOMPARE(value("mesh").toObject().value(QLatin1String("nonmanifold_edges")).toInt(), 47);
        QCOMPARE(value("mesh").toObject().value(QLatin1String("area")).toDouble(), 1.5);
        QCOMPARE(reportJson(report), json);
    }

    void doctorIsSilentAboutHealthyMeshes()
    {
        QCOMPARE(meshDoctorNotes(test::cube()->report), QStringList());
    }

    void doctorNamesWhatItFound()
    {
        // A fin on an edge, a doubled face, a vertex of no face, a split vertex and a triangle without area.
        const auto mesh =
            test::polygonMesh({{0, 0, 0},
                               {1, 0, 0},
                               {0, 1, 0},
                               {0, -1, 0},
                               {0, 0, 1},
                               {5, 5, 5},
                               {0, 0, 0},
                               {2, 0, 0},
                               {3, 0, 0}},
                              {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {2, 0, 1}, {1, 7, 8}, {6, 3, 4}});
        const QStringList notes = meshDoctorNotes(mesh->report);
        QVERIFY(notes.contains(
            QStringLiteral("1 non-manifold edge: each face was joined to its best partner, the "
                           "other sides are treated as boundary")));
        const auto has = [&](const char *start) {
            return std::any_of(notes.begin(), notes.end(),
                               [&](const QString &note) { return note.startsWith(QLatin1String(start)); });
        };
        QVERIFY(has("1 triangle without area: "));
        QVERIFY(has("1 duplicated face: "));
        QVERIFY(has("1 vertex without a face: "));
        QVERIFY(has("1 vertex at the place of another: "));
        QVERIFY(!has("0"));
    }

    void doctorCountsInThePlural()
    {
        MeshReport report;
        report.faces = 10;
        report.area = 1;
        report.nonManifoldEdges = 47;
        report.components = 3;
        report.boxDiagonal = 1;
        report.distanceFromOrigin = 1e6;
        const QStringList notes = meshDoctorNotes(report);
        QCOMPARE(notes.size(), 3);
        QVERIFY(notes[0].startsWith(QLatin1String("47 non-manifold edges: ")));
        QVERIFY(notes[1].startsWith(QLatin1String("3 separate parts: ")));
        QVERIFY(notes[2].contains(QLatin1String("1e+06 times its own size from the origin")));
        QCOMPARE(meshDoctorNotes({}), QStringList{QStringLiteral("No faces: there is nothing to unwrap")});
    }
};

QTEST_APPLESS_MAIN(TestReport)

} // namespace tst_report

#include "tst_report.moc"
