// Files that the studio exports: pictures, reports and meshes; nothing that was read is overwritten.
#include "model/io/files/savefile.h"
#include "model/io/meshes/meshfile.h"
#include "support/filedesk.h"
#include "views/actions/fileactions.h"
#include "views/control/mapjobs/picturejobs.h"
#include "views/control/session/jobrunner.h"

#include <QFileInfo>
#include <QImage>

namespace tst_exports {

using namespace autocuts;
using Desk = test::FileDesk;

class TestExports : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void picturesAndMeshesAreWritten()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        desk.files.openSample(QStringLiteral("torus"));
        LayoutOptions options;
        options.size = 64;
        for (const char *name : {"a.png", "a.svg"}) {
            desk.files.exportLayout(
                layoutPictures(*desk.workspace.document(), folder.filePath(QLatin1String(name)), {}),
                options);
            QVERIFY(desk.rests());
        }
        QCOMPARE(QImage(folder.filePath(QStringLiteral("a.png"))).size(), QSize(64, 64));
        QVERIFY(QFileInfo(folder.filePath(QStringLiteral("a.svg"))).size() > 100);
        desk.files.exportMesh(folder.filePath(QStringLiteral("a.xyz")));
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), 1);
        QCOMPARE(desk.done.count(), 2);
    }

    //! Neither the model, nor what lies beside it, nor the session, by whatever name.
    void exportsOverwriteNothingThatWasRead()
    {
        QTemporaryDir folder;
        Desk desk(folder);
        const auto at = [&folder](const char *name) { return folder.filePath(QLatin1String(name)); };
        const QByteArray material = "newmtl m\nKd 1 0 0\n";
        QVERIFY(saveAtomically(at("m.mtl"), material).ok());
        const QByteArray model = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                 "usemtl m\nf 1/1 2/2 3/3\n";
        QVERIFY(saveAtomically(at("m.obj"), model).ok());
        desk.files.open(at("m.obj"));
        QVERIFY(desk.rests());
        desk.files.save(at("m.acproj"));
        QVERIFY(desk.rests());
        QFile session(at("m.acproj"));
        QVERIFY(session.open(QIODevice::ReadOnly));
        const QByteArray saved = session.readAll();
        for (const auto &[link, target] :
             {std::pair("to_model.svg", "m.obj"), std::pair("to_session.svg", "m.acproj"),
              std::pair("to_material.svg", "m.mtl"), std::pair("to_model.json", "m.obj"),
              std::pair("to_session.obj", "m.acproj"), std::pair("to_model.acproj", "m.obj"),
              std::pair("to_material.png", "m.mtl")})
            QVERIFY(QFile::link(at(target), at(link)));
        LayoutOptions options;
        options.size = 64;
        int refused = 0;
        for (const char *name : {"to_model.svg", "to_session.svg", "to_material.svg"}) {
            desk.files.exportLayout(layoutPictures(desk.document(), at(name), {}), options);
            QVERIFY(desk.rests());
            QCOMPARE(desk.failed.count(), ++refused);
        }
        desk.files.exportReport(at("to_model.json"));
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), ++refused);
        desk.files.exportBytes(at("to_material.png"), "a picture");
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), ++refused);
        desk.files.exportMesh(at("to_session.obj"));
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), ++refused);
        desk.files.save(at("to_model.acproj"));
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), ++refused);
        for (const auto &[name, content] :
             {std::pair("m.obj", model), std::pair("m.acproj", saved), std::pair("m.mtl", material)}) {
            QFile file(at(name));
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(file.readAll(), content);
        }
        // The model itself may be written again.
        desk.files.exportMesh(at("m.obj"));
        QVERIFY(desk.rests());
        QCOMPARE(desk.failed.count(), refused);
    }

    //! The picture that the detailed model has its colours from is no place for the bake.
    void bakesOverwriteNoTextureOfTheDetailedModel()
    {
        QTemporaryDir folder;
        const auto at = [&folder](const char *name) { return folder.filePath(QLatin1String(name)); };
        const QByteArray model = "mtllib high.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                 "usemtl m\nf 1/1 2/2 3/3\n";
        QVERIFY(saveAtomically(at("low.obj"), model.mid(model.indexOf("\nv ") + 1)).ok());
        QVERIFY(saveAtomically(at("high.obj"), model).ok());
        QVERIFY(saveAtomically(at("high.mtl"), "newmtl m\nmap_Kd low_color.png\n").ok());
        QImage picture(4, 4, QImage::Format_RGB32);
        picture.fill(Qt::red);
        QVERIFY(picture.save(at("low_color.png")));
        Result<Scene> low = readMesh(at("low.obj"));
        QVERIFY(low.ok());
        jobs::BakeChoice choice;
        choice.maps = {QStringLiteral("color")};
        choice.high = at("high.obj");
        choice.folder = folder.path();
        MapInput input;
        input.packing.textureSize = 16;
        JobControl control;
        const MapJobResult result = bakeJob(DocumentState::initial(low.value()), input, choice, control);
        QVERIFY2(result.problem.contains(QStringLiteral("low_color.png")), qPrintable(result.problem));
        QCOMPARE(QImage(at("low_color.png")).size(), QSize(4, 4));
    }
};

QTEST_GUILESS_MAIN(TestExports)

} // namespace tst_exports

#include "tst_exports.moc"
