// What would keep the window from answering is not done in one go: paints, tables, pictures.
#include "commands/setuvs.h"
#include "support/canvases.h"
#include "support/editsupport.h"
#include "support/panelongrid.h"
#include "views/canvas/mapoverlays.h"
#include "views/panels/packpanel.h"

#include <QHeaderView>
#include <QPainter>
#include <QPicture>
#include <QResizeEvent>
#include <QStyledItemDelegate>
#include <QTest>
#include <QTreeWidget>

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::Canvases;

namespace {

//! Counts how often views are painted.
class CountingTool final : public AbstractTool
{
public:
    CountingTool(const StudioContext &context, int &count)
        : AbstractTool(context, u"counting"_s), mCount(count)
    {}
    QString hint() const override { return {}; }
    void press(const ToolEvent &) override {}
    void move(const ToolEvent &) override {}
    void release(const ToolEvent &) override {}
    void drawOverlay(QPainter &, const ToolCanvas &) override { ++mCount; }

private:
    int &mCount;
};

//! Counts the rows that are measured.
class CountingDelegate final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        ++mCount;
        return QStyledItemDelegate::sizeHint(option, index);
    }
    int count() const { return mCount; }

private:
    mutable int mCount = 0;
};

//! One face in each tile.
std::unique_ptr<Document> manyTiles(int side)
{
    const test::MeshPtr mesh = test::grid(side);
    Scene scene = test::sceneOf(mesh);
    UvMatrix uv = test::splitLayout(*mesh);
    for (int face = 0; face < mesh->faceCount(); ++face) {
        const Vec2 tile(face % 10, face / 10);
        const double corners[4][2] = {{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}};
        for (int k = 0; k < 4; ++k)
            uv.row(mesh->faceStart[face] + k) << tile.x() + corners[k][0], tile.y() + corners[k][1];
    }
    scene.uvSets.push_back({u"tiles"_s, uv});
    return std::make_unique<Document>(std::move(scene));
}

} // namespace

class TestShortTurns : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! The window paints after all of its views have their sizes.
    void aNewSizeIsPaintedOnce()
    {
        Canvases studio;
        studio.open(test::layoutDocument(test::grid(4)));
        int paints = 0;
        studio.tools.add(std::make_unique<CountingTool>(studio.context, paints));
        studio.tools.setTool(u"counting"_s);
        for (Canvas *canvas : {static_cast<Canvas *>(&studio.mesh), static_cast<Canvas *>(&studio.uv)}) {
            QTRY_VERIFY(paints > 0);
            QCoreApplication::processEvents();
            paints = 0;
            QResizeEvent event(canvas->size(), canvas->size() + QSize(10, 10));
            QCoreApplication::sendEvent(canvas, &event);
            QCOMPARE(paints, 0);
            QTRY_VERIFY(paints > 0);
            QVERIFY(!canvas->picture().isNull());
        }
    }

    //! The columns are wide enough for all rows, yet not all rows are measured.
    void manyTilesAreListed()
    {
        test::Bench<PackPanel> bench(false);
        auto *list = test::child<QTreeWidget>(bench.panel, "tiles");
        CountingDelegate delegate;
        list->setItemDelegate(&delegate);
        bench.workspace.open(manyTiles(40), {});
        QVERIFY(bench.measured());
        QVERIFY(bench.followed());
        QCOMPARE(list->topLevelItemCount(), 1600);
        QVERIFY(list->isVisible());
        QVERIFY(!list->grab().isNull());
        QVERIFY2(delegate.count() < 400, qPrintable(QString::number(delegate.count())));
        for (int column = 0; column < 3; ++column) {
            int widest = 0;
            for (int row = 0; row < list->topLevelItemCount(); row += 399)
                widest = std::max(
                    widest, list->fontMetrics().horizontalAdvance(list->topLevelItem(row)->text(column)));
            QVERIFY(list->columnWidth(column) > widest);
            QVERIFY(list->columnWidth(column) >= list->header()->sectionSizeHint(column));
        }
    }

    void tilesThatCannotBeSeenAreNotDrawn()
    {
        const ViewColors colors = ViewColors::of({}, true);
        MapCamera camera;
        const QRect view(0, 0, 200, 200);
        camera.setViewSize(view.size());
        camera.setCentre(Vec2(0.5, 0.5));
        using Tiles = std::vector<std::pair<int, QColor>>;
        const auto size = [&](double scale, const Tiles &tiles) {
            camera.setScale(scale);
            QPicture picture;
            QPainter painter(&picture);
            drawTilesInUse(painter, view, colors, camera, 1, tiles);
            painter.end();
            return picture.size();
        };
        const Tiles near{{1001, {}}, {1002, {}}};
        Tiles all = near;
        for (int tile = 1100; tile < 3000; ++tile)
            all.emplace_back(tile, QColor());
        QVERIFY(size(100, near) > size(100, {}));
        QCOMPARE(size(100, all), size(100, near));
        QCOMPARE(size(4, near), size(4, {}));                          // too small for a line
        QVERIFY(size(4, {{1001, QColor(Qt::red)}}) > size(4, {}));     // its tint can be seen
        QCOMPARE(size(100, {{1950, QColor(Qt::red)}}), size(100, {})); // outside
    }
};

QTEST_MAIN(TestShortTurns)
#include "tst_shortturns.moc"
