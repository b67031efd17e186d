// Baking in the studio: the dialog by mouse and keys, the job, its files, Cancel, and a solve that runs.
#include "jobs/bakechoice.h"
#include "jobs/lightchoice.h"
#include "model/pictures/picturefiles.h"
#include "support/bakesession.h"
#include "support/damagedsessions.h"
#include "support/mappedmodels.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/pictures/modelpictures.h"
#include "views/dialogs/bakedialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>

#include <cmath>

namespace tst_bakedialog {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::BakeSession;
using test::DialogUser;

class TestBakeDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void picturesAreBaked();
    void everyChoiceIsKept();
    void valuesThatDoNotExistAreNotTaken_data();
    void valuesThatDoNotExistAreNotTaken();
    void theCageIsProposed();
    void theProposalIsBaked();
    void cagesComeFromFiles();
    void problemsAreSaid();
    void cancelEndsIt();
    void foreignPicturesAreAskedAbout();
    void faultsAreSaid();
    void whatADamagedSessionLostIsSaid();
    void everyMapHasATitle();
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
void TestBakeDialog::valuesThatDoNotExistAreNotTaken_data()
{
    QTest::addColumn<QCborValue>("stored");
    QTest::newRow("above") << QCborValue(4);
    QTest::newRow("far above") << QCborValue(qint64(1) << 32);
    QTest::newRow("below") << QCborValue(-1);
    QTest::newRow("no whole number") << QCborValue(1.5);
    QTest::newRow("no number") << QCborValue(std::nan(""));
    QTest::newRow("text") << QCborValue(u"1"_s);
    QTest::newRow("nothing") << QCborValue();
}

//! A session may come from a newer version, or be damaged.
void TestBakeDialog::valuesThatDoNotExistAreNotTaken()
{
    QFETCH(QCborValue, stored);
    QCborMap map = jobs::BakeChoice().toCbor();
    map["direction"_L1] = stored;
    map["colors"_L1] = stored;
    QVERIFY(jobs::BakeChoice::fromCbor(map) == jobs::BakeChoice());
    QCborMap light = jobs::LightChoice().toCbor();
    light["values"_L1] = stored;
    QVERIFY(jobs::LightChoice::fromCbor(light) == jobs::LightChoice());
    // The last of each is taken.
    map["direction"_L1] = static_cast<int>(bake::CageDirection::Corrected);
    map["colors"_L1] = static_cast<int>(ColorSource::Materials);
    const jobs::BakeChoice last = jobs::BakeChoice::fromCbor(map);
    QVERIFY(last.direction == bake::CageDirection::Corrected && last.colors == ColorSource::Materials);
    light["values"_L1] = static_cast<int>(bake::LightValue::Lit);
    QVERIFY(jobs::LightChoice::fromCbor(light).values == bake::LightValue::Lit);
}

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
    QVERIFY(session.context.view.options().pattern != Pattern::Physical);
}

//! Once per file: what a bake has written is replaced by the next one.
void TestBakeDialog::foreignPicturesAreAskedAbout()
{
    BakeSession session;
    QFile foreign(session.file("low_ao.png"));
    QVERIFY(foreign.open(QIODevice::WriteOnly));
    foreign.write("foreign");
    foreign.close();
    const auto bake = [&](bool confirms) {
        session.answers->confirms = confirms;
        session.bake([&](const DialogUser &user) { return user.bake(); });
        QVERIFY(session.jobsRest());
    };
    bake(false);
    QCOMPARE(session.answers->confirmations.size(), 1);
    QCOMPARE(QFileInfo(foreign).size(), 7);
    for (int i = 0; i < 2; ++i)
        bake(true);
    QCOMPARE(session.answers->confirmations.size(), 2);
    QVERIFY(!QImage(foreign.fileName()).isNull());
    QCOMPARE(session.document()->undoStack().undoText(), u"Bake"_s);
    // Unless another program has changed it since.
    QVERIFY(foreign.open(QIODevice::Append));
    QVERIFY(foreign.setFileTime(QDateTime::currentDateTime().addSecs(60), QFileDevice::FileModificationTime));
    foreign.close();
    bake(true);
    QCOMPARE(session.answers->confirmations.size(), 3);
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

QTEST_MAIN(TestBakeDialog)

} // namespace tst_bakedialog

#include "tst_bakedialog.moc"
