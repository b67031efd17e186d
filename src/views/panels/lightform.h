// The rows that choose how texture sets are shown: channel, surroundings, exposure.
#pragma once

#include "views/state/viewstate.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QPushButton;

namespace autocuts {

class Preferences;
class Questions;
class SliderSpin;

//! Writes the view options. Choosing anything shows the texture sets.
class LightForm final : public QWidget
{
    Q_OBJECT

public:
    LightForm(ViewState &view, const Preferences &preferences, Questions &questions,
              QWidget *parent = nullptr);

    //! Shows the view options.
    void refresh();

private:
    template <class Edit>
    void change(Edit edit);
    void addRows();
    void chooseSurroundings();
    void askSurroundings();

    ViewState &mView;
    const Preferences &mPreferences;
    Questions &mQuestions;
    QFormLayout *mForm;
    QComboBox *mChannel, *mSurroundings;
    QPushButton *mLoad;
    SliderSpin *mExposure, *mTurn;
    QCheckBox *mVisible;
};

} // namespace autocuts
