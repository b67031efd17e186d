// The command line's contract: every command and option is understood, every mistake has a message.
#include "cli/clihelp.h"
#include "cli/clitable.h"
#include "cli/commandline.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

namespace tst_clioptions {

using namespace autocuts;
using namespace autocuts::unwrap;
using namespace Qt::Literals::StringLiterals;

namespace {

QStringList words(const QString &line)
{
    return line.split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

CliOptions parsed(const char *line)
{
    const Result<CliOptions> options = parseCommandLine(words(QString::fromLatin1(line)));
    if (!options)
        qWarning("%s", qPrintable(options.error().toString()));
    return options.ok() ? options.value() : CliOptions{};
}

//! A text file of the repository.
QString contents(const char *path)
{
    QFile file(QStringLiteral(AUTOCUTS_SOURCE_DIR "/") + QString::fromLatin1(path));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

class TestCliOptions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void defaultsAreTheContracts()
    {
        const CliOptions o = parsed("unwrap in.obj -o out.obj");
        QCOMPARE(o.command, CliOptions::Command::Unwrap);
        QCOMPARE(o.input, QStringLiteral("in.obj"));
        QCOMPARE(o.output, QStringLiteral("out.obj"));
        QCOMPARE(o.unwrap.maxDistortion, 4.1);
        QVERIFY(!o.unwrap.lambda);
        QCOMPARE(o.settings.start, StartMode::Rigid);
        QCOMPARE(o.settings.weighting, SeamWeighting::Length);
        QCOMPARE(o.settings.energy, DistortionEnergy::SymmetricDirichlet);
        QCOMPARE(o.settings.solver, SolverKind::Fast);
        QCOMPARE(o.settings.creases, CreaseMode::Auto);
        QCOMPARE(o.settings.creaseStrength, 0.8);
        QCOMPARE(o.settings.visibility, 0.0);
        QCOMPARE(o.settings.symmetry, SymmetryMode::Auto);
        QCOMPARE(o.settings.align, SolveSettings().align);
        QVERIFY(!o.settings.mirrorMaps && o.settings.worldUp == WorldUp::AutoY);
        QCOMPARE(o.settings.seams, SeamMode::Free);
        QVERIFY((o.settings.givenSeams == GivenSeamOptions{.cuts = true, .map = true}));
        QVERIFY(o.only.isEmpty() && o.borderAttached);
        QCOMPARE(o.unwrap.quality, UnwrapQuality::Standard);
        QVERIFY(!o.unwrap.allowOverlaps);
        QVERIFY(o.unwrap.pack);
        QCOMPARE(o.unwrap.packing.textureSize, 2048);
        QCOMPARE(o.unwrap.packing.margin, 8.0);
        QCOMPARE(o.unwrap.packing.rotation, PackRotation::Free);
        QVERIFY(!o.unwrap.packing.keepScale);
        QVERIFY(o.threads >= 1);
        QCOMPARE(o.timeLimit, 0.0);
        QVERIFY(!o.quiet && o.layout.isEmpty() && o.report.isEmpty());
    }

    void everyOptionOfUnwrapIsRead()
    {
        const CliOptions o = parsed(
            "unwrap --max-distortion 4.25 --init tutte --weights count --energy amips --allow-overlaps "
            "--no-pack --texture-size 1024 --margin 2.5 --rotation 90 --pack-time 3 --solver exact --quality "
            "best --creases on --crease-strength 0.5 --visibility 0.25 --symmetry --align auto --mirror "
            "--world-up "
            "z --seams keep --seams-from "
            "sharp:45,hard "
            "--only islands:3,5 --only objects:arm --only objects:leg --border free --layout l.svg --report "
            "r.json --threads 3 --time-limit 12.5 --seed 7 --quiet -o out.obj "
            "in.obj");
        QCOMPARE(o.input, QStringLiteral("in.obj"));
        QCOMPARE(o.output, QStringLiteral("out.obj"));
        QCOMPARE(o.unwrap.maxDistortion, 4.25);
        QCOMPARE(o.settings.start, StartMode::Tutte);
        QCOMPARE(o.settings.weighting, SeamWeighting::Count);
        QCOMPARE(o.settings.energy, DistortionEnergy::Amips);
        QVERIFY(o.unwrap.allowOverlaps);
        QVERIFY(!o.unwrap.pack);
        QCOMPARE(o.unwrap.packing.textureSize, 1024);
        QCOMPARE(o.unwrap.packing.margin, 2.5);
        QCOMPARE(o.unwrap.packing.rotation, PackRotation::Quarter);
        QCOMPARE(o.unwrap.packing.effort, 3.0);
        QCOMPARE(o.settings.solver, SolverKind::Exact);
        QCOMPARE(o.settings.creases, CreaseMode::On);
        QCOMPARE(o.settings.creaseStrength, 0.5);
        QCOMPARE(o.settings.visibility, 0.25);
        QCOMPARE(o.settings.symmetry, SymmetryMode::On);
        QCOMPARE(o.settings.align, CreaseMode::Auto);
        QVERIFY(o.settings.mirrorMaps);
        QCOMPARE(o.settings.worldUp, WorldUp::Z);
        QCOMPARE(o.settings.seams, SeamMode::Keep);
        QVERIFY((o.settings.givenSeams == GivenSeamOptions{.cuts = false,
                                                           .map = false,
                                                           .sharp = true,
                                                           .hard = true,
                                                           .materials = false,
                                                           .sharpAngle = 45}));
        QCOMPARE(o.only.islands, (std::vector<int>{3, 5}));
        QCOMPARE(o.only.objects, (QStringList{u"arm"_s, u"leg"_s}));
        QVERIFY(!o.borderAttached);
        QCOMPARE(o.unwrap.quality, UnwrapQuality::Best);
        QCOMPARE(o.layout, QStringLiteral("l.svg"));
        QCOMPARE(o.report, QStringLiteral("r.json"));
        QCOMPARE(o.threads, 3);
        QCOMPARE(o.timeLimit, 12.5);
        QCOMPARE(o.settings.seed, 7u);
        QCOMPARE(o.unwrap.packing.seed, 7u);
        QVERIFY(o.quiet);
    }

    void texturesHaveTwoSides()
    {
        const PackingSettings packing =
            parsed("pack a -o b --texture-size 2048x1024 --rotation 15").unwrap.packing;
        QCOMPARE(packing.textureSize, 2048);
        QCOMPARE(packing.height(), 1024);
        QCOMPARE(packing.rotation, PackRotation::TwentyFourth);
        QCOMPARE(parsed("pack a -o b --texture-size 512x512").unwrap.packing.textureHeight, 0);
        for (const char *wrong : {"--texture-size=12", "--texture-size=64x", "--texture-size=64x64x64",
                                  "--texture-size=1024x8", "--rotation=20", "--texture-size=99999x64"})
            QVERIFY2(!parseCommandLine({u"pack"_s, u"a"_s, u"-o"_s, u"b"_s, QString::fromLatin1(wrong)}).ok(),
                     wrong);
    }

    void everyWordIsKnown_data()
    {
        QTest::addColumn<QString>("line");
        for (const char *line : {"unwrap a -o b --init rigid",
                                 "unwrap a -o b --init random",
                                 "unwrap a -o b --init uv",
                                 "unwrap a -o b --weights length",
                                 "unwrap a -o b --energy symmetric-dirichlet",
                                 "unwrap a -o b --solver fast",
                                 "unwrap a -o b --quality draft",
                                 "unwrap a -o b --creases off",
                                 "unwrap a -o b --creases auto",
                                 "unwrap a -o b --quality standard",
                                 "unwrap a -o b --rotation free",
                                 "unwrap a -o b --rotation none",
                                 "unwrap a -o b --seams free",
                                 "unwrap a -o b --seams only --seams-from cuts,uv,sharp,hard",
                                 "finish a -o b --seams keep --seams-from objects,materials --only "
                                 "objects:a --border attached",
                                 "unwrap a -o b --lambda 0",
                                 "unwrap a -o b --lambda=1",
                                 "unwrap a --output b",
                                 "unwrap a --output=b --margin=0",
                                 "unwrap a -o b --layout L.PNG",
                                 "pack a -o b --texture-size 512 --margin 4 --rotation none --keep-scale "
                                 "--pack-time 1 --time-limit 3 "
                                 "--threads 2 --seed 3 --layout a.png --report b.json --quiet",
                                 "separate a -o b --margin 4 --quiet --report b.json",
                                 "transfer a -o b --from c --match position --report b.json",
                                 "transfer a -o b --from-object arm --objects leg --uv-set 2",
                                 "check a",
                                 "check a --json --texture-size 4096",
                                 "check a --report b --fail-on overlaps,distortion:4.2",
                                 "convert a -o b",
                                 "convert a -o b --quiet",
                                 "sample torus -o b",
                                 "batch unwrap a b -o c --jobs 3 --margin=4 --report d.html --format glb",
                                 "thumbnail a -o b --size 128 --show both"})
            QTest::newRow(line) << QString::fromLatin1(line);
    }
    void everyWordIsKnown()
    {
        QFETCH(QString, line);
        const Result<CliOptions> options = parseCommandLine(words(line));
        QVERIFY2(options.ok(), options.ok() ? "" : qPrintable(options.error().toString()));
    }

    void helpAndVersion()
    {
        QCOMPARE(parsed("unwrap --help").each, CliOptions::Command::Unwrap);
        for (const char *line :
             {"--help", "-h", "help", "unwrap --help", "pack a -h", "pack --help --margin 3"})
            QCOMPARE(parsed(line).command, CliOptions::Command::Help);
        QCOMPARE(parsed("--version").command, CliOptions::Command::Version);
        QCOMPARE(parsed("--man-page").command, CliOptions::Command::ManPage);
        QCOMPARE(parsed("--markdown").command, CliOptions::Command::Markdown);
        QCOMPARE(parsed("--completion fish").command, CliOptions::Command::Completion);
    }

    void commandsThatMakeMapsCanBeStopped()
    {
        QStringList making;
        for (const CliCommand &command : cliCommands()) {
            CliOptions options;
            options.command = command.id;
            if (canBeStopped(options))
                making << command.name;
        }
        QCOMPARE(making, (QStringList{u"unwrap"_s, u"pack"_s, u"separate"_s, u"lightmap"_s, u"finish"_s,
                                      u"transfer"_s, u"bake"_s, u"lightbake"_s, u"batch"_s}));
        QVERIFY(!canBeStopped({}));
    }

    void commandsTakeTheContractsOptions_data()
    {
        QTest::addColumn<QString>("command");
        QTest::addColumn<QStringList>("names");
        const QStringList common{u"-o"_s,        u"--texture-size"_s, u"--margin"_s,     u"--rotation"_s,
                                 u"--tile"_s,    u"--pack-time"_s,    u"--layout"_s,     u"--report"_s,
                                 u"--threads"_s, u"--time-limit"_s,   u"--seed"_s,       u"--only"_s,
                                 u"--border"_s,  u"--tile-border"_s,  u"--objects"_s,    u"--materials"_s,
                                 u"--uv-set"_s,  u"--new-uv-set"_s,   u"--make-unique"_s};
        QStringList lightmap = common;
        for (const QString &name : {u"--only"_s, u"--objects"_s, u"--materials"_s, u"--border"_s})
            lightmap.removeOne(name);
        QTest::newRow("unwrap")
            << u"unwrap"_s
            << common +
                   words(
                       u"--max-distortion --seams --seams-from --lambda --init --weights --energy --solver "
                       "--quality --for --flat --alike --creases --crease-strength --visibility "
                       "--symmetry --no-symmetry --align --mirror --world-up --allow-overlaps --no-pack --per --density"_s);
        QTest::newRow("pack") << u"pack"_s
                              << common +
                                     words(u"--into --keep-scale --per --density --fill-tiles --tiles"_s);
        QTest::newRow("separate") << u"separate"_s
                                  << common + words(u"--separate-by --per --density --tiles"_s);
        QTest::newRow("lightmap") << u"lightmap"_s << lightmap + words(u"--tiles"_s);
        QTest::newRow("finish")
            << u"finish"_s
            << common + words(u"--max-distortion --seams --seams-from --per --density --tiles"_s);
        QTest::newRow("transfer")
            << u"transfer"_s
            << words(u"-o --from --from-uv-set --from-object --textures --match --texture-size --only "
                     u"--objects "
                     u"--materials "
                     "--border --uv-set --new-uv-set --make-unique --layout --report --threads --time-limit "
                     "--seed"_s);
        QTest::newRow("lightbake")
            << u"lightbake"_s
            << words(u"-o --sun --sun-strength --sun-angle --sun-color --sky --sky-strength --turbidity "
                     "--area-light --emit --up --albedo --albedo-uv-set --bounces --samples --no-direct "
                     "--no-indirect --values --no-denoise --dilation --bits --texture-size --uv-set --report "
                     "--threads --time-limit"_s);
        QTest::newRow("check") << u"check"_s
                               << words(u"--texture-size --json --uv-set --only --objects --materials "
                                        "--report --fail-on"_s);
        QTest::newRow("convert") << u"convert"_s << words(u"-o --uv-set --force --make-unique --report"_s);
        QTest::newRow("thumbnail") << u"thumbnail"_s << QStringList{u"-o"_s, u"--size"_s, u"--show"_s};
        QTest::newRow("batch") << u"batch"_s
                               << words(u"-o --report --jobs --memory --file-limit --resume --retry --format "
                                        "--part --journal --elsewhere"_s);
        QTest::newRow("replay") << u"replay"_s << QStringList{u"-o"_s, u"--report"_s};
        QTest::newRow("sample") << u"sample"_s << QStringList{u"-o"_s};
    }
    void commandsTakeTheContractsOptions()
    {
        QFETCH(QString, command);
        QFETCH(QStringList, names);
        names << u"--preset"_s << u"--show-settings"_s << u"--dry-run"_s << u"--quiet"_s
              << u"--input-format"_s << u"--output-format"_s << u"--progress"_s;
        const auto row = std::find_if(cliCommands().begin(), cliCommands().end(),
                                      [&](const CliCommand &c) { return c.name == command; });
        QVERIFY(row != cliCommands().end());
        QStringList taken;
        for (const CliOption &option : cliOptions()) {
            if (row->takes(option.group))
                taken << option.names.first();
        }
        names.sort();
        taken.sort();
        QCOMPARE(taken, names);
    }

    //! The default that the texts name is a value of the option, and changes nothing when it is given.
    void defaultsInTheTextsAreTrue()
    {
        int checked = 0;
        for (const CliOption &option : cliOptions()) {
            if (option.standard.isEmpty() || option.names.contains(u"--threads"_s) ||
                option.names.contains(u"--jobs"_s))
                continue;
            CliOptions given;
            QVERIFY2(!option.read(given, option.standard), qPrintable(option.names.first()));
            const CliOptions standard;
            QCOMPARE(given.settings, standard.settings);
            QCOMPARE(given.unwrap.maxDistortion, standard.unwrap.maxDistortion);
            QCOMPARE(given.unwrap.quality, standard.unwrap.quality);
            QCOMPARE(given.unwrap.packing.textureSize, standard.unwrap.packing.textureSize);
            QCOMPARE(given.unwrap.packing.margin, standard.unwrap.packing.margin);
            QCOMPARE(given.unwrap.packing.rotation, standard.unwrap.packing.rotation);
            QCOMPARE(given.unwrap.packing.effort, standard.unwrap.packing.effort);
            QCOMPARE(given.unwrap.packing.udimTile, standard.unwrap.packing.udimTile);
            QCOMPARE(given.separation, standard.separation);
            QCOMPARE(given.borderAttached, standard.borderAttached);
            QCOMPARE(given.oneTile, standard.oneTile);
            QCOMPARE(given.match, standard.match);
            ++checked;
        }
        QCOMPARE(checked, 50);
    }

    //! What a batch gives to the command, and what it takes itself.
    void optionsOfBatches()
    {
        const CliOptions o =
            parsed("batch unwrap a b -o c --jobs 3 --margin 4 --no-pack --format=.GLB -- -d");
        QCOMPARE(o.command, CliOptions::Command::Batch);
        QCOMPARE(o.each, CliOptions::Command::Unwrap);
        QCOMPARE(o.many->inputs, (QStringList{u"a"_s, u"b"_s, u"-d"_s}));
        QCOMPARE(o.many->passed, (QStringList{u"--margin=4"_s, u"--no-pack"_s}));
        QCOMPARE(o.many->format, u"glb"_s);
        QCOMPARE(o.many->jobs, 3);
        QCOMPARE(o.output, u"c"_s);
    }

    //! Several inputs, and one for a folder, are what a batch would do.
    void severalInputsAreABatch_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("batch");
        const auto row = [](const char *line, const char *batch) {
            QTest::newRow(line) << QString::fromLatin1(line) << QString::fromLatin1(batch);
        };
        row("pack a --margin 4 b -o c --report d.csv", "batch pack a b -o c --margin 4 --report d.csv");
        row("pack a -o c/ --margin=4", "batch pack a -o c/ --margin 4");
        row("convert a b -o c --output-format glb",
            "batch convert a b -o c --output-format glb --format glb");
        row("check a b --json --fail-on flips", "batch check a b --fail-on flips --json");
        row("replay a b", "batch replay a b");
        row("bake a b -o c/ --bits 16", "batch bake a b -o c/ --bits 16");
    }
    void severalInputsAreABatch()
    {
        QFETCH(QString, line);
        QFETCH(QString, batch);
        const CliOptions made = parsed(line.toLatin1().constData()),
                         expected = parsed(batch.toLatin1().constData());
        QCOMPARE(made.command, CliOptions::Command::Batch);
        QCOMPARE(made.each, expected.each);
        QCOMPARE(made.output, expected.output);
        QCOMPARE(made.json, expected.json);
        QCOMPARE(made.many->command, expected.many->command);
        QCOMPARE(made.many->inputs, expected.many->inputs);
        QCOMPARE(made.many->passed, expected.many->passed);
        QCOMPARE(made.many->format, expected.many->format);
        QCOMPARE(made.many->report, expected.many->report);
    }

    //! Qt would take them for resources of the program.
    void namesMayBeginWithAColon()
    {
        const CliOptions o = parsed("unwrap :in.obj -o :out.obj --report :r.json");
        QCOMPARE(o.input, QStringLiteral("./:in.obj"));
        QCOMPARE(o.output, QStringLiteral("./:out.obj"));
        QCOMPARE(o.report, QStringLiteral("./:r.json"));
    }

    void aFolderIsNoBatchWhereTheCommandNeedsOne()
    {
        QVERIFY(!parsed("bake a -o b/").many);
        QVERIFY(!parsed("transfer a --from b --textures all -o c/").many);
    }

    void helpOfOneCommandHasItsOptionsOnly()
    {
        const QString help = usageText(CliOptions::Command::Pack);
        QVERIFY(help.contains(u"\n  --keep-scale "_s) && help.contains(u"autocuts-cli pack IN"_s));
        QVERIFY(!help.contains(u"--max-distortion"_s) && !help.contains(u"autocuts-cli unwrap"_s));
    }

    void twoDashesEndTheOptions()
    {
        const auto options = parseCommandLine({u"convert"_s, u"-o"_s, u"b.obj"_s, u"--"_s, u"--a.obj"_s});
        QVERIFY(options.ok());
        QCOMPARE(options->input, u"--a.obj"_s);
        QVERIFY(!parseCommandLine({u"convert"_s, u"-o"_s, u"b.obj"_s, u"--"_s, u"--"_s, u"a"_s}).ok());
    }

    void helpSaysAllInItsWidth()
    {
        const QString help = usageText();
        for (const CliCommand &command : cliCommands())
            QVERIFY2(help.contains(u"autocuts-cli "_s + command.name + u' '), qPrintable(command.name));
        for (const CliOption &option : cliOptions())
            QVERIFY2(help.contains(u"\n  "_s + option.names.join(u", "_s) + u' '),
                     qPrintable(option.names.first()));
        for (const CliExitCode &exit : cliExitCodes())
            QVERIFY2(help.contains(u"\n  "_s + QString::number(exit.code) + u' '), qPrintable(exit.meaning));
        for (const QString &line : help.split(u'\n'))
            QVERIFY2(line.size() <= 110 && !line.endsWith(u' '), qPrintable(line));
        // Options of one heading stand together.
        for (const QString &heading :
             {u"unwrap"_s, u"unwrap, finish"_s, u"unwrap, pack, separate, finish, transfer"_s, u"pack"_s,
              u"transfer"_s})
            QCOMPARE(help.count(u'\n' + heading + u":\n"_s), 1);
    }

    void tablesAndManualPageAreOfTheTable()
    {
        const QString tables = contents("docs/commandline.md"), page = contents("docs/autocuts-cli.1");
        QVERIFY2(tables.contains(u'\n' + markdownTables()), "write it again: scripts/docs");
        QVERIFY2(page == manualPage(), "write it again: scripts/docs");
        for (const CliOption &option : cliOptions())
            QVERIFY(page.contains(u"\n.TP\n\\fB"_s + QString(option.names.first()).replace(u'-', u"\\-"_s)));
        // A line that begins with a dot or an apostrophe is a request to man; only those of the page itself
        // may.
        static const QRegularExpression request(u"^\\.(\\\\\"|TH|SH|SS|TP|br)( |$)"_s);
        for (const QString &line : page.split(u'\n'))
            QVERIFY2(!(line.startsWith(u'.') || line.startsWith(u'\'')) || line.contains(request),
                     qPrintable(line));
    }

    //! Presets that come with the program can be read by every command, whatever they do not take.
    void mistakesAreExplained_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("part"); // of the message
        const auto row = [](const char *line, const char *part) {
            QTest::newRow(line[0] ? line : "nothing")
                << QString::fromLatin1(line) << QString::fromLatin1(part);
        };
        row("", "no command");
        row("unfold a -o b", "unknown command \"unfold\"");
        row("unwrap", "no input");
        row("unwrap a", "no output");
        row("unwrap a -o", "-o needs a value");
        row("unwrap a -o --quiet", "-o needs a value");
        row("unwrap a -o b --margin", "--margin needs a value");
        row("unwrap a -o b --colour red", "unknown option --colour");
        row("unwrap a -o b -q", "unknown option -q");
        row("unwrap a -o b --margin eight", "\"eight\"");
        row("unwrap a -o b --margin -1", "--margin takes a number from 0");
        row("unwrap a -o b --margin nan", "--margin takes a number");
        row("unwrap a -o b --margin 2048", "as wide as the whole texture");
        row("unwrap a -o b --texture-size 3.5", "--texture-size takes a whole number");
        row("unwrap a -o b --texture-size 0", "--texture-size takes a whole number from 16");
        row("unwrap a -o b --max-distortion 4", "--max-distortion takes a number from 4.0001");
        row("unwrap a -o b --max-distortion inf", "--max-distortion takes a number");
        row("unwrap a -o b --lambda 2", "--lambda takes a number from 0 to 1");
        row("unwrap a -o b --lambda 0.5 --max-distortion 4.2", "exclude each other");
        row("unwrap a -o b --init flat", "--init takes rigid or tutte or random or uv, not \"flat\"");
        row("unwrap a -o b --rotation 50", "--rotation takes free or 180 or 90 or 45 or 30 or 15 or none");
        row("unwrap a -o b --quality ultra", "--quality takes");
        row("unwrap a -o b --per face", "--per takes object or material");
        row("unwrap a -o b --objects ,", "--objects takes NAME,..");
        row("pack a -o b --per object --into 0,0,1,1", "--per packs into tiles");
        row("unwrap a -o b --per object --no-pack", "--per packs into tiles");
        row("pack a -o b --density 5 --per object", "--density excludes");
        row("pack a -o b --density 5 --keep-scale", "--density excludes");
        row("pack a -o b --density 0", "--density takes a number");
        row("pack a -o b --fill-tiles --into 0,0,1,1", "--fill-tiles excludes");
        row("pack a -o b --tiles one --per object", "--tiles one excludes");
        row("lightmap a -o b --per object", "--per does not belong to this command");
        row("unwrap a -o b --layout l.jpg", "--layout takes a .png or .svg file");
        row("unwrap a -o b --threads 0", "--threads takes a whole number from 1");
        row("unwrap a -o b --time-limit 0", "--time-limit takes a number");
        row("unwrap a -o b --seed -4", "--seed takes a whole number from 0");
        row("unwrap a -o b --quiet=yes", "--quiet takes no value");
        row("unwrap a -o b --seams mine", "--seams takes free or keep or only");
        for (const char *line :
             {"unwrap a -o b --seams-from edges", "unwrap a -o b --seams-from cuts,",
              "unwrap a -o b --seams-from sharp:181", "unwrap a -o b --seams-from sharp:flat",
              "unwrap a -o b --seams-from hard:30"})
            row(line, "--seams-from takes a list of cuts, uv, sharp");
        for (const char *line : {"pack a -o b --only island:3", "pack a -o b --only objects",
                                 "pack a -o b --only objects:", "pack a -o b --only materials:,"})
            row(line, "--only takes islands:N,.. or objects:NAME,..");
        row("pack a -o b --only islands:1,0", "--only takes islands by their numbers, from 1");
        row("pack a -o b --only islands:two", "--only takes islands by their numbers, from 1");
        row("pack a -o b --border free", "--border says how --only ends");
        row("pack a -o b --only islands:1 --border cut", "--border takes attached or free");
        row("pack a -o b --seams keep", "--seams does not belong to this command");
        row("check a --border free", "--border does not belong to this command");
        row("unwrap a -o b --keep-scale", "--keep-scale does not belong to this command");
        row("pack a -o b --no-pack", "--no-pack does not belong to this command");
        row("pack a -o b --init uv", "--init does not belong to this command");
        row("convert a -o b --margin 3", "--margin does not belong to this command");
        row("transfer a -o b", "transfer needs --from");
        row("transfer a -o b --from c --match nearest", "--match takes auto or topology or position");
        row("transfer a -o b --from c --margin 3", "--margin does not belong to this command");
        row("unwrap a -o b --from c", "--from does not belong to this command");
        row("check a -o b", "-o does not belong to this command");
        row("check", "no input");
        row("batch", "batch needs a command");
        row("batch sample torus -o b", "batch cannot do \"sample\"");
        row("batch unwrap -o b", "no input");
        row("batch unwrap a", "no output folder given");
        row("batch unwrap a -o b --layout c.png", "--layout names one file");
        row("batch unwrap a -o b --report c.txt", "--report takes a .csv, .json or .html file");
        row("batch convert a -o b", "conversions of several files need --output-format");
        row("batch check a --resume", "no folder given for the journal");
        row("unwrap a b", "no output folder given");
        row("unwrap a b -o -", "several files are made");
        row("unwrap a - -o b", "several inputs are files");
        row("unwrap a b -o c --jobs 2", "--jobs does not belong to this command, but to \"batch unwrap\"");
        row("unwrap a b -o c --report d.txt", "--report takes a .csv, .json or .html file of several inputs");
        row("unwrap a b -o c --jobs 2", "--jobs does not belong to this command, but to \"batch unwrap\"");
        row("unwrap a b -o c --report d.txt", "--report takes a .csv, .json or .html file of several inputs");
        row("unwrap a -o - --report -", "cannot both go to standard output");
        row("sample torus machine -o b", "one name only, but \"machine\" follows \"torus\"");
        row("batch pack a -o b --seams keep", "--seams does not belong to this command");
        row("check a --fail-on overlap", "--fail-on takes a list of overlaps");
        row("unwarp a -o b", "(did you mean unwrap?)");
        row("unwrap a -o b --qualty best", "(did you mean --quality?)");
        row("--completion", "--completion takes bash or zsh or fish");
        row("--completion csh", "--completion takes bash or zsh or fish");
        row("sample -o b", "no sample named");
        row("sample torus", "no output");
    }
    void mistakesAreExplained()
    {
        QFETCH(QString, line);
        QFETCH(QString, part);
        const Result<CliOptions> options = parseCommandLine(words(line));
        QVERIFY(!options.ok());
        const QString text = options.error().toString();
        QVERIFY2(text.contains(part), qPrintable(text));
        QVERIFY2(text.contains(QLatin1String("--help")), qPrintable(text));
        QVERIFY2(!text.contains(QLatin1Char('\n')), qPrintable(text));
    }
};

QTEST_APPLESS_MAIN(TestCliOptions)

} // namespace tst_clioptions

#include "tst_clioptions.moc"
