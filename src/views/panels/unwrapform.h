// The form for the automatic map: what it may cost and where its seams should rather be.
#pragma once

#include "model/plain/solvesettings.h"
#include "views/control/jobs/mapcontroller.h"

#include <QWidget>

#include <functional>
#include <optional>

class QCheckBox;
class QComboBox;
class QPushButton;

namespace autocuts {

class StretchControl;

//! Shows a large button to unwrap and the few settings that most maps need. Does not use the document;
//! changes are emitted as signals.
class UnwrapForm final : public QWidget
{
    Q_OBJECT

public:
    explicit UnwrapForm(QWidget *parent = nullptr);

    QPushButton *button() const { return mUnwrap; }
    //! Shows settings without emitting signals.
    void setSettings(const SolveSettings &settings);
    void setQuality(unwrap::UnwrapQuality quality);
    //! Shows which share of the area the last unwrap recognised as hard surfaces; nothing: unknown.
    void setRecognised(std::optional<double> hardShare);

Q_SIGNALS:
    //! \param edit applies the change to settings \param first false while a drag continues
    void edited(const std::function<void(autocuts::SolveSettings &)> &edit, bool first);
    void qualityChosen(autocuts::unwrap::UnwrapQuality quality);
    void unwrapRequested();

private:
    //! A list of the values of a setting, which no row shows yet.
    template <class T>
    QComboBox *makeChoice(QLatin1StringView name, T SolveSettings::*setting,
                          std::initializer_list<std::pair<QString, T>> choices);
    QCheckBox *addSwitch(const QString &text, QLatin1StringView name, const QString &tip,
                         std::function<void(SolveSettings &, bool)> set);

    QPushButton *mUnwrap;
    StretchControl *mStretch;
    QCheckBox *mFlat = nullptr, *mHidden = nullptr, *mSharp = nullptr, *mAlign = nullptr, *mMirror = nullptr;
    QComboBox *mSurface, *mAlike, *mSymmetry, *mUp, *mQuality;
};

} // namespace autocuts
