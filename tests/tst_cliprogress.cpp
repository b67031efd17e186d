// What the program says while it works, and how it ends when it is stopped: progress, signals, time limits.
#include "cli/progressline.h"
#include "cli/stopsource.h"
#include "model/io/meshes/meshfile.h"
#include "model/samples/samples.h"
#include "solver/metrics/uvmetrics.h"
#include "support/cliruns.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include <csignal>

namespace tst_cliprogress {

using namespace autocuts;
using namespace autocuts::metrics;

namespace {

QString program()
{
    return QStringLiteral(AUTOCUTS_CLI);
}

//! True when the process has a handler for the signal.
bool catchesSignal(qint64 process, int signal)
{
    const QByteArray status = test::readBytes(QStringLiteral("/proc/%1/status").arg(process));
    const qsizetype at = status.indexOf("SigCgt:");
    const quint64 mask = at < 0 ? 0 : status.mid(at + 7, 18).trimmed().toULongLong(nullptr, 16);
    return mask >> (signal - 1) & 1;
}

} // namespace

class TestCliProgress : public QObject, private test::OwnFolder
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(mFolder.isValid()); }

    void noProgressInAPipe()
    {
        const QString in = file("q.obj", test::sheetObj(5));
        const test::CliRun r = test::runProgram(program(), test::draft(in, at("q_uv.obj")));
        QCOMPARE(r.code, 0);
        QCOMPARE(r.err, QString());
        QVERIFY(r.out.contains(QLatin1String("seam_norm")));
        const test::CliRun quiet =
            test::runProgram(program(), test::draft(in, at("q_uv.obj")) << QStringLiteral("--quiet"));
        QCOMPARE(quiet.code, 0);
        QCOMPARE(quiet.out + quiet.err, QString());
    }

    void progressForPrograms()
    {
        const QString in = file("j.obj", test::sheetObj(5));
        const test::CliRun r =
            test::runProgram(program(), test::draft(in, at("j_uv.obj")) << QStringLiteral("--progress=json"));
        QCOMPARE(r.code, 0);
        const QStringList lines = r.err.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
        QVERIFY(!lines.isEmpty());
        for (const QString &line : lines) {
            const QJsonObject event = QJsonDocument::fromJson(line.toUtf8()).object();
            const double fraction = event.value(QLatin1String("fraction")).toDouble(-1);
            QVERIFY2(fraction >= 0 && fraction <= 1, qPrintable(line));
            QVERIFY(event.value(QLatin1String("stage")).isString());
        }
    }

    //! While that is said, a stop ends the program.
    void progressSaysThatAJobPrepares()
    {
        const QString in =
            file("p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
        const QString jobs[] = {QStringLiteral("bake %1 -o @maps --maps position --size 16"),
                                QStringLiteral("lightbake %1 -o @light.png --size 16 --samples 1"),
                                QStringLiteral("transfer %1 --from %1 -o @p.glb")};
        for (QString job : jobs) {
            job = job.arg(in).replace(QLatin1Char('@'), at("prepared_")) + QStringLiteral(" --progress=json");
            const test::CliRun r = test::runProgram(program(), job.split(QLatin1Char(' ')));
            QVERIFY2(r.err.startsWith(QLatin1String("{\"fraction\":0,\"stage\":\"preparing\"}\n")),
                     qPrintable(r.err));
            QVERIFY2(!r.err.contains(QLatin1String("optimising")), qPrintable(r.err));
        }
    }

    void aStopEndsTheProgramWhileAJobPrepares()
    {
        static StopReason endedBy = StopReason::None;
        StopSource source;
        source.endProgram = [](StopReason why) { endedBy = why; };
        source.request(StopReason::TimeLimit);
        QVERIFY(source.stop);
        QCOMPARE(endedBy, StopReason::None);
        source.isPreparing = true;
        source.request(StopReason::Interrupted);
        QCOMPARE(endedBy, StopReason::Interrupted);
    }

    void progressNamesTheWork()
    {
        QString said;
        QTextStream err(&said);
        ProgressLine line(ProgressStyle::Lines, err, 0);
        line.show({0.5, JobStage::Working});
        line.setWorkingWord(QStringLiteral("baking"));
        line.show({0.5, JobStage::Working});
        line.show({0.5, JobStage::Packing});
        QCOMPARE(said, QStringLiteral("optimising  50 %\nbaking  50 %\npacking  50 %\n"));
    }

    //! In a file, progress is whole lines, and none of a job that ends soon.
    void progressInAFile_data()
    {
        QTest::addColumn<int>("seldom");
        QTest::addColumn<QString>("said");
        QTest::newRow("at once") << 0 << QStringLiteral("half\nall\n");
        QTest::newRow("soon over") << 1'000'000 << QString();
    }
    void progressInAFile()
    {
        QFETCH(int, seldom);
        QString said;
        QTextStream err(&said);
        ProgressLine line(ProgressStyle::Lines, err, seldom);
        line.show(QStringLiteral("half"));
        line.show(QStringLiteral("all"));
        line.clear();
        QTEST(said, "said");
    }

    void progressOnATerminal()
    {
        // script(1) of util-linux runs a command on a terminal of its own.
        if (!QFileInfo::exists(QStringLiteral("/usr/bin/script")))
            QSKIP("script(1) is not installed");
        const QString in = file("p.obj", test::sheetObj(5));
        const QString command = QLatin1Char('"') + program() +
                                QStringLiteral("\" unwrap --quality draft --lambda 0.2 \"") + in +
                                QStringLiteral("\" -o \"") + at("p_uv.obj") + QLatin1Char('"');
        const test::CliRun r =
            test::runProgram(QStringLiteral("/usr/bin/script"),
                             {QStringLiteral("-qec"), command, QStringLiteral("/dev/null")});
        QCOMPARE(r.code, 0);
        QVERIFY2(r.out.contains(QLatin1String("optimising")), qPrintable(r.out));
        QVERIFY(r.out.contains(QLatin1Char('\r')));
    }

    void signalsGiveTheBestMapSoFar_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGINT") << SIGINT;
        QTest::newRow("SIGTERM") << SIGTERM;
    }
    void signalsGiveTheBestMapSoFar()
    {
        QFETCH(int, signal);
        const QString in = at("s.obj"), out = at("s_uv.obj"), report = at("s.json");
        QVERIFY(writeMesh(makeSample(QStringLiteral("character")).value(), in));
        QProcess process;
        process.start(program(), {QStringLiteral("unwrap"), in, QStringLiteral("-o"), out,
                                  QStringLiteral("--report"), report, QStringLiteral("--quality=best")});
        QVERIFY(process.waitForStarted());
        QVERIFY(QTest::qWaitFor([&] { return catchesSignal(process.processId(), signal); }, 60'000));
        ::kill(static_cast<pid_t>(process.processId()), signal);
        QVERIFY(process.waitForFinished(120'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 130);
        const QJsonObject figures = QJsonDocument::fromJson(test::readBytes(report)).object();
        QCOMPARE(figures.value(QLatin1String("status")).toString(), QStringLiteral("interrupted"));
        const Result<Scene> scene = readMesh(out);
        QVERIFY(scene.ok() && scene.value().hasUv());
        const UvMetrics m = measureUv(*scene.value().mesh, scene.value().uvSets.front().uv);
        QCOMPARE(m.flipped + m.symDirichletInfinite + m.facesWithoutUv, 0);
        QCOMPARE(m.overlapPairs, std::int64_t(0));
        QVERIFY(m.inUnitSquare);
        QVERIFY(m.charts == 1 || m.minGutterTexels >= 8 * (1 - 1e-6));
    }

    void aTimeLimitGivesTheBestMapSoFar()
    {
        const QString in = at("t.obj"), out = at("t_uv.obj"), report = at("t.json");
        QVERIFY(writeMesh(makeSample(QStringLiteral("character")).value(), in));
        const test::CliRun r = test::runProgram(
            program(), {QStringLiteral("unwrap"), in, QStringLiteral("-o"), out, QStringLiteral("--report"),
                        report, QStringLiteral("--quality=best"), QStringLiteral("--time-limit=0.05")});
        QCOMPARE(r.code, 0);
        const QJsonObject figures = QJsonDocument::fromJson(test::readBytes(report)).object();
        QCOMPARE(figures.value(QLatin1String("status")).toString(), QStringLiteral("time_limit"));
        QCOMPARE(figures.value(QLatin1String("flipped")).toInt(-1), 0);
        QCOMPARE(figures.value(QLatin1String("overlap_pairs")).toInt(-1), 0);
        QVERIFY(readMesh(out).ok());
    }

    void readingCanBeInterrupted()
    {
        const QString in = file("read.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
        const QString reader = file("reader", "#!/bin/sh\n: > \"$0.runs\"\nexec sleep 1000\n");
        QVERIFY(QFile::setPermissions(reader, QFile::ReadOwner | QFile::ExeOwner));
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("AUTOCUTS_READER"), reader);
        const QDir temporary(at("temporary"));
        QVERIFY(temporary.mkpath(QStringLiteral(".")));
        environment.insert(QStringLiteral("TMPDIR"), temporary.path());
        QProcess process;
        process.setProcessEnvironment(environment);
        process.start(program(), test::draft(in, at("read_uv.obj")));
        QVERIFY(process.waitForStarted());
        QVERIFY(QTest::qWaitFor([&] { return catchesSignal(process.processId(), SIGINT); }, 60'000));
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(120'000));
        QCOMPARE(process.exitCode(), 130);
        QVERIFY(process.readAllStandardError().contains("before the model was read"));

        process.start(program(), test::draft(in, at("read_uv.obj")) << QStringLiteral("--time-limit=0.1"));
        QVERIFY(process.waitForFinished(120'000));
        QCOMPARE(process.exitCode(), 1);
        QVERIFY(process.readAllStandardError().contains("--time-limit"));
        QVERIFY(!QFileInfo::exists(at("read_uv.obj")));

        // The detailed model of a bake.
        QVERIFY(QFile::remove(at("reader.runs")));
        const QString low =
            file("low.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
        process.start(program(), {QStringLiteral("bake"), low, QStringLiteral("--high"), in,
                                  QStringLiteral("-o"), at("read_maps")});
        QVERIFY(process.waitForStarted());
        QVERIFY(QTest::qWaitFor([&] { return QFileInfo::exists(at("reader.runs")); }, 60'000));
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(120'000));
        QCOMPARE(process.exitCode(), 130);
        QVERIFY(process.readAllStandardError().contains("before the model was read"));
        QVERIFY(temporary.isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestCliProgress)

} // namespace tst_cliprogress

#include "tst_cliprogress.moc"
