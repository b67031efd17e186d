#include "cli/clihelp.h"

#include "cli/clitable.h"

#include <algorithm>

namespace autocuts {

namespace {

using namespace Qt::Literals::StringLiterals;
using Output = CliCommand::Output;

constexpr int lineLength = 110;
constexpr int textColumn = 24;      //!< the column of the descriptions
constexpr int synopsisColumns = 30; //!< width of the column of synopses, including the gap after it

const QString sessions =
    u"IN and OUT may be sessions (.acproj). Of a session IN the cuts, joins, weights, pins, rectangles and "
    "settings are used; options that are given take the place of its settings."_s;
const QString severalFiles = u"Several inputs are done as by batch, each in a process of its own: -o is then "
                             u"the folder for the outputs, "
                             "which keep the names of the inputs, and --report a .csv, .json or .html file "
                             "about all of them. So is one "
                             "input where the folder after -o ends with a slash."_s;
const QString streams = u"Progress goes to stderr, results go to stdout."_s;

//! The arguments of a command, as its usage line shows them.
QString synopsis(const CliCommand &command)
{
    QString line = command.name + u' ' + command.operand + (command.takesFiles() ? u"..."_s : QString());
    if (command.output == Output::Needed)
        line += u" -o OUT"_s;
    else if (command.output == Output::Optional)
        line += u" [-o OUT]"_s;
    return command.groups ? line + u" [options]"_s : line;
}

//! The names of the commands that have an option.
QString commandsOf(const CliOption &option)
{
    QStringList names;
    for (const CliCommand &command : cliCommands()) {
        if (command.takes(option.group))
            names << command.name;
    }
    return names.size() == qsizetype(cliCommands().size()) ? u"all commands"_s : names.join(u", "_s);
}

QString withStandard(const CliOption &option)
{
    return option.standard.isEmpty() ? option.meaning : option.meaning + u" ["_s + option.standard + u']';
}

//! Appends a text, wrapped so that its lines begin at a column. The current line may already contain text.
void appendWrapped(QString &out, const QString &text, int column)
{
    qsizetype filled = out.size() - (out.lastIndexOf(u'\n') + 1);
    for (const QString &word : text.split(u' ')) {
        if (filled > column && filled + 1 + word.size() > lineLength) {
            out += u'\n';
            filled = 0;
        }
        const QString gap(filled > column ? 1 : column - filled, u' ');
        out += gap + word;
        filled += gap.size() + word.size();
    }
    out += u'\n';
}

//! Appends a row of two columns. After a long name, the text starts on a new line.
void appendRow(QString &out, const QString &name, const QString &text)
{
    out += u"  "_s + name;
    if (name.size() + 4 > textColumn)
        out += u'\n';
    appendWrapped(out, text, textColumn);
}

//! Escapes a text so that man prints all of its characters literally.
QString roff(QString text)
{
    return text.replace(u'\\', u"\\e"_s).replace(u'-', u"\\-"_s).replace(u'\'', u"\\(aq"_s);
}

QString bold(const QString &text)
{
    return u"\\fB"_s + roff(text) + u"\\fR"_s;
}

QString optionHeading(const CliOption &option, QString (*nameStyle)(const QString &))
{
    QStringList names;
    for (const QString &name : option.names)
        names << nameStyle(name);
    return names.join(u", "_s);
}

//! A code span for a table cell.
QString code(const QString &text)
{
    return u'`' + QString(text).replace(u'|', u"\\|"_s) + u'`';
}

QString usageOf(const CliCommand &command)
{
    QString out = u"usage: autocuts-cli "_s + synopsis(command) + u"\n\n"_s;
    appendWrapped(out, command.meaning, 0);
    out += u"\noptions:\n"_s;
    for (const CliOption &option : cliOptions()) {
        if (command.takes(option.group))
            appendRow(out, option.names.join(u", "_s) + u' ' + option.value, withStandard(option));
    }
    return out + u"\nautocuts-cli --help explains all commands and the exit codes.\n"_s;
}

} // namespace

QString usageText(CliOptions::Command command)
{
    const auto row = std::find_if(cliCommands().begin(), cliCommands().end(),
                                  [command](const CliCommand &one) { return one.id == command; });
    if (row != cliCommands().end())
        return usageOf(*row);
    QString out = u"Autocuts makes UV maps: cuts and distortion optimised together.\n\n"_s;
    QString start = u"usage: autocuts-cli "_s;
    for (const CliCommand &each : cliCommands()) {
        out += start + synopsis(each);
        appendWrapped(out, each.meaning, int(start.size()) + synopsisColumns);
        start = u"       autocuts-cli "_s;
    }
    out += start + u"--help | --version | --man-page | --markdown | --completion SHELL\n\n"_s;
    appendWrapped(out, sessions, 0);
    appendWrapped(out, severalFiles, 0);
    QString heading;
    for (const CliOption &option : cliOptions()) {
        if (commandsOf(option) != heading) {
            heading = commandsOf(option);
            out += u'\n';
            appendWrapped(out, heading + u':', 0);
        }
        appendRow(out, option.names.join(u", "_s) + u' ' + option.value, withStandard(option));
    }
    out += u"\nexit codes:\n"_s;
    for (const CliExitCode &exit : cliExitCodes())
        appendRow(out, QString::number(exit.code), exit.meaning);
    return out + u'\n' + streams + u'\n';
}

QString manualPage()
{
    QString out = u".\\\" Written by autocuts-cli --man-page.\n"
                  ".TH AUTOCUTS\\-CLI 1 \"\" Autocuts \"User Commands\"\n"
                  ".SH NAME\n"
                  "autocuts\\-cli \\- make, pack and check UV maps\n"
                  ".SH SYNOPSIS\n"_s;
    for (const CliCommand &command : cliCommands())
        out += bold(u"autocuts-cli"_s) + u' ' + roff(synopsis(command)) + u"\n.br\n"_s;
    out += bold(u"autocuts-cli"_s) + u' ' +
           roff(u"--help | --version | --man-page | --markdown | --completion SHELL"_s) + u'\n';
    out += u".SH DESCRIPTION\n"
           "Autocuts makes UV maps: cuts and distortion are optimised together.\n"_s +
           roff(sessions) + u'\n' + roff(severalFiles) + u'\n' + roff(streams) + u"\n.SH COMMANDS\n"_s;
    for (const CliCommand &command : cliCommands())
        out += u".TP\n"_s + bold(command.name) + u'\n' + roff(command.meaning) + u".\n"_s;
    out += u".SH OPTIONS\nDefaults are in brackets.\n"_s;
    QString heading;
    for (const CliOption &option : cliOptions()) {
        if (commandsOf(option) != heading) {
            heading = commandsOf(option);
            out += u".SS "_s + roff(heading) + u'\n';
        }
        out += u".TP\n"_s + optionHeading(option, bold);
        if (!option.value.isEmpty())
            out += u" \\fI"_s + roff(option.value) + u"\\fR"_s;
        out += u'\n' + roff(withStandard(option)) + u'\n';
    }
    out += u".SH EXIT STATUS\n"_s;
    for (const CliExitCode &exit : cliExitCodes())
        out += u".TP\n"_s + bold(QString::number(exit.code)) + u'\n' + roff(exit.meaning) + u'\n';
    return out;
}

QString markdownTables()
{
    QString out = u"| command | what it does |\n|---|---|\n"_s;
    for (const CliCommand &command : cliCommands())
        out +=
            u"| "_s + code(u"autocuts-cli "_s + synopsis(command)) + u" | "_s + command.meaning + u" |\n"_s;
    out += u"\n| option | commands | meaning [default] |\n|---|---|---|\n"_s;
    for (const CliOption &option : cliOptions()) {
        QString heading = optionHeading(option, code);
        if (!option.value.isEmpty())
            heading += u' ' + code(option.value);
        out +=
            u"| "_s + heading + u" | "_s + commandsOf(option) + u" | "_s + withStandard(option) + u" |\n"_s;
    }
    out += u"\n| exit code | meaning |\n|---|---|\n"_s;
    for (const CliExitCode &exit : cliExitCodes())
        out += u"| "_s + QString::number(exit.code) + u" | "_s + exit.meaning + u" |\n"_s;
    return out;
}

} // namespace autocuts
