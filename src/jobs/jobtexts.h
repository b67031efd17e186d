// The texts of jobs. Their context has the name of the class that they once were in.
#pragma once

#include <QCoreApplication>

namespace autocuts {

struct JobTexts
{
    Q_DECLARE_TR_FUNCTIONS(autocuts::MapController)
};

} // namespace autocuts
