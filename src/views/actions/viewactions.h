// The View menu.
#pragma once

#include "views/control/studiocontext.h"
#include "views/state/viewstate.h"

#include <QObject>

namespace autocuts {

class Questions;

//! Which of the two views have the room.
enum class ViewLayout { Both, Only3d, OnlyUv };

//! Connects the View menu to the view options. What only the window can do is passed on by signals.
class ViewActions final : public QObject
{
    Q_OBJECT

public:
    ViewActions(const StudioContext &context, Questions &questions, QObject *parent = nullptr);

    ViewLayout layout() const { return mLayout; }
    //! Checks the action; emits layoutChosen() when it differs.
    void setLayout(ViewLayout layout);

    //! The picture becomes the pattern of both views.
    void loadTexture(const QString &path);

Q_SIGNALS:
    void frameAll();
    void frameSelected();
    void layoutChosen(autocuts::ViewLayout layout);
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
