// Layout pictures: what is drawn where, and that the bytes are always the same.
#include "model/io/files/savefile.h"
#include "model/layouts/layoutfiles.h"
#include "model/layouts/layoutpaths.h"
#include "model/layouts/uvexport.h"
#include "support/meshbuilders.h"
#include "support/objuv.h"

#include <QFileInfo>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <cmath>
#include <limits>
#include <map>
#include <random>

namespace tst_uvexport {

using namespace autocuts;

namespace {

//! Two squares: one in the lower left quarter, one in the upper right, the second split by a diagonal.
test::ObjUv twoSquares()
{
    return test::parseObjUv("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 3 0 0\nv 4 0 0\nv 4 1 0\nv 3 1 0\n"
                            "vt 0.1 0.1\nvt 0.4 0.1\nvt 0.4 0.4\nvt 0.1 0.4\n"
                            "vt 0.6 0.6\nvt 0.9 0.6\nvt 0.9 0.9\nvt 0.6 0.9\n"
                            "f 1/1 2/2 3/3 4/4\nf 5/5 6/6 7/7\nf 5/5 7/7 8/8\n");
}

QImage picture(const test::ObjUv &obj, const LayoutOptions &options)
{
    const auto png = layoutPng(*obj.mesh, obj.uv, options);
    return png.ok() ? QImage::fromData(png.value(), "PNG") : QImage();
}

QColor at(const QImage &image, double u, double v)
{
    return image.pixelColor(static_cast<int>(u * image.width()), static_cast<int>((1 - v) * image.height()));
}

double signedArea(const std::vector<Vec2> &loop)
{
    double doubled = 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        doubled += cross2(loop[0], loop[i], loop[i + 1]);
    return doubled / 2;
}

const QColor seamColor(0xDB, 0x25, 0x12);

} // namespace

class TestUvExport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void islandsAreOutlinedOnce()
    {
        const test::ObjUv obj = twoSquares();
        const LayoutPaths paths = layoutPaths(*obj.mesh, obj.uv, 1, {1, 99, -1});
        QCOMPARE(paths.islands.size(), std::size_t(2));
        for (const auto &island : paths.islands) {
            QCOMPARE(island.size(), std::size_t(1));
            QCOMPARE(island[0].size(), std::size_t(4));
            QVERIFY(std::abs(signedArea(island[0]) - 0.09) < 1e-12);
        }
        QCOMPARE(paths.borders.size(), std::size_t(2));
        QVERIFY(paths.borders[0].closed && paths.borders[1].closed);
        QCOMPARE(paths.borders[0].points.size(), std::size_t(4));
        // The diagonal of the polygon is no edge, the edge between the two triangles is.
        QCOMPARE(paths.innerEdges.size(), std::size_t(1));
        QCOMPARE(paths.overlaps.size(), std::size_t(1));
    }

    void foldedIslandsCoverBothSides()
    {
        // The second triangle is folded back and reaches out on the other side.
        const test::ObjUv obj = test::parseObjUv("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                                 "vt 0.2 0.2\nvt 0.6 0.2\nvt 0.6 0.6\nvt 0.9 0.3\n"
                                                 "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
        LayoutOptions options;
        options.size = 200;
        options.edges = false;
        const QImage image = picture(obj, options);
        const QColor inside = at(image, 0.55, 0.3);
        QCOMPARE(at(image, 0.75, 0.38), inside);
        QVERIFY(at(image, 0.3, 0.5) != inside);
        const LayoutPaths paths = layoutPaths(*obj.mesh, obj.uv, 1, {});
        QCOMPARE(paths.borders.size(), std::size_t(1));
        QCOMPARE(paths.borders[0].points.size(), std::size_t(4));
    }

    void picturesShowIslandsSeamsAndBackground()
    {
        const test::ObjUv obj = twoSquares();
        LayoutOptions options;
        options.size = 2048; // the seams are wider than a pixel
        for (const auto background :
             {LayoutBackground::Dark, LayoutBackground::Light, LayoutBackground::Transparent}) {
            options.background = background;
            const QImage image = picture(obj, options);
            QCOMPARE(image.size(), QSize(2048, 2048));
            QCOMPARE(at(image, 0.25, 0.6).alpha(), background == LayoutBackground::Transparent ? 0 : 255);
            const QColor first = at(image, 0.25, 0.25), second = at(image, 0.8, 0.65);
            QVERIFY(first != second);
            QVERIFY(first != at(image, 0.25, 0.6));
            QCOMPARE(at(image, 0.1, 0.25), seamColor);
            QCOMPARE(at(image, 0.75, 0.9), seamColor);
            // No seam along the edge between the triangles, but an edge.
            QVERIFY(at(image, 0.7, 0.7) != seamColor);
            QVERIFY(at(image, 0.7, 0.7) != second);
        }
        options.edges = false;
        QCOMPARE(at(picture(obj, options), 0.7, 0.7), at(picture(obj, options), 0.8, 0.65));
    }

    void bleedGoesBeyondTheOutline()
    {
        const test::ObjUv obj = twoSquares();
        LayoutOptions options;
        options.size = 512;
        options.edges = options.seams = false;
        for (const auto background : {LayoutBackground::Dark, LayoutBackground::Transparent}) {
            options.background = background;
            options.bleed = 0;
            const QImage plain = picture(obj, options);
            options.bleed = 20;
            const QImage bled = picture(obj, options);
            // 10 pixels, and 30, outside of the first square, which ends at 0.4.
            const double near = 0.4 + 10.0 / 512, far = 0.4 + 30.0 / 512;
            QCOMPARE(at(bled, near, 0.25), at(bled, 0.25, 0.25));
            QCOMPARE(at(bled, 0.25, 0.25), at(plain, 0.25, 0.25));
            QVERIFY(at(plain, near, 0.25) != at(plain, 0.25, 0.25));
            QCOMPARE(at(bled, far, 0.25), at(plain, far, 0.25));
        }
        // A neighbour is never covered.
        options.bleed = 256;
        const QImage wide = picture(obj, options);
        QVERIFY(at(wide, 0.25, 0.25) != at(wide, 0.8, 0.65));
        QVERIFY(layoutSvg(*obj.mesh, obj.uv, options).value().contains("<g id=\"bleed\""));
        options.bleed = 257;
        QVERIFY(!layoutPng(*obj.mesh, obj.uv, options).ok());
    }

    void coloursAreChosen()
    {
        const test::ObjUv obj = twoSquares();
        LayoutOptions options;
        options.size = 2048;
        options.islandColor = QColor(10, 20, 30);
        options.seamColor = QColor(1, 255, 2);
        const QImage image = picture(obj, options);
        QCOMPARE(at(image, 0.25, 0.25), QColor(10, 20, 30));
        QCOMPARE(at(image, 0.8, 0.65), QColor(10, 20, 30));
        QCOMPARE(at(image, 0.1, 0.25), QColor(1, 255, 2));
        options.fill = false;
        QVERIFY(at(picture(obj, options), 0.25, 0.25) != QColor(10, 20, 30));
        const QByteArray svg = layoutSvg(*obj.mesh, obj.uv, options).value();
        QVERIFY(!svg.contains("<g id=\"islands\"") && svg.contains("#01ff02"));
    }

    void overlapsAreHatched()
    {
        const test::ObjUv obj = twoSquares();
        LayoutOptions options;
        options.size = 512;
        options.edges = false;
        const QImage plain = picture(obj, options);
        options.overlapping = {0, 1};
        const QImage hatched = picture(obj, options);
        int changed = 0, red = 0;
        for (int y = 0; y < 512; ++y) {
            for (int x = 0; x < 512; ++x) {
                const bool inFirst = x < 0.42 * 512 && y > 0.58 * 512;
                changed += inFirst && plain.pixel(x, y) != hatched.pixel(x, y);
                if (!inFirst)
                    QCOMPARE(plain.pixel(x, y), hatched.pixel(x, y));
                red += hatched.pixelColor(x, y).red() - hatched.pixelColor(x, y).green() > 130;
            }
        }
        QVERIFY(changed > 0.08 * 512 * 512);
        QVERIFY(red > 0.01 * 512 * 512 && red < 0.05 * 512 * 512);
    }

    //! Islands that cross themselves all over, as broken files have, are painted in other pieces.
    void tanglesAreFilled_data()
    {
        QTest::addColumn<int>("bleed");
        QTest::newRow("plain") << 0;
        QTest::newRow("bleeding") << 3;
    }
    void tanglesAreFilled()
    {
        QFETCH(int, bleed);
        test::ObjUv obj;
        obj.mesh = test::grid(20);
        std::mt19937 random(5);
        const auto unit = [&] { return random() / 4294967296.0; };
        std::map<int, Vec2> places; // of vertices: all are joined
        obj.uv.resize(obj.mesh->cornerCount(), 2);
        for (int c = 0; c < obj.mesh->cornerCount(); ++c) {
            const auto [place, isNew] = places.try_emplace(obj.mesh->cornerVertex[c]);
            if (isNew) // in the left half
                place->second = Vec2(0.1 + 0.4 * unit(), 0.1 + 0.8 * unit());
            obj.uv.row(c) = place->second;
        }
        LayoutOptions options;
        options.size = 256;
        options.seams = options.edges = false;
        options.bleed = bleed;
        options.islandColor = QColor(10, 20, 30);
        const QImage image = picture(obj, options);
        const auto isIn = [&](const Vec2 &p) {
            for (const auto &[a, b, c] : obj.mesh->triangles) {
                const Vec2 u = obj.uv.row(a), v = obj.uv.row(b), w = obj.uv.row(c);
                const double d = cross2(u, v, p), e = cross2(v, w, p), f = cross2(w, u, p);
                if ((d > 0 && e > 0 && f > 0) || (d < 0 && e < 0 && f < 0))
                    return true;
            }
            return false;
        };
        int inside = 0;
        for (int i = 0; i < 400; ++i) {
            const int x = static_cast<int>(256 * unit()), y = static_cast<int>(256 * unit());
            if (isIn(Vec2((x + 0.5) / 256, 1 - (y + 0.5) / 256))) {
                QCOMPARE(image.pixelColor(x, y), QColor(10, 20, 30));
                ++inside;
            }
        }
        QVERIFY(inside > 50);
        QVERIFY(at(image, 0.8, 0.5) != QColor(10, 20, 30));
    }

    void aStopEndsThePicture()
    {
        const test::ObjUv obj = twoSquares();
        const std::atomic<bool> stop = true, goOn = false;
        const QByteArray whole = layoutPng(*obj.mesh, obj.uv).value();
        QCOMPARE(layoutPng(*obj.mesh, obj.uv, {}, &goOn).value(), whole);
        QVERIFY(layoutPng(*obj.mesh, obj.uv, {}, &stop).value() != whole);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.png"));
        QVERIFY(!writeLayoutPictures({{1001, path}}, *obj.mesh, obj.uv, {}, &stop).ok());
        QVERIFY(!QFileInfo::exists(path));
        QVERIFY(writeLayoutPictures({{1001, path}}, *obj.mesh, obj.uv, {}, &goOn).ok());
        QCOMPARE(loadFile(path, 1 << 24).value(), whole);
    }

    //! Also where there are many.
    void holesStayOpen()
    {
        const test::MeshPtr whole = test::grid(21);
        std::vector<Vec3> points;
        std::vector<std::vector<int>> faces;
        for (int v = 0; v < whole->vertexCount(); ++v)
            points.push_back(whole->positions.row(v));
        for (int f = 0; f < whole->faceCount(); ++f) {
            if (f % 21 % 2 == 0 || f / 21 % 2 == 0)
                faces.emplace_back(whole->cornerVertex.begin() + whole->faceStart[f],
                                   whole->cornerVertex.begin() + whole->faceStart[f + 1]);
        }
        test::ObjUv obj;
        obj.mesh = test::polygonMesh(points, faces);
        obj.uv.resize(obj.mesh->cornerCount(), 2);
        for (int c = 0; c < obj.mesh->cornerCount(); ++c)
            obj.uv.row(c) = obj.mesh->cornerPosition(c).head<2>();
        LayoutOptions options;
        options.size = 420;
        options.seams = options.edges = false;
        options.islandColor = QColor(10, 20, 30);
        const QImage image = picture(obj, options);
        for (int i = 0; i < 21 * 21; ++i) {
            const bool isHole = i % 21 % 2 == 1 && i / 21 % 2 == 1;
            const QColor color = at(image, (i % 21 + 0.5) / 21, (i / 21 + 0.5) / 21);
            QCOMPARE(color != QColor(10, 20, 30), isHole);
        }
    }

    void sameInputGivesSameBytes()
    {
        const test::ObjUv obj = twoSquares();
        LayoutOptions options;
        options.size = 300;
        options.overlapping = {2};
        QCOMPARE(layoutPng(*obj.mesh, obj.uv, options).value(),
                 layoutPng(*obj.mesh, obj.uv, options).value());
        QCOMPARE(layoutSvg(*obj.mesh, obj.uv, options).value(),
                 layoutSvg(*obj.mesh, obj.uv, options).value());
    }

    void svgHasItsGroups()
    {
        const test::ObjUv obj = twoSquares();
        LayoutOptions options;
        options.size = 1000;
        options.overlapping = {0};
        const QByteArray svg = layoutSvg(*obj.mesh, obj.uv, options).value();
        QXmlStreamReader reader(svg);
        QStringList ids;
        QStringList islandPaths;
        while (!reader.atEnd()) {
            if (reader.readNext() != QXmlStreamReader::StartElement)
                continue;
            if (reader.attributes().hasAttribute(QLatin1String("id")))
                ids << reader.attributes().value(QLatin1String("id")).toString();
            if (reader.name() == QLatin1String("path") && ids.last() == QLatin1String("islands"))
                islandPaths << reader.attributes().value(QLatin1String("d")).toString();
        }
        QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
        QCOMPARE(ids,
                 QStringList({QStringLiteral("hatch"), QStringLiteral("frame"), QStringLiteral("islands"),
                              QStringLiteral("edges"), QStringLiteral("overlaps"), QStringLiteral("seams")}));
        QCOMPARE(islandPaths.size(), 2);
        QCOMPARE(islandPaths[0], QStringLiteral("M100 900L400 900L400 600L100 600Z"));
        QVERIFY(svg.contains("stroke=\"#db2512\""));
        options.edges = false;
        options.overlapping.clear();
        const QByteArray plain = layoutSvg(*obj.mesh, obj.uv, options).value();
        QVERIFY(!plain.contains("edges") && !plain.contains("hatch"));
    }

    void hostileMapsAreDrawn_data()
    {
        QTest::addColumn<double>("u");
        QTest::addColumn<double>("v");
        QTest::newRow("missing") << std::numeric_limits<double>::quiet_NaN() << 0.0;
        QTest::newRow("far") << 1e300 << -1e300;
        QTest::newRow("huge") << 1e12 << 0.5;
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << 0.5;
    }

    void hostileMapsAreDrawn()
    {
        QFETCH(double, u);
        QFETCH(double, v);
        test::ObjUv obj = twoSquares();
        obj.uv.row(2) << u, v;
        LayoutOptions options;
        options.size = 64;
        options.overlapping = {0, 1, 2, 3};
        QVERIFY(!picture(obj, options).isNull());
        QVERIFY(layoutSvg(*obj.mesh, obj.uv, options).ok());
        for (const auto &island : layoutPaths(*obj.mesh, obj.uv, 1, {}).islands) {
            for (const auto &loop : island) {
                for (const Vec2 &p : loop)
                    QVERIFY(p.minCoeff() >= -1 && p.maxCoeff() <= 2);
            }
        }
    }

    void sizesOutOfRangeAreRefused()
    {
        const test::ObjUv obj = twoSquares();
        for (const int size : {-1, 0, 15, 16385}) {
            LayoutOptions options;
            options.size = size;
            QVERIFY(!layoutPng(*obj.mesh, obj.uv, options).ok());
            QVERIFY(!layoutSvg(*obj.mesh, obj.uv, options).ok());
        }
        const test::ObjUv empty = test::parseObjUv("");
        QVERIFY(layoutPng(*empty.mesh, empty.uv, {}).ok());
    }
};

QTEST_APPLESS_MAIN(TestUvExport)

} // namespace tst_uvexport

#include "tst_uvexport.moc"
