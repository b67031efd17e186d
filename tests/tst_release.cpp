// scripts/release in a small repository, with programs in the place of cmake and cpack: what it refuses, what
// it makes, and that a failure leaves all as it was.
#include "support/cliruns.h"

#include <QCryptographicHash>
#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>

namespace tst_release {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

const QString root = QStringLiteral(AUTOCUTS_SOURCE_DIR);

//! A repository with what the script reads.
class Repository
{
public:
    Repository()
    {
        QDir().mkpath(at(u"scripts"_s));
        QDir().mkpath(programs());
        for (const QString &name : {u"release"_s, u"lib.sh"_s})
            QFile::copy(root + u"/scripts/"_s + name, at(u"scripts/"_s + name));
        write(u"CMakeLists.txt"_s,
              "project(Autocuts VERSION 0.2.0 LANGUAGES CXX\n        DESCRIPTION \"maps\")\n");
        write(u"CHANGELOG.md"_s,
              "# Changelog\n\n## [Unreleased]\n\n- New\n\n## [0.2.0] - 2026-01-01\n\n- Old\n");
        write(u".gitignore"_s, "/build\n");
        program(u"cmake"_s, "mkdir -p build/package/packages; grep -o 'VERSION [0-9.]*' CMakeLists.txt > "
                            "build/package/packages/autocuts.deb");
        program(u"cpack"_s, "exit 0");
        program(u"lintian"_s, "exit 0");
        git(u"init -q -b main"_s);
        git(u"add ."_s);
        git(u"commit -q -m First"_s);
    }

    QString at(const QString &name) const { return mFolder.filePath(u"repository/"_s + name); }
    QString out(const QString &name) const { return at(u"build/release-0.3.0/"_s + name); }
    QString text(const QString &name) const { return QString::fromUtf8(test::readBytes(at(name))); }
    void write(const QString &name, const QByteArray &bytes) const
    {
        if (!test::writeBytes(at(name), bytes))
            qFatal("no file");
    }
    //! A program that the script finds first.
    void program(const QString &name, const QByteArray &line) const
    {
        const QString path = programs() + u'/' + name;
        if (!test::writeBytes(path, "#!/bin/sh\n" + line + "\n") ||
            !QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner))
            qFatal("no program");
    }

    test::CliRun run(const QString &command, const QStringList &arguments) const
    {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(u"PATH"_s, programs() + u':' + environment.value(u"PATH"_s));
        for (const QString &role : {u"AUTHOR"_s, u"COMMITTER"_s}) {
            environment.insert(u"GIT_%1_NAME"_s.arg(role), u"Test"_s);
            environment.insert(u"GIT_%1_EMAIL"_s.arg(role), u"test@example.org"_s);
        }
        process.setProcessEnvironment(environment);
        process.setWorkingDirectory(at({}));
        process.start(command, arguments);
        if (!process.waitForFinished(60'000))
            return {};
        return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
                QString::fromUtf8(process.readAllStandardError())};
    }
    QString git(const QString &line) const { return run(u"git"_s, line.split(u' ')).out.trimmed(); }
    test::CliRun release(const QString &version) const { return run(u"scripts/release"_s, {version}); }

private:
    QString programs() const { return mFolder.filePath(u"programs"_s); }

    QTemporaryDir mFolder;
};

} // namespace

class TestRelease : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        if (QStandardPaths::findExecutable(u"git"_s).isEmpty())
            QSKIP("no program: git");
    }

    void releasesAreWhole()
    {
        const Repository made;
        const test::CliRun run = made.release(u"0.3.0"_s);
        QVERIFY2(run.code == 0, qPrintable(run.err));
        QVERIFY(made.text(u"CMakeLists.txt"_s).startsWith(u"project(Autocuts VERSION 0.3.0 LANGUAGES"_s));
        static const QRegularExpression dated(
            u"## \\[Unreleased\\]\n\n## \\[0\\.3\\.0\\] - \\d{4}-\\d\\d-\\d\\d\n\n- New\n"_s);
        QVERIFY(made.text(u"CHANGELOG.md"_s).contains(dated));
        QCOMPARE(made.git(u"describe"_s), u"v0.3.0"_s);
        QCOMPARE(made.git(u"status --porcelain"_s), QString());
        QCOMPARE(test::readBytes(made.out(u"autocuts.deb"_s)), QByteArray("VERSION 0.3.0\n"));
        // The checksums are those of what lies there, and the tarball has the version.
        const QByteArray package = test::readBytes(made.out(u"autocuts.deb"_s));
        QVERIFY(test::readBytes(made.out(u"SHA256SUMS"_s))
                    .contains(QCryptographicHash::hash(package, QCryptographicHash::Sha256).toHex()));
        const test::CliRun unpacked = made.run(
            u"tar"_s, {u"-xOzf"_s, made.out(u"autocuts-0.3.0.tar.gz"_s), u"autocuts-0.3.0/CMakeLists.txt"_s});
        QCOMPARE(unpacked.out, made.text(u"CMakeLists.txt"_s));
    }

    void mistakesAreRefused_data()
    {
        QTest::addColumn<QString>("version");
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("message");
        QTest::newRow("no version") << QString() << QString() << u"name the version"_s;
        QTest::newRow("half a version") << u"0.3"_s << QString() << u"name the version"_s;
        QTest::newRow("a tag") << u"0.3.0"_s << u"tag v0.3.0"_s << u"there is a tag v0.3.0"_s;
        QTest::newRow("changes") << u"0.3.0"_s << u"mv CHANGELOG.md other"_s << u"not committed"_s;
        QTest::newRow("an old version") << u"0.2.0"_s << QString() << u"0.2.0 is not newer than 0.2.0"_s;
    }
    void mistakesAreRefused()
    {
        QFETCH(QString, version);
        QFETCH(QString, before);
        QFETCH(QString, message);
        const Repository made;
        if (!before.isEmpty())
            made.git(before);
        const QString head = made.git(u"rev-parse HEAD"_s);
        const test::CliRun run = made.release(version);
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains(message), qPrintable(run.err));
        QCOMPARE(made.git(u"rev-parse HEAD"_s), head);
    }

    void nothingNewIsNoRelease()
    {
        const Repository made;
        QCOMPARE(made.release(u"0.3.0"_s).code, 0);
        const test::CliRun again = made.release(u"0.4.0"_s);
        QCOMPARE(again.code, 1);
        QVERIFY2(again.err.contains(u"nothing is under Unreleased"_s), qPrintable(again.err));
    }

    void failuresLeaveAllAsItWas_data()
    {
        QTest::addColumn<QString>("program");
        for (const char *name : {"cmake", "cpack", "lintian"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void failuresLeaveAllAsItWas()
    {
        QFETCH(QString, program);
        const Repository made;
        made.program(program, "exit 1");
        const QString head = made.git(u"rev-parse HEAD"_s), changelog = made.text(u"CHANGELOG.md"_s);
        QVERIFY(made.release(u"0.3.0"_s).code != 0);
        QCOMPARE(made.git(u"rev-parse HEAD"_s), head);
        QCOMPARE(made.git(u"tag"_s), QString());
        QCOMPARE(made.git(u"status --porcelain"_s), QString());
        QCOMPARE(made.text(u"CHANGELOG.md"_s), changelog);
    }
};

QTEST_APPLESS_MAIN(TestRelease)

} // namespace tst_release

#include "tst_release.moc"
