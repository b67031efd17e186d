// What would keep the window from answering is not done in one go: paints, tables, pictures.
#include "commands/setuvs.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "support/panelongrid.h"
#include "views/canvas/madepictures.h"
#include "views/canvas/mapoverlays.h"
#include "views/control/files/opening.h"
#include "views/gl/meshdrawing.h"
#include "views/gl/patterntexture.h"
#include "views/panels/packpanel.h"

#include <QHeaderView>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <QPainter>
#include <QPicture>
#include <QResizeEvent>
#include <QSignalSpy>
#include <QStyledItemDelegate>
#include <QTest>
#include <QThread>
#include <QTreeWidget>

#include <bit>
#include <future>

namespace tst_shortturns {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

namespace {

//! Counts how often views are painted.
class CountingTool final : public AbstractTool
{
public:
    CountingTool(const StudioContext &context, int &count)
        : AbstractTool(context, u"counting"_s), mCount(count)
    {}
    QString hint() const override { return {}; }
    void press(const ToolEvent &) override {}
    void move(const ToolEvent &) override {}
    void release(const ToolEvent &) override {}
    void drawOverlay(QPainter &, const ToolCanvas &) override { ++mCount; }

private:
    int &mCount;
};

//! Counts the rows that are measured.
class CountingDelegate final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        ++mCount;
        return QStyledItemDelegate::sizeHint(option, index);
    }
    int count() const { return mCount; }

private:
    mutable int mCount = 0;
};

//! One face in each tile.
std::unique_ptr<Document> manyTiles(int side)
{
    const test::MeshPtr mesh = test::grid(side);
    Scene scene = test::sceneOf(mesh);
    UvMatrix uv = test::splitLayout(*mesh);
    for (int face = 0; face < mesh->faceCount(); ++face) {
        const Vec2 tile(face % 10, face / 10);
        const double corners[4][2] = {{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}};
        for (int k = 0; k < 4; ++k)
            uv.row(mesh->faceStart[face] + k) << tile.x() + corners[k][0], tile.y() + corners[k][1];
    }
    scene.uvSets.push_back({u"tiles"_s, uv});
    return std::make_unique<Document>(std::move(scene));
}

} // namespace

class TestShortTurns : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! The window paints after all of its views have their sizes.
    void aNewSizeIsPaintedOnce()
    {
        Canvases studio;
        studio.open(test::layoutDocument(test::grid(4)));
        int paints = 0;
        studio.tools.add(std::make_unique<CountingTool>(studio.context, paints));
        studio.tools.setTool(u"counting"_s);
        for (Canvas *canvas : {static_cast<Canvas *>(&studio.mesh), static_cast<Canvas *>(&studio.uv)}) {
            QTRY_VERIFY(paints > 0);
            QCoreApplication::processEvents();
            paints = 0;
            QResizeEvent event(canvas->size(), canvas->size() + QSize(10, 10));
            QCoreApplication::sendEvent(canvas, &event);
            QCOMPARE(paints, 0);
            QTRY_VERIFY(paints > 0);
            QVERIFY(!canvas->picture().isNull());
        }
    }

    //! The columns are wide enough for all rows, yet not all rows are measured.
    void manyTilesAreListed()
    {
        test::Bench<PackPanel> bench(false);
        auto *list = test::child<QTreeWidget>(bench.panel, "tiles");
        CountingDelegate delegate;
        list->setItemDelegate(&delegate);
        bench.workspace.open(manyTiles(40), {});
        QVERIFY(bench.measured());
        QVERIFY(bench.followed());
        QCOMPARE(list->topLevelItemCount(), 1600);
        QVERIFY(list->isVisible());
        QVERIFY(!list->grab().isNull());
        QVERIFY2(delegate.count() < 400, qPrintable(QString::number(delegate.count())));
        for (int column = 0; column < 3; ++column) {
            int widest = 0;
            for (int row = 0; row < list->topLevelItemCount(); row += 399)
                widest = std::max(
                    widest, list->fontMetrics().horizontalAdvance(list->topLevelItem(row)->text(column)));
            QVERIFY(list->columnWidth(column) > widest);
            QVERIFY(list->columnWidth(column) >= list->header()->sectionSizeHint(column));
        }
    }

    void tilesThatCannotBeSeenAreNotDrawn()
    {
        const ViewColors colors = ViewColors::of({}, true);
        MapCamera camera;
        const QRect view(0, 0, 200, 200);
        camera.setViewSize(view.size());
        camera.setCentre(Vec2(0.5, 0.5));
        using Tiles = std::vector<std::pair<int, QColor>>;
        const auto size = [&](double scale, const Tiles &tiles) {
            camera.setScale(scale);
            QPicture picture;
            QPainter painter(&picture);
            drawTilesInUse(painter, view, colors, camera, 1, tiles);
            painter.end();
            return picture.size();
        };
        const Tiles near{{1001, {}}, {1002, {}}};
        Tiles all = near;
        for (int tile = 1100; tile < 3000; ++tile)
            all.emplace_back(tile, QColor());
        QVERIFY(size(100, near) > size(100, {}));
        QCOMPARE(size(100, all), size(100, near));
        QCOMPARE(size(4, near), size(4, {}));                          // too small for a line
        QVERIFY(size(4, {{1001, QColor(Qt::red)}}) > size(4, {}));     // its tint can be seen
        QCOMPARE(size(100, {{1950, QColor(Qt::red)}}), size(100, {})); // outside
    }

    void picturesAreMadeOnceForAllViews()
    {
        std::atomic<int> made = 0;
        std::atomic<QThread *> thread = nullptr;
        const auto make = [&] {
            ++made;
            thread = QThread::currentThread();
            QImage image(8, 4, QImage::Format_RGB32);
            image.fill(Qt::red);
            return Pictures::of(image);
        };
        MadePictures first, second;
        first.ask(u"red"_s, make, false);
        second.ask(u"red"_s, make, false);
        QVERIFY(first.pictures().images.empty());
        QTRY_VERIFY(!first.pictures().images.empty() && !second.pictures().images.empty());
        QCOMPARE(made.load(), 1);
        QVERIFY(thread != QThread::currentThread());
        const QImage &image = first.pictures().images.front();
        QCOMPARE(image.cacheKey(), second.pictures().images.front().cacheKey());
        QCOMPARE(image.format(), QImage::Format_RGBA8888);
        QCOMPARE(first.pictures().smaller.front().size(), std::size_t(3)); // 4 x 2, 2 x 1, 1 x 1
        // What nobody wants any more is not made; what was there may stay until the next is.
        {
            const Task::Hold busy;
            first.ask(u"second"_s, make, true);
            first.ask(u"third"_s, make, true);
            QCOMPARE(first.pictures().images.front().cacheKey(), image.cacheKey());
            second.ask({}, make, true);
            QVERIFY(second.pictures().images.empty());
        }
        const qint64 before = first.pictures().images.front().cacheKey();
        QTRY_VERIFY(first.pictures().images.front().cacheKey() != before);
        Task::waitForAll();
        QCOMPARE(made.load(), 2);
    }

    void picturesAreReadyForTheUpload()
    {
        QImage image(2, 2, QImage::Format_ARGB32);
        image.setPixel(0, 0, qRgba(10, 0, 0, 0)); // colours below full transparency are data, too
        image.setPixel(1, 0, qRgba(20, 0, 0, 0));
        image.setPixel(0, 1, qRgba(30, 100, 0, 0));
        image.setPixel(1, 1, qRgba(40, 100, 0, 100));
        QImage other(4, 1, QImage::Format_RGB32);
        other.fill(Qt::blue);
        const Pictures alone = readyForUpload(Pictures::of(image));
        QCOMPARE(alone.images.front(), image.convertToFormat(QImage::Format_RGBA8888));
        QCOMPARE(alone.smaller.front().size(), std::size_t(1));
        QCOMPARE(alone.smaller.front().front().pixel(0, 0), qRgba(25, 50, 0, 25));
        const Pictures both = readyForUpload({1, {image, other}, {{0, {}}, {1, {}}}});
        for (const QImage &each : both.images)
            QCOMPARE(each.size(), QSize(4, 2));
        QCOMPARE(both.images[1].pixel(3, 1), qRgb(0, 0, 255));
    }

    //! Large pictures are uploaded in parts; those before are drawn meanwhile.
    void picturesAreUploadedInParts()
    {
        Canvases studio;
        studio.mesh.makeCurrent();
        auto *gl = QOpenGLVersionFunctionsFactory::get<GlFunctions>(QOpenGLContext::currentContext());
        QVERIFY(gl && gl->initializeOpenGLFunctions());
        {
            PatternTexture texture(*gl);
            const auto finished = [&] {
                int parts = 0;
                for (; texture.isBusy(); ++parts)
                    texture.goOn(0);
                return parts;
            };
            QImage small(4, 4, QImage::Format_RGBA8888), large(2048, 2048, QImage::Format_RGBA8888);
            small.fill(Qt::red);
            large.fill(Qt::blue);
            const Pictures first = readyForUpload(Pictures::of(small)),
                           second = readyForUpload(Pictures::of(large));
            texture.begin(first, false);
            QVERIFY(!texture.show() && texture.isEmpty());
            finished();
            QVERIFY(texture.isEmpty() && texture.show() && !texture.isEmpty() && texture.has(first));
            QVERIFY(!texture.show());
            texture.begin(second, true);
            texture.goOn(0);
            QVERIFY(texture.isBusy() && !texture.show() && !texture.isEmpty() && !texture.has(second));
            QVERIFY(finished() > 10);
            QVERIFY(texture.show() && texture.has(second));
            texture.begin(Pictures::of(small), false); // without smaller copies
            QVERIFY(texture.isEmpty());
            finished();
            QVERIFY(texture.show() && !texture.isEmpty());
            texture.begin({}, true);
            QVERIFY(!texture.isBusy() && texture.isEmpty());
            QVERIFY(texture.show() && texture.has({}));
        }
        studio.mesh.doneCurrent();
    }

    //! Views go on while it is drawn, and show it afterwards.
    void lettersAreDrawnOnAnotherThread()
    {
        Canvases studio;
        studio.open(test::layoutDocument(test::grid(4)));
        studio.lookFromFront();
        const QImage plainMap = studio.uv.picture(), plainModel = studio.mesh.picture();
        ViewOptions options = studio.view.options();
        {
            const Task::Hold busy;
            options.pattern = Pattern::Lettered;
            options.letteredCells = 3;
            studio.view.setOptions(options);
            QVERIFY(!studio.uv.picture().isNull()); // does not wait
            QCOMPARE(studio.mesh.picture(), plainModel);
        }
        QTRY_VERIFY(studio.uv.picture() != plainMap && studio.mesh.picture() != plainModel);
        const QImage three = studio.mesh.picture();
        {
            const Task::Hold busy;
            options.letteredCells = 5;
            studio.view.setOptions(options);
            QCOMPARE(studio.mesh.picture(), three); // until the next is there
        }
        QTRY_VERIFY(studio.mesh.picture() != three);
        options.pattern = Pattern::None;
        studio.view.setOptions(options);
        QCOMPARE(studio.mesh.picture(), plainModel);
        options.pattern = Pattern::Lettered;
        studio.view.setOptions(options); // still there
        QVERIFY(studio.mesh.picture() != plainModel);
    }

    //! The arrays of a large mesh are not all made in one turn. A picture has all of them.
    void largeMeshesAreUpdatedInTurns_data()
    {
        QTest::addColumn<bool>("asMap");
        QTest::newRow("map") << true;
        QTest::newRow("model") << false;
    }

    void largeMeshesAreUpdatedInTurns()
    {
        QFETCH(bool, asMap);
        Canvases studio;
        const test::MeshPtr small = test::grid(4), large = test::grid(230);
        QVERIFY(large->triangleCount() > SceneContent::mostTrianglesAtOnce);
        SceneContent content(studio.context, asMap);
        studio.open(test::layoutDocument(small));
        QVERIFY(!content.isLarge());
        QCOMPARE(content.refresh(), int(SceneContent::AllParts));
        QVERIFY(content.isUpToDate() && content.canBeDrawn());
        studio.open(test::layoutDocument(large));
        QVERIFY(content.isLarge());
        for (int turns = 1; turns < std::popcount(unsigned(SceneContent::AllParts)); ++turns) {
            QCOMPARE(content.refreshOne(), 0);
            QVERIFY(!content.canBeDrawn() && !content.isUpToDate());
        }
        QCOMPARE(content.refreshOne(), int(SceneContent::AllParts));
        QVERIFY(content.canBeDrawn() && content.isUpToDate());
        QCOMPARE(content.sides().size(), std::size_t(large->soupCornerCount()));
        ViewOptions options = studio.view.options();
        options.coloring = Coloring::SignedStretch;
        options.wireframe = !options.wireframe;
        studio.view.setOptions(options);
        QCOMPARE(content.refreshOne(), 0); // measures
        QCOMPARE(content.refreshOne(), 0); // faces
        QCOMPARE(content.refreshOne(), SceneContent::Measures | SceneContent::Faces | SceneContent::Sides);
        // Those that were made are reported with the rest when all are wanted at once.
        options.coloring = Coloring::Islands;
        options.wireframe = !options.wireframe;
        studio.view.setOptions(options);
        QCOMPARE(content.refreshOne(), 0);
        QCOMPARE(content.refresh(), SceneContent::Faces | SceneContent::Sides);
        QVERIFY(content.isUpToDate());
        QCOMPARE(content.refresh(), 0);
    }

    //! What changes all the time is drawn, too.
    void arraysThatChangeMeanwhileWaitForTheNextRound()
    {
        Canvases studio;
        studio.open(test::layoutDocument(test::grid(230)));
        SceneContent content(studio.context, true);
        content.refresh();
        ViewOptions options = studio.view.options();
        const auto change = [&] {
            options.coloring = options.coloring == Coloring::Plain ? Coloring::Islands : Coloring::Plain;
            options.wireframe = !options.wireframe;
            studio.view.setOptions(options);
        };
        change();
        for (int round = 0; round < 3; ++round) {
            QCOMPARE(content.refreshOne(), 0);
            change();
            QCOMPARE(content.refreshOne(), SceneContent::Faces | SceneContent::Sides);
            change();
            QVERIFY(!content.isUpToDate());
        }
        // Another document does not go on with a round.
        QCOMPARE(content.refreshOne(), 0);
        studio.open(test::layoutDocument(test::grid(231)));
        for (int turns = 1; turns < std::popcount(unsigned(SceneContent::AllParts)); ++turns)
            QCOMPARE(content.refreshOne(), 0);
        QCOMPARE(content.refreshOne(), int(SceneContent::AllParts));
    }

    //! Nor in a turn in which a view is painted; the state of before is shown meanwhile.
    void largeMeshesAreNotUpdatedInAPaint()
    {
        Canvases studio;
        studio.open(test::layoutDocument(test::grid(230)));
        studio.lookFromFront();
        const std::array<Canvas *, 2> views{&studio.uv, &studio.mesh};
        for (Canvas *view : views)
            QTRY_VERIFY(view->content().isUpToDate());
        const std::array before{studio.uv.picture(), studio.mesh.picture()};
        ViewOptions options = studio.view.options();
        options.coloring = Coloring::Islands;
        studio.view.setOptions(options);
        for (Canvas *view : views) {
            QVERIFY(!view->content().isUpToDate());
            view->repaint();
            QVERIFY(!view->content().isUpToDate());
        }
        for (Canvas *view : views)
            QTRY_VERIFY(view->content().isUpToDate());
        QVERIFY(studio.uv.picture() != before[0]);
        QVERIFY(studio.mesh.picture() != before[1]);
        // What a picture needs is made at once.
        options.coloring = Coloring::Plain;
        studio.view.setOptions(options);
        QVERIFY(!studio.mesh.content().isUpToDate());
        QCOMPARE(studio.mesh.picture(), before[1]);
        QVERIFY(studio.mesh.content().isUpToDate());
    }

    //! What takes long of a model is done where it is read.
    void modelsComeReadyForTheViews()
    {
        Canvases studio;
        const QString path = studio.folder.filePath(u"m.obj"_s);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                   "f 1/1 2/2 3/3 4/4\n");
        file.close();
        const PreferenceValues preferences = studio.preferences.values();
        auto read = std::async(std::launch::async, [&, thread = QThread::currentThread()] {
            return std::make_shared<Result<NewDocument>>(
                readModel(path, preferences, thread, std::atomic<bool>()));
        });
        const std::shared_ptr<Result<NewDocument>> result = read.get();
        const Result<NewDocument> &made = *result;
        QVERIFY(made.ok() && made->drawing);
        QCOMPARE(made->document->thread(), QThread::currentThread());
        QCOMPARE(made->document->undoStack().thread(), QThread::currentThread());
        QCOMPARE(made->drawing->mesh, made->document->state().scene.mesh);
        QCOMPARE(made->drawing->vertices.size(), std::size_t(6));
        // Both views use the same.
        studio.files.open(path);
        QTRY_VERIFY(studio.workspace.document() && !studio.files.jobs().isBusy());
        QVERIFY(!studio.mesh.picture().isNull());
        QCOMPARE(&studio.mesh.content().topology(), &studio.uv.content().topology());
        QCOMPARE(&studio.mesh.content().topology(), &studio.workspace.drawing()->topology);
    }
};

QTEST_MAIN(TestShortTurns)

} // namespace tst_shortturns

#include "tst_shortturns.moc"
