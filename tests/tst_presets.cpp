// Presets: the same settings by the window and by the command line, and the menu of the Unwrap panel.
#include "cli/commandline.h"
#include "jobs/mapsettings.h"
#include "model/samples/samples.h"
#include "support/answers.h"
#include "support/panelbench.h"
#include "views/panels/presetmenu.h"
#include "views/panels/solverpanel.h"

#include <QComboBox>
#include <QDir>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>

#include <limits>

namespace tst_presets {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::child;

namespace {

//! Settings none of which is a default.
jobs::MapSettings unusual()
{
    jobs::MapSettings settings;
    SolveSettings &solve = settings.solve;
    solve.energy = DistortionEnergy::Amips;
    solve.weighting = SeamWeighting::Count;
    solve.start = StartMode::Tutte;
    solve.solver = SolverKind::Exact;
    solve.seed = 7;
    solve.maxDistortion = 4.0625;
    solve.surface = SurfaceKind::Organic;
    solve.flat = FlatMode::Free;
    solve.alike = AlikeMode::Stack;
    solve.creases = CreaseMode::On;
    solve.creaseStrength = 0.1;
    solve.visibility = 0.3;
    solve.symmetry = SymmetryMode::On;
    solve.align = CreaseMode::Auto;
    solve.mirrorMaps = true;
    solve.worldUp = WorldUp::Z;
    solve.seams = SeamMode::Keep;
    solve.givenSeams = {
        .cuts = false, .map = true, .sharp = true, .hard = true, .materials = true, .sharpAngle = 41.5};
    PackingSettings &packing = settings.packing;
    packing.setTexture(1024, 512);
    packing.margin = 3;
    packing.udimTile = 1012;
    packing.rotation = PackRotation::Eighth;
    packing.border = 2.5;
    packing.effort = 0.25;
    packing.keepScale = true;
    settings.quality = unwrap::UnwrapQuality::Best;
    return settings;
}

Result<jobs::MapSettings> readBack(const QString &name, const jobs::MapSettings &before = {})
{
    const Result<Preset> preset = readPreset(name);
    if (!preset)
        return preset.error();
    const Result<jobs::PresetSettings> made = jobs::settingsOf(preset.value(), before);
    if (!made)
        return made.error();
    return made->settings;
}

//! The panel of the solver, and what its menu of presets does.
struct PresetBench : test::PanelBench
{
    test::Answers answers;
    SolverPanel panel{context, answers};
    PresetMenu &menu = *panel.findChild<PresetMenu *>();
    QSignalSpy said{&panel, &SolverPanel::said}, listed{&menu, &PresetMenu::listed};

    PresetBench()
    {
        workspace.open(std::make_unique<Document>(makeSample(u"torus"_s).value()), {});
        if (!test::showPanel(panel) || !(listed.count() > 0 || listed.wait()))
            qFatal("no panel");
    }

    QStringList names() const
    {
        QStringList names;
        for (const QAction *action : menu.actions()) {
            if (action->isSeparator())
                break;
            names << action->text();
        }
        return names;
    }
    //! Opens the menu by the mouse, and clicks on an entry.
    void choose(const QString &text)
    {
        QTimer::singleShot(0, &menu, [this, text] {
            for (QAction *action : menu.actions()) {
                if (action->text() == text)
                    return QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(action).center());
            }
            menu.close();
        });
        test::click(panel, "presets");
    }
    //! The user types this name when asked for one.
    void willName(const QString &name)
    {
        answers.onDialog = [name](QDialog &dialog) {
            child<QComboBox>(dialog, "name")->setEditText(name);
            return int(QDialog::Accepted);
        };
    }
    QString saveText() const { return menu.findChild<QAction *>(u"save"_s)->text(); }
    QMenu *removeMenu() const { return menu.findChild<QMenu *>(u"remove"_s); }
    jobs::MapSettings settings()
    {
        return {document().solveSettings(), document().packingSettings(), map.quality()};
    }
};

} // namespace

class TestPresets : public QObject
{
    Q_OBJECT

    QTemporaryDir mConfig;

private Q_SLOTS:
    void initTestCase() { qputenv("XDG_CONFIG_HOME", QFile::encodeName(mConfig.path())); }
    void init() { QDir(presetFolder()).removeRecursively(); }

    void everySettingIsKept()
    {
        const jobs::MapSettings settings = unusual();
        QVERIFY(savePreset(u"mine"_s, jobs::presetText(settings)));
        QCOMPARE(ownPresetNames(), QStringList{u"mine"_s});
        const auto again = readBack(u"mine"_s);
        QVERIFY2(again, qPrintable(again ? QString() : again.error().toString()));
        QVERIFY(again.value() == settings);
        QVERIFY(savePreset(u"mine"_s, jobs::presetText({})));
        QVERIFY(readBack(u"mine"_s).value() == jobs::MapSettings());
    }

    void seedsAreKept_data()
    {
        QTest::addColumn<int>("seed");
        for (const int seed : {0, 1'000'000, 2'000'000'000, std::numeric_limits<int>::max()})
            QTest::addRow("%d", seed) << seed;
    }
    void seedsAreKept()
    {
        QFETCH(int, seed);
        jobs::MapSettings settings;
        settings.solve.seed = seed;
        QVERIFY(savePreset(u"mine"_s, jobs::presetText(settings)));
        const auto again = readBack(u"mine"_s);
        QVERIFY2(again, qPrintable(again ? QString() : again.error().toString()));
        QVERIFY(again.value() == settings);
        QVERIFY(parseCommandLine(words("unwrap a -o b --preset mine")));
    }

    //! The command line takes every setting that the window saves, and makes the same of it.
    void theCommandLineReadsTheSame()
    {
        const jobs::MapSettings settings = unusual();
        QVERIFY(savePreset(u"mine"_s, jobs::presetText(settings)));
        const auto unwrap = parseCommandLine(words("unwrap a -o b --preset mine"));
        QVERIFY2(unwrap, qPrintable(unwrap ? QString() : unwrap.error().toString()));
        SolveSettings solve = unwrap->settings;
        solve.maxDistortion = unwrap->unwrap.maxDistortion;
        QVERIFY(solve == settings.solve);
        PackingSettings packing = unwrap->unwrap.packing;
        QCOMPARE(unwrap->unwrap.quality, settings.quality);
        packing.keepScale = parseCommandLine(words("pack a -o b --preset mine"))->unwrap.packing.keepScale;
        QVERIFY(packing == settings.packing);
    }

    void wrongValuesAreThoseOfTheCommandLine_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("value");
        for (const QString &name : jobs::settingNames()) {
            const QString switchValue = u"on"_s;
            for (const QString &value :
                 {switchValue, u"-1"_s, u"1e7"_s, u"0.5"_s, u"auto"_s, u"9999x"_s, u"8"_s})
                QTest::addRow("%s = %s", qPrintable(name), qPrintable(value)) << name << value;
        }
    }
    void wrongValuesAreThoseOfTheCommandLine()
    {
        QFETCH(QString, name);
        QFETCH(QString, value);
        QVERIFY(savePreset(u"wrong"_s, u"\n%1 = %2\n"_s.arg(name, value)));
        const auto window = readBack(u"wrong"_s);
        const QString command = name == u"keep-scale"_s ? u"pack"_s : u"unwrap"_s;
        const auto line = parseCommandLine({command, u"a"_s, u"-o"_s, u"b"_s, u"--preset"_s, u"wrong"_s});
        QCOMPARE(window.ok(), line.ok());
        if (!window)
            QVERIFY2(window.error().toString().contains(u"wrong.preset:2"_s),
                     qPrintable(window.error().toString()));
    }

    //! What presets do not hold stays, what one does not name gets its default.
    void theRestIsDefined()
    {
        jobs::MapSettings before = unusual();
        before.solve.lambda = 0.25;
        before.solve.delta = 0.125;
        jobs::MapSettings expected;
        expected.solve.lambda = 0.25;
        expected.solve.delta = 0.125;
        expected.solve.maxDistortion = 4.2;
        expected.solve.surface = SurfaceKind::Organic;
        expected.packing.setTexture(4096, 4096);
        QVERIFY(readBack(u"scan"_s, before).value() == expected);
    }

    void badNamesAreRefused_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"", "a/b", "a\\b", "..", ".hidden", "scan", "scan.preset"})
            QTest::addRow("'%s'", name) << QString::fromLatin1(name);
    }
    void badNamesAreRefused()
    {
        QFETCH(QString, name);
        QVERIFY(!savePreset(name, {}));
        QVERIFY(ownPresetNames().isEmpty());
    }

    void theMenuAppliesOneAsOneStep()
    {
        PresetBench bench;
        QCOMPARE(bench.names(), presetNames());
        const jobs::MapSettings before = bench.settings();
        bench.choose(u"film-udim"_s);
        QTRY_COMPARE(bench.said.count(), 1);
        const QString message = bench.said.front().front().toString();
        QVERIFY2(message.contains(u"film-udim"_s) && message.endsWith(u"per"_s), qPrintable(message));
        QCOMPARE(bench.settings().packing.textureSize, 4096);
        QCOMPARE(bench.settings().solve.maxDistortion, 4.03);
        QCOMPARE(bench.map.quality(), unwrap::UnwrapQuality::Best);
        QCOMPARE(child<QComboBox>(bench.panel, "quality")->currentIndex(), 2);
        QCOMPARE(bench.stack().count(), 1);
        bench.stack().undo();
        QVERIFY(bench.settings().solve == before.solve && bench.settings().packing == before.packing);
    }

    void theMenuSavesReplacesAndDeletes()
    {
        PresetBench bench;
        QVERIFY(!bench.removeMenu()->isEnabled());
        bench.choose(u"scan"_s);
        QTRY_COMPARE(bench.said.count(), 1);
        bench.willName(u"  my scans "_s);
        const auto listed = [&bench, count = bench.listed.count()] { return bench.listed.count() > count; };
        bench.choose(bench.saveText());
        QTRY_VERIFY(listed() && bench.names().contains(u"my scans"_s));
        QVERIFY(readBack(u"my scans"_s).value() == bench.settings());
        QVERIFY(bench.answers.confirmations.isEmpty());
        // Again: asked first, and left as it is when the user does not want it.
        bench.answers.confirms = false;
        bench.stack().undo();
        bench.choose(bench.saveText());
        QCOMPARE(bench.answers.confirmations.size(), 1);
        QVERIFY(readBack(u"my scans"_s).value() != bench.settings());
        QVERIFY(bench.removeMenu()->isEnabled());
        bench.removeMenu()->actions().front()->trigger();
        QVERIFY(presetNames().contains(u"my scans"_s));
        bench.answers.confirms = true;
        bench.removeMenu()->actions().front()->trigger();
        QTRY_VERIFY(!bench.names().contains(u"my scans"_s));
        QVERIFY(ownPresetNames().isEmpty() && bench.answers.errors.isEmpty());
    }

    void problemsAreShown()
    {
        QVERIFY(savePreset(u"broken"_s, u"margin = wide\n"_s));
        PresetBench bench;
        bench.choose(u"broken"_s);
        QTRY_COMPARE(bench.answers.errors.size(), 1);
        QVERIFY2(bench.answers.errors.front().contains(u"broken.preset:1: margin takes a number"_s),
                 qPrintable(bench.answers.errors.front()));
        QCOMPARE(bench.stack().count(), 0);
        bench.willName(u"game-prop"_s);
        bench.choose(bench.saveText());
        QTRY_COMPARE(bench.answers.errors.size(), 2);
    }

private:
    static QStringList words(const char *line) { return QString::fromLatin1(line).split(u' '); }
};

QTEST_MAIN(TestPresets)

} // namespace tst_presets

#include "tst_presets.moc"
