// The table of actions, the menus made from it, and all actions in every state.
#include "model/samples/samples.h"
#include "support/gridstudio.h"
#include "views/actions/menubuilder.h"
#include "views/ui/icons.h"

#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QToolBar>

#include <set>

namespace tst_actions {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::GridStudio;

namespace {

QStringList idsInMenu(const QMenu &menu)
{
    QStringList ids;
    for (const QAction *action : menu.actions())
        ids << (action->isSeparator() ? u"-"_s
                : action->menu()      ? action->menu()->objectName()
                                      : action->objectName());
    return ids;
}

} // namespace

class TestActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tableIsSound()
    {
        std::set<QString> ids, keys;
        for (const ActionInfo &info : actionTable()) {
            const QString id = QLatin1String(info.id);
            QVERIFY2(ids.insert(id).second, info.id);
            QVERIFY2(*info.menu && *info.text && *info.tip, info.id);
            QVERIFY2(!QLatin1String(info.tip).endsWith(u'.'), info.id);
            QVERIFY2(!*info.group || info.checkable, info.id);
            for (const QKeySequence &key : defaultShortcuts(info)) {
                QVERIFY2(!key.isEmpty() && key.count() == 1, info.id);
                QVERIFY2(keys.insert(key.toString()).second, info.id);
            }
        }
        QVERIFY(ids.size() > 90);
    }

    void keysAreThoseAgreed_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("key");
        for (const auto &[id, key] :
             std::initializer_list<std::pair<const char *, const char *>>{{"uv.lambdaLess", "Left"},
                                                                          {"uv.lambdaMore", "Right"},
                                                                          {"uv.deltaDouble", "Up"},
                                                                          {"uv.deltaHalve", "Down"},
                                                                          {"uv.run", "Space"},
                                                                          {"uv.cut", "C"},
                                                                          {"uv.join", "J"},
                                                                          {"uv.unwrap", "U"},
                                                                          {"uv.pack", "P"},
                                                                          {"uv.separate", "O"},
                                                                          {"tool.select", "Q"},
                                                                          {"tool.move", "G"},
                                                                          {"tool.rotate", "R"},
                                                                          {"tool.scale", "S"},
                                                                          {"select.vertices", "1"},
                                                                          {"select.edges", "2"},
                                                                          {"select.faces", "3"},
                                                                          {"select.islands", "4"},
                                                                          {"view.texture", "T"},
                                                                          {"view.heatMap", "Shift+T"},
                                                                          {"view.frameAll", "Home"},
                                                                          {"view.hide", "H"},
                                                                          {"view.hideOthers", "Shift+H"},
                                                                          {"view.showAll", "Alt+H"},
                                                                          {"view.frameAll", "A"},
                                                                          {"view.frameSelected", "F"},
                                                                          {"view.frameSelected", "Num+."},
                                                                          {"uv.rip", "V"},
                                                                          {"uv.stitch", "Shift+V"},
                                                                          {"uv.clearSteering", "Shift+C"}})
            QTest::addRow("%s %s", id, key) << QString::fromLatin1(id) << QString::fromLatin1(key);
    }

    void keysAreThoseAgreed()
    {
        QFETCH(QString, id);
        QFETCH(QString, key);
        test::StudioParts studio;
        const auto keys = studio.action(qPrintable(id))->shortcuts();
        QVERIFY(keys.contains(QKeySequence(key, QKeySequence::PortableText)));
    }

    void keysOfToolsAreFree()
    {
        test::StudioParts studio;
        for (const char *key : {"X", "Y", "Del"}) {
            const QKeySequence keys(QString::fromLatin1(key), QKeySequence::PortableText);
            QVERIFY2(studio.registry.conflicts(nullptr, keys).isEmpty(), key);
        }
    }

    void tooltipsEndWithTheKey()
    {
        test::StudioParts studio;
        studio.registry.setMet(~0); // otherwise the reason why it is disabled comes after it
        for (const QAction *action : studio.registry.actions()) {
            const QString key = action->shortcut().toString(QKeySequence::NativeText);
            const QString tip = action->toolTip();
            QVERIFY2(tip.startsWith(actionTitle(studio.registry.info(action))), qPrintable(tip));
            QCOMPARE(tip.endsWith(u']'), !key.isEmpty());
            QVERIFY2(key.isEmpty() || tip.endsWith(u"[%1]"_s.arg(key)), qPrintable(tip));
        }
    }

    void iconsExistAndAreNotEmpty()
    {
        const QStringList names = iconNames();
        QVERIFY(names.size() > 60);
        for (const ActionInfo &info : actionTable())
            QVERIFY2(!*info.icon || names.contains(QLatin1String(info.icon)), info.icon);
        for (const QString &name : names) {
            for (const qreal ratio : {1.0, 2.0}) {
                const QImage image = icon(name).pixmap(QSize(24, 24), ratio).toImage();
                QCOMPARE(image.size(), QSize(24, 24) * ratio);
                int covered = 0, full = 0;
                for (int y = 0; y < image.height(); ++y) {
                    for (int x = 0; x < image.width(); ++x) {
                        covered += qAlpha(image.pixel(x, y)) > 0;
                        full += qAlpha(image.pixel(x, y)) > 200;
                    }
                }
                QVERIFY2(covered > 30 * ratio && full > 15 * ratio, qPrintable(name));
                // Nothing is cut off at the corners; a border of a pixel may be touched by a line.
                QVERIFY2(name == u"autocuts"_s || qAlpha(image.pixel(0, 0)) < 128, qPrintable(name));
            }
        }
        QVERIFY(icon(u"no such icon"_s).isNull());
    }

    void samplesAreThoseOfTheModel()
    {
        QStringList names;
        for (const ActionInfo &info : actionTable()) {
            if (QLatin1String(info.menu) == "File/Open sample"_L1)
                names << QString::fromLatin1(info.id).section(u'.', -1);
        }
        QCOMPARE(names, sampleNames());
    }

    void menusHoldTheWholeTable()
    {
        test::StudioParts studio;
        QMenuBar bar;
        const MenuBuilder menus(studio.registry, bar);
        QStringList titles;
        for (const QAction *action : bar.actions())
            titles << action->menu()->objectName();
        QCOMPARE(titles, QStringList({u"File"_s, u"Edit"_s, u"Select"_s, u"UV"_s, u"View"_s, u"Help"_s}));
        QSet<QAction *> found;
        for (const auto &[path, menu] : menus.menus()) {
            QVERIFY2(!menu->title().isEmpty(), qPrintable(path));
            QVERIFY2(!menu->actions().isEmpty(), qPrintable(path));
            QVERIFY2(!menu->actions().first()->isSeparator(), qPrintable(path));
            QVERIFY2(!menu->actions().last()->isSeparator(), qPrintable(path));
            std::set<QString> mnemonics;
            for (QAction *action : menu->actions()) {
                found.insert(action);
                const qsizetype at = action->text().indexOf(u'&');
                if (at >= 0)
                    QVERIFY2(mnemonics.insert(action->text().mid(at + 1, 1).toLower()).second,
                             qPrintable(path + u": "_s + action->text()));
            }
        }
        for (QAction *action : studio.registry.actions())
            QVERIFY2(found.contains(action), qPrintable(action->objectName()));
        QVERIFY(menus.menu(u"View/Panels"_s));
    }

    void separatorsStandBeforeSubmenus()
    {
        test::StudioParts studio;
        QMenuBar bar;
        const MenuBuilder menus(studio.registry, bar);
        const QStringList view = idsInMenu(*menus.menu(u"View"_s));
        QCOMPARE(view.at(view.indexOf(u"View/Coloring"_s) - 1), u"-"_s);
        QCOMPARE(view.at(view.indexOf(u"View/Panels"_s) - 1), u"-"_s);
    }

    void toolBarHasIcons()
    {
        test::StudioParts studio;
        QToolBar bar;
        fillToolBar(studio.registry, bar);
        int count = 0;
        for (const QAction *action : bar.actions()) {
            QVERIFY(action->isSeparator() || !action->icon().isNull());
            count += !action->isSeparator();
        }
        QVERIFY(count >= 14);
    }

    void recentFilesAreInTheirMenu()
    {
        test::StudioParts studio;
        QMenuBar bar;
        MenuBuilder menus(studio.registry, bar);
        studio.actions.file().fillRecentMenu(menus);
        const QMenu *menu = menus.menu(u"File/Open recent"_s);
        QVERIFY(!menu->menuAction()->isEnabled());
        studio.preferences.addRecentFile(u"/none/a & b.obj"_s);
        QVERIFY(menu->menuAction()->isEnabled());
        QCOMPARE(menu->actions().first()->text(), u"&1  a && b.obj"_s);
        menu->actions().first()->trigger();
        QVERIFY(studio.rests());
        studio.trigger("file.clearRecent");
        QVERIFY(!menu->menuAction()->isEnabled());
        QVERIFY(menu->actions().contains(studio.action("file.clearRecent")));
    }

    void everyActionWithoutADocument()
    {
        test::StudioParts studio;
        for (QAction *action : studio.registry.actions()) {
            if (studio.registry.info(action).needs & NeedsDocument)
                QVERIFY2(!action->isEnabled(), qPrintable(action->objectName()));
            if (!action->objectName().startsWith(u"file.sample"_s))
                action->trigger();
        }
        QVERIFY(!studio.workspace.document());
        QVERIFY(studio.rests());
    }

    void everyActionIgnoresItsState()
    {
        // Also what is disabled must not crash: other parts may trigger it when the state has moved on.
        test::StudioParts studio;
        for (QAction *action : studio.registry.actions()) {
            action->setEnabled(true);
            if (!action->objectName().startsWith(u"file.sample"_s))
                action->trigger();
        }
        QVERIFY(studio.rests());
    }

    void everyActionWithADocument_data()
    {
        QTest::addColumn<QString>("id");
        for (const ActionInfo &info : actionTable())
            QTest::newRow(info.id) << QString::fromLatin1(info.id);
    }

    void everyActionWithADocument()
    {
        QFETCH(QString, id);
        GridStudio studio;
        studio.answers.unsaved = Questions::Unsaved::Discard;
        studio.selectFaces({0, 1, 2});
        studio.registry.setMet(-1);
        studio.action(qPrintable(id))->trigger();
        if (studio.solver.isRunning())
            studio.solver.pause();
        QVERIFY(studio.rests());
        if (studio.workspace.document())
            QCOMPARE(studio.document().validate(), QString());
    }

    void needsFollowTheState()
    {
        test::StudioParts studio;
        const auto enabled = [&](const char *id) { return studio.action(id)->isEnabled(); };
        QVERIFY(enabled("file.open") && !enabled("file.save") && !enabled("uv.run") &&
                !enabled("select.all"));
        studio.workspace.open(std::make_unique<Document>(test::sceneOf(test::grid(4))), {});
        QVERIFY(enabled("file.save") && enabled("uv.run") && enabled("select.all"));
        QVERIFY(!enabled("uv.pack") && !enabled("edit.undo") && !enabled("uv.cut") && !enabled("uv.cancel"));
        studio.trigger("select.all");
        QVERIFY(enabled("uv.cut") && !enabled("uv.lock") && !enabled("select.loop"));
        studio.trigger("select.edges");
        studio.trigger("select.all");
        QVERIFY(enabled("select.loop"));
        studio.trigger("uv.cut");
        QVERIFY(enabled("edit.undo") && !enabled("edit.redo"));
        QVERIFY(studio.action("edit.undo")->text().size() > u"&Undo "_s.size());
        studio.trigger("edit.undo");
        QVERIFY(!enabled("edit.undo") && enabled("edit.redo"));
        studio.workspace.open(test::layoutDocument(test::grid(4)), {});
        QVERIFY(enabled("uv.pack") && !enabled("edit.redo"));
        studio.workspace.close();
        QVERIFY(!enabled("file.save") && !enabled("uv.pack") && !enabled("edit.undo"));
    }

    void jobsDisableWhatWouldDisturbThem()
    {
        GridStudio studio;
        studio.trigger("uv.pack");
        QVERIFY(studio.map.jobs().isBusy());
        QVERIFY(!studio.action("uv.unwrap")->isEnabled() && studio.action("uv.cancel")->isEnabled());
        studio.trigger("uv.cancel");
        QVERIFY(studio.rests());
        QVERIFY(studio.action("uv.unwrap")->isEnabled() && !studio.action("uv.cancel")->isEnabled());
    }
};

QTEST_MAIN(TestActions)

} // namespace tst_actions

#include "tst_actions.moc"
