// The command line's bakes: its files and report, carried textures, and its mistakes.
#include "model/io/meshes/meshfile.h"
#include "model/pictures/picturefiles.h"
#include "solver/bake/bakemaps.h"
#include "support/cliruns.h"
#include "support/mappedmodels.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>

namespace tst_clibake {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::MappedModel;
using test::runInProcess;

namespace {

//! A box whose sides are islands.
MappedModel mappedBox(double turned = 0)
{
    return test::mapped(test::box(4), [turned](const Vec3 &p, const Vec3 &centre) {
        const Vec2 uv = test::boxMap()(p, centre);
        return turned == 0 ? uv : Vec2(1 - uv.y(), uv.x());
    });
}

Scene sceneOf(const MappedModel &model, const QString &name)
{
    Scene scene;
    scene.mesh = model.mesh;
    scene.objectNames = {name};
    scene.faceMaterial.assign(static_cast<std::size_t>(model.mesh->faceCount()), -1);
    if (model.uv.rows() > 0)
        scene.uvSets = {{u"UVMap"_s, model.uv}};
    return scene;
}

} // namespace

class TestCliBake : public QObject, private test::OwnFolder
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void everyMap();
    void otherUnits_data();
    void otherUnits();
    void depths_data();
    void depths();
    void namesArePaired();
    void aProposedCage();
    void aCageFile();
    void tilesAreFiles();
    void texturesAreCarried();
    void colorsOfTextures();
    void colorsOfVertices_data();
    void colorsOfVertices();
    void whatWasMissedIsSaid();
    void mistakes_data();
    void mistakes();
    void aFailureKeepsAllPictures();
    void aTimeLimitKeepsWhatIsFinished();
    void aTimeLimitEndsTheReading();
};

void TestCliBake::initTestCase()
{
    QVERIFY(writeMesh(sceneOf(mappedBox(), u"lid_low"_s), at("low.obj")).ok());
    QVERIFY(writeMesh(sceneOf(mappedBox(1), u"lid_low"_s), at("turned.obj")).ok());
    QVERIFY(writeMesh(sceneOf({test::box(9, Vec3(2.02, 2.02, 2.02)), UvMatrix(0, 2)}, u"Lid_high"_s),
                      at("high.obj"))
                .ok());
    QVERIFY(writeMesh(sceneOf({test::box(4, Vec3(2.2, 2.2, 2.2)), UvMatrix(0, 2)}, u"cage"_s), at("cage.obj"))
                .ok());
    QVERIFY(writeMesh(sceneOf({test::box(4), UvMatrix(0, 2)}, u"plain"_s), at("plain.obj")).ok());
    file("file.txt", "not a folder");
}

void TestCliBake::everyMap()
{
    QStringList words;
    for (const auto &map : bake::mapNames())
        words << QString::fromLatin1(map.first.data(), std::ssize(map.first));
    const test::CliRun run = runInProcess({u"bake"_s, at("low.obj"), u"--high"_s, at("high.obj"), u"-o"_s,
                                           at("maps"), u"--maps"_s, words.join(u','), u"--size"_s, u"64"_s,
                                           u"--rays"_s, u"8"_s, u"--report"_s, at("report.json")});
    QVERIFY2(run.code == 0, qPrintable(run.err));
    QVERIFY2(run.err.isEmpty(), qPrintable(run.err));
    const QJsonObject report = QJsonDocument::fromJson(test::readBytes(at("report.json"))).object();
    QCOMPARE(report.value(u"status"_s).toString(), u"done"_s);
    QCOMPARE(report.value(u"files"_s).toArray().size(), words.size());
    QCOMPARE(report.value(u"texels_missed"_s).toInt(-1), 0);
    QVERIFY(report.value(u"texels"_s).toInt() > 500);
    for (const QString &word : words) {
        const QString path = at("maps") + u"/low_"_s + word + u".png"_s;
        QVERIFY2(run.out.contains(path), qPrintable(path));
        const Result<Picture> picture = readPicture(path);
        QVERIFY2(picture.ok(), qPrintable(path));
        QCOMPARE(picture->width, 64);
        QCOMPARE(picture->height, 64);
    }
    // The high box is .01 away from the low one, in the middle of the sides.
    const Result<Picture> height = readPicture(at("maps/low_height.png"));
    const double expected = 0.5 + 0.5 * 0.01 / (0.02 * std::sqrt(12.0));
    QVERIFY(std::abs(height->at(12, 51)[0] - expected) < 0.01);
}

void TestCliBake::otherUnits_data()
{
    QTest::addColumn<QString>("format");
    QTest::addColumn<double>("factor");
    QTest::newRow("a hundred times as large") << u"obj"_s << 100.0;
    QTest::newRow("a hundredth") << u"obj"_s << 0.01;
    QTest::newRow("a hundred times, as FBX") << u"fbx"_s << 100.0;
    QTest::newRow("z up") << u"ply"_s << 1.0;
}

//! A detailed model in other units is found, baked as if it were in those of the model, and told.
void TestCliBake::otherUnits()
{
    QFETCH(QString, format);
    QFETCH(double, factor);
    const QString high = at("units.") + format;
    QVERIFY(
        writeMesh(sceneOf({test::box(9, factor * Vec3(2.02, 2.02, 2.02)), UvMatrix(0, 2)}, u"high"_s), high)
            .ok());
    const test::CliRun run =
        runInProcess({u"bake"_s, at("low.obj"), u"--high"_s, high, u"-o"_s, at("units"), u"--maps"_s,
                      u"height"_s, u"--size"_s, u"64"_s, u"--report"_s, at("units.json")});
    QVERIFY2(run.code == 0, qPrintable(run.err));
    QCOMPARE(run.err.contains(u"times"_s), factor != 1);
    const QJsonObject report = QJsonDocument::fromJson(test::readBytes(at("units.json"))).object();
    QCOMPARE(report.value(u"texels_missed"_s).toInt(-1), 0);
    const Result<Picture> height = readPicture(at("units/low_height.png"));
    QVERIFY(height.ok());
    QVERIFY(std::abs(height->at(12, 51)[0] - (0.5 + 0.5 * 0.01 / (0.02 * std::sqrt(12.0)))) < 0.01);
}

void TestCliBake::depths_data()
{
    QTest::addColumn<QString>("format");
    QTest::addColumn<QString>("bits");
    QTest::addColumn<double>("tolerance");
    QTest::newRow("png 8") << u"png"_s << u"8"_s << 0.5 / 255;
    QTest::newRow("png 16") << u"png"_s << u"16"_s << 0.5 / 65535;
    QTest::newRow("tif 16") << u"tif"_s << u"16"_s << 0.5 / 65535;
    QTest::newRow("tga") << u"tga"_s << u"8"_s << 0.5 / 255;
    QTest::newRow("exr 16") << u"exr"_s << u"16"_s << 0.001;
    QTest::newRow("exr 32") << u"exr"_s << u"32"_s << 1e-6;
}

void TestCliBake::depths()
{
    QFETCH(QString, format);
    QFETCH(QString, bits);
    QFETCH(double, tolerance);
    const test::CliRun run =
        runInProcess({u"bake"_s, at("low.obj"), u"-o"_s, at("depths"), u"--maps"_s, u"position"_s,
                      u"--size"_s, u"32"_s, u"--format"_s, format, u"--bits"_s, bits});
    QVERIFY2(run.code == 0, qPrintable(run.err));
    const Result<Picture> picture = readPicture(at("depths/low_position.") + format);
    QVERIFY2(picture.ok(), qPrintable(picture.ok() ? QString() : picture.error().toString()));
    // The middle of the texel in the first side's corner.
    const auto texel = picture->at(4, 27);
    const bool floats = format == u"exr"_s;
    bool found = false;
    for (int k = 0; k < 3; ++k)
        found |= std::abs(std::abs(floats ? texel[k] : 2 * texel[k] - 1) - 1) <= 2 * tolerance;
    QVERIFY(found);
}

void TestCliBake::namesArePaired()
{
    const QStringList bake{u"bake"_s,   at("low.obj"), u"-o"_s, at("named"),    u"--maps"_s,
                           u"height"_s, u"--size"_s,   u"32"_s, u"--by-name"_s, u"--high"_s};
    const test::CliRun paired = runInProcess(bake + QStringList{at("high.obj")});
    QVERIFY2(paired.code == 0 && paired.err.isEmpty(), qPrintable(paired.err));
    const test::CliRun alone = runInProcess(bake + QStringList{at("plain.obj")});
    QCOMPARE(alone.code, 0);
    QVERIFY2(alone.err.contains(u"belongs to: lid_low"_s), qPrintable(alone.err));
    QVERIFY(alone.err.contains(u"found nothing"_s));
}

//! Measured as in the studio, and named in the report.
void TestCliBake::aProposedCage()
{
    const auto report = [&](const QStringList &arguments) {
        const test::CliRun run = runInProcess(
            QStringList{u"bake"_s, at("low.obj"), u"--high"_s, at("high.obj"), u"-o"_s, at("proposed"),
                        u"--maps"_s, u"height"_s, u"--size"_s, u"64"_s, u"--report"_s, at("proposed.json")} +
            arguments);
        [&] { QVERIFY2(run.code == 0, qPrintable(run.err)); }();
        QJsonObject figures = QJsonDocument::fromJson(test::readBytes(at("proposed.json"))).object();
        figures.insert(u"said"_s, run.err);
        return figures;
    };
    QCOMPARE(report({}).value(u"cage"_s).toDouble(), 0.02);
    const QJsonObject measured = report({u"--cage"_s, u"auto"_s});
    QCOMPARE(measured.value(u"cage"_s).toDouble(), 0.0075); // the corners are .01 * sqrt(3) apart
    QCOMPARE(measured.value(u"texels_missed"_s).toInt(-1), 0);
    const Result<Picture> height = readPicture(at("proposed/low_height.png"));
    QVERIFY(std::abs(height->at(12, 51)[0] - (0.5 + 0.5 * 0.01 / (0.0075 * std::sqrt(12.0)))) < 0.01);
    const QJsonObject last = report({u"--cage"_s, u"auto"_s, u"--cage"_s, u"0.03"_s});
    QCOMPARE(last.value(u"cage"_s).toDouble(), 0.03);
    QVERIFY(!report({u"--cage-file"_s, at("cage.obj")}).contains(u"cage"_s));
    QVERIFY(writeMesh(sceneOf({test::box(4, Vec3(9, 9, 9)), UvMatrix(0, 2)}, u"far"_s), at("far.obj")).ok());
    const QJsonObject far = report({u"--cage"_s, u"auto"_s, u"--high"_s, at("far.obj")});
    QVERIFY(far.value(u"said"_s).toString().contains(u"nowhere near"_s));
    QCOMPARE(far.value(u"cage"_s).toDouble(), 0.02);
}

void TestCliBake::aCageFile()
{
    const QStringList bake{u"bake"_s,   at("low.obj"), u"-o"_s,     at("caged"), u"--high"_s, at("high.obj"),
                           u"--maps"_s, u"normal"_s,   u"--size"_s, u"32"_s,     u"--cage"_s, u"0.000001"_s};
    QVERIFY(runInProcess(bake).err.contains(u"found nothing"_s));
    const test::CliRun caged = runInProcess(bake + QStringList{u"--cage-file"_s, at("cage.obj")});
    QVERIFY2(caged.code == 0 && caged.err.isEmpty(), qPrintable(caged.err));
    const test::CliRun other = runInProcess(bake + QStringList{u"--cage-file"_s, at("high.obj")});
    QCOMPARE(other.code, 1);
    QVERIFY(other.err.contains(u"other faces than the model"_s));
}

void TestCliBake::tilesAreFiles()
{
    MappedModel model = mappedBox();
    const MeshData &mesh = *model.mesh;
    for (int c = mesh.cornerCount() / 2; c < mesh.cornerCount(); ++c)
        model.uv(c, 0) += 1; // three sides into the next tile
    QVERIFY(writeMesh(sceneOf(model, u"box"_s), at("tiles.obj")).ok());
    const test::CliRun run = runInProcess({u"bake"_s, at("tiles.obj"), u"-o"_s, at("tiled"), u"--maps"_s,
                                           u"object-normal"_s, u"--size"_s, u"32"_s});
    QVERIFY2(run.code == 0, qPrintable(run.err));
    QVERIFY(QFileInfo::exists(at("tiled/tiles_object-normal.1001.png")));
    QVERIFY(QFileInfo::exists(at("tiled/tiles_object-normal.1002.png")));
}

void TestCliBake::texturesAreCarried()
{
    Picture picture(64, 64, 3);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            picture.at(x, y)[0] = static_cast<float>(x) / 63;
            picture.at(x, y)[1] = static_cast<float>(y) / 63;
        }
    }
    QVERIFY(writePicture(picture, at("box_color.png"), PictureDepth::Eight).ok());
    QVERIFY(writePicture(picture, at("box_roughness.tif"), PictureDepth::Sixteen).ok());
    const test::CliRun run =
        runInProcess({u"transfer"_s, at("turned.obj"), u"--from"_s, at("low.obj"), u"--textures"_s,
                      at("box_color.png") + u',' + at("box_roughness.tif"), u"-o"_s, at("carried")});
    QVERIFY2(run.code == 0, qPrintable(run.err));
    for (const char *name : {"carried/box_color.png", "carried/box_roughness.tif"}) {
        const Result<Picture> carried = readPicture(at(name));
        QVERIFY(carried.ok());
        QCOMPARE(carried->width, 64);
        // The islands are turned by a right angle about the middle of the tile.
        for (const auto &[x, y] : {std::pair(12, 50), std::pair(30, 52)}) {
            const auto before = picture.at(x, y);
            const auto after = carried->at(y, 63 - x);
            QVERIFY(std::abs(before[0] - after[0]) < 0.02F && std::abs(before[1] - after[1]) < 0.02F);
        }
    }
    // The figures are those of all pictures.
    const auto texelsOf = [&](const QString &pictures) {
        const test::CliRun figures =
            runInProcess({u"transfer"_s, at("turned.obj"), u"--from"_s, at("low.obj"), u"--textures"_s,
                          pictures, u"-o"_s, at("figures"), u"--report"_s, at("figures.json")});
        return figures.code == 0 ? QJsonDocument::fromJson(test::readBytes(at("figures.json")))
                                       .object()
                                       .value(u"texels"_s)
                                       .toInt()
                                 : -1;
    };
    const int one = texelsOf(at("box_color.png"));
    QVERIFY(one > 0);
    QCOMPARE(texelsOf(at("box_color.png") + u',' + at("box_roughness.tif")), 2 * one);
    // Each that is named has to be there: else none is made.
    const test::CliRun missing =
        runInProcess({u"transfer"_s, at("turned.obj"), u"--from"_s, at("low.obj"), u"--textures"_s,
                      at("box_color.png") + u',' + at("gone.png"), u"-o"_s, at("missing")});
    QCOMPARE(missing.code, 1);
    QVERIFY2(missing.err.contains(u"gone.png"_s), qPrintable(missing.err));
    QVERIFY(!QFileInfo::exists(at("missing/box_color.png")));
    const test::CliRun unmapped =
        runInProcess({u"transfer"_s, at("plain.obj"), u"--from"_s, at("low.obj"), u"--textures"_s,
                      at("box_color.png"), u"-o"_s, at("unmapped")});
    QCOMPARE(unmapped.code, 1);
    QVERIFY2(unmapped.err.contains(u"no UV map to bake into"_s), qPrintable(unmapped.err));
    const QString roughness = at("carried/box_roughness.tif");
    QCOMPARE(decodePicture(test::readBytes(roughness), roughness)->depth, PictureDepth::Sixteen);
}

//! The textures of the detailed model come through its own UVs; materials without one have their colour.
void TestCliBake::colorsOfTextures()
{
    Picture halves(64, 64, 3);
    for (int i = 0; i < 64 * 64; ++i)
        halves.at(i % 64, i / 64)[i % 64 < 32 ? 0 : 2] = 1; // red, blue
    QVERIFY(writePicture(halves, at("halves.png"), PictureDepth::Eight).ok());
    file("colored.mtl",
         "newmtl painted\nmap_Kd halves.png\nnewmtl plain\nKd 0 1 0\nnewmtl lost\nmap_Kd gone.png\n");
    file("colored.obj", "mtllib colored.mtl\n"
                        "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 3 0 0\nv 3 1 0\nv 4 0 0\nv 4 1 0\n"
                        "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                        "usemtl painted\nf 1/1 2/2 3/3 4/4\nusemtl plain\nf 2/1 5/2 6/3 3/4\n"
                        "usemtl lost\nf 5/1 7/2 8/3 6/4\n");
    file("sheet.obj",
         "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 0.25\nvt 0 0.25\nf 1/1 2/2 3/3 4/4\n");
    const test::CliRun run =
        runInProcess({u"bake"_s, at("sheet.obj"), u"--high"_s, at("colored.obj"), u"-o"_s, at("colored"),
                      u"--maps"_s, u"color"_s, u"--size"_s, u"64"_s});
    QVERIFY2(run.code == 0, qPrintable(run.err));
    QVERIFY2(run.err.contains(u"cannot be read: gone.png"_s), qPrintable(run.err));
    const Result<Picture> picture = readPicture(at("colored/sheet_color.png"));
    QVERIFY(picture.ok());
    const auto at = [&](int x) {
        return Vec3(picture->at(x, 56)[0], picture->at(x, 56)[1], picture->at(x, 56)[2]);
    };
    QVERIFY((at(8) - Vec3(1, 0, 0)).norm() < 0.01);
    QVERIFY((at(24) - Vec3(0, 0, 1)).norm() < 0.01);
    QVERIFY((at(40) - Vec3(0, 1, 0)).norm() < 0.01);
}

void TestCliBake::colorsOfVertices_data()
{
    QTest::addColumn<QString>("from");
    QTest::addColumn<QList<double>>("left");  // with a texture
    QTest::addColumn<QList<double>>("right"); // without
    const QList<double> texture{1, 0, 0}, vertices{0.2, 0.4, 0.6}, material{0, 1, 0};
    QTest::newRow("auto") << u"auto"_s << texture << vertices;
    QTest::newRow("textures") << u"textures"_s << texture << material;
    QTest::newRow("vertices") << u"vertices"_s << vertices << vertices;
    QTest::newRow("materials") << u"materials"_s << material << material;
}

void TestCliBake::colorsOfVertices()
{
    QFETCH(QString, from);
    QFETCH(QList<double>, left);
    QFETCH(QList<double>, right);
    Picture red(4, 4, 3);
    for (int i = 0; i < 16; ++i)
        red.at(i % 4, i / 4)[0] = 1;
    QVERIFY(writePicture(red, at("red.png"), PictureDepth::Eight).ok());
    file("both.mtl", "newmtl painted\nKd 0 1 0\nmap_Kd red.png\nnewmtl plain\nKd 0 1 0\n");
    QByteArray text = "mtllib both.mtl\n";
    for (const char *place : {"0 0 0", "2 0 0", "2 1 0", "0 1 0", "4 0 0", "4 1 0"})
        text += QByteArray("v ") + place + " .2 .4 .6\n";
    file("both.obj", text + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl painted\nf 1/1 2/2 3/3 4/4\n"
                            "usemtl plain\nf 2/1 5/2 6/3 3/4\n");
    file("sheet.obj",
         "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 0.25\nvt 0 0.25\nf 1/1 2/2 3/3 4/4\n");
    const QStringList bake{u"bake"_s,  at("sheet.obj"), u"-o"_s, at("both"),        u"--maps"_s,
                           u"color"_s, u"--size"_s,     u"64"_s, u"--color-from"_s, from};
    const test::CliRun run = runInProcess(bake + QStringList{u"--high"_s, at("both.obj")});
    QVERIFY2(run.code == 0 && run.err.isEmpty(), qPrintable(run.err));
    const Result<Picture> picture = readPicture(at("both/sheet_color.png"));
    QVERIFY(picture.ok());
    for (int k = 0; k < 3; ++k) {
        QVERIFY(std::abs(picture->at(16, 56)[std::size_t(k)] - left[k]) < 0.01);
        QVERIFY(std::abs(picture->at(48, 56)[std::size_t(k)] - right[k]) < 0.01);
    }
    // A model without any of them.
    const test::CliRun without =
        runInProcess(bake + QStringList{u"--high"_s, at("high.obj"), u"--cage"_s, u"1"_s});
    QCOMPARE(without.code, 0);
    QCOMPARE(without.err.contains(u"no colours of the chosen kind"_s), from != u"auto"_s);
}

void TestCliBake::whatWasMissedIsSaid()
{
    const test::CliRun run = runInProcess({u"bake"_s, at("low.obj"), u"--high"_s, at("high.obj"), u"-o"_s,
                                           at("missed"), u"--size"_s, u"32"_s, u"--cage"_s, u"0.0001"_s});
    QCOMPARE(run.code, 0);
    QVERIFY2(run.err.contains(u"texels found nothing of the detailed model"_s), qPrintable(run.err));
}

void TestCliBake::mistakes_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("message");
    QTest::newRow("no UVs") << QStringList{at("plain.obj"), u"-o"_s, at("x")} << 1
                            << u"no UV map to bake into"_s;
    QTest::newRow("no output") << QStringList{at("low.obj")} << 2 << u"-o"_s;
    QTest::newRow("no such model") << QStringList{at("none.obj"), u"-o"_s, at("x")} << 1 << u"none.obj"_s;
    QTest::newRow("no such detailed model")
        << QStringList{at("low.obj"), u"--high"_s, at("none.obj"), u"-o"_s, at("x")} << 1 << u"none.obj"_s;
    QTest::newRow("unknown map") << QStringList{at("low.obj"), u"-o"_s, at("x"), u"--maps"_s,
                                                u"normal,shine"_s}
                                 << 2 << u"thickness"_s;
    QTest::newRow("samples") << QStringList{at("low.obj"), u"-o"_s, at("x"), u"--samples"_s, u"5"_s} << 2
                             << u"1, 4, 9"_s;
    QTest::newRow("cage") << QStringList{at("low.obj"), u"-o"_s, at("x"), u"--cage"_s, u"wide"_s} << 2
                          << u"or auto"_s;
    QTest::newRow("huge") << QStringList{at("low.obj"), u"-o"_s, at("x"), u"--size"_s, u"60000"_s} << 1
                          << u"too large"_s;
    QTest::newRow("larger than any") << QStringList{at("low.obj"), u"-o"_s, at("x"), u"--size"_s, u"100000"_s}
                                     << 2 << u"65536"_s;
    QTest::newRow("bits") << QStringList{at("low.obj"), u"-o"_s, at("x"), u"--bits"_s, u"32"_s} << 1
                          << u"no numbers of 32 bits"_s;
    QTest::newRow("folder as report") << QStringList{at("low.obj"), u"-o"_s,       at("unmade"), u"--size"_s,
                                                     u"16"_s,       u"--report"_s, at("unmade")}
                                      << 1 << u"this would overwrite"_s;
    QTest::newRow("a file as folder")
        << QStringList{at("low.obj"), u"-o"_s, at("file.txt"), u"--size"_s, u"16"_s} << 1
        << u"cannot be written"_s;
    QTest::newRow("broken detailed model")
        << QStringList{at("low.obj"), u"--high"_s, at("file.txt"), u"-o"_s, at("x")} << 1 << u"file.txt"_s;
}

void TestCliBake::mistakes()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, message);
    const test::CliRun run = test::runInProcess(QStringList{u"bake"_s} + arguments);
    QCOMPARE(run.code, code);
    QVERIFY2(run.err.contains(message), qPrintable(run.err));
    QVERIFY(!QFileInfo::exists(at("x/low_normal.png")));
    QCOMPARE(test::readBytes(at("file.txt")), QByteArray("not a folder"));
}

//! The last of three pictures cannot be written: the first ones stay as they were.
void TestCliBake::aFailureKeepsAllPictures()
{
    QVERIFY(QDir().mkpath(at("kept/low_material-id.png/full")));
    file("kept/low_position.png", "old");
    const test::CliRun run = runInProcess({u"bake"_s, at("low.obj"), u"-o"_s, at("kept"), u"--maps"_s,
                                           u"position,height,material-id"_s, u"--size"_s, u"16"_s});
    QCOMPARE(run.code, 1);
    QVERIFY2(run.err.contains(u"low_material-id.png"_s), qPrintable(run.err));
    QCOMPARE(test::readBytes(at("kept/low_position.png")), QByteArray("old"));
    QCOMPARE(QDir(at("kept")).entryList(QDir::Files | QDir::Hidden), QStringList{u"low_position.png"_s});
}

void TestCliBake::aTimeLimitKeepsWhatIsFinished()
{
    const test::CliRun run =
        runInProcess({u"bake"_s, at("low.obj"), u"-o"_s, at("limited"), u"--size"_s, u"2048"_s, u"--rays"_s,
                      u"65536"_s, u"--time-limit"_s, u"0.2"_s, u"--report"_s, at("limited.json")});
    QVERIFY2(run.code == 0, qPrintable(run.err));
    const QJsonObject report = QJsonDocument::fromJson(test::readBytes(at("limited.json"))).object();
    QCOMPARE(report.value(u"status"_s).toString(), u"time_limit"_s);
    QCOMPARE(report.value(u"files"_s).toArray().size(), 0);
    QVERIFY(QDir(at("limited")).isEmpty());
}

void TestCliBake::aTimeLimitEndsTheReading()
{
    const QString high = file("sheet.obj", test::sheetObj(600));
    const test::CliRun run = runInProcess({u"bake"_s, at("low.obj"), u"--high"_s, high, u"-o"_s, at("unread"),
                                           u"--size"_s, u"16"_s, u"--time-limit"_s, u"0.02"_s});
    QCOMPARE(run.code, 1);
    QVERIFY2(run.err.contains(u"before the model was read"_s), qPrintable(run.err));
}

QTEST_GUILESS_MAIN(TestCliBake)

} // namespace tst_clibake

#include "tst_clibake.moc"
