// Pictures of the chapters Select, Straight where the model is straight, and Lay out islands.
#include "guide/chapterpictures.h"
#include "model/document/document.h"
#include "support/canvases.h"
#include "views/panels/unwrapform.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QDialog>
#include <QDockWidget>
#include <QTableView>

namespace autocuts::guide {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The model from behind, after a box was drawn over it from the front.
QImage boxSelected(GuideWindow &guide)
{
    guide.studio().action("select.none")->trigger();
    guide.studio().action("view.from.front")->trigger();
    guide.frame();
    guide.settle();
    const QPoint middle = guide.model().rect().center(), corner(70, 90);
    guide.artist().drag("", guide.model(), {middle - corner, middle + corner});
    guide.studio().action("view.from.back")->trigger();
    guide.settle();
    return guide.model().picture();
}

//! A loop of edges of the character: around its chest or around a leg.
enum Loop { Chest = 17, Leg = 34 };
void selectLoop(GuideWindow &guide, Loop loop)
{
    guide.artist().use("select.edges");
    guide.artist().doubleClick("", guide.model(), guide.artist().edgesOn(guide.model(), 40)[loop]);
}

void pickIsland(GuideWindow &guide, int place, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
{
    guide.artist().click("", guide.map(), guide.artist().placesOn(guide.map(), 40)[place], modifiers);
}

} // namespace

void selecting(GuideWindow &guide)
{
    test::Artist &artist = guide.artist();
    guide.unwrapped("file.sample.character");
    selectLoop(guide, Chest);
    guide.save(guide.both(), u"loop"_s);

    artist.use("select.faces");
    guide.studio().action("view.coloring.plain")->trigger();
    const QImage surface = boxSelected(guide);
    guide.studio().action("view.xray")->trigger();
    guide.save(GuideWindow::beside(surface, boxSelected(guide)), u"xray"_s);
    guide.studio().action("view.xray")->trigger();

    guide.openNew();
    guide.unwrapped("file.sample.machine");
    guide.artist().use("select.edges");
    guide.ask("select.sharp", [](QDialog &dialog) { dialog.accept(); });
    guide.save(guide.both(), u"sharp"_s);
    guide.studio().action("select.none")->trigger();
    guide.artist().use("select.faces");
    guide.dock("scene")->raise();
    guide.settle();
    auto *rows = guide.dock("scene")->findChild<QTableView *>(u"scene"_s);
    QTest::mouseClick(rows->viewport(), Qt::LeftButton, {},
                      rows->visualRect(rows->model()->index(1, 1)).center());
    guide.part(u"scene"_s, {guide.dock("scene"), &guide.model()});
    guide.pair(u"hide"_s, guide.model(), [&] { guide.studio().action("view.hide")->trigger(); });
}

void straightening(GuideWindow &guide)
{
    guide.unwrapped("file.sample.machine");
    auto *form = guide.studio().window.findChild<UnwrapForm *>();
    guide.pair(u"straight"_s, guide.map(), [&] {
        form->findChild<QCheckBox *>(u"align"_s)->click();
        guide.unwrap();
    });

    guide.openNew();
    guide.sample("file.sample.character");
    form = guide.studio().window.findChild<UnwrapForm *>();
    GuideWindow::choose(*form, "worldUp", 0);
    guide.unwrap();
    guide.pair(u"upright"_s, guide.map(), [&] {
        GuideWindow::choose(*form, "worldUp", 1);
        guide.unwrap();
    });

    guide.openNew();
    guide.unwrapped("file.sample.character");
    form = guide.studio().window.findChild<UnwrapForm *>();
    selectLoop(guide, Leg);
    guide.studio().action("uv.keepStraight")->trigger();
    const Selection loop = guide.document().selection();
    const auto show = [&] {
        guide.document().setSelection(loop);
        guide.studio().action("view.frameSelected")->trigger();
        guide.studio().action("select.none")->trigger();
        guide.lookAway();
    };
    show();
    guide.pair(u"keepstraight"_s, guide.map(), [&] {
        form->findChild<QAbstractButton *>(u"high"_s)->click();
        guide.unwrap();
        show();
    });

    guide.openNew();
    guide.unwrapped("file.sample.bumpycube");
    guide.artist().use("select.islands");
    guide.studio().action("select.all")->trigger();
    guide.pair(u"align"_s, guide.map(), [&] { guide.artist().runJob("uv.alignAxes"); });
}

void layingOut(GuideWindow &guide)
{
    test::Artist &artist = guide.artist();
    guide.unwrapped("file.sample.machine");
    artist.use("select.islands");
    const QPoint place = artist.pixelOf({.7, .3}); // on a large island
    artist.click("", guide.map(), place);
    guide.dock("layout")->raise();
    guide.part(u"layout"_s, {guide.dock("layout"), &guide.map()});
    artist.use("tool.rotate");
    artist.hover("", guide.map(), {place + QPoint(80, 0), place + QPoint(80, 40), place + QPoint(70, 80)});
    guide.save(guide.both(), u"rotate"_s);
    guide.studio().press(Qt::Key_Escape);
    artist.use("tool.select");

    guide.pair(u"marks"_s, guide.map(), [&] {
        guide.studio().action("uv.lock")->trigger();
        pickIsland(guide, 5);
        pickIsland(guide, 12, Qt::ShiftModifier);
        pickIsland(guide, 30, Qt::ShiftModifier);
        guide.studio().action("uv.group")->trigger();
        guide.studio().action("select.none")->trigger();
        guide.studio().action("view.islandNumbers")->trigger();
        guide.lookAway();
    });

    guide.openNew();
    guide.unwrapped("file.sample.machine");
    guide.artist().runJob("uv.packObjects");
    guide.studio().action("view.maximizeUv")->trigger();
    guide.dock("packing")->raise();
    guide.lookAway();
    guide.settle();
    guide.frame();
    guide.part(u"tiles"_s, {guide.dock("packing"), &guide.map()});
}

} // namespace autocuts::guide
