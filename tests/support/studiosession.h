// A studio on a virtual screen, for tests that work as an artist does.
#pragma once

#include "support/answers.h"
#include "support/patience.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"
#include "views/panels/unwrapform.h"
#include "views/shell/mainwindow.h"
#include "views/ui/preferences.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

namespace autocuts::test {

using namespace live;

//! Quick: in a small window without smooth edges, since software OpenGL takes most of the time otherwise.
//! Full: as users see it, for pictures and benchmarks.
enum class Look { Quick, Full };

//! A window of its own with empty preferences in a folder of its own.
struct StudioSession
{
    //! Rows of a menu, separators included: with more it gets a second column on a screen of 1280 x 800.
    static constexpr int mostRows = 42;

    QTemporaryDir folder;
    Preferences preferences{folder.filePath(QStringLiteral("autocuts.ini"))};
    Answers *answers = new Answers; //!< owned by the window
    MainWindow window{preferences, folder.filePath(QStringLiteral("recovery")),
                      std::unique_ptr<Questions>(answers)};
    StudioContext context = window.context();

    explicit StudioSession(Look look = Look::Quick)
    {
        if (look == Look::Quick) {
            window.resize(1440, 640); // with panels on both sides
            for (Canvas *canvas : std::initializer_list<Canvas *>{&window.meshView(), &window.uvView()}) {
                QSurfaceFormat format = canvas->format();
                format.setSamples(0);
                canvas->setFormat(format);
            }
        }
        window.show();
        [[maybe_unused]] const bool seen = QTest::qWaitForWindowExposed(&window);
        // A virtual screen has no window manager that would do it; without it no key is a shortcut.
        QApplication::setActiveWindow(&window);
        setQuality(unwrap::UnwrapQuality::Draft);
    }

    //! Of unwraps. Most tests need some map only, so that sessions begin with drafts.
    void setQuality(unwrap::UnwrapQuality quality)
    {
        context.map.setQuality(quality);
        window.findChild<UnwrapForm *>()->setQuality(quality);
    }

    Document *document() { return context.workspace.document(); }
    QAction *action(const char *id) { return context.actions.action(id); }
    //! Presses the keys in the window.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        // A dialog that has closed may have left no window active.
        if (!QApplication::activeWindow())
            QApplication::setActiveWindow(&window);
        QTest::keyClick(&window, key, modifiers);
        QCoreApplication::processEvents(); // the actions follow at the next turn of the event loop
    }
    bool solverRests()
    {
        return QTest::qWaitFor([this] { return !context.solver.isRunning() && !context.solver.isPausing(); },
                               patience);
    }
    bool jobsRest()
    {
        const bool rest = QTest::qWaitFor(
            [this] {
                return !context.solver.isPausing() && !context.map.jobs().isBusy() &&
                       !context.files.jobs().isBusy();
            },
            patience);
        QCoreApplication::processEvents();
        return rest;
    }
    bool measured()
    {
        return QTest::qWaitFor([this] { return context.map.figuresAreFresh(); }, patience);
    }
    //! Or until the solver has nothing left to gain, and waits for an edit or has ended by itself.
    bool runsTo(int iteration)
    {
        const auto isThere = [=, this] {
            const SolveStatus &status = context.solver.status();
            return status.iteration >= iteration || status.converged || !context.solver.isRunning();
        };
        return QTest::qWaitFor(isThere, patience);
    }
};

} // namespace autocuts::test
