// The docked panels as a whole.
#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QTimer>

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;

namespace autocuts {

class ActionRegistry;

//! Hides and brings back all panels. A panel that is a tab has its name on the tab only; in place of its
//! title there is a narrow bar by which it can be dragged.
class PanelDocks final : public QObject
{
    Q_OBJECT

public:
    //! \param docks those of the window, all of them
    PanelDocks(QMainWindow &window, const QList<QDockWidget *> &docks);

    //! Hides all panels, or shows those again that were hidden last.
    void toggle();
    //! The arrangement for the next start: while all are hidden, the one before.
    QByteArray arrangement() const;
    //! The version of QMainWindow::saveState() for arrangements from now on.
    void setVersion(int version) { mVersion = version; }
    bool isAnyShown() const;
    //! Adds the panels to their menu, and to the actions that are found by name: these only ever show them.
    void addTo(QMenu &menu, QAction *before, ActionRegistry &actions);

private:
    void showTitles();

    QMainWindow &mWindow;
    const QList<QDockWidget *> mDocks;
    int mVersion = 0;
    QByteArray mBefore; //!< the arrangement before all were hidden; empty: they were not
    QTimer mTitlesSoon; //!< Qt makes tabs only after it has said that a dock moved
};

} // namespace autocuts
