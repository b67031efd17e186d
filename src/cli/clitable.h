// The table of commands, options and exit codes, used by the parser, the help, the manual page and the
// README.
#pragma once

#include "cli/clioption.h"

#include <vector>

namespace autocuts {

//! A command of the program.
struct CliCommand
{
    enum class Output { None, Optional, Needed };

    CliOptions::Command id;
    QString name;
    QString operand; //!< the input in the usage line
    Output output;
    OptionGroups groups; //!< without the groups that every command has
    QString meaning;

    //! True when the inputs are files, so that there may be several of them.
    bool takesFiles() const { return id != CliOptions::Command::Sample && id != CliOptions::Command::Batch; }
    bool takes(OptionGroup group) const
    {
        return group == OptionGroup::Everything || groups.testFlag(group) ||
               (group == OptionGroup::Output && output != Output::None);
    }
};

//! An exit code of the program.
struct CliExitCode
{
    int code;
    QString meaning;
};

const std::vector<CliCommand> &cliCommands();
//! All options; those of one group follow each other.
const std::vector<CliOption> &cliOptions();
const std::vector<CliExitCode> &cliExitCodes();

} // namespace autocuts
