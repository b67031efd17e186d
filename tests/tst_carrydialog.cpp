// Carrying textures over in the studio: the dialog by mouse and keys, the files, undo, Cancel, sessions.
#include "commands/setuvs.h"
#include "model/io/meshes/meshfile.h"
#include "model/pictures/picturefiles.h"
#include "support/damagedsessions.h"
#include "support/mappedmodels.h"
#include "support/studiosession.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/pictures/modelpictures.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/carrydialog.h"
#include "views/state/viewstate.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTreeWidget>

namespace tst_carrydialog {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::StudioSession;
using Channel = TextureChannel;

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
        QTest::keyClick(edit, Qt::Key_Delete);
        QTest::keyClicks(edit, text);
    }
    void choose(const char *name, int row) const
    {
        auto *box = find<QComboBox>(name);
        QTest::keyClick(box, Qt::Key_Home);
        for (int i = 0; i < row; ++i)
            QTest::keyClick(box, Qt::Key_Down);
        QCOMPARE(box->currentIndex(), row);
    }
    QString problem() const { return find<QLabel>("problem")->text(); }
    bool canCarry() const { return find<QPushButton>("carry")->isEnabled(); }
    QTreeWidget *list() const { return find<QTreeWidget>("pictures"); }
    QString newFile(int row) const { return list()->topLevelItem(row)->text(3); }
    int carry() const
    {
        QTest::mouseClick(find<QPushButton>("carry"), Qt::LeftButton);
        return dialog.result();
    }
};

//! A studio with a textured box: the left half of the picture is red, the right one green.
struct CarrySession : StudioSession
{
    QSignalSpy done{&context.map, &MapController::done}, failed{&context.map, &MapController::failed};

    explicit CarrySession(int side = 64)
    {
        Picture halves(side, side, 3);
        for (int i = 0; i < side * side; ++i)
            halves.at(i % side, i / side)[i % side < side / 2 ? 0 : 1] = 1;
        QVERIFY(writePicture(halves, at("box_BaseColor.png"), PictureDepth::Eight).ok());
        QVERIFY(writePicture(halves, at("box_ORM.png"), PictureDepth::Eight).ok());
        write(at("box.obj"));
        QFile mtl(at("m.mtl"));
        QVERIFY(mtl.open(QIODevice::WriteOnly));
        mtl.write("newmtl skin\nmap_Kd box_BaseColor.png\nmap_Pr box_ORM.png\nmap_Pm box_ORM.png\n"
                  "map_Ke gone.png\n");
        mtl.close();
        context.files.open(at("box.obj"));
        jobsRest();
    }
    QString at(const char *name) const { return folder.filePath(QString::fromUtf8(name)); }
    static void write(const QString &path)
    {
        const test::MappedModel model = test::mapped(test::box(4), test::boxMap());
        Scene scene;
        scene.mesh = model.mesh;
        scene.objectNames = {u"box"_s};
        scene.materialNames = {u"skin"_s};
        scene.faceMaterial.assign(static_cast<std::size_t>(model.mesh->faceCount()), 0);
        scene.uvSets = {{u"UVMap"_s, model.uv}};
        QVERIFY(writeMesh(scene, path).ok());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray bytes = file.readAll();
        file.close();
        bytes = "mtllib m.mtl\n" + bytes;
        if (!bytes.contains("usemtl"))
            bytes.insert(bytes.indexOf("\nf ") + 1, "usemtl skin\n");
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    //! Another map: turned by a right angle about the middle of the tile.
    void turn()
    {
        UvMatrix uv = document()->uv();
        const Eigen::VectorXd u = uv.col(0);
        uv.col(0) = 1 - uv.col(1).array();
        uv.col(1) = u;
        pushCommand(std::make_unique<SetUvs>(*document(), UvEdit::Rotate, uv));
    }
    void carry(const std::function<int(const DialogUser &)> &user)
    {
        answers->onDialog = [&](QDialog &dialog) {
            dialog.open();
            [[maybe_unused]] const bool seen = QTest::qWaitForWindowExposed(&dialog);
            QApplication::setActiveWindow(&dialog);
            return user({dialog});
        };
        action("uv.carryTextures")->trigger();
        answers->onDialog = nullptr;
        QApplication::setActiveWindow(&window);
    }
    bool carriedBy(const std::function<int(const DialogUser &)> &user)
    {
        carry(user);
        return jobsRest();
    }
    QString file(Channel channel) { return document()->state().textureSet(0).at(channel).picture.file; }
    QString said() const { return failed.isEmpty() ? QString() : failed.last().first().toString(); }
};

bool isRed(const Picture &picture, int x, int y)
{
    return picture.at(x, y)[0] > 0.9F && picture.at(x, y)[1] < 0.1F;
}

} // namespace

class TestCarryDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void texturesFollowTheMap();
    void undoPutsTheOldPicturesBack();
    void otherSources();
    void formatsAndSizes();
    void problemsAreSaid();
    void whatADamagedSessionLostIsSaid();
    void filesAreReplacedOnlyWhenAsked();
    void cancelWritesNothing();
    void anEditedMapGetsNoTextures();
    void sessionsKeepThem();
    void aNewMapTellsOfIt();
};

void TestCarryDialog::texturesFollowTheMap()
{
    CarrySession session;
    session.turn();
    const int entries = session.document()->undoStack().index();
    QVERIFY(session.carriedBy([&](const DialogUser &user) {
        [&] {
            QCOMPARE(user.list()->topLevelItemCount(), 3);
            QCOMPARE(user.newFile(0), u"box_BaseColor_uv2.png"_s);
            QCOMPARE(user.newFile(1), u"box_ORM_uv2.png"_s);
            QVERIFY(user.list()->topLevelItem(1)->text(1).contains(u"Metalness"_s));
            QCOMPARE(user.list()->topLevelItem(2)->text(2), u"gone.png"_s);
            QVERIFY(user.problem().contains(u"gone.png"_s));
        }();
        return user.carry();
    }));
    QCOMPARE(session.document()->undoStack().index(), entries + 1);
    QCOMPARE(session.failed.count(), 1); // the missing picture
    QVERIFY2(session.said().contains(u"2 pictures"_s) && session.said().contains(u"gone.png"_s),
             qPrintable(session.said()));
    QCOMPARE(session.file(Channel::BaseColor), session.at("box_BaseColor_uv2.png"));
    QCOMPARE(session.file(Channel::Metalness), session.at("box_ORM_uv2.png"));
    QCOMPARE(session.file(Channel::Emission), u"gone.png"_s);
    const Result<Picture> before = readPicture(session.at("box_BaseColor.png")),
                          after = readPicture(session.at("box_BaseColor_uv2.png"));
    QVERIFY(before.ok() && after.ok());
    QCOMPARE(after->width, 64);
    for (const auto &[x, y] : {std::pair(10, 50), std::pair(12, 55), std::pair(50, 52)})
        QCOMPARE(isRed(after.value(), y, 63 - x), isRed(before.value(), x, y));
    // Again, for one more map: from the one that they are for now.
    session.turn();
    QVERIFY(session.carriedBy([](const DialogUser &user) {
        [&] { QCOMPARE(user.newFile(0), u"box_BaseColor_uv3.png"_s); }();
        return user.carry();
    }));
    const Result<Picture> again = readPicture(session.at("box_BaseColor_uv3.png"));
    QVERIFY(again.ok());
    for (const auto &[x, y] : {std::pair(10, 50), std::pair(12, 55), std::pair(50, 52)})
        QCOMPARE(isRed(again.value(), 63 - x, 63 - y), isRed(before.value(), x, y));
}

void TestCarryDialog::undoPutsTheOldPicturesBack()
{
    CarrySession session;
    const DocumentState opened = session.document()->state();
    session.turn();
    const DocumentState turned = session.document()->state();
    QVERIFY(session.carriedBy([](const DialogUser &user) { return user.carry(); }));
    const DocumentState carried = session.document()->state();
    QVERIFY(carried.textureSets != turned.textureSets);
    session.press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(session.document()->state() == turned);
    session.press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(session.document()->state() == opened);
    session.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    session.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(session.document()->state() == carried);
}

void TestCarryDialog::otherSources()
{
    CarrySession session;
    QVERIFY(session.carriedBy([](const DialogUser &user) { return user.carry(); }));
    QVERIFY2(session.said().contains(u"already"_s), qPrintable(session.said()));
    session.action("uvset.copy")->trigger();
    session.jobsRest();
    session.turn();
    // Another UV set, and the model's file.
    for (const int source : {1, 2}) {
        session.failed.clear();
        QVERIFY(session.carriedBy([&](const DialogUser &user) {
            user.choose("from", source);
            [&] {
                QCOMPARE(user.find<QComboBox>("uvSet")->isVisible(), source == 1);
                QCOMPARE(user.find<QLineEdit>("file")->isVisible(), source == 2);
                if (source == 2)
                    QCOMPARE(user.find<QLineEdit>("file")->text(), session.at("box.obj"));
            }();
            return user.carry();
        }));
        QVERIFY2(session.said().contains(u"2 pictures"_s), qPrintable(session.said()));
        session.press(Qt::Key_Z, Qt::ControlModifier);
    }
    const Result<Picture> ofSet = readPicture(session.at("box_BaseColor_uv2.png")),
                          ofFile = readPicture(session.at("box_BaseColor_uv3.png"));
    QVERIFY(ofSet.ok() && ofFile.ok());
    QVERIFY(ofSet->values == ofFile->values);
}

void TestCarryDialog::whatADamagedSessionLostIsSaid()
{
    CarrySession session;
    const Scene before = session.document()->state().scene;
    session.turn();
    for (const auto &[part, pictures, said] :
         {std::tuple("texelWeights", u"2 pictures"_s, u"hurt.acproj: the painted texel density: damaged"_s),
          std::tuple("uv.0", u"no UV map"_s, u"hurt.acproj: the UV sets: damaged"_s)}) {
        QVERIFY(test::writeDamaged(before, session.at("hurt.acproj"), part));
        session.failed.clear();
        QVERIFY(session.carriedBy([&](const DialogUser &user) {
            user.choose("from", 1); // there is no other UV set
            user.type("file", session.at("hurt.acproj"));
            return user.carry();
        }));
        QVERIFY2(session.said().contains(pictures) && session.said().contains(said),
                 qPrintable(session.said()));
        session.press(Qt::Key_Z, Qt::ControlModifier);
    }
}

void TestCarryDialog::formatsAndSizes()
{
    CarrySession session;
    session.turn();
    jobs::CarryChoice first;
    QVERIFY(session.carriedBy([&](const DialogUser &user) {
        user.choose("size", 1);
        user.choose("format", 4);
        user.find<QSpinBox>("margin")->setValue(3);
        user.type("suffix", u"_new"_s);
        [&] { QCOMPARE(user.newFile(0), u"box_BaseColor_new.exr"_s); }();
        first = static_cast<CarryDialog &>(user.dialog).choice();
        return user.carry();
    }));
    const Result<Picture> made = readPicture(session.at("box_BaseColor_new.exr"));
    QVERIFY(made.ok());
    QCOMPARE(made->width, 256);
    QCOMPARE(first.margin, 3);
    session.carry([&](const DialogUser &user) {
        const jobs::CarryChoice second = static_cast<CarryDialog &>(user.dialog).choice();
        [&] {
            QCOMPARE(second.format, u"exr"_s);
            QCOMPARE(second.size, 256);
            QCOMPARE(second.margin, 3);
        }();
        QTest::keyClick(&user.dialog, Qt::Key_Escape);
        return user.dialog.result();
    });
}

void TestCarryDialog::problemsAreSaid()
{
    CarrySession session;
    session.turn();
    session.carry([&](const DialogUser &user) {
        [&] {
            QVERIFY(user.canCarry());
            user.type("suffix", u""_s);
            QVERIFY(!user.canCarry() && user.problem().contains(u"overwrite"_s));
            user.type("suffix", u"/x"_s);
            QVERIFY(!user.canCarry() && user.problem().contains(u"sign"_s));
            user.type("suffix", u"_x"_s);
            QVERIFY(user.canCarry());
            user.type("folder", u"/nowhere"_s);
            QVERIFY(!user.canCarry() && user.problem().contains(u"folder"_s));
            session.answers->filesToOpen = {session.folder.path()};
            QTest::mouseClick(user.find<QPushButton>("browseFolder"), Qt::LeftButton);
            QVERIFY(user.canCarry());
            user.choose("from", 1);
            user.type("file", u"/nowhere/x.obj"_s);
            QVERIFY(!user.canCarry() && user.problem().contains(u"no such file"_s));
            session.answers->filesToOpen = {session.at("box.obj")};
            QTest::mouseClick(user.find<QPushButton>("browseFile"), Qt::LeftButton);
            QVERIFY(user.canCarry());
        }();
        return 0;
    });
    for (const char *name : {"box_BaseColor.png", "box_ORM.png"})
        QVERIFY(QFile::remove(session.at(name)));
    session.carry([&](const DialogUser &user) {
        [&] { QVERIFY(!user.canCarry() && user.problem().contains(u"box_ORM.png"_s)); }();
        return 0;
    });
    QVERIFY(QFile(session.at("box_ORM.png")).open(QIODevice::WriteOnly)); // there, but no picture
    QVERIFY(session.carriedBy([](const DialogUser &user) { return user.carry(); }));
    QVERIFY2(session.said().contains(u"box_ORM.png"_s), qPrintable(session.said()));
    QVERIFY(session.document()->state().textureSets.empty());
}

void TestCarryDialog::filesAreReplacedOnlyWhenAsked()
{
    CarrySession session;
    session.turn();
    QFile old(session.at("box_ORM_uv2.png"));
    QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
    old.close();
    session.answers->confirms = false;
    session.carry([&](const DialogUser &user) {
        [&] { QCOMPARE(user.newFile(0), u"box_BaseColor_uv3.png"_s); }();
        user.type("suffix", u"_uv2"_s);
        [&] { QVERIFY(user.canCarry() && user.problem().contains(u"exist already"_s)); }();
        user.carry();
        [&] {
            QCOMPARE(session.answers->confirmations.size(), 1);
            QVERIFY(user.dialog.isVisible()); // asked in vain
        }();
        QTest::keyClick(&user.dialog, Qt::Key_Escape);
        return user.dialog.result();
    });
    QCOMPARE(QFileInfo(old.fileName()).size(), 3);
    session.answers->confirms = true;
    QVERIFY(session.carriedBy([&](const DialogUser &user) {
        user.type("suffix", u"_uv2"_s);
        return user.carry();
    }));
    QVERIFY(readPicture(old.fileName()).ok());
}

void TestCarryDialog::cancelWritesNothing()
{
    CarrySession session;
    session.turn();
    const DocumentState before = session.document()->state();
    const QStringList files = QDir(session.folder.path()).entryList(QDir::Files | QDir::Dirs | QDir::Hidden);
    session.carry([](const DialogUser &user) {
        user.choose("size", 6);
        return user.carry();
    });
    QTRY_VERIFY(session.context.map.jobs().progress() > 0);
    QElapsedTimer clock;
    clock.start();
    session.press(Qt::Key_Escape);
    QVERIFY(session.jobsRest());
    QTRY_COMPARE(session.failed.count(), 1);
    QVERIFY2(session.said().contains(u"no picture was written"_s), qPrintable(session.said()));
    QVERIFY(session.document()->state() == before);
    QTRY_COMPARE(QDir(session.folder.path()).entryList(QDir::Files | QDir::Dirs | QDir::Hidden), files);
}

void TestCarryDialog::anEditedMapGetsNoTextures()
{
    CarrySession session;
    session.turn();
    session.carry([](const DialogUser &user) {
        user.choose("size", 4);
        return user.carry();
    });
    session.turn();
    QVERIFY(session.jobsRest());
    QVERIFY2(session.said().contains(u"edited meanwhile"_s), qPrintable(session.said()));
    QVERIFY(session.document()->state().textureSets.empty());
}

void TestCarryDialog::sessionsKeepThem()
{
    CarrySession session;
    session.turn();
    QVERIFY(session.carriedBy([](const DialogUser &user) { return user.carry(); }));
    const auto sets = session.document()->state().textureSets;
    session.turn();
    const QString path = session.at("box.acproj");
    session.answers->filesToSave = {path};
    session.action("file.saveAs")->trigger();
    QTRY_VERIFY(QFile::exists(path));
    QVERIFY(session.jobsRest());
    session.context.files.open(path);
    QVERIFY(session.jobsRest());
    // With its history.
    QVERIFY(session.document()->undoStack().isClean());
    QCOMPARE(session.document()->undoStack().index(), 3);
    QVERIFY(session.document()->state().textureSets == sets);
    // The session still knows for which map they are.
    QVERIFY(session.carriedBy([](const DialogUser &user) { return user.carry(); }));
    const Result<Picture> before = readPicture(session.at("box_BaseColor.png")),
                          after = readPicture(session.at("box_BaseColor_uv3.png"));
    QVERIFY2(after.ok(), qPrintable(session.said()));
    for (const auto &[x, y] : {std::pair(10, 50), std::pair(12, 55), std::pair(50, 52)})
        QCOMPARE(isRed(after.value(), 63 - x, 63 - y), isRed(before.value(), x, y));
}

void TestCarryDialog::aNewMapTellsOfIt()
{
    CarrySession session;
    session.context.map.pack(PackScope::All);
    QVERIFY(session.jobsRest());
    QTRY_VERIFY(session.done.count() + session.failed.count() > 0);
    const QString said = session.done.isEmpty() ? session.said() : session.done.last().first().toString();
    QVERIFY2(said.contains(u"Carry textures over"_s), qPrintable(said));
}

QTEST_MAIN(TestCarryDialog)

} // namespace tst_carrydialog

#include "tst_carrydialog.moc"
