// What the studio writes while calls on files fail, or the program is killed: the old or the new files.
//
// The program runs itself again with tests/fuzz/failingcalls.cpp preloaded, for each call of each job: once
// with an error and once being killed. With ALL_FAULTS in the environment, as scripts/soak sets it, it tries
// more errors.
#include "model/io/files/savefile.h"
#include "model/io/files/setjournal.h"
#include "model/io/projects/projectfile.h"
#include "model/layouts/layoutoptions.h"
#include "model/pictures/picturefiles.h"
#include "support/cliruns.h"
#include "support/gltffiles.h"
#include "support/mappedmodels.h"
#include "support/patience.h"
#include "views/control/files/filecontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/mapjobs/picturejobs.h"
#include "views/control/session/jobrunner.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/ui/preferences.h"

#include <QDir>
#include <QGuiApplication>
#include <QProcess>
#include <QSignalSpy>
#include <QTest>

#include <cerrno>
#include <csignal>

namespace tst_studiofaults {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! The files that a job writes. They belong together.
const std::map<QString, QStringList> filesOfJobs{
    {u"session"_s, {u"model.acproj"_s}},
    {u"mesh"_s, {u"out.obj"_s}},
    {u"gltf"_s, {u"out.glb"_s}},
    {u"gltf with bin"_s, {u"out.gltf"_s}},
    {u"picture"_s, {u"view.png"_s}},
    {u"layout"_s, {u"layout.1001.png"_s, u"layout.1002.png"_s}},
    {u"report"_s, {u"report.json"_s}},
    {u"bake"_s, {u"model_position.png"_s, u"model_height.png"_s, u"model_material-id.png"_s}},
    {u"light"_s, {u"light.png"_s}},
    {u"textures"_s, {u"skin_new.png"_s, u"rough_new.png"_s}},
};

//! Does a job in the current folder. \returns what went wrong; empty when it succeeded
QString doJob(const QString &job, const QString &other)
{
    Workspace workspace;
    ShownMap shown{workspace};
    SolverController solver{workspace, shown};
    Preferences preferences{other + u"/autocuts.ini"_s};
    FileController files{workspace, solver, preferences, other + u"/recovery"_s};
    QString problem;
    QObject::connect(&files, &FileController::failed,
                     [&problem](const Error &error) { problem = error.toString(); });
    const auto rests = [&files] {
        return QTest::qWaitFor([&files] { return !files.jobs().isBusy() && !files.isSaving(); },
                               test::patience);
    };
    files.open(job == "gltf with bin"_L1 ? other + u"/pair.gltf"_s
                                         : QDir::current().filePath(u"model.acproj"_s));
    if (!rests() || !workspace.document())
        return problem.isEmpty() ? u"nothing was opened"_s : problem;
    const Document &document = *workspace.document();
    const auto path = [](const QString &name) { return QDir::current().filePath(name); };
    const QString first = path(filesOfJobs.at(job).front());
    LayoutOptions picture;
    picture.size = 64;
    MapInput input;
    input.packing.textureSize = 64;
    JobControl control;
    if (job == "session"_L1) {
        files.save(first, true);
    } else if (job == "mesh"_L1 || job.startsWith("gltf"_L1)) {
        files.exportMesh(first);
    } else if (job == "picture"_L1) {
        files.exportBytes(first, "a picture");
    } else if (job == "layout"_L1) {
        files.exportLayout({{1001, first}, {1002, path(filesOfJobs.at(job).back())}}, picture, {});
    } else if (job == "report"_L1) {
        files.exportReport(first);
    } else if (job == "bake"_L1) {
        jobs::BakeChoice choice;
        choice.maps = {u"position"_s, u"height"_s, u"material-id"_s};
        choice.folder = QDir::currentPath();
        return bakeJob(document.state(), input, choice, control).problem;
    } else if (job == "light"_L1) {
        jobs::LightChoice choice;
        choice.textureSize = 16;
        choice.samples = 1;
        choice.path = first;
        return lightBakeJob(document.state(), 0, input, choice, {}, control).problem;
    } else if (job == "textures"_L1) {
        jobs::CarryChoice choice;
        choice.from = jobs::CarryChoice::From::UvSet;
        choice.uvSet = 1;
        choice.folder = QDir::currentPath();
        choice.suffix = u"_new"_s;
        return carryJob({document.state(), workspace.recorder().pending()}, workspace.sessionPath(), choice,
                        control)
            .problem;
    }
    return rests() ? problem : u"it does not end"_s;
}

} // namespace

class TestStudioFaults : public QObject, private test::OwnFolder
{
    Q_OBJECT

private:
    static constexpr int didNotEnd = -1;

    struct Run
    {
        QProcess::ExitStatus status = QProcess::NormalExit;
        int code = 0;
        QString text;
    };

    QString work() const { return at("work"); }
    void reset(const QString &job) const
    {
        QDir(work()).removeRecursively();
        QDir().mkpath(work());
        QFile::copy(at("model.acproj"), work() + u"/model.acproj"_s);
        for (const QString &name : filesOfJobs.at(job)) {
            if (!QFileInfo::exists(work() + u'/' + name))
                test::writeBytes(work() + u'/' + name, "old");
        }
    }
    std::vector<QByteArray> contents(const QString &job) const
    {
        std::vector<QByteArray> bytes;
        for (const QString &name : filesOfJobs.at(job))
            bytes.push_back(test::readBytes(work() + u'/' + name));
        return bytes;
    }
    Run run(const QString &job, int call, const QString &with) const
    {
        QFile::remove(at("calls.log"));
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const auto &[name, value] :
             {std::pair(u"FAULT_JOB"_s, job), std::pair(u"FAULT_OTHER"_s, at("other")),
              std::pair(u"LD_PRELOAD"_s, QStringLiteral(FAILING_CALLS)),
              std::pair(u"FAILING_FOLDER"_s, work()), std::pair(u"FAILING_LOG"_s, at("calls.log")),
              std::pair(u"FAILING_CALL"_s, QString::number(call)), std::pair(u"FAILING_WITH"_s, with)})
            environment.insert(name, value);
        if (!environment.contains(u"DISPLAY"_s))
            environment.insert(u"QT_QPA_PLATFORM"_s, u"offscreen"_s);
        process.setProcessEnvironment(environment);
        process.setWorkingDirectory(work());
        process.start(QCoreApplication::applicationFilePath(), {QCoreApplication::applicationName()});
        if (!process.waitForFinished(60'000)) {
            process.kill();
            process.waitForFinished();
            return {QProcess::NormalExit, didNotEnd, u"it does not end"_s};
        }
        return {process.exitStatus(), process.exitCode(), QString::fromUtf8(process.readAllStandardOutput())};
    }

private Q_SLOTS:
    void initTestCase()
    {
#ifdef AUTOCUTS_SANITIZED
        QSKIP("sanitizers have to be the first library");
#endif
        Scene scene;
        scene.mesh = test::box(2);
        scene.path = at("model.obj");
        scene.objectNames = {u"box"_s};
        scene.faceMaterial.assign(static_cast<std::size_t>(scene.mesh->faceCount()), -1);
        const UvMatrix uv = test::mapped(scene.mesh, test::boxMap()).uv;
        scene.uvSets = {{u"UVMap"_s, uv}, {u"before"_s, 0.5 * uv}};
        QVERIFY(QDir().mkpath(at("other")));
        DocumentState state = DocumentState::initial(scene);
        Picture picture(4, 4, 3);
        for (const auto &[channel, name] : {std::pair(TextureChannel::BaseColor, u"other/skin.png"_s),
                                            std::pair(TextureChannel::Roughness, u"other/rough.png"_s)}) {
            const QString path = mFolder.filePath(name);
            QVERIFY(writePicture(picture, path, PictureDepth::Eight).ok());
            state.textureSets.resize(1);
            state.textureSets[0][channel] = {{path, {}}};
        }
        QVERIFY(saveProject(state, {}, at("model.acproj")).ok());
        const gltffiles::FileBuilder pair = gltffiles::grid();
        QVERIFY(saveAtomically(at("other/pair.gltf"), pair.text("pair.bin")).ok());
        QVERIFY(saveAtomically(at("other/pair.bin"), pair.buffer).ok());
    }

    void theOldOrTheNewFiles_data()
    {
        QTest::addColumn<QString>("job");
        for (const auto &[job, files] : filesOfJobs)
            QTest::newRow(qPrintable(job)) << job;
    }
    void theOldOrTheNewFiles()
    {
        QFETCH(const QString, job);
        reset(job);
        const std::vector<QByteArray> before = contents(job);
        const Run whole = run(job, 0, {});
        QVERIFY2(whole.code == 0 && whole.text.isEmpty(), qPrintable(whole.text));
        const std::vector<QByteArray> after = contents(job);
        const auto calls = int(test::readBytes(at("calls.log")).count('\n'));
        QVERIFY(calls > 3);
        const QStringList names = QDir(work()).entryList(QDir::Files | QDir::Hidden);
        QStringList faults{QString::number(EIO), u"kill"_s};
        if (qEnvironmentVariableIsSet("ALL_FAULTS"))
            faults << QString::number(ENOSPC) << QString::number(EACCES);
        qInfo("%s: %d calls, %d runs", qPrintable(job), calls, int(calls * faults.size()));
        for (int call = 1; call <= calls; ++call) {
            for (const QString &with : faults) {
                reset(job);
                const Run failed = run(job, call, with);
                const QByteArray where =
                    u"call %1 of %2 with %3: %4"_s.arg(call).arg(calls).arg(with, failed.text).toLocal8Bit();
                QVERIFY2(failed.code != didNotEnd, where.constData());
                const bool killed = failed.status == QProcess::CrashExit;
                QVERIFY2(!killed || failed.code == SIGKILL, where.constData());
                // Whoever looks into the folder next puts right what is mixed.
                const QStringList ended = killed ? endBrokenSets({work()}) : QStringList();
                QVERIFY2(ended.size() <= 1, where.constData());
                const std::vector<QByteArray> now = contents(job);
                // Sessions hold the time of an entry of the history, so that only their size is compared.
                const auto isNew = [&](std::size_t i) {
                    return job == "session"_L1 ? bool(loadProject(work() + u"/model.acproj"_s))
                                               : now[i] == after[i];
                };
                bool allOld = true, allNew = true;
                for (std::size_t i = 0; i < now.size(); ++i) {
                    allOld = allOld && now[i] == before[i];
                    allNew = allNew && isNew(i);
                    QVERIFY2(now[i] == before[i] || isNew(i), where.constData());
                }
                QVERIFY2(allOld || allNew, where.constData());
                if (killed && now.size() == 1) // a file that had no name before may be left
                    continue;
                QVERIFY2(killed || !failed.text.isEmpty() || allNew, where.constData());
                QStringList left = QDir(work()).entryList(QDir::Files | QDir::Hidden);
                for (const QString &name : names)
                    left.removeAll(name);
                if (killed) // it counts for nothing then
                    left.removeAll(u".model.acproj.lock"_s);
                left.removeAll(u"model.acproj.new"_s); // where the backup could not get its name
                QVERIFY2(left.isEmpty(), qPrintable(left.join(u',') + QString::fromLocal8Bit(where)));
            }
        }
    }
};

int main(int argc, char *argv[])
{
    if (qEnvironmentVariableIsSet("FAULT_JOB")) {
        QGuiApplication application(argc, argv);
        const QString problem = doJob(qEnvironmentVariable("FAULT_JOB"), qEnvironmentVariable("FAULT_OTHER"));
        QTextStream(stdout) << problem;
        return problem.isEmpty() ? 0 : 1;
    }
    QCoreApplication application(argc, argv);
    TestStudioFaults test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace tst_studiofaults

#include "tst_studiofaults.moc"
