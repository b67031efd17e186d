// The form that says which edges become seams: given ones, found ones or both.
#pragma once

#include "model/plain/solvesettings.h"

#include <QWidget>

#include <functional>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace autocuts {

//! Chooses whether the map gets given seams, and which edges are given. Does not use the document; changes
//! are emitted as signals.
class GivenSeamForm final : public QWidget
{
    Q_OBJECT

public:
    explicit GivenSeamForm(QWidget *parent = nullptr);

    //! Shows settings without emitting signals.
    void setSettings(const SolveSettings &settings);

Q_SIGNALS:
    //! \param edit applies the change to settings
    void edited(const std::function<void(autocuts::SolveSettings &)> &edit);

private:
    //! A check box and the option that it sets.
    struct Source
    {
        QCheckBox *box;
        bool GivenSeamOptions::*option;
    };

    QCheckBox *addSource(QLatin1StringView name, const QString &text, const QString &tip,
                         bool GivenSeamOptions::*option);
    QWidget *makeSharpRow();

    QComboBox *mMode;
    std::vector<Source> mSources;
    QDoubleSpinBox *mAngle = nullptr;
    QWidget *mSourceBox;
};

} // namespace autocuts
