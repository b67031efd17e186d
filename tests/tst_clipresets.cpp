// Presets on the command line: what they stand for, what replaces them, and what is wrong with one.
#include "cli/clitable.h"
#include "cli/commandline.h"
#include "jobs/presets.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace tst_clipresets {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

class TestCliPresets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void presetsFit_data()
    {
        QTest::addColumn<QString>("preset");
        for (const QString &name : {u"game-prop"_s, u"film-udim"_s, u"lightmap"_s, u"scan"_s})
            QTest::newRow(qPrintable(name)) << name;
    }

    void presetsFit()
    {
        QFETCH(QString, preset);
        QVERIFY(presetNames().contains(preset));
        for (const CliCommand &command : cliCommands()) {
            if (command.operand != u"IN" || command.name == u"transfer")
                continue;
            const QString line = command.name + u" a.obj -o b.obj --preset "_s + preset;
            const auto options = parseCommandLine(line.split(u' '));
            QVERIFY2(options || command.output == CliCommand::Output::None,
                     qPrintable(options ? QString() : options.error().toString()));
        }
    }

    void presetsAreReplacedByTheCommandLine()
    {
        const auto made = [](const QString &line) { return parseCommandLine(line.split(u' ')); };
        const auto plain = made(u"unwrap a.obj -o b.obj --preset scan"_s);
        QVERIFY(plain);
        QCOMPARE(plain->unwrap.maxDistortion, 4.2);
        QCOMPARE(plain->unwrap.packing.textureSize, 4096);
        QVERIFY(plain->settings.surface == SurfaceKind::Organic);
        for (const QString &line : {u"unwrap a.obj -o b.obj --max-distortion 4.3 --preset scan"_s,
                                    u"unwrap a.obj -o b.obj --preset=scan --max-distortion=4.3"_s})
            QCOMPARE(made(line)->unwrap.maxDistortion, 4.3);
    }

    void presetsFromFiles()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(u"own.preset"_s);
        const auto with = [&](const QByteArray &text) {
            QFile file(path);
            if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
                qFatal("the preset cannot be written");
            file.close();
            return parseCommandLine({u"unwrap"_s, u"a.obj"_s, u"-o"_s, u"b.obj"_s, u"--preset"_s, path});
        };
        const auto read = with("# mine\n\nmargin = 12\nsymmetry\nrays = 9\n");
        QVERIFY(read);
        QCOMPARE(read->unwrap.packing.margin, 12.0);
        QCOMPARE(read->settings.symmetry, SymmetryMode::On);
        QCOMPARE(with("no-symmetry\n")->settings.symmetry, SymmetryMode::Off);
        for (const auto &[text, message] :
             {std::pair("margni = 12\n", "own.preset:1: unknown option \"margni\" (did you mean --margin?)"),
              std::pair("\nmargin = many\n", "own.preset:2: --margin takes"),
              std::pair("margin\n", "own.preset:1: --margin needs a value"),
              std::pair("symmetry = on\n", "own.preset:1: --symmetry takes no value")}) {
            const auto refused = with(text);
            QVERIFY(!refused);
            QVERIFY2(refused.error().toString().contains(QLatin1StringView(message)),
                     qPrintable(refused.error().toString()));
        }
        const auto missing = parseCommandLine({u"unwrap"_s, u"a.obj"_s, u"--preset"_s, u"game-pop"_s});
        QVERIFY(!missing && missing.error().toString().contains(u"did you mean game-prop?"));
    }

    //! What is shown is a preset that gives the same.
    void settingsAreShown()
    {
        const auto shown = parseCommandLine(
            QStringLiteral("unwrap --preset scan --margin 3 --symmetry --show-settings").split(u' '));
        QVERIFY(shown && shown->command == CliOptions::Command::Settings);
        const QStringList lines = shown->settingsText.split(u'\n');
        for (const QString &line : {u"margin = 3"_s, u"symmetry"_s, u"for = organic"_s,
                                    u"texture-size = 4096"_s, u"alike = same-cuts"_s})
            QVERIFY2(lines.contains(line), qPrintable(line + u'\n' + shown->settingsText));
        QTemporaryDir folder;
        const QString path = folder.filePath(u"again.preset"_s);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(shown->settingsText.toUtf8());
        file.close();
        const auto again = parseCommandLine({u"unwrap"_s, u"--preset"_s, path, u"--show-settings"_s});
        QVERIFY2(again, qPrintable(again ? QString() : again.error().toString()));
        QCOMPARE(again->settingsText, shown->settingsText);
        // Several inputs have the same settings, and none of them is read.
        const auto several = parseCommandLine({u"convert"_s, u"-"_s, u"b.obj"_s, u"--show-settings"_s});
        QVERIFY(several && several->command == CliOptions::Command::Settings && !several->many);
    }
};

QTEST_GUILESS_MAIN(TestCliPresets)

} // namespace tst_clipresets

#include "tst_clipresets.moc"
