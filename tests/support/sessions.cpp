#include "support/sessions.h"

#include "commands/journalrecorder.h"
#include "commands/setseamstate.h"
#include "model/io/obj/objreader.h"
#include "support/editsupport.h"
#include "support/randomedits.h"

#include <limits>

namespace autocuts::test {

using namespace Qt::Literals::StringLiterals;

namespace {

const char *const cubeText = R"(# a cube
mtllib cube.mtl
o Würfel
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
vt 0 0
vt 0.1 0
vt 0.1 0.3
usemtl iron
f 1/1 3/2 2/3
f 1 4 3
f 5 6 7
f 5 7 8
usemtl gold
f 1 2 6
f 1 6 5
f 2 3 7
f 2 7 6
s 1
f 3 4 8
f 3 8 7
f 4 1 5
f 4 5 8
)";

//! Everything that is set directly; the rest comes from commands.
void addSteering(DocumentState &state)
{
    const int corners = state.scene.mesh->cornerCount();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    UvMatrix second(corners, 2);
    for (int c = 0; c < corners; ++c)
        second.row(c) << c / 7.0, 1.0 / (c + 3);
    second.row(5) << nan, nan;
    second.row(6) << -0.0, std::numeric_limits<double>::denorm_min();
    state.scene.uvSets.push_back({u"lightmap ☀"_s, second});
    state.uvScales.push_back(0.125);
    state.activeUvSet = 1;
    state.seams.states[3] = PairState::Cut; // half cut
    state.seams.states[6] = state.seams.states[7] = PairState::Cut;
    state.seams.states[10] = state.seams.states[11] = PairState::Joined;
    state.seams.weights[3] = 0;
    state.seams.weights[20] = 1.0 / 3;
    state.constraints.pins = {{3, {0.25, 0.5}, true, 1}, {30, {1.5, -0.5}, false, 7}};
    state.constraints.rectangles = {{1, u"head"_s, 0xff00ff00, {0, 0}, {0.5, 0.5}, false, 1, {0, 1, 4}},
                                    {4, u""_s, 0x80ff0000, {0.5, 0}, {1, 0.25}, true, 2, {}}};
    state.marks.faceFlags[2] = {.locked = 1};
    state.marks.faceFlags[7] = {.stack = 3, .group = 9};
    state.marks.tags = {{u"metal"_s, {0, 1, 5}}, {u"skin"_s, {11}}};
    state.solveSettings = {0.25,
                           0.5,
                           50,
                           DistortionEnergy::Amips,
                           SeamWeighting::Count,
                           StartMode::ExistingUv,
                           SolverKind::Exact,
                           77};
    state.packingSettings = {1024, 5, 1012, PackRotation::Quarter, true};
    state.selection = {SelectionMode::Edges, {1, 2}, {0, 4}, {7, 8, 35}};
    state.viewState = QByteArrayLiteral("camera\0x");
}

//! \pre nothing was done in the document yet
Session sessionOf(Document &document, JournalRecorder &recorder)
{
    return {document.state(),
            {recorder.journal(), QByteArrayLiteral("\x89PNG thumbnail"), u"/home/ü/a.acproj"_s}};
}

} // namespace

Session cubeSession()
{
    DocumentState state = DocumentState::initial(parseObj(cubeText, u"/models/cube.obj"_s).value());
    addSteering(state);
    const auto document = std::move(Document::create(std::move(state)).value());
    JournalRecorder recorder(*document);
    const std::vector<int> edges{0, 2};
    pushCommand(std::make_unique<SetSeamState>(*document, SetSeamState::Edit::Cut,
                                               cornerPairsOfEdges(document->mesh(), edges)));
    return sessionOf(*document, recorder);
}

Session gridSession(int n, int edits, int seed)
{
    Scene scene = sceneOf(grid(n, 0.3));
    scene.path = u"C:\\models\\grid.ply"_s;
    scene.format = u"ply"_s;
    scene.materialNames = {u"a"_s, u"b"_s};
    for (std::size_t f = 0; f < scene.faceMaterial.size(); ++f)
        scene.faceMaterial[f] = static_cast<int>(f % 3) - 1;
    scene.hardEdges.resize(scene.mesh->edgePairs.size());
    for (std::size_t e = 0; e < scene.hardEdges.size(); e += 3)
        scene.hardEdges[e] = !scene.mesh->edgePairs[e].diagonal;
    scene.notes = {u"two vertices were \"welded\""_s};
    scene.uvSets.push_back({u"first"_s, splitLayout(*scene.mesh)});
    const auto document = std::make_unique<Document>(std::move(scene));
    JournalRecorder recorder(*document);
    RandomEdits random(static_cast<std::uint64_t>(seed));
    for (int i = 0; i < edits; ++i) {
        random.select(*document);
        pushCommand(random.next(*document));
    }
    document->setViewState(QByteArray(300, 'v'));
    return sessionOf(*document, recorder);
}

QByteArray bytesOf(const Session &session)
{
    return ProjectWriter().bytes(session.state, session.extras);
}

QByteArray repacked(const QByteArray &bytes, const std::function<void(PartMap &)> &change, int version)
{
    PartMap parts = readContainer(bytes, projectVersion, {}).value().parts;
    change(parts);
    std::vector<PackedBlock> blocks;
    for (const auto &[name, content] : parts)
        blocks.push_back(packBlock(name, content));
    return containerBytes(version, blocks);
}

} // namespace autocuts::test
