// The textures that a model names, and sets of tiles, in the window: drawing, messages, the choice of
// pattern.
#include "support/studiosession.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"
#include "views/control/pictures/modelpictures.h"
#include "views/panels/noticebar.h"
#include "views/ui/task.h"

#include <QComboBox>
#include <QLabel>
#include <QScopeGuard>
#include <QSemaphore>
#include <QSignalSpy>

namespace tst_modelpictures {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr QRgb red = qRgb(240, 20, 20), green = qRgb(20, 230, 20), blue = qRgb(20, 20, 240);

//! Two quads side by side, with the materials "first" and "second". \param right where the second one begins
//! in the map
QByteArray quads(double right = 0.55)
{
    QByteArray text = "mtllib m.mtl\n";
    for (const int y : {0, 1}) {
        for (const int x : {0, 1, 2})
            text += "v " + QByteArray::number(x) + ' ' + QByteArray::number(y) + " 0\n";
    }
    for (const double left : {0.05, right}) {
        for (const double v : {0.05, 0.45}) {
            for (const double u : {left, left + 0.4})
                text += "vt " + QByteArray::number(u) + ' ' + QByteArray::number(v) + '\n';
        }
    }
    return text + "usemtl first\nf 1/1 2/2 5/4 4/3\nusemtl second\nf 2/5 3/6 6/8 5/7\n";
}

void fill(const QString &path, QRgb color, int side = 32)
{
    QImage image(side, side, QImage::Format_RGB32);
    image.fill(color);
    QVERIFY(image.save(path));
}

bool isNear(const QColor &color, QRgb other)
{
    const QColor wanted(other);
    // Lighting changes brightness, not hue.
    return color.hue() >= 0 && std::abs(color.hue() - wanted.hue()) < 25 && color.saturation() > 90;
}

//! A window with a folder for models.
struct Desk : test::StudioSession
{
    ModelPictures &pictures = context.pictures;
    QSignalSpy noticed{&pictures, &ModelPictures::noticed};

    QString at(const char *name) const { return folder.filePath(QLatin1String(name)); }
    void put(const char *name, const QByteArray &bytes) const
    {
        QFile file(at(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    bool open(const char *name)
    {
        context.files.open(at(name));
        const bool loaded = QTest::qWaitFor(
            [this] { return !context.files.jobs().isBusy() && !pictures.isLoading(); }, test::patience);
        OrbitCamera camera;
        camera.frame(Vec3::Zero(), 1);
        camera.setDirection(0, 0);
        window.meshView().setCamera(camera);
        return loaded && document();
    }
    Pattern pattern() const { return context.view.options().pattern; }
    //! The colour of a face in the 3D view.
    QColor onModel(int face)
    {
        Canvas &view = window.meshView();
        QPointF place;
        for (const int k : {0, 1, 2})
            place += view.screenOf(6 * face + k).value_or(QPointF()) / 3;
        return at(view, place);
    }
    QColor inMap(double u, double v)
    {
        return at(window.uvView(), window.uvView().camera().toScreen({u, v}));
    }
    static QColor at(Canvas &view, const QPointF &place)
    {
        const QImage picture = view.picture();
        return picture.pixelColor((place * picture.devicePixelRatio()).toPoint());
    }
};

} // namespace

class TestModelPictures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyMaterialHasItsOwn()
    {
        Desk desk;
        desk.put("m.obj", quads());
        desk.put("m.mtl", "newmtl first\nmap_Kd red.png\nnewmtl second\nmap_Kd sub\\blue.png\n");
        fill(desk.at("red.png"), red, 48); // of another size
        QVERIFY(QDir(desk.folder.path()).mkdir(u"sub"_s));
        fill(desk.at("sub/blue.png"), blue);
        QVERIFY(desk.open("m.obj"));
        QCOMPARE(desk.pattern(), Pattern::Materials);
        QVERIFY(desk.action("view.pattern.materials")->isChecked());
        QVERIFY(isNear(desk.onModel(0), red));
        QVERIFY(isNear(desk.onModel(1), blue));
        QVERIFY(isNear(desk.inMap(0.2, 0.2), red) && isNear(desk.inMap(0.7, 0.2), blue));
        QCOMPARE(desk.noticed.count(), 0);

        // Behind the map: the picture of the selected face.
        const QColor first = desk.inMap(0.5, 0.9);
        QVERIFY(first.red() > first.blue() + 20);
        QTest::mouseClick(
            &desk.window.meshView(), Qt::LeftButton, {},
            ((*desk.window.meshView().screenOf(6) + *desk.window.meshView().screenOf(8)) / 2).toPoint());
        QCOMPARE(desk.document()->selection().faces, QList<int>{1});
        const QColor second = desk.inMap(0.5, 0.9);
        QVERIFY(second.blue() > second.red() + 20);

        // They stay while a solve runs, after undo and after another map.
        desk.press(Qt::Key_Space);
        QVERIFY(desk.runsTo(2));
        QVERIFY(isNear(desk.onModel(0), red));
        desk.press(Qt::Key_Escape);
        desk.context.solver.pause();
        QVERIFY(desk.solverRests());
        desk.document()->undoStack().undo();
        QVERIFY(isNear(desk.onModel(0), red));

        // T leads on to none, and back.
        desk.press(Qt::Key_T);
        QCOMPARE(desk.pattern(), Pattern::None);
        QVERIFY(!isNear(desk.onModel(0), red));
        for (const Pattern next : {Pattern::Checker, Pattern::Lettered, Pattern::Materials}) {
            desk.press(Qt::Key_T);
            QCOMPARE(desk.pattern(), next);
        }
        QVERIFY(isNear(desk.onModel(0), red));

        // A model without textures gets back the pattern that was there before.
        QFile::remove(desk.at("m.mtl"));
        QVERIFY(desk.open("m.obj"));
        QCOMPARE(desk.pattern(), Pattern::None);
    }

    void brokenOnesAreToldOnce()
    {
        Desk desk;
        desk.put("m.obj", quads() + "usemtl third\nf 1/1 2/2 5/4\nusemtl fourth\nf 1/1 5/4 4/3\n");
        desk.put("m.mtl", "newmtl first\nmap_Kd huge.bmp\nnewmtl second\nmap_Kd red.png\n"
                          "newmtl third\nmap_Kd gone.png\nnewmtl fourth\nmap_Kd broken.png\n");
        fill(desk.at("red.png"), red);
        desk.put("broken.png", "no picture");
        // The head of a picture of 20000 x 1000 pixels.
        desk.put("huge.bmp", QByteArray::fromHex("424d360000000000000036000000280000"
                                                 "00204e0000e80300000100180000000000") +
                                 QByteArray(200, '\0'));
        QVERIFY(desk.open("m.obj"));
        QTRY_COMPARE(desk.noticed.count(), 1);
        const QString message = desk.noticed[0][0].toString();
        for (const char *name : {"huge.bmp (20000 x 1000", "gone.png (not found)", "broken.png ("})
            QVERIFY2(message.contains(QLatin1String(name)), qPrintable(message));
        QCOMPARE(desk.window.findChild<NoticeBar *>()->message(), message);
        QVERIFY(desk.answers->errors.isEmpty());
        QVERIFY(isNear(desk.onModel(1), red));
        // Drawn and chosen again, nothing more is said.
        for (int i = 0; i < 4; ++i)
            desk.press(Qt::Key_T);
        QCOMPARE(desk.pattern(), Pattern::Materials);
        QCOMPARE(desk.noticed.count(), 1);
    }

    //! Neither the next model nor the one before it gets pictures that were still being read.
    void anotherModelIsOpenedMeanwhile()
    {
        Desk desk;
        desk.put("m.obj", quads());
        desk.put("m.mtl", "newmtl first\nmap_Kd red.png\n");
        fill(desk.at("red.png"), red, 1024);
        QVERIFY(desk.open("m.obj"));
        QVERIFY(isNear(desk.onModel(0), red));
        QVERIFY(QDir(desk.folder.path()).mkdir(u"other"_s));
        desk.put("other/n.obj", QByteArray(quads()).replace("m.mtl", "n.mtl"));
        desk.put("other/n.mtl", "newmtl first\nmap_Kd blue.png\n");
        fill(desk.at("other/blue.png"), blue, 512);
        const auto opened = [&](const char *name) {
            desk.context.files.open(desk.at(name));
            return QTest::qWaitFor(
                [&] { return desk.jobsRest() && desk.document()->state().scene.path == desk.at(name); },
                test::patience);
        };
        std::optional<Task::Hold> hold(std::in_place);
        for (const char *name : {"other/n.obj", "m.obj", "other/n.obj"}) {
            QVERIFY(opened(name));
            QCoreApplication::processEvents();
            QVERIFY(!isNear(desk.onModel(0), red) && !isNear(desk.onModel(0), blue));
        }
        hold.reset();
        QTRY_VERIFY(!desk.context.pictures.isLoading());
        QVERIFY(isNear(desk.onModel(0), blue));
        QCoreApplication::processEvents();
        QVERIFY(isNear(desk.onModel(0), blue) && !isNear(desk.onModel(1), red));
    }

    void aPreferenceLeavesThemOut()
    {
        Desk desk;
        desk.put("m.obj", quads());
        desk.put("m.mtl", "newmtl first\nmap_Kd red.png\n");
        fill(desk.at("red.png"), red);
        PreferenceValues values = desk.preferences.values();
        values.showTextures = false;
        desk.preferences.setValues(values);
        QVERIFY(desk.open("m.obj"));
        QCOMPARE(desk.pattern(), Pattern::None);
        QVERIFY(!isNear(desk.onModel(0), red));
        // The view panel shows them.
        auto *pattern = desk.window.findChild<QComboBox *>(u"pattern"_s);
        pattern->setFocus();
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(pattern, Qt::Key_Down);
        QCOMPARE(desk.pattern(), Pattern::Materials);
        QTRY_VERIFY(isNear(desk.onModel(0), red));
        QTRY_COMPARE(desk.window.findChild<QLabel *>(u"modelTextures"_s)->text(), u"of 1 materials"_s);
        QVERIFY(!isNear(desk.onModel(1), red)); // its material names none
        // A saved session keeps the choice.
        desk.context.files.save(desk.at("s.acproj"));
        QVERIFY(QTest::qWaitFor([&] { return !desk.context.files.isSaving(); }, test::patience));
        ViewOptions options = desk.context.view.options();
        options.pattern = Pattern::None;
        desk.context.view.setOptions(options);
        QVERIFY(desk.open("s.acproj"));
        QCOMPARE(desk.pattern(), Pattern::Materials);
        QTRY_VERIFY(isNear(desk.onModel(0), red));
    }

    void tilesHaveTheirOwnPictures_data()
    {
        QTest::addColumn<QString>("chosen");
        QTest::newRow("named by the model") << QString();
        QTest::newRow("loaded") << u"skin.1002.png"_s;
    }
    void tilesHaveTheirOwnPictures()
    {
        QFETCH(QString, chosen);
        Desk desk;
        desk.put("m.obj", quads(1.55));
        if (chosen.isEmpty())
            desk.put("m.mtl",
                     "newmtl first\nmap_Kd skin.<UDIM>.png\nnewmtl second\nmap_Kd skin.<UDIM>.png\n");
        fill(desk.at("skin.1001.png"), red);
        fill(desk.at("skin.1002.png"), green);
        QVERIFY(desk.open("m.obj"));
        if (!chosen.isEmpty()) {
            desk.answers->filesToOpen << desk.folder.filePath(chosen);
            desk.press(Qt::Key_T, Qt::ControlModifier);
            QCOMPARE(desk.pattern(), Pattern::Texture);
        }
        // Each view reads the pictures of both tiles by itself.
        QTRY_VERIFY(isNear(desk.onModel(0), red) && isNear(desk.onModel(1), green));
        desk.window.uvView().frameAll();
        QVERIFY(desk.measured()); // from then on tiles are tinted, but where pictures are shown
        QTRY_VERIFY(isNear(desk.inMap(0.2, 0.2), red) && isNear(desk.inMap(1.7, 0.2), green));
        const QColor left = desk.inMap(0.5, 0.9), right = desk.inMap(1.5, 0.9);
        QVERIFY(left.red() > left.green() + 20 && right.green() > right.red() + 20);
        QCOMPARE(desk.noticed.count(), 0);
    }
};

QTEST_MAIN(TestModelPictures)

} // namespace tst_modelpictures

#include "tst_modelpictures.moc"
