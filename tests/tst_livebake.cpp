// Bakes that follow the map while it changes: what is shown, what is refined, what ends them.
#include "commands/edittextures.h"
#include "jobs/bakechoice.h"
#include "model/pictures/picturefiles.h"
#include "support/bakesession.h"
#include "support/mappedmodels.h"
#include "support/patience.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/pictures/livebake.h"
#include "views/control/pictures/modelpictures.h"

#include <QComboBox>
#include <QListWidget>
#include <QPushButton>

namespace tst_livebake {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::BakeSession;
using test::DialogUser;

class TestLiveBake : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void liveBakesFollowTheMap();
    void liveNormalsAreLit();
    void liveColorsGoAlong();
    void liveBakesEnd();
    void liveBakesFillAllTiles();
    void whatALiveBakeMissesIsSaid();
    void anotherMapIsShownLive();
};

void TestLiveBake::liveBakesFollowTheMap()
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
    QTRY_VERIFY_WITH_TIMEOUT(!live.isRefining() && live.updates() >= 3, test::patience);
    QVERIFY(!QFile::exists(session.file("low_object-normal.png")));
    QVERIFY(session.window.meshView().grab().toImage() != modelBefore);
    const QImage first = live.pictures().images.front();
    QCOMPARE(first.width(), LiveBake::size);
    // The islands take another place.
    const int updates = live.updates();
    session.context.map.pack(PackScope::All);
    QVERIFY(session.jobsRest());
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > updates, test::patience);
    QTRY_VERIFY_WITH_TIMEOUT(live.pictures().images.front() != first, test::patience);
    const QImage packed = live.pictures().images.front();
    session.press(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(live.pictures().images.front() == first, test::patience);
    session.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(live.pictures().images.front() == packed, test::patience);
    // It goes on while a solve runs.
    const int before = live.updates();
    session.press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > before + 2, test::patience);
    session.press(Qt::Key_Space);
    QVERIFY(session.jobsRest());
    QVERIFY(live.isOn());
}

//! In the light of the surroundings, which turns; as colours in the UV view. Other maps are shown as they
//! are.
void TestLiveBake::liveNormalsAreLit()
{
    BakeSession session;
    LiveBake &live = session.context.liveBake;
    session.bake([&](const DialogUser &user) {
        user.type("high", session.high);
        QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
        return user.dialog.result();
    });
    const auto rests = [&] { return !live.isRefining() && live.updates() > 0; };
    QTRY_VERIFY_WITH_TIMEOUT(rests() && session.context.pictures.light().environment(), test::patience);
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
    QTRY_VERIFY_WITH_TIMEOUT(middle(model).hsvSaturationF() < 0.2, test::patience); // not the blue of normals
    const QColor before = middle(model);
    turnLight(150);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(middle(model).lightnessF() - before.lightnessF()) > 0.01,
                             test::patience);
    const QImage map = session.window.uvView().grab().toImage();
    int blue = 0;
    for (int y = 0; y < map.height(); y += 4) {
        for (int x = 0; x < map.width(); x += 4)
            blue += qBlue(map.pixel(x, y)) > qRed(map.pixel(x, y)) + 60;
    }
    QVERIFY2(blue > 500, qPrintable(QString::number(blue)));
    live.choose(u"height"_s);
    QTRY_VERIFY_WITH_TIMEOUT(rests(), test::patience);
    QVERIFY(!live.isLit());
}

//! The pictures that the user chose for the model stay on its faces while its map changes.
void TestLiveBake::liveColorsGoAlong()
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
    QTRY_VERIFY_WITH_TIMEOUT(!live.isRefining() && live.updates() >= 3, test::patience);
    QTRY_VERIFY_WITH_TIMEOUT(isRed(), test::patience);
    const int updates = live.updates();
    session.context.map.pack(PackScope::All);
    QVERIFY(session.jobsRest());
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > updates && isRed(), test::patience);
}

void TestLiveBake::liveBakesEnd()
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
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > 0 && !live.isRefining(), test::patience);
    // What cannot be read.
    session.bake([&](const DialogUser &user) {
        QFile(session.low).resize(3);
        user.type("high", session.low);
        QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
        return user.dialog.result();
    });
    QTRY_VERIFY_WITH_TIMEOUT(!live.isOn(), test::patience);
    QVERIFY(session.failed.last().first().toString().contains(u"low.obj"_s));
}

void TestLiveBake::liveBakesFillAllTiles()
{
    BakeSession session(true);
    LiveBake &live = session.context.liveBake;
    session.bake([&](const DialogUser &user) {
        QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
        return user.dialog.result();
    });
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > 0, test::patience);
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
void TestLiveBake::whatALiveBakeMissesIsSaid()
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
        QTRY_VERIFY_WITH_TIMEOUT(live.updates() > 1 && !live.isRefining(), test::patience);
    };
    show(u"2"_s);
    QCOMPARE(session.failed.count(), 0);
    show(u"0.01"_s);
    QCOMPARE(session.failed.count(), 1); // once, not for each pass
    const QString said = session.failed.first().first().toString();
    QVERIFY2(said.contains(u"100.0 % of the surface"_s) && said.contains(u"larger cage"_s), qPrintable(said));
}

void TestLiveBake::anotherMapIsShownLive()
{
    BakeSession session;
    LiveBake &live = session.context.liveBake;
    session.bake([&](const DialogUser &user) {
        user.type("high", session.high);
        QTest::mouseClick(user.find<QPushButton>("live"), Qt::LeftButton);
        return user.dialog.result();
    });
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > 0, test::patience);
    auto *maps = session.window.findChild<QComboBox *>(u"bakedMap"_s);
    QTRY_COMPARE_WITH_TIMEOUT(maps->currentData().toString(), u"normal"_s, test::patience);
    QCOMPARE(maps->count(), jobs::bakeMapNames().size());
    const QImage normals = live.pictures().images.front();
    // By the keys to the height, without reading the detailed model again.
    QVERIFY(QFile::remove(session.high));
    maps->setFocus();
    QTest::keyClick(maps, Qt::Key_End);
    QCOMPARE(live.map(), u"height"_s);
    QTRY_VERIFY_WITH_TIMEOUT(live.updates() > 0 && !live.isRefining(), test::patience);
    QVERIFY(live.isOn());
    const QRgb height = live.pictures().images.front().pixel(200, 820);
    QVERIFY(live.pictures().images.front() != normals);
    QCOMPARE(qRed(height), qBlue(height));
}

QTEST_MAIN(TestLiveBake)

} // namespace tst_livebake

#include "tst_livebake.moc"
