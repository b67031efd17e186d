// The command `batch`: one command on many files.
#pragma once

#include "cli/clioptions.h"
#include "cli/stopsource.h"

#include <QTextStream>

namespace autocuts::manyfiles {

//! Runs the batch of the options. \pre there is an application object, options.many \param showProgress
//! false: err is no terminal, and gets a line for each file in place of one that changes \returns the exit
//! code: 0 all is done, 1 a file failed, 3 a bound was missed, 4 check found something, 130 interrupted
int runBatch(const CliOptions &options, StopSource &stop, bool showProgress, QTextStream &out,
             QTextStream &err);

} // namespace autocuts::manyfiles
