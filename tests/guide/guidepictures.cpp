// Takes the pictures of docs/guide from the real studio, worked with by events.
//
//   guide_pictures FOLDER [STEP]
//
// Each picture shows a view before and after: rows 24 to 39 of what the paper's artist does, and the window
// as a whole. scripts/guide runs it.
#include "guide/chapterpictures.h"
#include "model/io/meshes/meshfile.h"
#include "views/control/pictures/livebake.h"
#include "views/control/pictures/modelpictures.h"
#include "views/ui/language.h"
#include "views/ui/theme.h"

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QListWidget>
#include <QPushButton>
#include <QSurfaceFormat>

#include <cstdio>
#include <functional>

using namespace autocuts;
using namespace autocuts::guide;
using namespace Qt::Literals::StringLiterals;

namespace {

class Guide final : public GuideWindow
{
public:
    using GuideWindow::GuideWindow;

    //! \param only the number of a step from 1 on; 0: all of them
    //! \returns the first problem; empty: none
    QString take(int only)
    {
        const std::function<void(Guide &)> steps[] = {&Guide::unwrapping,
                                                      &Guide::runningLive,
                                                      &Guide::steeringBySeams,
                                                      &Guide::ripping,
                                                      &Guide::painting,
                                                      &Guide::dragging,
                                                      &Guide::boxing,
                                                      &Guide::overlaps,
                                                      &Guide::arranging,
                                                      &Guide::looking,
                                                      &Guide::texturing,
                                                      selecting,
                                                      straightening,
                                                      layingOut,
                                                      seeing,
                                                      handingOn,
                                                      lighting};
        int number = 0;
        for (const auto &step : steps) {
            if (++number != only && only != 0)
                continue;
            // No step depends on the one before.
            openNew();
            step(*this);
            if (!problem().isEmpty())
                break;
        }
        return problem();
    }

private:
    //! Row 24.
    void unwrapping()
    {
        window(u"start"_s);
        sample("file.sample.bumpycube");
        solve(3);
        window(u"solving"_s);
        pause();
        artist().runJob("uv.unwrap");
        frame();
        studio().action("view.pattern.checker")->trigger();
        window(u"unwrapped"_s);
    }

    //! A live solve after 1, 3 and 10 seconds, its ghost, a cut on the way, and a solve of the selection.
    void runningLive()
    {
        sample("file.sample.character");
        studio().action("view.coloring.islands")->trigger();
        studio().press(Qt::Key_Space);
        QImage course;
        for (const int wait : {1000, 2000, 7000}) {
            QTest::qWait(wait);
            frame();
            standStill();
            course = course.isNull() ? map().picture() : beside(course, map().picture());
        }
        save(course, u"live"_s);
        studio().action("uv.ghost")->trigger();
        QTest::qWait(4000);
        save(both(), u"ghost"_s);
        studio().action("uv.ghost")->trigger();
        artist().use("tool.cut");
        standStill();
        pair(u"livecut"_s, map(), [&] {
            artist().doubleClick("", model(), artist().edgesOn(model(), 40)[22]);
            QTest::qWait(1500);
            standStill();
        });
        pause();
        artist().use("select.faces");
        artist().click("", model(), artist().placesOn(model(), 9)[4]);
        for (int i = 0; i < 4; ++i)
            studio().action("select.grow")->trigger();
        pair(u"scope"_s, map(), [&] {
            studio().action("uv.runSelection")->trigger();
            QTest::qWait(3000);
            studio().press(Qt::Key_Space);
            studio().solverRests();
        });
    }

    //! Rows 25 to 27.
    void steeringBySeams()
    {
        sample("file.sample.character");
        artist().runJob("uv.unwrap");
        frame();
        const QList<QPoint> edges = artist().edgesOn(model(), 40);
        artist().use("tool.cut");
        pair(u"cut"_s, model(), [&] {
            artist().doubleClick("", model(), edges[22]);
            solveToRest();
        });
        artist().use("tool.join");
        pair(u"join"_s, model(), [&] {
            artist().doubleClick("", model(), edges[30]);
            solveToRest();
        });
    }

    void ripping()
    {
        sample("file.sample.character");
        artist().runJob("uv.unwrap");
        studio().action("view.coloring.islands")->trigger();
        frame();
        artist().use("select.edges");
        artist().click("", model(), artist().edgesOn(model(), 40)[22]);
        studio().action("select.loop")->trigger();
        pair(u"rip"_s, map(), [&] { artist().runJob("uv.rip"); });
    }

    //! Rows 28 and 29.
    void painting()
    {
        sample("file.sample.character");
        studio().action("view.coloring.paint")->trigger();
        artist().use("tool.paint");
        const QList<QPoint> places = artist().placesOn(model(), 24);
        pair(u"paint"_s, model(), [&] {
            QTest::keyClick(&model(), Qt::Key_1);
            artist().drag("", model(), {places[4], places[6], places[8], places[7]});
            QTest::keyClick(&model(), Qt::Key_2);
            artist().drag("", model(), {places[16], places[19]});
        });
    }

    //! Rows 30, 31 and 37.
    void dragging()
    {
        sample("file.sample.bumpycube");
        artist().runJob("uv.unwrap");
        frame();
        artist().use("select.vertices");
        artist().use("tool.drag");
        pair(u"drag"_s, map(), [&] {
            const QPoint rim = artist().placesOn(map(), 400).first();
            artist().drag("", map(), {rim, rim + QPoint(-60, -120)});
        });
        const QList<QPoint> places = artist().placesOn(map(), 12);
        artist().use("tool.pin");
        pair(u"pins"_s, map(), [&] {
            for (const int i : {0, 4, 8, 11}) {
                const int corner = 3 * map().pick(places[i]).triangle;
                if (const auto place = corner >= 0 ? map().screenOf(corner) : std::nullopt)
                    artist().click("", map(), place->toPoint());
            }
        });
    }

    //! Rows 32 to 34.
    void boxing()
    {
        sample("file.sample.bumpycube");
        artist().runJob("uv.unwrap");
        studio().action("view.coloring.islands")->trigger();
        frame();
        artist().use("tool.rectangle");
        const QPoint lower = artist().pixelOf({0.05, 0.1}), upper = artist().pixelOf({0.95, 0.9});
        pair(u"rectangle"_s, map(), [&] {
            artist().drag("", map(), {lower, upper});
            artist().drag("", map(), {artist().placesOn(map(), 9)[4], (lower + upper) / 2});
            solveToRest();
        });
    }

    //! Rows 35 and 36.
    void overlaps()
    {
        sample("file.sample.machine");
        artist().runJob("uv.unwrap");
        artist().use("select.islands");
        studio().action("select.all")->trigger();
        studio().action("uv.alignLeft")->trigger();
        studio().action("select.none")->trigger();
        frame();
        studio().measured();
        artist().use("tool.region");
        pair(u"region"_s, map(), [&] {
            const QPoint place = artist().placesOn(map(), 9)[4];
            artist().click("", map(), place);
            (void)QTest::qWaitFor([&] { return !document().selection().faces.isEmpty(); }, test::patience);
            artist().drag("", map(), {place, artist().emptyPlace(60)});
            studio().measured();
        });
        pair(u"separate"_s, map(), [&] {
            artist().runJob("uv.separate");
            frame();
        });
    }

    //! Row 38.
    void arranging()
    {
        sample("file.sample.machine");
        artist().runJob("uv.unwrap");
        studio().action("view.coloring.islands")->trigger();
        frame();
        artist().use("select.islands");
        studio().action("select.all")->trigger();
        studio().action("uv.alignLeft")->trigger();
        frame();
        pair(u"pack"_s, map(), [&] {
            artist().runJob("uv.pack");
            frame();
        });
    }

    //! Row 39, and the heat-map.
    void looking()
    {
        sample("file.sample.bumpycube");
        studio().action("uv.budget")->trigger();
        for (int i = 0; i < 8; ++i)
            studio().press(Qt::Key_Right);
        solve(40);
        for (int i = 0; i < 5; ++i)
            studio().press(Qt::Key_Down);
        solve(30);
        frame();
        save(both(), u"tension"_s);
        pause();
        artist().runJob("uv.unwrap");
        frame();
        studio().action("view.coloring.signedStretch")->trigger();
        save(both(), u"stretch"_s);
    }

    //! Opens the dialog of a bake, where `work` is done, and clicks a button of it.
    template <class Work>
    void bake(const char *button, Work work)
    {
        ask("uv.bake", [&](QDialog &dialog) {
            work(dialog);
            QTest::mouseClick(dialog.findChild<QPushButton *>(QLatin1StringView(button)), Qt::LeftButton);
        });
    }
    //! Ticks these maps, and clears the others.
    static void chooseMaps(QDialog &dialog, const QList<int> &rows)
    {
        auto *maps = dialog.findChild<QListWidget *>(u"maps"_s);
        for (int row = 0; row < maps->count(); ++row)
            maps->item(row)->setCheckState(rows.contains(row) ? Qt::Checked : Qt::Unchecked);
        maps->setCurrentRow(rows.first());
    }

    //! A dialog of a bake, one of its maps live while the map changes, and a texture set made of others.
    void texturing()
    {
        workInFolder();
        QDir().mkdir(u"maps"_s);
        sample("file.sample.machine");
        (void)writeMesh(document().state().scene, u"machine_high.obj"_s);
        artist().runJob("uv.unwrap");
        frame();
        bake("bake", [&](QDialog &dialog) {
            chooseMaps(dialog, {0, 2});
            type(dialog, "high", u"machine_high.obj"_s);
            type(dialog, "folder", u"maps"_s);
            settle();
            save(dialog.grab().toImage(), u"bake"_s);
            type(dialog, "high", {});
            chooseMaps(dialog, {2, 4});
        });
        (void)studio().jobsRest();
        bake("live", [](QDialog &dialog) { chooseMaps(dialog, {2}); });
        const LiveBake &live = studio().context.liveBake;
        (void)QTest::qWaitFor([&] { return !live.isRefining() && !live.pictures().images.empty(); },
                              test::patience);
        save(both(), u"livebake"_s);
        paintTextures();
        studio().answers->filesToOpen = {QDir(u"maps"_s).absolutePath()};
        dock("textures")->raise();
        settle();
        QTest::mouseClick(studio().window.findChild<QPushButton *>(u"loadTextureFolder"_s), Qt::LeftButton);
        const auto &pictures = studio().context.pictures;
        (void)QTest::qWaitFor([&] { return !pictures.isLoading() && !pictures.light().isLoading(); },
                              test::patience);
        window(u"textures"_s);
        ask("uv.carryTextures", [&](QDialog &dialog) {
            type(dialog, "folder", u"maps"_s);
            settle();
            save(dialog.grab().toImage(), u"carry"_s);
        });
    }
    //! Makes paint of the baked pictures that has come off where edges stick out.
    void paintTextures()
    {
        const QDir maps(u"maps"_s);
        QImage curvature, shadow;
        for (const QString &name : maps.entryList({u"*.png"_s})) {
            const QImage image = QImage(maps.filePath(name)).convertToFormat(QImage::Format_Grayscale8);
            (name.contains(u"curvature"_s) ? curvature : shadow) = image;
            QFile::remove(maps.filePath(name));
        }
        if (curvature.isNull() || curvature.size() != shadow.size()) {
            fail(u"nothing was baked"_s);
            return;
        }
        QImage color(curvature.size(), QImage::Format_RGB32), rough = color, metal = color;
        for (int y = 0; y < color.height(); ++y) {
            for (int x = 0; x < color.width(); ++x) {
                const int bare = std::clamp(12 * (qGray(curvature.pixel(x, y)) - 140), 0, 255);
                const auto mix = [bare](int paint, int steel) {
                    return (paint * (255 - bare) + steel * bare) / 255;
                };
                color.setPixel(x, y, qRgb(mix(30, 190), mix(95, 188), mix(120, 182)));
                rough.setPixel(x, y, qRgb(mix(110, 60), mix(110, 60), mix(110, 60)));
                metal.setPixel(x, y, qRgb(bare, bare, bare));
            }
        }
        color.save(maps.filePath(u"machine_BaseColor.png"_s));
        rough.save(maps.filePath(u"machine_Roughness.png"_s));
        metal.save(maps.filePath(u"machine_Metallic.png"_s));
        shadow.save(maps.filePath(u"machine_AO.png"_s));
    }
};

} // namespace

int main(int argc, char *argv[])
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSamples(4);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(argc, argv);
    applyTheme(application, Theme::Dark);
    installLanguage(application, Language::English); // for texts with a number of one
    const qsizetype count = QApplication::arguments().size();
    if (count != 2 && count != 3) {
        std::fputs("usage: guide_pictures FOLDER [STEP]\n", stderr);
        return 2;
    }
    const QString folder = QApplication::arguments()[1];
    if (!QDir().mkpath(folder)) {
        std::fprintf(stderr, "guide_pictures: cannot make %s\n", qPrintable(folder));
        return 1;
    }
    const QString problem = Guide(folder).take(QApplication::arguments().value(2).toInt());
    if (!problem.isEmpty())
        std::fprintf(stderr, "guide_pictures: %s\n", qPrintable(problem));
    return problem.isEmpty() ? 0 : 1;
}
