#include "cli/commandline.h"

#include "cli/clicompletion.h"
#include "cli/clitable.h"
#include "cli/manyoptions.h"
#include "jobs/nearestname.h"
#include "jobs/presets.h"

#include <QThread>

#include <algorithm>
#include <map>

namespace autocuts {

namespace {

using Command = CliOptions::Command;

Error usageError(const QString &message)
{
    return Error{message, {}, 0, QStringLiteral("See autocuts-cli --help")};
}

//! Reads the arguments of one call by the tables of commands and options.
class Parser final
{
public:
    explicit Parser(const QStringList &arguments) : mArguments(arguments) {}

    Result<CliOptions> parse()
    {
        if (mArguments.isEmpty())
            return usageError(QStringLiteral("no command given"));
        const QString word = take();
        static const std::map<QString, Command> informing{{QStringLiteral("--help"), Command::Help},
                                                          {QStringLiteral("-h"), Command::Help},
                                                          {QStringLiteral("help"), Command::Help},
                                                          {QStringLiteral("--version"), Command::Version},
                                                          {QStringLiteral("--man-page"), Command::ManPage},
                                                          {QStringLiteral("--markdown"), Command::Markdown}};
        if (const auto found = informing.find(word); found != informing.end()) {
            mOptions.command = found->second;
            return mOptions;
        }
        if (word == QLatin1String("--completion")) {
            mOptions.command = Command::Completion;
            mOptions.input = atEnd() ? QString() : take();
            if (!completionShells().contains(mOptions.input))
                return usageError(QStringLiteral("--completion takes %1")
                                      .arg(completionShells().join(QStringLiteral(" or "))));
            return mOptions;
        }
        auto command = commandNamed(word);
        if (command == cliCommands().end())
            return unknownCommand(word);
        if (command->id == Command::Batch) {
            if (atEnd())
                return usageError(QStringLiteral("batch needs a command for its files"));
            const QString each = take();
            if (each == QLatin1String("--help") || each == QLatin1String("-h")) {
                mOptions.each = Command::Batch;
                return mOptions;
            }
            command = commandNamed(each);
            if (command == cliCommands().end())
                return unknownCommand(each);
            if (!command->takesFiles())
                return usageError(QStringLiteral("batch cannot do \"%1\"").arg(each));
            mOptions.many.emplace().command = each;
        }
        mOptions.command = mOptions.each = command->id;
        mOptions.threads = std::max(1, QThread::idealThreadCount());
        if (const Problem problem = takePresets(*command))
            return *problem;
        while (!atEnd()) {
            const QString argument = take();
            if (!mOptionsEnded && argument == QLatin1String("--"))
                mOptionsEnded = true;
            else if (const Problem problem = readArgument(*command, argument))
                return *problem;
        }
        if (mOptions.command == Command::Help)
            return mOptions;
        if (const Problem problem = takeInputs(*command))
            return *problem;
        if (mOptions.showSettings) {
            mOptions.settingsText = settingsOf(*command);
            mOptions.command = Command::Settings;
            mOptions.many.reset(); // the same for all inputs
            return mOptions;
        }
        if (const Problem problem = finish(*command))
            return *problem;
        if (mOptions.many)
            mOptions.command = Command::Batch;
        return mOptions;
    }

private:
    using Problem = std::optional<Error>;

    static std::vector<CliCommand>::const_iterator commandNamed(const QString &name)
    {
        return std::find_if(cliCommands().begin(), cliCommands().end(),
                            [&](const CliCommand &row) { return row.name == name; });
    }

    static Error unknownCommand(const QString &word)
    {
        QStringList names;
        for (const CliCommand &row : cliCommands())
            names << row.name;
        return usageError(QStringLiteral("unknown command \"%1\"").arg(word) + didYouMean(word, names));
    }

    bool takes(const CliCommand &command, const CliOption &option) const
    {
        return command.takes(option.group) || (mOptions.many && (option.group == OptionGroup::Batching ||
                                                                 option.group == OptionGroup::Output));
    }

    bool atEnd() const { return mNext >= mArguments.size(); }
    QString take() { return mArguments[mNext++]; }

    Problem readArgument(const CliCommand &command, const QString &argument)
    {
        if (mOptionsEnded || !argument.startsWith(QLatin1Char('-')) || argument == QLatin1String("-")) {
            if (!command.takesFiles() && !mInputs.isEmpty())
                return usageError(QStringLiteral("one name only, but \"%1\" follows \"%2\"")
                                      .arg(argument, mInputs.first()));
            mInputs << argument;
            return std::nullopt;
        }
        if (argument == QLatin1String("--help") || argument == QLatin1String("-h")) {
            mOptions.command = Command::Help;
            return std::nullopt;
        }
        return readOption(command, argument);
    }

    //! Several files are a batch, and one whose output goes into a folder.
    Problem takeInputs(const CliCommand &command)
    {
        for (QString *path : {&mOptions.output, &mOptions.layout, &mOptions.report})
            *path = nameOfFile(*path);
        for (QString &path : mInputs)
            path = nameOfFile(path);
        mOptions.input = mInputs.value(0);
        const bool isBatch = mOptions.many.has_value();
        if (!isBatch && (!command.takesFiles() || (mInputs.size() < 2 && !namesFolder())))
            return std::nullopt;
        ManyChoice &many = isBatch ? *mOptions.many : mOptions.many.emplace();
        many.command = command.name;
        many.inputs = mInputs;
        many.passed = mPassed;
        if (many.format.isEmpty())
            many.format = mOptions.outputFormat;
        if (isBatch || mOptions.report.isEmpty())
            return std::nullopt;
        if (const std::optional<QString> expected = readManyReport(mOptions, mOptions.report))
            return usageError(QStringLiteral("--report takes %1 of several inputs, not \"%2\"")
                                  .arg(*expected, mOptions.report));
        return std::nullopt;
    }

    //! Qt takes what begins with a colon for a resource of the program.
    static QString nameOfFile(const QString &path)
    {
        return path.startsWith(QLatin1Char(':')) ? QStringLiteral("./") + path : path;
    }

    bool namesFolder() const { return !makesFiles() && mOptions.output.endsWith(QLatin1Char('/')); }
    //! True when -o of one input is a folder.
    bool makesFiles() const { return mOptions.command == Command::Bake || !mOptions.textures.isEmpty(); }

    //! Options of several groups may share a name: the one that the command takes, if there is one.
    std::vector<CliOption>::const_iterator optionNamed(const CliCommand &command, const QString &name) const
    {
        return std::find_if(cliOptions().begin(), cliOptions().end(), [&](const CliOption &row) {
            return row.names.contains(name) && takes(command, row);
        });
    }

    static bool isKnown(const QString &name)
    {
        return std::any_of(cliOptions().begin(), cliOptions().end(),
                           [&](const CliOption &row) { return row.names.contains(name); });
    }

    //! Takes the options of all presets that are named.
    Problem takePresets(const CliCommand &command)
    {
        static const QString option = QStringLiteral("--preset");
        for (qsizetype i = mNext; i < mArguments.size() && mArguments[i] != QLatin1String("--"); ++i) {
            QString name;
            if (mArguments[i] == option && i + 1 < mArguments.size())
                name = mArguments[i + 1];
            else if (mArguments[i].startsWith(option + QLatin1Char('=')))
                name = mArguments[i].mid(option.size() + 1);
            if (name.isEmpty())
                continue;
            const Result<Preset> preset = readPreset(name);
            if (!preset)
                return preset.error();
            for (const PresetOption &row : preset->options) {
                if (Problem problem = takePresetOption(command, row, preset->path))
                    return problem;
            }
        }
        return std::nullopt;
    }

    Problem takePresetOption(const CliCommand &command, const PresetOption &given, const QString &path)
    {
        const auto wrong = [&](const QString &message) {
            return Error{message, path, given.line, QStringLiteral("See autocuts-cli --help")};
        };
        if (!isKnown(given.name)) {
            QStringList names;
            for (const CliOption &row : cliOptions())
                names += row.names;
            return wrong(QStringLiteral("unknown option \"%1\"").arg(given.name.mid(2)) +
                         didYouMean(given.name, names));
        }
        const auto option = optionNamed(command, given.name);
        if (option == cliOptions().end())
            return std::nullopt; // of another command
        if (option->value.isEmpty() != given.value.isEmpty())
            return wrong(QStringLiteral("%1 %2").arg(given.name, given.value.isEmpty()
                                                                     ? QStringLiteral("needs a value")
                                                                     : QStringLiteral("takes no value")));
        if (const std::optional<QString> expected = option->read(mOptions, given.value))
            return wrong(QStringLiteral("%1 takes %2, not \"%3\"").arg(given.name, *expected, given.value));
        note(*option, given.value);
        return std::nullopt;
    }

    //! Keeps what was given, the last value of each option.
    void note(const CliOption &option, const QString &value)
    {
        mOptions.given << option.names.first();
        mValues[option.names.first()] = value;
    }

    //! What was given, and the defaults of the rest, as a preset.
    QString settingsOf(const CliCommand &command) const
    {
        QString text;
        for (const CliOption &row : cliOptions()) {
            const QString name = row.names.first();
            if (!name.startsWith(QLatin1String("--")) || !takes(command, row) ||
                name == QLatin1String("--preset") || name == QLatin1String("--show-settings"))
                continue;
            const auto given = mValues.find(name);
            const QString value = given == mValues.end() ? row.standard : given->second;
            CliOptions tried; // some defaults are told in words
            if (given == mValues.end() && (value.isEmpty() || row.read(tried, value)))
                continue;
            text += name.mid(2) + (row.value.isEmpty() ? QString() : QStringLiteral(" = ") + value) +
                    QLatin1Char('\n');
        }
        return text;
    }

    //! "--name", "--name value" or "--name=value".
    Problem readOption(const CliCommand &command, const QString &argument)
    {
        const qsizetype equals =
            argument.startsWith(QLatin1String("--")) ? argument.indexOf(QLatin1Char('=')) : -1;
        const QString name = argument.left(equals);
        const auto option = optionNamed(command, name);
        if (option == cliOptions().end()) {
            if (isKnown(name))
                return usageError(QStringLiteral("%1 does not belong to this command").arg(name) +
                                  ofBatch(command, name));
            QStringList names;
            for (const CliOption &row : cliOptions())
                names += takes(command, row) ? row.names : QStringList();
            return usageError(QStringLiteral("unknown option %1").arg(name) + didYouMean(name, names));
        }
        QString value;
        if (option->value.isEmpty()) {
            if (equals >= 0)
                return usageError(QStringLiteral("%1 takes no value").arg(name));
        } else if (equals >= 0) {
            value = argument.mid(equals + 1);
        } else if (atEnd() || mArguments[mNext].startsWith(QLatin1String("--"))) {
            // An option in place of the value was hardly meant as the name of a file.
            return usageError(QStringLiteral("%1 needs a value").arg(name));
        } else {
            value = take();
        }
        note(*option, value);
        if (const std::optional<QString> expected = option->read(mOptions, value))
            return usageError(QStringLiteral("%1 takes %2, not \"%3\"").arg(name, *expected, value));
        static const QStringList ofAllFiles{QStringLiteral("--progress"), QStringLiteral("--dry-run"),
                                            QStringLiteral("--json"), QStringLiteral("--report"),
                                            QStringLiteral("--quiet")};
        if (option->group != OptionGroup::Batching && option->group != OptionGroup::Output &&
            !ofAllFiles.contains(name))
            mPassed << (option->value.isEmpty() ? name : name + QLatin1Char('=') + value);
        return std::nullopt;
    }

    //! Where an option is that of a batch, how it is given.
    static QString ofBatch(const CliCommand &command, const QString &name)
    {
        const bool isOfBatch =
            std::any_of(cliOptions().begin(), cliOptions().end(), [&](const CliOption &row) {
                return row.group == OptionGroup::Batching && row.names.contains(name);
            });
        return isOfBatch && command.takesFiles() ? QStringLiteral(", but to \"batch %1\"").arg(command.name)
                                                 : QString();
    }

    //! What concerns several options.
    Problem finish(const CliCommand &command)
    {
        if (mOptions.input.isEmpty())
            return usageError(mOptions.command == Command::Sample ? QStringLiteral("no sample named")
                                                                  : QStringLiteral("no input file given"));
        if (mOptions.many && mOptions.output.isEmpty() && command.output == CliCommand::Output::Needed)
            return usageError(QStringLiteral("no output folder given (-o DIR)"));
        const bool keepsJournal =
            mOptions.many && (mOptions.many->resume || mOptions.many->parts > 0 || mOptions.many->elsewhere);
        if (keepsJournal && mOptions.output.isEmpty() && mOptions.many->journal.isEmpty())
            return usageError(QStringLiteral("no folder given for the journal (--journal DIR)"));
        if (command.output == CliCommand::Output::Needed && mOptions.output.isEmpty())
            return usageError(QStringLiteral("no output file given (-o FILE)"));
        if (mOptions.output == QLatin1String("-") && (mOptions.many || makesFiles()))
            return usageError(QStringLiteral("several files are made, which need a folder in place of -"));
        if (mOptions.many && mOptions.many->inputs.contains(QLatin1String("-")))
            return usageError(QStringLiteral("several inputs are files, not standard input"));
        if (mOptions.output == QLatin1String("-") && mOptions.report == QLatin1String("-"))
            return usageError(QStringLiteral("-o and --report cannot both go to standard output"));
        if (mOptions.many && !mOptions.layout.isEmpty())
            return usageError(
                QStringLiteral("--layout names one file; the .html report on several files has pictures"));
        if (mOptions.many && mOptions.command == Command::Convert && mOptions.many->format.isEmpty())
            return usageError(QStringLiteral("conversions of several files need --output-format"));
        if (mOptions.given.contains(QStringLiteral("--max-distortion")) && mOptions.unwrap.lambda)
            return usageError(QStringLiteral("--max-distortion and --lambda exclude each other"));
        if (mOptions.command == Command::Lightmap && mOptions.newUvSet.isEmpty())
            mOptions.newUvSet = QStringLiteral("Lightmap");
        if (mOptions.command == Command::Transfer && mOptions.from.isEmpty() &&
            mOptions.fromUvSet.isEmpty() && mOptions.fromObject.isEmpty())
            return usageError(QStringLiteral("transfer needs --from, --from-uv-set or --from-object"));
        packing::PackOptions &packing = mOptions.unwrap.packing;
        if (packing.margin >= packing.shorterSide())
            return usageError(QStringLiteral("the margin of %1 texels is as wide as the whole texture of %2")
                                  .arg(packing.margin)
                                  .arg(packing.shorterSide()));
        if (mOptions.given.contains(QStringLiteral("--border")) && mOptions.only.isEmpty())
            return usageError(QStringLiteral("--border says how --only ends, which is not given"));
        if (mOptions.hasRectangle() && mOptions.given.contains(QStringLiteral("--tile")))
            return usageError(QStringLiteral("--into and --tile exclude each other"));
        if (mOptions.per && (mOptions.hasRectangle() || !mOptions.unwrap.pack))
            return usageError(QStringLiteral("--per packs into tiles: it excludes --into and --no-pack"));
        if (const Problem problem = checkTiling())
            return problem;
        if (!mOptions.hasRectangle())
            mOptions.packIntoTile();
        packing.seed = mOptions.settings.seed;
        return std::nullopt;
    }

    Problem checkTiling() const
    {
        if (mOptions.density > 0 && (mOptions.per || mOptions.hasRectangle() ||
                                     mOptions.unwrap.packing.keepScale || !mOptions.unwrap.pack))
            return usageError(QStringLiteral("--density excludes --per, --into, --keep-scale and --no-pack"));
        if (mOptions.fillTiles && (mOptions.per || mOptions.hasRectangle()))
            return usageError(QStringLiteral("--fill-tiles excludes --per and --into"));
        if (mOptions.oneTile && (mOptions.per || mOptions.density > 0 || mOptions.fillTiles))
            return usageError(QStringLiteral("--tiles one excludes --per, --density and --fill-tiles"));
        return std::nullopt;
    }

    const QStringList &mArguments;
    qsizetype mNext = 0;
    bool mOptionsEnded = false; //!< by "--"
    QStringList mInputs;
    QStringList mPassed;                //!< what each of several files gets, as it was given
    std::map<QString, QString> mValues; //!< of the options that were given, by their first names
    CliOptions mOptions;
};

} // namespace

bool canBeStopped(const CliOptions &options)
{
    return options.command == Command::Batch ||
           std::any_of(cliCommands().begin(), cliCommands().end(), [&options](const CliCommand &row) {
               return row.id == options.command && row.takes(OptionGroup::Limiting);
           });
}

Result<CliOptions> parseCommandLine(const QStringList &arguments)
{
    return Parser(arguments).parse();
}

} // namespace autocuts
