// Keys of the window work wherever the focus is: in all controls of all panels, and after clicks on all
// buttons.
#include "support/studiosession.h"
#include "views/canvas/uvview.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

namespace tst_panelkeys {

using namespace autocuts;
using test::StudioSession;
using namespace Qt::Literals::StringLiterals;

class TestPanelKeys : public QObject
{
    Q_OBJECT

    //! A studio with a map; nothing happens when an action is triggered.
    static std::unique_ptr<StudioSession> ready()
    {
        auto studio = std::make_unique<StudioSession>();
        studio->action("file.sample.bumpycube")->trigger();
        studio->context.map.unwrap(unwrap::UnwrapQuality::Draft);
        if (!studio->jobsRest() || !studio->measured())
            return nullptr;
        for (QAction *action : studio->context.actions.actions())
            QObject::disconnect(action, &QAction::triggered, nullptr, nullptr);
        return studio;
    }
    static QString nameOf(const QDockWidget *dock, const QWidget *control)
    {
        return dock->objectName() + u'/' + QString::fromLatin1(control->metaObject()->className()) + u'/' +
               control->objectName();
    }
    static void keys()
    {
        QTest::addColumn<QByteArray>("action");
        QTest::addColumn<Qt::Key>("key");
        QTest::newRow("run") << "uv.run"_ba << Qt::Key_Space;
        QTest::newRow("unwrap") << "uv.unwrap"_ba << Qt::Key_U;
        QTest::newRow("pack") << "uv.pack"_ba << Qt::Key_P;
        QTest::newRow("select") << "tool.select"_ba << Qt::Key_Q;
        QTest::newRow("move") << "tool.move"_ba << Qt::Key_G;
        QTest::newRow("pin") << "tool.pin"_ba << Qt::Key_N;
        QTest::newRow("pattern") << "view.texture"_ba << Qt::Key_T;
        QTest::newRow("frame all") << "view.frameAll"_ba << Qt::Key_A;
        QTest::newRow("islands") << "select.islands"_ba << Qt::Key_4;
    }
    //! Text and numbers are typed there; Space operates a button that was reached by Tab.
    static bool isTyped(const QWidget *control, Qt::Key key)
    {
        const auto *combo = qobject_cast<const QComboBox *>(control);
        const bool digit = key >= Qt::Key_0 && key <= Qt::Key_9;
        return qobject_cast<const QLineEdit *>(control) || (combo && combo->isEditable()) ||
               (digit && qobject_cast<const QAbstractSpinBox *>(control)) ||
               (key == Qt::Key_Space && qobject_cast<const QAbstractButton *>(control));
    }

private Q_SLOTS:
    void keysWorkInAllControls_data() { keys(); }
    void keysWorkInAllControls()
    {
        QFETCH(const QByteArray, action);
        QFETCH(const Qt::Key, key);
        const auto studio = ready();
        QVERIFY(studio);
        QStringList deaf;
        int tried = 0;
        for (QDockWidget *dock : studio->window.findChildren<QDockWidget *>()) {
            dock->show();
            dock->raise();
            QCoreApplication::processEvents();
            for (QWidget *control : dock->findChildren<QWidget *>()) {
                if (!control->isVisible() || !control->isEnabled() || control->focusPolicy() == Qt::NoFocus ||
                    control->focusProxy() || isTyped(control, key))
                    continue;
                control->setFocus(Qt::TabFocusReason);
                if (!control->hasFocus())
                    continue;
                ++tried;
                const QSignalSpy triggered(studio->action(action.constData()), &QAction::triggered);
                QTest::keyClick(control, key);
                if (triggered.count() != 1)
                    deaf << nameOf(dock, control);
            }
        }
        QCOMPARE(deaf.join(QStringLiteral(", ")), QString());
        QVERIFY2(tried > (key == Qt::Key_Space ? 30 : 60), qPrintable(QString::number(tried)));
    }

    //! The keys of a tool do not become those of actions when a panel has the focus.
    void keysOfToolsWorkInPanels()
    {
        const auto studio = ready();
        QVERIFY(studio);
        studio->window.tools().setTool(u"paint"_s);
        const QSignalSpy mode(studio->action("select.edges"), &QAction::triggered);
        auto *islands = studio->window.findChild<QDockWidget *>(u"islands"_s);
        islands->show();
        islands->raise();
        QWidget *list = nullptr;
        for (QWidget *control : islands->findChildren<QAbstractItemView *>()) {
            if (control->isVisible() && control->focusPolicy() != Qt::NoFocus)
                list = control;
        }
        QVERIFY(list);
        for (const auto &[key, paint] : {std::pair(Qt::Key_2, 1), std::pair(Qt::Key_3, 2)}) {
            list->setFocus();
            QVERIFY(list->hasFocus());
            QTest::keyClick(studio->window.windowHandle(), key);
            QTRY_COMPARE(int(studio->window.tools().tool()->options().front().value), paint);
        }
        QCOMPARE(mode.count(), 0);
    }

    void keysWorkAfterClicksOnAllButtons_data()
    {
        QTest::addColumn<QByteArray>("action");
        QTest::addColumn<Qt::Key>("key");
        QTest::newRow("run") << "uv.run"_ba << Qt::Key_Space;
        QTest::newRow("select") << "tool.select"_ba << Qt::Key_Q;
    }
    void keysWorkAfterClicksOnAllButtons()
    {
        QFETCH(const QByteArray, action);
        QFETCH(const Qt::Key, key);
        const auto studio = ready();
        QVERIFY(studio);
        // Menus and dialogs of buttons are closed again.
        QTimer closing;
        connect(&closing, &QTimer::timeout, &closing, [] {
            for (QWidget *open : {QApplication::activePopupWidget(), QApplication::activeModalWidget()}) {
                if (open)
                    open->close();
            }
        });
        closing.start(20);
        QStringList deaf;
        int tried = 0;
        for (QDockWidget *dock : studio->window.findChildren<QDockWidget *>()) {
            dock->show();
            dock->raise();
            for (QPointer<QAbstractButton> button : dock->widget()->findChildren<QAbstractButton *>()) {
                studio->document()->setSelection({});
                QCoreApplication::processEvents();
                if (!button || !button->isVisible() || !button->isEnabled())
                    continue;
                const QString name = nameOf(dock, button);
                studio->window.uvView().setFocus();
                QTest::mouseClick(button, Qt::LeftButton);
                studio->context.solver.pause();
                studio->context.map.cancel();
                QVERIFY(studio->jobsRest() && studio->solverRests());
                if (!QApplication::activeWindow())
                    QApplication::setActiveWindow(&studio->window);
                QWidget *const focus = QApplication::focusWidget();
                if (!focus || isTyped(focus, key))
                    continue;
                ++tried;
                const QSignalSpy triggered(studio->action(action.constData()), &QAction::triggered);
                QTest::keyClick(focus, key);
                if (triggered.count() != 1)
                    deaf << name;
            }
        }
        QCOMPARE(deaf.join(QStringLiteral(", ")), QString());
        QVERIFY2(tried >= 40, qPrintable(QString::number(tried)));
    }
};

QTEST_MAIN(TestPanelKeys)

} // namespace tst_panelkeys

#include "tst_panelkeys.moc"
