#include "views/shell/paneldocks.h"

#include "views/actions/actionregistry.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QTabBar>

#include <algorithm>
#include <utility>

namespace autocuts {

namespace {

constexpr int gripHeight = 6; //!< device-independent pixels

bool isTab(const QMainWindow &window, QDockWidget *dock)
{
    const QList<QDockWidget *> others = window.tabifiedDockWidgets(dock);
    return !dock->isFloating() && std::any_of(others.begin(), others.end(), [](const QDockWidget *other) {
        return !other->isHidden() && !other->isFloating();
    });
}

} // namespace

PanelDocks::PanelDocks(QMainWindow &window, const QList<QDockWidget *> &docks)
    : QObject(&window), mWindow(window), mDocks(docks)
{
    mTitlesSoon.setSingleShot(true);
    connect(&mTitlesSoon, &QTimer::timeout, this, &PanelDocks::showTitles);
    const auto soon = [this] { mTitlesSoon.start(); };
    for (const QDockWidget *dock : docks) {
        connect(dock, &QDockWidget::visibilityChanged, this, soon);
        connect(dock, &QDockWidget::topLevelChanged, this, soon);
        connect(dock, &QDockWidget::dockLocationChanged, this, soon);
    }
    showTitles();
}

bool PanelDocks::isAnyShown() const
{
    return std::any_of(mDocks.begin(), mDocks.end(),
                       [](const QDockWidget *dock) { return !dock->isHidden(); });
}

void PanelDocks::toggle()
{
    if (!isAnyShown()) {
        mWindow.restoreState(std::exchange(mBefore, {}), mVersion);
        return;
    }
    mBefore = mWindow.saveState(mVersion);
    for (QDockWidget *dock : mDocks)
        dock->hide();
}

QByteArray PanelDocks::arrangement() const
{
    return isAnyShown() || mBefore.isEmpty() ? mWindow.saveState(mVersion) : mBefore;
}

void PanelDocks::addTo(QMenu &menu, QAction *before, ActionRegistry &actions)
{
    for (QDockWidget *dock : mDocks) {
        QAction *const toggle = dock->toggleViewAction();
        menu.insertAction(before, toggle);
        connect(toggle, &QAction::triggered, dock, [dock](bool shown) {
            if (shown)
                dock->raise(); // it may be a tab behind others
        });
        // Who looks for a panel wants to see it, also when it is open behind others.
        auto *const find = new QAction(dock->windowTitle(), dock);
        connect(find, &QAction::triggered, dock, [dock] {
            dock->show();
            dock->raise();
        });
        actions.addOther(find, menu.objectName());
    }
}

void PanelDocks::showTitles()
{
    for (QDockWidget *dock : mDocks) {
        QWidget *const grip = dock->titleBarWidget();
        if (isTab(mWindow, dock) == (grip != nullptr))
            continue;
        auto *const next = grip ? nullptr : new QWidget;
        if (next) {
            next->setFixedHeight(gripHeight);
            next->setToolTip(tr("Drag to move the panel, double-click to take it out of the window"));
        }
        dock->setTitleBarWidget(next);
        delete grip;
    }
    // Names that are cut off look all the same: tabs that find no room are scrolled to.
    for (QTabBar *tabs : mWindow.findChildren<QTabBar *>(Qt::FindDirectChildrenOnly))
        tabs->setElideMode(Qt::ElideNone);
}

} // namespace autocuts
