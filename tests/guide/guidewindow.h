// The window that the pictures of the guide are taken from, and how they are taken.
#pragma once

#include "support/artist.h"

#include <QDir>
#include <QImage>

#include <functional>
#include <memory>

class QDialog;
class QDockWidget;

namespace autocuts::guide {

class GuideWindow
{
public:
    explicit GuideWindow(const QString &folder) : mFolder(folder) {}

    //! A window of its own for the next pictures.
    void openNew();
    test::Artist &artist() { return *mArtist; }
    test::StudioSession &studio() { return mArtist->studio; }
    Document &document() { return mArtist->document(); }
    Canvas &model() { return mArtist->model(); }
    Canvas &map() { return mArtist->map(); }
    QDockWidget *dock(const char *name);

    //! The first problem; empty: none.
    const QString &problem() const { return mProblem; }
    void fail(const QString &problem);

    // Pictures.
    void settle();
    //! Moves the mouse to where nothing is.
    void lookAway();
    void save(const QImage &image, const QString &name);
    //! The whole window.
    void window(const QString &name);
    //! The part of the window with these widgets.
    void part(const QString &name, const QList<const QWidget *> &widgets);
    QImage both();
    static QImage beside(const QImage &left, const QImage &right);
    //! A view before and after some work.
    template <class Work>
    void pair(const QString &name, Canvas &canvas, Work work)
    {
        settle();
        const QImage before = canvas.picture();
        work();
        settle();
        save(beside(before, canvas.picture()), name);
    }

    // Work.
    void sample(const char *action);
    //! Opens a sample and unwraps it.
    void unwrapped(const char *action);
    //! Makes a draft of a map and shows all of it, islands in colours.
    void unwrap();
    void solve(int steps);
    void pause();
    //! Waits until the views have moved to the newest map.
    void standStill();
    //! Lets the solver come to rest by itself, as it does within a distortion budget.
    void solveToRest();
    void frame() { studio().action("view.frameAll")->trigger(); }
    //! Writes files beside the session from now on, not into the folder of the caller.
    void workInFolder();
    //! Does some work in the dialog of an action, which is cancelled unless the work has accepted it.
    void ask(const char *action, const std::function<void(QDialog &)> &work);
    static void type(QDialog &dialog, const char *name, const QString &text);
    //! Chooses an entry of a list of choices by its number.
    static void choose(QWidget &parent, const char *name, int entry);

private:
    QDir mFolder;
    std::unique_ptr<test::Artist> mArtist;
    QString mProblem;
};

} // namespace autocuts::guide
