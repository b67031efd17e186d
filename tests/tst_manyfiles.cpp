// autocuts-cli batch: many files, some of them bad, and batches that are killed and go on.
#include "cli/manyfiles/filelist.h"
#include "cli/manyfiles/filerunner.h"
#include "cli/manyfiles/runreport.h"
#include "jobs/nearestname.h"
#include "support/cliruns.h"

#include <QDir>
#include <QDirIterator>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTest>

#include <csignal>

namespace tst_manyfiles {

using namespace autocuts;
using namespace autocuts::manyfiles;
using namespace Qt::Literals::StringLiterals;

namespace {

QString program()
{
    return QStringLiteral(AUTOCUTS_CLI);
}

QStringList words(const QString &line)
{
    return line.split(u' ', Qt::SkipEmptyParts);
}

//! Enough of a file for the reader to be started.
constexpr const char *plyHeader = "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n";

//! A folder of models, and one for what is made of them.
class Place
{
public:
    explicit Place(int models)
    {
        QDir().mkpath(in(u"a/deep"_s));
        for (int i = 0; i < models; ++i)
            add(u"%1%2.obj"_s.arg(i % 3 == 0 ? u"a/deep/"_s : QString()).arg(i, 3, 10, QLatin1Char('0')),
                test::sheetObj(3 + i % 4));
    }

    QString in(const QString &name = {}) const { return mFolder.filePath(u"in/"_s + name); }
    QString out(const QString &name = {}) const { return mFolder.filePath(u"out/"_s + name); }
    QString at(const QString &name) const { return mFolder.filePath(name); }
    void add(const QString &name, const QByteArray &bytes) const
    {
        if (!test::writeBytes(in(name), bytes))
            qFatal("no file");
    }

    QStringList arguments(const QString &more = {}, const QString &folder = u"out"_s) const
    {
        return words(u"batch unwrap --quality draft --pack-time 0 "_s + more) +
               QStringList{in(), u"-o"_s, at(folder)};
    }
    test::CliRun run(const QString &more = {}, const QString &folder = u"out"_s) const
    {
        return test::runProgram(program(), arguments(more, folder));
    }

    //! The lines of the journal behind the first.
    QJsonArray journal(const QString &folder = u"out"_s) const
    {
        QJsonArray lines;
        for (const QByteArray &line :
             test::readBytes(at(folder + u"/autocuts-batch.jsonl"_s)).split('\n').mid(1)) {
            if (const QJsonDocument content = QJsonDocument::fromJson(line); content.isObject())
                lines.append(content.object());
        }
        return lines;
    }
    QJsonObject lineOf(const QString &input) const
    {
        for (const QJsonValue &line : journal()) {
            if (line[u"input"_s].toString().endsWith(input))
                return line.toObject();
        }
        return {};
    }

    //! The outputs by their paths.
    static std::map<QString, QByteArray> outputsIn(const QString &folder)
    {
        std::map<QString, QByteArray> outputs;
        QDirIterator each(folder, {u"*.obj"_s}, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (each.hasNext()) {
            const QString path = each.next();
            outputs[QDir(folder).relativeFilePath(path)] = test::readBytes(path);
        }
        return outputs;
    }

private:
    QTemporaryDir mFolder;
};

//! Puts a script in the place of autocuts-reader: it dies of a signal or hangs, as the name of the file says.
class BadReader
{
public:
    BadReader()
    {
        const QString path = mFolder.filePath(u"reader"_s);
        if (!test::writeBytes(
                path, "#!/bin/sh\ncase \"$*\" in *endless*) exec sleep 1000 ;; esac\nkill -SEGV $$\n") ||
            !QFile::setPermissions(path, QFile::ReadOwner | QFile::ExeOwner))
            qFatal("the script cannot be written");
        qputenv("AUTOCUTS_READER", QFile::encodeName(path));
    }
    ~BadReader() { qunsetenv("AUTOCUTS_READER"); }
    BadReader(const BadReader &) = delete;
    BadReader &operator=(const BadReader &) = delete;

private:
    QTemporaryDir mFolder;
};

} // namespace

class TestManyFiles : public QObject
{
    Q_OBJECT

private:
    //! Starts a batch and sends it a signal as soon as its journal has so many lines.
    static void endEarly(const Place &place, const QString &more, int lines, int signal)
    {
        QProcess process;
        process.start(program(), place.arguments(more));
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(place.journal().size() >= lines, 120'000);
        ::kill(pid_t(process.processId()), signal);
        QVERIFY(process.waitForFinished(60'000));
        if (signal == SIGINT)
            QCOMPARE(process.exitCode(), 130);
    }

private Q_SLOTS:
    void patterns_data()
    {
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<QString>("path");
        QTest::addColumn<bool>("matches");
        QTest::newRow("name") << u"*.obj"_s << u"a.obj"_s << true;
        QTest::newRow("not into folders") << u"*.obj"_s << u"b/a.obj"_s << false;
        QTest::newRow("any folders") << u"x/**/*.obj"_s << u"x/b/c/a.obj"_s << true;
        QTest::newRow("no folder") << u"x/**/*.obj"_s << u"x/a.obj"_s << true;
        QTest::newRow("one letter") << u"a?.obj"_s << u"ab.obj"_s << true;
        QTest::newRow("a set") << u"[ab].obj"_s << u"b.obj"_s << true;
        QTest::newRow("not in a set") << u"[!ab].obj"_s << u"b.obj"_s << false;
        QTest::newRow("a dot is a dot") << u"*.obj"_s << u"aXobj"_s << false;
    }
    void patterns()
    {
        QFETCH(QString, pattern);
        QFETCH(QString, path);
        QTEST(matchesPattern(path, pattern), "matches");
    }

    void treesAreKept()
    {
        const Place place(4);
        place.add(u"notes.txt"_s, "not a model");
        ManyChoice choice;
        choice.command = u"unwrap"_s;
        const auto outputs = [&](const QStringList &inputs) {
            choice.inputs = inputs;
            const auto tasks = fileTasks(choice, place.out());
            QStringList names;
            for (const FileTask &task : tasks ? tasks.value() : std::vector<FileTask>())
                names << task.output;
            return tasks ? names : QStringList{tasks.error().message};
        };
        QCOMPARE(outputs({place.in()}),
                 (QStringList{u"001.obj"_s, u"002.obj"_s, u"a/deep/000.obj"_s, u"a/deep/003.obj"_s}));
        QCOMPARE(outputs({place.in(u"**/*3.obj"_s)}), QStringList{u"a/deep/003.obj"_s});
        QCOMPARE(outputs({place.in(u"*.obj"_s), place.in(u"001.obj"_s)}),
                 (QStringList{u"001.obj"_s, u"002.obj"_s}));
        QCOMPARE(outputs({place.in(u"*.fbx"_s)}), QStringList{u"no models found"_s});
        choice.format = u"glb"_s;
        QCOMPARE(outputs({place.in(u"001.obj"_s)}), QStringList{u"001.glb"_s});
        place.add(u"001.ply"_s, "ply");
        QVERIFY(outputs({place.in()}).front().startsWith(u"the output 001.glb would be that of"_s));
        choice.format.clear();
        place.add(u"a/part.LWO"_s, "lwo");
        place.add(u"a/scan.stl"_s, "stl");
        QCOMPARE(outputs({place.in(u"a/*"_s)}), (QStringList{u"part.fbx"_s, u"scan.obj"_s}));
        choice.command = u"bake"_s;
        QCOMPARE(outputs({place.in(u"a/**/*0.obj"_s)}), QStringList{u"deep/000"_s});
    }

    //! What a batch has made is none of its models.
    void theOutputsMayLieBelowTheModels()
    {
        const Place place(2);
        for (int i = 0; i < 2; ++i) {
            const test::CliRun run =
                test::runProgram(program(), words(u"batch pack --dry-run"_s) +
                                                QStringList{place.in(), u"-o"_s, place.in(u"made"_s)});
            QCOMPARE(run.code, 0);
            QCOMPARE(run.out.count(u'\n'), 2);
            QDir().mkpath(place.in(u"made"_s));
            place.add(u"made/000.obj"_s, test::quadCubeObj());
        }
    }

    void largeFilesAreWorkedOnAlone()
    {
        FileTask small, large;
        small.bytes = 1000;
        large.bytes = 1'000'000'000;
        RunLimits limits;
        limits.jobs = 2;
        limits.memory = 2 * expectedMemory(small);
        QVERIFY(mayBegin(large, limits, 0, 0));
        QVERIFY(!mayBegin(small, limits, 1, expectedMemory(large)));
        QVERIFY(!mayBegin(large, limits, 1, expectedMemory(small)));
        QVERIFY(mayBegin(small, limits, 1, expectedMemory(small)));
        QVERIFY(!mayBegin(small, limits, 2, 0));
    }

    void badFilesStopNothing()
    {
        const BadReader reader;
        const Place place(6);
        place.add(u"broken.obj"_s, "v 0 0\n");
        place.add(u"crash.ply"_s, plyHeader);
        const test::CliRun run = place.run(u"--jobs 2"_s);
        QCOMPARE(run.code, 1);
        QCOMPARE(run.out, u"done: 6\nfailed: 2\n"_s);
        QVERIFY2(run.err.contains(u"broken.obj:1: a vertex has fewer than three coordinates"_s),
                 qPrintable(run.err));
        QVERIFY(place.lineOf(u"crash.ply"_s)[u"message"_s].toString().contains(u"cannot be read"_s));
        QVERIFY(!place.lineOf(u"crash.ply"_s)[u"message"_s].toString().contains(u"crash.ply: "_s));
        QCOMPARE(place.lineOf(u"001.obj"_s)[u"figures"_s][u"flipped"_s].toInt(-1), 0);
        QCOMPARE(Place::outputsIn(place.out()).size(), std::size_t(6));
    }

    void endlessFilesAreGivenUp()
    {
        const BadReader reader;
        const Place place(0);
        place.add(u"endless.ply"_s, plyHeader);
        const test::CliRun run = place.run(u"--file-limit 0.5"_s);
        QCOMPARE(run.code, 1);
        QCOMPARE(run.out, u"timed_out: 1\n"_s);
        QCOMPARE(place.lineOf(u"endless.ply"_s)[u"message"_s].toString(), u"took longer than 0.5 s"_s);
    }

    //! Killed twice, then interrupted: in the end all is as if nothing had happened, and no file was done
    //! twice.
    void killedBatchesGoOn()
    {
        const Place place(24);
        place.add(u"broken.obj"_s, "v 0 0\n");
        QCOMPARE(place.run(u"--jobs 1"_s, u"undisturbed"_s).code, 1);
        endEarly(place, u"--jobs 2"_s, 3, SIGKILL);
        endEarly(place, u"--jobs 2 --resume"_s, 9, SIGKILL);
        endEarly(place, u"--jobs 2 --resume"_s, 14, SIGINT);
        QVERIFY(place.journal().size() < 25);
        const test::CliRun run = place.run(u"--jobs 2 --resume"_s);
        QCOMPARE(run.code, 1);
        QCOMPARE(run.out, u"done: 24\nfailed: 1\n"_s);
        QStringList done;
        for (const QJsonValue &line : place.journal())
            done << line[u"output"_s].toString();
        QCOMPARE(done.size(), 25);
        QCOMPARE(done.removeDuplicates(), 0);
        QCOMPARE(Place::outputsIn(place.out()), Place::outputsIn(place.at(u"undisturbed"_s)));
    }

    //! As an array of jobs does: each part by itself, then a batch that takes them over.
    void partsAreTakenOver()
    {
        const Place place(7);
        place.add(u"broken.obj"_s, "v 0 0\n");
        QCOMPARE(place.run({}, u"whole"_s).code, 1);
        QStringList said;
        for (const QString &part : {u"1/3"_s, u"2/3"_s, u"3/3"_s})
            said << place.run(u"--resume --part "_s + part).out;
        QCOMPARE(said.join(QString()).count(u"failed: 1"_s), 1);
        QCOMPARE(said.count(u"done: 3\n"_s) + said.count(u"done: 2\nfailed: 1\n"_s), 2);
        QCOMPARE(said.count(u"done: 2\n"_s) + said.count(u"done: 1\nfailed: 1\n"_s), 1);
        QCOMPARE(place.journal().size(), 0);
        const test::CliRun run = place.run(u"--resume --progress json"_s);
        QCOMPARE(run.err, QString()); // nothing was left to do
        QCOMPARE(run.out, u"done: 7\nfailed: 1\n"_s);
        QCOMPARE(place.journal().size(), 8);
        QCOMPARE(Place::outputsIn(place.out()), Place::outputsIn(place.at(u"whole"_s)));
        // A part that is done again replaces what had failed.
        place.add(u"broken.obj"_s, test::sheetObj(4));
        for (const QString &part : {u"1/3"_s, u"2/3"_s, u"3/3"_s})
            QCOMPARE(place.run(u"--resume --part "_s + part).code, 0);
        const test::CliRun again = place.run(u"--resume --progress json"_s);
        QCOMPARE(again.err, QString());
        QCOMPARE(again.out, u"done: 8\n"_s);
        // From the beginning, the parts of before count no more.
        QCOMPARE(place.run(u"--part 1/3"_s).code, 0);
        QVERIFY(QFile::exists(place.out(u"autocuts-batch.2-of-3.jsonl"_s)));
        QCOMPARE(place.run().code, 0);
        QVERIFY(!QFile::exists(place.out(u"autocuts-batch.2-of-3.jsonl"_s)));
    }

    void partsAreNumbered_data()
    {
        QTest::addColumn<QString>("part");
        for (const char *part : {"0/3", "4/3", "1", "1/0", "a/b"})
            QTest::newRow(part) << QString::fromLatin1(part);
    }
    void partsAreNumbered()
    {
        QFETCH(QString, part);
        const test::CliRun run = Place(1).run(u"--part "_s + part);
        QCOMPARE(run.code, 2);
        QVERIFY2(run.err.contains(u"K/N with K from 1 to N"_s), qPrintable(run.err));
    }

    //! A farm is told what to do and tells what came of it; what it has not told is still to be done.
    void workIsDoneElsewhere()
    {
        const Place place(3);
        QProcess process;
        process.start(program(), place.arguments(u"--elsewhere --format ply"_s));
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY(process.canReadLine());
        const QJsonDocument head = QJsonDocument::fromJson(process.readLine());
        QCOMPARE(head[u"arguments"_s].toVariant().toStringList(),
                 words(u"batch unwrap --quality=draft --pack-time=0 --format=ply"_s));
        QCOMPARE(head[u"files"_s].toInt(), 3);
        QTRY_VERIFY(process.canReadLine());
        QCOMPARE(QJsonDocument::fromJson(process.readLine())[u"output"_s].toString(), u"001.ply"_s);
        process.write(
            "{\"output\": \"001.ply\", \"status\": \"failed\", \"message\": \"no luck\"}\n{\"output");
        process.closeWriteChannel();
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitCode(), 1);
        QCOMPARE(place.lineOf(u"001.obj"_s)[u"message"_s].toString(), u"no luck"_s);
        QCOMPARE(place.lineOf(u"001.obj"_s)[u"bytes"_s].toInt(), int(test::sheetObj(4).size()));
        QCOMPARE(place.journal().size(), 1);
    }

    void theJournalMayLieElsewhere()
    {
        const Place place(2);
        QCOMPARE(place.run(u"--journal "_s + place.at(u"notes"_s)).code, 0);
        QCOMPARE(place.journal(u"notes"_s).size(), 2);
        QVERIFY(!QFile::exists(place.out(u"autocuts-batch.jsonl"_s)));
    }

    void onlyWhatHasChangedIsDoneAgain()
    {
        const Place place(3);
        place.add(u"broken.obj"_s, "v 0 0\n");
        QCOMPARE(place.run().code, 1);
        const auto doneAgain = [&](const QString &more) {
            const test::CliRun run = place.run(u"--progress json "_s + more);
            QStringList inputs;
            for (const QString &line : run.err.split(u'\n', Qt::SkipEmptyParts))
                inputs << QFileInfo(QJsonDocument::fromJson(line.toUtf8())[u"input"_s].toString()).fileName();
            return inputs;
        };
        QCOMPARE(doneAgain(u"--resume"_s), QStringList());
        QCOMPARE(doneAgain(u"--retry"_s), QStringList{u"broken.obj"_s});
        place.add(u"001.obj"_s, test::sheetObj(5));
        QVERIFY(QFile::remove(place.out(u"002.obj"_s)));
        QCOMPARE(doneAgain(u"--resume --jobs 1"_s), (QStringList{u"001.obj"_s, u"002.obj"_s}));
        const test::CliRun other = place.run(u"--resume --margin 3"_s);
        QCOMPARE(other.code, 1);
        QVERIFY2(other.err.contains(u"other options"_s), qPrintable(other.err));
    }

    //! A kill may leave half a line.
    void halfALineCountsNot()
    {
        const Place place(3);
        QCOMPARE(place.run(u"--jobs 1"_s).code, 0);
        QFile journal(place.out(u"autocuts-batch.jsonl"_s));
        QVERIFY(journal.open(QIODevice::ReadWrite) && journal.resize(journal.size() - 5));
        journal.close();
        QCOMPARE(place.journal().size(), 2);
        QCOMPARE(place.run(u"--resume"_s).code, 0);
        QCOMPARE(place.journal().size(), 3);
    }

    void reportsSayAll()
    {
        const Place place(2);
        place.add(u"bro,ken.obj"_s, "v 0 0\n");
        const QString json = place.at(u"report.json"_s), csv = place.at(u"report.csv"_s),
                      page = place.at(u"report.html"_s);
        QCOMPARE(place.run(u"--report "_s + json).code, 1);
        const QJsonDocument report = QJsonDocument::fromJson(test::readBytes(json));
        QCOMPARE(report[u"counts"_s][u"done"_s].toInt(), 2);
        QCOMPARE(report[u"files"_s].toArray().size(), 3);
        QCOMPARE(place.run(u"--resume --report "_s + csv).code, 1);
        const QList<QByteArray> rows = test::readBytes(csv).trimmed().split('\n');
        QCOMPARE(rows.size(), 4);
        QVERIFY(rows[0].startsWith("input,output,status,message,warnings,seconds,triangles,"));
        QVERIFY(rows[2].contains("\"bro,ken.obj\",failed,") || rows[3].contains("\"bro,ken.obj\",failed,"));
        // Again, with another model: the page has what has changed since then.
        place.add(u"001.obj"_s, test::sheetObj(9));
        QCOMPARE(place.run(u"--report "_s + page).code, 1);
        const QString html = QString::fromUtf8(test::readBytes(page));
        QCOMPARE(html.count(u"data:image/png;base64,"_s), 2);
        QVERIFY(html.contains(u"<small>+"_s));
        QVERIFY(html.indexOf(u"class=\"u0\""_s) < html.indexOf(u"class=\"u2\""_s));
        QVERIFY(!html.contains(u"http"_s)); // it needs no other file
        const qsizetype at = html.indexOf(u"base64,"_s) + 7;
        const QImage picture = QImage::fromData(
            QByteArray::fromBase64(html.mid(at, html.indexOf(u'"', at) - at).toLatin1()), "PNG");
        QCOMPARE(picture.size(), QSize(320, 160));
        QVERIFY(qAlpha(picture.pixel(80, 80)) == 255 && qAlpha(picture.pixel(240, 80)) == 255);
    }

    void aReportThatCannotBeWrittenIsToldBeforeTheWork()
    {
        const Place place(2);
        const test::CliRun run = place.run(u"--report "_s + place.at(u"none/report.csv"_s));
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains(u"the output folder does not exist"_s), qPrintable(run.err));
        QVERIFY(Place::outputsIn(place.out()).empty());
        QVERIFY(place.journal().isEmpty());
    }

    void everyCommandOfFilesCanBeDone_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("output");
        QTest::newRow("pack") << u"pack"_s << u"001.obj"_s;
        QTest::newRow("lightmap") << u"lightmap --format glb"_s << u"001.glb"_s;
        QTest::newRow("convert") << u"convert --format ply"_s << u"001.ply"_s;
        QTest::newRow("bake") << u"bake --maps position --texture-size 16"_s << u"001"_s;
        QTest::newRow("lightbake") << u"lightbake --texture-size 16 --samples 1 --sky 1,1,1"_s
                                   << u"001.exr"_s;
        QTest::newRow("check") << u"check"_s << QString();
    }
    void everyCommandOfFilesCanBeDone()
    {
        QFETCH(QString, line);
        QFETCH(QString, output);
        const Place place(2);
        const QString mapped = place.out(u"001.obj"_s);
        QCOMPARE(place.run().code, 0);
        const test::CliRun run = test::runProgram(
            program(), words(u"batch "_s + line) + QStringList{mapped, u"-o"_s, place.at(u"made"_s)});
        QVERIFY2(run.code == 0, qPrintable(run.err));
        QVERIFY2(run.out.endsWith(u"done: 1\n"_s), qPrintable(run.out));
        if (!output.isEmpty())
            QVERIFY(QFileInfo::exists(place.at(u"made/"_s + output)));
    }

    void thresholdsOfCheck()
    {
        const Place place(2);
        QCOMPARE(place.run().code, 0);
        const auto check = [](const QString &file, const QString &list) {
            return test::runInProcess({u"check"_s, file, u"--fail-on"_s, list}).code;
        };
        const QString mapped = place.out(u"001.obj"_s);
        QCOMPARE(check(mapped, u"overlaps,flips,missing,tiles,distortion:4.2"_s), 0);
        QCOMPARE(check(mapped, u"gutter:100000"_s), 0); // there is one island
        QCOMPARE(check(mapped, u"distortion:3"_s), 4);
        QCOMPARE(check(place.in(u"001.obj"_s), u"missing"_s), 4);
        QCOMPARE(check(place.in(u"001.obj"_s), u"distortion:9"_s), 4);
        QCOMPARE(check(mapped, u"holes"_s), 2);
        const QString report = place.at(u"figures.json"_s);
        QCOMPARE(test::runInProcess({u"check"_s, mapped, u"--report"_s, report}).code, 0);
        QCOMPARE(QJsonDocument::fromJson(test::readBytes(report))[u"flipped"_s].toInt(-1), 0);
    }

    void nearNamesAreProposed_data()
    {
        QTest::addColumn<QString>("word");
        QTest::addColumn<QString>("name");
        QTest::newRow("missing letter") << u"--qualty"_s << u"--quality"_s;
        QTest::newRow("exchanged letters") << u"unwarp"_s << u"unwrap"_s;
        QTest::newRow("another word") << u"flatten"_s << QString();
    }
    void nearNamesAreProposed()
    {
        QFETCH(QString, word);
        QTEST(nearestName(word, {u"unwrap"_s, u"pack"_s, u"--quality"_s, u"--quiet"_s}), "name");
    }
};

QTEST_GUILESS_MAIN(TestManyFiles)

} // namespace tst_manyfiles

#include "tst_manyfiles.moc"
