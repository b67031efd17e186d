// What both views draw, pixel by pixel, and what they refill after an event.
#include "commands/changesettings.h"
#include "commands/editrectangles.h"
#include "commands/setislandflags.h"
#include "commands/setseamstate.h"
#include "commands/setuvs.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "views/gl/letteredpattern.h"

#include <QSignalSpy>
#include <QTest>

namespace tst_drawing {

using namespace autocuts;
using test::Canvases;

namespace {

//! A grid of 4 x 4 quads, its right half an island of its own.
std::unique_ptr<Document> gridDocument()
{
    return test::layoutDocument(test::grid(4));
}

QColor pixelAt(Canvas &canvas, const QPoint &place)
{
    const QImage picture = canvas.picture();
    return picture.pixelColor(place * picture.devicePixelRatio());
}

} // namespace

class TestDrawing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mStudio = std::make_unique<Canvases>();
        mStudio->open(gridDocument());
        mStudio->lookFromFront();
    }
    void cleanup() { mStudio.reset(); }

    void selectionIsDrawnInBothViews()
    {
        const QColor orange = mStudio->preferences.values().selectionColor;
        for (Canvas *canvas : {static_cast<Canvas *>(&mStudio->mesh), static_cast<Canvas *>(&mStudio->uv)}) {
            const QPoint place = Canvases::middle(*canvas, 6);
            mStudio->select(SelectionMode::Faces);
            const QColor before = pixelAt(*canvas, place);
            Selection selection = mStudio->document().selection();
            selection.faces = {3};
            mStudio->document().setSelection(selection);
            const QColor after = pixelAt(*canvas, place);
            QVERIFY(after.red() - after.blue() > before.red() - before.blue() + 60);
            QVERIFY(std::abs(after.hue() - orange.hue()) < 25);
        }
    }

    void seamsHaveTheirColour()
    {
        const QColor red = mStudio->preferences.values().seamColor;
        for (Canvas *canvas : {static_cast<Canvas *>(&mStudio->mesh), static_cast<Canvas *>(&mStudio->uv)}) {
            const int shown = test::countNear(canvas->picture(), red, 60);
            QVERIFY2(shown > 150, qPrintable(QString::number(shown)));
            ViewOptions options = mStudio->view.options();
            options.seams = false;
            mStudio->view.setOptions(options);
            QVERIFY(test::countNear(canvas->picture(), red, 60) < shown / 10);
            options.seams = true;
            mStudio->view.setOptions(options);
            QCOMPARE(test::countNear(canvas->picture(), red, 60), shown);
        }
    }

    void letteredCellsAreAllDifferent()
    {
        QCOMPARE(letteredCellName(0, 0), QStringLiteral("A1"));
        QCOMPARE(letteredCellName(7, 7), QStringLiteral("H8"));
        const QImage picture = letteredPattern(8);
        const int side = picture.width() / 8;
        std::vector<QImage> cells;
        for (int i = 0; i < 64; ++i) {
            const QImage cell = picture.copy(i % 8 * side, i / 8 * side, side, side);
            QVERIFY(cell != cell.mirrored(true, false) && cell != cell.mirrored(false, true));
            for (const QImage &other : cells)
                QVERIFY(cell != other);
            cells.push_back(cell);
        }
        for (int count : {-5, 1, 2, 26, 1000})
            QVERIFY(!letteredPattern(count).isNull());
    }

    void texturesLieOnTheModelAndBehindTheMap()
    {
        QImage picture(2, 2, QImage::Format_RGB32);
        picture.setPixel(0, 0, qRgb(250, 240, 20)); // upper left: small u, large v
        picture.setPixel(1, 0, qRgb(20, 240, 20));
        picture.setPixel(0, 1, qRgb(20, 30, 240));
        picture.setPixel(1, 1, qRgb(20, 240, 240));
        picture = picture.scaled(64, 64);
        const QString path = mStudio->folder.filePath(QStringLiteral("texture.png"));
        QVERIFY(picture.save(path));
        ViewOptions options;
        options.texturePath = path;
        options.pattern = Pattern::Texture;
        options.fillIslands = false;
        mStudio->view.setOptions(options);
        UvView &uv = mStudio->uv;
        const auto inMap = [&](double u, double v) {
            return pixelAt(uv, uv.camera().toScreen(Vec2(u, v)).toPoint());
        };
        QTRY_VERIFY(inMap(0.3, 0.7).red() > 180);
        QVERIFY(inMap(0.3, 0.7).blue() < 60);
        QVERIFY(inMap(0.3, 0.3).blue() > 180 && inMap(0.3, 0.3).green() < 90);
        QVERIFY(inMap(0.7, 0.7).green() > 180 && inMap(0.7, 0.7).red() < 90);
        // Faces 0 to 4 are the lower row; u is x for the left half.
        const QColor lower = pixelAt(mStudio->mesh, Canvases::middle(mStudio->mesh, 0));
        const QColor upper = pixelAt(mStudio->mesh, Canvases::middle(mStudio->mesh, 2 * 12));
        QVERIFY(lower.blue() > lower.red() + 40);
        QVERIFY(upper.red() > upper.blue() + 40);
        // Filled islands show it as clearly, and stand out from what is behind them.
        options.fillIslands = true;
        mStudio->view.setOptions(options);
        QVERIFY(inMap(0.3, 0.7).red() > 170 && inMap(0.3, 0.7).blue() < 90);
        QVERIFY(inMap(0.7, 0.7).green() < 200);
        // Island colours are seen through it.
        options.coloring = Coloring::Islands;
        mStudio->view.setOptions(options);
        const QColor tinted = pixelAt(mStudio->mesh, Canvases::middle(mStudio->mesh, 0));
        QVERIFY(std::abs(tinted.red() - lower.red()) + std::abs(tinted.green() - lower.green()) +
                    std::abs(tinted.blue() - lower.blue()) >
                40);
        QVERIFY(tinted.blue() > tinted.red());
        options.texturePath = mStudio->folder.filePath(QStringLiteral("gone.png"));
        mStudio->view.setOptions(options);
        QTRY_VERIFY(inMap(0.3, 0.7).red() < 120);
    }

    void rectanglesAreDrawn()
    {
        LayoutRectangle rectangle;
        rectangle.name = QStringLiteral("hands");
        rectangle.color = qRgb(20, 230, 240);
        rectangle.lower = Vec2(0.55, 0.55);
        rectangle.upper = Vec2(0.9, 0.95);
        rectangle.hard = true;
        const QColor color(rectangle.color);
        const int before = test::countNear(mStudio->uv.picture(), color, 90);
        mStudio->document().undoStack().push(EditRectangles::add(mStudio->document(), rectangle));
        QVERIFY(test::countNear(mStudio->uv.picture(), color, 90) > before + 300);
        ViewOptions options;
        options.steering = false;
        mStudio->view.setOptions(options);
        QCOMPARE(test::countNear(mStudio->uv.picture(), color, 90), before);
    }

    void forcedCutsAppearAtOnce()
    {
        const int edge = mStudio->edgeBetween({0.25, 0.25, 0}, {0.25, 0.5, 0});
        const QPoint place = Canvases::middleOfEdge(mStudio->mesh, edge);
        const QColor before = pixelAt(mStudio->mesh, place);
        mStudio->document().undoStack().push(std::make_unique<SetSeamState>(
            mStudio->document(), SetSeamState::Edit::Cut,
            cornerPairsOfEdges(mStudio->document().mesh(), std::vector<int>{edge})));
        const QColor after = pixelAt(mStudio->mesh, place),
                     blue = mStudio->preferences.values().forcedCutColor;
        QVERIFY(after.blue() > before.blue() + 40);
        QVERIFY(std::abs(after.hue() - blue.hue()) < 20);
        mStudio->document().undoStack().undo();
        QCOMPARE(pixelAt(mStudio->mesh, place), before);
    }

    void liveMapsAreDrawnAndPicked()
    {
        UvView &uv = mStudio->uv;
        const MeshData &mesh = mStudio->document().mesh();
        UvMatrix live(mesh.soupCornerCount(), 2);
        for (int t = 0; t < mesh.triangleCount(); ++t) {
            live.row(3 * t) << 0.1 * t, -1;
            live.row(3 * t + 1) << 0.1 * t + 0.09, -1;
            live.row(3 * t + 2) << 0.1 * t, -0.9;
        }
        mStudio->shown.showSoup(live, std::vector<float>(mesh.cornerPairCount(), 1));
        uv.frameAll();
        const QPoint place = Canvases::middle(uv, 9);
        QCOMPARE(uv.pick(place).triangle, 9);
        QVERIFY(pixelAt(uv, place) != pixelAt(uv, place + QPoint(0, 30)));
        mStudio->shown.showDocument();
        QVERIFY(uv.pick(place).triangle != 9);
    }

    void onlyWhatAnEventNamesIsRefilled()
    {
        using Content = SceneContent;
        Content model(mStudio->context, false), map(mStudio->context, true);
        QCOMPARE(model.refresh(), int(Content::AllParts));
        QCOMPARE(map.refresh(), int(Content::AllParts));
        QSignalSpy changes(&model, &Content::changed);
        const auto expect = [&](int ofModel, int ofMap) {
            QVERIFY(!changes.isEmpty());
            changes.clear();
            QCOMPARE(model.refresh(), ofModel);
            QCOMPARE(map.refresh(), ofMap);
        };
        mStudio->view.setHover({3, -1, -1});
        expect(0, 0);
        Selection selection;
        selection.faces = {1};
        mStudio->document().setSelection(selection);
        expect(Content::Faces, Content::Faces);
        selection.edges = {mStudio->edgeBetween({0, 0.25, 0}, {0.25, 0.25, 0})};
        mStudio->document().setSelection(selection);
        expect(Content::Sides, Content::Sides);
        selection.corners = {4};
        mStudio->document().setSelection(selection);
        expect(Content::Points, Content::Points);
        QCOMPARE(model.points().size(), map.points().size());
        mStudio->document().undoStack().push(
            std::make_unique<SetSeamState>(mStudio->document(), SetSeamState::Edit::Cut,
                                           cornerPairsOfEdges(mStudio->document().mesh(), selection.edges)));
        expect(Content::Sides, Content::Sides);
        ViewOptions options;
        options.wireframe = false;
        mStudio->view.setOptions(options);
        expect(Content::Sides, Content::Sides);
        options.coloring = Coloring::Islands;
        mStudio->view.setOptions(options);
        expect(Content::Faces, Content::Faces);
        options.smoothShading = true;
        mStudio->view.setOptions(options);
        expect(0, 0);
        const MeshData &mesh = mStudio->document().mesh();
        mStudio->shown.showSoup(UvMatrix::Random(mesh.soupCornerCount(), 2),
                                std::vector<float>(mesh.cornerPairCount(), 0.2f));
        const int live = Content::Uvs | Content::Faces | Content::Sides;
        expect(live, live | Content::Points | Content::Ghost);
        QVERIFY(model.ghostUvs().empty());
        QCOMPARE(map.ghostUvs().size(), map.uvs().size());
        mStudio->shown.showDocument();
        expect(live, live | Content::Points | Content::Ghost);
        QVERIFY(map.ghostUvs().empty());
    }

    void givenSeamsAreDrawn()
    {
        Document &document = mStudio->document();
        mStudio->uv.frameAll();
        const auto drawn = [&](Canvas &canvas) {
            const QColor given = canvas.content().colors().sides[static_cast<int>(SideStyle::Given)];
            return test::countNear(canvas.picture(), given, 60);
        };
        SceneContent content(mStudio->context, false);
        content.refresh();
        QCOMPARE(drawn(mStudio->mesh) + drawn(mStudio->uv), 0);
        SolveSettings settings;
        settings.lambda = 0.5;
        pushCommand(std::make_unique<ChangeSettings>(document, settings));
        QCOMPARE(content.refresh(), 0);
        settings.seams = SeamMode::Keep;
        pushCommand(std::make_unique<ChangeSettings>(document, settings));
        QCOMPARE(content.refresh(), int(SceneContent::Sides));
        // What is drawn over the map changes no buffer, but the views have to draw it.
        QSignalSpy changed(&content, &SceneContent::changed);
        pushCommand(
            std::make_unique<SetIslandFlags>(document, SetIslandFlags::Edit::Group, std::vector<int>{0}));
        QCOMPARE(changed.count(), 1);
        document.undoStack().undo();
        // The border between the islands: once in the model, on both sides in the map.
        QVERIFY(drawn(mStudio->mesh) > 100 && drawn(mStudio->uv) > 100);
        document.undoStack().undo();
        QCOMPARE(content.refresh(), int(SceneContent::Sides));
        QCOMPARE(drawn(mStudio->mesh) + drawn(mStudio->uv), 0);
    }

    //! A view that looks at the UVs of a file, far away, shows the map of a job. One that sees it stays.
    void mapsFarFromTheViewAreFramed()
    {
        UvView &uv = mStudio->uv;
        const UvMatrix map = mStudio->document().uv();
        const auto setUvs = [&](const UvMatrix &uvs) {
            pushCommand(std::make_unique<SetUvs>(mStudio->document(), UvEdit::Move, uvs));
        };
        setUvs((map.array() + 5000).matrix());
        uv.frameAll();
        const Vec2 far = uv.mapCamera()->centre();
        QVERIFY((far - Vec2(5001, 5000)).norm() < 2); // without the tile, beside which it would be a speck
        QVERIFY(uv.mapCamera()->scale() > 50);
        setUvs(map);
        QCOMPARE(uv.mapCamera()->centre(), far);
        Q_EMIT mStudio->map.done(QString());
        QVERIFY(uv.mapCamera()->centre().norm() < 3);
        MapCamera camera = *uv.mapCamera();
        camera.zoom(3, QPointF(10, 10));
        uv.setCamera(camera);
        Q_EMIT mStudio->map.done(QString());
        QCOMPARE(uv.mapCamera()->scale(), camera.scale());
        QCOMPARE(uv.mapCamera()->centre(), camera.centre());
        // A job that made no map leaves the view where it is.
        camera.setCentre(Vec2(500, 500));
        uv.setCamera(camera);
        mStudio->map.rip({});
        QVERIFY(mStudio->map.jobs().isBusy());
        QTRY_VERIFY(!mStudio->map.jobs().isBusy());
        QCoreApplication::processEvents();
        QCOMPARE(uv.mapCamera()->centre(), camera.centre());
        // A live map is framed when it comes, not whenever it changes.
        camera.setCentre(Vec2(500, 500));
        uv.setCamera(camera);
        mStudio->shown.showMap(map);
        QVERIFY(uv.mapCamera()->centre().norm() < 3);
        uv.setCamera(camera);
        mStudio->shown.showMap(0.5 * map);
        QCOMPARE(uv.mapCamera()->centre(), camera.centre());
    }

    void legendsStayAboveWhatCoversAView()
    {
        ViewOptions options;
        options.coloring = Coloring::SignedStretch;
        mStudio->view.setOptions(options);
        for (Canvas *canvas : {static_cast<Canvas *>(&mStudio->mesh), static_cast<Canvas *>(&mStudio->uv)}) {
            constexpr int coverHeight = 60;
            QWidget cover(canvas);
            cover.setGeometry(0, canvas->height() - coverHeight, canvas->width(), coverHeight);
            const auto bottom = [&] {
                const QImage picture = canvas->picture();
                return picture.copy(picture.width() / 2, picture.height() - coverHeight, picture.width() / 2,
                                    coverHeight);
            };
            cover.hide();
            canvas->setCover(&cover);
            const QImage with = bottom();
            cover.show();
            QVERIFY(bottom() != with);
            options.coloring = Coloring::Plain;
            mStudio->view.setOptions(options);
            const QImage without = bottom();
            options.coloring = Coloring::SignedStretch;
            mStudio->view.setOptions(options);
            QCOMPARE(bottom(), without);
            canvas->setCover(nullptr);
        }
    }

    void picturesSurviveHostileDocuments()
    {
        // Degenerate, non-manifold, without UVs; and UVs beyond all bounds.
        const auto dirty = test::dirty();
        Document &document = mStudio->open(std::make_unique<Document>(test::sceneOf(dirty)));
        QVERIFY(!mStudio->mesh.picture().isNull());
        Scene scene = document.state().scene;
        scene.uvSets[0].uv = UvMatrix::Constant(dirty->cornerCount(), 2, 1e300);
        scene.uvSets[0].uv.row(0) << -1e300, 0.5;
        mStudio->open(std::make_unique<Document>(scene));
        for (int coloring = 0; coloring <= static_cast<int>(Coloring::PaintWeights); ++coloring) {
            ViewOptions options;
            options.coloring = static_cast<Coloring>(coloring);
            mStudio->view.setOptions(options);
            QVERIFY(!mStudio->uv.picture().isNull());
            Canvases::moveMouse(mStudio->uv, {100 + coloring, 100});
            Canvases::moveMouse(mStudio->mesh, {250, 250 + coloring});
        }
        mStudio->workspace.close();
        QVERIFY(!mStudio->uv.picture().isNull());
    }

private:
    std::unique_ptr<Canvases> mStudio;
};

QTEST_MAIN(TestDrawing)

} // namespace tst_drawing

#include "tst_drawing.moc"
