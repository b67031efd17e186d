// The Help menu.
#pragma once

#include "views/control/studiocontext.h"

#include <QObject>

namespace autocuts {

class Questions;

//! List of keys, recovery folder, about.
class HelpActions final : public QObject
{
    Q_OBJECT

public:
    //! \param recoveryFolder where autosaves are kept
    HelpActions(const StudioContext &context, Questions &questions, const QString &recoveryFolder,
                QObject *parent = nullptr);
};

} // namespace autocuts
