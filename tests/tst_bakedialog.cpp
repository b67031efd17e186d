// Baking in the studio: the dialog by mouse and keys, the job, its files, Cancel, and a solve that runs.
#include "commands/changesettings.h"
#include "commands/edittextures.h"
#include "jobs/bakechoice.h"
#include "model/io/meshfile.h"
#include "model/io/picturefiles.h"
#include "support/damagedsessions.h"
#include "support/mappedmodels.h"
#include "support/studiosession.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"
#include "views/control/filecontroller.h"
#include "views/control/livebake.h"
#include "views/control/mapcontroller.h"
#include "views/control/modelpictures.h"
#include "views/control/workspace.h"
#include "views/dialogs/bakedialog.h"
#include "views/state/viewstate.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::MappedModel;
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
    void type(const char *name, const QString &text) const
    {
        auto *edit = find<QLineEdit>(name);
        QTest::mouseClick(edit, Qt::LeftButton);
        edit->selectAll();
        QTest::keyClicks(edit, text);
    }
    void typeCage(const QString &text) const
    {
        auto *number = find<QDoubleSpinBox>("cage")->findChild<QLineEdit *>();
        number->setFocus();
        number->selectAll();
        QTest::keyClicks(number, text);
    }
    //! Ticks or clears a map by the space bar.
    void toggle(int row) const
    {
        auto *maps = find<QListWidget>("maps");
        maps->setFocus();
        maps->setCurrentRow(row);
        QTest::keyClick(maps, Qt::Key_Space);
    }
    QString problem() const { return find<QLabel>("problem")->text(); }
    jobs::BakeChoice choice() const { return static_cast<BakeDialog &>(dialog).choice(); }
    int bake() const
    {
        QTest::mouseClick(find<QPushButton>("bake"), Qt::LeftButton);
        return dialog.result();
    }
};

//! A studio with a box, and a larger box to bake from.
struct BakeSession : StudioSession
{
    QString low = folder.filePath(u"low.obj"_s), high = folder.filePath(u"high.obj"_s);
    QSignalSpy done{&context.map, &MapController::done}, failed{&context.map, &MapController::failed};

    explicit BakeSession(bool twoTiles = false)
    {
        MappedModel box = test::mapped(test::box(4), test::boxMap());
        for (Eigen::Index corner = 0; twoTiles && corner < box.uv.rows(); ++corner)
            box.uv(corner, 0) += box.uv(corner, 0) > 0.65 ? 1 : 0; // two sides of the box
        write(low, box);
        write(high, {test::box(9, Vec3(2.02, 2.02, 2.02)), UvMatrix(0, 2)});
        context.files.open(low);
        jobsRest();
        setTexture(64);
    }
    void setTexture(int size)
    {
        PackingSettings packing = document()->packingSettings();
        packing.setTexture(size, size);
        pushCommand(std::make_unique<ChangeSettings>(*document(), packing));
    }
    static void write(const QString &path, const MappedModel &model)
    {
        Scene scene;
        scene.mesh = model.mesh;
        scene.objectNames = {u"box"_s};
        scene.faceMaterial.assign(static_cast<std::size_t>(model.mesh->faceCount()), -1);
        if (model.uv.rows() > 0)
            scene.uvSets = {{u"UVMap"_s, model.uv}};
        QVERIFY(writeMesh(scene, path).ok());
    }
    void bake(const std::function<int(const DialogUser &)> &user)
    {
        answers->onDialog = [&](QDialog &dialog) {
            dialog.open();
            [[maybe_unused]] const bool seen = QTest::qWaitForWindowExposed(&dialog);
            QApplication::setActiveWindow(&dialog);
            return user({dialog});
        };
        action("uv.bake")->trigger();
        answers->onDialog = nullptr;
        QApplication::setActiveWindow(&window);
    }
    QString file(const char *name) const { return folder.filePath(QString::fromUtf8(name)); }
};

} // namespace

class TestBakeDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void picturesAreBaked();
    void everyChoiceIsKept();
    void theCageIsProposed();
    void theProposalIsBaked();
    void cagesComeFromFiles();
    void problemsAreSaid();
    void cancelEndsIt();
    void faultsAreSaid();
    void whatADamagedSessionLostIsSaid();
    void everyMapHasATitle();
    void liveBakesFollowTheMap();
    void liveNormalsAreLit();
    void liveColorsGoAlong();
    void liveBakesEnd();
    void liveBakesFillAllTiles();
    void whatALiveBakeMissesIsSaid();
    void anotherMapIsShownLive();
};

void TestBakeDialog::picturesAreBaked()
{
    BakeSession session;
    const DocumentState before = session.document()->state();
    session.bake([&](const DialogUser &user) {
        user.type("high", session.high);
        user.typeCage(u"2"_s);
        user.toggle(9); // height
        return user.bake();
    });
    QVERIFY(session.jobsRest());
    QCOMPARE(session.failed.count(), 0);
    QCOMPARE(session.done.count(), 1);
    QVERIFY(session.done.last().first().toString().contains(u"3 pictures"_s));
    // The model shows them in light; the map is as it was.
    const TextureSet shown = session.document()->state().textureSet(-1);
    QCOMPARE(shown.size(), std::size_t(2));
    QCOMPARE(shown.at(TextureChannel::Normal).picture.file, session.file("low_normal.png"));
    QCOMPARE(shown.at(TextureChannel::Occlusion).picture.file, session.file("low_ao.png"));
    QVERIFY(session.context.view.options().pattern == Pattern::Physical);
    session.press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(session.document()->state() == before);
    for (const char *name : {"low_normal.png", "low_ao.png", "low_height.png"}) {
        const Result<Picture> picture = readPicture(session.file(name));
        QVERIFY2(picture.ok(), name);
        QCOMPARE(picture->width, 64);
    }
    const Result<Picture> height = readPicture(session.file("low_height.png"));
    QVERIFY(std::abs(height->at(12, 51)[0] - (0.5 + 0.5 * 0.01 / (0.02 * std::sqrt(12.0)))) < 0.01);
}

void TestBakeDialog::everyChoiceIsKept()
{
    BakeSession session;
    jobs::BakeChoice first;
    session.bake([&](const DialogUser &user) {
        user.type("high", session.high);
        user.toggle(0);
        user.toggle(4);
        for (const char *name : {"samples", "direction", "format"})
            QTest::keyClick(user.find<QComboBox>(name), Qt::Key_Down);
        [&] { QCOMPARE(user.find<QSpinBox>("width")->value(), 64); }(); // of the texture
        user.find<QSpinBox>("width")->setValue(32);
        user.find<QSpinBox>("rays")->setValue(5);
        user.find<QSpinBox>("dilation")->setValue(3);
        user.find<QDoubleSpinBox>("cage")->setValue(7);
        user.find<QDoubleSpinBox>("reach")->setValue(40);
        user.find<QDoubleSpinBox>("curvature")->setValue(3);
        user.find<QDoubleSpinBox>("thickness")->setValue(50);
        QTest::keyClick(user.find<QComboBox>("colors"), Qt::Key_End);
        user.type("cageFile", session.low);
        QTest::mouseClick(user.find<QCheckBox>("putOn"), Qt::LeftButton, {}, {8, 8});
        QTest::mouseClick(user.find<QCheckBox>("byName"), Qt::LeftButton, {}, {8, 8});
        QTest::mouseClick(user.find<QCheckBox>("greenDown"), Qt::LeftButton, {}, {8, 8});
        first = user.choice();
        return user.bake();
    });
    QVERIFY(session.jobsRest());
    QCOMPARE(first.maps, (QStringList{u"ao"_s, u"curvature"_s}));
    QCOMPARE(first.samplesPerSide, 3);
    QCOMPARE(first.reach, 0.4);
    QCOMPARE(first.curvatureRadius, 0.03);
    QCOMPARE(first.thicknessLimit, 0.5);
    QCOMPARE(first.cageFile, session.low);
    QVERIFY(first.colors == ColorSource::Materials && !first.putOn);
    QVERIFY(session.document()->state().textureSets.empty());
    QCOMPARE(first.rays, 5);
    QCOMPARE(first.dilation, 3);
    QVERIFY(first.ownCage);
    QCOMPARE(first.cage, 0.07);
    QVERIFY(first.byName && first.greenDown);
    QVERIFY(first.direction == bake::CageDirection::Shading);
    QCOMPARE(first.bits, 16);
    session.bake([&](const DialogUser &user) {
        const jobs::BakeChoice second = static_cast<BakeDialog &>(user.dialog).choice();
        [&] { QVERIFY(second == first); }();
        QTest::keyClick(&user.dialog, Qt::Key_Escape);
        return user.dialog.result();
    });
    QCOMPARE(QImage(session.file("low_curvature.png")).size(), QSize(32, 32));
    QVERIFY(!QFile::exists(session.file("low_normal.png")));
    // Also through the session, in another run of the program.
    const QString saved = session.file("kept.acproj");
    session.context.files.save(saved);
    QVERIFY(session.jobsRest());
    BakeSession later;
    later.context.files.open(saved);
    QVERIFY(later.jobsRest());
    later.bake([&](const DialogUser &user) {
        const jobs::BakeChoice third = static_cast<BakeDialog &>(user.dialog).choice();
        [&] { QVERIFY(third == first); }();
        QTest::keyClick(&user.dialog, Qt::Key_Escape);
        return user.dialog.result();
    });
}

//! From the distance of both models, on another thread, as soon as there is a detailed one.
void TestBakeDialog::theCageIsProposed()
{
    BakeSession session;
    session.bake([&](const DialogUser &user) {
        auto *propose = user.find<QPushButton>("propose");
        auto *cage = user.find<QDoubleSpinBox>("cage");
        auto *note = user.find<QLabel>("cageNote");
        [&] {
            QVERIFY(!propose->isEnabled() && note->text().contains(u"Occlusion has no cage"_s));
            user.toggle(2);
            QVERIFY(note->isHidden());
            user.toggle(2);
            QVERIFY(!note->isHidden());
            user.type("high", session.high);
            QVERIFY(!propose->isEnabled() && note->text().contains(u"Measuring"_s));
            QTRY_VERIFY_WITH_TIMEOUT(propose->isEnabled(), 60000);
            // The corners are .01 * sqrt(3) apart, and half as much is added.
            QCOMPARE(cage->value(), 0.75);
            QVERIFY(note->text().contains(u"Proposed"_s) && note->isVisible());
            QVERIFY(!user.choice().ownCage);
            // What is typed stays, until a proposal is asked for.
            user.typeCage(u"7"_s);
            QVERIFY(note->isHidden());
            user.type("high", session.low);
            user.type("high", session.high);
            QVERIFY(user.choice().ownCage && propose->isEnabled());
            QCOMPARE(user.choice().cage, 0.07);
            QTest::mouseClick(propose, Qt::LeftButton);
            QTRY_VERIFY_WITH_TIMEOUT(propose->isEnabled(), 60000);
            QCOMPARE(cage->value(), 0.75);
            session.write(session.high, {test::box(2, Vec3(30, 30, 30)), UvMatrix(0, 2)});
            QTest::mouseClick(propose, Qt::LeftButton);
            QTRY_VERIFY_WITH_TIMEOUT(propose->isEnabled(), 60000);
            QVERIFY(note->text().contains(u"nowhere near"_s));
            QVERIFY(user.find<QPushButton>("bake")->isEnabled());
        }();
        return 0;
    });
}

//! A bake that begins before the distance is there measures it itself. The height has the cage for its range.
void TestBakeDialog::theProposalIsBaked()
{
    BakeSession session;
    session.bake([&](const DialogUser &user) {
        user.type("high", session.high);
        user.toggle(9); // height
        return user.bake();
    });
    QVERIFY(session.jobsRest());
    QCOMPARE(session.failed.count(), 0);
    const Result<Picture> height = readPicture(session.file("low_height.png"));
    const double expected = 0.5 + 0.5 * 0.01 / (0.0075 * std::sqrt(12.0));
    QVERIFY(std::abs(height->at(12, 51)[0] - expected) < 0.01);
    // Out of all reach: said, and baked as without a proposal.
    session.write(session.high, {test::box(9, Vec3(30, 30, 30)), UvMatrix(0, 2)});
    session.bake([&](const DialogUser &user) { return user.bake(); });
    QVERIFY(session.jobsRest());
    QVERIFY(session.failed.last().first().toString().contains(u"nowhere near"_s));
}

void TestBakeDialog::cagesComeFromFiles()
{
    BakeSession session;
    const QString cage = session.file("cage.obj");
    session.write(cage, {test::box(4, Vec3(2.1, 2.1, 2.1)), UvMatrix(0, 2)});
    for (const bool fits : {true, false}) {
        if (!fits)
            session.write(cage, {test::box(2, Vec3(2.1, 2.1, 2.1)), UvMatrix(0, 2)});
        session.bake([&](const DialogUser &user) {
            user.type("high", session.high);
            user.find<QDoubleSpinBox>("cage")->setValue(0.01); // reaches nothing
            user.type("cageFile", cage);
            [&] { QVERIFY(!user.find<QDoubleSpinBox>("cage")->isEnabled()); }();
            return user.bake();
        });
        QVERIFY(session.jobsRest());
        QCOMPARE(session.failed.count(), fits ? 0 : 1);
    }
    QVERIFY(session.failed.last().first().toString().contains(u"other faces"_s));
}

void TestBakeDialog::problemsAreSaid()
{
    BakeSession session;
    session.bake([&](const DialogUser &user) {
        auto *bake = user.find<QPushButton>("bake");
        [&] {
            QVERIFY(bake->isEnabled());
            QVERIFY(!user.find<QDoubleSpinBox>("cage")->isEnabled()); // there is nothing to look for
            user.type("high", u"/nowhere/x.obj"_s);
            QVERIFY(!bake->isEnabled() && user.problem().contains(u"no such"_s));
            user.type("high", session.high);
            QVERIFY(bake->isEnabled() && user.find<QDoubleSpinBox>("cage")->isEnabled());
            user.toggle(0);
            user.toggle(2);
            QVERIFY(!bake->isEnabled() && user.problem().contains(u"at least one"_s));
            user.toggle(2);
            user.type("folder", u"/nowhere"_s);
            QVERIFY(!bake->isEnabled() && user.problem().contains(u"folder"_s));
            session.answers->filesToOpen = {session.folder.path()};
            QTest::mouseClick(user.find<QPushButton>("browseFolder"), Qt::LeftButton);
            QVERIFY(bake->isEnabled());
        }();
        return 0;
    });
    BakeSession bare;
    bare.context.files.open(bare.high);
    QVERIFY(bare.jobsRest());
    bare.bake([&](const DialogUser &user) {
        [&] { QVERIFY(user.problem().contains(u"no UVs"_s)); }();
        return 0;
    });
}

void TestBakeDialog::cancelEndsIt()
{
    BakeSession session;
    session.setTexture(4096);
    session.bake([&](const DialogUser &user) {
        user.find<QSpinBox>("rays")->setValue(65536);
        return user.bake();
    });
    QTRY_VERIFY(session.context.map.jobs().progress() > 0);
    session.press(Qt::Key_Escape);
    QVERIFY(session.jobsRest());
    QTRY_COMPARE(session.failed.count(), 1);
    QVERIFY(session.failed.last().first().toString().contains(u"nothing was baked"_s));
    QVERIFY(!QFile::exists(session.file("low_ao.png")));
}

void TestBakeDialog::faultsAreSaid()
{
    BakeSession session;
    QFile broken(session.high);
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("f 1 2 3\n");
    broken.close();
    session.bake([&](const DialogUser &user) {
        user.type("high", session.high);
        return user.bake();
    });
    QVERIFY(session.jobsRest());
    QCOMPARE(session.failed.count(), 1);
    QVERIFY(session.failed.last().first().toString().contains(u"high.obj"_s));
    session.write(session.high, {test::box(2, Vec3(3, 3, 3)), UvMatrix(0, 2)}); // out of reach
    session.bake([&](const DialogUser &user) { return user.bake(); });
    QVERIFY(session.jobsRest());
    QVERIFY(session.failed.last().first().toString().contains(u"larger cage"_s));
}

//! The detailed model is a session without its painted densities, which no bake needs: still it is said.
void TestBakeDialog::whatADamagedSessionLostIsSaid()
{
    BakeSession session;
    const QString hurt = session.file("hurt.acproj");
    QVERIFY(test::writeDamaged(session.document()->state().scene, hurt, "texelWeights"));
    session.bake([&](const DialogUser &user) {
        user.type("high", hurt);
        return user.bake();
    });
    QVERIFY(session.jobsRest());
    QVERIFY(QFile::exists(session.file("low_normal.png")));
    QCOMPARE(session.failed.count(), 1);
    const QString said = session.failed.last().first().toString();
    QVERIFY2(said.contains(u"Baked"_s) && said.contains(u"hurt.acproj: the painted texel density: damaged"_s),
             qPrintable(said));
}

void TestBakeDialog::everyMapHasATitle()
{
    BakeSession session;
    session.bake([&](const DialogUser &user) {
        [&] { QCOMPARE(user.find<QListWidget>("maps")->count(), jobs::bakeMapNames().size()); }();
        jobs::BakeChoice all = static_cast<BakeDialog &>(user.dialog).choice();
        for (int i = 0; i < jobs::bakeMapNames().size(); ++i) {
            if (!all.maps.contains(jobs::bakeMapNames()[i]))
                user.toggle(i);
        }
        all = static_cast<BakeDialog &>(user.dialog).choice();
        [&] { QCOMPARE(all.maps, jobs::bakeMapNames()); }();
        return 0;
    });
}

void TestBakeDialog::liveBakesFollowTheMap()
{
    BakeSession session;
    LiveBake &live = session.context.liveBake;
    const QImage modelBefore = session.window.meshView().grab().toImage();
    session.bake([&](const DialogUser &user) {
        user.type("high", session.high);
        user.toggle(0);
        user.toggle(2);
        user.toggle(1); // normals of the model's space
        QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
        return user.dialog.result();
    });
    QVERIFY(live.isOn());
    QCOMPARE(live.map(), u"object-normal"_s);
    QVERIFY(session.context.view.options().pattern == Pattern::Baked);
    QTRY_VERIFY_WITH_TIMEOUT(!live.isRefining() && live.updates() >= 3, 60000);
    QVERIFY(!QFile::exists(session.file("low_object-normal.png")));
    QVERIFY(session.window.meshView().grab().toImage() != modelBefore);
    const QImage first = live.pictures().images.front();
    QCOMPARE(first.width(), LiveBake::size);
    // The islands take another place.
    const int updates = live.updates();
    session.context.map.pack(PackScope::All);
    QVERIFY(session.jobsRest());
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > updates, 30000);
    QTRY_VERIFY_WITH_TIMEOUT(live.pictures().images.front() != first, 30000);
    const QImage packed = live.pictures().images.front();
    session.press(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(live.pictures().images.front() == first, 30000);
    session.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(live.pictures().images.front() == packed, 30000);
    // It goes on while a solve runs.
    const int before = live.updates();
    session.press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > before + 2, 60000);
    session.press(Qt::Key_Space);
    QVERIFY(session.jobsRest());
    QVERIFY(live.isOn());
}

//! In the light of the surroundings, which turns; as colours in the UV view. Other maps are shown as they
//! are.
void TestBakeDialog::liveNormalsAreLit()
{
    BakeSession session;
    LiveBake &live = session.context.liveBake;
    session.bake([&](const DialogUser &user) {
        user.type("high", session.high);
        QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
        return user.dialog.result();
    });
    const auto rests = [&] { return !live.isRefining() && live.updates() > 0; };
    QTRY_VERIFY_WITH_TIMEOUT(rests() && session.context.pictures.light().environment(), 60000);
    QVERIFY(live.isLit());
    const auto middle = [](QWidget &view) {
        const QImage image = view.grab().toImage();
        return QColor(image.pixel(image.width() / 2, image.height() / 2));
    };
    const auto turnLight = [&](double degrees) {
        ViewOptions options = session.context.view.options();
        options.lightTurn = degrees;
        session.context.view.setOptions(options);
    };
    MeshView &model = session.window.meshView();
    QTRY_VERIFY(middle(model).hsvSaturationF() < 0.2); // not the blue of normals
    const QColor before = middle(model);
    turnLight(150);
    QTRY_VERIFY(std::abs(middle(model).lightnessF() - before.lightnessF()) > 0.01);
    const QImage map = session.window.uvView().grab().toImage();
    int blue = 0;
    for (int y = 0; y < map.height(); y += 4) {
        for (int x = 0; x < map.width(); x += 4)
            blue += qBlue(map.pixel(x, y)) > qRed(map.pixel(x, y)) + 60;
    }
    QVERIFY2(blue > 500, qPrintable(QString::number(blue)));
    live.choose(u"height"_s);
    QTRY_VERIFY_WITH_TIMEOUT(rests(), 60000);
    QVERIFY(!live.isLit());
}

//! The pictures that the user chose for the model stay on its faces while its map changes.
void TestBakeDialog::liveColorsGoAlong()
{
    BakeSession session;
    Picture red(4, 4, 3, 0);
    for (std::size_t i = 0; i < red.values.size(); i += 3)
        red.values[i] = 1;
    QVERIFY(writePicture(red, session.file("red.png"), PictureDepth::Eight).ok());
    TextureSet set;
    set[TextureChannel::BaseColor].picture.file = session.file("red.png");
    pushCommand(EditTextures::ofMaterial(*session.document(), -1, set));
    session.bake([&](const DialogUser &user) {
        user.toggle(0);
        user.toggle(2);
        user.toggle(7);
        QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
        return user.dialog.result();
    });
    LiveBake &live = session.context.liveBake;
    QCOMPARE(live.map(), u"color"_s);
    const auto isRed = [&] {
        const QImage image = live.pictures().images.front();
        int reds = 0, others = 0;
        for (int y = 0; y < image.height(); y += 8) {
            for (int x = 0; x < image.width(); x += 8) {
                const QRgb color = image.pixel(x, y);
                reds += color == qRgb(255, 0, 0);
                others += qRed(color) > 0 && color != qRgb(255, 0, 0);
            }
        }
        return reds > 1000 && others == 0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(!live.isRefining() && live.updates() >= 3, 60000);
    QTRY_VERIFY(isRed());
    const int updates = live.updates();
    session.context.map.pack(PackScope::All);
    QVERIFY(session.jobsRest());
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > updates && isRed(), 30000);
}

void TestBakeDialog::liveBakesEnd()
{
    BakeSession session;
    LiveBake &live = session.context.liveBake;
    const auto begin = [&] {
        session.bake([&](const DialogUser &user) {
            QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
            return user.dialog.result();
        });
        QVERIFY(live.isOn());
    };
    begin();
    session.action("view.pattern.checker")->trigger();
    QVERIFY(!live.isOn() && live.pictures().images.empty());
    begin();
    session.context.files.open(session.high);
    QVERIFY(session.jobsRest());
    QVERIFY(!live.isOn());
    // A model without UVs: what is there is shown when there is a map.
    begin();
    session.context.map.unwrap(unwrap::UnwrapQuality::Draft);
    QVERIFY(session.jobsRest());
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > 0 && !live.isRefining(), 60000);
    // What cannot be read.
    session.bake([&](const DialogUser &user) {
        QFile(session.low).resize(3);
        user.type("high", session.low);
        QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
        return user.dialog.result();
    });
    QTRY_VERIFY(!live.isOn());
    QVERIFY(session.failed.last().first().toString().contains(u"low.obj"_s));
}

void TestBakeDialog::liveBakesFillAllTiles()
{
    BakeSession session(true);
    LiveBake &live = session.context.liveBake;
    session.bake([&](const DialogUser &user) {
        QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
        return user.dialog.result();
    });
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > 0, 60000);
    QCOMPARE(live.pictures().sets.size(), std::size_t(1));
    const std::map<int, int> expected{{0, 0}, {1, 3}}; // three layers each
    QCOMPARE(live.pictures().sets.front().tiles, expected);
    for (const std::size_t normals : {1U, 4U}) {
        const QImage &picture = live.pictures().images[normals];
        QCOMPARE(picture.width(), LiveBake::size);
        QVERIFY(qRed(picture.pixel(820, 820)) > 0 || qRed(picture.pixel(820, 512)) > 0 ||
                qRed(picture.pixel(204, 820)) > 0);
    }
    QCOMPARE(LiveBake::sizeFor(16), LiveBake::size);
    QCOMPARE(LiveBake::sizeFor(17), LiveBake::size / 2);
}

//! Where rays meet nothing of the detailed model there is no occlusion, but black.
void TestBakeDialog::whatALiveBakeMissesIsSaid()
{
    BakeSession session;
    const auto show = [&](const QString &cage) {
        session.failed.clear();
        session.bake([&](const DialogUser &user) {
            user.type("high", session.high);
            if (user.find<QListWidget>("maps")->item(0)->checkState() == Qt::Checked)
                user.toggle(0); // only occlusion
            user.typeCage(cage);
            QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
            return user.dialog.result();
        });
        const LiveBake &live = session.context.liveBake;
        QVERIFY(live.map() == u"ao"_s);
        QTRY_VERIFY_WITH_TIMEOUT(live.updates() > 1 && !live.isRefining(), 120000);
    };
    show(u"2"_s);
    QCOMPARE(session.failed.count(), 0);
    show(u"0.01"_s);
    QCOMPARE(session.failed.count(), 1); // once, not for each pass
    const QString said = session.failed.first().first().toString();
    QVERIFY2(said.contains(u"100.0 % of the surface"_s) && said.contains(u"larger cage"_s), qPrintable(said));
}

void TestBakeDialog::anotherMapIsShownLive()
{
    BakeSession session;
    LiveBake &live = session.context.liveBake;
    session.bake([&](const DialogUser &user) {
        user.type("high", session.high);
        QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
        return user.dialog.result();
    });
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > 0, 60000);
    auto *maps = session.window.findChild<QComboBox *>(u"bakedMap"_s);
    QTRY_COMPARE(maps->currentData().toString(), u"normal"_s);
    QCOMPARE(maps->count(), jobs::bakeMapNames().size());
    const QImage normals = live.pictures().images.front();
    // By the keys to the height, without reading the detailed model again.
    QVERIFY(QFile::remove(session.high));
    maps->setFocus();
    QTest::keyClick(maps, Qt::Key_End);
    QCOMPARE(live.map(), u"height"_s);
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > 0 && !live.isRefining(), 60000);
    QVERIFY(live.isOn());
    const QRgb height = live.pictures().images.front().pixel(200, 820);
    QVERIFY(live.pictures().images.front() != normals);
    QCOMPARE(qRed(height), qBlue(height));
}

QTEST_MAIN(TestBakeDialog)
#include "tst_bakedialog.moc"
