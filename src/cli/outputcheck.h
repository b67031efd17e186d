// Checks before the work that all outputs can be written and overwrite nothing that is read.
#pragma once

#include "cli/clioptions.h"
#include "model/document/documentstate.h"

namespace autocuts {

//! Checks that a file can be written, as far as that can be known without writing it.
Result<Done> checkOutputFile(const QString &path);

//! Checks the folders and names of the outputs that the options name.
Result<Done> checkTargets(const CliOptions &options);

//! All files and folders that the options name.
QStringList namedFiles(const CliOptions &options);

//! An Error when an output is a file that the model was read from, or another output. The file of the input
//! may be written again as a model of its own format.
Result<Done> checkClashes(const CliOptions &options, const DocumentState &model);

//! The files that a command must not replace by its pictures.
QStringList keptFiles(const CliOptions &options, const DocumentState &model);

} // namespace autocuts
