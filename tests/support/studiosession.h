// A studio on a virtual screen, for tests that work as an artist does.
#pragma once

#include "views/actions/questions.h"
#include "views/mainwindow.h"
#include "views/preferences/preferences.h"

#include <QApplication>
#include <QDialog>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

namespace autocuts::test {

inline constexpr int patience = 120'000; //!< milliseconds

//! Answers as a test wants it, and notes what was asked.
class Answers final : public Questions
{
public:
    Answers() : Questions(nullptr) {}

    Unsaved unsaved = Unsaved::Discard;
    QStringList filesToOpen, filesToSave;   //!< taken from the front; none left: cancelled
    std::function<int(QDialog &)> onDialog; //!< not set: every dialog is cancelled
    QStringList errors;
    int unsavedAsked = 0;

    Unsaved askUnsaved(const QString &) override
    {
        ++unsavedAsked;
        return unsaved;
    }
    bool confirm(const QString &, const QString &, const QString &) override { return true; }
    QString fileToOpen(const QString &, const QString &, const QStringList &) override
    {
        return filesToOpen.isEmpty() ? QString() : filesToOpen.takeFirst();
    }
    QString fileToSave(const QString &, const QString &, const QStringList &) override
    {
        return filesToSave.isEmpty() ? QString() : filesToSave.takeFirst();
    }
    int run(QDialog &dialog) override
    {
        return onDialog ? onDialog(dialog) : static_cast<int>(QDialog::Rejected);
    }
    void showError(const Error &error) override { errors << error.toString(); }
    void showFolder(const QString &) override {}
};

//! A window of its own with empty preferences in a folder of its own.
struct StudioSession
{
    QTemporaryDir folder;
    Preferences preferences{folder.filePath(QStringLiteral("autocuts.ini"))};
    Answers *answers = new Answers; //!< owned by the window
    MainWindow window{preferences, folder.filePath(QStringLiteral("recovery")),
                      std::unique_ptr<Questions>(answers)};
    StudioContext context = window.context();

    StudioSession()
    {
        window.show();
        [[maybe_unused]] const bool seen = QTest::qWaitForWindowExposed(&window);
        // A virtual screen has no window manager that would do it; without it no key is a shortcut.
        QApplication::setActiveWindow(&window);
    }

    Document *document() { return context.workspace.document(); }
    QAction *action(const char *id) { return context.actions.action(id); }
    //! Presses the keys in the window.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::keyClick(&window, key, modifiers);
        QCoreApplication::processEvents(); // the actions follow at the next turn of the event loop
    }
    bool solverRests()
    {
        return QTest::qWaitFor([this] { return !context.solver.isRunning() && !context.solver.isSettling(); },
                               patience);
    }
    bool jobsRest()
    {
        const bool rest = QTest::qWaitFor(
            [this] {
                return solverIsQuiet() && !context.map.jobs().isBusy() && !context.files.jobs().isBusy();
            },
            patience);
        QCoreApplication::processEvents();
        return rest;
    }
    bool measured()
    {
        return QTest::qWaitFor([this] { return context.map.figuresAreFresh(); }, patience);
    }
    bool runsTo(int iteration)
    {
        return QTest::qWaitFor([=, this] { return context.solver.status().iteration >= iteration; },
                               patience);
    }

private:
    bool solverIsQuiet() const { return !context.solver.isSettling(); }
};

} // namespace autocuts::test
