// Baking light in the studio: the dialog by mouse and keys, the set for lightmaps, files, views, Cancel.
#include "commands/changesettings.h"
#include "model/io/meshes/meshfile.h"
#include "model/pictures/picturefiles.h"
#include "support/mappedmodels.h"
#include "support/studiosession.h"
#include "views/canvas/meshview.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/pictures/livebake.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/lightbakedialog.h"
#include "views/panels/noticebar.h"
#include "views/shell/statusbar.h"
#include "views/state/viewstate.h"
#include "views/ui/colorbutton.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>

#include <algorithm>
#include <ranges>

namespace tst_lightdialog {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::StudioSession;

namespace {

//! The dialog, used by events.
struct DialogUser
{
    QDialog &dialog;

    template <class Widget>
    Widget *find(const char *name) const
    {
        return dialog.findChild<Widget *>(QLatin1StringView(name));
    }
    void type(QLineEdit *edit, const QString &text) const
    {
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
    }
    //! Types a number and leaves the field.
    template <class Box>
    void number(const char *name, const QString &text) const
    {
        auto *box = find<Box>(name);
        type(box->template findChild<QLineEdit *>(), text);
        QTest::keyClick(box, Qt::Key_Tab);
    }
    void path(const QString &text) const { type(find<QWidget>("path")->findChild<QLineEdit *>(), text); }
    //! Moves in a list by arrow keys.
    void choose(const char *name, int index) const
    {
        auto *box = find<QComboBox>(name);
        box->setFocus();
        while (box->currentIndex() != index)
            QTest::keyClick(box, box->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
    }
    void click(const char *name) const
    {
        auto *button = find<QAbstractButton>(name);
        QTest::mouseClick(button, Qt::LeftButton, {}, {8, button->height() / 2});
    }
    void switchSun() const
    {
        find<QGroupBox>("sun")->setFocus();
        QTest::keyClick(find<QGroupBox>("sun"), Qt::Key_Space);
    }
    //! Types into a cell of a table.
    void cell(const char *name, int row, int column, const QString &text) const
    {
        auto *table = find<QTableWidget>(name);
        table->setFocus();
        table->setCurrentCell(row, column);
        QTest::keyClick(table, Qt::Key_F2);
        auto *editor = table->viewport()->findChild<QLineEdit *>();
        [&] { QVERIFY(editor); }();
        type(editor, text);
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents(); // only now the text is taken
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    jobs::LightChoice choice() const { return static_cast<LightBakeDialog &>(dialog).choice(); }
    QString problem() const { return find<QLabel>("problem")->text(); }
    bool canBake() const { return find<QPushButton>("bake")->isEnabled(); }
    int bake() const
    {
        QTest::mouseClick(find<QPushButton>("bake"), Qt::LeftButton);
        return dialog.result();
    }
    int cancel() const
    {
        QTest::keyClick(&dialog, Qt::Key_Escape);
        return dialog.result();
    }
};

//! A studio with a box whose sides are islands in the first tile.
struct LightSession : StudioSession
{
    QString model = folder.filePath(u"box.obj"_s);
    QSignalSpy done{&context.map, &MapController::done}, failed{&context.map, &MapController::failed};

    explicit LightSession(int texture = 64)
    {
        Scene scene;
        const test::MappedModel box = test::mapped(test::box(4), test::boxMap());
        scene.mesh = box.mesh;
        scene.objectNames = {u"box"_s};
        scene.materialNames = {u"Paint"_s};
        scene.faceMaterial.assign(static_cast<std::size_t>(box.mesh->faceCount()), 0);
        scene.uvSets = {{u"UVMap"_s, box.uv}};
        QVERIFY(writeMesh(scene, model).ok());
        context.files.open(model);
        jobsRest();
        PackingSettings packing = document()->packingSettings();
        packing.setTexture(texture, texture);
        pushCommand(std::make_unique<ChangeSettings>(*document(), packing));
    }
    void ask(const std::function<int(const DialogUser &)> &user)
    {
        answers->onDialog = [&](QDialog &dialog) {
            dialog.open();
            [[maybe_unused]] const bool seen = QTest::qWaitForWindowExposed(&dialog);
            QApplication::setActiveWindow(&dialog);
            return user({dialog});
        };
        action("uv.bakeLight")->trigger();
        answers->onDialog = nullptr;
        QApplication::setActiveWindow(&window);
    }
    QString file(const char *name) const { return folder.filePath(QString::fromUtf8(name)); }
    QString said() const { return done.isEmpty() ? QString() : done.last().first().toString(); }
};

} // namespace

class TestLightDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lightIsBaked();
    void setsThatAreThere();
    void lightsReachTheModel();
    void everyChoiceIsKept();
    void theSurfaceReflectsWhatIsChosen();
    void problemsAreSaid();
    void cancelKeepsWhatThereIs();
    void cancelSaysWhichSetIsActive();
    void brightLightIsSaid();
};

void TestLightDialog::lightIsBaked()
{
    LightSession session;
    const QImage before = session.window.meshView().grab().toImage();
    QSignalSpy shown(&session.context.liveBake, &LiveBake::changed);
    session.ask([&](const DialogUser &user) {
        [&] { QCOMPARE(user.find<QComboBox>("uvSet")->currentText(), u"New set for lightmaps"_s); }();
        return user.bake();
    });
    QTRY_VERIFY_WITH_TIMEOUT(session.jobsRest() && session.said().contains(u"Baked light"_s), 60000);
    QCOMPARE(session.failed.count(), 0);
    // A set of its own, which is shown with its light.
    QCOMPARE(session.document()->uvSets().size(), std::size_t(2));
    QCOMPARE(session.document()->activeUvSet(), 1);
    QVERIFY(session.document()->uvSets()[1].name.startsWith(u"Lightmap"_s));
    QVERIFY2(session.said().endsWith(u". The UV set Lightmap is the active one now"_s),
             qPrintable(session.said()));
    const Result<Picture> picture = readPicture(session.file("box_light.png"));
    QVERIFY(picture.ok());
    QCOMPARE(picture->width, 64);
    const auto [dark, bright] = std::ranges::minmax(picture->values);
    QVERIFY(bright > 0.8F && dark < 0.1F);
    const LiveBake &live = session.context.liveBake;
    QVERIFY(live.isReceiving() && live.map().isEmpty());
    QVERIFY(session.context.view.options().pattern == Pattern::Baked);
    QTRY_VERIFY(live.updates() > 0 && shown.count() >= 2);
    const QImage last = live.pictures().images.front();
    QCOMPARE(last.width(), 64);
    const auto level = [&](int x, int y) { return int(255 * picture->at(x, y)[0] + 0.5F); };
    for (const auto &[x, y] : {std::pair(5, 9), {30, 20}, {50, 50}})
        QCOMPARE(qRed(last.pixel(x, y)), level(x, y));
    QVERIFY(session.window.meshView().grab().toImage() != before);
    // The new set is what undo takes back.
    session.press(Qt::Key_Z, Qt::ControlModifier);
    session.press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(session.document()->uvSets().size(), std::size_t(1));
    // Its light goes with it, and comes back with it.
    QTRY_VERIFY(live.pictures().images.empty());
    session.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    session.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(!live.pictures().images.empty());
    QCOMPARE(live.pictures().images.front(), last);
    // Another pattern ends the showing.
    session.action("view.pattern.checker")->trigger();
    QVERIFY(!live.isOn());
}

void TestLightDialog::setsThatAreThere()
{
    LightSession session;
    const DocumentState before = session.document()->state();
    session.ask([&](const DialogUser &user) {
        user.choose("uvSet", 0);
        user.number<QSpinBox>("size", u"100"_s);
        user.number<QSpinBox>("samples", u"4"_s);
        user.choose("format", 6);
        [&] { QVERIFY(user.choice().path.endsWith(u"box_light.exr"_s)); }();
        return user.bake();
    });
    QVERIFY(session.jobsRest());
    QTRY_VERIFY(session.said().contains(u"box_light.exr"_s));
    QVERIFY(!session.said().contains(u"UV set"_s));
    QVERIFY(session.document()->state() == before); // the map is as it was
    const Result<Picture> picture = readPicture(session.file("box_light.exr"));
    QVERIFY(picture.ok());
    QCOMPARE(picture->width, 100);
    // The file is there now: it is asked for.
    session.answers->confirms = false;
    session.ask([&](const DialogUser &user) {
        user.bake();
        [&] { QVERIFY(user.dialog.isVisible()); }();
        return user.cancel();
    });
    QCOMPARE(session.answers->confirmations.size(), 1);
    session.answers->confirms = true;
}

void TestLightDialog::lightsReachTheModel()
{
    LightSession session;
    const auto meanOf = [&](const std::function<void(const DialogUser &)> &lights) {
        session.ask([&](const DialogUser &user) {
            user.choose("uvSet", 0);
            user.number<QSpinBox>("samples", u"16"_s);
            lights(user);
            return user.bake();
        });
        const bool rests = session.jobsRest();
        const Result<Picture> picture = readPicture(session.file("box_light.png"));
        if (!rests || !picture || session.failed.count() > 0)
            return -1.0;
        double sum = 0;
        for (const float value : picture->values)
            sum += double(value);
        return sum / double(picture->values.size());
    };
    const double both = meanOf([](const DialogUser &) {});
    const double sky = meanOf([](const DialogUser &user) { user.switchSun(); });
    const double weak = meanOf(
        [](const DialogUser &user) { user.number<QDoubleSpinBox>("skyStrength", QLocale().toString(0.1)); });
    QVERIFY2(both > sky && sky > weak && weak > 0, qPrintable(u"%1 %2 %3"_s.arg(both).arg(sky).arg(weak)));
    const double lamp = meanOf([](const DialogUser &user) {
        user.choose("sky", 0);
        user.click("addLamp");
        user.cell("areas", 0, 3, u"0.25, 0.25, 2"_s);
    });
    QVERIFY(lamp > 0);
    const Result<Picture> blue = readPicture(session.file("box_light.png"));
    const auto most = std::ranges::max(std::views::iota(0, 64 * 64), {},
                                       [&](int i) { return blue->at(i % 64, i / 64)[2]; });
    QVERIFY(blue->at(most % 64, most / 64)[2] > 1.5F * blue->at(most % 64, most / 64)[0]);
    const double day = meanOf([](const DialogUser &user) {
        user.choose("sky", 3);
        user.click("removeLamp");
    });
    QVERIFY(day > 0);
}

void TestLightDialog::everyChoiceIsKept()
{
    LightSession session;
    const QString picture = session.file("albedo.png");
    QVERIFY(writePicture(Picture(2, 2, 3, 0.5F), picture, PictureDepth::Eight).ok());
    jobs::LightChoice first;
    session.ask([&](const DialogUser &user) {
        user.choose("uvSet", 0);
        user.number<QDoubleSpinBox>("azimuth", u"10"_s);
        user.number<QDoubleSpinBox>("elevation", u"20"_s);
        user.number<QDoubleSpinBox>("sunStrength", u"2"_s);
        user.number<QDoubleSpinBox>("sunAngle", u"5"_s);
        user.choose("sky", 2);
        user.number<QDoubleSpinBox>("turbidity", u"6"_s); // not for this sky
        user.choose("up", 1);
        user.choose("values", 2);
        user.number<QSpinBox>("size", u"48"_s);
        user.choose("format", 2);
        user.choose("albedo", 2);
        user.type(user.find<QLineEdit>("albedoPicture"), picture);
        user.choose("albedoUvSet", 1);
        for (const char *name : {"denoise", "direct"})
            user.click(name);
        user.number<QSpinBox>("samples", u"3"_s);
        user.number<QSpinBox>("bounces", u"2"_s);
        user.number<QSpinBox>("dilation", u"5"_s);
        user.click("addLamp");
        user.cell("areas", 0, 0, u"0, 0, 3"_s);
        user.cell("areas", 0, 2, u"2 x 1"_s);
        auto *shining = user.find<QTableWidget>("shining");
        shining->setFocus();
        shining->setCurrentCell(0, 0);
        QTest::keyClick(shining, Qt::Key_Space);
        user.cell("shining", 0, 1, u"0.5"_s);
        first = user.choice();
        return user.bake();
    });
    QVERIFY(session.jobsRest());
    QVERIFY(first.lights.sun && *first.lights.sun == Vec2(10, 20) && first.lights.zUp);
    QCOMPARE(first.lights.sunStrength, 2.0);
    QCOMPARE(first.lights.sunAngle, 5.0);
    QCOMPARE(first.lights.turbidity, 3.0);
    QCOMPARE(first.lights.sky->size(), std::size_t(3));
    QVERIFY(first.lights.sky->front() == Vec3f::Ones() && first.lights.sky->back().x() < 0.5F);
    QCOMPARE(first.lights.areas.size(), std::size_t(1));
    QCOMPARE(first.lights.areas[0].centre, Vec3(0, 0, 3));
    QCOMPARE(first.lights.areas[0].size, Vec2(2, 1));
    QCOMPARE(first.surface.emission.size(), std::size_t(1));
    QCOMPARE(first.surface.emission[0].first, u"Paint"_s);
    QCOMPARE(first.surface.emission[0].second, Vec3f(0.5F, 0.5F, 0.5F));
    QCOMPARE(first.textureSize, 48);
    QVERIFY(!first.denoise && !first.direct && first.indirect);
    QVERIFY(first.values == bake::LightValue::Lit);
    QCOMPARE(first.samples, 3);
    QCOMPARE(first.bounces, 2);
    QCOMPARE(first.dilation, 5);
    QCOMPARE(first.bits, 8);
    QVERIFY(first.path.endsWith(u"box_light.tif"_s));
    QCOMPARE(first.surface.albedoFile, picture);
    QCOMPARE(first.surface.albedoUvSet, u"UVMap"_s);
    QVERIFY(!first.surface.albedo);
    session.ask([&](const DialogUser &user) {
        [&] { QVERIFY(user.choice() == first); }();
        return user.cancel();
    });
    // Also through the session, in another run of the program.
    const QString saved = session.file("kept.acproj");
    session.context.files.save(saved);
    QVERIFY(session.jobsRest());
    LightSession later;
    later.context.files.open(saved);
    QVERIFY(later.jobsRest());
    later.ask([&](const DialogUser &user) {
        [&] { QVERIFY(user.choice() == first); }();
        return user.cancel();
    });
}

//! What is seen goes by what the surface reflects.
void TestLightDialog::theSurfaceReflectsWhatIsChosen()
{
    LightSession session;
    QVERIFY(writePicture(Picture(2, 2, 3, 0.25F), session.file("dark.png"), PictureDepth::Eight).ok());
    const auto brightest = [&](const std::function<void(const DialogUser &)> &change) {
        QFile::remove(session.file("box_light.png"));
        session.ask([&](const DialogUser &user) {
            user.choose("uvSet", 0);
            user.choose("values", 2); // what is seen
            change(user);
            return user.bake();
        });
        session.jobsRest();
        const Result<Picture> seen = readPicture(session.file("box_light.png"));
        return seen ? std::ranges::max(seen->values) : -1;
    };
    const float own = brightest([](const DialogUser &) {});
    QVERIFY(own > 0.5F);
    QCOMPARE(brightest([](const DialogUser &user) {
                 user.choose("albedo", 1);
                 user.find<ColorButton>("albedoColor")->setColor(Qt::black);
             }),
             0.0F);
    const float dark = brightest([&](const DialogUser &user) {
        [&] { QVERIFY(user.choice().surface.albedo == Vec3f(0, 0, 0)); }(); // kept
        user.choose("albedo", 2);
        [&] { QVERIFY(!user.canBake() && user.problem().contains(u"picture of the surface"_s)); }();
        user.type(user.find<QLineEdit>("albedoPicture"), session.file("dark.png"));
    });
    QVERIFY(dark > 0 && dark < 0.6F * own);
}

void TestLightDialog::problemsAreSaid()
{
    LightSession session;
    session.ask([&](const DialogUser &user) {
        [&] {
            QVERIFY(user.canBake());
            user.switchSun();
            user.choose("sky", 0);
            QVERIFY(!user.canBake() && user.problem().contains(u"at least one light"_s));
            user.click("addLamp");
            QVERIFY(user.canBake());
            user.cell("areas", 0, 2, u"wide"_s);
            QVERIFY(!user.canBake() && user.problem().contains(u"An area light needs"_s));
            user.cell("areas", 0, 2, u"1x2"_s);
            QVERIFY(user.canBake());
            user.click("removeLamp");
            QVERIFY(!user.canBake());
            user.switchSun();
            user.click("direct");
            user.click("indirect");
            QVERIFY(!user.canBake() && user.problem().contains(u"indirect light"_s));
            user.click("direct");
            user.path(u"/nowhere/light.png"_s);
            QVERIFY(!user.canBake() && user.problem().contains(u"folder"_s));
            user.path(session.file("light.bmp"));
            QVERIFY(!user.canBake());
            user.path(session.file("light.png"));
            QVERIFY(user.canBake());
        }();
        return user.cancel();
    });
    const QString bare = session.file("bare.obj");
    Scene scene;
    scene.mesh = test::box(2);
    scene.objectNames = {u"box"_s};
    scene.faceMaterial.assign(static_cast<std::size_t>(scene.mesh->faceCount()), -1);
    QVERIFY(writeMesh(scene, bare).ok());
    session.context.files.open(bare);
    QVERIFY(session.jobsRest());
    session.ask([&](const DialogUser &user) {
        [&] { QVERIFY(user.problem().contains(u"no UVs"_s)); }();
        return user.cancel();
    });
}

void TestLightDialog::cancelKeepsWhatThereIs()
{
    LightSession session(512);
    session.ask([&](const DialogUser &user) {
        user.choose("uvSet", 0);
        user.number<QSpinBox>("samples", u"1000000"_s);
        return user.bake();
    });
    const LiveBake &live = session.context.liveBake;
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > 2, 120000); // coarse pictures are seen
    QVERIFY(!QFile::exists(session.file("box_light.png")));
    QApplication::setActiveWindow(&session.window);
    session.press(Qt::Key_Escape);
    QVERIFY(session.jobsRest());
    QTRY_COMPARE(session.failed.count(), 1);
    QVERIFY(session.failed.last().first().toString().contains(u"found so far"_s));
    const Result<Picture> picture = readPicture(session.file("box_light.png"));
    QVERIFY(picture.ok() && std::ranges::max(picture->values) > 0.5F);
    QVERIFY(live.isReceiving());
}

//! The set was made for a bake that was given up, and would be edited unnoticed.
void TestLightDialog::cancelSaysWhichSetIsActive()
{
    LightSession session(512);
    session.ask([&](const DialogUser &user) {
        user.number<QSpinBox>("samples", u"1000000"_s);
        return user.bake();
    });
    QTRY_VERIFY_WITH_TIMEOUT(session.context.liveBake.updates() > 2, 120000);
    QApplication::setActiveWindow(&session.window);
    session.press(Qt::Key_Escape);
    QVERIFY(session.jobsRest());
    QTRY_COMPARE(session.failed.count(), 1);
    const QString said = session.failed.last().first().toString();
    QVERIFY2(said.contains(u"found so far"_s) &&
                 said.contains(u"The UV set Lightmap is the active one now"_s),
             qPrintable(said));
    QCOMPARE(session.window.findChild<NoticeBar *>()->message(), said);
    QCOMPARE(session.window.findChild<StatusBar *>()->setText(), u"UV set: Lightmap"_s);
}

void TestLightDialog::brightLightIsSaid()
{
    LightSession session;
    session.ask([&](const DialogUser &user) {
        user.choose("uvSet", 0);
        user.number<QDoubleSpinBox>("sunStrength", u"20"_s);
        return user.bake();
    });
    QVERIFY(session.jobsRest());
    QTRY_COMPARE(session.failed.count(), 1);
    QVERIFY(session.failed.last().first().toString().contains(u"above 1"_s));
    QVERIFY(QFile::exists(session.file("box_light.png")));
}

QTEST_MAIN(TestLightDialog)

} // namespace tst_lightdialog

#include "tst_lightdialog.moc"
