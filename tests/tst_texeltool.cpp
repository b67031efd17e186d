// Painting the texel density with the brush, in both views, and its colours.
#include "commands/settexelweights.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "views/gl/colormap.h"
#include "views/tools/texeltool.h"

#include <QTest>

#include <cmath>

namespace tst_texeltool {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

class TestTexelTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mStudio = std::make_unique<Canvases>();
        openGrid(0);
    }
    void cleanup() { mStudio.reset(); }

    void strokesAreOneEntry_data()
    {
        QTest::addColumn<bool>("inMap");
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::addColumn<bool>("denser");
        for (const bool inMap : {false, true}) {
            const char *view = inMap ? "map" : "3D";
            QTest::addRow("denser, %s", view) << inMap << Qt::KeyboardModifiers(Qt::NoModifier) << true;
            QTest::addRow("Ctrl inverts, %s", view)
                << inMap << Qt::KeyboardModifiers(Qt::ControlModifier) << false;
        }
    }

    void strokesAreOneEntry()
    {
        QFETCH(bool, inMap);
        QFETCH(Qt::KeyboardModifiers, modifiers);
        QFETCH(bool, denser);
        Canvas &view = canvas(inMap);
        stroke(view, modifiers);
        const std::vector<double> painted = document().texelWeights();
        const double middle = painted[faceAt(2, 6)];
        QVERIFY2(denser ? middle > 1.3 && middle <= 2 : middle < 0.8 && middle >= 0.5,
                 qPrintable(QString::number(middle)));
        QCOMPARE(painted[faceAt(7, 0)], 1.0); // far away
        for (const double weight : painted)
            QVERIFY(denser ? weight >= 1 && weight <= 2 : weight <= 1 && weight >= 0.5);
        QCOMPARE(document().undoStack().count(), 1);
        document().undoStack().undo();
        QVERIFY(document().state().texelWeights.empty());
        document().undoStack().redo();
        QCOMPARE(document().texelWeights(), painted);
        QCOMPARE(document().validate(), QString());
    }

    void shiftErases()
    {
        setOption(2, 100); // strength
        setOption(3, 100); // hardness: no soft rim
        stroke(mStudio->mesh);
        QCOMPARE(document().texelWeights()[faceAt(2, 6)], 2.0);
        stroke(mStudio->mesh, Qt::ShiftModifier);
        QCOMPARE(document().texelWeights()[faceAt(2, 6)], 1.0);
        QVERIFY(document().state().texelWeights.empty());
        QCOMPARE(document().undoStack().count(), 2);
    }

    void strokesDoNotAddUpWithinThemselves()
    {
        Canvas &view = mStudio->mesh;
        const QPoint a = at(view, 0.2, 0.8), b = at(view, 0.7, 0.8);
        Canvases::drag(view, {a, b});
        const std::vector<double> once = document().texelWeights();
        document().undoStack().undo();
        Canvases::drag(view, {a, b, a, b});
        QCOMPARE(document().texelWeights(), once);
        for (int i = 0; i < 8; ++i)
            Canvases::drag(view, {a, b});
        QVERIFY(document().texelWeights()[faceAt(3, 6)] > 1.95);
        QVERIFY(document().texelWeights()[faceAt(3, 6)] <= 2);
    }

    void escapeAndUndoInTheMiddle()
    {
        Canvas &view = mStudio->mesh;
        pushCommand(SetTexelWeights::uniform(document(), IndexRanges::all(3), 3));
        const DocumentState before = document().state();
        const QPoint a = at(view, 0.2, 0.8), b = at(view, 0.7, 0.8);
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, a);
        QTest::mouseMove(&view, b);
        QVERIFY(mStudio->tools.tool()->isBusy());
        QVERIFY(!(document().state() == before));
        QTest::keyClick(&view, Qt::Key_Escape);
        QVERIFY(!mStudio->tools.tool()->isBusy());
        QVERIFY(document().state() == before);
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, b);
        QCOMPARE(document().undoStack().count(), 1);
        // Another tool in the middle of a stroke ends it in the same way.
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, a);
        mStudio->tools.setTool(u"select"_s);
        QVERIFY(document().state() == before);
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, a);
    }

    void symmetryPaintsBothSides_data()
    {
        QTest::addColumn<bool>("inMap");
        QTest::newRow("3D") << false;
        QTest::newRow("map") << true;
    }

    void symmetryPaintsBothSides()
    {
        QFETCH(bool, inMap);
        openGrid(-0.5);
        Canvas &view = canvas(inMap);
        QTest::keyClick(&view, Qt::Key_X);
        QVERIFY(tool().isSymmetric());
        Canvases::drag(view, {at(view, -0.4, 0.6), at(view, -0.25, 0.3)});
        const std::vector<double> painted = document().texelWeights();
        QVERIFY(painted[faceAt(1, 3)] > 1);
        for (int x = 0; x < 8; ++x) {
            for (int y = 0; y < 8; ++y)
                QCOMPARE(painted[faceAt(x, y)], painted[faceAt(7 - x, y)]);
        }
        QCOMPARE(document().undoStack().count(), 1);
        document().undoStack().undo();
        QTest::keyClick(&view, Qt::Key_X);
        Canvases::drag(view, {at(view, -0.4, 0.6), at(view, -0.25, 0.3)});
        QCOMPARE(document().texelWeights()[faceAt(6, 3)], 1.0);
    }

    void optionsAndWheel()
    {
        setOption(0, 400);
        QCOMPARE(tool().weight(), 4.0);
        setOption(0, 12);
        QCOMPARE(tool().weight(), 0.125);
        setOption(1, 60);
        QCOMPARE(tool().brush().radius, 60.0);
        QVERIFY(tool().hint().contains(u"0.125"_s));
    }

    void theFacesShowTheWeights()
    {
        QCOMPARE(mStudio->view.options().coloring, Coloring::TexelWeights);
        setOption(2, 100);
        stroke(mStudio->mesh);
        SceneContent &content = const_cast<SceneContent &>(mStudio->mesh.content());
        content.refresh();
        const FaceTexel hit = content.faces()[document().mesh().faceTriangle[faceAt(2, 6)]];
        const QRgb expected = texelWeightColor(2);
        QCOMPARE(int(hit.red), qRed(expected));
        QCOMPARE(int(hit.blue), qBlue(expected));
        mStudio->tools.setTool(u"select"_s);
        QCOMPARE(mStudio->view.options().coloring, Coloring::Plain);
    }

    void densityHasBandsAroundThePaintedTarget()
    {
        // The map has one density; the painted faces are to have twice as much.
        ViewOptions options = mStudio->view.options();
        options.coloring = Coloring::Density;
        options.densityTarget = document().packingSettings().textureSize;
        options.densityTolerance = 0.1;
        mStudio->view.setOptions(options);
        pushCommand(SetTexelWeights::uniform(document(), IndexRanges::all(8), 2));
        SceneContent &content = const_cast<SceneContent &>(mStudio->mesh.content());
        content.refresh();
        const auto colorOf = [&](int face) {
            const FaceTexel texel = content.faces()[document().mesh().faceTriangle[face]];
            return qRgb(texel.red, texel.green, texel.blue);
        };
        const auto expected = [](double ratio) {
            return heatColor(HeatMap::Density, false, bandedDensity(ratio, 0.1)) | 0xff000000;
        };
        QCOMPARE(colorOf(20), expected(1));
        QCOMPARE(colorOf(0), expected(0.5));
        QVERIFY(expected(1) != expected(0.5) && expected(1) != expected(2) && expected(2) != expected(0.5));
        QCOMPARE(bandedDensity(1.09, 0.1), 0.0);
        QCOMPARE(bandedDensity(0.91, 0.1), 0.0);
    }

    void noModelAndStrangeOnes()
    {
        mStudio->workspace.close();
        Canvases::drag(mStudio->mesh, {{5, 5}, {250, 250}});
        mStudio->open(std::make_unique<Document>(test::sceneOf(test::dirty())));
        Canvases::drag(mStudio->mesh, {{5, 5}, {495, 495}, {5, 495}, {495, 5}});
        QCOMPARE(document().validate(), QString());
    }

private:
    Document &document() { return mStudio->document(); }
    Canvas &canvas(bool inMap)
    {
        return inMap ? static_cast<Canvas &>(mStudio->uv) : static_cast<Canvas &>(mStudio->mesh);
    }
    //! Opens a grid from x = left on, whose map is as it lies there.
    void openGrid(double left)
    {
        mLeft = left;
        MeshData moved = *test::grid(8);
        moved.positions.col(0).array() += left;
        Scene scene = test::sceneOf(
            MeshData::build(moved.positions, moved.faceStart, moved.cornerVertex, moved.faceObject));
        UvMatrix uv(scene.mesh->cornerCount(), 2);
        for (int c = 0; c < scene.mesh->cornerCount(); ++c)
            uv.row(c) = scene.mesh->cornerPosition(c).head<2>();
        scene.uvSets = {{u"UV"_s, uv}};
        mStudio->open(std::make_unique<Document>(std::move(scene)));
        mStudio->lookFromFront();
        mStudio->tools.setTool(u"texelWeight"_s);
    }
    const TexelTool &tool() { return *qobject_cast<const TexelTool *>(mStudio->tools.tool()); }
    void setOption(std::size_t index, double value) { mStudio->tools.tool()->options()[index].set(value); }
    void stroke(Canvas &view, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        Canvases::drag(view, {at(view, 0.1, 0.8), at(view, 0.4, 0.8), at(view, 0.4, 0.6)}, modifiers);
    }
    //! The face in a column and a row of the grid, from the lower left.
    std::size_t faceAt(int column, int row)
    {
        const MeshData &mesh = document().mesh();
        const Vec3 wanted(mLeft + (column + 0.5) / 8, (row + 0.5) / 8, 0);
        for (int face = 0; face < mesh.faceCount(); ++face) {
            Vec3 middle = Vec3::Zero();
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                middle += mesh.cornerPosition(c) / 4;
            if ((middle - wanted).norm() < 1e-9)
                return static_cast<std::size_t>(face);
        }
        return 0;
    }
    //! Pixel of a place of the model.
    QPoint at(const Canvas &view, double x, double y)
    {
        if (view.kind() == Canvas::Kind::Map)
            return mStudio->uv.camera().toScreen(Vec2(x, y)).toPoint();
        const auto seen = OrbitProjector(mStudio->mesh.camera());
        ScreenPoint point;
        seen.project(mStudio->mesh.content().frame().toFrame(Vec3(x, y, 0)), point);
        return {qRound(point.x), qRound(point.y)};
    }

    std::unique_ptr<Canvases> mStudio;
    double mLeft = 0;
};

QTEST_MAIN(TestTexelTool)

} // namespace tst_texeltool

#include "tst_texeltool.moc"
