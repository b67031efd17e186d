// Shaping the map with the brushes, in both views.
#include "commands/editpins.h"
#include "commands/setislandflags.h"
#include "commands/setuvs.h"
#include "solver/metrics/uvmetrics.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "support/timers.h"
#include "views/tools/shapetool.h"

#include <QTest>

#include <cmath>

namespace tst_shapetool {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

namespace {

//! A grid over the unit square, of which the map is one island with a dent in the middle.
std::unique_ptr<Document> dentedDocument()
{
    Scene scene = test::sceneOf(test::grid(16));
    UvMatrix uv(scene.mesh->cornerCount(), 2);
    for (int c = 0; c < scene.mesh->cornerCount(); ++c) {
        const Vec2 place = scene.mesh->cornerPosition(c).head<2>();
        const double dent = 0.06 * std::exp(-30 * (place - Vec2(0.5, 0.5)).squaredNorm());
        uv.row(c) = (place + dent * Vec2(1, 0.5)).transpose();
    }
    scene.uvSets = {{u"UV"_s, uv}};
    return std::make_unique<Document>(std::move(scene));
}

} // namespace

class TestShapeTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mStudio = std::make_unique<Canvases>();
        mStudio->open(dentedDocument());
        mStudio->lookFromFront();
    }
    void cleanup() { mStudio.reset(); }

    //! A brush that is held still works on.
    void heldStillItWorksOn_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::newRow("pinch") << u"pinchBrush"_s;
        QTest::newRow("relax") << u"relaxBrush"_s;
    }
    void heldStillItWorksOn()
    {
        QFETCH(QString, tool);
        mStudio->tools.setTool(tool);
        const UvMatrix before = document().uv();
        const auto change = [&] { return (document().uv() - before).norm(); };
        Canvas &view = canvas(true);
        const QPoint place = at(view, 0.45, 0.5);
        Canvases::moveMouse(view, place);
        QTest::mousePress(&view, Qt::LeftButton, {}, place);
        QTRY_VERIFY(change() > 0);
        const double first = change();
        QTRY_VERIFY2(change() > 1.5 * first, qPrintable(u"%1, %2"_s.arg(first).arg(change())));
        QTest::mouseRelease(&view, Qt::LeftButton, {}, place);
        QCOMPARE(document().undoStack().count(), 1);
        const UvMatrix after = document().uv();
        QVERIFY(test::timersRest(*mStudio->tools.tool())); // nothing works on
        QVERIFY(document().uv() == after);
        document().undoStack().undo();
        QVERIFY(document().uv() == before);
    }

    void strokesAreOneEntry_data()
    {
        QTest::addColumn<bool>("inMap");
        QTest::addColumn<QString>("tool");
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::addColumn<QString>("label");
        for (const bool inMap : {false, true}) {
            const auto row = [&](const char *name, QString tool, Qt::KeyboardModifiers modifiers,
                                 QString label) {
                QTest::addRow("%s, %s", name, inMap ? "map" : "3D") << inMap << tool << modifiers << label;
            };
            row("relax", u"relaxBrush"_s, Qt::NoModifier, u"Relax with a brush"_s);
            row("pinch", u"pinchBrush"_s, Qt::NoModifier, u"Pinch"_s);
            row("apart", u"pinchBrush"_s, Qt::ControlModifier, u"Pinch"_s);
            row("grab", u"grabBrush"_s, Qt::NoModifier, u"Grab"_s);
            row("Shift relaxes", u"grabBrush"_s, Qt::ShiftModifier, u"Relax with a brush"_s);
        }
    }

    void strokesAreOneEntry()
    {
        QFETCH(bool, inMap);
        QFETCH(QString, tool);
        QFETCH(Qt::KeyboardModifiers, modifiers);
        QFETCH(QString, label);
        mStudio->tools.setTool(tool);
        const UvMatrix before = document().uv();
        Canvas &view = canvas(inMap);
        Canvases::drag(view, {at(view, 0.45, 0.5), at(view, 0.55, 0.52), at(view, 0.5, 0.45)}, modifiers);
        const UvMatrix after = document().uv();
        QVERIFY((after - before).cwiseAbs().maxCoeff() > 1e-4);
        QCOMPARE(document().undoStack().count(), 1);
        QCOMPARE(document().undoStack().undoText(), label);
        const metrics::UvMetrics figures = metrics::measureUv(document().mesh(), after);
        QCOMPARE(figures.flipped, 0);
        QCOMPARE(figures.overlapPairs, 0);
        QCOMPARE(figures.charts, 1); // nothing tears
        QCOMPARE(document().validate(), QString());
        document().undoStack().undo();
        QCOMPARE(document().uv(), before);
        document().undoStack().redo();
        QCOMPARE(document().uv(), after);
    }

    void relaxingLowersTheDistortion()
    {
        mStudio->tools.setTool(u"relaxBrush"_s);
        const auto distortion = [&] {
            return metrics::measureUv(document().mesh(), document().uv()).symDirichlet;
        };
        const double before = distortion();
        Canvas &view = mStudio->uv;
        makeLarger(8);
        for (int i = 0; i < 4; ++i)
            Canvases::drag(view,
                           {at(view, 0.3, 0.5), at(view, 0.7, 0.5), at(view, 0.5, 0.3), at(view, 0.5, 0.7)});
        QVERIFY2(distortion() - 4 < 0.25 * (before - 4), qPrintable(QString::number(distortion())));
        QCOMPARE(document().undoStack().count(), 4);
    }

    void theMapFollowsTheGrab()
    {
        mStudio->tools.setTool(u"grabBrush"_s);
        const int corner = cornerAt(0.5, 0.5);
        const Vec2 from = document().uv().row(corner);
        UvView &view = mStudio->uv;
        const QPoint start = view.camera().toScreen(from).toPoint();
        Canvases::drag(view, {start, start + QPoint(20, 10)});
        const Vec2 way = document().uv().row(corner).transpose() - from;
        QVERIFY(std::abs(way.x() * view.camera().scale() - 20) < 2);
        QVERIFY(std::abs(way.y() * view.camera().scale() + 10) < 2);
    }

    void whereTheMouseReturnsTheMapDoes()
    {
        mStudio->tools.setTool(u"grabBrush"_s);
        const DocumentState before = document().state();
        Canvas &view = mStudio->uv;
        const QPoint start = at(view, 0.4, 0.4);
        Canvases::drag(view, {start, start + QPoint(15, 10), start});
        QVERIFY(document().state() == before);
        QCOMPARE(document().undoStack().count(), 0);
    }

    void escapeLeavesNoTrace()
    {
        mStudio->tools.setTool(u"pinchBrush"_s);
        const DocumentState before = document().state();
        Canvas &view = mStudio->uv;
        QTest::mousePress(&view, Qt::LeftButton, {}, at(view, 0.4, 0.4));
        Canvases::moveMouse(view, at(view, 0.5, 0.45), Qt::LeftButton);
        QVERIFY(tool().isBusy() && !(document().state() == before));
        QTest::keyClick(&view, Qt::Key_Escape);
        QVERIFY(!tool().isBusy());
        Canvases::moveMouse(view, at(view, 0.3, 0.4), Qt::LeftButton);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, at(view, 0.3, 0.4));
        QVERIFY(document().state() == before);
        QVERIFY(!document().undoStack().canRedo());
    }

    void otherChangesOfTheMapEndTheStroke()
    {
        mStudio->tools.setTool(u"relaxBrush"_s);
        Canvas &view = mStudio->uv;
        QTest::mousePress(&view, Qt::LeftButton, {}, at(view, 0.5, 0.5));
        QVERIFY(tool().isBusy());
        UvMatrix moved = document().uv();
        moved.array() += 0.1;
        pushCommand(std::make_unique<SetUvs>(document(), UvEdit::Move, moved)); // as a job does
        QVERIFY(!tool().isBusy());
        Canvases::moveMouse(view, at(view, 0.6, 0.5), Qt::LeftButton);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, at(view, 0.6, 0.5));
        QCOMPARE(document().uv(), moved);
    }

    void locksAndPinsHold()
    {
        UvPin pin;
        pin.corner = cornerAt(0.5, 0.5);
        pin.position = document().uv().row(pin.corner);
        pushCommand(std::make_unique<EditPins>(document(), EditPins::Edit::Pin, std::vector<UvPin>{pin}));
        mStudio->tools.setTool(u"pinchBrush"_s);
        const UvMatrix before = document().uv();
        Canvas &view = mStudio->uv;
        Canvases::drag(view, {at(view, 0.4, 0.4), at(view, 0.45, 0.42)});
        QVERIFY(document().uv() != before);
        for (int corner : document().adjacency().vertexCorners(vertexAt(0.5, 0.5)))
            QCOMPARE(document().uv().row(corner), before.row(corner));
        document().undoStack().undo();
        pushCommand(
            std::make_unique<SetIslandFlags>(document(), SetIslandFlags::Edit::Lock, std::vector<int>{0}));
        const int entries = document().undoStack().count();
        const QString hint = tool().hint();
        Canvases::drag(view, {at(view, 0.4, 0.4), at(view, 0.45, 0.42)});
        QCOMPARE(document().uv(), before);
        QCOMPARE(document().undoStack().count(), entries);
        QVERIFY(tool().hint() != hint);
    }

    void aLiveSolveIsPausedFirst()
    {
        mStudio->tools.setTool(u"relaxBrush"_s);
        mStudio->solver.setMode(homotopy::SolveMode::Manual);
        mStudio->solver.run();
        QVERIFY(QTest::qWaitFor([&] { return mStudio->solver.status().iteration > 2; }, test::patience));
        Canvas &view = mStudio->mesh;
        const QPoint middle = at(view, 0.5, 0.5);
        QTest::mousePress(&view, Qt::LeftButton, {}, middle);
        QVERIFY(QTest::qWaitFor([&] { return !mStudio->solver.isRunning() && !mStudio->solver.isPausing(); },
                                test::patience));
        Canvases::moveMouse(view, middle + QPoint(20, 0), Qt::LeftButton);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + QPoint(20, 0));
        QVERIFY(!tool().isBusy());
        QCOMPARE(document().validate(), QString());
    }

    void theWheelChangesTheBrush()
    {
        mStudio->tools.setTool(u"grabBrush"_s);
        UvView &view = mStudio->uv;
        const Brush before = tool().brush();
        const double scale = view.camera().scale();
        makeLarger(1);
        Canvases::turnWheel(view, {250, 250}, -120, Qt::ControlModifier);
        Canvases::turnWheel(view, {250, 250}, 120, Qt::AltModifier);
        QVERIFY(tool().brush().radius > before.radius && tool().brush().strength < before.strength &&
                tool().brush().hardness > before.hardness);
        QCOMPARE(view.camera().scale(), scale);
    }

    void theBrushIsDrawn()
    {
        mStudio->tools.setTool(u"relaxBrush"_s);
        const QImage before = mStudio->uv.picture();
        Canvases::moveMouse(mStudio->uv, {250, 250});
        QVERIFY(mStudio->uv.picture() != before);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&mStudio->uv, &leave);
        QCOMPARE(mStudio->uv.picture(), before);
    }

    void oddModelsDoNoHarm()
    {
        for (const char *name : {"dirty", "cube"}) {
            mStudio->open(std::make_unique<Document>(test::sceneOf(test::meshNamed(QLatin1String(name)))));
            for (const QString &id : {u"relaxBrush"_s, u"pinchBrush"_s, u"grabBrush"_s}) {
                mStudio->tools.setTool(id);
                for (Canvas *view :
                     {static_cast<Canvas *>(&mStudio->mesh), static_cast<Canvas *>(&mStudio->uv)})
                    Canvases::drag(*view, {{5, 5}, {250, 250}, {495, 400}});
            }
            QCOMPARE(document().undoStack().count(), 0);
        }
        mStudio->workspace.close();
        Canvases::drag(mStudio->uv, {{5, 5}, {250, 250}});
    }

private:
    Document &document() { return mStudio->document(); }
    Canvas &canvas(bool inMap)
    {
        return inMap ? static_cast<Canvas &>(mStudio->uv) : static_cast<Canvas &>(mStudio->mesh);
    }
    const ShapeTool &tool() { return *qobject_cast<const ShapeTool *>(mStudio->tools.tool()); }
    void makeLarger(int notches)
    {
        for (int i = 0; i < notches; ++i)
            Canvases::turnWheel(mStudio->uv, {250, 250}, 120, Qt::ShiftModifier);
    }
    int vertexAt(double x, double y)
    {
        for (int v = 0; v < document().mesh().vertexCount(); ++v) {
            if (Vec3(document().mesh().positions.row(v)) == Vec3(x, y, 0))
                return v;
        }
        return -1;
    }
    int cornerAt(double x, double y) { return document().adjacency().vertexCorners(vertexAt(x, y)).front(); }
    //! Pixel of a place of the model, or of about the same place of the map.
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
};

QTEST_MAIN(TestShapeTool)

} // namespace tst_shapetool

#include "tst_shapetool.moc"
