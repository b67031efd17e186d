// The command line on sessions: reading them, writing them, replaying them.
#include "commands/editpins.h"
#include "commands/journalrecorder.h"
#include "commands/replay.h"
#include "commands/setseamstate.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/instances.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "support/cliruns.h"
#include "support/editsupport.h"
#include "support/fbxfiles.h"
#include "support/overlapmaps.h"

#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace tst_clisession {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Edges of the active map along which the UVs of the two faces differ.
std::vector<bool> openEdges(const Scene &scene)
{
    const MeshData &mesh = *scene.mesh;
    const UvMatrix &uv = scene.uvSets.front().uv;
    std::vector<bool> result;
    for (const EdgePair &pair : mesh.edgePairs) {
        const auto differs = [&](int end) {
            return (uv.row(mesh.cornerOfSoup(pair.corner[end][0])) -
                    uv.row(mesh.cornerOfSoup(pair.corner[end][1])))
                       .norm() > 1e-9;
        };
        result.push_back(differs(0) || differs(1));
    }
    return result;
}

LoadedProject loaded(const QString &path)
{
    return loadProject(path).value();
}

} // namespace

class TestCliSession : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void meshToSession();
    void sessionToMeshIsLossless();
    void unwrapUsesTheSteering();
    void settingsOfTheSessionCount();
    void optionsWin();
    void packAndSeparate();
    void separateKeepsJoinedEdges();
    void aMissedBoundIsSaid();
    void checkReadsTheActiveSet();
    void uvSetsOfASession();
    void replayReproduces();
    void replaySeesADifference();
    void uniqueMeshes();
    void replayWithoutJournal();
    void whatASessionLostIsSaid_data();
    void whatASessionLostIsSaid();
    void damagedSession();

private:
    QString file(const QString &name) const { return mFolder->filePath(name); }
    test::CliRun run(const QStringList &arguments) const { return test::runInProcess(arguments); }
    //! Unwraps with little effort.
    test::CliRun unwrap(const QStringList &arguments) const
    {
        return run(QStringList{u"unwrap"_s, u"--quality"_s, u"draft"_s, u"--pack-time"_s, u"0"_s} +
                   arguments);
    }

    std::unique_ptr<QTemporaryDir> mFolder;
};

void TestCliSession::init()
{
    mFolder = std::make_unique<QTemporaryDir>();
    QVERIFY(test::writeBytes(file(u"cube.obj"_s), test::quadCubeObj()));
    QVERIFY(test::writeBytes(file(u"sheet.obj"_s), test::sheetObj(4)));
}

void TestCliSession::meshToSession()
{
    const test::CliRun made =
        unwrap({file(u"cube.obj"_s), u"-o"_s, file(u"a.acproj"_s), u"--margin"_s, u"12"_s});
    QVERIFY2(made.code == 0, qPrintable(made.err));
    const test::CliRun mesh =
        unwrap({file(u"cube.obj"_s), u"-o"_s, file(u"a.obj"_s), u"--margin"_s, u"12"_s});
    QCOMPARE(mesh.code, 0);
    const LoadedProject project = loaded(file(u"a.acproj"_s));
    QVERIFY(project.notes.isEmpty());
    const Scene expected = readMesh(file(u"a.obj"_s)).value();
    QVERIFY(project.state.scene.uvSets[0].uv == expected.uvSets[0].uv);
    QCOMPARE(project.state.packingSettings.margin, 12);
    QVERIFY(project.state.seams == Seams::allFree(*expected.mesh));
    QCOMPARE(project.extras.journal->commands.size(), std::size_t(1));
    QVERIFY(project.extras.journal->initial.scene.uvSets[0].uv.hasNaN());
    const QImage picture = QImage::fromData(project.extras.thumbnail, "PNG");
    QCOMPARE(picture.size(), QSize(256, 256));
}

void TestCliSession::sessionToMeshIsLossless()
{
    QCOMPARE(run({u"convert"_s, file(u"cube.obj"_s), u"-o"_s, file(u"a.acproj"_s)}).code, 0);
    QVERIFY(QFile::rename(file(u"cube.obj"_s), file(u"gone.obj"_s)));
    QCOMPARE(run({u"convert"_s, file(u"a.acproj"_s), u"-o"_s, file(u"b.obj"_s)}).code, 0);
    QCOMPARE(test::readBytes(file(u"b.obj"_s)), test::quadCubeObj());
    QCOMPARE(run({u"sample"_s, u"machine"_s, u"-o"_s, file(u"machine.acproj"_s)}).code, 0);
    QVERIFY(loaded(file(u"machine.acproj"_s)).state.scene.mesh->faceCount() > 100);
}

void TestCliSession::unwrapUsesTheSteering()
{
    QCOMPARE(run({u"convert"_s, file(u"sheet.obj"_s), u"-o"_s, file(u"a.acproj"_s)}).code, 0);
    LoadedProject project = loaded(file(u"a.acproj"_s));
    const MeshData &mesh = *project.state.scene.mesh;
    // Without steering the sheet stays whole. Cut off its first row of faces.
    std::vector<bool> cut(mesh.edgePairs.size(), false);
    for (std::size_t p = 0; p < mesh.edgePairs.size(); ++p) {
        const EdgePair &pair = mesh.edgePairs[p];
        const auto inFirstRow = [&](int which) { return mesh.triangleFace[pair.triangle[which]] < 4; };
        cut[p] = inFirstRow(0) != inFirstRow(1);
        if (cut[p])
            project.state.seams.states[2 * p] = project.state.seams.states[2 * p + 1] = PairState::Cut;
    }
    QCOMPARE(std::count(cut.begin(), cut.end(), true), 4);
    QVERIFY(saveProject(project.state, {}, file(u"cut.acproj"_s)).ok());
    QCOMPARE(unwrap({file(u"a.acproj"_s), u"-o"_s, file(u"plain.obj"_s)}).code, 0);
    const std::vector<bool> none(mesh.edgePairs.size(), false);
    QCOMPARE(openEdges(readMesh(file(u"plain.obj"_s)).value()), none);
    const test::CliRun made = unwrap({file(u"cut.acproj"_s), u"-o"_s, file(u"cut.obj"_s)});
    QVERIFY2(made.code == 0, qPrintable(made.err));
    QCOMPARE(openEdges(readMesh(file(u"cut.obj"_s)).value()), cut);
    // The session keeps its steering.
    QCOMPARE(unwrap({file(u"cut.acproj"_s), u"-o"_s, file(u"again.acproj"_s)}).code, 0);
    QVERIFY(loaded(file(u"again.acproj"_s)).state.seams == project.state.seams);
}

void TestCliSession::settingsOfTheSessionCount()
{
    QCOMPARE(run({u"convert"_s, file(u"cube.obj"_s), u"-o"_s, file(u"a.acproj"_s)}).code, 0);
    LoadedProject project = loaded(file(u"a.acproj"_s));
    project.state.solveSettings.weighting = SeamWeighting::Count;
    project.state.solveSettings.seed = 5;
    project.state.packingSettings.textureSize = 512;
    project.state.packingSettings.margin = 20;
    project.state.packingSettings.rotation = PackRotation::None;
    QVERIFY(saveProject(project.state, {}, file(u"a.acproj"_s)).ok());
    QCOMPARE(unwrap({file(u"a.acproj"_s), u"-o"_s, file(u"a.obj"_s)}).code, 0);
    QCOMPARE(
        unwrap({file(u"cube.obj"_s), u"-o"_s, file(u"b.obj"_s), u"--weights"_s, u"count"_s, u"--seed"_s,
                u"5"_s, u"--texture-size"_s, u"512"_s, u"--margin"_s, u"20"_s, u"--rotation"_s, u"none"_s})
            .code,
        0);
    QVERIFY(test::readBytes(file(u"a.obj"_s)).contains("\nvt "));
    QCOMPARE(test::readBytes(file(u"a.obj"_s)), test::readBytes(file(u"b.obj"_s)));
}

void TestCliSession::optionsWin()
{
    QCOMPARE(run({u"convert"_s, file(u"cube.obj"_s), u"-o"_s, file(u"a.acproj"_s)}).code, 0);
    LoadedProject project = loaded(file(u"a.acproj"_s));
    project.state.packingSettings.margin = 20;
    project.state.solveSettings.boxWeight = 7;
    QVERIFY(saveProject(project.state, {}, file(u"a.acproj"_s)).ok());
    QCOMPARE(unwrap({file(u"a.acproj"_s), u"-o"_s, file(u"b.acproj"_s), u"--margin=3"_s, u"--seed=9"_s}).code,
             0);
    const LoadedProject made = loaded(file(u"b.acproj"_s));
    QCOMPARE(made.state.packingSettings.margin, 3);
    QCOMPARE(made.state.solveSettings.seed, 9u);
    QCOMPARE(made.state.solveSettings.boxWeight, 7.0);
}

void TestCliSession::packAndSeparate()
{
    QCOMPARE(unwrap({file(u"cube.obj"_s), u"-o"_s, file(u"a.acproj"_s)}).code, 0);
    LoadedProject project = loaded(file(u"a.acproj"_s));
    const Vec2 corner = project.state.scene.uvSets[0].uv.row(0);
    project.state.constraints.pins = {{0, corner, true, 1}};
    QVERIFY(saveProject(project.state, {}, file(u"a.acproj"_s)).ok());
    const test::CliRun packed =
        run({u"pack"_s, file(u"a.acproj"_s), u"-o"_s, file(u"b.acproj"_s), u"--margin"_s, u"200"_s});
    QVERIFY2(packed.code == 0, qPrintable(packed.err));
    const LoadedProject after = loaded(file(u"b.acproj"_s));
    // The pin holds the only island.
    QVERIFY(after.state.scene.uvSets[0].uv == project.state.scene.uvSets[0].uv);
    QVERIFY(after.state.constraints == project.state.constraints);
    QCOMPARE(run({u"separate"_s, file(u"b.acproj"_s), u"-o"_s, file(u"c.acproj"_s)}).code, 0);
    QVERIFY(loaded(file(u"c.acproj"_s)).state == after.state);
}

void TestCliSession::separateKeepsJoinedEdges()
{
    const test::OverlappingMap map = test::overlappingMaps()[1];
    Scene scene;
    scene.mesh = map.mesh;
    scene.uvSets = {{u"UVMap"_s, map.uv}};
    DocumentState state = DocumentState::initial(scene);
    QVERIFY(saveProject(state, {}, file(u"a.acproj"_s)).ok());
    const auto separated = [this](const QString &from) {
        const test::CliRun done = run({u"separate"_s, file(from), u"-o"_s, file(u"done.acproj"_s),
                                       u"--margin"_s, u"1"_s, u"--pack-time"_s, u"0"_s});
        return done.code == 0 ? openEdges(loaded(file(u"done.acproj"_s)).state.scene) : std::vector<bool>();
    };
    const std::vector<bool> plain = separated(u"a.acproj"_s);
    QCOMPARE(plain.size(), map.mesh->edgePairs.size());
    QVERIFY(std::count(plain.begin(), plain.end(), true) > 0);
    for (std::size_t p = 0; p < plain.size(); ++p) {
        if (plain[p])
            state.seams.states[2 * p] = PairState::Joined;
    }
    QVERIFY(saveProject(state, {}, file(u"b.acproj"_s)).ok());
    const std::vector<bool> steered = separated(u"b.acproj"_s);
    QCOMPARE(steered.size(), plain.size());
    QVERIFY(std::count(steered.begin(), steered.end(), true) > 0);
    for (std::size_t p = 0; p < plain.size(); ++p)
        QVERIFY(!(plain[p] && steered[p]));
}

//! Joins leave cuts on one cap of a sphere only: the rest cannot be flattened within the bound.
void TestCliSession::aMissedBoundIsSaid()
{
    Document document(test::sceneOf(test::sphere(10, 12)));
    const MeshData &mesh = document.mesh();
    std::vector<int> joined;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const auto height = [&](int end) {
            return mesh.positions(mesh.vertexOfSoup(pair.corner[end][0]), 2);
        };
        if (!pair.diagonal && std::min(height(0), height(1)) < 0.5)
            joined.push_back(static_cast<int>(e));
    }
    pushCommand(
        std::make_unique<SetSeamState>(document, SetSeamState::Edit::Join, cornerPairsOfEdges(mesh, joined)));
    QVERIFY(saveProject(document.state(), {}, file(u"a.acproj"_s)));
    const test::CliRun made =
        unwrap({file(u"a.acproj"_s), u"-o"_s, file(u"b.obj"_s), u"--report"_s, file(u"r.json"_s)});
    QCOMPARE(made.code, 3);
    QVERIFY(made.err.contains(u"above the bound"_s));
    QVERIFY(test::readBytes(file(u"r.json"_s)).contains("\"bound_missed\""));
    QVERIFY(readMesh(file(u"b.obj"_s)).ok());
}

void TestCliSession::checkReadsTheActiveSet()
{
    DocumentState state = test::layoutDocument(test::grid(4))->state();
    QVERIFY(saveProject(state, {}, file(u"a.acproj"_s)).ok());
    state.activeUvSet = 1; // without UVs
    QVERIFY(saveProject(state, {}, file(u"b.acproj"_s)).ok());
    const test::CliRun first = run({u"check"_s, file(u"a.acproj"_s), u"--json"_s});
    QCOMPARE(first.code, 0);
    QVERIFY2(first.out.contains(u"\"charts\": 2"), qPrintable(first.out));
    const test::CliRun second = run({u"check"_s, file(u"b.acproj"_s), u"--json"_s});
    QVERIFY2(second.out.contains(u"\"facesWithoutUv\": 16") ||
                 second.out.contains(u"\"faces_without_uv\": 16"),
             qPrintable(second.out));
    QCOMPARE(run({u"pack"_s, file(u"b.acproj"_s), u"-o"_s, file(u"c.acproj"_s)}).code, 1);
    QCOMPARE(run({u"convert"_s, file(u"b.acproj"_s), u"-o"_s, file(u"b.obj"_s)}).code, 0);
    QVERIFY(!readMesh(file(u"b.obj"_s)).value().hasUv());
}

void TestCliSession::uvSetsOfASession()
{
    DocumentState state = test::layoutDocument(test::grid(4))->state();
    const std::vector<UvSet> sets = state.scene.uvSets;
    QCOMPARE(sets.size(), std::size_t(2)); // the second one is empty
    QVERIFY(saveProject(state, {}, file(u"a.acproj"_s)).ok());
    const test::CliRun wrong = run({u"check"_s, file(u"a.acproj"_s), u"--uv-set"_s, u"nothing"_s});
    QCOMPARE(wrong.code, 1);
    QVERIFY2(wrong.err.contains(sets[1].name), qPrintable(wrong.err));
    QVERIFY(run({u"check"_s, file(u"a.acproj"_s), u"--uv-set"_s, u"2"_s, u"--json"_s})
                .out.contains(u"\"uv_set\": \"%1\""_s.arg(sets[1].name)));

    // A set of its own begins as a copy of the chosen one, and the others stay.
    const test::CliRun made =
        run({u"lightmap"_s, file(u"a.acproj"_s), u"--uv-set"_s, sets[0].name, u"--new-uv-set"_s, u"Light"_s,
             u"--margin"_s, u"40"_s, u"-o"_s, file(u"b.acproj"_s)});
    QVERIFY2(made.code == 0, qPrintable(made.err));
    const Result<LoadedProject> again = loadProject(file(u"b.acproj"_s));
    QVERIFY(again.ok());
    QCOMPARE(again->state.scene.uvSets.size(), std::size_t(3));
    QCOMPARE(again->state.activeUvSet, 2);
    QCOMPARE(again->state.scene.uvSets[2].name, u"Light"_s);
    QCOMPARE(again->state.scene.uvSets[0].uv, sets[0].uv);
    QVERIFY(again->state.scene.uvSets[2].uv.allFinite());
    QVERIFY(again->state.scene.uvSets[2].uv != sets[0].uv);
    QCOMPARE(run({u"replay"_s, file(u"b.acproj"_s)}).code, 0);
    const test::CliRun twice =
        run({u"pack"_s, file(u"b.acproj"_s), u"--new-uv-set"_s, u"Light"_s, u"-o"_s, file(u"c.acproj"_s)});
    QCOMPARE(twice.code, 1);
    QVERIFY2(twice.err.contains(u"in use"_s), qPrintable(twice.err));
}

void TestCliSession::replayReproduces()
{
    QCOMPARE(unwrap({file(u"cube.obj"_s), u"-o"_s, file(u"a.acproj"_s)}).code, 0);
    QCOMPARE(
        run({u"pack"_s, file(u"a.acproj"_s), u"-o"_s, file(u"b.acproj"_s), u"--margin"_s, u"100"_s}).code, 0);
    const test::CliRun plain = run({u"replay"_s, file(u"b.acproj"_s)});
    QCOMPARE(plain.code, 0);
    QCOMPARE(plain.out, u"replayed commands: 3\nthe result is what the session holds\n"_s);
    const test::CliRun again = run({u"replay"_s, file(u"b.acproj"_s), u"-o"_s, file(u"c.acproj"_s)});
    QCOMPARE(again.code, 0);
    QVERIFY(loaded(file(u"c.acproj"_s)).state == loaded(file(u"b.acproj"_s)).state);
    QCOMPARE(test::readBytes(file(u"c.acproj"_s)), test::readBytes(file(u"b.acproj"_s)));
    QCOMPARE(run({u"replay"_s, file(u"b.acproj"_s), u"-o"_s, file(u"c.obj"_s)}).code, 0);
    QCOMPARE(run({u"convert"_s, file(u"b.acproj"_s), u"-o"_s, file(u"d.obj"_s)}).code, 0);
    QCOMPARE(test::readBytes(file(u"c.obj"_s)), test::readBytes(file(u"d.obj"_s)));
}

//! Objects that share a mesh: figures of a session are those of the file that it will be.
void TestCliSession::uniqueMeshes()
{
    const fbxfiles::Kind kind;
    const QString in = file(u"twins.fbx"_s), session = file(u"twins.acproj"_s), out = file(u"out.fbx"_s);
    QVERIFY(saveAtomically(
                in, fbxfiles::model(
                        kind,
                        {{"One", fbxfiles::quads({fbxfiles::uvElement(0, "UVMap"), fbxfiles::layer(0, {0})})},
                         {"Two", {}, {fbxfiles::property(kind, "Lcl Translation", {9, 0, 0})}}}))
                .ok());
    const auto charts = [this](const QString &path) {
        const test::CliRun checked = run({u"check"_s, path});
        return checked.out.section(u"charts"_s, 1).simplified().section(u' ', 0, 0);
    };
    QCOMPARE(unwrap({in, u"-o"_s, session}).code, 0);
    QCOMPARE(run({u"convert"_s, session, u"-o"_s, out}).code, 0);
    QVERIFY(hasSharedMeshes(readMesh(out).value()));
    QCOMPARE(charts(session), charts(out));

    const QString unique = file(u"unique.acproj"_s);
    const test::CliRun made = run({u"pack"_s, session, u"-o"_s, unique, u"--make-unique"_s});
    QVERIFY2(made.code == 0, qPrintable(made.err));
    QVERIFY(loaded(unique).state.scene.uniqueMeshes);
    QCOMPARE(run({u"replay"_s, unique}).code, 0);
    QCOMPARE(run({u"convert"_s, unique, u"-o"_s, out}).code, 0);
    QVERIFY(!hasSharedMeshes(readMesh(out).value()));
    QCOMPARE(charts(unique), charts(out));
    QVERIFY(run({u"check"_s, out}).out.contains(u"no problems"_s));
    // There is nothing left that it could do.
    QVERIFY(run({u"convert"_s, out, u"-o"_s, file(u"again.fbx"_s), u"--make-unique"_s}).code == 0);
}

void TestCliSession::replaySeesADifference()
{
    QCOMPARE(unwrap({file(u"cube.obj"_s), u"-o"_s, file(u"a.acproj"_s)}).code, 0);
    LoadedProject project = loaded(file(u"a.acproj"_s));
    project.state.scene.uvSets[0].uv(0, 0) += 0.25;
    QVERIFY(saveProject(project.state, project.extras, file(u"a.acproj"_s)).ok());
    const test::CliRun replayed = run({u"replay"_s, file(u"a.acproj"_s)});
    QCOMPARE(replayed.code, 1);
    QVERIFY(replayed.out.contains(u"the result differs"));
}

void TestCliSession::replayWithoutJournal()
{
    QVERIFY(saveProject(test::gridDocument()->state(), {}, file(u"a.acproj"_s)).ok());
    const test::CliRun replayed = run({u"replay"_s, file(u"a.acproj"_s)});
    QCOMPARE(replayed.code, 1);
    QVERIFY(replayed.err.contains(u"has no journal"));
    QCOMPARE(run({u"replay"_s, file(u"cube.obj"_s)}).code, 1);
    QCOMPARE(run({u"replay"_s}).code, 2);
}

void TestCliSession::whatASessionLostIsSaid()
{
    QFETCH(QByteArray, part);
    QFETCH(QString, said);
    QCOMPARE(unwrap({file(u"cube.obj"_s), u"-o"_s, file(u"a.acproj"_s)}).code, 0);
    LoadedProject project = loaded(file(u"a.acproj"_s));
    project.state.texelWeights.assign(std::size_t(project.state.scene.mesh->faceCount()), 0.5);
    QVERIFY(saveProject(project.state, project.extras, file(u"a.acproj"_s)).ok());
    QByteArray bytes = test::readBytes(file(u"a.acproj"_s));
    const qsizetype name = bytes.indexOf(part);
    QVERIFY(name > 0);
    QFETCH(int, offset);
    bytes[name + offset] = char(bytes[name + offset] ^ 1);
    QVERIFY(test::writeBytes(file(u"hurt.acproj"_s), bytes));
    const QString hurt = file(u"hurt.acproj"_s);
    const auto says = [&](const test::CliRun &made) { return made.err.contains(u"warning: "_s + said); };
    QVERIFY(says(run({u"check"_s, hurt})));
    const test::CliRun toMesh = run({u"convert"_s, hurt, u"-o"_s, file(u"hurt.obj"_s), u"--quiet"_s});
    QVERIFY2(toMesh.code == 0 && says(toMesh), qPrintable(toMesh.err));
    const QString report = file(u"report.json"_s);
    const test::CliRun made =
        unwrap({hurt, u"-o"_s, file(u"made.obj"_s), u"--quiet"_s, u"--report"_s, report});
    QVERIFY2(made.code == 0 && says(made), qPrintable(made.err));
    QVERIFY(QString::fromUtf8(test::readBytes(report)).contains(QString(said).replace(u'"', u"\\\""_s)));
    // The same of a session that is read beside the input.
    QVERIFY(QImage(4, 4, QImage::Format_RGB32).save(file(u"skin.png"_s)));
    QCOMPARE(run({u"convert"_s, file(u"a.acproj"_s), u"-o"_s, file(u"mapped.obj"_s)}).code, 0);
    const QStringList small{u"--size"_s, u"16"_s, u"-o"_s, file(u"maps"_s)};
    for (const QStringList &words :
         {QStringList{u"bake"_s, file(u"mapped.obj"_s), u"--high"_s, hurt, u"--maps"_s, u"position"_s} +
              small,
          QStringList{u"bake"_s, file(u"mapped.obj"_s), u"--high"_s, file(u"cube.obj"_s), u"--cage-file"_s,
                      hurt, u"--maps"_s, u"position"_s} +
              small,
          QStringList{u"transfer"_s, file(u"mapped.obj"_s), u"--from"_s, hurt, u"-o"_s, file(u"x.obj"_s)},
          QStringList{u"transfer"_s, file(u"mapped.obj"_s), u"--from"_s, hurt, u"--textures"_s,
                      file(u"skin.png"_s)} +
              small}) {
        const test::CliRun beside = run(words + QStringList{u"--quiet"_s});
        QVERIFY2(beside.err.contains(u"hurt.acproj: "_s + said), qPrintable(words.join(u' ') + beside.err));
    }
    // A session of a damaged one only when asked for.
    const QString copy = file(u"copy.acproj"_s);
    const test::CliRun refused = run({u"convert"_s, hurt, u"-o"_s, copy});
    QCOMPARE(refused.code, 1);
    QVERIFY2(refused.err.contains(u"--force"), qPrintable(refused.err));
    QVERIFY(!QFile::exists(copy));
    QCOMPARE(run({u"convert"_s, hurt, u"-o"_s, copy, u"--force"_s}).code, 0);
    QVERIFY(loaded(copy).warnings.isEmpty());
}

void TestCliSession::whatASessionLostIsSaid_data()
{
    QTest::addColumn<QByteArray>("part");
    QTest::addColumn<int>("offset");
    QTest::addColumn<QString>("said");
    QTest::newRow("UVs") << QByteArray("uv.0") << 60 << u"the UV sets: damaged in the session, left out"_s;
    QTest::newRow("name of a part") << QByteArray("texelWeights") << 5
                                    << u"the part \"texelVeights\" is unknown"_s;
    QTest::newRow("an optional part") << QByteArray("texelWeights") << 30
                                      << u"the painted texel density: damaged in the session, left out"_s;
}

void TestCliSession::damagedSession()
{
    QCOMPARE(unwrap({file(u"cube.obj"_s), u"-o"_s, file(u"a.acproj"_s)}).code, 0);
    const QByteArray bytes = test::readBytes(file(u"a.acproj"_s));
    QVERIFY(test::writeBytes(file(u"cut.acproj"_s), bytes.left(bytes.size() - 20)));
    const test::CliRun checked = run({u"check"_s, file(u"cut.acproj"_s)});
    QCOMPARE(checked.code, 0);
    QVERIFY2(checked.out.contains(u"note: the session is cut off"), qPrintable(checked.out));
    QVERIFY(test::writeBytes(file(u"bad.acproj"_s), bytes.left(100)));
    const test::CliRun failed = run({u"convert"_s, file(u"bad.acproj"_s), u"-o"_s, file(u"x.obj"_s)});
    QCOMPARE(failed.code, 1);
    QVERIFY2(failed.err.contains(u"the model in the session is damaged. Open a backup"),
             qPrintable(failed.err));
}

QTEST_GUILESS_MAIN(TestCliSession)

} // namespace tst_clisession

#include "tst_clisession.moc"
