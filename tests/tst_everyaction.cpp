// Every action of the studio, triggered without a model, with one, and while the solver runs: nothing breaks.
#include "support/editsupport.h"
#include "support/studiosession.h"

#include <QTest>

namespace tst_everyaction {

using namespace autocuts;
using test::StudioSession;

class TestEveryAction : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onAnEmptyStudio() { triggerAll(false, false); }
    void onAModel() { triggerAll(true, false); }
    void whileSolving() { triggerAll(true, true); }

private:
    void triggerAll(bool withModel, bool solving)
    {
        StudioSession studio;
        studio.window.resize(900, 600); // software OpenGL is slow
        int triggered = 0;
        // Each on a model of its own: one action may take away what another one needs.
        for (QAction *action : studio.context.actions.actions()) {
            const QString id = action->objectName();
            if (id == QStringLiteral("file.quit"))
                continue; // tested by closing the window
            if (withModel) {
                studio.context.workspace.open(test::layoutDocument(test::sphere(8, 10)), {});
                Selection selection;
                selection.faces = {0, 1, 2};
                selection.edges = {0, 5};
                studio.document()->setSelection(selection);
                if (solving) {
                    studio.context.solver.run();
                    QVERIFY2(studio.runsTo(1), qPrintable(id));
                }
            }
            if (!action->isEnabled())
                continue;
            action->trigger();
            ++triggered;
            QCoreApplication::processEvents();
            studio.context.map.cancel();
            QVERIFY2(studio.jobsRest(), qPrintable(id));
            QVERIFY2(studio.window.isVisible(), qPrintable(id));
            if (studio.document())
                QVERIFY2(studio.document()->validate().isEmpty(), qPrintable(id));
        }
        QVERIFY2(triggered > (withModel ? 60 : 20), qPrintable(QString::number(triggered)));
        QVERIFY2(studio.answers->errors.isEmpty(),
                 qPrintable(studio.answers->errors.join(QLatin1Char('\n'))));
    }
};

QTEST_MAIN(TestEveryAction)

} // namespace tst_everyaction

#include "tst_everyaction.moc"
