// The part of a model that a command of the command line may change.
#pragma once

#include "cli/clioptions.h"
#include "model/document/result.h"
#include "model/document/scene.h"
#include "model/plain/chart.h"
#include "model/plain/snapshot.h"

#include <memory>

namespace autocuts {

//! The faces that --only names; null without it. Islands are those of the first UV set. Fails for names that
//! the scene does not have.
Result<std::shared_ptr<const JobScope>> batchScope(const CliOptions &options, const Scene &scene);

//! Cuts the charts in two where the border of the scope runs through them.
ChartMap chartsAlong(const JobScope &scope, ChartMap charts);

//! True when at least one chart lies in the scope as a whole.
[[nodiscard]] bool holdsWholeChart(const JobScope &scope, const ChartMap &charts);

} // namespace autocuts
