// The command line's transfer: from files, sessions, UV sets and objects, its report and its mistakes.
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "model/plain/chart.h"
#include "model/plain/uvlayout.h"
#include "support/cliruns.h"
#include "support/mappedmodels.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace tst_clitransfer {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::MappedModel;
using test::runInProcess;

namespace {

Scene sceneOf(const MappedModel &model)
{
    Scene scene;
    scene.mesh = model.mesh;
    scene.objectNames = {u"box"_s};
    scene.faceMaterial.assign(static_cast<std::size_t>(model.mesh->faceCount()), -1);
    if (model.uv.rows() > 0)
        scene.uvSets = {{u"UVMap"_s, model.uv}};
    return scene;
}

UvMatrix uvOf(const QString &path)
{
    const Result<Scene> scene = readMesh(path);
    return scene && !scene->uvSets.empty() ? scene->uvSets.front().uv : UvMatrix();
}

} // namespace

class TestCliTransfer : public QObject, private test::OwnFolder
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void fromAFileOfAnotherResolution();
    void fromASession();
    void betweenUvSets();
    void betweenObjects();
    void mistakes_data();
    void mistakes();

private:
    bool write(const char *name, const MappedModel &model)
    {
        return writeMesh(sceneOf(model), at(name)).ok();
    }
};

void TestCliTransfer::initTestCase()
{
    QVERIFY(write("mapped.obj", test::mapped(test::box(6), test::boxMap())));
    QVERIFY(write("fine.obj", {test::box(9, Vec3(2, 2, 2), true), UvMatrix(0, 2)}));
    QVERIFY(write("same.obj", {test::box(6), UvMatrix(0, 2)}));
    QVERIFY(write("large.obj", {test::box(7, Vec3(50, 50, 50)), UvMatrix(0, 2)}));
}

void TestCliTransfer::fromAFileOfAnotherResolution()
{
    const test::CliRun run = runInProcess({u"transfer"_s, at("fine.obj"), u"--from"_s, at("mapped.obj"),
                                           u"-o"_s, at("out.obj"), u"--report"_s, at("report.json")});
    QVERIFY2(run.code == 0, qPrintable(run.err));
    QVERIFY2(run.out.contains(u"of 972 faces matched by position"_s), qPrintable(run.out));
    const UvMatrix uv = uvOf(at("out.obj"));
    const UvMatrix expected = test::mapped(test::box(9, Vec3(2, 2, 2), true), test::boxMap()).uv;
    QCOMPARE(uv.rows(), expected.rows());
    QVERIFY((uv - expected).cwiseAbs().maxCoeff() < 1e-6);
    const QJsonObject report = QJsonDocument::fromJson(test::readBytes(at("report.json"))).object();
    QCOMPARE(report.value(u"status"_s).toString(), u"done"_s);
    QCOMPARE(report.value(u"charts"_s).toInt(), 6);
    const QJsonObject transfer = report.value(u"transfer"_s).toObject();
    QCOMPARE(transfer.value(u"faces"_s).toInt(), 972);
    QCOMPARE(transfer.value(u"copied"_s).toInt() + transfer.value(u"placed"_s).toInt(), 972);
    QCOMPARE(transfer.value(u"unmatched"_s).toInt(), 0);
    QCOMPARE(transfer.value(u"turned_over"_s).toInt(-1), 0);
    QVERIFY(std::abs(transfer.value(u"seam_length"_s).toDouble() - 24) < 1e-4);
    QVERIFY(transfer.value(u"max_distance"_s).toDouble() < 1e-6);
}

void TestCliTransfer::fromASession()
{
    QCOMPARE(runInProcess({u"convert"_s, at("mapped.obj"), u"-o"_s, at("mapped.acproj")}).code, 0);
    QCOMPARE(runInProcess({u"transfer"_s, at("same.obj"), u"--from"_s, at("mapped.acproj"), u"--match"_s,
                           u"topology"_s, u"-o"_s, at("session.acproj"), u"--quiet"_s})
                 .code,
             0);
    const Result<LoadedProject> project = loadProject(at("session.acproj"));
    QVERIFY(project.ok());
    QVERIFY(sameBits(project->state.scene.uvSets.front().uv, uvOf(at("mapped.obj"))));
    QVERIFY(project->extras.journal.has_value());
    QCOMPARE(runInProcess({u"replay"_s, at("session.acproj")}).code, 0);
}

void TestCliTransfer::betweenUvSets()
{
    QCOMPARE(runInProcess({u"transfer"_s, at("mapped.obj"), u"--from-uv-set"_s, u"1"_s, u"--new-uv-set"_s,
                           u"second"_s, u"-o"_s, at("sets.acproj"), u"--quiet"_s})
                 .code,
             0);
    const Result<LoadedProject> project = loadProject(at("sets.acproj"));
    QVERIFY(project.ok());
    QCOMPARE(project->state.scene.uvSets.size(), std::size_t(2));
    QVERIFY(sameBits(project->state.scene.uvSets[1].uv, project->state.scene.uvSets[0].uv));
}

void TestCliTransfer::betweenObjects()
{
    // Two boxes of an object each; the second has no UVs and lies elsewhere.
    const MappedModel source = test::mapped(test::box(2), test::boxMap());
    const MeshData &box = *source.mesh;
    PositionMatrix positions(2 * box.vertexCount(), 3);
    positions << box.positions, box.positions.array() + 7;
    std::vector<int> starts = box.faceStart, vertices = box.cornerVertex, objects(24, 0);
    for (int f = 1; f <= box.faceCount(); ++f)
        starts.push_back(box.cornerCount() + box.faceStart[f]);
    for (int v : box.cornerVertex)
        vertices.push_back(v + box.vertexCount());
    objects.resize(48, 1);
    Scene scene = sceneOf({MeshData::build(positions, starts, vertices, objects), UvMatrix(2 * 96, 2)});
    scene.uvSets.front().uv << source.uv, emptyLayout(box);
    scene.objectNames = {u"left"_s, u"right"_s};
    QVERIFY(writeMesh(scene, at("two.obj")).ok());
    const test::CliRun run = runInProcess({u"transfer"_s, at("two.obj"), u"--from-object"_s, u"left"_s,
                                           u"--objects"_s, u"right"_s, u"-o"_s, at("both.obj")});
    QVERIFY2(run.code == 0, qPrintable(run.err));
    const UvMatrix uv = uvOf(at("both.obj"));
    QCOMPARE(uv.rows(), 192);
    QVERIFY((uv.topRows(96) - uv.bottomRows(96)).cwiseAbs().maxCoeff() < 1e-12);
}

void TestCliTransfer::mistakes_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<QString>("part"); // of the message
    QTest::newRow("no UVs") << u"fine.obj --from large.obj"_s << u"there are no UVs to transfer"_s;
    QTest::newRow("missing file") << u"fine.obj --from none.obj"_s << u"none.obj"_s;
    QTest::newRow("missing set") << u"fine.obj --from mapped.obj --from-uv-set 4"_s
                                 << u"there is no UV set \"4\""_s;
    QTest::newRow("missing object") << u"fine.obj --from mapped.obj --from-object lid"_s
                                    << u"there is no object \"lid\""_s;
    QTest::newRow("other polygons") << u"fine.obj --from mapped.obj --match topology"_s
                                    << u"the polygons are not the same"_s;
    QTest::newRow("other units") << u"large.obj --from mapped.obj"_s << u"do not lie in one place"_s;
}

void TestCliTransfer::mistakes()
{
    QFETCH(QString, options);
    QFETCH(QString, part);
    QStringList arguments{u"transfer"_s};
    for (const QString &word : options.split(u' '))
        arguments << (word.endsWith(u".obj"_s) ? mFolder.filePath(word) : word);
    const test::CliRun run = runInProcess(arguments << u"-o"_s << at("no.obj"));
    QCOMPARE(run.code, 1);
    QVERIFY2(run.err.contains(part), qPrintable(run.err));
    QVERIFY(!QFile::exists(at("no.obj")));
}

QTEST_GUILESS_MAIN(TestCliTransfer)

} // namespace tst_clitransfer

#include "tst_clitransfer.moc"
