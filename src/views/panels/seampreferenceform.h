// Where the solver should rather cut.
#pragma once

#include "model/plain/solvesettings.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;

namespace autocuts {

class SliderSpin;

//! Creases, visibility and symmetry of the seams. Knows no document: what is chosen is told by a signal.
class SeamPreferenceForm final : public QWidget
{
    Q_OBJECT

public:
    explicit SeamPreferenceForm(QWidget *parent = nullptr);

    //! Shows settings without a signal.
    void setSettings(const SolveSettings &settings);

Q_SIGNALS:
    //! \param edit changes the setting that was chosen \param first false when a drag goes on
    void edited(const std::function<void(autocuts::SolveSettings &)> &edit, bool first);

private:
    SliderSpin *makeShare(QLatin1StringView name, double SolveSettings::*field);

    QComboBox *mCreases;
    SliderSpin *mCreaseStrength, *mVisibility;
    QCheckBox *mSymmetry;
};

} // namespace autocuts
