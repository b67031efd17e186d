// Textures that are not square: tiles, files, pictures and packing.
#include "model/io/formats/tilescaling.h"
#include "model/io/meshes/meshfile.h"
#include "model/layouts/uvexport.h"
#include "model/plain/chart.h"
#include "model/plain/packingsettings.h"
#include "model/plain/udimtiles.h"
#include "model/plain/uvlayout.h"
#include "model/samples/samples.h"
#include "support/cliruns.h"

#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace tst_tilescaling {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::readBytes;

namespace {

//! Gives all corners UVs that are no round numbers, beyond the tile as well.
void fillUvs(Scene &scene)
{
    UvMatrix uv(scene.mesh->cornerCount(), 2);
    for (Eigen::Index c = 0; c < uv.rows(); ++c) {
        const auto point = scene.mesh->cornerPosition(static_cast<int>(c));
        uv.row(c) << 0.3 + point.x() / 3 + point.z() / 7, 1.1 + point.y() / 1.7 - point.z() / 11;
    }
    scene.uvSets = {{u"UVMap"_s, std::move(uv)}};
}

} // namespace

class TestTileScaling : public QObject, public test::OwnFolder
{
    Q_OBJECT

private Q_SLOTS:
    void tilesHaveTheShapeOfTheTexture()
    {
        PackingSettings packing;
        QCOMPARE(packing.tileHeight(), 1.0);
        packing.setTexture(2048, 1024);
        QCOMPARE(packing.tileHeight(), 0.5);
        QCOMPARE(packing.height(), 1024);
        QCOMPARE(udimTile(1001, 0.5).max(), Vec2(1, 0.5));
        QCOMPARE(udimTile(1012, 0.5).min(), Vec2(1, 0.5));
        QCOMPARE(tileAt(Vec2(-0.1, 0.6), 0.5).min(), Vec2(-1, 0.5));
        packing.setTexture(512, 512);
        QCOMPARE(packing.textureHeight, 0);
        packing.setTexture(64, 32);
        packing.margin = 33;
        QVERIFY(!packing.isValid());
        packing.margin = 8;
        packing.border = 16;
        QVERIFY(!packing.isValid());
    }

    void unchangedFilesKeepTheirBytes_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<double>("tileHeight");
        for (const QString &format : {u"obj"_s, u"fbx"_s, u"glb"_s, u"gltf"_s, u"dae"_s, u"ply"_s}) {
            for (const double height : {0.5, 0.75, 1.0 / 3, 0.7, 3.0, 1080.0 / 1920})
                QTest::newRow(qPrintable(u"%1 %2"_s.arg(format).arg(height))) << format << height;
        }
    }

    void unchangedFilesKeepTheirBytes()
    {
        QFETCH(QString, format);
        QFETCH(double, tileHeight);
        Scene scene = makeSample(u"bumpycube"_s).value();
        fillUvs(scene);
        const QString first = at("first.") + format, second = at("second.") + format;
        QVERIFY(writeMesh(scene, first));
        if (format == u"dae" || format == u"ply") { // Assimp writes them in a form of its own
            QVERIFY(writeMesh(readMesh(first).value(), second));
            QVERIFY(QFile::remove(first) && QFile::rename(second, first));
        }
        const Result<Scene> square = readMesh(first);
        const Result<Scene> read = readMesh(first, nullptr, tileHeight);
        QVERIFY(read.ok() && square.ok());
        const UvMatrix &uv = read->uvSets.front().uv, &inFile = square->uvSets.front().uv;
        QVERIFY(uv.col(0) == inFile.col(0));
        QVERIFY(uv.col(1) == (inFile.col(1) * tileHeight).eval());
        QVERIFY(writeMesh(read.value(), second, tileHeight));
        QVERIFY(writeMesh(square.value(), first));
        QVERIFY(readBytes(first) == readBytes(second));
    }

    void changedUvsAreScaledBack()
    {
        Scene scene = makeSample(u"torus"_s).value();
        fillUvs(scene);
        const QString path = at("changed.obj");
        QVERIFY(writeMesh(scene, path));
        Scene read = readMesh(path, nullptr, 0.75).value();
        read.uvSets.front().uv.row(5) = Eigen::RowVector2d(0.25, 0.6);
        const Scene back = scaledForFile(read, 0.75);
        QVERIFY(std::abs(back.uvSets.front().uv(5, 1) - 0.8) < 1e-15);
        const Scene inFile = readMesh(path).value();
        QVERIFY(back.uvSets.front().uv.topRows(5) == inFile.uvSets.front().uv.topRows(5));
    }

    void picturesHaveTheShapeOfTheTexture()
    {
        Scene scene = makeSample(u"bumpycube"_s).value();
        fillUvs(scene);
        LayoutOptions options;
        options.size = 256;
        for (const auto &[height, size] :
             {std::pair(0.5, QSize(256, 128)), std::pair(2.0, QSize(128, 256))}) {
            options.tileHeight = height;
            const UvMatrix &uv = scene.uvSets.front().uv;
            const QImage image = QImage::fromData(layoutPng(*scene.mesh, uv, options).value());
            QCOMPARE(image.size(), size);
            const QByteArray svg = layoutSvg(*scene.mesh, uv, options).value();
            QVERIFY(svg.contains(u"viewBox=\"0 0 %1 %2\""_s.arg(size.width()).arg(size.height()).toUtf8()));
        }
    }

    void theCommandLinePacksIntoTheTexture_data()
    {
        QTest::addColumn<QString>("size");
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::newRow("wide") << u"2048x1024"_s << 2048 << 1024;
        QTest::newRow("high") << u"512x1536"_s << 512 << 1536;
        QTest::newRow("odd") << u"1000x300"_s << 1000 << 300;
    }

    void theCommandLinePacksIntoTheTexture()
    {
        QFETCH(QString, size);
        QFETCH(int, width);
        QFETCH(int, height);
        const QString in = at("parts.obj"), out = at("packed.obj"), picture = at("packed.png");
        QCOMPARE(test::runInProcess({u"sample"_s, u"machine"_s, u"-o"_s, in}).code, 0);
        const test::CliRun run = test::runInProcess(
            {u"unwrap"_s, in, u"-o"_s, out, u"--quality=draft"_s, u"--texture-size"_s, size, u"--margin=6"_s,
             u"--tile-border=10"_s, u"--tile=1012"_s, u"--rotation=90"_s, u"--layout"_s, picture});
        QVERIFY2(run.code == 0 || run.code == 3, qPrintable(run.err));
        // The file: the second row, second column, with the border in texels on each side.
        const Eigen::AlignedBox2d box = layoutBox(readMesh(out).value().uvSets.front().uv);
        const Vec2 border = Vec2(10.0 / width, 10.0 / height) * (1 - 1e-6);
        QVERIFY(Eigen::AlignedBox2d(Vec2(Vec2(1, 1) + border), Vec2(Vec2(2, 2) - border)).contains(box));
        // In texels, shapes are those of the model: the distortion is that of a square texture.
        const test::CliRun check =
            test::runInProcess({u"check"_s, out, u"--json"_s, u"--texture-size"_s, size});
        const QJsonObject figures = QJsonDocument::fromJson(check.out.toUtf8()).object();
        QVERIFY(figures[u"sym_dirichlet"].toDouble() < 4.11);
        QVERIFY(figures[u"min_gutter_texels"].toDouble() >= 6 * (1 - 1e-6));
        QCOMPARE(figures[u"texture_size"].toInt(), width);
        QCOMPARE(figures[u"texture_height"].toInt(), height);
        QCOMPARE(figures[u"in_unit_square"].toBool(), false);
        const QImage image(picture);
        QCOMPARE(image.width() > image.height(), width > height);
    }

    void aRectangleIsInUnitsOfTheFile()
    {
        const QString in = at("box.obj"), out = at("boxed.obj");
        QCOMPARE(test::runInProcess({u"sample"_s, u"machine"_s, u"-o"_s, in}).code, 0);
        QCOMPARE(test::runInProcess({u"unwrap"_s, in, u"-o"_s, in, u"--quality=draft"_s}).code, 0);
        const test::CliRun run = test::runInProcess(
            {u"pack"_s, in, u"-o"_s, out, u"--texture-size=1024x256"_s, u"--into=0.5,0.5,1,1"_s});
        QVERIFY2(run.code == 0, qPrintable(run.err));
        const Eigen::AlignedBox2d box = layoutBox(readMesh(out).value().uvSets.front().uv);
        QVERIFY(Eigen::AlignedBox2d(Vec2(0.5, 0.5), Vec2(1, 1)).contains(box));
        QVERIFY(box.sizes().y() > 0.4); // the whole rectangle is used
    }
};

QTEST_GUILESS_MAIN(TestTileScaling)

} // namespace tst_tilescaling

#include "tst_tilescaling.moc"
