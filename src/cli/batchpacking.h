// Packing as the command line does it.
#pragma once

#include "cli/batchfiles.h"
#include "cli/progressline.h"
#include "cli/stopsource.h"
#include "model/plain/chart.h"

namespace autocuts {

//! Packs into the tile or the rectangle that the options name, by the locks, stacks and groups of the
//! session.
class BatchPacking final
{
public:
    BatchPacking(const CliOptions &options, const BatchFiles &files, StopSource &stop, ProgressLine &progress)
        : mOptions(options), mFiles(files), mStop(stop), mProgress(progress)
    {}

    //! When a stop was requested before there was a layout, a quick one is made all the same.
    //! \param uv one row per corner; changed when all went well
    Result<Done> pack(const MeshData &mesh, const ChartMap &charts, UvMatrix &uv);
    Error noRoom() const;

private:
    const CliOptions &mOptions;
    const BatchFiles &mFiles;
    StopSource &mStop;
    ProgressLine &mProgress;
};

} // namespace autocuts
