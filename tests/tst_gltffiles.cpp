// glTF files as files: containers, buffers beside them, sessions, other formats, damage.
#include "model/io/files/savefile.h"
#include "model/io/gltf/gltfprimitive.h"
#include "model/io/gltf/gltfreader.h"
#include "model/io/gltf/gltfwriter.h"
#include "model/io/meshes/exportlosses.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectblocks.h"
#include "model/io/projects/projectfile.h"
#include "model/io/projects/projectmigration.h"
#include "model/io/projects/projectscene.h"
#include "support/gltffiles.h"

#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <csignal>
#include <random>

#ifdef Q_OS_UNIX
#include <sys/resource.h>
#endif

namespace tst_gltffiles {

using namespace autocuts;
using namespace gltffiles;
using namespace Qt::Literals::StringLiterals;

class TestGltfFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void containers_data();
    void containers();
    void savingAgainDoesNotGrow();
    void bufferFiles();
    void failedExportKeepsThePair();
    void foreignBufferFilesStay();
    void exportingInPlaceDoesNotGrow();
    void imagesOfAnotherFolder();
    void sessions();
    void everyDamagedPartIsSaid();
    void otherFormats();
    void badFiles_data();
    void badFiles();
    void stopping();
    void mutations();
    void realFiles();
};

void TestGltfFiles::containers_data()
{
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    for (const QString &from : {u"glb"_s, u"gltf"_s, u"gltf with bin"_s}) {
        for (const QString &to : {u"glb"_s, u"gltf"_s})
            QTest::addRow("%s to %s", qPrintable(from), qPrintable(to)) << from << to;
    }
}

void TestGltfFiles::containers()
{
    QFETCH(QString, from);
    QFETCH(QString, to);
    const QTemporaryDir folder;
    const FileBuilder file = manyAttributes();
    const QString path = folder.filePath(u"in."_s + from.split(u' ').first());
    const bool outer = from.endsWith("bin"_L1);
    QVERIFY(
        saveAtomically(path, from == "glb"_L1 ? file.glb() : file.text(outer ? "some%20data.bin" : "")).ok());
    if (outer)
        QVERIFY(saveAtomically(folder.filePath(u"some data.bin"_s), file.buffer).ok());
    Result<Scene> scene = readMesh(path);
    QVERIFY(scene.ok());

    const QString same = folder.filePath(u"same."_s + to);
    QVERIFY(writeMesh(scene.value(), same).ok());
    const bool sameContainer = from.startsWith(to + u' ') || from == to;
    QCOMPARE(contentOf(same) == contentOf(path), sameContainer);
    QCOMPARE(uvDifference(scene.value(), readMesh(same).value()), 0.0);

    scene->uvSets[0].uv = seamyUv(*scene->mesh);
    const QString changed = folder.filePath(u"changed."_s + to);
    QVERIFY(writeMesh(scene.value(), changed).ok());
    QVERIFY(uvDifference(scene.value(), readMesh(changed).value()) <= 1e-6);
    QCOMPARE(QFile::exists(folder.filePath(u"changed.bin"_s)), outer && to == "gltf"_L1);
    QCOMPARE(contentOf(changed).startsWith("glTF"), to == "glb"_L1);
    if (from != "glb"_L1 && to == "gltf"_L1)
        QVERIFY(contentOf(changed).startsWith("{\n  \"asset\""));
}

void TestGltfFiles::savingAgainDoesNotGrow()
{
    Scene scene = parsed(morphed().glb());
    scene.uvSets[0].uv = seamyUv(*scene.mesh);
    const QByteArray first = written(scene);
    Scene again = parsed(first);
    again.uvSets[0].uv *= 0.5;
    again.uvSets[0].uv.row(5) << 7, 7;
    const QByteArray second = written(again);
    QVERIFY(second.size() < first.size() + 300);
    QCOMPARE(differenceOf({first, {}}, {second, {}}), QString());
    QVERIFY(uvDifference(again, parsed(second)) < 1e-6);
}

void TestGltfFiles::bufferFiles()
{
    const QTemporaryDir folder;
    FileBuilder file = grid();
    const QString path = folder.filePath(u"in.gltf"_s);
    // A second buffer that has the name which the first would get.
    Json json = Json::parse(file.text("in.bin").toStdString());
    json["buffers"].push_back({{"byteLength", 4}, {"uri", "out.bin"}});
    QVERIFY(saveAtomically(path, jsonText(json, {})).ok());
    QVERIFY(saveAtomically(folder.filePath(u"in.bin"_s), file.buffer).ok());
    QVERIFY(saveAtomically(folder.filePath(u"out.bin"_s), QByteArrayView("kept")).ok());
    Result<Scene> scene = readMesh(path);
    QVERIFY(scene.ok());
    scene->uvSets[0].uv = seamyUv(*scene->mesh);
    QVERIFY(writeMesh(scene.value(), folder.filePath(u"out.gltf"_s)).ok());
    QCOMPARE(contentOf(folder.filePath(u"out.bin"_s)), QByteArray("kept"));
    QCOMPARE(contentOf(folder.filePath(u"in.bin"_s)), file.buffer);
    QVERIFY(uvDifference(scene.value(), readMesh(folder.filePath(u"out.gltf"_s)).value()) < 1e-6);

    // Over itself.
    QVERIFY(writeMesh(scene.value(), path).ok());
    QVERIFY(uvDifference(scene.value(), readMesh(path).value()) < 1e-6);
}

void TestGltfFiles::failedExportKeepsThePair()
{
#ifdef Q_OS_UNIX
    const QTemporaryDir folder;
    FileBuilder file = grid();
    file.json["extras"] = std::string(200000, 'x'); // so that only the .gltf file is too large
    const QString path = folder.filePath(u"in.gltf"_s);
    QVERIFY(saveAtomically(path, file.text("in.bin")).ok());
    QVERIFY(saveAtomically(folder.filePath(u"in.bin"_s), file.buffer).ok());
    Result<Scene> scene = readMesh(path);
    QVERIFY(scene.ok());
    const UvMatrix before = scene->uvSets[0].uv;
    scene->uvSets[0].uv = seamyUv(*scene->mesh);

    std::signal(SIGXFSZ, SIG_IGN);
    rlimit usual{};
    getrlimit(RLIMIT_FSIZE, &usual);
    rlimit small = usual;
    small.rlim_cur = 100000;
    setrlimit(RLIMIT_FSIZE, &small);
    const Result<Done> written = writeMesh(scene.value(), path);
    setrlimit(RLIMIT_FSIZE, &usual);

    QVERIFY(!written.ok());
    QCOMPARE(contentOf(path), file.text("in.bin"));
    QCOMPARE(contentOf(folder.filePath(u"in.bin"_s)), file.buffer);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden),
             QStringList({u"in.bin"_s, u"in.gltf"_s}));
    QVERIFY((readMesh(path)->uvSets[0].uv - before).cwiseAbs().maxCoeff() == 0);
#endif
}

void TestGltfFiles::foreignBufferFilesStay()
{
    const QTemporaryDir folder;
    const FileBuilder file = grid();
    const QString path = folder.filePath(u"in.gltf"_s), out = folder.filePath(u"model.gltf"_s);
    QVERIFY(saveAtomically(path, file.text("in.bin")).ok());
    QVERIFY(saveAtomically(folder.filePath(u"in.bin"_s), file.buffer).ok());
    QVERIFY(saveAtomically(folder.filePath(u"model.bin"_s), QByteArrayView("foreign")).ok());
    Result<Scene> scene = readMesh(path);
    QVERIFY(scene.ok());
    // Unchanged, it shares the buffer of the input.
    const QString twin = folder.filePath(u"twin.gltf"_s);
    QVERIFY(writeMesh(scene.value(), twin).ok());
    scene->uvSets[0].uv = seamyUv(*scene->mesh);
    for (int i = 0; i < 2; ++i) {
        QVERIFY(writeMesh(scene.value(), out).ok());
        QCOMPARE(contentOf(folder.filePath(u"model.bin"_s)), QByteArray("foreign"));
        QVERIFY(uvDifference(scene.value(), readMesh(out).value()) < 1e-6);
    }
    // A buffer that another file names stays, too.
    QVERIFY(writeMesh(scene.value(), path).ok());
    QCOMPARE(contentOf(folder.filePath(u"in.bin"_s)), file.buffer);
    QVERIFY(readMesh(twin).ok());
}

void TestGltfFiles::exportingInPlaceDoesNotGrow()
{
    const QTemporaryDir folder;
    const FileBuilder file = grid();
    const QString path = folder.filePath(u"in.gltf"_s);
    QVERIFY(saveAtomically(path, file.text("in.bin")).ok());
    QVERIFY(saveAtomically(folder.filePath(u"in.bin"_s), file.buffer).ok());
    std::vector<qint64> sizes;
    for (int i = 0; i < 6; ++i) {
        Result<Scene> scene = readMesh(path);
        QVERIFY(scene.ok());
        scene->uvSets[0].uv = seamyUv(*scene->mesh) * (1 + i);
        QVERIFY(writeMesh(scene.value(), path).ok());
        QVERIFY(uvDifference(scene.value(), readMesh(path).value()) < 1e-5);
        // The file that came with the model stays: a model of another folder may name it.
        QCOMPARE(contentOf(folder.filePath(u"in.bin"_s)), file.buffer);
        const QFileInfoList bins = QDir(folder.path()).entryInfoList({u"in-*.bin"_s}, QDir::Files);
        QCOMPARE(bins.size(), 1);
        sizes.push_back(bins.front().size());
    }
    QCOMPARE(sizes.back(), sizes[1]);
}

void TestGltfFiles::imagesOfAnotherFolder()
{
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath(u"a"_s) && QDir(folder.path()).mkpath(u"b"_s));
    FileBuilder file = grid();
    file.json["images"] = {{{"uri", "my%20picture.png"}}, {{"uri", "data:image/png;base64,AAAA"}}};
    const QString path = folder.filePath(u"a/in.gltf"_s);
    QVERIFY(saveAtomically(path, file.text("in.bin")).ok());
    QVERIFY(saveAtomically(folder.filePath(u"a/in.bin"_s), file.buffer).ok());
    const Result<Scene> scene = readMesh(path);
    QVERIFY(scene.ok());
    QVERIFY(writeMesh(scene.value(), folder.filePath(u"b/out.gltf"_s)).ok());
    QCOMPARE(contentOf(folder.filePath(u"b/out.bin"_s)), file.buffer);
    GltfFile out{contentOf(folder.filePath(u"b/out.gltf"_s)), {{"out.bin", file.buffer}}};
    const Json images = openGltf(out).json["images"];
    QCOMPARE(QByteArray::fromStdString(images[0]["uri"]), QByteArray("../a/my%20picture.png"));
    QCOMPARE(QByteArray::fromStdString(images[1]["uri"]), QByteArray("data:image/png;base64,AAAA"));
}

void TestGltfFiles::sessions()
{
    const QTemporaryDir folder;
    const FileBuilder file = skinned();
    const QString path = folder.filePath(u"in.gltf"_s);
    QVERIFY(saveAtomically(path, file.text("in.bin")).ok());
    QVERIFY(saveAtomically(folder.filePath(u"in.bin"_s), file.buffer).ok());
    const DocumentState state = DocumentState::initial(readMesh(path).value());
    QVERIFY(QFile::remove(path) && QFile::remove(folder.filePath(u"in.bin"_s)));
    const QString session = folder.filePath(u"a.acproj"_s);
    QVERIFY(saveProject(state, {}, session).ok());
    Result<LoadedProject> project = loadProject(session);
    QVERIFY2(project.ok(), project.ok() ? "" : qPrintable(project.error().toString()));
    Scene &scene = project->state.scene;
    QVERIFY(sourceOf<GltfSource>(scene));
    QCOMPARE(scene.path, path);
    QVERIFY(writeMesh(scene, path).ok());
    QCOMPARE(contentOf(path), file.text("in.bin"));
    QCOMPARE(contentOf(folder.filePath(u"in.bin"_s)), file.buffer);

    // A made-up session names no file that is written.
    Result<Scene> hidden =
        parseGltf({file.text(".bashrc"), {{".bashrc", file.buffer}}}, folder.filePath(u"free/in.gltf"_s));
    QVERIFY(hidden.ok() && QDir(folder.path()).mkdir(u"free"_s));
    QVERIFY(writeMesh(hidden.value(), hidden->path).ok());
    QVERIFY(!QFile::exists(folder.filePath(u"free/.bashrc"_s)));
    QCOMPARE(contentOf(folder.filePath(u"free/in.bin"_s)), file.buffer);
    QVERIFY(readMesh(hidden->path).ok());

    // Nor does it write outside of the folder.
    const QString outside = folder.filePath(u"outside.bin"_s);
    QVERIFY(QDir(folder.path()).mkdir(u"inner"_s));
    Result<Scene> sly = parseGltf({file.text("../outside.bin"), {{"../outside.bin", file.buffer}}},
                                  folder.filePath(u"inner/in.gltf"_s));
    QVERIFY(sly.ok() && writeMesh(sly.value(), sly->path).ok());
    QVERIFY(!QFile::exists(outside) && readMesh(sly->path).ok());

    // Without its glTF file, it still holds the polygons.
    PartMap parts = scenePartsOf(state.scene);
    parts["gltf"].truncate(300);
    QStringList lost;
    const Result<Scene> partly = readSceneParts(parts, session, lost);
    QVERIFY(partly.ok() && !partly->source);
    QCOMPARE(lost, QStringList{u"the glTF file"_s});
    parts = scenePartsOf(state.scene);
    parts.erase("polygons");
    QVERIFY(sourceOf<GltfSource>(readSceneParts(parts, session, lost).value()));
}

//! Also the polygons, which are in the glTF file as well.
void TestGltfFiles::everyDamagedPartIsSaid()
{
    Result<Scene> scene = parseGltf({grid().glb(), {}}, u"in.glb"_s);
    DocumentState state = DocumentState::initial(std::move(scene).value());
    state.texelWeights.assign(std::size_t(state.scene.mesh->faceCount()), 0.5);
    const PartMap parts = readContainer(ProjectWriter().bytes(state, {}), projectVersion, {}).value().parts;
    QVERIFY(parts.contains("gltf") && parts.contains("polygons"));
    for (const auto &[hurt, ignored] : parts) {
        std::vector<PackedBlock> blocks;
        for (const auto &[name, content] : parts) {
            blocks.push_back(packBlock(name, content));
            if (name == hurt)
                blocks.back().checksum[0] = char(blocks.back().checksum[0] ^ 1);
        }
        const Result<LoadedProject> loaded = parseProject(containerBytes(projectVersion, blocks), {});
        QVERIFY2(loaded.ok() && !loaded->warnings.isEmpty(), hurt.constData());
    }
}

void TestGltfFiles::otherFormats()
{
    const QTemporaryDir folder;
    Scene scene = parsed(skinned().glb());
    scene.uvSets[0].uv = seamyUv(*scene.mesh);
    const QString path = folder.filePath(u"out.dae"_s);
    QVERIFY(writeMesh(scene, path).ok());
    QVERIFY(contentOf(path).contains("<skin"));
    const Result<Scene> again = readMesh(path);
    QVERIFY(again.ok());
    QCOMPARE(again->mesh->faceCount(), scene.mesh->faceCount());
    QVERIFY((again->uvSets.at(0).uv - scene.uvSets[0].uv).cwiseAbs().maxCoeff() < 1e-5);
    QVERIFY(exportLosses(scene, u"ply"_s).join(u' ').contains("bones and animations are lost"_L1));
    QVERIFY(exportLosses(parsed(morphed().glb()), u"dae"_s).join(u' ').contains("morph targets"_L1));
    // Corners that start elsewhere, and triangles that our reader leaves out.
    for (const FileBuilder &file : {strip(), fan(), instanced()}) {
        Scene other = parsed(file.glb());
        other.uvSets[0].uv = seamyUv(*other.mesh);
        QVERIFY(writeMesh(other, path).ok());
        const Result<Scene> read = readMesh(path);
        QVERIFY(read.ok());
        QVERIFY(read->uvSets.at(0).uv.array().isFinite().all());
        QVERIFY(std::abs(read->uvSets[0].uv.maxCoeff() - other.uvSets[0].uv.maxCoeff()) < 1e-5);
    }
}

void TestGltfFiles::badFiles_data()
{
    QTest::addColumn<QByteArray>("bytes");
    const auto row = [](const char *name, const std::function<void(FileBuilder &)> &change) {
        FileBuilder file = grid();
        change(file);
        QTest::newRow(name) << file.glb();
    };
    const auto accessor = [](FileBuilder &file, int number) -> Json & {
        return file.json["accessors"][number];
    };
    row("huge count", [&](FileBuilder &f) { accessor(f, 0)["count"] = 4000000000; });
    row("huge count without data", [&](FileBuilder &f) {
        accessor(f, 0)["count"] = 200000000;
        accessor(f, 0).erase("bufferView");
    });
    row("negative offset", [&](FileBuilder &f) { accessor(f, 0)["byteOffset"] = -4; });
    row("overflowing offset", [&](FileBuilder &f) { accessor(f, 0)["byteOffset"] = 0xFFFFFFFFFFFFFFFE; });
    row("stride", [&](FileBuilder &f) { f.json["bufferViews"][0]["byteStride"] = 1; });
    row("view beyond the buffer", [&](FileBuilder &f) { f.json["bufferViews"][0]["byteLength"] = 1 << 30; });
    row("no such view", [&](FileBuilder &f) { accessor(f, 0)["bufferView"] = 77; });
    row("no such buffer", [&](FileBuilder &f) { f.json["bufferViews"][0]["buffer"] = 2; });
    row("no such accessor", [&](FileBuilder &f) { f.primitive()["indices"] = 99; });
    row("no such mesh", [&](FileBuilder &f) { f.json["nodes"][0]["mesh"] = 5; });
    row("no such node", [&](FileBuilder &f) { f.json["scenes"][0]["nodes"] = {5}; });
    row("component type", [&](FileBuilder &f) { accessor(f, 0)["componentType"] = 1; });
    row("type", [&](FileBuilder &f) { accessor(f, 0)["type"] = "VEC9"; });
    row("positions of two numbers", [&](FileBuilder &f) { f.primitive()["attributes"]["POSITION"] = 1; });
    row("counts differ", [&](FileBuilder &f) { accessor(f, 1)["count"] = 3; });
    row("no positions", [&](FileBuilder &f) { f.primitive()["attributes"].erase("POSITION"); });
    row("all indices wrong", [&](FileBuilder &f) { accessor(f, 0)["count"] = accessor(f, 1)["count"] = 0; });
    row("infinite position", [&](FileBuilder &f) {
        const float infinite = std::numeric_limits<float>::infinity();
        std::memcpy(f.buffer.data(), &infinite, 4);
    });
    row("infinite transform", [&](FileBuilder &f) { f.json["nodes"][0]["scale"] = {1e300, 1e300, 1e300}; });
    row("sparse place", [&](FileBuilder &f) {
        const int view = f.addView(QByteArray(12, '\x77'));
        accessor(f, 0)["sparse"] = {{"count", 1},
                                    {"indices", {{"bufferView", view}, {"componentType", 5121}}},
                                    {"values", {{"bufferView", view}}}};
    });
    row("draco", [&](FileBuilder &f) {
        f.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0},
                                                                     {"attributes", {{"POSITION", 0}}}};
    });
    row("meshopt", [&](FileBuilder &f) {
        f.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {
            {"buffer", 0}, {"byteLength", 20}, {"byteStride", 12}, {"mode", "ATTRIBUTES"}, {"count", 25}};
    });
    row("meshopt, huge", [&](FileBuilder &f) {
        f.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                                             {"byteLength", 20},
                                                                             {"byteStride", 12},
                                                                             {"mode", "ATTRIBUTES"},
                                                                             {"count", 4000000000}};
    });
    row("unknown compression",
        [&](FileBuilder &f) { f.json["extensionsRequired"] = {"X_mesh_compression"}; });
    QTest::newRow("buffer elsewhere") << grid().text("/etc/passwd");
    QTest::newRow("buffer missing") << grid().text("missing.bin");
    QTest::newRow("nested deeply") << "{\"a\":" + QByteArray("[").repeated(100000) +
                                          QByteArray("]").repeated(100000) + "}";
    QTest::newRow("cut off") << grid().glb().first(200);
    QTest::newRow("no JSON") << QByteArray("{\"asset\":");
    QTest::newRow("an array") << QByteArray("[]");
    QTest::newRow("header only") << grid().glb().first(12);
}

void TestGltfFiles::badFiles()
{
    QFETCH(QByteArray, bytes);
    const Result<Scene> scene = parseGltf({bytes, {}}, u"bad.glb"_s);
    QVERIFY(!scene.ok());
    QCOMPARE(scene.error().file, u"bad.glb"_s);
    QVERIFY(!scene.error().message.isEmpty() && !scene.error().remedy.isEmpty());
    QVERIFY(!scene.error().message.contains(u'\n'));
}

void TestGltfFiles::stopping()
{
    const std::atomic<bool> stop = true;
    const Result<Scene> scene = parseGltf({grid().glb(), {}}, u"a.glb"_s, &stop);
    QVERIFY(!scene.ok());
    QVERIFY(scene.error().message.contains("cancelled"_L1));
}

//! Overwrites, removes or doubles some bytes.
void damage(QByteArray &bytes, std::mt19937 &random)
{
    const auto below = [&](qsizetype n) {
        return static_cast<qsizetype>(random() % static_cast<std::size_t>(n));
    };
    for (auto changes = 1 + below(4); changes > 0; --changes) {
        const qsizetype at = below(bytes.size());
        const qsizetype size = 1 + below(std::min<qsizetype>(8, bytes.size() - at));
        switch (below(4)) {
        case 0:
            bytes[at] = static_cast<char>(below(256));
            break;
        case 1: // another digit makes another number
            bytes[at] = static_cast<char>('0' + below(10));
            break;
        case 2:
            bytes.insert(at, bytes.mid(at, size));
            break;
        default:
            bytes.remove(at, size);
        }
    }
}

void TestGltfFiles::mutations()
{
    std::mt19937 random(1);
    const QList<QByteArray> seeds{manyAttributes().glb(), morphed().glb(), skinned().text(),
                                  strip().glb(),          shared().text(), instanced().text()};
    int opened = 0;
    for (int i = 0; i < 3000; ++i) {
        QByteArray bytes = seeds[i % seeds.size()];
        damage(bytes, random);
        Result<Scene> scene = parseGltf({bytes, {}}, u"/nowhere/damaged.glb"_s);
        if (!scene) {
            QVERIFY(!scene.error().message.isEmpty());
            continue;
        }
        ++opened;
        QCOMPARE(QString::fromStdString(scene->mesh->validate()), QString());
        for (UvSet &set : scene->uvSets)
            set.uv = seamyUv(*scene->mesh);
        if (!sourceOf<GltfSource>(scene.value()))
            continue;
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"out.glb"_s);
        if (writeMesh(scene.value(), path))
            QVERIFY2(readMesh(path).ok(), qPrintable(QString::number(i)));
    }
    QVERIFY(opened > 300);
}

void TestGltfFiles::realFiles()
{
    QStringList files;
    const QByteArray meshes = qgetenv("AUTOCUTS_MESHES");
    const QString shared = meshes.isEmpty() ? QStringLiteral(AUTOCUTS_SOURCE_DIR "/../shared/meshes")
                                            : QString::fromLocal8Bit(meshes);
    for (const QString &folder : {shared + "/gltf"_L1, u"/usr/share/assimp/models/glTF2"_s}) {
        QDirIterator walk(folder, {u"*.gltf"_s, u"*.glb"_s}, QDir::Files, QDirIterator::Subdirectories);
        while (walk.hasNext())
            files << walk.next();
    }
    int changed = 0;
    for (const QString &path : files) {
        Result<Scene> scene = readMesh(path);
        if (!scene || scene->mesh->faceCount() > 20000)
            continue;
        const QTemporaryDir folder;
        const bool binary = path.endsWith(".glb"_L1, Qt::CaseInsensitive);
        const QString same = folder.filePath(binary ? u"a.glb"_s : u"a.gltf"_s);
        QVERIFY2(writeMesh(scene.value(), same).ok(), qPrintable(path));
        if (binary)
            QVERIFY2(contentOf(same) == contentOf(path), qPrintable(path));
        if (scene->uvSets.empty())
            scene->uvSets = {{u"UVMap"_s, {}}};
        scene->uvSets[0].uv = seamyUv(*scene->mesh);
        const QByteArray out = written(scene.value());
        const Scene again = parsed(out);
        QCOMPARE(again.mesh->faceCount(), scene->mesh->faceCount());
        if (sourceOf<GltfSource>(scene.value())->contents.instances ||
            sourceOf<GltfSource>(scene.value())->compressed)
            continue;
        ++changed;
        QVERIFY2(uvDifference(scene.value(), again) < 1e-4, qPrintable(path));
        QCOMPARE(path + differenceOf(sourceOf<GltfSource>(scene.value())->file, {out, {}}), path);
    }
    if (changed == 0)
        QSKIP("there are no glTF files");
}

QTEST_GUILESS_MAIN(TestGltfFiles)

} // namespace tst_gltffiles

#include "tst_gltffiles.moc"
