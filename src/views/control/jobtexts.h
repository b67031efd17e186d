// The texts of jobs, as the translations know them.
#pragma once

#include <QCoreApplication>

namespace autocuts {

struct JobTexts
{
    Q_DECLARE_TR_FUNCTIONS(autocuts::MapController)
};

} // namespace autocuts
