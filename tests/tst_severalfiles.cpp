// autocuts-cli in pipelines: several inputs, standard streams, what would be done, reports.
#include "cli/manyfiles/runjournal.h"
#include "support/cliruns.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTest>

namespace tst_severalfiles {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

test::CliRun run(const QString &line, const QByteArray &input = {})
{
    QProcess process;
    process.start(QStringLiteral(AUTOCUTS_CLI), line.split(u' ', Qt::SkipEmptyParts));
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(300'000) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

//! A folder with two models, their maps and sessions, in which nothing changes.
class Folder
{
public:
    Folder()
    {
        for (int i = 1; i <= 2; ++i) {
            if (!test::writeBytes(at(u"%1.obj"_s.arg(i)), test::sheetObj(2 + i)))
                qFatal("no file");
        }
        for (const QString &format : {u"obj"_s, u"acproj"_s}) {
            const test::CliRun made =
                run(u"unwrap --quality draft --pack-time 0 %1 %2 -o %3/ --output-format %4"_s.arg(
                    at(u"1.obj"_s), at(u"2.obj"_s), at(u"maps"_s), format));
            if (made.code != 0)
                qFatal("%s", qPrintable(made.err));
        }
    }
    QString at(const QString &name) const { return mFolder.filePath(name); }
    QString map(int i) const { return at(u"maps/%1.obj"_s.arg(i)); }
    QString session(int i) const { return at(u"maps/%1.acproj"_s.arg(i)); }
    QStringList names() const
    {
        return QDir(mFolder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
    }

private:
    QTemporaryDir mFolder;
};

} // namespace

class TestSeveralFiles : public QObject
{
    Q_OBJECT

private:
    Folder mFiles;

    //! The place where a test writes.
    QTemporaryDir mOut;
    QString out(const QString &name) const { return mOut.filePath(name); }

private Q_SLOTS:
    void everyCommandTakesSeveral_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QStringList>("made");
        const auto row = [](const QString &line, const QStringList &made) {
            QTest::newRow(qPrintable(line.section(u' ', 0, 0))) << line << made;
        };
        const QString maps = u" %1 %2 -o %3"_s.arg(mFiles.map(1), mFiles.map(2));
        for (const QString &command : {u"pack"_s, u"separate"_s, u"lightmap"_s, u"finish"_s})
            row(command + u" --pack-time 0"_s + maps, {u"1.obj"_s, u"2.obj"_s});
        row(u"transfer --from "_s + mFiles.map(1) + maps, {u"1.obj"_s, u"2.obj"_s});
        row(u"convert --output-format ply"_s + maps, {u"1.ply"_s, u"2.ply"_s});
        row(u"thumbnail --size 16"_s + maps, {u"1.png"_s, u"2.png"_s});
        row(u"bake --maps position --texture-size 16"_s + maps, {u"1"_s, u"2"_s});
        row(u"lightbake --texture-size 16 --samples 1 --sky 1,1,1"_s + maps, {u"1.exr"_s, u"2.exr"_s});
        row(u"replay %1 %2 -o %3"_s.arg(mFiles.session(1), mFiles.session(2)),
            {u"1.acproj"_s, u"2.acproj"_s});
    }
    void everyCommandTakesSeveral()
    {
        QFETCH(QString, line);
        QFETCH(QStringList, made);
        const QString folder = out(QString::fromLatin1(QTest::currentDataTag()));
        const test::CliRun done = run(line.arg(folder));
        QVERIFY2(done.code == 0, qPrintable(done.err));
        QCOMPARE(done.out, u"done: 2\n"_s);
        for (const QString &name : made)
            QVERIFY2(QFileInfo::exists(folder + u'/' + name), qPrintable(name));
    }

    //! What is named is done, also where its folder is the one of the outputs.
    void filesInPlace()
    {
        QVERIFY(test::writeBytes(out(u"a.obj"_s), test::sheetObj(3)));
        QVERIFY(test::writeBytes(out(u"b.obj"_s), test::sheetObj(4)));
        const test::CliRun done = run(u"unwrap --quality draft --pack-time 0 %1 %2 -o %3"_s.arg(
            out(u"a.obj"_s), out(u"b.obj"_s), mOut.path()));
        QVERIFY2(done.code == 0, qPrintable(done.err));
        QCOMPARE(done.out, u"done: 2\n"_s);
        QVERIFY(test::readBytes(out(u"a.obj"_s)).contains("vt "));
    }

    void severalAreChecked()
    {
        const QString files = u"check %1 %2"_s.arg(mFiles.map(1), mFiles.at(u"2.obj"_s));
        const QStringList before = mFiles.names();
        const test::CliRun fine = run(files);
        QCOMPARE(fine.code, 0);
        QVERIFY2(fine.out.startsWith(mFiles.map(1) + u": no problems found\n"_s), qPrintable(fine.out));
        const test::CliRun bad = run(files + u" --fail-on missing --json"_s);
        QCOMPARE(bad.code, 4);
        const QJsonDocument report = QJsonDocument::fromJson(bad.out.toUtf8());
        QCOMPARE(report[u"counts"_s][u"check_failed"_s].toInt(), 1);
        const QJsonValue second = report[u"files"_s][1];
        QCOMPARE(second[u"status"_s].toString(), u"check_failed"_s);
        QVERIFY2(second[u"message"_s].toString().contains(u"UV"_s),
                 qPrintable(second[u"message"_s].toString()));
        QCOMPARE(run(files + u" %1 --fail-on missing"_s.arg(mFiles.at(u"none.obj"_s))).code, 1);
        QCOMPARE(run(files + u" --quiet"_s).out, QString());
        QCOMPARE(mFiles.names(), before);
    }

    //! The model is read, and all is as it was.
    void dryRunsWriteNothing_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QStringList>("targets");
        const auto row = [](const char *name, const QString &line, const QStringList &targets) {
            QTest::newRow(name) << line << targets;
        };
        row("unwrap", u"unwrap %1 -o %2/a.obj --report %2/a.json --layout %2/a.png"_s,
            {u"a.obj"_s, u"a.png"_s, u"a.json"_s});
        row("pack", u"pack %1 -o %2/a.obj"_s, {u"a.obj"_s});
        row("transfer", u"transfer %1 --from %1 -o %2/a.obj"_s, {u"a.obj"_s});
        row("bake", u"bake %1 -o %2/a"_s, {u"a"_s});
        row("lightbake", u"lightbake %1 -o %2/a.exr"_s, {u"a.exr"_s});
        row("convert", u"convert %1 -o %2/a.ply"_s, {u"a.ply"_s});
        row("thumbnail", u"thumbnail %1 -o %2/a.png"_s, {u"a.png"_s});
    }
    void dryRunsWriteNothing()
    {
        QFETCH(QString, line);
        QFETCH(QStringList, targets);
        QTemporaryDir folder;
        const test::CliRun plan = run(line.arg(mFiles.map(1), folder.path()) + u" --dry-run"_s);
        QVERIFY2(plan.code == 0, qPrintable(plan.err));
        QString said;
        for (const QString &target : targets)
            said += u"%1 -> %2\n"_s.arg(mFiles.map(1), folder.filePath(target));
        QCOMPARE(plan.out, said);
        QVERIFY(QDir(folder.path()).isEmpty());
        // What the command would refuse, is refused.
        QCOMPARE(run(line.arg(mFiles.at(u"none.obj"_s), folder.path()) + u" --dry-run"_s).code, 1);
    }

    void dryRunsOfOtherThings()
    {
        const QString torus = out(u"torus.obj"_s);
        QCOMPARE(run(u"sample torus --dry-run -o "_s + torus).out, u"torus -> %1\n"_s.arg(torus));
        QVERIFY(!QFileInfo::exists(torus));
        QCOMPARE(run(u"check --dry-run "_s + mFiles.map(1)).out,
                 mFiles.map(1) + u": nothing would be written\n"_s);
        QCOMPARE(run(u"replay --dry-run "_s + mFiles.session(1)).out,
                 mFiles.session(1) + u": nothing would be written\n"_s);
        QCOMPARE(run(u"unwrap - -o - --dry-run"_s, test::sheetObj(3)).out,
                 u"standard input -> standard output\n"_s);
        const QString folder = out(u"planned"_s);
        QCOMPARE(run(u"pack --dry-run %1 %2 -o %3"_s.arg(mFiles.map(1), mFiles.map(2), folder)).out,
                 u"%1 -> %3/1.obj\n%2 -> %3/2.obj\n"_s.arg(mFiles.map(1), mFiles.map(2), folder));
        QVERIFY(!QFileInfo::exists(folder));
    }

    //! A folder is not made by mistake where a file was meant.
    void theOutputsNeedAFolder()
    {
        const QString file = out(u"both.obj"_s);
        const test::CliRun refused = run(u"pack %1 %2 -o %3"_s.arg(mFiles.map(1), mFiles.map(2), file));
        QCOMPARE(refused.code, 1);
        QVERIFY2(refused.err.contains(u"several files need a folder"_s), qPrintable(refused.err));
        QVERIFY(!QFileInfo::exists(file));
    }

    //! No message or report names a file that the user does not know.
    void streamsHaveNames()
    {
        const test::CliRun broken = run(u"check -"_s, "v 0 0\n");
        QCOMPARE(broken.code, 1);
        QVERIFY2(broken.err.startsWith(u"autocuts-cli: standard input:1: "_s), qPrintable(broken.err));
        const QString report = out(u"report.json"_s);
        const test::CliRun mapped =
            run(u"unwrap --quality draft --pack-time 0 - -o - --report "_s + report, test::sheetObj(3));
        QCOMPARE(mapped.code, 0);
        const QJsonDocument said = QJsonDocument::fromJson(test::readBytes(report));
        QCOMPARE(said[u"input"_s].toString(), u"standard input"_s);
        QCOMPARE(said[u"output"_s].toString(), u"standard output"_s);
        QVERIFY(!test::readBytes(report).contains("stdin."));
    }

    //! Every command with one input and one output can stand in a pipe.
    void everyCommandTakesStreams_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QByteArray>("input");
        QTest::addColumn<QByteArray>("begins");
        const QByteArray map = test::readBytes(mFiles.map(1)), session = test::readBytes(mFiles.session(1));
        const auto row = [](const QString &line, const QByteArray &input, const QByteArray &begins) {
            QTest::newRow(qPrintable(line.section(u' ', 0, 0))) << line << input << begins;
        };
        row(u"lightbake --texture-size 16 --samples 1 --sky 1,1,1 - -o -"_s, map, "\x76\x2f\x31\x01");
        row(u"thumbnail --size 16 - -o -"_s, map, "\x89PNG");
        row(u"convert - -o - --output-format ply"_s, map, "ply");
        row(u"replay - -o - --output-format ply"_s, session, "ply");
        row(u"sample torus -o - --output-format ply"_s, {}, "ply");
        row(u"check - --report -"_s, map, "{");
        row(u"pack --pack-time 0 - -o %1 --report -"_s.arg(out(u"piped.obj"_s)), map, "{");
    }
    void everyCommandTakesStreams()
    {
        QFETCH(QString, line);
        QFETCH(QByteArray, input);
        QFETCH(QByteArray, begins);
        QProcess process;
        process.start(QStringLiteral(AUTOCUTS_CLI), line.split(u' '));
        process.write(input);
        process.closeWriteChannel();
        QVERIFY(process.waitForFinished(60'000));
        QVERIFY2(process.exitCode() == 0, process.readAllStandardError().constData());
        const QByteArray said = process.readAllStandardOutput();
        QVERIFY2(said.startsWith(begins), said.left(200).constData());
    }

    void reportsOfConversionsAndReplays()
    {
        const QString report = out(u"figures.json"_s);
        const auto said = [&](const QString &line) {
            const test::CliRun done = run(line + u" --report "_s + report);
            return done.code == 0 ? QJsonDocument::fromJson(test::readBytes(report)) : QJsonDocument();
        };
        const QJsonDocument converted = said(u"convert %1 -o %2"_s.arg(mFiles.map(1), out(u"c.ply"_s)));
        QCOMPARE(converted[u"triangles"_s].toInt(), 18);
        QCOMPARE(converted[u"flipped"_s].toInt(-1), 0);
        QCOMPARE(converted[u"output"_s].toString(), out(u"c.ply"_s));
        const QJsonDocument replayed = said(u"replay "_s + mFiles.session(1));
        QCOMPARE(replayed[u"status"_s].toString(), u"done"_s);
        QCOMPARE(replayed[u"triangles"_s].toInt(), 18);
        QVERIFY(replayed[u"notes"_s].toArray().contains(u"the result is what the session holds"_s));
    }

    //! Progress for programs and --json are what was asked for; only what is for people is left out.
    void quietIsForPeople()
    {
        QCOMPARE(run(u"check --quiet "_s + mFiles.map(1)).out, QString());
        QVERIFY(run(u"check --quiet --json "_s + mFiles.map(1)).out.startsWith(u'{'));
        const test::CliRun done = run(u"unwrap --quality draft --quiet --progress json %1 -o %2"_s.arg(
            mFiles.at(u"1.obj"_s), out(u"quiet.obj"_s)));
        QCOMPARE(done.out, QString());
        QVERIFY2(done.err.startsWith(u'{'), qPrintable(done.err));
    }

    void batchesKeepOutOfEachOthersWay_data()
    {
        QTest::addColumn<int>("part");
        QTest::addColumn<int>("parts");
        QTest::addColumn<QString>("other");
        QTest::addColumn<int>("code");
        QTest::newRow("all twice") << 0 << 0 << QString() << 1;
        QTest::newRow("all beside a part") << 1 << 3 << QString() << 1;
        QTest::newRow("a part beside all") << 0 << 0 << u"1/3"_s << 1;
        QTest::newRow("a part twice") << 1 << 3 << u"1/3"_s << 1;
        QTest::newRow("other parts") << 1 << 3 << u"2/4"_s << 1;
        QTest::newRow("two parts") << 1 << 3 << u"2/3"_s << 0;
    }
    void batchesKeepOutOfEachOthersWay()
    {
        QFETCH(int, part);
        QFETCH(int, parts);
        QFETCH(QString, other);
        ManyChoice choice;
        choice.part = part;
        choice.parts = parts;
        QTemporaryDir folder;
        const auto lock = manyfiles::RunJournal::lock(choice, folder.path());
        QVERIFY(lock);
        const QString line =
            u"batch convert --format ply %1 %2 -o %3"_s.arg(mFiles.map(1), mFiles.map(2), folder.path());
        const test::CliRun done = run(other.isEmpty() ? line : line + u" --part "_s + other);
        QTEST(done.code, "code");
        QCOMPARE(done.err.contains(u"another batch works in this folder"_s), done.code == 1);
    }
};

QTEST_APPLESS_MAIN(TestSeveralFiles)

} // namespace tst_severalfiles

#include "tst_severalfiles.moc"
