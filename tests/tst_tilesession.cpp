// Several UDIM tiles in the window: packing by density, filling tiles, their figures, pictures and report.
#include "commands/setislandflags.h"
#include "model/plain/udimtiles.h"
#include "support/cliruns.h"
#include "support/pieces.h"
#include "support/studiosession.h"
#include "views/canvas/uvview.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/dialogs/densitydialog.h"
#include "views/dialogs/exportlayoutdialog.h"
#include "views/dialogs/pathfield.h"
#include "views/panels/noticebar.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QTreeWidget>

namespace tst_tilesession {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! A window with four parts, each of 2.5 x 2 units.
struct Desk : test::StudioSession
{
    Desk()
    {
        context.workspace.open(test::partsDocument({{}, {{0.3, 0}, 1}, {{0.7, 0.1}, 2}, {{0.1, 0.5}}}), {});
        QCoreApplication::processEvents();
    }

    QList<int> tiles()
    {
        const std::vector<int> used = usedTiles(udimTiles(document()->mesh(), document()->uv(), 1));
        return {used.begin(), used.end()};
    }
    UvMatrix uvOf(int part) const
    {
        return context.workspace.document()->uv().middleRows(part * test::partCorners, test::partCorners);
    }
    void selectPart(int part)
    {
        Selection selection;
        selection.mode = SelectionMode::Faces;
        for (int face = 0; face < test::partFaces; ++face)
            selection.faces << part * test::partFaces + face;
        document()->setSelection(selection);
        QCoreApplication::processEvents();
    }
    //! Types a density into the dialog, and presses the key.
    void answerDensity(const QString &density, Qt::Key key = Qt::Key_Return)
    {
        answers->onDialog = [this, density, key](QDialog &dialog) {
            dialog.show();
            auto *box = dialog.findChild<QDoubleSpinBox *>(u"density"_s);
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, density);
            remark = dialog.findChild<QLabel *>(u"texture"_s)->text();
            QTest::keyClick(&dialog, key);
            return dialog.result();
        };
    }
    bool packAt(const QString &density)
    {
        answerDensity(density);
        action("uv.packDensity")->trigger();
        return QTest::qWaitFor([this] { return !context.solver.isPausing(); }, test::patience) && jobsRest();
    }

    QString remark;
};

} // namespace

class TestTileSession : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void densityTakesTiles()
    {
        Desk desk;
        QVERIFY(desk.packAt(u"700"_s));
        QVERIFY2(desk.remark.contains(u"1.6"_s), qPrintable(desk.remark)); // 14 * (700 / 2048)^2 tiles
        const QList<int> tiles = desk.tiles();
        QVERIFY(tiles.size() > 1 && tiles[0] == 1001 && tiles[1] == 1002);
        QCOMPARE(desk.document()->undoStack().count(), 1);
        QVERIFY(desk.measured());
        const auto *list = desk.window.findChild<QTreeWidget *>(u"tiles"_s);
        QTRY_COMPARE(list->topLevelItemCount(), int(tiles.size()));
        QCOMPARE(list->topLevelItem(1)->text(0), u"1002"_s);
        QCOMPARE(list->topLevelItem(1)->text(3), u"700"_s);
        desk.document()->undoStack().undo();
        QVERIFY(desk.measured());
        QTRY_COMPARE(list->topLevelItemCount(), 1);
        desk.document()->undoStack().redo();
        QCOMPARE(desk.tiles(), tiles);
        // Cancelled in the dialog, nothing happens.
        desk.answerDensity(u"300"_s, Qt::Key_Escape);
        desk.action("uv.packDensity")->trigger();
        QVERIFY(desk.jobsRest());
        QCOMPARE(desk.document()->undoStack().count(), 1);
        // Larger than a tile: all is packed, and a notice says it.
        QVERIFY(desk.packAt(u"3000"_s));
        QCOMPARE(desk.tiles().size(), 4);
        QVERIFY2(desk.window.findChild<NoticeBar *>()->message().contains(u"larger than a tile"_s),
                 qPrintable(desk.window.findChild<NoticeBar *>()->message()));
    }

    void locksStayAndSolvesPause()
    {
        Desk desk;
        pushCommand(std::make_unique<SetIslandFlags>(*desk.document(), SetIslandFlags::Edit::Lock,
                                                     std::vector<int>{1}));
        const UvMatrix locked = desk.uvOf(1);
        QVERIFY(desk.packAt(u"400"_s));
        QVERIFY(desk.uvOf(1) == locked);
        QVERIFY(desk.measured());
        QCOMPARE(desk.context.map.figures()->metrics.overlapPairs, 0);
        // A live solve is paused first.
        desk.press(Qt::Key_Space);
        QVERIFY(desk.runsTo(1));
        QVERIFY(desk.packAt(u"700"_s));
        QVERIFY(!desk.context.solver.isRunning());
        QVERIFY(desk.tiles().size() > 1);
        const UvMatrix before = desk.document()->uv();
        // Escape ends a job, and leaves the map.
        const int entries = desk.document()->undoStack().count();
        desk.context.map.packAtDensity(900);
        QTRY_VERIFY(desk.context.map.jobs().isBusy());
        desk.context.map.cancel();
        QVERIFY(desk.jobsRest());
        if (desk.document()->undoStack().count() > entries) // it had ended before
            desk.document()->undoStack().undo();
        QVERIFY(desk.document()->uv() == before);
    }

    void tilesAreFilled()
    {
        Desk desk;
        QVERIFY(!desk.action("uv.fillTiles")->isEnabled()); // nothing is selected
        QVERIFY(desk.packAt(u"400"_s));
        QCOMPARE(desk.tiles(), QList<int>{1001});
        const UvMatrix others = desk.document()->uv().topRows(3 * test::partCorners);
        desk.selectPart(3);
        QTRY_VERIFY(desk.action("uv.fillTiles")->isEnabled());
        QVERIFY(desk.packAt(u"100"_s)); // only that one
        QVERIFY(desk.document()->uv().topRows(3 * test::partCorners) == others);
        desk.action("uv.fillTiles")->trigger();
        QVERIFY(desk.jobsRest());
        QVERIFY(desk.document()->uv().topRows(3 * test::partCorners) == others);
        QVERIFY(desk.measured());
        const metrics::UvMetrics &figures = desk.context.map.figures()->metrics;
        QCOMPARE(figures.tiles.size(), std::size_t(1));
        QCOMPARE(figures.overlapPairs, 0);
        QVERIFY(std::abs(figures.texelDensitySpread - 1) < 1e-6); // at the density of the others
        desk.document()->undoStack().undo();
        QVERIFY(desk.document()->uv().topRows(3 * test::partCorners) == others);
    }

    void tilesHaveTheColourOfTheirMaterial()
    {
        // One part in each of 1001, 1002 and 1003; a fourth one, of another material, in 1003 as well.
        const auto placed = test::partsDocument({{{0.3, 0.3}}, {{1.3, 0.3}}, {{2.2, 0.3}}, {{2.6, 0.3}}});
        Scene scene = placed->state().scene;
        scene.materialNames = {u"red"_s, u"green"_s};
        scene.materialColors = {qRgb(255, 0, 0), qRgb(0, 255, 0)};
        scene.faceMaterial.clear();
        for (const int material : {0, 1, 0, 1})
            scene.faceMaterial.insert(scene.faceMaterial.end(), test::partFaces, material);
        test::StudioSession studio;
        studio.context.workspace.open(std::make_unique<Document>(std::move(scene)), {});
        QVERIFY(studio.measured());
        UvView &view = studio.window.uvView();
        // How much more red than green the empty corner of each tile is.
        const auto redness = [&] {
            const QImage picture = view.grab().toImage();
            QList<int> result;
            for (int tile = 0; tile < 3; ++tile) {
                const QPointF place = view.camera().toScreen(Vec2(tile + 0.9, 0.1));
                const QColor color = picture.pixelColor((place * picture.devicePixelRatio()).toPoint());
                result << color.red() - color.green();
            }
            return result;
        };
        QTRY_VERIFY2(redness()[0] > 30 && redness()[1] < -30 && std::abs(redness()[2]) < 10,
                     qPrintable(u"%1, %2, %3"_s.arg(redness()[0]).arg(redness()[1]).arg(redness()[2])));
    }

    void picturesAndReport()
    {
        Desk desk;
        QVERIFY(desk.packAt(u"700"_s));
        QVERIFY(desk.measured());
        const auto at = [&](const char *name) { return desk.folder.filePath(QLatin1String(name)); };
        desk.answers->onDialog = [&](QDialog &dialog) {
            auto &layout = dynamic_cast<ExportLayoutDialog &>(dialog);
            layout.findChild<PathField *>()->setPath(at("map.png"));
            layout.accept();
            return layout.result();
        };
        const auto exportPictures = [&] {
            desk.action("file.exportLayout")->trigger();
            return desk.jobsRest();
        };
        QVERIFY(exportPictures());
        QVERIFY(!QFile::exists(at("map.png")));
        QVERIFY(QImage(at("map.1001.png")) != QImage(at("map.1002.png")));
        QCOMPARE(desk.answers->confirmations, QStringList());
        QVERIFY(QFile::remove(at("map.1001.png")));
        desk.answers->confirms = false;
        QVERIFY(exportPictures()); // refused: 1002 is there
        QCOMPARE(desk.answers->confirmations.size(), 1);
        QVERIFY(!QFile::exists(at("map.1001.png")));
        desk.answers->confirms = true;
        QVERIFY(exportPictures());
        QVERIFY(QFile::exists(at("map.1001.png")));

        // The report is that of the command line.
        desk.answers->filesToSave << at("report.json");
        desk.action("file.exportReport")->trigger();
        QVERIFY(desk.jobsRest());
        desk.context.files.save(at("s.acproj"));
        QVERIFY(QTest::qWaitFor([&] { return !desk.context.files.isSaving(); }, test::patience));
        QJsonObject studio = QJsonDocument::fromJson(test::readBytes(at("report.json"))).object();
        const test::CliRun run = test::runInProcess({u"check"_s, at("s.acproj"), u"--json"_s});
        QJsonObject cli = QJsonDocument::fromJson(run.out.toUtf8()).object();
        QVERIFY(studio.size() > 40 && studio.value(u"tiles"_s).toArray().size() > 1);
        for (QJsonObject *report : {&studio, &cli})
            report->remove(u"input"_s); // model or session
        QCOMPARE(studio, cli);
    }
};

QTEST_MAIN(TestTileSession)

} // namespace tst_tilesession

#include "tst_tilesession.moc"
