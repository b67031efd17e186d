// Packing into boxes and rectangles with the mouse.
#include "commands/editrectangles.h"
#include "commands/setislandflags.h"
#include "support/canvases.h"
#include "support/pieces.h"

#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

namespace tst_packinto {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

class TestPackInto : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mStudio = std::make_unique<Canvases>();
        mStudio->open(test::partsDocument({{{0, 0}}, {{0.3, 0}, 1}, {{0.7, 0.1}, 2}, {{0.1, 0.5}}}));
        MapCamera camera;
        camera.setCentre(Vec2(1, 0.5));
        camera.setScale(200);
        mStudio->uv.setCamera(camera);
    }
    void cleanup() { mStudio.reset(); }

    void boxesAreDragged_data()
    {
        QTest::addColumn<QList<int>>("parts");
        QTest::newRow("selected") << QList<int>{0, 2};
        QTest::newRow("all") << QList<int>{};
    }

    void boxesAreDragged()
    {
        QFETCH(QList<int>, parts);
        select(parts);
        mStudio->tools.setTool(u"packBox"_s);
        const DocumentState before = document().state();
        const Eigen::AlignedBox2d box(Vec2(1, 0.25), Vec2(1.5, 0.75));
        Canvases::drag(mStudio->uv, {pixel(box.min()), pixel(box.max())});
        QVERIFY(mStudio->tools.tool()->isBusy() == false);
        QVERIFY(rests());
        for (int part = 0; part < 4; ++part) {
            const bool packed = parts.isEmpty() || parts.contains(part);
            QCOMPARE(box.contains(document().islands().box(part)), packed);
            const auto rows = [&](const UvMatrix &uv) {
                return uv.middleRows(part * test::partCorners, test::partCorners);
            };
            QCOMPARE(rows(document().uv()) == rows(before.scene.uvSets[0].uv), !packed);
        }
        QCOMPARE(document().undoStack().count(), 1);
        const DocumentState after = document().state();
        document().undoStack().undo();
        QVERIFY(document().state() == before);
        document().undoStack().redo();
        QVERIFY(document().state() == after);
    }

    void escapeAndClicksPackNothing()
    {
        mStudio->tools.setTool(u"packBox"_s);
        QTest::mouseClick(&mStudio->uv, Qt::LeftButton, {}, {100, 100});
        QTest::mousePress(&mStudio->uv, Qt::LeftButton, {}, {100, 100});
        Canvases::moveMouse(mStudio->uv, {200, 200}, Qt::LeftButton);
        QVERIFY(mStudio->tools.tool()->isBusy());
        QVERIFY(mStudio->tools.tool()->hint().contains(u"texels"_s));
        QTest::keyClick(&mStudio->uv, Qt::Key_Escape);
        QTest::mouseRelease(&mStudio->uv, Qt::LeftButton, {}, {200, 200});
        QVERIFY(!mStudio->map.jobs().isBusy());
        QVERIFY(rests());
        QCOMPARE(document().undoStack().count(), 0);
    }

    void rectanglesPackTheirIslands()
    {
        const LayoutRectangle rectangle{1,          u"hands"_s, 0xff4080ff, {1.1, 0.1},
                                        {1.6, 0.9}, false,      1,          {0, 1, 2, 9, 10, 11}};
        pushCommand(EditRectangles::add(document(), rectangle));
        mStudio->tools.setTool(u"rectangle"_s);
        QTest::mouseClick(&mStudio->uv, Qt::LeftButton, {}, pixel({1.35, 0.5}));
        auto *button = mStudio->uv.findChild<QToolButton *>(u"rectanglePack"_s);
        QVERIFY(button && button->isVisible());
        const UvMatrix before = document().uv();
        button->click();
        QVERIFY(rests());
        const Eigen::AlignedBox2d box(rectangle.lower, rectangle.upper);
        for (int part = 0; part < 4; ++part)
            QCOMPARE(box.contains(document().islands().box(part)), part == 0 || part == 3);
        document().undoStack().undo();
        QVERIFY(document().uv() == before);
    }

    void lockedIslandsAreObstacles()
    {
        pushCommand(
            std::make_unique<SetIslandFlags>(document(), SetIslandFlags::Edit::Lock, std::vector<int>{3}));
        QSignalSpy failed(&mStudio->map, &MapController::failed);
        const Eigen::AlignedBox2d place = document().islands().box(3);
        const Eigen::AlignedBox2d box(Vec2(0, 0.4), Vec2(0.6, 1));
        select({});
        mStudio->map.packInto(box, QList<int>{0, 1, 2, 9, 10, 11});
        QVERIFY(rests());
        QCOMPARE(failed.count(), 0);
        QVERIFY((document().islands().box(3).min() - place.min()).norm() == 0);
        QVERIFY(box.contains(document().islands().box(0)));
        QVERIFY(QTest::qWaitFor([&] { return mStudio->map.figuresAreFresh(); }, 60'000));
        QCOMPARE(mStudio->map.figures()->metrics.overlapPairs, 0);
        // Nothing to pack: said, and no entry.
        mStudio->map.packInto(box);
        QVERIFY(rests());
        QCOMPARE(failed.count(), 1);
        QCOMPARE(document().undoStack().count(), 2);
    }

private:
    Document &document() { return mStudio->document(); }
    QPoint pixel(const Vec2 &uv) { return mStudio->uv.camera().toScreen(uv).toPoint(); }
    bool rests()
    {
        return QTest::qWaitFor([this] { return !mStudio->map.jobs().isBusy(); }, 60'000);
    }
    void select(const QList<int> &parts)
    {
        Selection selection;
        for (int part : parts) {
            for (int face = 0; face < test::partFaces; ++face)
                selection.faces << test::partFaces * part + face;
        }
        document().setSelection(selection);
    }

    std::unique_ptr<Canvases> mStudio;
};

QTEST_MAIN(TestPackInto)

} // namespace tst_packinto

#include "tst_packinto.moc"
