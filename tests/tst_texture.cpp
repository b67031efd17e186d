// Texture, rotation and kept orientations in the real window: by fields, keys and menus, with undo, while a
// live solve runs and through files.
#include "commands/changesettings.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "model/plain/uvlayout.h"
#include "support/cliruns.h"
#include "support/studiosession.h"
#include "views/canvas/uvview.h"
#include "views/panels/packpanel.h"
#include "views/shell/contextmenu.h"

#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>

namespace tst_texture {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::StudioSession;

namespace {

void type(QWidget *field, const QString &text)
{
    field->setFocus();
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
    QCoreApplication::processEvents();
}

//! The studio on a model with a map of several islands.
struct TextureWindow : StudioSession
{
    TextureWindow()
    {
        window.resize(1280, 800);
        context.actions.action("file.sample.machine")->trigger();
        [[maybe_unused]] const bool open = jobsRest();
        context.map.unwrap(unwrap::UnwrapQuality::Draft);
        [[maybe_unused]] const bool made = jobsRest();
        raise("packing");
    }
    void raise(const char *panel)
    {
        auto *dock = window.findChild<QDockWidget *>(QLatin1String(panel));
        dock->show();
        dock->raise();
        QCoreApplication::processEvents();
    }
    QLineEdit *field(const char *name)
    {
        auto *box = window.findChild<QComboBox *>(QLatin1String(name));
        return box ? box->lineEdit() : nullptr;
    }
    void setTexture(const QString &width, const QString &height)
    {
        type(field("textureSize"), width);
        type(field("textureHeight"), height);
    }
    const PackingSettings &packing() { return document()->packingSettings(); }
    void pack()
    {
        context.map.pack(PackScope::All);
        QVERIFY(jobsRest());
    }
    Eigen::AlignedBox2d box() { return layoutBox(document()->uv()); }
};

} // namespace

class TestTexture : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSidesOfTheTexture()
    {
        TextureWindow studio;
        UndoStack &stack = studio.document()->undoStack();
        const int before = stack.count();
        const UvMatrix uv = studio.document()->uv();
        type(studio.field("textureSize"), u"1024"_s); // a square one stays square
        QCOMPARE(studio.packing().height(), 1024);
        QCOMPARE(studio.field("textureHeight")->text(), u"1024"_s);
        type(studio.field("textureHeight"), u"512"_s);
        QCOMPARE(studio.packing().tileHeight(), 0.5);
        QCOMPARE(stack.count(), before + 2);
        QVERIFY(studio.document()->uv() == uv); // shapes on the texture stay
        QVERIFY(studio.box().max().y() > 0.5);
        studio.pack();
        QVERIFY(Eigen::AlignedBox2d(Vec2(0, 0), Vec2(1, 0.5)).contains(studio.box()));
        QVERIFY(studio.measured());
        const metrics::UvMetrics &figures = studio.context.map.figures()->metrics;
        QVERIFY(figures.inUnitSquare && figures.minGutterTexels >= 8 && figures.borderGutterTexels >= 4);
        QVERIFY(figures.packingUnit > 0.3);
        stack.undo();
        stack.undo();
        QTRY_COMPARE(studio.field("textureHeight")->text(), u"1024"_s);
        stack.undo();
        QCOMPARE(studio.packing(), PackingSettings());
        QVERIFY(studio.document()->uv() == uv);
        type(studio.field("textureHeight"), u"0"_s);
        QCOMPARE(studio.packing(), PackingSettings());
    }

    void aMarginThatIsTooWideShrinksWithTheTexture()
    {
        TextureWindow studio;
        PackingSettings wide = studio.packing();
        wide.margin = 600;
        wide.border = 700;
        pushCommand(std::make_unique<ChangeSettings>(*studio.document(), wide));
        type(studio.field("textureHeight"), u"256"_s);
        QCOMPARE(studio.packing().height(), 256);
        QCOMPARE(studio.packing().margin, 256.0);
        QVERIFY(studio.packing().border < 128);
        QVERIFY(studio.document()->validate().isEmpty());
    }

    void numbersOfTheLayoutPanelAreThoseOfTheFile()
    {
        TextureWindow studio;
        studio.setTexture(u"2048"_s, u"1024"_s);
        studio.pack();
        studio.raise("layout");
        studio.press(Qt::Key_4);
        studio.action("select.all")->trigger();
        auto *const height = studio.window.findChild<QDoubleSpinBox *>(u"height"_s);
        QVERIFY(height);
        QTRY_VERIFY(std::abs(height->value() - 2048 * studio.box().sizes().y()) < 0.01); // texels
        auto *const unit = studio.window.findChild<QComboBox *>(u"unit"_s);
        QVERIFY(unit);
        unit->setFocus();
        QTest::keyClick(unit, Qt::Key_Home);
        QCOMPARE(unit->currentText(), u"UV units"_s);
        QTRY_VERIFY(std::abs(height->value() - 2 * studio.box().sizes().y()) < 1e-4);
        const QString path = studio.folder.filePath(u"out.obj"_s);
        studio.context.files.exportMesh(path);
        QVERIFY(studio.jobsRest());
        const Eigen::AlignedBox2d inFile = layoutBox(readMesh(path).value().uvSets.front().uv);
        QVERIFY(std::abs(inFile.sizes().y() - 2 * studio.box().sizes().y()) < 1e-12);
        QVERIFY(Eigen::AlignedBox2d(Vec2(0, 0), Vec2(1, 1)).contains(inFile));
    }

    void aMapForThisTextureIsSqueezed()
    {
        TextureWindow studio;
        const QString path = studio.folder.filePath(u"in.obj"_s), out = studio.folder.filePath(u"out.obj"_s);
        studio.context.files.exportMesh(path);
        QVERIFY(studio.jobsRest());
        studio.context.files.open(path);
        QVERIFY(studio.jobsRest());
        studio.setTexture(u"2048"_s, u"1536"_s);
        studio.action("select.all")->trigger();
        studio.action("uv.toTexture")->trigger();
        QVERIFY(studio.box().max().y() <= 0.75);
        studio.context.files.exportMesh(out);
        QVERIFY(studio.jobsRest());
        QVERIFY(test::readBytes(path) == test::readBytes(out));
    }

    void islandsSnapAndFitIntoTheTile()
    {
        TextureWindow studio;
        studio.setTexture(u"2048"_s, u"512"_s);
        studio.press(Qt::Key_4);
        studio.action("select.all")->trigger();
        studio.action("uv.fitTile")->trigger();
        const Vec2 size = studio.box().sizes();
        QVERIFY(std::abs(size.y() - (0.25 - 8.0 / 2048)) < 1e-12 ||
                std::abs(size.x() - (1 - 8.0 / 2048)) < 1e-12);
        const double row = std::floor(studio.box().center().y() / 0.25);
        QVERIFY(studio.box().min().y() >= 0.25 * row && studio.box().max().y() <= 0.25 * (row + 1));
    }

    void keptOrientations()
    {
        TextureWindow studio;
        const auto flags = [&](int island) {
            return studio.document()->marks().flagsOf(studio.document()->islands().faces(island));
        };
        Selection one;
        one.mode = SelectionMode::Islands;
        const std::vector<int> own = studio.document()->islands().faces(0);
        one.faces = QList<int>(own.begin(), own.end());
        studio.document()->setSelection(one);
        QMenu menu;
        QCoreApplication::processEvents();
        fillContextMenu(menu, studio.context);
        const auto submenus = menu.findChildren<QMenu *>();
        QVERIFY(std::any_of(submenus.begin(), submenus.end(), [&](const QMenu *submenu) {
            return submenu->actions().contains(studio.action("uv.keepOrientation"));
        }));
        studio.action("uv.keepOrientation")->trigger();
        QCOMPARE(flags(0).upright, 1);
        QCOMPARE(flags(1).upright, 0);
        const MeshData &mesh = studio.document()->mesh();
        const auto side = [&] { // one side of the first face
            const UvMatrix &uv = studio.document()->uv();
            const int c = mesh.faceStart[own.front()];
            return Vec2((uv.row(c + 1) - uv.row(c)).transpose().normalized());
        };
        const Vec2 before = side();
        studio.pack();
        QVERIFY((side() - before).norm() < 1e-9);
        studio.context.map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(studio.jobsRest());
        QVERIFY(side().dot(before) > 0.9);
        // Through a session, and freed again.
        PackingSettings packing = studio.packing();
        packing.setTexture(2048, 1024);
        packing.rotation = PackRotation::Twelfth;
        pushCommand(std::make_unique<ChangeSettings>(*studio.document(), packing));
        const QString path = studio.folder.filePath(u"kept.acproj"_s);
        QVERIFY(saveProject(studio.document()->state(), {}, path));
        const DocumentState read = loadProject(path).value().state;
        QCOMPARE(read.marks, studio.document()->marks());
        QCOMPARE(read.packingSettings, packing);
        studio.action("uv.freeOrientation")->trigger();
        QCOMPARE(studio.document()->marks().faceFlags[static_cast<std::size_t>(own.front())].upright, 0);
    }

    void theShapeChangesWhileASolveRuns()
    {
        TextureWindow studio;
        studio.press(Qt::Key_Space);
        QTRY_VERIFY(studio.context.shownMap.isLive());
        studio.setTexture(u"1024"_s, u"2048"_s);
        QVERIFY(studio.context.solver.isRunning());
        studio.document()->undoStack().undo();
        studio.document()->undoStack().redo();
        studio.press(Qt::Key_Space);
        QVERIFY(studio.solverRests() && studio.jobsRest());
        QVERIFY(studio.document()->validate().isEmpty());
        QCOMPARE(studio.packing().tileHeight(), 2.0);
        // During an unwrap, and with Escape.
        studio.press(Qt::Key_U);
        QVERIFY(studio.context.map.jobs().isBusy());
        studio.setTexture(u"2048"_s, u"1024"_s);
        QVERIFY(studio.context.map.jobs().isBusy());
        studio.press(Qt::Key_Escape);
        QVERIFY(studio.jobsRest());
        QVERIFY(studio.document()->validate().isEmpty());
        while (studio.document()->undoStack().canUndo())
            studio.document()->undoStack().undo();
        QVERIFY(studio.document()->validate().isEmpty());
        QCOMPARE(studio.packing(), PackingSettings());
    }

    void rotationIsChosenByKeys()
    {
        TextureWindow studio;
        auto *const rotation = studio.window.findChild<QComboBox *>(u"rotation"_s);
        rotation->setFocus();
        QTest::keyClick(rotation, Qt::Key_Up);
        QCOMPARE(studio.packing().rotation, PackRotation::TwentyFourth);
        QTest::keyClick(rotation, Qt::Key_Home);
        QTest::keyClick(rotation, Qt::Key_Down);
        QCOMPARE(studio.packing().rotation, PackRotation::Half);
    }
};

QTEST_MAIN(TestTexture)

} // namespace tst_texture

#include "tst_texture.moc"
