// Where new files are proposed: one folder for all dialogs.
#include "support/editsupport.h"
#include "support/studiosession.h"
#include "views/actions/studioactions.h"
#include "views/control/session/proposedfolder.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/bakedialog.h"
#include "views/dialogs/carrydialog.h"
#include "views/dialogs/exportlayoutdialog.h"
#include "views/dialogs/exportmeshdialog.h"
#include "views/dialogs/lightbakedialog.h"

#include <QDir>
#include <QFileInfo>

namespace tst_proposedfolder {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::StudioSession;

namespace {

//! A studio with a sphere that has UVs.
struct FolderSession : StudioSession
{
    QString sessions = made(u"sessions"_s), models = made(u"models"_s), last = made(u"last"_s);

    FolderSession() { preferences.setLastFolder(last); }

    QString made(const QString &name) const
    {
        QDir(folder.path()).mkpath(name);
        return folder.filePath(name);
    }
    void open(const QString &model, const QString &session)
    {
        Scene scene = test::layoutDocument(test::sphere(8, 10))->state().scene;
        scene.path = model;
        context.workspace.open(std::make_unique<Document>(std::move(scene)), session);
        QVERIFY(measured());
    }
    //! What the dialog of an action says; the user cancels it.
    QString asked(const char *id, const std::function<QString(QDialog &)> &read)
    {
        QString text;
        answers->onDialog = [&](QDialog &dialog) {
            text = read(dialog);
            return int(QDialog::Rejected);
        };
        action(id)->trigger();
        answers->onDialog = nullptr;
        return text;
    }
    QString bake()
    {
        return asked("uv.bake",
                     [](QDialog &dialog) { return static_cast<BakeDialog &>(dialog).choice().folder; });
    }
    QString light()
    {
        return asked("uv.bakeLight",
                     [](QDialog &dialog) { return static_cast<LightBakeDialog &>(dialog).choice().path; });
    }
    //! What each of the dialogs proposes.
    QStringList proposed()
    {
        const auto folderOf = [](const QString &path) { return QFileInfo(path).path(); };
        return {
            folderOf(asked("file.exportMesh",
                           [](QDialog &dialog) { return static_cast<ExportMeshDialog &>(dialog).path(); })),
            folderOf(asked("file.exportLayout",
                           [](QDialog &dialog) { return static_cast<ExportLayoutDialog &>(dialog).path(); })),
            bake(), folderOf(light()), asked("uv.carryTextures", [](QDialog &dialog) {
                return static_cast<CarryDialog &>(dialog).choice().folder;
            })};
    }
};

} // namespace

class TestProposedFolder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allDialogsProposeTheSame_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<QString>("session");
        QTest::addColumn<QString>("folder");
        QTest::newRow("the model alone") << u"models/a.obj"_s << QString() << u"models"_s;
        QTest::newRow("a session elsewhere") << u"models/a.obj"_s << u"sessions/a.acproj"_s << u"sessions"_s;
        // Not the folder in which the program happens to run.
        QTest::newRow("a model without a folder") << u":a.obj"_s << u"sessions/a.acproj"_s << u"sessions"_s;
        QTest::newRow("a model that is gone") << u"gone/a.obj"_s << u"sessions/a.acproj"_s << u"sessions"_s;
        QTest::newRow("a session that is gone") << u"models/a.obj"_s << u"gone/a.acproj"_s << u"models"_s;
        QTest::newRow("both gone") << u"gone/a.obj"_s << u"gone/a.acproj"_s << u"last"_s;
        QTest::newRow("a sample") << u":a.obj"_s << QString() << u"last"_s;
    }
    void allDialogsProposeTheSame()
    {
        QFETCH(const QString, model);
        QFETCH(const QString, session);
        QFETCH(const QString, folder);
        FolderSession studio;
        studio.open(model.startsWith(u':') ? model.mid(1) : studio.folder.filePath(model),
                    session.isEmpty() ? QString() : studio.folder.filePath(session));
        const QString expected = studio.folder.filePath(folder);
        QCOMPARE(studio.proposed(), QStringList(5, expected));
        QCOMPARE(studio.answers->errors, QStringList());
    }

    //! Nothing was chosen: the next model has a folder of its own.
    void cancelledDialogsKeepNoFolder()
    {
        FolderSession studio;
        studio.open(studio.models + u"/a.obj"_s, {});
        QCOMPARE(studio.bake(), studio.models);
        studio.open(studio.sessions + u"/b.obj"_s, {});
        QCOMPARE(studio.bake(), studio.sessions);
    }

    //! What a session remembers counts while it is there.
    void rememberedFoldersMayBeGone()
    {
        FolderSession studio;
        BakeActions &bakes = studio.window.actions().bake();
        studio.open(studio.models + u"/a.obj"_s, {});
        jobs::BakeChoice bake;
        jobs::LightChoice light = LightBakeDialog::firstChoice(*studio.document(), studio.last);
        const auto remember = [&](const QString &folder) {
            bake.folder = folder;
            light.path = folder + u"/own.exr"_s;
            bakes.setChoice(bake);
            bakes.setLight(light);
        };
        remember(studio.last);
        QCOMPARE(studio.bake(), studio.last);
        QCOMPARE(studio.light(), studio.last + u"/own.exr"_s);
        for (const QString &folder : {studio.folder.filePath(u"gone"_s), u"."_s}) {
            remember(folder);
            QCOMPARE(studio.bake(), studio.models);
            QCOMPARE(studio.light(), studio.models + u"/own.exr"_s);
        }
    }

    //! The model of a session that was moved is looked for beside the session.
    void aModelThatIsGoneIsLookedForBesideTheSession()
    {
        FolderSession studio;
        studio.open(studio.models + u"/a.obj"_s, studio.sessions + u"/a.acproj"_s);
        studio.action("file.relink")->trigger();
        studio.open(u"a.obj"_s, studio.sessions + u"/a.acproj"_s);
        studio.action("file.relink")->trigger();
        QCOMPARE(studio.answers->begins, (QStringList{studio.models, studio.sessions}));
    }
};

QTEST_MAIN(TestProposedFolder)

} // namespace tst_proposedfolder

#include "tst_proposedfolder.moc"
