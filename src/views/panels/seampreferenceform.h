// The form for preferred places of seams.
#pragma once

#include "model/plain/solvesettings.h"

#include <QWidget>

#include <functional>

class QComboBox;

namespace autocuts {

class SliderSpin;

//! Sets how strongly seams run along creases and in hidden places. Does not use the document; changes are
//! emitted as signals.
class SeamPreferenceForm final : public QWidget
{
    Q_OBJECT

public:
    explicit SeamPreferenceForm(QWidget *parent = nullptr);

    //! Shows settings without emitting signals.
    void setSettings(const SolveSettings &settings);

Q_SIGNALS:
    //! \param edit applies the change to settings \param first false while a drag continues
    void edited(const std::function<void(autocuts::SolveSettings &)> &edit, bool first);

private:
    SliderSpin *makeShare(QLatin1StringView name, double SolveSettings::*field);

    QComboBox *mCreases;
    SliderSpin *mCreaseStrength, *mVisibility;
};

} // namespace autocuts
