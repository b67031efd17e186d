// The Help menu.
#pragma once

#include "views/control/session/studiocontext.h"

#include <QObject>

namespace autocuts {

class Questions;

//! List of shortcuts, recovery folder, about dialog.
class HelpActions final : public QObject
{
    Q_OBJECT

public:
    //! \param recoveryFolder folder of the autosaves
    HelpActions(const StudioContext &context, Questions &questions, const QString &recoveryFolder,
                QObject *parent = nullptr);
};

} // namespace autocuts
