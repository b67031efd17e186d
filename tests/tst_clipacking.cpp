// The command line packs into tiles and rectangles, by the marks of a session.
#include "cli/commandline.h"
#include "commands/editrectangles.h"
#include "commands/setislandflags.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "model/plain/udimtiles.h"
#include "model/plain/uvlayout.h"
#include "support/cliruns.h"
#include "support/pieces.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace tst_clipacking {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

class TestCliPacking : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mDocument = test::partsDocument({{}, {{0.3, 0}, 1}, {{0.7, 0.1}, 2}, {{0.1, 0.5}}});
        pushCommand(EditRectangles::add(
            *mDocument,
            {1, u"two hands"_s, 0xff4080ff, {1.1, 0.1}, {1.6, 0.9}, false, 1, {0, 1, 2, 9, 10, 11}}));
    }

    void optionsAreRead()
    {
        const auto packing = [](const QStringList &words) {
            return parseCommandLine(QStringList{u"pack"_s, u"a.obj"_s, u"-o"_s, u"b.obj"_s} + words);
        };
        QCOMPARE(packing({}).value().unwrap.packing.lower, Vec2(0, 0));
        QCOMPARE(packing({u"--tile=1013"_s}).value().unwrap.packing.lower, Vec2(2, 1));
        QCOMPARE(packing({u"--tile=1013"_s}).value().unwrap.packing.upper, Vec2(3, 2));
        const CliOptions box = packing({u"--into"_s, u"0.25,-1,0.5,2"_s}).value();
        QCOMPARE(box.unwrap.packing.lower, Vec2(0.25, -1));
        QCOMPARE(box.unwrap.packing.upper, Vec2(0.5, 2));
        QCOMPARE(packing({u"--into"_s, u"left hand"_s}).value().intoRectangle, u"left hand"_s);
        for (const char *wrong : {"--tile=1000", "--tile=10000", "--into=1,0,0,1", "--into=0,0,1,1e9"})
            QVERIFY2(!packing({QString::fromLatin1(wrong)}).ok(), wrong);
        QVERIFY(!packing({u"--into=0,0,1,1"_s, u"--tile=1002"_s}).ok());
        QVERIFY(!parseCommandLine({u"unwrap"_s, u"a.obj"_s, u"-o"_s, u"b.obj"_s, u"--into=0,0,1,1"_s}).ok());
    }

    void sidesGiveARectangle()
    {
        const auto packed = this->packed({u"--into=0.5,0.5,0.75,1"_s});
        QVERIFY2(packed, qPrintable(mRun.err));
        for (int part = 0; part < 4; ++part)
            QVERIFY(Eigen::AlignedBox2d(Vec2(0.5, 0.5), Vec2(0.75, 1)).contains(packed->islands().box(part)));
    }

    void theBorderIsKept()
    {
        constexpr double border = 400.0 / 2048;
        const auto packed = this->packed({u"--tile-border=400"_s});
        QVERIFY2(packed, qPrintable(mRun.err));
        const Eigen::AlignedBox2d inside(Vec2::Constant(border - 1e-9), Vec2::Constant(1 - border + 1e-9));
        // The others have a rectangle.
        QVERIFY(inside.contains(packed->islands().box(1)) && inside.contains(packed->islands().box(2)));
        const auto usual = this->packed({});
        QVERIFY2(usual, qPrintable(mRun.err));
        QVERIFY(!inside.contains(usual->islands().box(1)) || !inside.contains(usual->islands().box(2)));
    }

    void namesGiveARectangleWithItsIslands()
    {
        const auto packed = this->packed({u"--into=two hands"_s});
        QVERIFY2(packed, qPrintable(mRun.err));
        const Eigen::AlignedBox2d box(Vec2(1.1, 0.1), Vec2(1.6, 0.9));
        for (int part = 0; part < 4; ++part)
            QCOMPARE(box.contains(packed->islands().box(part)), part == 0 || part == 3);
        QVERIFY(packed->uv().middleRows(test::partCorners, 2 * test::partCorners) ==
                mDocument->uv().middleRows(test::partCorners, 2 * test::partCorners));
        QVERIFY(!pack({u"--into=no such"_s}));
        QVERIFY2(mRun.err.contains(u"no rectangle \"no such\""_s), qPrintable(mRun.err));
    }

    void tilesAreThoseOfTheOptionOrTheSession()
    {
        auto packed = this->packed({u"--tile=1002"_s});
        QVERIFY(packed && packed->islands().box(0).min().x() > 1);
        QCOMPARE(packed->packingSettings().udimTile, 1002);
        mDocument = std::move(packed);
        packed = this->packed({});
        QVERIFY(packed && packed->islands().box(0).min().x() > 1);
    }

    void picturesAndFiguresAreThoseOfTheTilesInUse()
    {
        const QTemporaryDir folder;
        const auto at = [&folder](const char *name) { return folder.filePath(QLatin1String(name)); };
        const auto packed = this->packed({u"--tile=1012"_s, u"--layout"_s, at("one.svg"), u"--report"_s,
                                          at("one.json"), u"--only=islands:2,3"_s});
        QVERIFY2(packed, qPrintable(mRun.err));
        QVERIFY(test::readBytes(at("one.svg")).contains("<path fill=")); // the islands
        const QJsonObject report = QJsonDocument::fromJson(test::readBytes(at("one.json"))).object();
        const QJsonArray tiles = report.value(u"tiles"_s).toArray();
        QCOMPARE(tiles.last().toObject().value(u"tile"_s).toInt(), 1012);
        QCOMPARE(tiles.last().toObject().value(u"charts"_s).toInt(), 2);
        QVERIFY(tiles.last().toObject().value(u"packing_efficiency"_s).toDouble() > 0.2);
        QVERIFY(tiles.last().toObject().value(u"texel_density"_s).toDouble() > 0);
        QVERIFY2(mRun.out.contains(u"tile_1012"_s), qPrintable(mRun.out));

        // The rectangle lies in tile 1002, the other islands in 1001: a picture for each.
        QVERIFY(pack({u"--layout"_s, at("both.png")}));
        QVERIFY(!QFile::exists(at("both.png")));
        for (const char *name : {"both.1001.png", "both.1002.png"})
            QVERIFY2(QFile::exists(at(name)), name);
        QVERIFY2(mRun.out.contains(u"part of the 2 tiles in use"_s), qPrintable(mRun.out));
        QVERIFY2(!mRun.out.contains(u"unit square"_s), qPrintable(mRun.out));
    }

    void densityTakesAsManyTilesAsItNeeds()
    {
        // A part is 2.5 x 2 units in size, with an area of 3.5.
        QVERIFY(pack({u"--density=300"_s}));
        QCOMPARE(tilesInUse(), QList<int>{1001});
        for (int part = 0; part < 4; ++part)
            QVERIFY(std::abs(density(part) - 300) < 1e-6);
        QVERIFY(pack({u"--density=700"_s, u"--tile=1010"_s}));
        const QList<int> tiles = tilesInUse();
        QVERIFY2(tiles.size() > 1 && tiles[0] == 1010 && tiles[1] == 1011, qPrintable(mRun.out));
        QVERIFY2(mRun.out.contains(u"into the tiles 1010, 1011"_s), qPrintable(mRun.out));
        QVERIFY(std::abs(density(3) - 700) < 1e-6);
        const QString once = mRun.out;
        QVERIFY(pack({u"--density=700"_s, u"--tile=1010"_s, u"--threads=3"_s}));
        QCOMPARE(mRun.out, once);
    }

    void whatIsLargerThanATileGetsOneOfItsOwn()
    {
        QVERIFY(pack({u"--density=2000"_s}));
        QCOMPARE(tilesInUse(), (QList<int>{1001, 1002, 1003, 1004}));
        QVERIFY2(
            mRun.err.contains(u"Islands larger than a tile at this density, and made smaller to fit: 4"_s),
            qPrintable(mRun.err));
        QVERIFY(density(0) > 500 && density(0) < 2000);
        QVERIFY(!pack({u"--density=500"_s, u"--tile=9999"_s, u"--margin=200"_s}));
        QVERIFY2(mRun.err.contains(u"more UDIM tiles than there are"_s), qPrintable(mRun.err));
    }

    void tilesInUseAreFilled()
    {
        mDocument = test::partsDocument({{}, {{0.3, 0}, 1}, {{0.7, 0.1}, 2}, {{0.1, 0.5}}});
        QVERIFY2(pack({u"--only=islands:1,2,3"_s, u"--density=400"_s}), qPrintable(mRun.err));
        mDocument = std::move(mPacked);
        QVERIFY2(pack({u"--only=islands:4"_s, u"--fill-tiles"_s}), qPrintable(mRun.err));
        constexpr Eigen::Index others = 3 * test::partCorners; // they stay to the bit
        QVERIFY(mPacked->uv().topRows(others) == mDocument->uv().topRows(others));
        QCOMPARE(tilesInUse(), QList<int>{1001});
        QVERIFY(std::abs(density(3) - 400) < 1e-6);
        QVERIFY2(mRun.out.contains(u"Islands packed: 1, into the tiles 1001"_s), qPrintable(mRun.out));
        QVERIFY2(mRun.out.contains(u"no problems found"_s), qPrintable(mRun.out));
        // Where there is no room the next tile is taken.
        QVERIFY2(pack({u"--only=islands:4"_s, u"--fill-tiles"_s, u"--density=800"_s}), qPrintable(mRun.err));
        QCOMPARE(tilesInUse(), (QList<int>{1001, 1002}));
        QVERIFY(mPacked->uv().topRows(others) == mDocument->uv().topRows(others));
    }

    void marksAreRespected()
    {
        using Edit = SetIslandFlags::Edit;
        pushCommand(std::make_unique<SetIslandFlags>(*mDocument, Edit::Lock, std::vector<int>{3}));
        pushCommand(std::make_unique<SetIslandFlags>(*mDocument, Edit::Group, std::vector<int>{0, 1}));
        const auto packed = this->packed({u"--keep-scale"_s});
        QVERIFY2(packed, qPrintable(mRun.err));
        const auto middle = [](const Document &document, int part) {
            const Eigen::Index rows = test::partCorners;
            return Vec2(document.uv().middleRows(part * rows, rows).colwise().mean().transpose());
        };
        QVERIFY(packed->uv().bottomRows(test::partCorners) == mDocument->uv().bottomRows(test::partCorners));
        const double before = (middle(*mDocument, 1) - middle(*mDocument, 0)).norm();
        QVERIFY(std::abs((middle(*packed, 1) - middle(*packed, 0)).norm() - before) < 1e-9);
    }

    void plainFilesKeepTheirTiles_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<double>("scale"); // of the islands
        QTest::addColumn<QList<int>>("tiles");
        const QList<int> kept{1001, 1002, 1003, 1013}, one{1001, 1001, 1001, 1001};
        QTest::newRow("pack") << QStringList{u"pack"_s} << 1.0 << kept;
        QTest::newRow("lightmap") << QStringList{u"lightmap"_s} << 1.0 << kept;
        QTest::newRow("one tile") << QStringList{u"pack"_s, u"--tiles=one"_s} << 1.0 << one;
        QTest::newRow("lightmap in one tile") << QStringList{u"lightmap"_s, u"--tiles=one"_s} << 1.0 << one;
        QTest::newRow("another tile")
            << QStringList{u"pack"_s, u"--tile=1004"_s} << 1.0 << QList<int>{1004, 1004, 1004, 1004};
        QTest::newRow("a texture that repeats") << QStringList{u"pack"_s} << 40.0 << one;
    }

    //! Islands of a file in several tiles, of which one reaches over the border of its tile.
    void plainFilesKeepTheirTiles()
    {
        QFETCH(QStringList, words);
        QFETCH(double, scale);
        QFETCH(QList<int>, tiles);
        const auto laidOut = test::partsDocument({{{0.1, 0.1}, 0, scale},
                                                  {{1.2, 0.3}, 0, scale},
                                                  {{2.83, 0.2}, 0, scale},
                                                  {{2.4, 1.4}, 0, 2 * scale}});
        const QTemporaryDir folder;
        const QString in = folder.filePath(u"in.obj"_s), out = folder.filePath(u"out.acproj"_s);
        QVERIFY(writeMesh(laidOut->state().scene, in));
        const QString command = words.takeFirst();
        const test::CliRun run =
            test::runInProcess(QStringList{command, in, u"-o"_s, out, u"--pack-time=0.05"_s} + words);
        QCOMPARE(run.code, 0);
        const Scene scene = loadProject(out).value().state.scene;
        const auto set = std::ranges::find(scene.uvSets, u"Lightmap"_s, &UvSet::name);
        QCOMPARE(set != scene.uvSets.end(), command == u"lightmap"_s);
        const UvMatrix &uv = set != scene.uvSets.end() ? set->uv : scene.uvSets.front().uv;
        QList<int> now, all;
        QList<double> densities;
        for (int t = 0; t < scene.mesh->triangleCount(); ++t) {
            const auto &[a, b, c] = scene.mesh->triangles[t];
            const Vec2 middle = (uv.row(a) + uv.row(b) + uv.row(c)).transpose() / 3;
            all << 1001 + int(std::floor(middle.x())) + 10 * int(std::floor(middle.y()));
            const double area = cross2(Vec2(uv.row(a)), Vec2(uv.row(b)), Vec2(uv.row(c))) / 2;
            densities << std::sqrt(area / scene.mesh->triangleArea[t]);
        }
        for (int part = 0; part < 4; ++part)
            now << all[part * all.size() / 4];
        QCOMPARE(now, tiles);
        QVERIFY(std::abs(layoutBox(uv).min().x() - std::floor(layoutBox(uv).min().x())) < 0.1);
        if (command == u"lightmap"_s) // one density in all tiles
            QVERIFY(*std::ranges::max_element(densities) < 1.001 * *std::ranges::min_element(densities));
        const bool saysKept = command == u"pack"_s && tiles.contains(1013);
        QCOMPARE(run.out.contains(u"islands stay in their tiles: 1001, 1002, 1003, 1013"_s), saysKept);
    }

private:
    //! The tiles of the session that was packed last.
    QList<int> tilesInUse() const
    {
        const std::vector<int> tiles = usedTiles(udimTiles(mPacked->mesh(), mPacked->uv(), 1));
        return {tiles.begin(), tiles.end()};
    }
    //! Texels per unit of a part.
    double density(int part) const
    {
        double uvArea = 0, area = 0;
        for (int t = 0; t < mPacked->mesh().triangleCount(); ++t) {
            const auto &[a, b, c] = mPacked->mesh().triangles[t];
            if (mPacked->mesh().triangleFace[t] / test::partFaces != part)
                continue;
            const auto uv = [&](int corner) { return Vec2(mPacked->uv().row(corner)); };
            uvArea += std::abs(cross2(uv(a), uv(b), uv(c))) / 2;
            area += mPacked->mesh().triangleArea[t];
        }
        return 2048 * std::sqrt(uvArea / area);
    }

    //! As packed(), and keeps the session.
    bool pack(const QStringList &options)
    {
        mPacked = packed(options);
        return mPacked != nullptr;
    }

    //! The session after it was packed; null when that failed.
    std::unique_ptr<Document> packed(const QStringList &options)
    {
        const QTemporaryDir folder;
        const QString in = folder.filePath(u"in.acproj"_s), out = folder.filePath(u"out.acproj"_s);
        if (!saveProject(mDocument->state(), {}, in))
            return nullptr;
        mRun = test::runInProcess(QStringList{u"pack"_s, in, u"-o"_s, out, u"--pack-time=0.05"_s} + options);
        if (mRun.code != 0)
            return nullptr;
        return Document::create(loadProject(out).value().state).value();
    }

    std::unique_ptr<Document> mDocument, mPacked;
    test::CliRun mRun;
};

QTEST_GUILESS_MAIN(TestCliPacking)

} // namespace tst_clipacking

#include "tst_clipacking.moc"
