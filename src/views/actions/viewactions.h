// The View menu.
#pragma once

#include "views/canvas/orbitcamera.h"
#include "views/control/session/studiocontext.h"
#include "views/state/viewstate.h"

#include <QObject>

namespace autocuts {

class Questions;

//! Which of the two views are visible.
enum class ViewLayout { Both, Only3d, OnlyUv };

//! Connects the View menu to the view options. Signals pass on what only the window can do.
class ViewActions final : public QObject
{
    Q_OBJECT

public:
    ViewActions(const StudioContext &context, Questions &questions, QObject *parent = nullptr);

    ViewLayout layout() const { return mLayout; }
    //! Checks the action of the layout; emits layoutChosen() when it changes.
    void setLayout(ViewLayout layout);

    //! Loads an image and makes it the pattern of both views.
    void loadTexture(const QString &path);

Q_SIGNALS:
    void frameAll();
    void frameSelected();
    void lookFrom(autocuts::ViewSide side);
    void layoutChosen(autocuts::ViewLayout layout);
    void togglePanels();
    void resetPanels();

private:
    void connectChoices();
    void connectWindow();
    template <typename Change>
    void connectChange(const char *id, Change change);
    void askTexture();
    void showPreview();
    void nextHeatMap();
    void nextPattern();
    void showOptions();

    StudioContext mContext;
    Questions &mQuestions;
    ViewLayout mLayout = ViewLayout::Both;
};

} // namespace autocuts
