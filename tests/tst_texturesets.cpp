// Texture sets: names of files, folders, what models say, sessions, relinking.
#include "commands/edittextures.h"
#include "model/document/documentstate.h"
#include "model/editing/relink.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "model/pictures/texturenames.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace tst_texturesets {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

using Channel = TextureChannel;

void put(const QString &path, const QByteArray &bytes = "x")
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

const QByteArray obj = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                       "usemtl wood\nf 1/1 2/2 3/3\nusemtl Steel.001\nf 1/1 3/3 2/2\n";

//! Roughness, metalness and occlusion are packed, as most glTF files have them.
const QByteArray gltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
"images":[{"uri":"orm.png"},{"uri":"n.png"},{"uri":"e.png"}],
"textures":[{"source":0},{"source":1},{"source":2}],
"materials":[{"name":"m","pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0},"roughnessFactor":0.5},
"occlusionTexture":{"index":0},"normalTexture":{"index":1,"scale":0.25},"emissiveTexture":{"index":2},
"emissiveFactor":[0.5,1,0.25],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":3}}}]})";

} // namespace

class TestTextureSets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesOfFiles_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("stem");
        QTest::addColumn<QString>("channels"); // channel number, component, flipped
        const auto add = [](const char *name, const char *stem, const char *channels) {
            QTest::newRow(name) << QString::fromLatin1(name) << QString::fromLatin1(stem)
                                << QString::fromLatin1(channels);
        };
        add("wood_BaseColor.png", "wood", "0 -1 0");
        add("wood_Base_Color.png", "wood", "0 -1 0");
        add("wood_Base color.1001.png", "wood", "0 -1 0");
        add("DefaultMaterial_Roughness.exr", "DefaultMaterial", "1 -1 0");
        add("a_b_Metallic.tga", "a_b", "2 -1 0");
        add("wood_nor_gl_4k.exr", "wood", "3 -1 0");
        add("wood_nor_dx_4k.png", "wood", "3 -1 1");
        add("Bricks_2K-JPG_NormalDX.jpg", "Bricks_2K_JPG", "3 -1 1");
        add("wood_Normal_OpenGL.png", "wood", "3 -1 0");
        add("wood_AO.png", "wood", "4 -1 0");
        add("wood_Mixed_AO.png", "wood", "4 -1 0");
        add("woodAmbientOcclusion.png", "wood", "4 -1 0");
        add("wood_Emissive.png", "wood", "5 -1 0");
        add("wood_disp_1k.png", "wood", "6 -1 0");
        add("wood_Height.tif", "wood", "6 -1 0");
        add("wood_OcclusionRoughnessMetallic.png", "wood", "1 1 0,2 2 0,4 0 0");
        add("wood_arm_2k.jpg", "wood", "1 1 0,2 2 0,4 0 0");
        add("Default_metalRoughness.jpg", "Default", "1 1 0,2 2 0");
        add("wood_Glossiness.png", "wood", "1 -1 1");
        add("wood_BaseColor_uv2.1001.png", "wood", "0 -1 0");
        add("albedo.png", "", "0 -1 0");
        add("holiday.png", "", "");
        add("render_2024.png", "", "");
    }
    void namesOfFiles()
    {
        QFETCH(QString, name);
        QFETCH(QString, stem);
        QFETCH(QString, channels);
        const std::optional<NamedTexture> found = textureOfName(name);
        QCOMPARE(found.has_value(), !channels.isEmpty());
        if (!found)
            return;
        QCOMPARE(found->stem, stem);
        QStringList parts;
        for (const auto &[channel, entry] : found->channels)
            parts << u"%1 %2 %3"_s.arg(int(channel)).arg(entry.component).arg(int(entry.flipped));
        QCOMPARE(parts.join(u','), channels);
        QCOMPARE(found->file.contains(u"<UDIM>"_s), name.contains(u"1001"_s));
    }

    void folders()
    {
        QTemporaryDir folder;
        for (const char *name :
             {"wood_BaseColor.1001.png", "wood_BaseColor.1002.png", "wood_NormalDX.png", "wood_NormalGL.png",
              "steel_001_ORM.png", "other_Roughness.png", "notes.txt"})
            put(folder.filePath(QLatin1StringView(name)));
        Scene scene;
        scene.materialNames = {u"wood"_s, u"Steel.001"_s, u"unused"_s};
        scene.faceMaterial = {0, 1};
        const FolderTextures found = texturesInFolder(folder.path(), scene);
        QCOMPARE(found.sets.size(), std::size_t(3)); // without a material, wood, steel
        QVERIFY(found.sets[0].empty());
        QCOMPARE(found.sets[1].size(), std::size_t(2));
        QCOMPARE(found.sets[1].at(Channel::BaseColor).picture.file,
                 folder.filePath(u"wood_BaseColor.<UDIM>.png"_s));
        QVERIFY(found.sets[1].at(Channel::Normal).picture.file.endsWith(u"GL.png"_s));
        QVERIFY(!found.sets[1].at(Channel::Normal).flipped);
        QCOMPARE(found.sets[2].at(Channel::Metalness).component, 2);
        QCOMPARE(found.pictures, 5);
        QCOMPARE(found.left, QStringList{u"other_Roughness.png"_s});

        // Names that fit no material go to all of them when there is one name only.
        scene.materialNames = {u"x"_s, u"y"_s};
        for (const QString &name : QDir(folder.path()).entryList({u"wood*"_s, u"steel*"_s}, QDir::Files))
            QFile::remove(folder.filePath(name));
        const FolderTextures all = texturesInFolder(folder.path(), scene);
        QCOMPARE(all.sets.size(), std::size_t(3));
        QCOMPARE(all.sets[1], all.sets[2]);
        scene.materialNames.clear();
        scene.faceMaterial.clear();
        QCOMPARE(texturesInFolder(folder.path(), scene).sets.size(), std::size_t(1));
    }

    void materialFiles()
    {
        QTemporaryDir folder;
        put(folder.filePath(u"m.obj"_s), obj);
        put(folder.filePath(u"m.mtl"_s),
            "newmtl wood\nmap_Kd c.png\nmap_Bump -bm 0.5 b.png\nmap_Pr r.png\n"
            "map_Pm -imfchan r m.png\nmap_Ke e.png\nnewmtl Steel.001\nPr 0.25\nnorm n.png\n");
        const auto scene = readMesh(folder.filePath(u"m.obj"_s));
        QVERIFY(scene.ok());
        const TextureSet wood = scene->fileSet(0), steel = scene->fileSet(1);
        QCOMPARE(wood.at(Channel::BaseColor).picture.file, u"c.png"_s);
        QCOMPARE(wood.at(Channel::Normal).picture.file, u"b.png"_s);
        QCOMPARE(wood.at(Channel::Roughness).picture.file, u"r.png"_s);
        QCOMPARE(wood.at(Channel::Metalness).picture.file, u"m.png"_s);
        QCOMPARE(wood.at(Channel::Emission).picture.file, u"e.png"_s);
        QVERIFY(steel.at(Channel::Roughness).picture.isEmpty());
        QCOMPARE(steel.at(Channel::Roughness).factor, 0.25);
        QCOMPARE(steel.at(Channel::Normal).picture.file, u"n.png"_s);
    }

    void packedInGltf()
    {
        QTemporaryDir folder;
        put(folder.filePath(u"m.gltf"_s), gltf);
        auto scene = readMesh(folder.filePath(u"m.gltf"_s));
        QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
        const TextureSet set = scene->fileSet(0);
        QCOMPARE(set.at(Channel::Occlusion).component, 0);
        QCOMPARE(set.at(Channel::Roughness).component, 1);
        QCOMPARE(set.at(Channel::Roughness).factor, 0.5);
        QCOMPARE(set.at(Channel::Metalness).component, 2);
        QCOMPARE(set.at(Channel::Metalness).picture, set.at(Channel::Occlusion).picture);
        QCOMPARE(set.at(Channel::Normal).factor, 0.25);
        QCOMPARE(set.at(Channel::Emission).factor, 3.0);
        // Sessions keep them, and what the user chose.
        DocumentState state = DocumentState::initial(std::move(scene).value());
        state.textureSets = {{},
                             {{Channel::Normal, {{}, -1, true, 0.5, true}},
                              {Channel::Height, {{u"/h.exr"_s, {}}, 3, false, 2, false}}}};
        QVERIFY(state.validate().isEmpty());
        QCOMPARE(state.textureSet(0).at(Channel::Normal).picture.file, u"n.png"_s);
        QVERIFY(state.textureSet(0).at(Channel::Normal).flipped);
        QVERIFY(saveProject(state, {}, folder.filePath(u"s.acproj"_s)).ok());
        const auto back = loadProject(folder.filePath(u"s.acproj"_s));
        QVERIFY(back.ok());
        QVERIFY(back->state == state);
        QCOMPARE(back->state.textureSets, state.textureSets);
    }

    void wrongOnesAreRefused()
    {
        QVERIFY(!validateTextureSets(std::vector<TextureSet>(3), 2).isEmpty());
        QVERIFY(!validateTextureSets({{{Channel::Height, {{}, 4}}}}, 2).isEmpty());
        QVERIFY(!validateTextureSets({{{Channel::Height, {{}, 0, false, std::nan("")}}}}, 2).isEmpty());
        const QCborArray good =
            toCbor(std::vector<TextureSet>{{{Channel::Height, {{u"a"_s, {}}, 2, true, 3}}}});
        QVERIFY(readTextureSets(good, 1).has_value());
        QVERIFY(!readTextureSets(good, 0).has_value());
        for (const auto &[key, value] : {std::pair(u"channel"_s, QCborValue(7)),
                                         {u"component"_s, QCborValue(9)},
                                         {u"factor"_s, QCborValue(1e300)}}) {
            QCborMap channel = good[0].toArray()[0].toMap();
            channel[key] = value;
            QCborArray channels, sets;
            channels.append(channel);
            sets.append(channels); // braces would mean a copy to one compiler, a list to the other
            QVERIFY2(!readTextureSets(sets, 1), qPrintable(key));
        }
    }
};

QTEST_GUILESS_MAIN(TestTextureSets)

} // namespace tst_texturesets

#include "tst_texturesets.moc"
