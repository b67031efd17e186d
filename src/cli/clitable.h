// The commands, options and exit codes of the command line: one table that the parser, the help, the manual
// page and the README read.
#pragma once

#include "cli/clioptions.h"

#include <QFlags>

#include <functional>
#include <optional>
#include <vector>

namespace autocuts {

//! Options that belong together: a command takes whole groups.
enum class OptionGroup {
    Output = 1,      //!< the file to write
    Bound = 256,     //!< how much distortion is allowed
    Solving = 2,     //!< how seams and distortion are found
    Texture = 4,     //!< the texture that texel figures refer to
    Packing = 8,     //!< how islands are arranged
    Placing = 16,    //!< where, and whether they may be scaled
    Making = 32,     //!< for all that makes a map and may take long: limits, reports
    Measuring = 64,  //!< how figures are printed
    Everything = 128 //!< for all commands
};
Q_DECLARE_FLAGS(OptionGroups, OptionGroup)
Q_DECLARE_OPERATORS_FOR_FLAGS(OptionGroups)

//! A command as the user knows it.
struct CliCommand
{
    enum class Output { None, Optional, Needed };

    CliOptions::Command id;
    QString name;
    QString operand; //!< what the usage line calls the input
    Output output;
    OptionGroups groups; //!< those that not every command takes
    QString meaning;

    bool takes(OptionGroup group) const
    {
        return group == OptionGroup::Everything || groups.testFlag(group) ||
               (group == OptionGroup::Output && output != Output::None);
    }
};

//! An option as the user knows it, and how it is read.
struct CliOption
{
    //! Puts a value into the options. Returns what is expected instead when it is no good ("a number from 0
    //! to 1"), and then leaves the options as they are. The value is empty for options that take none.
    using Reader = std::function<std::optional<QString>(CliOptions &, const QString &value)>;

    OptionGroup group;
    QStringList names;
    QString value; //!< what stands for the value in texts; empty when the option takes none
    QString meaning;
    QString standard; //!< the value when the option is not given; empty where the meaning says it
    Reader read;
};

//! How the program ends.
struct CliExitCode
{
    int code;
    QString meaning;
};

const std::vector<CliCommand> &cliCommands();
//! Options of the same group stand together.
const std::vector<CliOption> &cliOptions();
const std::vector<CliExitCode> &cliExitCodes();

} // namespace autocuts
