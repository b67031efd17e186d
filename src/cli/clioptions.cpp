#include "cli/clioptions.h"

#include "solver/packing/packmap.h"

#include <QThread>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace autocuts {

namespace {

using Command = CliOptions::Command;

Error usageError(const QString &message)
{
    return Error{message, {}, 0, QStringLiteral("See autocuts-cli --help")};
}

//! Walks through the arguments; value() takes the one that an option needs.
class Arguments
{
public:
    explicit Arguments(const QStringList &list) : mList(list) {}

    bool atEnd() const { return mNext >= mList.size(); }
    QString take() { return mList[mNext++]; }

    //! "--name=value" or the next argument.
    Result<QString> value(const QString &option)
    {
        if (!mInline.isNull())
            return std::exchange(mInline, QString());
        // An option in place of the value was hardly meant as the name of a file.
        if (atEnd() || mList[mNext].startsWith(QLatin1String("--")))
            return usageError(QStringLiteral("%1 needs a value").arg(option));
        return take();
    }
    //! Splits "--name=value" and keeps the value for value().
    QString optionName(const QString &argument)
    {
        const qsizetype equals = argument.indexOf(QLatin1Char('='));
        if (!argument.startsWith(QLatin1String("--")) || equals < 0)
            return argument;
        mInline = argument.mid(equals + 1);
        return argument.left(equals);
    }
    bool hasUnusedValue() const { return !mInline.isNull(); }

private:
    const QStringList &mList;
    qsizetype mNext = 0;
    QString mInline;
};

class Parser
{
public:
    explicit Parser(const QStringList &arguments) : mArguments(arguments) { declareOptions(); }

    Result<CliOptions> parse()
    {
        if (mArguments.atEnd())
            return usageError(QStringLiteral("no command given"));
        const QString word = mArguments.take();
        if (word == QLatin1String("--help") || word == QLatin1String("-h") || word == QLatin1String("help"))
            return mOptions;
        if (word == QLatin1String("--version")) {
            mOptions.command = Command::Version;
            return mOptions;
        }
        static const std::map<QString, Command> commands{
            {QStringLiteral("unwrap"), Command::Unwrap},     {QStringLiteral("pack"), Command::Pack},
            {QStringLiteral("separate"), Command::Separate}, {QStringLiteral("check"), Command::Check},
            {QStringLiteral("convert"), Command::Convert},   {QStringLiteral("sample"), Command::Sample},
            {QStringLiteral("replay"), Command::Replay}};
        const auto command = commands.find(word);
        if (command == commands.end())
            return usageError(QStringLiteral("unknown command \"%1\"").arg(word));
        mOptions.command = command->second;
        mOptions.unwrap.threads = std::max(1, QThread::idealThreadCount());
        while (!mArguments.atEnd()) {
            if (const auto error = parseArgument(mArguments.take()))
                return *error;
        }
        return finish();
    }

private:
    using Problem = std::optional<Error>;
    struct Option
    {
        std::vector<Command> commands;
        std::function<Problem(const QString &name)> read;
    };

    void declareOptions()
    {
        const std::vector<Command> unwrap{Command::Unwrap};
        const std::vector<Command> writing{Command::Unwrap,  Command::Pack,   Command::Separate,
                                           Command::Convert, Command::Sample, Command::Replay};
        const std::vector<Command> mapping{Command::Unwrap, Command::Pack, Command::Separate};
        const std::vector<Command> measuring{Command::Unwrap, Command::Pack, Command::Separate,
                                             Command::Check};
        unwrap::UnwrapOptions &u = mOptions.unwrap;
        add("-o", writing, text(mOptions.output));
        add("--output", writing, text(mOptions.output));
        add("--max-distortion", unwrap, [this, &u](const QString &name) {
            mBoundGiven = true;
            return number(u.maxDistortion, 4.0001, 1e6)(name);
        });
        add("--lambda", unwrap, [this, &u](const QString &name) {
            double lambda = 0;
            const Problem problem = number(lambda, 0, 1)(name);
            u.lambda = lambda;
            return problem;
        });
        add("--init", unwrap,
            choice(mOptions.settings.start, {{"rigid", StartMode::Rigid},
                                             {"tutte", StartMode::Tutte},
                                             {"random", StartMode::Random},
                                             {"uv", StartMode::ExistingUv}}));
        add("--weights", unwrap,
            choice(mOptions.settings.weighting,
                   {{"length", SeamWeighting::Length}, {"count", SeamWeighting::Count}}));
        add("--energy", unwrap,
            choice(mOptions.settings.energy, {{"symmetric-dirichlet", DistortionEnergy::SymmetricDirichlet},
                                              {"amips", DistortionEnergy::Amips}}));
        add("--solver", unwrap,
            choice(mOptions.settings.solver, {{"fast", SolverKind::Fast}, {"exact", SolverKind::Exact}}));
        add("--creases", unwrap,
            choice(mOptions.settings.creases,
                   {{"off", CreaseMode::Off}, {"auto", CreaseMode::Auto}, {"on", CreaseMode::On}}));
        add("--crease-strength", unwrap, number(mOptions.settings.creaseStrength, 0, 1));
        add("--visibility", unwrap, number(mOptions.settings.visibility, 0, 1));
        add("--symmetry", unwrap, flag(mOptions.settings.symmetry, true));
        add("--quality", unwrap,
            choice(u.quality, {{"draft", unwrap::UnwrapQuality::Draft},
                               {"standard", unwrap::UnwrapQuality::Standard},
                               {"best", unwrap::UnwrapQuality::Best}}));
        add("--allow-overlaps", unwrap, flag(u.allowOverlaps, true));
        add("--no-pack", unwrap, flag(u.pack, false));
        add("--texture-size", measuring, integer(u.packing.textureSize, 16, 65536));
        add("--margin", mapping, number(u.packing.margin, 0, 4096));
        add("--rotation", mapping,
            choice(
                u.packing.rotation,
                {{"free", PackRotation::Free}, {"90", PackRotation::Quarter}, {"none", PackRotation::None}}));
        add("--pack-time", mapping, number(u.packing.effort, 0, 3600));
        add("--keep-scale", {Command::Pack}, flag(u.packing.keepScale, true));
        add("--tile", mapping,
            integer(u.packing.udimTile, PackingSettings::firstTile, PackingSettings::lastTile));
        add("--into", {Command::Pack}, [this](const QString &name) { return readRectangle(name); });
        add("--layout", mapping, text(mOptions.layout));
        add("--report", mapping, text(mOptions.report));
        add("--threads", mapping, integer(u.threads, 1, 1024));
        add("--time-limit", mapping, number(mOptions.timeLimit, 0.001, 1e9));
        add("--seed", mapping, [this](const QString &name) {
            int seed = 0;
            const Problem problem = integer(seed, 0, 2'000'000'000)(name);
            mOptions.settings.seed = mOptions.unwrap.packing.seed = static_cast<unsigned>(seed);
            return problem;
        });
        add("--json", {Command::Check}, flag(mOptions.json, true));
        add("--quiet", {}, flag(mOptions.quiet, true));
    }

    void add(const char *name, std::vector<Command> commands, std::function<Problem(const QString &)> read)
    {
        mDeclared[QLatin1String(name)] = {std::move(commands), std::move(read)};
    }

    std::function<Problem(const QString &)> text(QString &target)
    {
        return [this, &target](const QString &name) -> Problem {
            const Result<QString> value = mArguments.value(name);
            if (!value)
                return value.error();
            target = value.value();
            return std::nullopt;
        };
    }

    std::function<Problem(const QString &)> flag(bool &target, bool value)
    {
        return [&target, value](const QString &) -> Problem {
            target = value;
            return std::nullopt;
        };
    }

    std::function<Problem(const QString &)> number(double &target, double low, double high)
    {
        return [this, &target, low, high](const QString &name) -> Problem {
            const Result<QString> value = mArguments.value(name);
            if (!value)
                return value.error();
            bool ok = false;
            const double parsed = value.value().toDouble(&ok);
            if (!ok || !(parsed >= low && parsed <= high))
                return usageError(QStringLiteral("%1 takes a number from %2 to %3, not \"%4\"")
                                      .arg(name)
                                      .arg(low)
                                      .arg(high)
                                      .arg(value.value()));
            target = parsed;
            return std::nullopt;
        };
    }

    std::function<Problem(const QString &)> integer(int &target, int low, int high)
    {
        return [this, &target, low, high](const QString &name) -> Problem {
            const Result<QString> value = mArguments.value(name);
            if (!value)
                return value.error();
            bool ok = false;
            const int parsed = value.value().toInt(&ok);
            if (!ok || parsed < low || parsed > high)
                return usageError(QStringLiteral("%1 takes a whole number from %2 to %3, not \"%4\"")
                                      .arg(name)
                                      .arg(low)
                                      .arg(high)
                                      .arg(value.value()));
            target = parsed;
            return std::nullopt;
        };
    }

    template <class T>
    std::function<Problem(const QString &)> choice(T &target, std::vector<std::pair<const char *, T>> words)
    {
        return [this, &target, words = std::move(words)](const QString &name) -> Problem {
            const Result<QString> value = mArguments.value(name);
            if (!value)
                return value.error();
            QStringList known;
            for (const auto &[word, meaning] : words) {
                if (value.value() == QLatin1String(word)) {
                    target = meaning;
                    return std::nullopt;
                }
                known << QLatin1String(word);
            }
            return usageError(QStringLiteral("%1 takes %2, not \"%3\"")
                                  .arg(name, known.join(QStringLiteral(" or ")), value.value()));
        };
    }

    //! Four numbers, or the name of a rectangle.
    Problem readRectangle(const QString &name)
    {
        const Result<QString> value = mArguments.value(name);
        if (!value)
            return value.error();
        const QStringList parts = value.value().split(QLatin1Char(','));
        bool allNumbers = parts.size() == 4;
        std::vector<double> sides;
        for (const QString &part : parts) {
            bool ok = false;
            sides.push_back(part.toDouble(&ok));
            allNumbers = allNumbers && ok;
        }
        if (!allNumbers) {
            mOptions.intoRectangle = value.value();
            return std::nullopt;
        }
        constexpr double farthest = 1000;
        const bool inRange =
            std::all_of(sides.begin(), sides.end(), [](double side) { return std::abs(side) <= farthest; });
        if (!inRange || !(sides[0] < sides[2]) || !(sides[1] < sides[3]))
            return usageError(QStringLiteral("%1 takes left,bottom,right,top in UV units, not \"%2\"")
                                  .arg(name, value.value()));
        mOptions.unwrap.packing.lower = {sides[0], sides[1]};
        mOptions.unwrap.packing.upper = {sides[2], sides[3]};
        return std::nullopt;
    }

    Problem parseArgument(const QString &argument)
    {
        if (!argument.startsWith(QLatin1Char('-')) || argument == QLatin1String("-")) {
            if (!mOptions.input.isEmpty())
                return usageError(QStringLiteral("one input only, but \"%1\" follows \"%2\"")
                                      .arg(argument, mOptions.input));
            mOptions.input = argument;
            return std::nullopt;
        }
        if (argument == QLatin1String("--help") || argument == QLatin1String("-h")) {
            mOptions.command = Command::Help;
            return std::nullopt;
        }
        const QString name = mArguments.optionName(argument);
        const auto option = mDeclared.find(name);
        if (option == mDeclared.end())
            return usageError(QStringLiteral("unknown option %1").arg(name));
        const auto &commands = option->second.commands;
        if (!commands.empty() &&
            std::find(commands.begin(), commands.end(), mOptions.command) == commands.end())
            return usageError(QStringLiteral("%1 does not belong to this command").arg(name));
        mOptions.given << name;
        if (const Problem problem = option->second.read(name))
            return problem;
        if (mArguments.hasUnusedValue())
            return usageError(QStringLiteral("%1 takes no value").arg(name));
        return std::nullopt;
    }

    Result<CliOptions> finish()
    {
        if (mOptions.command == Command::Help)
            return mOptions;
        if (mOptions.input.isEmpty())
            return usageError(mOptions.command == Command::Sample ? QStringLiteral("no sample named")
                                                                  : QStringLiteral("no input file given"));
        const bool isOutputOptional =
            mOptions.command == Command::Check || mOptions.command == Command::Replay;
        if (!isOutputOptional && mOptions.output.isEmpty())
            return usageError(QStringLiteral("no output file given (-o FILE)"));
        if (!mOptions.layout.isEmpty() &&
            !mOptions.layout.endsWith(QLatin1String(".png"), Qt::CaseInsensitive) &&
            !mOptions.layout.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive))
            return usageError(
                QStringLiteral("--layout takes a .png or .svg file, not \"%1\"").arg(mOptions.layout));
        if (mBoundGiven && mOptions.unwrap.lambda)
            return usageError(QStringLiteral("--max-distortion and --lambda exclude each other"));
        const packing::PackOptions &packing = mOptions.unwrap.packing;
        if (packing.margin >= packing.textureSize)
            return usageError(QStringLiteral("the margin of %1 texels is as wide as the whole texture of %2")
                                  .arg(packing.margin)
                                  .arg(packing.textureSize));
        if (mOptions.hasRectangle() && mOptions.given.contains(QStringLiteral("--tile")))
            return usageError(QStringLiteral("--into and --tile exclude each other"));
        if (!mOptions.hasRectangle())
            mOptions.packIntoTile();
        mOptions.unwrap.packing.threads = mOptions.unwrap.threads;
        return mOptions;
    }

    Arguments mArguments;
    CliOptions mOptions;
    bool mBoundGiven = false;
    std::map<QString, Option> mDeclared;
};

} // namespace

void CliOptions::packIntoTile()
{
    const packing::PackOptions tile = packing::tileOptions(unwrap.packing);
    unwrap.packing.lower = tile.lower;
    unwrap.packing.upper = tile.upper;
}

Result<CliOptions> parseCommandLine(const QStringList &arguments)
{
    return Parser(arguments).parse();
}

QString usageText()
{
    return QStringLiteral(R"(Autocuts makes UV maps: cuts and distortion optimised together.

usage: autocuts-cli unwrap IN -o OUT [options]     make a UV map
       autocuts-cli pack IN -o OUT [options]       lay the islands out anew
       autocuts-cli separate IN -o OUT [options]   cut islands that cover themselves, then pack
       autocuts-cli check IN [--json]              measure a UV map and say what is wrong with it
       autocuts-cli convert IN -o OUT              another file format; OBJ to OBJ changes nothing
       autocuts-cli replay SESSION [-o OUT]        do again what was done in a session, and compare
       autocuts-cli sample NAME -o OUT             write a sample: bumpycube, character, torus, machine

IN and OUT may be sessions (.acproj). Of IN, cuts, joins, weights, pins, rectangles and settings are used;
options that are given take the place of the session's settings.

unwrap:
  --max-distortion X   bound on the mean symmetric Dirichlet energy; 4 is no distortion [4.1]
  --lambda X           a fixed balance in [0, 1] in place of the bound: 0 cuts freely, 1 hardly
  --init MODE          start from rigid, tutte, random or uv (the file's own) [rigid]
  --weights MODE       minimise the length of the seams, or their count [length]
  --energy MODE        symmetric-dirichlet or amips (conformal) [symmetric-dirichlet]
  --no-pack            leave the islands where the solver put them, scaled to the unit square
  --allow-overlaps     do not cut islands that cover themselves
  --solver MODE        fast or exact [fast]
  --quality MODE       draft, standard or best [standard]
  --creases MODE       seams along sharp edges: off, on, or auto (on meshes that have creases) [auto]
  --crease-strength X  part of its cost that a seam on a sharp edge saves, 0 to 1 [0.8]
  --visibility X       seams rather where they are hidden, 0 (no matter) to 1 [0]
  --symmetry           symmetric cuts on symmetric meshes
unwrap, pack, separate:
  --texture-size N     texels along each side of the unit square; also for check [2048]
  --margin N           texels between islands, half of it to the border [8]
  --rotation MODE      turns that packing may make: free, 90 or none [free]
  --tile N             UDIM tile to pack into: 1001 is the unit square, ten tiles in a row [1001]
  --into RECTANGLE     pack only, in place of a tile: left,bottom,right,top in UV units, or the name of a
                       rectangle of the session, whose islands are packed while the others stay
  --keep-scale         pack only: keep the size of the islands
  --pack-time SECONDS  effort that goes into packing [0.5]
  --layout FILE        picture of the layout, .png or .svg
  --report FILE        figures as JSON
  --threads N          threads; the result does not depend on it [all cores]
  --time-limit SECONDS stop then with the best map so far
  --seed N             for everything random
  --quiet              no progress and no figures, only warnings and errors

Exit codes: 0 done, 1 failed, 2 wrong usage, 130 interrupted (the best map so far has been written).
Progress goes to stderr, results to stdout.
)");
}

} // namespace autocuts
