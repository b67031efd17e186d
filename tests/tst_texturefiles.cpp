// Textures that files name: OBJ, FBX, glTF and sessions; where they are looked for, and sets of tiles.
#include "model/document/documentstate.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/outputs/bakefiles.h"
#include "model/io/projects/projectfile.h"
#include "model/pictures/picturefiles.h"
#include "model/pictures/texturefiles.h"
#include "support/fbxfiles.h"
#include "support/gltffiles.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

namespace tst_texturefiles {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

const QByteArray picture("\x89PNG not really, but bytes");

const QByteArray obj = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                       "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 2/2\nusemtl c\nf 2/2 1/1 3/3\n";

//! A material with a texture, and what is behind it. \param content of the video; empty: no video
QByteArray fbxWithTexture(const fbxfiles::Kind &kind, const QByteArray &property, const QByteArray &content)
{
    using fbxfiles::Node;
    const auto name = [&](const QByteArray &cls, const QByteArray &text) {
        return kind.binary ? text + QByteArray("\0\1", 2) + cls : cls + "::" + text;
    };
    const QByteArray file("tex\\wood.png");
    Node objects{"Objects", {}, {}}, connections{"Connections", {}, {}};
    std::vector<Node> mesh = fbxfiles::quads({fbxfiles::uvElement(0, "map")});
    objects.children = {
        {"Geometry", {std::int64_t(1), name("Geometry", ""), QByteArray("Mesh")}, mesh},
        {"Model", {std::int64_t(2), name("Model", "m"), QByteArray("Mesh")}, {}, true},
        {"Material", {std::int64_t(3), name("Material", "paint"), QByteArray()}, {}, true},
        {"Texture",
         {std::int64_t(4), name("Texture", "t"), QByteArray()},
         {{"FileName", {QByteArray("C:\\far\\wood.png")}, {}}, {"RelativeFilename", {file}, {}}}}};
    const auto connect = [&](const char *type, std::int64_t from, std::int64_t to,
                             const QByteArray &to_property = {}) {
        Node node{"C", {QByteArray(type), from, to}, {}};
        if (!to_property.isEmpty())
            node.values.push_back(to_property);
        connections.children.push_back(node);
    };
    connect("OO", 1, 2);
    connect("OO", 2, 0);
    connect("OO", 3, 2);
    connect("OP", 4, 3, property);
    if (!content.isEmpty()) {
        objects.children.push_back({"Video",
                                    {std::int64_t(5), name("Video", "v"), QByteArray("Clip")},
                                    {{"Content", {kind.binary ? content : content.toBase64()}, {}}}});
        connect("OO", 5, 4);
    }
    return fbxfiles::file(kind, {objects, connections});
}

//! A file of version 6: two quads of a model with two textures. \param ids of the textures of the quads, or
//! one for both \param materials how many the model has: none or one
QByteArray oldFbx(bool binary, const std::vector<std::int32_t> &ids, int materials)
{
    using fbxfiles::Node;
    const fbxfiles::Kind kind{.binary = binary, .version = 6100};
    const auto name = [&](const QByteArray &cls, const QByteArray &text) {
        return binary ? text + QByteArray("\0\1", 2) + cls : cls + "::" + text;
    };
    Node objects{"Objects", {}, {}}, connections{"Connections", {}, {}};
    const auto connect = [&](const QByteArray &from, const QByteArray &to) {
        connections.children.push_back({"Connect", {QByteArray("OO"), from, to}, {}});
    };
    const std::vector<Node> mesh = fbxfiles::quads(
        {fbxfiles::uvElement(0, "map"),
         fbxfiles::layerElement("LayerElementTexture", 0, "", ids.size() == 1 ? "AllSame" : "ByPolygon",
                                "IndexToDirect", {{"TextureId", {ids}, {}}})});
    const QByteArray model = name("Model", "m");
    objects.children.push_back({"Model", {model, QByteArray("Mesh")}, mesh});
    connect(model, name("Model", "Scene"));
    if (materials > 0) {
        objects.children.push_back({"Material", {name("Material", "paint"), QByteArray()}, {}, true});
        connect(name("Material", "paint"), model);
    }
    for (const char *texture : {"wood", "iron"}) {
        objects.children.push_back({"Texture",
                                    {name("Texture", texture), QByteArray()},
                                    {{"RelativeFilename", {QByteArray(texture) + ".png"}, {}}}});
        connect(name("Texture", texture), model);
    }
    objects.children.push_back({"Video",
                                {name("Video", "v"), QByteArray("Clip")},
                                {{"Content", {binary ? picture : picture.toBase64()}, {}}}});
    connect(name("Video", "v"), name("Texture", "iron"));
    return fbxfiles::file(kind, {objects, connections});
}

bool write(const QString &path, const QByteArray &bytes = picture)
{
    QDir().mkpath(QFileInfo(path).path());
    return saveAtomically(path, bytes).ok();
}

} // namespace

class TestTextureFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void objNamesThem()
    {
        const QTemporaryDir folder;
        QVERIFY(write(folder.filePath(u"m.obj"_s), obj));
        QVERIFY(write(folder.filePath(u"m.mtl"_s),
                      "newmtl a\nKd 1 0 0\nmap_Kd -s 2 2 -bm 0.5 -clamp on my wood.png\r\n"
                      "newmtl b\nmap_Kd  maps/b.jpg\nmap_Kd second.png\nnewmtl c\nmap_Ks shine.png\n"));
        const Scene scene = readMesh(folder.filePath(u"m.obj"_s)).value();
        QCOMPARE(scene.materialTextures.size(), std::size_t(3));
        QCOMPARE(scene.materialTextures[0].file, u"my wood.png"_s);
        QCOMPARE(scene.materialTextures[1].file, u"maps/b.jpg"_s);
        QVERIFY(scene.materialTextures[2].isEmpty());
        // A session knows them, too.
        const DocumentState state = DocumentState::initial(scene);
        QVERIFY(saveProject(state, {}, folder.filePath(u"s.acproj"_s)).ok());
        QVERIFY(loadProject(folder.filePath(u"s.acproj"_s)).value().state.scene.materialTextures ==
                scene.materialTextures);
    }

    void gltfNamesOrHoldsThem()
    {
        const QTemporaryDir folder;
        gltffiles::FileBuilder file = gltffiles::grid();
        const int view = file.addView(picture);
        file.json["images"] = {{{"uri", "my%20wood.png"}},
                               {{"uri", "data:image/png;base64," + picture.toBase64().toStdString()}},
                               {{"bufferView", view}, {"mimeType", "image/png"}, {"name", "inside"}}};
        file.json["textures"] = {{{"source", 0}}, {{"source", 1}}, {{"source", 2}}, {{"source", 9}}};
        for (const int texture : {0, 1, 2, 2, 3, 7})
            file.json["materials"].push_back(
                {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
        file.json["materials"].push_back({{"name", "plain"}});
        file.primitive()["material"] = 2;
        const QString path = folder.filePath(u"m.glb"_s);
        QVERIFY(write(path, file.glb()));
        const Scene scene = readMesh(path).value();
        const std::vector<SceneTexture> &textures = scene.materialTextures;
        QCOMPARE(textures.size(), std::size_t(7));
        QCOMPARE(textures[0].file, u"my wood.png"_s);
        QVERIFY(textures[0].content.isEmpty());
        QCOMPARE(textures[1].content, picture);
        QCOMPARE(textures[2].content, picture);
        QCOMPARE(textures[2].file, u"inside"_s);
        QCOMPARE(textures[3].content.constData(), textures[2].content.constData()); // shared
        for (const std::size_t broken : {4, 5, 6})
            QVERIFY(textures[broken].isEmpty());
        QVERIFY(saveProject(DocumentState::initial(scene), {}, folder.filePath(u"s.acproj"_s)).ok());
        QVERIFY(loadProject(folder.filePath(u"s.acproj"_s)).value().state.scene.materialTextures == textures);
    }

    void fbxNamesOrHoldsThem_data()
    {
        QTest::addColumn<bool>("binary");
        QTest::addColumn<QByteArray>("property");
        QTest::addColumn<QByteArray>("content");
        for (const bool binary : {true, false}) {
            const char *kind = binary ? "binary" : "text";
            QTest::addRow("%s, named", kind) << binary << QByteArray("DiffuseColor") << QByteArray();
            QTest::addRow("%s, inside", kind) << binary << QByteArray("DiffuseColor") << picture;
            QTest::addRow("%s, Maya", kind) << binary << QByteArray("Maya|baseColor") << picture;
            QTest::addRow("%s, bump map", kind) << binary << QByteArray("NormalMap") << QByteArray();
        }
    }
    void fbxNamesOrHoldsThem()
    {
        QFETCH(bool, binary);
        QFETCH(QByteArray, property);
        QFETCH(QByteArray, content);
        const QTemporaryDir folder;
        fbxfiles::Kind kind;
        kind.binary = binary;
        const QString path = folder.filePath(u"m.fbx"_s);
        QVERIFY(write(path, fbxWithTexture(kind, property, content)));
        const Result<Scene> read = readMesh(path);
        QVERIFY2(read.ok(), read.ok() ? "" : qPrintable(read.error().toString()));
        const std::vector<SceneTexture> &textures = read->materialTextures;
        if (property == "NormalMap") {
            QVERIFY(textures.empty());
            return;
        }
        QCOMPARE(textures.size(), std::size_t(1));
        QCOMPARE(textures[0].file, u"tex\\wood.png"_s);
        QCOMPARE(textures[0].content, content);
        QVERIFY(saveProject(DocumentState::initial(read.value()), {}, folder.filePath(u"s.acproj"_s)).ok());
        QVERIFY(loadProject(folder.filePath(u"s.acproj"_s)).value().state.scene.materialTextures == textures);
    }

    void oldFbxHasThemOnModels_data()
    {
        QTest::addColumn<bool>("binary");
        QTest::addColumn<std::vector<int>>("ids");
        QTest::addColumn<int>("materials");
        QTest::addColumn<QStringList>("names"); // of the two faces: material and file
        for (const bool binary : {true, false}) {
            const auto add = [&](const char *what, const std::vector<int> &ids, int materials,
                                 const QStringList &names) {
                QTest::addRow("%s, %s", binary ? "binary" : "text", what)
                    << binary << ids << materials << names;
            };
            add("all same", {1}, 1, {u"paint iron.png"_s, u"paint iron.png"_s});
            add("by polygon", {0, 1}, 1, {u"paint wood.png"_s, u"paint_iron iron.png"_s});
            add("one plain", {0, -1}, 1, {u"paint wood.png"_s, u"paint_plain "_s});
            add("first plain", {-1, 0}, 1, {u"paint "_s, u"paint_wood wood.png"_s});
            add("damaged", {7, -5}, 1, {u"paint "_s, u"paint "_s});
            add("no material", {1, -1}, 0, {u"iron iron.png"_s, u""_s});
        }
    }
    void oldFbxHasThemOnModels()
    {
        QFETCH(bool, binary);
        QFETCH(std::vector<int>, ids);
        QFETCH(int, materials);
        QFETCH(QStringList, names);
        const Result<Scene> read = parseFbx(oldFbx(binary, ids, materials), u"m.fbx"_s);
        QVERIFY2(read.ok(), read.ok() ? "" : qPrintable(read.error().toString()));
        QStringList found;
        for (const int material : read->faceMaterial) {
            const auto m = static_cast<std::size_t>(material);
            const SceneTexture texture = material >= 0 && m < read->materialTextures.size()
                                             ? read->materialTextures[m]
                                             : SceneTexture();
            found << (material < 0 ? QString() : read->materialNames.at(m) + u' ' + texture.file);
            QCOMPARE(texture.content, texture.file == u"iron.png" ? picture : QByteArray());
        }
        QCOMPARE(found, names);
        QCOMPARE(read->materialColors.size(), read->materialNames.size());
    }

    void oldFbxFilesOfOthers_data()
    {
        QTest::addColumn<QStringList>("names"); // of the materials of faces, and their files
        QTest::newRow("maya_textured_cube_6100_ascii")
            << QStringList{u"phong1 textures\\checkerboard_diffuse.png"_s};
        QTest::newRow("maya_shared_textures_6100_ascii") << QStringList{
            u"Shared textures\\checkerboard_ambient.png"_s, u"Special textures\\tiny_clouds.png"_s};
        QTest::newRow("zbrush_d20_6100_ascii") << QStringList{u"PolyMesh3D1_ncl1_2 PolyMesh3D1_TXTR.tga"_s};
        QTest::newRow("zbrush_d20_6100_binary") << QStringList{u"PolyMesh3D1_ncl1_2 PolyMesh3D1_TXTR.tga"_s};
        QTest::newRow("maya_absolute_texture_6100_binary")
            << QStringList{u"lambert1 W:\\checkerboard_diffuse.png"_s};
    }
    void oldFbxFilesOfOthers()
    {
        QFETCH(QStringList, names);
        const QByteArray meshes = qgetenv("AUTOCUTS_MESHES");
        const QString folder = meshes.isEmpty() ? QStringLiteral(AUTOCUTS_SOURCE_DIR "/../shared/meshes")
                                                : QString::fromLocal8Bit(meshes);
        const QString path = folder + u"/fbx/"_s + QString::fromLatin1(QTest::currentDataTag()) + u".fbx"_s;
        if (!QFile::exists(path))
            QSKIP("the shared meshes are not there");
        const Result<Scene> read = readMesh(path);
        QVERIFY2(read.ok(), read.ok() ? "" : qPrintable(read.error().toString()));
        QStringList found;
        const std::vector<int> &used = read->faceMaterial;
        for (std::size_t m = 0; m < read->materialTextures.size(); ++m) {
            const bool isUsed = std::count(used.begin(), used.end(), static_cast<int>(m)) > 0;
            if (isUsed && !read->materialTextures[m].isEmpty())
                found << read->materialNames[m] + u' ' + read->materialTextures[m].file;
        }
        QCOMPARE(found, names);
    }

    void theyAreLookedForBesideTheModel()
    {
        const QTemporaryDir folder;
        const auto at = [&](const char *name) { return folder.filePath(QLatin1String(name)); };
        const QString model = at("job/model/m.obj");
        for (const char *name :
             {"outside.png", "job/shared/wood.png", "job/model/beside.png", "job/model/sub/inner.png",
              "job/model/textures/usual.png", "job/model/set.1001.png", "job/model/set.1002.png"})
            QVERIFY(write(at(name)));
        const auto found = [&](const char *named) {
            const QString path = findTexture(QString::fromLatin1(named), model);
            return path.isEmpty() ? QString() : QDir(folder.path()).relativeFilePath(path);
        };
        QCOMPARE(found("beside.png"), u"job/model/beside.png"_s);
        QCOMPARE(found("C:\\work\\beside.png"), u"job/model/beside.png"_s);
        QCOMPARE(found("/somewhere/else/usual.png"), u"job/model/textures/usual.png"_s);
        QCOMPARE(found("sub\\inner.png"), u"job/model/sub/inner.png"_s);
        QCOMPARE(found("../shared/wood.png"), u"job/shared/wood.png"_s);
        QCOMPARE(found("set.<UDIM>.png"), u"job/model/set.<UDIM>.png"_s);
        QCOMPARE(found("../../outside.png"), QString()); // not from elsewhere
        QCOMPARE(found(qPrintable(at("outside.png"))), QString());
        for (const char *nothing : {"", "gone.png", "..", "sub", "other.<UDIM>.png", "///"})
            QCOMPARE(found(nothing), QString());
    }

    void tilesMakeASet()
    {
        const QTemporaryDir folder;
        const auto at = [&](const char *name) { return folder.filePath(QLatin1String(name)); };
        for (const char *name : {"a.1001.png", "a.1002.png", "a.1011.png", "a.1500.png", "a.10011.png",
                                 "ab.1003.png", "a.1004.jpg", "b_1003.png", "photo.2024.png", "plain.png"})
            QVERIFY(write(at(name)));
        const auto tiles = [&](const char *name) {
            QList<int> numbers;
            for (const TextureTile &tile : textureTiles(at(name)))
                numbers << tile.tile;
            return numbers;
        };
        QCOMPARE(tiles("a.1001.png"), (QList<int>{1001, 1002, 1011}));
        QCOMPARE(tiles("a.1002.png"), (QList<int>{1001, 1002, 1011}));
        QCOMPARE(tiles("a.<UDIM>.png"), (QList<int>{1001, 1002, 1011, 1500}));
        QCOMPARE(tiles("b_1003.png"), QList<int>{1003});
        QCOMPARE(tiles("photo.2024.png"), QList<int>{0}); // one picture
        QCOMPARE(tiles("plain.png"), QList<int>{0});
        QCOMPARE(tiles("gone.png"), QList<int>());
        QCOMPARE(textureTiles(at("a.1001.png"))[1].path, at("a.1002.png"));
        // A folder is listed once for many textures.
        FolderNames folders;
        QCOMPARE(textureTiles(at("a.<UDIM>.png"), &folders).size(), std::size_t(4));
        QVERIFY(write(at("a.1005.png")));
        QCOMPARE(textureTiles(at("a.<UDIM>.png"), &folders).size(), std::size_t(4));
        QCOMPARE(textureTiles(at("a.<UDIM>.png")).size(), std::size_t(5));
        QCOMPARE(findTexture(u"a.<UDIM>.png"_s, at("m.obj"), &folders), at("a.<UDIM>.png"));
    }

    //! Thousands of materials may name one picture, however they spell it.
    void aPictureOfManyMaterialsIsReadOnce()
    {
        const QTemporaryDir folder;
        const auto at = [&](const char *name) { return folder.filePath(QLatin1String(name)); };
        for (const char *name : {"a.png", "b.png"})
            QVERIFY(writePicture(Picture(2, 2, 3), at(name), PictureDepth::Eight).ok());
        QVERIFY(saveAtomically(at("m.mtl"), "newmtl a\nmap_Kd a.png\nnewmtl b\nmap_Kd ./a.png\nnewmtl c\n"
                                            "map_Kd b.png\n")
                    .ok());
        QVERIFY(saveAtomically(at("m.obj"), obj).ok());
        DocumentState state;
        state.scene = readMesh(at("m.obj")).value();
        state.scene.materialNames.push_back(u"of no face"_s);
        state.scene.materialTextures.push_back({u"gone.png"_s, {}});
        QStringList missing;
        const std::optional<SurfaceTexture> colors = readBaseColors(state, missing);
        QVERIFY(colors);
        QCOMPARE(missing, QStringList());
        QCOMPARE(colors->ofMaterial.size(), std::size_t(5));
        QVERIFY(colors->ofMaterial[0].repeated);
        QCOMPARE(colors->ofMaterial[1].repeated, colors->ofMaterial[0].repeated);
        QVERIFY(colors->ofMaterial[2].repeated);
        QVERIFY(colors->ofMaterial[2].repeated != colors->ofMaterial[0].repeated);
        QVERIFY(!colors->ofMaterial[3].repeated);
    }
};

QTEST_GUILESS_MAIN(TestTextureFiles)

} // namespace tst_texturefiles

#include "tst_texturefiles.moc"
