// What cannot be done says why: keys, entries of menus, buttons of panels, the search for actions.
#include "support/editsupport.h"
#include "support/meshbuilders.h"
#include "support/studiosession.h"
#include "views/actions/actionpalette.h"
#include "views/canvas/uvview.h"
#include "views/shell/statusbar.h"

#include <QAbstractButton>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QToolBar>

namespace tst_reasons {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::StudioSession;

class TestReasons : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keysOfDisabledActionsSayWhy_data()
    {
        QTest::addColumn<bool>("open");
        QTest::addColumn<QByteArray>("action");
        QTest::addColumn<Qt::Key>("key");
        QTest::addColumn<QString>("said");
        QTest::newRow("no model") << false << "uv.unwrap"_ba << Qt::Key_U << u"Unwrap: Open a model first"_s;
        QTest::newRow("no map") << true << "uv.pack"_ba << Qt::Key_P
                                << u"Pack: There is no map yet: unwrap first"_s;
        QTest::newRow("nothing selected")
            << true << "view.hide"_ba << Qt::Key_H << u"Hide selected: Select something first"_s;
        QTest::newRow("no edges") << true << "uv.cut"_ba << Qt::Key_C
                                  << u"Cut: Select edges or faces first"_s;
    }

    void keysOfDisabledActionsSayWhy()
    {
        QFETCH(const bool, open);
        QFETCH(const QByteArray, action);
        QFETCH(const Qt::Key, key);
        QFETCH(const QString, said);
        StudioSession studio;
        if (open)
            studio.action("file.sample.bumpycube")->trigger();
        QVERIFY(!studio.action(action.constData())->isEnabled());
        studio.press(key);
        QCOMPARE(studio.window.findChild<StatusBar *>()->shownText(), said);
        QVERIFY(studio.action(action.constData())->toolTip().endsWith(said.section(u": "_s, 1)));
    }

    void aKeyDuringAJobSaysThatItRuns()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        studio.action("uv.unwrap")->trigger();
        QVERIFY(studio.context.map.jobs().isBusy());
        studio.press(Qt::Key_P);
        QCOMPARE(studio.window.findChild<StatusBar *>()->shownText(),
                 u"Pack: A job is running: wait for its end, or cancel it"_s);
        studio.action("uv.cancel")->trigger();
        QVERIFY(studio.jobsRest());
    }

    //! With a model, each button of each panel that cannot be pressed has a line of its tooltip for that.
    void disabledButtonsOfPanelsSayWhy_data()
    {
        QTest::addColumn<bool>("mapped");
        QTest::newRow("without a map") << false;
        QTest::newRow("with a map") << true;
    }

    void disabledButtonsOfPanelsSayWhy()
    {
        QFETCH(const bool, mapped);
        StudioSession studio;
        studio.action("file.sample.character")->trigger();
        if (mapped) {
            studio.action("uv.unwrap")->trigger();
            QVERIFY(studio.jobsRest());
            QVERIFY(studio.measured());
        }
        QStringList silent;
        for (QDockWidget *dock : studio.window.findChildren<QDockWidget *>()) {
            dock->show();
            dock->raise();
            QCoreApplication::processEvents();
            for (const QAbstractButton *button : dock->widget()->findChildren<QAbstractButton *>()) {
                if (button->isVisible() && !button->isEnabled() && !button->toolTip().contains(u'\n'))
                    silent << dock->objectName() + u'/' + button->objectName();
            }
        }
        QCOMPARE(silent.join(u", "_s), QString());
    }

    //! Each button of each dialog that an action opens, on all pages.
    void disabledButtonsOfDialogsSayWhy()
    {
        StudioSession studio;
        studio.context.workspace.open(test::layoutDocument(test::sphere(8, 10)), {});
        QStringList silent;
        int dialogs = 0, disabled = 0;
        studio.answers->onDialog = [&](QDialog &dialog) {
            ++dialogs;
            for (const QAbstractButton *button : dialog.findChildren<QAbstractButton *>()) {
                if (button->isEnabled() || !button->parentWidget()->isEnabled())
                    continue;
                ++disabled;
                if (button->property("autocutsWhyDisabled").toString().isEmpty())
                    silent << dialog.windowTitle() + u'/' + button->text() + button->objectName();
            }
            return int(QDialog::Rejected);
        };
        for (QAction *action : studio.context.actions.actions()) {
            if (action->text().endsWith(u"..."_s) && action->isEnabled())
                action->trigger();
        }
        QVERIFY2(dialogs > 8, qPrintable(QString::number(dialogs)));
        QVERIFY2(disabled > 5, qPrintable(QString::number(disabled)));
        QCOMPARE(silent.join(u", "_s), QString());
    }

    void theSearchForActionsSaysWhatItLacks()
    {
        StudioSession studio;
        ActionPalette palette(studio.context.actions);
        const auto *remark = palette.findChild<QLabel *>(u"remark"_s);
        palette.show();
        const auto search = [&](const QString &words) {
            palette.findChild<QLineEdit *>()->setText(words);
            return remark->text();
        };
        QCOMPARE(search(u"no such thing"_s), u"No action has all of these words in its name or menu"_s);
        QTest::keyClick(&palette, Qt::Key_Return);
        QVERIFY(palette.isVisible());
        QCOMPARE(search(u"unwrap selection"_s), u"Open a model first"_s);
        palette.accept();
        QVERIFY(palette.isVisible());
        QCOMPARE(search(u"preferences"_s), QString());
        palette.accept();
        QVERIFY(!palette.isVisible());
        QCOMPARE(palette.chosen(), studio.action("edit.preferences"));
    }

    void theSearchForActionsSeesThatAJobEnds()
    {
        StudioSession studio;
        ActionPalette palette(studio.context.actions);
        const auto *remark = palette.findChild<QLabel *>(u"remark"_s);
        palette.findChild<QLineEdit *>()->setText(u"unwrap selection"_s);
        QCOMPARE(palette.chosen(), nullptr);
        QCOMPARE(remark->text(), u"Open a model first"_s);
        QAction *action = studio.action("uv.unwrapSelection");
        action->setEnabled(true);
        QCOMPARE(palette.chosen(), action);
        const auto *found = palette.findChild<QListWidget *>();
        QVERIFY(found->currentItem()->flags() & Qt::ItemIsEnabled);
    }

    //! As they stand in the menus: with their dots, and with the menus that lead there.
    void theSearchForActionsTakesTextsOfMenus()
    {
        StudioSession studio;
        studio.context.workspace.open(test::layoutDocument(test::sphere(8, 10)), {});
        QCoreApplication::processEvents();
        ActionPalette palette(studio.context.actions);
        const auto chosen = [&](const QString &words) {
            palette.findChild<QLineEdit *>()->setText(words);
            return palette.chosen();
        };
        QCOMPARE(chosen(u"bake..."_s), studio.action("uv.bake"));
        QCOMPARE(chosen(u"UV > Bake light..."_s), studio.action("uv.bakeLight"));
        QCOMPARE(chosen(u"Preferences\u2026"_s), studio.action("edit.preferences"));
    }

    //! They are shown, whether they are closed or a tab behind others, and never closed.
    void theSearchForActionsFindsPanels()
    {
        StudioSession studio;
        QList<QDockWidget *> docks = studio.window.findChildren<QDockWidget *>();
        QVERIFY(docks.size() > 10);
        for (QDockWidget *dock : docks) {
            for (const bool closed : {true, false}) {
                dock->setHidden(closed);
                ActionPalette palette(studio.context.actions);
                palette.findChild<QLineEdit *>()->setText(u"View > Panels > "_s + dock->windowTitle());
                QVERIFY2(palette.chosen(), qPrintable(dock->windowTitle()));
                QCOMPARE(palette.chosen()->text(), dock->windowTitle());
                palette.chosen()->trigger();
                QTRY_VERIFY2(!dock->visibleRegion().isEmpty(), qPrintable(dock->windowTitle()));
            }
        }
        ActionPalette palette(studio.context.actions);
        palette.findChild<QLineEdit *>()->setText(u"main tool bar"_s);
        QVERIFY(palette.chosen());
        palette.chosen()->trigger();
        QVERIFY(studio.window.findChild<QToolBar *>(u"mainToolBar"_s)->isHidden());
    }
};

QTEST_MAIN(TestReasons)

} // namespace tst_reasons

#include "tst_reasons.moc"
