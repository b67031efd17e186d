// Transferring UVs in the studio: the dialog by mouse and keys, the job, its undo entry, locks and live
// solves.
#include "commands/setuvs.h"
#include "model/io/meshes/meshfile.h"
#include "model/plain/uvlayout.h"
#include "support/damagedsessions.h"
#include "support/mappedmodels.h"
#include "support/studiosession.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/transferdialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>

namespace tst_transferdialog {

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
    void type(const QString &path) const
    {
        auto *edit = find<QLineEdit>("path");
        QTest::mouseClick(edit, Qt::LeftButton);
        edit->selectAll();
        QTest::keyClicks(edit, path);
    }
    //! Chooses an entry by its first letters.
    void choose(const char *name, const QString &entry) const
    {
        auto *box = find<QComboBox>(name);
        box->setFocus();
        QTest::keyClicks(box, entry);
        [&] { QVERIFY2(box->currentText().startsWith(entry), qPrintable(box->currentText())); }();
    }
    bool canTransfer() const { return find<QPushButton>("transfer")->isEnabled(); }
    int transfer() const
    {
        QTest::mouseClick(find<QPushButton>("transfer"), Qt::LeftButton);
        return dialog.result();
    }
};

//! A studio, and models to take UVs from.
struct TransferSession : StudioSession
{
    QString coarse = folder.filePath(u"coarse.obj"_s), mapped = folder.filePath(u"mapped.obj"_s),
            bare = folder.filePath(u"bare.obj"_s);
    UvMatrix expected;
    QSignalSpy done{&context.map, &MapController::done}, failed{&context.map, &MapController::failed};

    TransferSession()
    {
        const MappedModel model = test::mapped(test::box(6), test::boxMap());
        const test::MeshPtr other = test::box(9, Vec3(2, 2, 2), true);
        expected = test::mapped(other, test::boxMap()).uv;
        write(mapped, model);
        write(coarse, {other, UvMatrix(0, 2)});
        write(bare, {test::box(3), UvMatrix(0, 2)});
        context.files.open(coarse);
        jobsRest();
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
    //! Opens the dialog and lets the user act in it.
    void transfer(const std::function<int(const DialogUser &)> &user)
    {
        answers->onDialog = [&](QDialog &dialog) {
            dialog.open();
            [[maybe_unused]] const bool seen = QTest::qWaitForWindowExposed(&dialog);
            QApplication::setActiveWindow(&dialog);
            return user({dialog});
        };
        action("uv.transfer")->trigger();
        answers->onDialog = nullptr;
        QApplication::setActiveWindow(&window);
    }
    void transferFrom(const QString &path)
    {
        transfer([&](const DialogUser &user) {
            user.type(path);
            return user.transfer();
        });
        jobsRest();
    }
    bool hasExpectedMap()
    {
        const UvMatrix &uv = document()->uv();
        return uv.rows() == expected.rows() && uv.allFinite() && (uv - expected).cwiseAbs().maxCoeff() < 1e-6;
    }
};

} // namespace

class TestTransferDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aFileGivesItsMap();
    void enterTransfers();
    void theDialogSaysWhatIsMissing();
    void anotherUvSet();
    void anObjectGivesToTheOthers();
    void onlyTheSelectedFaces();
    void whatCannotBeDoneIsSaid();
    void whatADamagedSessionLostIsSaid_data();
    void whatADamagedSessionLostIsSaid();
    void lockedIslandsStay();
    void aLiveSolveIsPaused();
    void aJobIsCancelled();
    void theMenuAndThePaletteHaveIt();
};

void TestTransferDialog::enterTransfers()
{
    TransferSession studio;
    studio.transfer([&](const DialogUser &user) {
        user.type(studio.mapped);
        QTest::keyClick(user.find<QLineEdit>("path"), Qt::Key_Return);
        return user.dialog.result();
    });
    QVERIFY(studio.jobsRest());
    QVERIFY(studio.hasExpectedMap());
}

void TestTransferDialog::aFileGivesItsMap()
{
    TransferSession studio;
    QVERIFY(!studio.document()->uv().allFinite());
    studio.transferFrom(studio.mapped);
    QVERIFY(studio.hasExpectedMap());
    QCOMPARE(studio.failed.count(), 0);
    QCOMPARE(studio.done.count(), 1);
    QVERIFY2(studio.done[0][0].toString().contains(u"faces matched by position"_s),
             qPrintable(studio.done[0][0].toString()));
    UndoStack &stack = studio.document()->undoStack();
    QCOMPARE(stack.index(), 1);
    QCOMPARE(stack.undoText(), u"Transfer UVs"_s);
    studio.press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!studio.document()->uv().allFinite());
    studio.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(studio.hasExpectedMap());
    // The dialog remembers the file; Enter takes it again, and nothing changes.
    studio.transfer([&](const DialogUser &user) {
        [&] { QVERIFY(user.find<QLineEdit>("path")->text().endsWith(u"mapped.obj"_s)); }();
        QTest::keyClick(user.find<QLineEdit>("path"), Qt::Key_Return);
        return user.dialog.result();
    });
    QVERIFY(studio.jobsRest());
    QCOMPARE(stack.index(), 1);
}

void TestTransferDialog::theDialogSaysWhatIsMissing()
{
    TransferSession studio;
    studio.answers->filesToOpen << studio.mapped;
    studio.transfer([&](const DialogUser &user) {
        const auto check = [&] {
            QCOMPARE(user.find<QComboBox>("from")->count(), 1); // no other set, one object
            QVERIFY(!user.canTransfer() && !user.find<QLabel>("problem")->text().isEmpty());
            user.type(u"/nowhere/no.obj"_s);
            QVERIFY(!user.canTransfer());
            QVERIFY(!user.find<QCheckBox>("onlySelection")->isEnabled());
            for (QPushButton *button : user.dialog.findChildren<QPushButton *>()) {
                if (button->text().contains(u"rowse"_s))
                    QTest::mouseClick(button, Qt::LeftButton);
            }
            QVERIFY(user.canTransfer());
        };
        check();
        QTest::keyClick(&user.dialog, Qt::Key_Escape);
        return user.dialog.result();
    });
    QVERIFY(studio.jobsRest());
    QVERIFY(!studio.document()->undoStack().canUndo());
}

void TestTransferDialog::anotherUvSet()
{
    TransferSession studio;
    studio.transferFrom(studio.mapped);
    studio.action("uvset.add")->trigger();
    QVERIFY(!studio.document()->uv().allFinite());
    studio.transfer([](const DialogUser &user) {
        user.choose("from", u"Another"_s);
        [&] { QVERIFY(!user.find<QLineEdit>("path")->isVisible()); }();
        return user.transfer();
    });
    QVERIFY(studio.jobsRest());
    QCOMPARE(studio.document()->activeUvSet(), 1);
    QVERIFY(sameBits(studio.document()->uv(), studio.document()->uvSets()[0].uv));
}

void TestTransferDialog::anObjectGivesToTheOthers()
{
    TransferSession studio;
    studio.action("file.sample.machine")->trigger();
    QVERIFY(studio.jobsRest());
    const MeshData &mesh = studio.document()->mesh();
    // The first object gets a map: a corner's place is its x and y.
    UvMatrix uv = emptyLayout(mesh);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1] && mesh.faceObject[f] == 0; ++c)
            uv.row(c) = mesh.cornerPosition(c).head<2>().transpose();
    }
    pushCommand(std::make_unique<SetUvs>(*studio.document(), UvEdit::Move, uv));
    studio.transfer([](const DialogUser &user) {
        user.choose("from", u"An"_s);
        user.choose("match", u"Only"_s);
        return user.transfer();
    });
    QVERIFY(studio.jobsRest());
    // Its parts are different: that is said, and nothing changes.
    QCOMPARE(studio.failed.count(), 1);
    QVERIFY2(studio.failed[0][0].toString().contains(u"polygons are not the same"_s),
             qPrintable(studio.failed[0][0].toString()));
    QVERIFY(sameBits(studio.document()->uv(), uv));
}

void TestTransferDialog::onlyTheSelectedFaces()
{
    TransferSession studio;
    Selection selection;
    selection.mode = SelectionMode::Faces;
    selection.faces = {0, 1, 2, 3};
    studio.document()->setSelection(selection);
    studio.transfer([&](const DialogUser &user) {
        user.type(studio.mapped);
        QTest::mouseClick(user.find<QCheckBox>("onlySelection"), Qt::LeftButton, {}, QPoint(8, 8));
        return user.transfer();
    });
    QVERIFY(studio.jobsRest());
    const UvMatrix &uv = studio.document()->uv();
    // All of the source is far larger than the four faces; they are matched all the same.
    QVERIFY(uv.topRows(12).allFinite());
    QVERIFY(!uv.bottomRows(uv.rows() - 12).array().isFinite().any());
}

void TestTransferDialog::whatADamagedSessionLostIsSaid_data()
{
    QTest::addColumn<QByteArray>("part");
    QTest::addColumn<bool>("gives");
    QTest::addColumn<QString>("said");
    QTest::newRow("densities") << QByteArray("texelWeights") << true
                               << u"hurt.acproj: the painted texel density: damaged"_s;
    QTest::newRow("the map") << QByteArray("uv.0") << false << u"hurt.acproj: the UV sets: damaged"_s;
}

void TestTransferDialog::whatADamagedSessionLostIsSaid()
{
    QFETCH(const QByteArray, part);
    QFETCH(const bool, gives);
    QFETCH(const QString, said);
    TransferSession studio;
    const Result<Scene> mapped = readMesh(studio.mapped);
    QVERIFY(mapped.ok());
    const QString hurt = studio.folder.filePath(u"hurt.acproj"_s);
    QVERIFY(test::writeDamaged(mapped.value(), hurt, part.constData()));
    studio.transferFrom(hurt);
    QCOMPARE(studio.hasExpectedMap(), gives);
    QCOMPARE(studio.failed.count(), 1);
    QVERIFY2(studio.failed[0][0].toString().contains(said), qPrintable(studio.failed[0][0].toString()));
}

void TestTransferDialog::whatCannotBeDoneIsSaid()
{
    TransferSession studio;
    studio.transferFrom(studio.bare);
    QCOMPARE(studio.failed.count(), 1);
    QVERIFY(studio.failed[0][0].toString().contains(u"no UVs to transfer"_s));
    QVERIFY(!studio.document()->undoStack().canUndo());
    const QString broken = studio.folder.filePath(u"broken.obj"_s);
    QFile file(broken);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("v 0 0 nan\nf 1 2 3\n") > 0);
    file.close();
    studio.transferFrom(broken);
    QCOMPARE(studio.failed.count(), 2);
    QVERIFY(!studio.document()->undoStack().canUndo());
}

void TestTransferDialog::lockedIslandsStay()
{
    TransferSession studio;
    studio.press(Qt::Key_U);
    QVERIFY(studio.jobsRest());
    const UvMatrix before = studio.document()->uv();
    QVERIFY(before.allFinite());
    QList<int> faces;
    for (int f = 0; f < studio.document()->mesh().faceCount(); ++f) {
        if (studio.document()->islands().islandOfFace(f) == 0)
            faces << f;
    }
    Selection selection;
    selection.mode = SelectionMode::Faces;
    selection.faces = faces;
    studio.document()->setSelection(selection);
    studio.action("uv.lock")->trigger();
    studio.transferFrom(studio.mapped);
    const MeshData &mesh = studio.document()->mesh();
    bool changed = false;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const bool same = sameBits(before.middleRows(3 * f, 3), studio.document()->uv().middleRows(3 * f, 3));
        QVERIFY(same || !faces.contains(f));
        changed = changed || !same;
    }
    QVERIFY(changed || faces.size() == mesh.faceCount());
}

void TestTransferDialog::aLiveSolveIsPaused()
{
    TransferSession studio;
    studio.action("uv.run")->trigger();
    QVERIFY(QTest::qWaitFor([&] { return studio.context.solver.isRunning(); }));
    QVERIFY(studio.runsTo(3));
    studio.transferFrom(studio.mapped);
    QVERIFY(QTest::qWaitFor([&] { return studio.hasExpectedMap(); }));
    QVERIFY(!studio.context.solver.isRunning());
    QCOMPARE(studio.document()->undoStack().undoText(), u"Transfer UVs"_s);
    studio.press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!studio.hasExpectedMap());
    QCOMPARE(studio.document()->validate(), QString());
}

void TestTransferDialog::aJobIsCancelled()
{
    TransferSession studio;
    const UvMatrix before = studio.document()->uv();
    studio.transfer([&](const DialogUser &user) {
        user.type(studio.mapped);
        return user.transfer();
    });
    studio.press(Qt::Key_Escape);
    studio.context.map.cancel();
    QVERIFY(studio.jobsRest());
    QVERIFY(QTest::qWaitFor([&] { return studio.failed.count() + studio.done.count() > 0; }));
    QVERIFY(studio.hasExpectedMap() || sameBits(before, studio.document()->uv()));
    QCOMPARE(studio.document()->undoStack().index(), studio.hasExpectedMap() ? 1 : 0);
}

void TestTransferDialog::theMenuAndThePaletteHaveIt()
{
    TransferSession studio;
    auto *menu = studio.window.findChild<QMenu *>(u"UV"_s);
    QVERIFY(menu && menu->actions().contains(studio.action("uv.transfer")));
    QVERIFY(studio.action("uv.transfer")->isEnabled());
    studio.context.files.close();
    QVERIFY(!studio.action("uv.transfer")->isEnabled());
}

QTEST_MAIN(TestTransferDialog)

} // namespace tst_transferdialog

#include "tst_transferdialog.moc"
