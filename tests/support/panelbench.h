// A panel on a document, with all controllers but without a window, for tests that use it as an artist does.
#pragma once

#include "model/document/document.h"
#include "views/actions/actionregistry.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/pictures/livebake.h"
#include "views/control/pictures/modelpictures.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/studiocontext.h"
#include "views/control/session/workspace.h"
#include "views/panels/panel.h"
#include "views/state/viewstate.h"
#include "views/ui/preferences.h"

#include <QMouseEvent>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QTemporaryDir>
#include <QTest>

namespace autocuts::test {

inline constexpr int panelPatience = 60'000; //!< milliseconds

//! Everything that a panel is given.
struct PanelBench
{
    QTemporaryDir folder;
    Preferences preferences{folder.filePath(QStringLiteral("autocuts.ini"))};
    Workspace workspace;
    ShownMap shownMap{workspace};
    ViewState view;
    SolverController solver{workspace, shownMap};
    MapController map{workspace, solver, shownMap};
    FileController files{workspace, solver, preferences, folder.path()};
    ActionRegistry actions{preferences};
    ModelPictures pictures{workspace, view};
    LiveBake liveBake{workspace, shownMap};
    StudioContext context{workspace, shownMap, view,    preferences, solver,
                          map,       files,    actions, pictures,    liveBake};

    Document &document() { return *workspace.document(); }
    UndoStack &stack() { return document().undoStack(); }
    bool measured()
    {
        return QTest::qWaitFor([this] { return map.figuresAreFresh(); }, panelPatience);
    }
};

//! Shows a panel as wide as a dock.
inline bool showPanel(QWidget &panel, int width = 320, int height = 900)
{
    panel.resize(width, height);
    panel.show();
    panel.activateWindow();
    return QTest::qWaitForWindowExposed(&panel) && QTest::qWaitForWindowActive(&panel);
}

//! Waits until the panel has followed the document.
inline bool isUpToDate(const Panel &panel)
{
    return QTest::qWaitFor([&panel] { return panel.isUpToDate(); }, panelPatience);
}

//! The widget with this name. \pre there is one
template <class Widget>
Widget *child(const QWidget &panel, const char *name)
{
    auto *const found = panel.findChild<Widget *>(QString::fromLatin1(name));
    if (!found)
        qFatal("no widget %s", name);
    return found;
}

inline void click(const QWidget &panel, const char *name)
{
    QTest::mouseClick(child<QWidget>(panel, name), Qt::LeftButton);
}

inline QPoint handleOf(const QSlider &slider)
{
    QStyleOptionSlider option;
    option.initFrom(&slider);
    option.orientation = slider.orientation();
    option.minimum = slider.minimum();
    option.maximum = slider.maximum();
    option.sliderPosition = slider.sliderPosition();
    option.sliderValue = slider.value();
    option.subControls = QStyle::SC_All;
    return slider.style()
        ->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider)
        .center();
}

//! Drags the slider's handle in several steps, by that many pixels in all.
inline void dragSlider(QSlider &slider, int pixels, int steps = 8)
{
    const QPoint start = handleOf(slider);
    QTest::mousePress(&slider, Qt::LeftButton, {}, start);
    for (int step = 1; step <= steps; ++step) {
        const QPoint place = start + QPoint(pixels * step / steps, 0);
        QMouseEvent move(QEvent::MouseMove, QPointF(place), slider.mapToGlobal(QPointF(place)), Qt::NoButton,
                         Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&slider, &move);
        QCoreApplication::processEvents();
    }
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, start + QPoint(pixels, 0));
}

} // namespace autocuts::test
