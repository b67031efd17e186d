// The live link of the studio with other programs, over a real socket.
#include "commands/edittextures.h"
#include "commands/setseamstate.h"
#include "commands/setuvs.h"
#include "model/document/makesnapshot.h"
#include "model/samples/samples.h"
#include "support/linkedprogram.h"
#include "support/studiosession.h"
#include "views/control/files/filecontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"
#include "views/link/linkbutton.h"

#include <QRandomGenerator>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace autocuts;
using link::Message;
using test::LinkedProgram;
using test::meshMessage;
using test::patience;
using namespace Qt::Literals::StringLiterals;

namespace {

struct LinkedStudio : test::StudioSession
{
    QString place = folder.filePath(u"run"_s);

    LinkedStudio() { window.link().listen(place); }

    //! The numbers of edges depend on the positions.
    int pairOf(link::VertexPair edge)
    {
        return link::VertexPairs(document()->mesh()).edgePairs({edge}).at(0);
    }
    bool isCut(link::VertexPair edge)
    {
        const int pair = pairOf(edge);
        return document()->seams().edgeIs(pair, PairState::Cut);
    }
    void setCut(link::VertexPair edge, bool cut)
    {
        const int pair = pairOf(edge);
        pushCommand(std::make_unique<SetSeamState>(
            *document(), cut ? SetSeamState::Edit::Cut : SetSeamState::Edit::Clear,
            IndexRanges::fromSorted(std::vector{2 * pair, 2 * pair + 1})));
    }
};

Scene cube()
{
    Scene scene = makeSample(u"bumpycube"_s).value();
    scene.path = u"cube.blend"_s;
    if (scene.objectNames.empty())
        scene.objectNames = {u"Cube"_s};
    return scene;
}

//! The scene with its vertices moved a little.
Scene bent(Scene scene, double by)
{
    const MeshData &mesh = *scene.mesh;
    PositionMatrix positions = mesh.positions;
    positions.col(0) += by * positions.col(1).array().sin().matrix();
    scene.mesh = MeshData::build(positions, mesh.faceStart, mesh.cornerVertex, mesh.faceObject);
    return scene;
}

//! The scene without its last face.
Scene torn(Scene scene)
{
    const MeshData &mesh = *scene.mesh;
    std::vector<int> starts = mesh.faceStart, corners = mesh.cornerVertex, objects = mesh.faceObject;
    starts.pop_back();
    corners.resize(std::size_t(starts.back()));
    objects.pop_back();
    scene.mesh = MeshData::build(mesh.positions, starts, corners, objects);
    return scene;
}

link::VertexPair someEdge(const link::VertexPairs &edges, const MeshData &mesh, int number)
{
    std::vector<bool> chosen(mesh.edgePairs.size());
    chosen[std::size_t(number) % chosen.size()] = true;
    while (edges.names(chosen).empty()) { // a diagonal
        chosen.assign(chosen.size(), false);
        chosen[std::size_t(++number) % chosen.size()] = true;
    }
    return edges.names(chosen).front();
}

Message marks(int serial)
{
    Message message(u"marks"_s);
    message.set(u"serial"_s, serial);
    return message;
}

void addEdge(Message &message, const char *name, link::VertexPair edge)
{
    message.add(QString::fromLatin1(name), std::span<const int>(edge), 2);
}

QString how(const Message &taken)
{
    return taken.fields().value("how"_L1).toString();
}

} // namespace

class TestLiveLink : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aModelIsOpened()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        const Scene scene = cube();
        const link::VertexPairs edges(*scene.mesh);
        const link::VertexPair edge = someEdge(edges, *scene.mesh, 7);
        Message message = meshMessage(scene, 1, true);
        addEdge(message, "cuts", edge);
        const std::vector<int> pins{5}, faces{1, 3};
        const std::vector<double> pinUvs{.25, .5};
        message.add(u"pins"_s, std::span<const int>(pins));
        message.add(u"pinUvs"_s, std::span<const double>(pinUvs), 2);
        message.add(u"selection"_s, std::span<const int>(faces));
        QCOMPARE(how(program.hand(message)), u"opened"_s);
        QVERIFY(studio.document());
        QCOMPARE(studio.document()->mesh().faceCount(), scene.mesh->faceCount());
        QVERIFY(studio.isCut(edge));
        QCOMPARE(studio.document()->constraints().pins, (std::vector{UvPin{5, Vec2(.25, .5)}}));
        QCOMPARE(studio.document()->selection().faces, (QList{1, 3}));
        QVERIFY(!studio.context.workspace.isModified());
        QCOMPARE(test::placeIn(studio.place).value("model"_L1).toString(), u"cube.blend"_s);
        auto *button = studio.window.findChild<LinkButton *>();
        QVERIFY(button->isVisible());
        QVERIFY2(button->text().contains(u"Test"_s), qPrintable(button->text()));
        program.send("bye");
        QVERIFY(program.isLetGo());
        QTRY_VERIFY(!button->isVisible());
        QCOMPARE(studio.document()->mesh().faceCount(), scene.mesh->faceCount());
    }

    void marksGoBothWays()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        const Scene scene = cube();
        const link::VertexPairs edges(*scene.mesh);
        program.hand(meshMessage(scene, 1, true));
        const link::VertexPair a = someEdge(edges, *scene.mesh, 3), b = someEdge(edges, *scene.mesh, 30);
        Message message = marks(1);
        addEdge(message, "cuts", a);
        program.send(message);
        QTRY_VERIFY(studio.isCut(a));
        studio.setCut(b, true);
        const Message cut = program.waitFor("marks");
        QCOMPARE(cut.integers(u"cuts"_s, 2).value(), (std::vector<int>{b[0], b[1]}));
        QVERIFY(!cut.has(u"uncuts"_s));
        studio.document()->undoStack().undo();
        QCOMPARE(program.waitFor("marks").integers(u"uncuts"_s, 2).value(), (std::vector<int>{b[0], b[1]}));
        Selection selection;
        selection.faces = {4};
        studio.document()->setSelection(selection);
        QCOMPARE(program.waitFor("marks").integers(u"selection"_s).value(), std::vector{4});
        QVERIFY(studio.isCut(a));
        message = marks(1);
        addEdge(message, "uncuts", a);
        program.send(message);
        QTRY_VERIFY(!studio.isCut(a));
    }

    void texturesGoBothWays()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        const auto materials = [](const QString &color, const QString &normal) {
            return QJsonArray{
                QJsonObject{{u"name"_s, u"Wood"_s},
                            {u"textures"_s, QJsonObject{{u"baseColor"_s, color}, {u"normal"_s, normal}}}}};
        };
        Message mesh = meshMessage(cube(), 1, true);
        mesh.set(u"materials"_s, materials(u"/a.png"_s, u"/n.png"_s));
        QCOMPARE(how(program.hand(mesh)), u"opened"_s);
        const auto file = [&](TextureChannel channel) {
            return studio.document()->state().textureSet(0).at(channel).picture.file;
        };
        QCOMPARE(file(TextureChannel::BaseColor), u"/a.png"_s);
        Message other(u"textures"_s);
        other.set(u"serial"_s, 1);
        other.set(u"materials"_s, materials(u"/b.png"_s, u"/n.png"_s));
        program.send(other);
        QTRY_COMPARE(file(TextureChannel::BaseColor), u"/b.png"_s);
        QCOMPARE(file(TextureChannel::Normal), u"/n.png"_s);
        TextureSet chosen;
        chosen[TextureChannel::BaseColor].picture.file = u"/c.png"_s;
        pushCommand(EditTextures::ofMaterial(*studio.document(), 0, chosen));
        QCOMPARE(program.waitFor("textures").fields().value("materials"_L1).toArray(),
                 materials(u"/c.png"_s, u"/n.png"_s));
        // The same mesh again, with what the program has meanwhile: nothing changes.
        mesh = meshMessage(cube(), 2, false);
        mesh.set(u"materials"_s, materials(u"/c.png"_s, u"/n.png"_s));
        const int entries = studio.document()->undoStack().count();
        QCOMPARE(how(program.hand(mesh)), u"unchanged"_s);
        QCOMPARE(studio.document()->undoStack().count(), entries);
    }

    void mapsComeWhileSolving()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        program.want("live");
        program.hand(meshMessage(cube(), 1, true));
        studio.context.solver.run();
        Message maps;
        QTRY_VERIFY_WITH_TIMEOUT(!(maps = program.waitFor("maps")).type().isEmpty() &&
                                     std::isfinite(maps.numbers(u"uvs"_s, 2).value().at(0)),
                                 patience);
        QVERIFY(maps.fields().value("solving"_L1).toBool());
        studio.context.solver.pause();
        while (maps.fields().value("solving"_L1).toBool())
            maps = program.waitFor("maps");
        const UvMatrix &uv = studio.document()->uv();
        QCOMPARE(maps.numbers(u"uvs"_s, 2).value(), std::vector<double>(uv.data(), uv.data() + uv.size()));
        QVERIFY(!maps.integers(u"seams"_s, 2).value().empty());
    }

    void onPauseMapsWait()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        program.want("pause");
        program.hand(meshMessage(cube(), 1, true));
        studio.context.solver.run();
        QVERIFY(studio.runsTo(1));
        studio.context.solver.pause();
        QVERIFY(!program.waitFor("maps").fields().value("solving"_L1).toBool(true));
    }

    void onRequestNothingComesUnasked()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        program.want("request");
        const Scene scene = cube();
        const link::VertexPairs edges(*scene.mesh);
        QCOMPARE(how(program.hand(meshMessage(scene, 1, true))), u"opened"_s);
        studio.setCut(someEdge(edges, *scene.mesh, 3), true);
        QCOMPARE(how(program.hand(meshMessage(bent(scene, .1), 2, false))), u"relinked"_s);
        // What comes first is what was asked for.
        program.send("send");
        QCOMPARE(program.waitFor("maps").fields().value("serial"_L1).toInt(), 2);
        QVERIFY(program.heard.empty());
    }

    //! A solve goes on with another state of the model, and hand work stays; undo brings the state before
    //! back.
    void editsOfTheModelAreRelinked()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        program.want("live");
        const Scene scene = cube();
        const link::VertexPairs edges(*scene.mesh);
        program.hand(meshMessage(scene, 1, true));
        const link::VertexPair edge = someEdge(edges, *scene.mesh, 3);
        studio.setCut(edge, true);
        studio.context.solver.run();
        QVERIFY(studio.runsTo(1));
        QCOMPARE(how(program.hand(meshMessage(bent(scene, .1), 2, false))), u"relinked"_s);
        QCOMPARE(studio.document()->mesh().positions, bent(scene, .1).mesh->positions);
        QVERIFY(studio.isCut(edge));
        QTRY_VERIFY(studio.context.solver.isRunning() || studio.context.solver.status().converged);
        QCOMPARE(program.waitFor("maps").fields().value("serial"_L1).toInt(), 2);
        studio.context.solver.pause();
        QVERIFY(studio.solverRests());
        const Message lost = program.hand(meshMessage(torn(scene), 3, false));
        QCOMPARE(how(lost), u"relinked"_s);
        QVERIFY(!lost.fields().value("lost"_L1).toArray().isEmpty());
        QCOMPARE(studio.answers->unsavedAsked, 0);
        program.heard.clear();
        studio.document()->undoStack().undo();
        QCOMPARE(program.waitFor("left").fields().value("serial"_L1).toInt(), 3);
        QCOMPARE(studio.document()->mesh().faceCount(), scene.mesh->faceCount());
        studio.document()->undoStack().redo();
        program.send("send");
        QCOMPARE(program.waitFor("maps").fields().value("serial"_L1).toInt(), 3);
    }

    //! A drag in the other program hands over many states.
    void statesOfOneEditAreOneEntry()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        const Scene scene = cube();
        program.hand(meshMessage(scene, 1, true));
        UndoStack &history = studio.document()->undoStack();
        const int entries = history.count();
        for (int state = 1; state <= 3; ++state)
            QCOMPARE(how(program.hand(meshMessage(bent(scene, 0.1 * state), 1 + state, false))),
                     u"relinked"_s);
        QCOMPARE(history.count(), entries + 1);
        history.undo();
        QCOMPARE(studio.document()->mesh().positions, scene.mesh->positions);
        history.redo();
        QCOMPARE(studio.document()->mesh().positions, bent(scene, 0.1 * 3).mesh->positions);
        // What the artist does in between stays an entry of its own.
        studio.setCut(someEdge(link::VertexPairs(*scene.mesh), *scene.mesh, 3), true);
        QCOMPARE(how(program.hand(meshMessage(bent(scene, .4), 5, false))), u"relinked"_s);
        QCOMPARE(history.count(), entries + 3);
        // What is saved begins with the last state of the edit.
        JournalRecorder recorder(*studio.document());
        const int before = history.count();
        for (int state = 1; state <= 2; ++state)
            program.hand(meshMessage(bent(scene, 0.05 * state), 5 + state, false));
        QVERIFY(history.count() <= before + 1);
        studio.setCut(someEdge(link::VertexPairs(*scene.mesh), *scene.mesh, 30), true);
        const Result<std::unique_ptr<Document>> replayed = replay(recorder.journal());
        QVERIFY(replayed);
        QVERIFY(sameWork(replayed.value()->state(), studio.document()->state()));
    }

    void handWorkOfTheOtherProgramIsAnUndoableEdit()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        const Scene scene = cube();
        program.hand(meshMessage(scene, 1, true));
        QVERIFY(!hasUvs(*studio.document()));
        std::vector<double> uvs(std::size_t(2 * scene.mesh->cornerCount()));
        for (std::size_t i = 0; i < uvs.size(); ++i)
            uvs[i] = double(i % 97) / 97;
        Message message = meshMessage(scene, 2, false);
        message.set(u"uvSets"_s, QJsonArray{u"UVMap"_s});
        message.add(u"uvs0"_s, std::span<const double>(uvs), 2);
        QCOMPARE(how(program.hand(message)), u"unchanged"_s);
        const UvMatrix &uv = studio.document()->uv();
        QCOMPARE(std::vector<double>(uv.data(), uv.data() + uv.size()), uvs);
        studio.document()->undoStack().undo();
        QVERIFY(!hasUvs(*studio.document()));
    }

    void unsavedWorkIsAskedAbout()
    {
        LinkedStudio studio;
        const Scene scene = cube();
        const link::VertexPairs edges(*scene.mesh);
        LinkedProgram program(studio.place), other(studio.place);
        QVERIFY(program.enter(studio.place));
        QVERIFY(other.enter(studio.place));
        program.hand(meshMessage(scene, 1, true));
        const link::VertexPair edge = someEdge(edges, *scene.mesh, 3);
        studio.setCut(edge, true);
        Scene torus = makeSample(u"torus"_s).value();
        torus.path = u"torus.blend"_s;
        torus.objectNames = {u"Torus"_s};
        // An edit of another model takes nothing away; the user is not even asked.
        QCOMPARE(other.hand(meshMessage(torus, 1, false)).type(), u"refused"_s);
        QCOMPARE(studio.answers->unsavedAsked, 0);
        studio.answers->unsaved = Questions::Unsaved::Cancel;
        const Message refused = other.hand(meshMessage(torus, 2, true));
        QCOMPARE(refused.type(), u"refused"_s);
        QCOMPARE(refused.fields().value("serial"_L1).toInt(), 2);
        QCOMPARE(studio.answers->unsavedAsked, 1);
        QVERIFY(studio.isCut(edge));
        studio.answers->unsaved = Questions::Unsaved::Discard;
        QCOMPARE(how(other.hand(meshMessage(torus, 3, true))), u"opened"_s);
        QCOMPARE(program.waitFor("left").fields().value("model"_L1).toString(), u"torus.blend"_s);
        // Marks for the model that is gone change nothing.
        Message late = marks(1);
        addEdge(late, "cuts", edge);
        program.send(late);
        QCOMPARE(program.waitFor("refused").fields().value("serial"_L1).toInt(), 1);
        QVERIFY(!studio.context.workspace.isModified());
    }

    void aModelThatWasClosedStaysClosed()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        program.hand(meshMessage(cube(), 1, true));
        studio.context.files.close();
        QVERIFY(program.waitFor("left").fields().value("model"_L1).toString().isEmpty());
        QCOMPARE(program.hand(meshMessage(bent(cube(), .1), 2, false)).type(), u"refused"_s);
        QVERIFY(!studio.document());
        QCOMPARE(how(program.hand(meshMessage(cube(), 3, true))), u"opened"_s);
    }

    void strangersAreSentAway_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("wrong token") << LinkedProgram::hello(QString(64, u'a')).encoded();
        QTest::newRow("no token") << Message(u"hello"_s).encoded();
        QTest::newRow("no hello") << Message(u"send"_s).encoded();
        QTest::newRow("text") << QByteArray("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
        QTest::newRow("large") << meshMessage(cube(), 1, true).encoded();
    }
    void strangersAreSentAway()
    {
        QFETCH(QByteArray, bytes);
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        program.socket.write(bytes);
        QVERIFY(program.isLetGo());
        program.read();
        QCOMPARE(program.heard.size(), std::size_t(1));
        QCOMPARE(program.heard[0].type(), u"refused"_s);
        QVERIFY(!studio.document());
        QVERIFY(studio.window.link().clients().empty());
    }

    void anotherVersionIsToldWhy()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        program.send(LinkedProgram::hello(test::placeIn(studio.place).value("token"_L1).toString(),
                                          link::protocolVersion + 1));
        QVERIFY2(program.waitFor("refused").fields().value("reason"_L1).toString().contains(u"version"_s),
                 "no reason");
        QVERIFY(program.isLetGo());
    }

    //! Noise after the welcome, and programs that end in the middle of a message: others go on.
    void garbageEndsItsOwnLinkOnly()
    {
        LinkedStudio studio;
        const Scene scene = cube();
        const link::VertexPairs edges(*scene.mesh);
        LinkedProgram good(studio.place);
        QVERIFY(good.enter(studio.place));
        good.hand(meshMessage(scene, 1, true));
        const QByteArray mesh = meshMessage(scene, 1, false).encoded();
        QRandomGenerator random(7);
        for (int round = 0; round < 40; ++round) {
            LinkedProgram bad(studio.place);
            QVERIFY(bad.enter(studio.place));
            QByteArray bytes = mesh;
            for (int change = random.bounded(1, 40); change > 0; --change)
                bytes[random.bounded(round % 2 ? 600 : int(bytes.size()))] = char(random.generate());
            bad.socket.write(bytes.first(random.bounded(1, int(bytes.size()))));
            if (round % 4 == 0)
                bad.socket.flush();
            bad.socket.abort();
        }
        QTRY_COMPARE(studio.window.link().clients().size(), std::size_t(1));
        const link::VertexPair edge = someEdge(edges, *scene.mesh, 3);
        Message message = marks(1);
        addEdge(message, "cuts", edge);
        good.send(message);
        QTRY_VERIFY(studio.isCut(edge));
    }

    void preferencesEndAndBeginTheLink()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        const QString token = test::placeIn(studio.place).value("token"_L1).toString();
        PreferenceValues values = studio.preferences.values();
        values.letProgramsIn = false;
        studio.preferences.setValues(values);
        QVERIFY(program.isLetGo());
        QCOMPARE(program.heard.back().type(), u"bye"_s);
        QVERIFY(test::placeIn(studio.place).isEmpty());
        values.letProgramsIn = true;
        studio.preferences.setValues(values);
        QVERIFY(test::placeIn(studio.place).value("token"_L1).toString() != token);
        LinkedProgram again(studio.place);
        QVERIFY(again.enter(studio.place));
    }

    //! Both sides cut, free, pin, bend and select at once; afterwards both have the same.
    void manyRoundsOfEdits()
    {
        LinkedStudio studio;
        LinkedProgram program(studio.place);
        QVERIFY(program.enter(studio.place));
        program.want("live");
        Scene scene = cube();
        const link::VertexPairs edges(*scene.mesh);
        program.hand(meshMessage(scene, 1, true));
        studio.context.solver.run();
        link::Marks own;
        const auto hear = [&] {
            for (const Message &message : std::exchange(program.heard, {})) {
                if (message.type() == "marks"_L1)
                    own.apply(link::MarkChanges::read(message, int(scene.mesh->positions.rows()),
                                                      scene.mesh->cornerCount(), scene.mesh->faceCount())
                                  .value());
            }
        };
        std::vector<link::VertexPair> expected;
        int serial = 1;
        for (int round = 0; round < 50; ++round) {
            const link::VertexPair ours = someEdge(edges, *scene.mesh, 11 * round);
            const link::VertexPair theirs = someEdge(edges, *scene.mesh, 11 * round + 5);
            studio.setCut(ours, true);
            hear();
            link::MarkChanges changes;
            changes.cuts = {theirs};
            changes.faces = QList{round};
            Message message = marks(serial);
            changes.writeTo(message);
            own.apply(changes);
            program.send(message);
            expected.insert(expected.end(), {ours, theirs});
            if (round % 5 == 4) {
                QCoreApplication::processEvents();
                hear();
                Message mesh = meshMessage(bent(scene, .001 * round), ++serial, false);
                link::Marks().changesTo(own).writeTo(mesh);
                const Message answer = program.hand(mesh);
                QCOMPARE(how(answer), u"relinked"_s);
            }
        }
        std::ranges::sort(expected);
        expected.erase(std::ranges::unique(expected).begin(), expected.end());
        QTRY_VERIFY_WITH_TIMEOUT((hear(), own.cuts == expected), patience);
        std::vector<bool> cut(scene.mesh->edgePairs.size());
        for (std::size_t pair = 0; pair < cut.size(); ++pair)
            cut[pair] = studio.document()->seams().edgeIs(int(pair), PairState::Cut);
        QCOMPARE(link::VertexPairs(studio.document()->mesh()).names(cut), expected);
        QCOMPARE(studio.document()->mesh().positions, bent(scene, .049).mesh->positions);
        QTRY_VERIFY(studio.context.solver.isRunning() || studio.context.solver.status().converged);
        studio.context.solver.pauseAtOnce();
        QCOMPARE(studio.answers->errors, QStringList());
    }
};

QTEST_MAIN(TestLiveLink)
#include "tst_livelink.moc"
