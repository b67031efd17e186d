// Reports on a batch: a table for spreadsheets, JSON for programs, a page for people.
#pragma once

#include "cli/manyfiles/runjournal.h"

namespace autocuts::manyfiles {

//! All that a report says. The results are in the order of the files.
struct RunReport
{
    ManyChoice choice;
    std::vector<FileResult> results;
    FileResults before; //!< of the run before; empty for none
    QString pictures;   //!< folder of the pictures; see FileRunner::pictureName()
};

//! A row for each file, comma-separated, with a heading.
QByteArray csvReport(const RunReport &report);
//! An object with "command", "files" as the journal has them, and how many there are of each status.
QByteArray jsonReport(const RunReport &report);
//! A page that needs no other file: what failed or has warnings first; figures that sort and filter, with the
//! difference to the run before.
QByteArray htmlReport(const RunReport &report);

//! How many results there are of each status.
std::map<QString, int> countsOf(const std::vector<FileResult> &results);

} // namespace autocuts::manyfiles
