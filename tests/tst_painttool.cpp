// Painting seam weights with the brush, in both views.
#include "commands/settexelweights.h"
#include "commands/setuvs.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "views/tools/painttool.h"

#include <QTest>

namespace tst_painttool {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

class TestPaintTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mStudio = std::make_unique<Canvases>();
        // Symmetric about x = 0, in one island.
        MeshData moved = *test::grid(8);
        moved.positions.col(0).array() -= 0.5;
        Scene scene = test::sceneOf(
            MeshData::build(moved.positions, moved.faceStart, moved.cornerVertex, moved.faceObject));
        UvMatrix uv(scene.mesh->cornerCount(), 2);
        for (int c = 0; c < scene.mesh->cornerCount(); ++c)
            uv.row(c) = scene.mesh->cornerPosition(c).head<2>() + Vec2(0.5, 0);
        scene.uvSets = {{u"UV"_s, uv}};
        mStudio->open(std::make_unique<Document>(std::move(scene)));
        mStudio->lookFromFront();
        mStudio->tools.setTool(u"paint"_s);
    }
    void cleanup() { mStudio.reset(); }

    //! The paint of another tool, as a session has it, gives way while this tool is active.
    void otherPaintGivesWay()
    {
        const auto show = [this](Coloring coloring) {
            ViewOptions options = mStudio->view.options();
            options.coloring = coloring;
            mStudio->view.setOptions(options);
        };
        const auto shown = [this] { return mStudio->view.options().coloring; };
        mStudio->tools.setTool(u"select"_s);
        for (const Coloring before : {Coloring::Plain, Coloring::TexelWeights}) {
            show(before);
            mStudio->tools.setTool(u"paint"_s);
            QCOMPARE(shown(), Coloring::PaintWeights);
            mStudio->tools.setTool(u"select"_s);
            QCOMPARE(shown(), before);
        }
        show(Coloring::Density); // chosen by the user
        mStudio->tools.setTool(u"paint"_s);
        QCOMPARE(shown(), Coloring::Density);
        mStudio->tools.setTool(u"texelWeight"_s);
        QCOMPARE(shown(), Coloring::Density);
    }

    //! A selection leaves the difference between painted and other faces.
    void selectionLeavesPaint()
    {
        std::vector<double> weights;
        IndexRanges half;
        const MeshData &mesh = document().mesh();
        for (int face = 0; face < mesh.faceCount(); ++face) {
            if (mesh.cornerPosition(mesh.faceStart[face]).x() < -0.01) {
                half.append(face);
                weights.push_back(4);
            }
        }
        pushCommand(std::make_unique<SetTexelWeights>(document(), half, weights));
        ViewOptions options = mStudio->view.options();
        options.coloring = Coloring::TexelWeights;
        options.wireframe = false;
        mStudio->view.setOptions(options);
        const auto difference = [this] {
            const QImage picture = mStudio->mesh.grabFramebuffer();
            const double ratio = mStudio->mesh.devicePixelRatioF();
            const auto color = [&](double x) {
                return picture.pixelColor((QPointF(at(mStudio->mesh, x, 0.55)) * ratio).toPoint());
            };
            const QColor left = color(-0.28), right = color(0.22);
            return std::abs(left.red() - right.red()) + std::abs(left.green() - right.green()) +
                   std::abs(left.blue() - right.blue());
        };
        const int before = difference();
        QVERIFY2(before > 60, qPrintable(QString::number(before)));
        Selection all;
        all.mode = SelectionMode::Faces;
        for (int face = 0; face < mesh.faceCount(); ++face)
            all.faces << face;
        document().setSelection(all);
        const int selected = difference();
        QVERIFY2(selected > 0.6 * before, qPrintable(u"%1 of %2"_s.arg(selected).arg(before)));
    }

    void strokesAreOneEntry_data()
    {
        QTest::addColumn<bool>("inMap");
        QTest::addColumn<int>("key");
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::addColumn<bool>("keeps");
        for (const bool inMap : {false, true}) {
            const char *view = inMap ? "map" : "3D";
            const auto row = [&](const char *name, int key, Qt::KeyboardModifiers modifiers, bool keeps) {
                QTest::addRow("%s, %s", name, view) << inMap << key << modifiers << keeps;
            };
            row("keep together", Qt::Key_1, Qt::NoModifier, true);
            row("attract cuts", Qt::Key_2, Qt::NoModifier, false);
            row("Ctrl inverts", Qt::Key_1, Qt::ControlModifier, false);
            row("Ctrl inverts back", Qt::Key_2, Qt::ControlModifier, true);
        }
    }

    void strokesAreOneEntry()
    {
        QFETCH(bool, inMap);
        QFETCH(int, key);
        QFETCH(Qt::KeyboardModifiers, modifiers);
        QFETCH(bool, keeps);
        Canvas &view = canvas(inMap);
        QTest::keyClick(&view, static_cast<Qt::Key>(key));
        Canvases::drag(view, {at(view, -0.4, 0.6), at(view, -0.1, 0.6), at(view, -0.1, 0.3)}, modifiers);
        const Seams painted = document().seams();
        const int hit = across(0, 5), far = across(6, 1);
        const double weight = painted.weights[2 * hit];
        QVERIFY2(keeps ? weight > 2 : weight < 0.7, qPrintable(QString::number(weight)));
        QCOMPARE(painted.weights[2 * far], unpaintedWeight);
        for (int e = 0; e < static_cast<int>(document().mesh().edgePairs.size()); ++e) {
            QCOMPARE(painted.weights[2 * e], painted.weights[2 * e + 1]);
            QVERIFY(!document().mesh().edgePairs[e].diagonal || painted.weights[2 * e] == unpaintedWeight);
            QVERIFY(keeps ? painted.weights[2 * e] >= 1 : painted.weights[2 * e] <= 1);
        }
        QCOMPARE(document().undoStack().count(), 1);
        document().undoStack().undo();
        QCOMPARE(document().seams(), Seams::allFree(document().mesh()));
        document().undoStack().redo();
        QCOMPARE(document().seams(), painted);
        QCOMPARE(document().validate(), QString());
    }

    void strokesDoNotAddUpWithinThemselves()
    {
        Canvas &view = mStudio->mesh;
        const QPoint a = at(view, -0.3, 0.5), b = at(view, 0.2, 0.5);
        Canvases::drag(view, {a, b});
        const Seams once = document().seams();
        document().undoStack().undo();
        Canvases::drag(view, {a, b, a, b});
        QCOMPARE(document().seams(), once);
        // Another stroke goes on towards the full weight, and never beyond.
        double before = once.weights[2 * across(2, 4)];
        for (int stroke = 0; stroke < 6; ++stroke) {
            Canvases::drag(view, {a, b});
            const double now = document().seams().weights[2 * across(2, 4)];
            QVERIFY(now >= before && now <= 100);
            before = now;
        }
        QVERIFY(before > 90);
    }

    void noGapOfTheMapIsCrossed()
    {
        // The right half of the map lies a little apart.
        const MeshData &mesh = document().mesh();
        UvMatrix uv = document().uv();
        for (int c = 0; c < mesh.cornerCount(); ++c) {
            const int face = document().adjacency().faceOfCorner(c);
            double middle = 0;
            for (int k = mesh.faceStart[face]; k < mesh.faceStart[face + 1]; ++k)
                middle += mesh.cornerPosition(k).x() / (mesh.faceStart[face + 1] - mesh.faceStart[face]);
            if (middle > 0)
                uv(c, 0) += 0.02;
        }
        pushCommand(std::make_unique<SetUvs>(document(), UvEdit::Move, uv));
        Canvas &view = mStudio->uv;
        for (int i = 0; i < 4; ++i)
            Canvases::turnWheel(view, {100, 100}, 2 * 120, Qt::ShiftModifier);
        const QPoint place = at(view, -0.1, 0.5);
        Canvases::drag(view, {place, place - QPoint(3, 0)});
        QVERIFY(document().seams().weights[2 * across(3, 4)] > 1); // ends at the gap
        QCOMPARE(document().seams().weights[2 * across(4, 4)], 1.0);
        // The model has no gap.
        document().undoStack().undo();
        const QPoint there = at(mStudio->mesh, -0.1, 0.5);
        Canvases::drag(mStudio->mesh, {there, there - QPoint(3, 0)});
        QVERIFY(document().seams().weights[2 * across(4, 4)] > 1);
    }

    void erasingBringsBackUnpainted()
    {
        Canvas &view = mStudio->uv;
        for (int i = 0; i < 4; ++i)
            Canvases::turnWheel(view, {100, 100}, 2 * 120, Qt::ControlModifier);
        for (int i = 0; i < 20; ++i)
            Canvases::turnWheel(view, {100, 100}, 120, Qt::AltModifier);
        QCOMPARE(tool().brush().strength, 1.0);
        QCOMPARE(tool().brush().hardness, 1.0);
        const QList<QPoint> way{at(view, -0.3, 0.5), at(view, 0.2, 0.5)};
        Canvases::drag(view, way);
        QCOMPARE(document().seams().weights[2 * across(2, 4)], 100.0);
        Canvases::drag(view, way, Qt::ShiftModifier);
        QCOMPARE(document().seams(), Seams::allFree(document().mesh()));
        document().undoStack().undo();
        QTest::keyClick(&view, Qt::Key_3);
        QCOMPARE(tool().paint(), Paint::Erase);
        Canvases::drag(view, way);
        QCOMPARE(document().seams(), Seams::allFree(document().mesh()));
        QCOMPARE(document().undoStack().count(), 2);
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
        Canvas &view = canvas(inMap);
        QTest::keyClick(&view, Qt::Key_X);
        QVERIFY(tool().isSymmetric());
        Canvases::drag(view, {at(view, -0.4, 0.6), at(view, -0.25, 0.3)});
        const auto &weights = document().seams().weights;
        QVERIFY(weights[2 * across(1, 4)] > 1);
        for (int x = 0; x < 8; ++x) {
            for (int y = 1; y < 8; ++y)
                QCOMPARE(weights[2 * across(x, y)], weights[2 * across(7 - x, y)]);
        }
        QCOMPARE(document().undoStack().count(), 1);
        document().undoStack().undo();
        QTest::keyClick(&view, Qt::Key_X);
        Canvases::drag(view, {at(view, -0.4, 0.6), at(view, -0.25, 0.3)});
        QCOMPARE(document().seams().weights[2 * across(6, 4)], unpaintedWeight);
    }

    void escapeLeavesNoTrace()
    {
        const DocumentState before = document().state();
        Canvas &view = mStudio->mesh;
        QTest::mousePress(&view, Qt::LeftButton, {}, at(view, -0.3, 0.5));
        Canvases::moveMouse(view, at(view, 0.2, 0.5), Qt::LeftButton);
        QVERIFY(tool().isBusy() && !(document().state() == before));
        QTest::keyClick(&view, Qt::Key_Escape);
        QVERIFY(!tool().isBusy());
        Canvases::moveMouse(view, at(view, 0.3, 0.2), Qt::LeftButton);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, at(view, 0.3, 0.2));
        QVERIFY(document().state() == before);
        QCOMPARE(document().undoStack().count(), 0);
        QVERIFY(!document().undoStack().canRedo());
    }

    void wheelChangesTheBrushAndNotTheCamera()
    {
        UvView &view = mStudio->uv;
        const double scale = view.camera().scale(), radius = tool().brush().radius;
        Canvases::turnWheel(view, {250, 250}, 120, Qt::ShiftModifier);
        QVERIFY(tool().brush().radius > radius);
        for (int i = 0; i < 100; ++i)
            Canvases::turnWheel(view, {250, 250}, 120, Qt::ShiftModifier);
        QCOMPARE(tool().brush().radius, Brush::maxRadius);
        for (int i = 0; i < 100; ++i)
            Canvases::turnWheel(view, {250, 250}, -120, Qt::ShiftModifier);
        QCOMPARE(tool().brush().radius, Brush::minRadius);
        for (int i = 0; i < 30; ++i)
            Canvases::turnWheel(view, {250, 250}, -120, Qt::ControlModifier);
        QCOMPARE(tool().brush().strength, 0.05);
        QCOMPARE(view.camera().scale(), scale);
        Canvases::turnWheel(view, {250, 250}, 120, Qt::NoModifier);
        QVERIFY(view.camera().scale() > scale);
    }

    void theBackIsNotPainted()
    {
        mStudio->open(std::make_unique<Document>(test::sceneOf(test::sphere(12, 16))));
        mStudio->lookFromFront();
        for (int i = 0; i < 20; ++i)
            Canvases::turnWheel(mStudio->mesh, {250, 250}, 120, Qt::ShiftModifier);
        const QPoint middle(250, 250);
        QVERIFY(mStudio->mesh.pick(middle).triangle >= 0);
        QTest::mouseClick(&mStudio->mesh, Qt::LeftButton, {}, middle);
        const MeshData &mesh = document().mesh();
        int painted = 0;
        for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
            if (document().seams().weights[2 * e] == unpaintedWeight)
                continue;
            ++painted;
            // The camera looks along -z; sides on the silhouette belong to a face on either side of it.
            const auto z = [&](int end) {
                return mesh.cornerPosition(mesh.cornerOfSoup(mesh.edgePairs[e].corner[end][0])).z();
            };
            QVERIFY(std::max(z(0), z(1)) > -0.3);
        }
        QVERIFY(painted > 50);
    }

    void theColouringComesAndGoes()
    {
        QCOMPARE(mStudio->view.options().coloring, Coloring::PaintWeights);
        mStudio->tools.setTool(u"select"_s);
        QCOMPARE(mStudio->view.options().coloring, Coloring::Plain);
        ViewOptions options = mStudio->view.options();
        options.coloring = Coloring::SignedStretch;
        mStudio->view.setOptions(options);
        mStudio->tools.setTool(u"paint"_s);
        QCOMPARE(mStudio->view.options().coloring, Coloring::SignedStretch);
        mStudio->tools.setTool(u"select"_s);
        QCOMPARE(mStudio->view.options().coloring, Coloring::SignedStretch);
    }

    void theBrushIsDrawn()
    {
        const QImage before = mStudio->uv.picture();
        Canvases::moveMouse(mStudio->uv, {250, 250});
        const QImage with = mStudio->uv.picture();
        const int radius = qRound(tool().brush().radius);
        const QColor rim = with.pixelColor(250 + radius, 250), under = before.pixelColor(250 + radius, 250);
        QVERIFY(rim.red() < under.red() - 30);
        QVERIFY(rim.green() > rim.red() + 30); // as joined edges
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&mStudio->uv, &leave);
        QCOMPARE(mStudio->uv.picture(), before);
    }

    void paintingBesideTheModelDoesNothing()
    {
        Canvases::drag(mStudio->mesh, {{5, 5}, {30, 5}});
        QCOMPARE(document().undoStack().count(), 0);
        mStudio->workspace.close();
        Canvases::drag(mStudio->mesh, {{5, 5}, {250, 250}});
        mStudio->open(std::make_unique<Document>(test::sceneOf(test::dirty())));
        QTest::keyClick(&mStudio->mesh, Qt::Key_X);
        Canvases::drag(mStudio->mesh, {{5, 5}, {495, 495}, {5, 495}, {495, 5}});
        QCOMPARE(document().validate(), QString());
    }

private:
    Document &document() { return mStudio->document(); }
    Canvas &canvas(bool inMap)
    {
        return inMap ? static_cast<Canvas &>(mStudio->uv) : static_cast<Canvas &>(mStudio->mesh);
    }
    const PaintTool &tool() { return *qobject_cast<const PaintTool *>(mStudio->tools.tool()); }
    //! The edge that goes right from a vertex of the grid.
    int across(int x, int y)
    {
        return mStudio->edgeBetween(Vec3(x / 8.0 - 0.5, y / 8.0, 0), Vec3((x + 1) / 8.0 - 0.5, y / 8.0, 0));
    }
    //! Pixel of a place of the model.
    QPoint at(const Canvas &view, double x, double y)
    {
        if (view.kind() == Canvas::Kind::Map)
            return mStudio->uv.camera().toScreen(Vec2(x + 0.5, y)).toPoint();
        const auto seen = OrbitProjector(mStudio->mesh.camera());
        ScreenPoint point;
        seen.project(mStudio->mesh.content().frame().toFrame(Vec3(x, y, 0)), point);
        return {qRound(point.x), qRound(point.y)};
    }

    std::unique_ptr<Canvases> mStudio;
};

QTEST_MAIN(TestPaintTool)

} // namespace tst_painttool

#include "tst_painttool.moc"
