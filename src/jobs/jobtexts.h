// What jobs say, in the context that the translations know.
#pragma once

#include <QCoreApplication>

namespace autocuts {

struct JobTexts
{
    Q_DECLARE_TR_FUNCTIONS(autocuts::MapController)
};

} // namespace autocuts
