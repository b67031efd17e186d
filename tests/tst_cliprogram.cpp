// The program itself: exit codes, streams, and everything that can be wrong with its files.
#include "model/io/files/sessionlock.h"
#include "model/io/meshes/meshfile.h"
#include "model/samples/samples.h"
#include "support/cliruns.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include <cerrno>
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>

namespace tst_cliprogram {

using namespace autocuts;

namespace {

QString program()
{
    return QStringLiteral(AUTOCUTS_CLI);
}

QByteArray withLine(const char *line)
{
    return QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n") + line + '\n';
}

} // namespace

class TestCliProgram : public QObject, private test::OwnFolder
{
    Q_OBJECT

private:
    //! A failure as it should be: code 1, nothing on stdout, one line on stderr with these parts.
    static QString problemWithFailure(const test::CliRun &r, const QStringList &parts)
    {
        if (r.code != 1 || !r.out.isEmpty())
            return QStringLiteral("exit %1, stdout %2, stderr %3").arg(r.code).arg(r.out, r.err);
        if (!r.err.startsWith(QLatin1String("autocuts-cli: ")) || r.err.count(QLatin1Char('\n')) != 1 ||
            !r.err.endsWith(QLatin1Char('\n')))
            return QStringLiteral("not one line: %1").arg(r.err);
        for (const QString &part : parts) {
            if (!r.err.contains(part))
                return QStringLiteral("no \"%1\" in: %2").arg(part, r.err);
        }
        return {};
    }
    //! True when only the given files are in the folder: no temporary file was left.
    static QStringList filesIn(const QString &folder)
    {
        return QDir(folder).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(mFolder.isValid()); }

    void usageErrorsGiveTwo()
    {
        for (const QStringList &arguments :
             {QStringList(), QStringList{QStringLiteral("unfold")},
              QStringList{QStringLiteral("unwrap"), QStringLiteral("a.obj")}}) {
            const test::CliRun r = test::runProgram(program(), arguments);
            QCOMPARE(r.code, 2);
            QCOMPARE(r.out, QString());
            QCOMPARE(r.err.count(QLatin1Char('\n')), 1);
            QVERIFY(r.err.startsWith(QLatin1String("autocuts-cli: ")));
        }
    }

    void helpAndVersionGoToStdout()
    {
        const test::CliRun help = test::runProgram(program(), {QStringLiteral("--help")});
        QCOMPARE(help.code, 0);
        QVERIFY(help.out.startsWith(QLatin1String("Autocuts")));
        QCOMPARE(help.err, QString());
        const test::CliRun version = test::runProgram(program(), {QStringLiteral("--version")});
        QCOMPARE(version.code, 0);
        QVERIFY(version.out.startsWith(QLatin1String("autocuts-cli ")) && version.out.size() > 15);
    }

    //! The same bytes as by files; figures stand in no one's way.
    void standardStreams()
    {
        const QString in = file("stream.obj", test::sheetObj(5)), out = at("stream_uv.ply");
        QCOMPARE(test::runProgram(program(), test::draft(in, out)).code, 0);
        QProcess process;
        process.start(program(), test::draft(QStringLiteral("-"), QStringLiteral("-"))
                                     << QStringLiteral("--output-format=ply"));
        process.write(test::sheetObj(5));
        process.closeWriteChannel();
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 0);
        QCOMPARE(process.readAllStandardOutput(), test::readBytes(out));
        QVERIFY(process.readAllStandardError().contains("seam_norm"));
        // A broken model gives nothing.
        process.start(program(), test::draft(QStringLiteral("-"), QStringLiteral("-")));
        process.write("v 0 0\n");
        process.closeWriteChannel();
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 1);
        QCOMPARE(process.readAllStandardOutput(), QByteArray());
        const test::CliRun bake = test::runProgram(
            program(), {QStringLiteral("bake"), out, QStringLiteral("-o"), QStringLiteral("-")});
        QCOMPARE(bake.code, 2);
        QVERIFY2(bake.err.contains(QLatin1String("need a folder")), qPrintable(bake.err));
    }

    void badInputIsExplained_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QStringList>("parts");
        const auto row = [](const char *name, const QByteArray &bytes, const QStringList &parts) {
            QTest::newRow(name) << bytes << parts;
        };
        const QByteArray points("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
        row("empty.obj", "", {});
        row("garbage.obj", QByteArray::fromHex("7f454c4602010100000000fffe00d8c3").repeated(400), {});
        row("nan.obj", points + "v nan 0 0\nf 1 2 4\n", {QStringLiteral("nan.obj:4:")});
        row("inf.obj", points + "v 0 inf 0\nf 1 2 4\n", {QStringLiteral("inf.obj:4:")});
        row("toolarge.obj", withLine("f 1 2 9"), {QStringLiteral("toolarge.obj:5:")});
        row("zero.obj", withLine("f 0 1 2"), {QStringLiteral("zero.obj:5:")});
        row("negative.obj", withLine("f -1 -2 -9"), {QStringLiteral("negative.obj:5:")});
        row("letters.obj", withLine("f a b c"), {QStringLiteral("letters.obj:5:")});
        row("nofaces.obj", points, {});
        row("flat.obj", points + "v 2 0 0\nf 1 2 4\nf 1 1 1\n", {QStringLiteral("without area")});
        row("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2", {});
        row("empty.glb", "", {});
        row("garbage.glb", QByteArray("glTF\2\0\0\0\377\377\0\0garbage", 19), {});
        row("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n", {});
        row("garbage.fbx", "Kaydara FBX Binary  \0\x1a", {});
        row("garbage.blend", "BLENDER-v300garbage", {});
        row("format.xyz", "1 2 3\n", {QStringLiteral("xyz")});
    }
    void badInputIsExplained()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QStringList, parts);
        const char *name = QTest::currentDataTag();
        const QString in = file(name, bytes);
        const QString out = file("kept.obj", "kept\n");
        parts << QString::fromLatin1(name);
        const test::CliRun r = test::runProgram(program(), test::draft(in, out));
        QCOMPARE(problemWithFailure(r, parts), QString());
        QCOMPARE(test::readBytes(out), QByteArray("kept\n"));
    }

    void missingAndUnreadableInputIsExplained()
    {
        QCOMPARE(problemWithFailure(test::runProgram(program(), test::draft(at("missing.obj"), at("x.obj"))),
                                    {QStringLiteral("missing.obj"), QStringLiteral("no such file")}),
                 QString());
        QVERIFY(QDir(mFolder.path()).mkpath(QStringLiteral("folder.obj")));
        QCOMPARE(problemWithFailure(test::runProgram(program(), test::draft(at("folder.obj"), at("x.obj"))),
                                    {QStringLiteral("folder")}),
                 QString());
        QVERIFY(QFile::link(QStringLiteral("/proc/self/mem"), at("device.obj"))); // readable by nobody
        QCOMPARE(problemWithFailure(test::runProgram(program(), test::draft(at("device.obj"), at("x.obj"))),
                                    {QStringLiteral("device.obj")}),
                 QString());
        QVERIFY(!QFileInfo::exists(at("x.obj")));
    }

    void oneTriangleIsEnough()
    {
        const QString in = file("one.obj", withLine("# the end"));
        const test::CliRun r = test::runProgram(program(), test::draft(in, at("one_uv.obj")));
        QVERIFY2(r.code == 0, qPrintable(r.err));
        QVERIFY(readMesh(at("one_uv.obj")).value().hasUv());
    }

    void badTargetsAreFoundBeforeTheWork()
    {
        const QString in = file("in.obj", test::quadCubeObj());
        const auto fails = [&](const QStringList &more, const QStringList &parts) {
            QStringList arguments{QStringLiteral("unwrap"), in};
            return problemWithFailure(test::runProgram(program(), arguments + more), parts);
        };
        const QString o = QStringLiteral("-o");
        QCOMPARE(
            fails({o, at("nowhere/out.obj")}, {QStringLiteral("nowhere"), QStringLiteral("does not exist")}),
            QString());
        QCOMPARE(fails({o, in + QStringLiteral("/out.obj")}, {QStringLiteral("in.obj")}), QString());
        QCOMPARE(fails({o, mFolder.path()}, {QStringLiteral("folder")}), QString());
        QCOMPARE(fails({o, at("out.stl")}, {QStringLiteral("STL files cannot hold UVs")}), QString());
        QCOMPARE(fails({o, at("out.xyz")}, {QStringLiteral("xyz")}), QString());
        QCOMPARE(fails({o, at("out.obj"), QStringLiteral("--layout"), at("nowhere/l.png")},
                       {QStringLiteral("nowhere")}),
                 QString());
        QCOMPARE(fails({o, at("out.obj"), QStringLiteral("--report"), at("nowhere/r.json")},
                       {QStringLiteral("nowhere")}),
                 QString());
        for (const QString &path : {at("out.obj"), mFolder.path() + QStringLiteral("/./in.obj")})
            QCOMPARE(fails({o, at("out.obj"), QStringLiteral("--report"), path},
                           {QStringLiteral("would overwrite another file")}),
                     QString());
        QCOMPARE(mkfifo(qPrintable(at("pipe.json")), 0600), 0);
        QCOMPARE(fails({o, at("out.obj"), QStringLiteral("--report"), at("pipe.json")},
                       {QStringLiteral("not a regular file")}),
                 QString());
        QVERIFY(!QFileInfo::exists(at("out.obj")));
        QCOMPARE(
            problemWithFailure(test::runProgram(program(), test::draft(in, QStringLiteral("/proc/out.obj"))),
                               {QStringLiteral("/proc")}),
            QString());
    }

    void aFullDiskLeavesTheOldFile()
    {
        // A limit on the size of files gives the same failed writes as a full disk.
        QVERIFY(QDir(mFolder.path()).mkpath(QStringLiteral("full")));
        const QString in = file("in.obj", test::sheetObj(20));
        const QString out = file("full/out.obj", "kept\n");
        for (const char *command : {"unwrap", "convert"}) {
            QProcess process;
            process.setChildProcessModifier([] {
                const rlimit limit{4096, 4096};
                setrlimit(RLIMIT_FSIZE, &limit);
            });
            QStringList arguments{QString::fromLatin1(command), in, QStringLiteral("-o"), out};
            if (arguments.first() == QLatin1String("unwrap"))
                arguments << QStringLiteral("--quality=draft") << QStringLiteral("--time-limit=0.001");
            process.start(program(), arguments);
            QVERIFY(process.waitForFinished(60'000));
            QCOMPARE(process.exitStatus(), QProcess::NormalExit);
            const test::CliRun r{process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
                                 QString::fromUtf8(process.readAllStandardError())};
            QCOMPARE(problemWithFailure(r, {QStringLiteral("out.obj"), QStringLiteral("cannot be written")}),
                     QString());
            QCOMPARE(test::readBytes(out), QByteArray("kept\n"));
            QCOMPARE(filesIn(at("full")), QStringList{QStringLiteral("out.obj")});
        }
    }

    //! A report that cannot be written any more when the map is.
    void whatIsWrittenAlreadyIsSaid()
    {
#ifdef AUTOCUTS_SANITIZED
        QSKIP("sanitizers have to be the first library");
#endif
        QVERIFY(QDir(mFolder.path()).mkpath(QStringLiteral("later")));
        const QString in = file("in.obj", test::quadCubeObj()), out = at("said.obj");
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("LD_PRELOAD"), QStringLiteral(FAILING_CALLS));
        environment.insert(QStringLiteral("FAILING_FOLDER"), at("later"));
        environment.insert(QStringLiteral("FAILING_LOG"), at("calls.log"));
        environment.insert(QStringLiteral("FAILING_CALL"), QStringLiteral("1"));
        environment.insert(QStringLiteral("FAILING_WITH"), QString::number(EIO));
        process.setProcessEnvironment(environment);
        process.start(program(), test::draft(in, out)
                                     << QStringLiteral("--quiet") << QStringLiteral("--report")
                                     << at("later/report.json"));
        QVERIFY(process.waitForFinished(60'000));
        const test::CliRun r{process.exitCode(), {}, QString::fromUtf8(process.readAllStandardError())};
        QCOMPARE(problemWithFailure(
                     r, {QStringLiteral("report.json"), QStringLiteral("; written already: ") + out}),
                 QString());
        QVERIFY(QFileInfo::exists(out) && !QFileInfo::exists(at("later/report.json")));
    }

    void figuresThatGetLostAreAFailure_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const QString in = file("in.obj", test::quadCubeObj());
        QTest::newRow("check") << QStringList{QStringLiteral("check"), in, QStringLiteral("--json")};
        QTest::newRow("version") << QStringList{QStringLiteral("--version")};
        QTest::newRow("help") << QStringList{QStringLiteral("--help")};
        QTest::newRow("unwrap") << test::draft(in, at("lost.obj"));
        const auto words = [this](QString text) {
            return text.replace(QLatin1Char('@'), mFolder.path() + QLatin1Char('/')).split(QLatin1Char(' '));
        };
        QCOMPARE(test::runInProcess(test::draft(in, at("mapped.obj"))).code, 0);
        QCOMPARE(test::runInProcess(words(QStringLiteral("convert @mapped.obj -o @lost.acproj"))).code, 0);
        for (const char *text :
             {"pack @mapped.obj -o @lost.obj --pack-time 0.1", "finish @mapped.obj -o @lost.obj",
              "separate @mapped.obj -o @lost.obj", "lightmap @mapped.obj -o @lost.obj --pack-time 0.1",
              "transfer @mapped.obj --from @mapped.obj -o @lost.obj", "replay @lost.acproj",
              "bake @mapped.obj -o @ --maps position --size 16",
              "lightbake @mapped.obj -o @lost.png --size 16 --samples 1", "--man-page", "--markdown"})
            QTest::newRow(text) << words(QString::fromLatin1(text));
    }
    void figuresThatGetLostAreAFailure()
    {
        QFETCH(QStringList, arguments);
        QProcess process;
        process.setStandardOutputFile(QStringLiteral("/dev/full"));
        process.start(program(), arguments);
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 1);
        QVERIFY(process.readAllStandardError().contains("standard output"));
    }

    //! Qt cannot name such a file: it would be written under another name.
    void namesThatAreNotUtf8AreRefused()
    {
        const QString in = file("plain.obj", test::quadCubeObj());
        const QStringList before = filesIn(mFolder.path());
        for (const char *arguments : {"convert \"$1\" -o \"$2/\377.obj\"", "check \"$2/\377.obj\""}) {
            QString script = QStringLiteral("\"$0\" ") + QString::fromLatin1(arguments);
            script.replace(QLatin1String("\377"), QStringLiteral("$(printf '\\377')"));
            const test::CliRun r = test::runProgram(
                QStringLiteral("/bin/sh"), {QStringLiteral("-c"), script, program(), in, mFolder.path()});
            QCOMPARE(r.code, 2);
            QVERIFY2(r.err.contains(QLatin1String("not valid UTF-8")), qPrintable(r.err));
        }
        QCOMPARE(filesIn(mFolder.path()), before);
    }

    void aSessionThatIsOpenElsewhereIsSaid()
    {
        const QString session = at("open.acproj");
        QCOMPARE(
            test::runProgram(program(), test::draft(file("open.obj", test::quadCubeObj()), session)).code, 0);
        const QStringList pack{QStringLiteral("pack"), session, QStringLiteral("-o"), session};
        {
            const SessionLock lock(session);
            const test::CliRun r = test::runProgram(program(), pack);
            QCOMPARE(r.code, 0);
            QVERIFY2(r.err.contains(QLatin1String("the session is open in")), qPrintable(r.err));
        }
        const test::CliRun r = test::runProgram(program(), pack);
        QCOMPARE(r.code, 0);
        QVERIFY2(!r.err.contains(QLatin1String("is open in")), qPrintable(r.err));
    }

    //! With too little memory for the threads of OpenBLAS the program did not end, or was ended by OpenBLAS
    //! as if it had been interrupted.
    void endsHoweverLittleMemoryThereIs()
    {
#ifdef AUTOCUTS_SANITIZED
        QSKIP("a sanitized program needs more address space than a limit leaves");
#else
        const QString in = file("little.obj", test::sheetObj(5));
        bool loaded = false; // with less memory, all libraries were loaded
        for (int megabytes = 150; megabytes <= 350; megabytes += 2) {
            QStringList arguments{QStringLiteral("--version")};
            if (megabytes % 10 == 0)
                arguments = test::draft(in, at("little_uv.obj"));
            QProcess process;
            const QString script = QStringLiteral("ulimit -v %1; exec \"$0\" \"$@\"").arg(megabytes * 1024);
            process.start(QStringLiteral("/bin/sh"),
                          QStringList{QStringLiteral("-c"), script, program()} + arguments);
            const bool ended = process.waitForFinished(20'000);
            process.kill();
            process.waitForFinished();
            QVERIFY2(ended, qPrintable(QString::number(megabytes)));
            const QByteArray said = process.readAllStandardError();
            constexpr int notLoaded = 127;
            const int code = process.exitCode();
            // GLib, a library of Qt, and Embree end a process whose memory ends while they are loaded.
            const bool crashed = process.exitStatus() == QProcess::CrashExit;
            if (crashed && (!loaded || said.contains("GSlice: failed to allocate")))
                continue;
            loaded = loaded || code != notLoaded;
            QVERIFY2(process.exitStatus() == QProcess::NormalExit &&
                         (code == 0 || ((code == 1 || code == notLoaded) && !said.isEmpty())),
                     said.constData());
        }
#endif
    }

    void anyPathWorksInAnyLocale()
    {
        const QByteArray name = QByteArrayLiteral("модель куба è 立方体 .obj");
        QVERIFY(QDir(mFolder.path()).mkpath(QStringLiteral("папка с пробелом")));
        const QString in = file(("папка с пробелом/" + name).constData(), test::quadCubeObj());
        const QString out = at("папка с пробелом/выход.obj"), layout = at("папка с пробелом/вид.png");
        for (const char *locale : {"C.UTF-8", "C", "POSIX"}) {
            QFile::remove(out);
            QProcess process;
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert(QStringLiteral("LC_ALL"), QString::fromLatin1(locale));
            process.setProcessEnvironment(environment);
            process.start(program(), test::draft(in, out) << QStringLiteral("--layout") << layout);
            QVERIFY(process.waitForFinished(60'000));
            QCOMPARE(process.exitCode(), 0);
            QCOMPARE(process.readAllStandardError(), QByteArray());
            QVERIFY(QFileInfo::exists(out) && QFileInfo::exists(layout));
        }
        const test::CliRun r = test::runProgram(program(), {QStringLiteral("check"), at("нет такого.obj")});
        QCOMPARE(problemWithFailure(r, {QStringLiteral("нет такого.obj")}), QString());
    }
};

QTEST_GUILESS_MAIN(TestCliProgram)

} // namespace tst_cliprogram

#include "tst_cliprogram.moc"
