// The command line's light bake: its lights, surfaces, files and mistakes.
#include "jobs/lightmaterials.h"
#include "model/io/meshes/meshfile.h"
#include "model/pictures/picturefiles.h"
#include "support/cliruns.h"
#include "support/mappedmodels.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace tst_clilight {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::runInProcess;

namespace {

//! A square in the plane y = 0 that faces up and fills the map, and a smaller one above it that faces down
//! and is in no place of the map.
QByteArray floorObj()
{
    return "mtllib floor.mtl\n"
           "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\n"
           "v -.5 1 -.5\nv .5 1 -.5\nv .5 1 .5\nv -.5 1 .5\n"
           "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
           "usemtl Floor\nf 1/1 2/2 3/3 4/4\nusemtl Lamp\nf 5 6 7 8\n";
}

} // namespace

class TestCliLight : public QObject, private test::OwnFolder
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void lights_data();
    void lights();
    void files();
    void albedoPictures();
    void texturesReflect();
    void texturesHaveTheirUvSet();
    void severalTiles();
    void mistakes_data();
    void mistakes();

private:
    //! The value in the middle of the map that a command makes.
    double baked(const QStringList &options, const char *name = "out.exr")
    {
        const test::CliRun run =
            runInProcess(QStringList{u"lightbake"_s, at("floor.obj"), u"-o"_s, at(name), u"--size"_s, u"16"_s,
                                     u"--samples"_s, u"256"_s, u"--no-denoise"_s} +
                         options);
        const Result<Picture> picture = readPicture(at(name));
        if (run.code != 0 || !picture || picture->width != 16 || picture->channels != 3) {
            qWarning("%s", qPrintable(run.err));
            return -1;
        }
        return double(picture->at(8, 8)[0]);
    }
};

void TestCliLight::initTestCase()
{
    QVERIFY(!file("floor.obj", floorObj()).isEmpty());
    QVERIFY(!file("floor.mtl", "newmtl Floor\nKd .5 .5 .5\nnewmtl Lamp\nKd 0 0 0\n").isEmpty());
}

void TestCliLight::lights_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<double>("light");
    // The lamp hides .2373 of the sky from the texel in the middle of the floor (its form factor), and is
    // black.
    const double open = 1 - .2373;
    QTest::newRow("a white sky if nothing is said") << u""_s << open;
    QTest::newRow("a sky") << u"--sky .5"_s << .5 * open;
    QTest::newRow("stronger") << u"--sky .5,0,0 --sky-strength 4"_s << 2 * open;
    QTest::newRow("of the horizon alone") << u"--sky 0/1/0"_s << open - .6;
    QTest::newRow("irradiance") << u"--values irradiance"_s << open * M_PI;
    QTest::newRow("lit") << u"--values lit --albedo .25 --no-indirect"_s << .25 * open;
    QTest::newRow("shining faces") << u"--emit Lamp:2"_s << 2 * .2373;
    QTest::newRow("what shines is not reflected light") << u"--emit Lamp:2 --no-direct"_s << 0.0;
    QTest::newRow("an area light") << u"--area-light 0,.5,0:0,0,0:1x1:3"_s << 3 * .5473;
    QTest::newRow("that shines upwards") << u"--area-light 0,.5,0:0,1,0:1x1:3 --bounces 0"_s << 0.0;
    QTest::newRow("sun from the side") << u"--sun 90,45 --sun-strength 2"_s << std::sqrt(2) / M_PI;
    QTest::newRow("sun behind the lamp") << u"--sun 90,80"_s << 0.0;
    QTest::newRow("a coloured sun") << u"--sun 90,45 --sun-strength 2 --sun-color .5,1,1"_s
                                    << std::sqrt(.5) / M_PI;
    QTest::newRow("z is up") << u"--sun 180,0 --up z"_s << 0.0;
    QTest::newRow("no light") << u"--sky none"_s << 0.0;
}

void TestCliLight::lights()
{
    QFETCH(QString, options);
    QFETCH(double, light);
    const double value = baked(options.split(u' ', Qt::SkipEmptyParts));
    if (qstrcmp(QTest::currentDataTag(), "of the horizon alone") == 0)
        QVERIFY(value > .1 && value < .5);
    else
        QVERIFY2(std::abs(value - light) < .02 * std::max(light, .02),
                 qPrintable(QStringLiteral("%1 instead of %2").arg(value).arg(light)));
}

void TestCliLight::files()
{
    // Sixteen bits in sRGB.
    const double value = baked({u"--sky"_s, u".5"_s, u"--bits"_s, u"16"_s}, "out.png");
    QVERIFY(std::abs(double(linearFromSrgb(static_cast<float>(value))) - .5 * (1 - .2373)) < .01);
    QVERIFY(baked({u"--bits"_s, u"16"_s}, "half.exr") > .7);
    // The report, and the same bytes on any number of threads.
    QVERIFY(baked({u"--threads"_s, u"1"_s, u"--report"_s, at("report.json")}, "one.exr") > 0);
    QVERIFY(baked({u"--threads"_s, u"2"_s}, "two.exr") > 0);
    QCOMPARE(test::readBytes(at("one.exr")), test::readBytes(at("two.exr")));
    const QJsonObject report = QJsonDocument::fromJson(test::readBytes(at("report.json"))).object();
    QCOMPARE(report.value(u"status"_s).toString(), u"done"_s);
    QCOMPARE(report.value(u"texels"_s).toInt(), 256);
}

void TestCliLight::albedoPictures()
{
    Picture grey(4, 4, 3, srgbFromLinear(.25F));
    QVERIFY(writePicture(grey, at("grey.png"), PictureDepth::Eight).ok());
    const double value = baked({u"--values"_s, u"lit"_s, u"--no-indirect"_s, u"--albedo"_s, at("grey.png")});
    QVERIFY2(std::abs(value - .25 * (1 - .2373)) < .01, qPrintable(QString::number(value)));
}

//! Materials reflect what their textures show.
void TestCliLight::texturesReflect()
{
    QVERIFY(writePicture(Picture(4, 4, 3, srgbFromLinear(.25F)), at("grey.png"), PictureDepth::Eight).ok());
    const auto lit = [this](const QByteArray &picture) {
        file("floor.mtl", "newmtl Floor\nKd .5 .5 .5\nmap_Kd " + picture + "\nnewmtl Lamp\nKd 0 0 0\n");
        return baked({u"--values"_s, u"lit"_s, u"--no-indirect"_s});
    };
    const double open = 1 - .2373, textured = lit("grey.png"), missing = lit("nothing.png");
    file("floor.mtl", "newmtl Floor\nKd .5 .5 .5\nnewmtl Lamp\nKd 0 0 0\n");
    QVERIFY2(std::abs(textured - .25 * open) < .01, qPrintable(QString::number(textured)));
    QVERIFY2(std::abs(missing - double(linearFromSrgb(.5F)) * open) < .01,
             qPrintable(QString::number(missing)));
}

//! The picture is black on the left and white on the right.
void TestCliLight::texturesHaveTheirUvSet()
{
    Picture halves(4, 4, 3);
    for (int y = 0; y < 4; ++y) {
        for (const int x : {2, 3})
            std::ranges::fill(halves.at(x, y), 1.0F);
    }
    QVERIFY(writePicture(halves, at("halves.png"), PictureDepth::Eight).ok());
    file("floor.mtl", "newmtl Floor\nmap_Kd halves.png\nnewmtl Lamp\n");
    Result<Scene> scene = readMesh(at("floor.obj"));
    file("floor.mtl", "newmtl Floor\nKd .5 .5 .5\nnewmtl Lamp\nKd 0 0 0\n");
    QVERIFY(scene.ok());
    const UvMatrix left = UvMatrix::Constant(scene->mesh->cornerCount(), 2, .2);
    const UvMatrix right = UvMatrix::Constant(scene->mesh->cornerCount(), 2, .8);
    scene->uvSets = {{u"light"_s, left}, {u"textures"_s, right}};
    DocumentState model;
    model.scene = scene.value();
    QStringList missing;
    for (const int set : {0, 1}) {
        const Result<LitSurface> surface = jobs::litSurface(model, {}, set, 1, missing);
        QVERIFY(surface.ok() && missing.isEmpty());
        QCOMPARE(surface->albedo({0, .25F, .25F}).x(), float(set));
    }
}

void TestCliLight::severalTiles()
{
    const QByteArray obj = "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 5 0 0\nv 5 0 1\nv 6 0 0\n"
                           "vt .1 .1\nvt .9 .1\nvt .1 .9\nvt 1.1 .1\nvt 1.9 .1\nvt 1.1 .9\n"
                           "f 1/1 2/2 3/3\nf 4/4 5/5 6/6\n";
    const test::CliRun run = runInProcess({u"lightbake"_s, file("tiles.obj", obj), u"-o"_s, at("tiles.png"),
                                           u"--size"_s, u"16"_s, u"--samples"_s, u"4"_s});
    QVERIFY2(run.code == 0, qPrintable(run.err));
    for (const char *name : {"tiles.1001.png", "tiles.1002.png"})
        QVERIFY(readPicture(at(name)).ok());
}

void TestCliLight::mistakes_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("message");
    const auto row = [](const char *name, const QString &options, int code, const QString &message) {
        QTest::newRow(name) << options << code << message;
    };
    row("sun", u"--sun 90"_s, 2, u"an azimuth and an elevation"_s);
    row("sun too high", u"--sun 90,100"_s, 2, u"an azimuth and an elevation"_s);
    row("sky", u"--sky 1/1/1/1"_s, 2, u"one to three colours"_s);
    row("negative", u"--sky -1"_s, 2, u"one to three colours"_s);
    row("area", u"--area-light 0,0,0:0,0,0:1x1:1"_s, 2, u"its centre"_s);
    row("area without size", u"--area-light 0,0,0:0,1,0:1:1"_s, 2, u"its centre"_s);
    row("emission", u"--emit Lamp"_s, 2, u"the name of a material"_s);
    row("bright albedo", u"--albedo 2"_s, 2, u"from 0 to 1"_s);
    row("infinite", u"--sky inf"_s, 2, u"one to three colours"_s);
    row("option of another command", u"--rays 4"_s, 2, u"does not belong to this command"_s);
    row("no such material", u"--emit Sun:1"_s, 1, u"It has: Floor, Lamp"_s);
    row("no such picture", u"--albedo nothing.png"_s, 1, u"nothing.png"_s);
    row("bits", u"--bits 8"_s, 1, u"exr files have no numbers of 8 bits"_s);
    row("too large", u"--size 16384"_s, 1, u"at most 8192"_s);
}

void TestCliLight::mistakes()
{
    QFETCH(QString, options);
    QFETCH(int, code);
    QFETCH(QString, message);
    const test::CliRun run = runInProcess(
        QStringList{u"lightbake"_s, at("floor.obj"), u"-o"_s, at("mistake.exr"), u"--size"_s, u"16"_s} +
        options.split(u' '));
    QCOMPARE(run.code, code);
    QVERIFY2(run.err.contains(message), qPrintable(run.err));
    QVERIFY(test::readBytes(at("mistake.exr")).isEmpty());
    const test::CliRun format =
        runInProcess({u"lightbake"_s, at("floor.obj"), u"-o"_s, at("out.bmp"), u"--size"_s, u"16"_s});
    QCOMPARE(format.code, 1);
    QVERIFY(format.err.contains(u"exr, png, tif and tga"_s));
}

QTEST_GUILESS_MAIN(TestCliLight)

} // namespace tst_clilight

#include "tst_clilight.moc"
