// Texture sets in the window: the panel, light, channels, changed files, sessions.
#include "commands/setuvs.h"
#include "model/pictures/picturefiles.h"
#include "support/studiosession.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"
#include "views/control/pictures/modelpictures.h"
#include "views/panels/noticebar.h"
#include "views/shell/statusbar.h"
#include "views/ui/task.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTreeWidget>

#include <optional>

namespace tst_textureviews {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! A quad that fills its tile, facing the viewer.
const QByteArray quad = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                        "usemtl wood\nf 1/1 2/2 3/3 4/4\n";

void put(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

//! Writes it as image editors do: the old file is deleted first.
void fill(const QString &path, QColor color, int side = 16)
{
    QImage image(side, side, QImage::Format_RGB32);
    image.fill(color);
    QFile::remove(path);
    QVERIFY(image.save(path));
}

//! A window with a quad and a folder of pictures for its material.
struct Desk : test::StudioSession
{
    ModelPictures &pictures = context.pictures;
    QSignalSpy noticed{&pictures, &ModelPictures::noticed};

    Desk()
    {
        put(at("m.obj"), quad);
        put(at("m.mtl"), "newmtl wood\nKd 0.5 0.5 0.5\n");
        QVERIFY(QDir(folder.path()).mkdir(u"maps"_s));
        fill(at("maps/wood_BaseColor.png"), QColor(200, 60, 30));
        fill(at("maps/wood_Roughness.png"), QColor(90, 90, 90));
        fill(at("maps/wood_Metallic.png"), Qt::black);
        fill(at("maps/wood_Normal.png"), QColor(128, 220, 200)); // leans up
        fill(at("maps/wood_AO.png"), Qt::white);
        open();
    }
    QString at(const char *name) const { return folder.filePath(QLatin1String(name)); }
    void open()
    {
        context.files.open(at("m.obj"));
        QVERIFY(QTest::qWaitFor([this] { return document() && jobsRest() && loaded(); }, test::patience));
        lookFromFront();
        raise();
    }
    void lookFromFront()
    {
        OrbitCamera camera;
        camera.frame(Vec3::Zero(), 1);
        camera.setDirection(0, 0);
        window.meshView().setCamera(camera);
    }
    //! The panel.
    void raise()
    {
        auto *dock = window.findChild<QDockWidget *>(u"textures"_s);
        dock->raise();
        QCoreApplication::processEvents();
    }
    bool loaded()
    {
        return QTest::qWaitFor([this] { return !pictures.isLoading() && !pictures.light().isLoading(); },
                               test::patience);
    }
    template <class W>
    W *child(const char *name)
    {
        return window.findChild<W *>(QLatin1String(name));
    }
    void click(const char *name)
    {
        auto *button = child<QAbstractButton>(name);
        QVERIFY(button && button->isEnabled());
        QTest::mouseClick(button, Qt::LeftButton, {}, {8, button->height() / 2});
        QCoreApplication::processEvents();
    }
    void choose(const char *name, int steps)
    {
        auto *box = child<QComboBox>(name);
        box->setFocus();
        for (; steps > 0; --steps)
            QTest::keyClick(box, Qt::Key_Down);
        for (; steps < 0; ++steps)
            QTest::keyClick(box, Qt::Key_Up);
    }
    void loadFolder()
    {
        answers->filesToOpen = {at("maps")};
        click("loadTextureFolder");
        QVERIFY(loaded());
    }
    QString shown(int channel)
    {
        QCoreApplication::processEvents();
        return child<QTreeWidget>("channels")->topLevelItem(channel)->text(1);
    }
    QColor onModel()
    {
        Canvas &view = window.meshView();
        view.picture(); // asks for tangents
        Task::waitForAll();
        QCoreApplication::processEvents();
        return middleOf(view.picture());
    }
    QColor middleOf(const QImage &picture)
    {
        Canvas &view = window.meshView();
        const QPointF middle = (*view.screenOf(0) + *view.screenOf(2)) / 2 + QPointF(5, 9);
        return picture.pixelColor((middle * picture.devicePixelRatio()).toPoint());
    }
    QColor inMap()
    {
        Canvas &view = window.uvView();
        const QImage picture = view.picture();
        return picture.pixelColor(
            (window.uvView().camera().toScreen({0.4, 0.3}) * picture.devicePixelRatio()).toPoint());
    }
    const ViewOptions &options() const { return context.view.options(); }
};

int brightness(const QColor &color)
{
    return color.red() + color.green() + color.blue();
}

bool isNear(const QColor &a, const QColor &b, int tolerance)
{
    return std::abs(a.red() - b.red()) <= tolerance && std::abs(a.green() - b.green()) <= tolerance &&
           std::abs(a.blue() - b.blue()) <= tolerance;
}

} // namespace

class TestTextureViews : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! Chosen by keys in the View panel.
    void vertexColors()
    {
        Desk desk;
        QByteArray colored = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
        for (const char *place : {"0 0 0", "1 0 0", "1 1 0", "0 1 0"})
            colored += QByteArray("v ") + place + " .9 .1 .2\n";
        put(desk.at("c.obj"), colored + "f 1/1 2/2 3/3 4/4\n");
        desk.context.files.open(desk.at("c.obj"));
        QVERIFY(QTest::qWaitFor(
            [&] { return desk.jobsRest() && desk.document()->state().scene.cornerColors; }, test::patience));
        desk.lookFromFront();
        const QColor plain = desk.onModel();
        QVERIFY2(plain.red() < plain.green() + 25, qPrintable(plain.name()));
        desk.window.findChild<QDockWidget *>(u"view"_s)->raise();
        desk.choose("coloring", 7);
        QCOMPARE(desk.options().coloring, Coloring::VertexColors);
        for (const QColor &color : {desk.onModel(), desk.inMap()})
            QVERIFY2(color.red() > color.green() + 60 && color.red() > color.blue() + 50,
                     qPrintable(color.name()));
    }

    void aFolderIsLoaded()
    {
        Desk desk;
        QCOMPARE(desk.shown(0), u"none"_s);
        desk.loadFolder();
        QCOMPARE(desk.options().pattern, Pattern::Physical);
        QCOMPARE(desk.shown(0), u"wood_BaseColor.png"_s);
        QCOMPARE(desk.shown(3), u"wood_Normal.png"_s);
        QCOMPARE(desk.shown(6), u"none"_s);
        QCOMPARE(desk.noticed.count(), 0);
        const QColor lit = desk.onModel();
        QVERIFY2(lit.red() > lit.green() + 25 && lit.red() > lit.blue() + 25, qPrintable(lit.name()));
        QVERIFY(!desk.pictures.thumbnail(0, TextureChannel::BaseColor, 8).isNull());

        // One undo takes all of them away, redo brings them back.
        desk.document()->undoStack().undo();
        QVERIFY(desk.loaded());
        QCOMPARE(desk.shown(0), u"none"_s);
        const QColor plain = desk.onModel();
        QVERIFY(std::abs(plain.red() - plain.blue()) < 25);
        desk.document()->undoStack().redo();
        QVERIFY(desk.loaded());
        QVERIFY(isNear(desk.onModel(), lit, 2));

        // A folder without such names changes nothing.
        desk.answers->filesToOpen = {desk.at("recovery")};
        desk.click("loadTextureFolder");
        QCOMPARE(desk.answers->errors.size(), 1);
        QVERIFY(isNear(desk.onModel(), lit, 2));
    }

    //! Also where a redo brings them back: the window goes on meanwhile.
    void theBarSaysThatTheyAreRead()
    {
        Desk desk;
        desk.loadFolder();
        auto *progress = desk.child<QProgressBar>("progress");
        desk.press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(desk.loaded());
        QTRY_VERIFY(!progress->isVisible());
        // All threads that read pictures are busy for as long as the test wants.
        std::optional<Task::Hold> busy(std::in_place);
        desk.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(desk.shown(0), u"wood_BaseColor.png"_s); // the document is there at once
        QTRY_VERIFY(progress->isVisible());
        QCOMPARE(progress->maximum(), 0); // moves
        const auto *bar = desk.window.findChild<StatusBar *>();
        QVERIFY2(bar->shownText().contains(u"eading textures"_s), qPrintable(bar->shownText()));
        busy.reset();
        QVERIFY(desk.loaded());
        QVERIFY(!progress->isVisible());
        QVERIFY(!bar->shownText().contains(u"eading textures"_s));
    }

    void channelsAreShownAsTheyAre()
    {
        Desk desk;
        desk.loadFolder();
        const QColor expected[] = {{200, 60, 30}, {90, 90, 90}, {0, 0, 0}, {128, 220, 214}, {255, 255, 255}};
        desk.choose("shownChannel", 1);
        for (const QColor &color : expected) {
            QVERIFY2(isNear(desk.onModel(), color, 8), qPrintable(desk.onModel().name() + color.name()));
            const QColor map = desk.inMap(); // islands lie over it, a little darker or brighter
            QVERIFY2(isNear(map, color, 70), qPrintable(map.name() + color.name()));
            desk.choose("shownChannel", 1);
        }
        desk.choose("shownChannel", -6);
        QCOMPARE(desk.options().shownChannel, -1);
    }

    void greenUpAndDown()
    {
        Desk desk;
        desk.loadFolder();
        const int up = brightness(desk.onModel()); // towards the light above
        desk.click("directX");
        QVERIFY(desk.loaded());
        QVERIFY(desk.document()->state().textureSet(0).at(TextureChannel::Normal).flipped);
        const int down = brightness(desk.onModel());
        QVERIFY2(up > down + 30, qPrintable(u"%1 %2"_s.arg(up).arg(down)));
        desk.document()->undoStack().undo();
        QVERIFY(desk.loaded());
        QVERIFY(std::abs(brightness(desk.onModel()) - up) < 6);
    }

    //! Tangents take long. A map has those of the map before until its own are there.
    void tangentsAreMadeOnAnotherThread()
    {
        Desk desk;
        desk.loadFolder();
        Canvas &view = desk.window.meshView();
        const int up = brightness(desk.onModel());
        const UvMatrix turned = 1 - desk.document()->uv().array(); // half a turn: up is down
        {
            const Task::Hold busy;
            desk.document()->undoStack().push(
                std::make_unique<SetUvs>(*desk.document(), UvEdit::Rotate, turned));
            QVERIFY(std::abs(brightness(desk.middleOf(view.picture())) - up) < 6);
            desk.document()->undoStack().undo();
            view.picture();
            desk.document()->undoStack().redo();
            QVERIFY(std::abs(brightness(desk.middleOf(view.picture())) - up) < 6);
        }
        QTRY_VERIFY(brightness(desk.middleOf(view.picture())) < up - 30);
        desk.document()->undoStack().undo();
        QTRY_VERIFY(std::abs(brightness(desk.middleOf(view.picture())) - up) < 6);
    }

    void lightCanBeChanged()
    {
        Desk desk;
        desk.loadFolder();
        const int before = brightness(desk.onModel());
        QSlider *exposure = desk.child<QWidget>("exposure")->findChild<QSlider *>();
        exposure->setFocus();
        for (int i = 0; i < 12; ++i)
            QTest::keyClick(exposure, Qt::Key_Right);
        QVERIFY(desk.options().exposure > 0.5);
        QVERIFY(brightness(desk.onModel()) > before + 20);
        const QColor corner = desk.window.meshView().picture().pixelColor(12, 200);
        desk.click("showSurroundings");
        QVERIFY(!isNear(desk.window.meshView().picture().pixelColor(12, 200), corner, 3));
        const QColor studio = desk.onModel();
        desk.choose("surroundings", 1);
        QVERIFY(desk.loaded());
        QVERIFY(!isNear(desk.onModel(), studio, 2));

        // Own surroundings: green from all sides.
        Picture panorama(64, 32, 3);
        for (std::size_t i = 1; i < panorama.values.size(); i += 3)
            panorama.values[i] = 0.8F;
        QVERIFY(writePicture(panorama, desk.at("green.exr"), PictureDepth::Float).ok());
        desk.answers->filesToOpen = {desk.at("green.exr")};
        desk.click("loadSurroundings");
        QVERIFY(desk.loaded());
        QCOMPARE(desk.options().surroundings, Surroundings::File);
        QVERIFY(desk.onModel().green() > desk.onModel().red() + 40);
        // A file that cannot be read is told, and the last ones stay.
        put(desk.at("broken.hdr"), "#?RADIANCE\n\nrubbish");
        desk.answers->filesToOpen = {desk.at("broken.hdr")};
        desk.click("loadSurroundings");
        QTRY_COMPARE(desk.noticed.count(), 1);
        QVERIFY(desk.onModel().green() > desk.onModel().red() + 40);
    }

    void changedFilesAreReadAgain()
    {
        Desk desk;
        desk.loadFolder();
        const auto shows = [&](int hue) {
            const QColor color = desk.onModel();
            return std::abs(color.hue() - hue) < 40 && color.saturation() > 40;
        };
        for (const auto &[color, hue] : {std::pair(QColor(20, 40, 200), 230), {QColor(20, 200, 40), 128}}) {
            QTest::qWait(20); // another time of change
            fill(desk.at("maps/wood_BaseColor.png"), color, hue == 128 ? 24 : 16);
            QTRY_VERIFY_WITH_TIMEOUT(shows(hue), 10000);
        }
        // While it is away the other channels stay; the notice comes once.
        QFile::remove(desk.at("maps/wood_BaseColor.png"));
        QTRY_COMPARE(desk.noticed.count(), 1);
        QVERIFY(desk.noticed[0][0].toString().contains(u"wood_BaseColor.png"_s));
        QCOMPARE(desk.window.findChild<NoticeBar *>()->message(), desk.noticed[0][0].toString());
        QCOMPARE(desk.shown(0), u"wood_BaseColor.png"_s);
        fill(desk.at("maps/wood_BaseColor.png"), QColor(200, 60, 30));
        QTRY_VERIFY_WITH_TIMEOUT(shows(10), 10000);
        QCOMPARE(desk.noticed.count(), 1);
    }

    void sessionsKeepThem()
    {
        Desk desk;
        desk.loadFolder();
        desk.choose("shownChannel", 2);
        const QColor before = desk.onModel();
        desk.context.files.save(desk.at("s.acproj"));
        QVERIFY(QTest::qWaitFor([&] { return desk.jobsRest() && !desk.context.workspace.isModified(); },
                                test::patience));
        desk.open(); // the model again
        QCOMPARE(desk.shown(0), u"none"_s);
        desk.context.files.open(desk.at("s.acproj"));
        QVERIFY(QTest::qWaitFor([&] { return desk.jobsRest() && desk.loaded(); }, test::patience));
        desk.lookFromFront();
        QCOMPARE(desk.shown(1), u"wood_Roughness.png"_s);
        QCOMPARE(desk.options().shownChannel, 1);
        QVERIFY(isNear(desk.onModel(), before, 2));
    }

    void packedChannels()
    {
        Desk desk;
        QImage packed(16, 16, QImage::Format_RGB32);
        packed.fill(QColor(220, 120, 40));
        QVERIFY(packed.save(desk.at("pack.png")));
        desk.answers->filesToOpen = {desk.at("pack.png")};
        auto *button = desk.child<QPushButton>("loadPacked");
        // The menu waits for the keys: down to the first order, and Return.
        QTimer::singleShot(200, button, [menu = button->menu()] {
            QTest::keyClick(menu, Qt::Key_Down);
            QTest::keyClick(menu, Qt::Key_Return);
        });
        desk.click("loadPacked");
        QTRY_COMPARE(desk.shown(int(TextureChannel::Occlusion)), u"pack.png, red"_s);
        QVERIFY(desk.loaded());
        QCOMPARE(desk.shown(int(TextureChannel::Roughness)), u"pack.png, green"_s);
        QCOMPARE(desk.shown(int(TextureChannel::Metalness)), u"pack.png, blue"_s);
        desk.choose("shownChannel", 2);
        QVERIFY2(isNear(desk.onModel(), {120, 120, 120}, 4), qPrintable(desk.onModel().name()));
        // The roughness from the blue.
        desk.child<QTreeWidget>("channels")
            ->setCurrentItem(
                desk.child<QTreeWidget>("channels")->topLevelItem(int(TextureChannel::Roughness)));
        QCOMPARE(desk.child<QComboBox>("component")->currentText(), u"green"_s);
        desk.choose("component", 1);
        QVERIFY(desk.loaded());
        QCOMPARE(desk.shown(int(TextureChannel::Roughness)), u"pack.png, blue"_s);
        QVERIFY2(isNear(desk.onModel(), {40, 40, 40}, 4), qPrintable(desk.onModel().name()));
        desk.context.files.save(desk.at("p.acproj"));
        QVERIFY(QTest::qWaitFor([&] { return desk.jobsRest() && !desk.context.workspace.isModified(); },
                                test::patience));
        // Undo takes back first the component, then all three at once.
        desk.press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(desk.shown(int(TextureChannel::Roughness)), u"pack.png, green"_s);
        desk.press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(desk.shown(int(TextureChannel::Roughness)), u"none"_s);
        QCOMPARE(desk.shown(int(TextureChannel::Occlusion)), u"none"_s);
        QVERIFY(!desk.child<QComboBox>("component")->isEnabled());
        // Sessions keep it.
        desk.context.files.open(desk.at("p.acproj"));
        QVERIFY(QTest::qWaitFor([&] { return desk.jobsRest() && desk.loaded(); }, test::patience));
        QCOMPARE(desk.shown(int(TextureChannel::Roughness)), u"pack.png, blue"_s);
    }

    void componentsOfTheModelsPictures()
    {
        Desk desk;
        put(desk.at("m.mtl"), "newmtl wood\nmap_Kd maps/wood_BaseColor.png\n");
        desk.open();
        QCOMPARE(desk.shown(0), u"wood_BaseColor.png"_s);
        desk.choose("component", 2); // green
        QVERIFY(desk.loaded());
        QCOMPARE(desk.shown(0), u"wood_BaseColor.png, green"_s);
        const ChannelPicture own = desk.document()->state().textureSets.at(1).at(TextureChannel::BaseColor);
        QVERIFY(own.fromModel && own.component == 1);
    }

    void onePicture()
    {
        Desk desk;
        Picture grey(8, 8, 1, 0.5F);
        QVERIFY(writePicture(grey, desk.at("any.exr"), PictureDepth::Float).ok());
        desk.answers->filesToOpen = {desk.at("any.exr")};
        desk.click("loadChannel"); // the marked one is the base colour
        QVERIFY(desk.loaded());
        QCOMPARE(desk.shown(0), u"any.exr"_s);
        desk.choose("shownChannel", 1);
        // Float colours are linear: 0.5 is 188 in sRGB.
        QVERIFY2(isNear(desk.onModel(), {188, 188, 188}, 4), qPrintable(desk.onModel().name()));
        desk.click("removeChannel");
        QVERIFY(desk.loaded());
        QCOMPARE(desk.shown(0), u"none"_s);
    }
};

QTEST_MAIN(TestTextureViews)

} // namespace tst_textureviews

#include "tst_textureviews.moc"
