// The picture of the map that is drawn in pieces: the same as the one drawn at once, whatever covers what.
#include "model/plain/uvlayout.h"
#include "support/editsupport.h"
#include "support/meshbuilders.h"
#include "views/canvas/glresources.h"
#include "views/gl/meshframe.h"
#include "views/ui/preferences.h"

#include <QGuiApplication>
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <QTest>

namespace tst_gradualpicture {

using namespace autocuts;
using test::MeshPtr;

namespace {

constexpr int side = 96;

QOpenGLFramebufferObjectFormat smoothFormat()
{
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(4);
    return format;
}

//! The faces of a grid, all on one quarter of the view, the later ones on the earlier ones.
std::vector<float> stackedUvs(const MeshData &mesh)
{
    std::vector<float> uvs;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const float low = 0.2f + 1e-4f * static_cast<float>(t % 50);
        for (const auto &[u, v] : {std::pair(low, low), std::pair(0.8f, 0.3f), std::pair(0.4f, 0.7f)})
            uvs.insert(uvs.end(), {u, v});
    }
    return uvs;
}

//! Where pictures differ; empty: nowhere.
QString differences(const QImage &a, const QImage &b)
{
    int count = 0, most = 0, first = -1;
    for (int place = 0; place < side * side; ++place) {
        const QColor p = a.pixelColor(place % side, place / side),
                     q = b.pixelColor(place % side, place / side);
        const int difference = std::max(
            {std::abs(p.red() - q.red()), std::abs(p.green() - q.green()), std::abs(p.blue() - q.blue())});
        if (difference > 0 && count++ == 0)
            first = place;

        most = std::max(most, difference);
    }
    return count == 0 ? QString()
                      : QStringLiteral("%1 pixels by up to %2, the first at %3, %4")
                            .arg(count)
                            .arg(most)
                            .arg(first % side)
                            .arg(first / side);
}

} // namespace

class TestGradualPicture : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QSurfaceFormat format;
        format.setVersion(3, 3);
        format.setProfile(QSurfaceFormat::CoreProfile);
        mSurface.setFormat(format);
        mSurface.create();
        mContext.setFormat(format);
        QVERIFY(mContext.create() && mContext.makeCurrent(&mSurface));
        auto *functions = QOpenGLVersionFunctionsFactory::get<GlFunctions>(&mContext);
        QVERIFY(functions && functions->initializeOpenGLFunctions());
        mGl = std::make_unique<GlResources>(*functions, true);
    }
    void cleanupTestCase() { mGl.reset(); }

    void piecesMakeTheSamePicture_data()
    {
        QTest::addColumn<int>("quads");
        QTest::addColumn<bool>("stacked");
        QTest::addColumn<bool>("ghost");
        QTest::newRow("a map") << 12 << false << false;
        QTest::newRow("a map and what shines through") << 12 << false << true;
        QTest::newRow("512 triangles on one another") << 16 << true << false;
        QTest::newRow("and what shines through") << 16 << true << true;
    }

    void piecesMakeTheSamePicture()
    {
        QFETCH(const int, quads);
        QFETCH(const bool, stacked);
        QFETCH(const bool, ghost);
        const MapScene scene = sceneOf(test::grid(quads), stacked, ghost);
        const QImage whole = drawn([&] { drawScene(mGl->forMap(), scene); });
        MapScene empty = scene;
        empty.map.reset();
        QVERIFY(whole != drawn([&] { drawScene(mGl->forMap(), empty); }));
        GradualPicture picture;
        QVERIFY(!picture.has(scene, {side, side}));
        picture.begin(scene, {side, side});
        int pieces = 0;
        for (; picture.isBusy(); ++pieces)
            picture.goOn(mGl->forMap(), 0);
        qInfo() << pieces << "pieces";
        QVERIFY(picture.has(scene, {side, side}));
        QCOMPARE(differences(shown(picture, scene.camera), whole), QString());
    }

    //! However much lies on the strip, what is drawn at once covers no more than asked for, unless it is one
    //! triangle; and nothing is left out.
    void piecesAreSmall_data()
    {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<double>("most");
        QTest::newRow("a strip") << 30.0 << 34.0 << 1000.0;
        QTest::newRow("a row") << 30.0 << 31.0 << 200.0;
        QTest::newRow("all of it") << 0.0 << double(side) << 50'000.0;
        QTest::newRow("one by one") << 30.0 << 60.0 << 1.0;
    }

    void piecesAreSmall()
    {
        QFETCH(const double, low);
        QFETCH(const double, high);
        QFETCH(const double, most);
        const MeshPtr mesh = test::grid(16);
        const std::vector<float> uvs = stackedUvs(*mesh);
        std::vector<FaceTexel> faces(mesh->triangleCount());
        for (std::size_t t = 0; t < faces.size(); t += 3)
            faces[t].marks = t % 2 == 0 ? FaceTexel::Hidden : FaceTexel::Buried;
        const MapOnPixels map{uvs, faces, {9, 10}, {side, side}, {0, 0}, side};
        std::vector<int> drawn;
        for (int next = 0, pieces = 0; next < map.triangleCount(); ++pieces) {
            QVERIFY(pieces <= map.triangleCount());
            const TriangleRuns runs = trianglesInStrip(map, low, high, most, next);
            double covered = 0;
            int shown = 0;
            for (std::size_t i = 0; i < runs.first.size(); ++i) {
                for (int t = runs.first[i] / 3; t < (runs.first[i] + runs.count[i]) / 3; ++t) {
                    if (faces[t].marks != 0 && t != 9)
                        continue;
                    // Of the box around it: 0.6 by 0.5 of the picture, from 0.2 on.
                    covered += 0.6 * side * (std::min(0.7 * side, high) - std::max(0.2 * side, low));
                    ++shown;
                    drawn.push_back(t);
                }
            }
            QVERIFY2(shown == 1 || covered <= most, qPrintable(QString::number(covered)));
        }
        std::vector<int> all;
        for (int t = 0; t < map.triangleCount(); ++t) {
            if (faces[t].marks == 0 || t == 9)
                all.push_back(t);
        }
        QCOMPARE(drawn, all);
        int beside = 0;
        QVERIFY(trianglesInStrip(map, 0.9 * side, side, most, beside).first.empty());
        QCOMPARE(beside, map.triangleCount());
    }

    //! A large map is not looked through in one go, even where nothing of it is drawn.
    void aLargeMapIsLookedThroughInParts()
    {
        const MeshPtr mesh = test::grid(160);
        const std::vector<float> uvs = stackedUvs(*mesh);
        const std::vector<FaceTexel> faces(mesh->triangleCount());
        const MapOnPixels map{uvs, faces, {0, 0}, {side, side}, {0, 0}, side};
        int next = 0;
        QVERIFY(trianglesInStrip(map, 0.9 * side, side, 1e9, next).first.empty());
        QVERIFY(next > 0 && next < map.triangleCount());
        QVERIFY(trianglesInStrip(map, 0.9 * side, side, 1e9, next).first.empty());
        QCOMPARE(next, map.triangleCount());
    }

    void meanwhileTheLastOneIsShown()
    {
        MapScene scene = sceneOf(test::grid(12), false, false);
        GradualPicture picture;
        complete(picture, scene);
        const QImage before = shown(picture, scene.camera);
        MapScene other = scene;
        other.camera.pan({20, 10});
        other.revision = ++mRevision;
        QVERIFY(!picture.has(other, {side, side}));
        // At once where the camera sees it, before anything is drawn.
        const QImage moved = shown(picture, other.camera);
        QVERIFY(moved.copy(20, 10, side - 20, side - 10) == before.copy(0, 0, side - 20, side - 10));
        picture.begin(other, {side, side});
        picture.goOn(mGl->forMap(), 0);
        QVERIFY(picture.isBusy());
        QVERIFY(shown(picture, other.camera) == moved);
        picture.abandon();
        QVERIFY(!picture.isBusy() && !picture.has(other, {side, side}));
        QVERIFY(shown(picture, other.camera) == moved);
    }

private:
    MapScene sceneOf(const MeshPtr &mesh, bool stacked, bool ghost)
    {
        const Scene model = test::sceneOf(mesh);
        const UvMatrix map = test::splitLayout(*mesh);
        const std::vector<float> flat = soupUvs(0.4 * soupUv(*mesh, map));
        mGl->soup.setVertices(soupVertices(*mesh, model.hardEdges, MeshFrame::of(*mesh)));
        mUvs = stacked ? stackedUvs(*mesh) : flat;
        mGhostUvs = ghost ? flat : std::vector<float>();
        mGl->soup.setUvs(mUvs);
        mGl->soup.setGhostUvs(mGhostUvs);
        std::vector<FaceTexel> &faces = mFaces;
        faces.assign(mesh->triangleCount(), {});
        for (std::size_t t = 0; t < faces.size(); ++t)
            faces[t] = {static_cast<quint8>(40 + t % 200), static_cast<quint8>(t / 200), 90,
                        static_cast<quint8>(t % 7 == 0 ? FaceTexel::Selected : 0)};
        mGl->soup.setFaces(faces);
        mGl->soup.setIslands(std::vector<quint32>(faces.size(), 1));
        mGl->soup.setSides(
            std::vector<SideTexel>(3 * faces.size(), {static_cast<quint8>(SideStyle::Wire), {0, 0}, 0}));
        MapScene scene;
        scene.revision = ++mRevision;
        scene.uvs = mUvs;
        scene.ghostUvs = mGhostUvs;
        scene.faces = mFaces;
        scene.colors = ViewColors::of(PreferenceValues(), true);
        scene.camera.setViewSize({side, side});
        scene.camera.setScale(side);
        scene.paper.tilePixels = side;
        scene.paper.gridPixels = 30;
        SoupDrawing drawing;
        drawing.mapScale = {2, 2};
        drawing.mapOffset = {-1, -1};
        drawing.fillOpacity = 0.6;
        if (ghost) {
            scene.ghost = drawing;
            scene.ghost->ghost = true;
            scene.ghost->lineOpacity = 0;
        }
        scene.map = drawing;
        return scene;
    }

    void complete(GradualPicture &picture, const MapScene &scene)
    {
        picture.begin(scene, {side, side});
        while (picture.isBusy())
            picture.goOn(mGl->forMap(), 0);
    }

    template <typename Draw>
    QImage drawn(Draw draw)
    {
        QOpenGLFramebufferObject target(QSize(side, side), smoothFormat());
        target.bind();
        mGl->gl.glViewport(0, 0, side, side);
        mGl->gl.glClear(GL_DEPTH_BUFFER_BIT);
        draw();
        return target.toImage();
    }

    QImage shown(GradualPicture &picture, const MapCamera &camera)
    {
        QOpenGLFramebufferObject target(QSize(side, side), smoothFormat());
        picture.show(mGl->forMap(), target.handle(), target.size(), camera);
        return target.toImage();
    }

    std::vector<float> mUvs, mGhostUvs;
    std::vector<FaceTexel> mFaces;
    QOffscreenSurface mSurface;
    QOpenGLContext mContext;
    std::unique_ptr<GlResources> mGl;
    quint64 mRevision = 0;
};

QTEST_MAIN(TestGradualPicture)

} // namespace tst_gradualpicture

#include "tst_gradualpicture.moc"
