// The options of a batch.
#pragma once

#include "cli/clioption.h"

#include <vector>

namespace autocuts {

std::vector<CliOption> batchOptions();

//! Reads the report on several files. \pre options.many
std::optional<QString> readManyReport(CliOptions &options, const QString &value);

} // namespace autocuts
