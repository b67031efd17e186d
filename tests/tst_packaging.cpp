// What packages give to desktops and shells: completions, manual pages, menu entry, file type, thumbnails.
#include "cli/clicompletion.h"
#include "cli/clitable.h"
#include "model/io/formats/meshformats.h"
#include "model/io/projects/projectfile.h"
#include "model/samples/samples.h"
#include "support/cliruns.h"

#include <QBuffer>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>
#include <QTest>

namespace tst_packaging {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr const char *sessionType = "application/x-autocuts-session";

QString packaging(const char *name)
{
    return QStringLiteral(AUTOCUTS_SOURCE_DIR "/packaging/") + QString::fromLatin1(name);
}

bool isMissing(const char *program)
{
    return QStandardPaths::findExecutable(QString::fromLatin1(program)).isEmpty();
}

QStringList optionsOf(const CliCommand &command)
{
    QStringList names;
    for (const CliOption &option : cliOptions()) {
        if (command.takes(option.group))
            names << option.names;
    }
    return names;
}

//! The line of a desktop file with this key.
QString entry(const char *file, const QString &key)
{
    const QString text = QString::fromUtf8(test::readBytes(packaging(file)));
    return QRegularExpression(u"^"_s + key + u"=(.*)$"_s, QRegularExpression::MultilineOption)
        .match(text)
        .captured(1);
}

} // namespace

// scripts/test counts what was skipped for this reason.
#define SKIP_WITHOUT(PROGRAM)                                                                                \
    if (isMissing(PROGRAM))                                                                                  \
    QSKIP("no program: " PROGRAM)

class TestPackaging : public QObject, private test::OwnFolder
{
    Q_OBJECT

    QStringList mPackages; //!< that CMake looks for, without those that were looked at

private:
    //! What bash offers for the last of some words.
    QStringList offeredByBash(const QStringList &words)
    {
        const QString script = file("completion.bash", completionScript(u"bash"_s).toUtf8());
        const test::CliRun run = test::runProgram(
            u"bash"_s,
            QStringList{u"-c"_s,
                        u"compopt() { :; }\n. \"$0\"\nCOMP_WORDS=(\"$@\")\n"
                        "COMP_CWORD=$(($# - 1))\n_autocuts_cli\nprintf '%s\\n' \"${COMPREPLY[@]}\""_s,
                        script, u"autocuts-cli"_s} +
                words);
        return run.out.split(u'\n', Qt::SkipEmptyParts);
    }

private Q_SLOTS:
    //! Whoever builds elsewhere gets every library that CMake looks for.
    void librariesAreNamedForOtherSystems_data()
    {
        QTest::addColumn<QString>("vcpkg");
        QTest::addColumn<QString>("flatpak");
        const auto row = [](const char *package, const char *vcpkg, const char *flatpak) {
            QTest::newRow(package) << QString::fromLatin1(vcpkg) << QString::fromLatin1(flatpak);
        };
        row("Eigen3", "eigen3", "eigen");
        row("embree", "embree3", "embree");
        row("OpenMesh", "openmesh", "openmesh");
        row("CHOLMOD", "suitesparse-cholmod", "suitesparse");
        row("Qt6", "qtbase", "");
        row("assimp", "assimp", "assimp");
        row("draco", "draco", "draco");
        row("meshoptimizer", "meshoptimizer", "meshoptimizer");
        row("nlohmann_json", "nlohmann-json", "nlohmann-json");
        row("OpenEXR", "openexr", "openexr");
        row("ZLIB", "zlib", "");
        row("Threads", "", ""); // of the compiler
        row("OpenMP", "", "");
        static const QRegularExpression found(u"find_package\\((\\w+)"_s);
        const QString build =
            QString::fromUtf8(test::readBytes(QStringLiteral(AUTOCUTS_SOURCE_DIR "/CMakeLists.txt")));
        for (auto each = found.globalMatch(build); each.hasNext();)
            mPackages << each.next().captured(1);
        mPackages << u"CHOLMOD"_s;
        mPackages.removeDuplicates();
    }
    void librariesAreNamedForOtherSystems()
    {
        QFETCH(QString, vcpkg);
        QFETCH(QString, flatpak);
        mPackages.removeOne(QString::fromLatin1(QTest::currentDataTag()));
        const QJsonDocument manifest =
            QJsonDocument::fromJson(test::readBytes(QStringLiteral(AUTOCUTS_SOURCE_DIR "/vcpkg.json")));
        QStringList names{QString()};
        for (const QJsonValue &each : manifest[u"dependencies"_s].toArray())
            names << (each.isObject() ? each[u"name"_s] : each).toString();
        QVERIFY(names.contains(vcpkg));
        const QString modules =
            QString::fromUtf8(test::readBytes(packaging("flatpak/org.autocuts.Autocuts.yml")));
        QVERIFY(flatpak.isEmpty() || modules.contains(u"\n  - name: "_s + flatpak + u'\n'));
    }
    void noLibraryIsForgotten() { QCOMPARE(mPackages, QStringList()); }

    void bashOffersEveryCommandAndOption()
    {
        SKIP_WITHOUT("bash");
        QStringList commands;
        for (const CliCommand &command : cliCommands())
            commands << command.name;
        QStringList offered = offeredByBash({QString()});
        QCOMPARE(offered.mid(0, commands.size()), commands);
        for (const CliCommand &command : cliCommands()) {
            QStringList names = optionsOf(command), some = offeredByBash({command.name, u"-"_s});
            names.sort();
            some.sort();
            QCOMPARE(some, names);
        }
    }

    void bashOffersWordsAndFiles()
    {
        SKIP_WITHOUT("bash");
        const QStringList all{u"draft"_s, u"standard"_s, u"best"_s};
        QCOMPARE(offeredByBash({u"unwrap"_s, u"--quality"_s, QString()}), all);
        QCOMPARE(offeredByBash({u"unwrap"_s, u"--quality"_s, u"="_s, u"st"_s}), QStringList{u"standard"_s});
        QCOMPARE(offeredByBash({u"--completion"_s, u"z"_s}), QStringList{u"zsh"_s});
        QVERIFY(offeredByBash({u"unwrap"_s, u"--margin"_s, QString()}).isEmpty());
        const QString model = file("model.obj", test::quadCubeObj());
        QCOMPARE(offeredByBash({u"unwrap"_s, model.chopped(2)}), QStringList{model});
        QCOMPARE(offeredByBash({u"unwrap"_s, u"-o"_s, model.chopped(2)}), QStringList{model});
    }

    void otherShellsReadTheirFiles_data()
    {
        QTest::addColumn<QString>("shell");
        QTest::addColumn<QString>("longOption");
        QTest::newRow("zsh") << u"zsh"_s << u"'%1"_s;
        QTest::newRow("fish") << u"fish"_s << u" -l %1 "_s;
    }
    void otherShellsReadTheirFiles()
    {
        QFETCH(QString, shell);
        QFETCH(QString, longOption);
        const QString script = completionScript(shell);
        for (const CliOption &option : cliOptions()) {
            const QString name = option.names.last();
            QVERIFY2(script.contains(longOption.arg(shell == u"fish" ? name.mid(2) : name)),
                     qPrintable(name));
        }
        if (isMissing(qPrintable(shell)))
            QSKIP(qPrintable(u"no program: "_s + shell));
        const test::CliRun run = test::runProgram(shell, {u"-n"_s, file(qPrintable(shell), script.toUtf8())});
        QVERIFY2(run.code == 0, qPrintable(run.err));
    }

    //! fish says what it offers itself.
    void fishOffersEveryOption()
    {
        SKIP_WITHOUT("fish");
        const QString script = file("completion.fish", completionScript(u"fish"_s).toUtf8());
        for (const CliCommand &command : cliCommands()) {
            const test::CliRun run = test::runProgram(
                u"fish"_s, {u"-N"_s, u"-c"_s, u"source $argv[1]; complete -C \"autocuts-cli $argv[2] -\""_s,
                            script, command.name});
            for (const QString &name : optionsOf(command))
                QVERIFY2(run.out.contains(QRegularExpression(u"^"_s + name + u"\\b"_s,
                                                             QRegularExpression::MultilineOption)),
                         qPrintable(command.name + u' ' + name + run.err));
        }
    }

    void theStudiosManualPageHasItsOptions()
    {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        const test::CliRun run = test::runProgram(QStringLiteral(AUTOCUTS_STUDIO), {u"--help"_s});
        qunsetenv("QT_QPA_PLATFORM");
        const QString page =
            QString::fromUtf8(test::readBytes(QStringLiteral(AUTOCUTS_SOURCE_DIR "/docs/autocuts.1")));
        QRegularExpressionMatchIterator names = QRegularExpression(u"--([a-z-]+)"_s).globalMatch(run.out);
        int count = 0;
        for (; names.hasNext(); ++count) {
            const QString name = names.next().captured(1);
            QVERIFY2(page.contains(u"\\fB\\-\\-"_s + QString(name).replace(u'-', u"\\-"_s) + u"\\fR"_s),
                     qPrintable(name));
        }
        QCOMPARE(count, 5);
    }

    void manualPagesAreWellFormed()
    {
        SKIP_WITHOUT("man");
        qputenv("LC_ALL", "C.UTF-8");
        qputenv("MANROFFSEQ", "");
        for (const char *name : {"autocuts.1", "autocuts-cli.1"}) {
            const test::CliRun run = test::runProgram(
                u"man"_s, {u"--warnings"_s, u"-E"_s, u"UTF-8"_s, u"-l"_s, u"-Tutf8"_s, u"-Z"_s,
                           QStringLiteral(AUTOCUTS_SOURCE_DIR "/docs/") + QString::fromLatin1(name)});
            QCOMPARE(run.err, QString());
            QCOMPARE(run.code, 0);
        }
        qunsetenv("LC_ALL");
        qunsetenv("MANROFFSEQ");
    }

    void theMenuEntryIsValid()
    {
        SKIP_WITHOUT("desktop-file-validate");
        const test::CliRun run =
            test::runProgram(u"desktop-file-validate"_s, {packaging("org.autocuts.Autocuts.desktop")});
        QCOMPARE(run.out + run.err, QString());
        QCOMPARE(run.code, 0);
    }

    void theMetainfoIsValid()
    {
        SKIP_WITHOUT("appstreamcli");
        const test::CliRun run = test::runProgram(
            u"appstreamcli"_s, {u"validate"_s, u"--no-net"_s, QStringLiteral(AUTOCUTS_METAINFO)});
        QVERIFY2(run.code == 0, qPrintable(run.out + run.err));
    }

    //! Whoever opens, shows or describes sessions means the same type.
    void allNameTheSameType()
    {
        const QString type = QString::fromLatin1(sessionType);
        QVERIFY(entry("org.autocuts.Autocuts.desktop", u"MimeType"_s).startsWith(type + u';'));
        QCOMPARE(entry("autocuts.thumbnailer", u"MimeType"_s), type + u';');
        const QByteArray types = test::readBytes(packaging("autocuts.xml"));
        QVERIFY(types.contains(QByteArray("<mime-type type=\"") + sessionType + '"'));
        QVERIFY(types.contains(QByteArray("<glob pattern=\"*.") + projectSuffix + "\"/>"));
        QVERIFY(test::readBytes(QStringLiteral(AUTOCUTS_METAINFO))
                    .contains(QByteArray("<mediatype>") + sessionType + "</mediatype>"));
    }

    //! Models can be opened from the file manager. The common list of types has those of other names.
    void allModelsHaveAType()
    {
        const QString types = QString::fromUtf8(test::readBytes(packaging("autocuts.xml")));
        const QStringList opened = entry("org.autocuts.Autocuts.desktop", u"MimeType"_s).split(u';');
        for (const MeshFormat &format : meshFormats()) {
            QVERIFY2(opened.contains(format.mimeType), qPrintable(format.suffix));
            const bool isOurs = types.contains(u"<glob pattern=\"*."_s + format.suffix + u'"');
            QCOMPARE(isOurs, types.contains(u"type=\""_s + format.mimeType + u'"'));
            QVERIFY2(isOurs || !format.mimeType.startsWith(u"model/x-"_s), qPrintable(format.suffix));
        }
        QCOMPARE(opened.count(QString()), 1); // behind the last semicolon
        QCOMPARE(QSet<QString>(opened.begin(), opened.end()).size(), opened.size());
    }

    //! The desktop calls the thumbnailer with an output without a suffix.
    void sessionsShowTheirThumbnail()
    {
        QImage picture(64, 32, QImage::Format_RGB32);
        picture.fill(Qt::red);
        ProjectExtras extras;
        QBuffer buffer(&extras.thumbnail);
        QVERIFY(buffer.open(QIODevice::WriteOnly) && picture.save(&buffer, "PNG"));
        const Result<Scene> scene = makeSample(u"torus"_s);
        QVERIFY(scene.ok());
        const DocumentState state = DocumentState::initial(scene.value());
        const QString session = at("session.acproj"), out = at("picture");
        QVERIFY(saveProject(state, extras, session).ok());
        QStringList words = entry("autocuts.thumbnailer", u"Exec"_s).split(u' ');
        words.replaceInStrings(u"%i"_s, session)
            .replaceInStrings(u"%o"_s, out)
            .replaceInStrings(u"%s"_s, u"128"_s);
        QCOMPARE(words.takeFirst(), u"autocuts-cli"_s);
        const test::CliRun run = test::runInProcess(words);
        QVERIFY2(run.code == 0, qPrintable(run.err));
        const QImage shown(out, "PNG");
        QCOMPARE(shown.size(), QSize(128, 64));
        QCOMPARE(shown.pixel(64, 32), qRgb(255, 0, 0));
    }

    void modelsAreDrawn()
    {
        const QString model = file("cube.obj", test::quadCubeObj()), out = at("cube.png");
        const test::CliRun run =
            test::runInProcess({u"thumbnail"_s, model, u"-o"_s, out, u"--size"_s, u"64"_s});
        QVERIFY2(run.code == 0, qPrintable(run.err));
        const QImage drawn(out);
        QCOMPARE(drawn.size(), QSize(64, 64));
        QCOMPARE(qAlpha(drawn.pixel(0, 0)), 0);
        QCOMPARE(qAlpha(drawn.pixel(32, 32)), 255);
        // Three sides of a cube have three brightnesses.
        QVERIFY(drawn.pixel(32, 14) != drawn.pixel(18, 40));
        QVERIFY(drawn.pixel(18, 40) != drawn.pixel(46, 40));
        const QByteArray before = test::readBytes(model);
        QCOMPARE(test::runInProcess({u"thumbnail"_s, model, u"-o"_s, model}).code, 1);
        QCOMPARE(test::readBytes(model), before);
    }
};

QTEST_GUILESS_MAIN(TestPackaging)

} // namespace tst_packaging

#include "tst_packaging.moc"
