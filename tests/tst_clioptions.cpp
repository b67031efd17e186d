// The command line's contract: every command and option is understood, every mistake has a message.
#include "cli/clioptions.h"

#include <QTest>

using namespace autocuts;
using namespace autocuts::unwrap;

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
        QVERIFY(!o.settings.symmetry);
        QCOMPARE(o.unwrap.quality, UnwrapQuality::Standard);
        QVERIFY(!o.unwrap.allowOverlaps);
        QVERIFY(o.unwrap.pack);
        QCOMPARE(o.unwrap.packing.textureSize, 2048);
        QCOMPARE(o.unwrap.packing.margin, 8.0);
        QCOMPARE(o.unwrap.packing.rotation, PackRotation::Free);
        QVERIFY(!o.unwrap.packing.keepScale);
        QVERIFY(o.unwrap.threads >= 1);
        QCOMPARE(o.unwrap.packing.threads, o.unwrap.threads);
        QCOMPARE(o.timeLimit, 0.0);
        QVERIFY(!o.quiet && o.layout.isEmpty() && o.report.isEmpty());
    }

    void everyOptionOfUnwrapIsRead()
    {
        const CliOptions o = parsed(
            "unwrap --max-distortion 4.25 --init tutte --weights count --energy amips --allow-overlaps "
            "--no-pack --texture-size 1024 --margin 2.5 --rotation 90 --pack-time 3 --solver exact --quality "
            "best --creases on --crease-strength 0.5 --visibility 0.25 --symmetry --layout l.svg --report "
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
        QVERIFY(o.settings.symmetry);
        QCOMPARE(o.unwrap.quality, UnwrapQuality::Best);
        QCOMPARE(o.layout, QStringLiteral("l.svg"));
        QCOMPARE(o.report, QStringLiteral("r.json"));
        QCOMPARE(o.unwrap.threads, 3);
        QCOMPARE(o.unwrap.packing.threads, 3);
        QCOMPARE(o.timeLimit, 12.5);
        QCOMPARE(o.settings.seed, 7u);
        QCOMPARE(o.unwrap.packing.seed, 7u);
        QVERIFY(o.quiet);
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
                                 "unwrap a -o b --lambda 0",
                                 "unwrap a -o b --lambda=1",
                                 "unwrap a --output b",
                                 "unwrap a --output=b --margin=0",
                                 "unwrap a -o b --layout L.PNG",
                                 "pack a -o b --texture-size 512 --margin 4 --rotation none --keep-scale "
                                 "--pack-time 1 --time-limit 3 "
                                 "--threads 2 --seed 3 --layout a.png --report b.json --quiet",
                                 "separate a -o b --margin 4 --quiet --report b.json",
                                 "check a",
                                 "check a --json --texture-size 4096",
                                 "convert a -o b",
                                 "convert a -o b --quiet",
                                 "sample torus -o b"})
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
        for (const char *line : {"--help", "-h", "help", "unwrap --help", "pack a -h"})
            QCOMPARE(parsed(line).command, CliOptions::Command::Help);
        QCOMPARE(parsed("--version").command, CliOptions::Command::Version);
        const QString help = usageText();
        for (const char *word :
             {"unwrap",    "pack",         "separate",         "check",        "convert",
              "sample",    "-o",           "--max-distortion", "--lambda",     "--init",
              "--weights", "--energy",     "--allow-overlaps", "--no-pack",    "--texture-size",
              "--margin",  "--rotation",   "--pack-time",      "--solver",     "--quality",
              "--layout",  "--report",     "--threads",        "--time-limit", "--seed",
              "--quiet",   "--keep-scale", "--json",           "130"})
            QVERIFY2(help.contains(QLatin1String(word)), word);
        for (const QString &line : help.split(QLatin1Char('\n')))
            QVERIFY2(line.size() <= 110, qPrintable(line));
    }

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
        row("unwrap a b -o c", "\"b\" follows \"a\"");
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
        row("unwrap a -o b --rotation 45", "--rotation takes free or 90 or none");
        row("unwrap a -o b --quality ultra", "--quality takes");
        row("unwrap a -o b --layout l.jpg", "--layout takes a .png or .svg file");
        row("unwrap a -o b --threads 0", "--threads takes a whole number from 1");
        row("unwrap a -o b --time-limit 0", "--time-limit takes a number");
        row("unwrap a -o b --seed -4", "--seed takes a whole number from 0");
        row("unwrap a -o b --quiet=yes", "--quiet takes no value");
        row("unwrap a -o b --keep-scale", "--keep-scale does not belong to this command");
        row("pack a -o b --no-pack", "--no-pack does not belong to this command");
        row("pack a -o b --init uv", "--init does not belong to this command");
        row("convert a -o b --margin 3", "--margin does not belong to this command");
        row("check a -o b", "-o does not belong to this command");
        row("check", "no input");
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
#include "tst_clioptions.moc"
