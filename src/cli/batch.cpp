#include "cli/batch.h"

#include "cli/batchpacking.h"
#include "cli/clihelp.h"
#include "cli/mapreporting.h"
#include "cli/progressline.h"
#include "commands/replay.h"
#include "model/io/meshfile.h"
#include "model/io/projectfile.h"
#include "model/io/savefile.h"
#include "model/samples/samples.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/separatejob.h"
#include "solver/unwrap/unwrap.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>

#include <algorithm>
#include <exception>
#include <new>

namespace autocuts {

namespace {

using Command = CliOptions::Command;

QString statusWord(const StopSource &stop)
{
    switch (stop.reason.load()) {
    case StopReason::Interrupted:
        return QStringLiteral("interrupted");
    case StopReason::TimeLimit:
        return QStringLiteral("time_limit");
    case StopReason::None:
        break;
    }
    return QStringLiteral("done");
}

//! Runs one command.
class Job final
{
public:
    Job(const CliOptions &options, StopSource &stop, bool showProgress, QTextStream &out, QTextStream &err)
        : mOptions(options), mStop(stop), mOut(out), mErr(err), mProgress(showProgress && !options.quiet, err)
    {
        mClock.start();
    }

    int run()
    {
        switch (mOptions.command) {
        case Command::Help:
            mOut << usageText() << Qt::flush;
            return 0;
        case Command::ManPage:
            mOut << manualPage() << Qt::flush;
            return 0;
        case Command::Markdown:
            mOut << markdownTables() << Qt::flush;
            return 0;
        case Command::Version:
            mOut << "autocuts-cli " << QCoreApplication::applicationVersion() << Qt::endl;
            return 0;
        case Command::Sample:
            return runSample();
        case Command::Check:
            return runCheck();
        case Command::Convert:
            return runConvert();
        case Command::Replay:
            return runReplay();
        case Command::Unwrap:
            return runMapping([this](Scene &scene) { return unwrapScene(scene); });
        case Command::Pack:
            return runMapping([this](Scene &scene) { return packScene(scene); });
        case Command::Finish:
            return runMapping([this](Scene &scene) { return finishScene(scene); });
        case Command::Separate:
            return runMapping([this](Scene &scene) { return separateScene(scene); });
        }
        return 1;
    }

    int fail(const Error &error)
    {
        mProgress.clear();
        mErr << "autocuts-cli: " << error.toString() << Qt::endl;
        return 1;
    }

private:
    //! Results of a mapping command besides the UVs.
    struct Outcome
    {
        std::optional<int> iterations;
        double lambda = MapReport::unknown, delta = MapReport::unknown;
        QStringList notes;    //!< what was done
        QStringList warnings; //!< what was requested and could not be done
    };

    int runSample()
    {
        const Result<Scene> scene = makeSample(mOptions.input);
        if (!scene)
            return fail(scene.error());
        sayLosses(scene.value());
        const Result<Done> written = mFiles.write(scene.value(), mOptions);
        return written ? 0 : fail(written.error());
    }

    int runConvert()
    {
        if (const Result<Done> writable = checkTargets(); !writable)
            return fail(writable.error());
        const Result<Scene> scene = mFiles.read(mOptions.input);
        if (!scene)
            return fail(scene.error());
        sayLosses(scene.value());
        const Result<Done> written = mFiles.write(scene.value(), mOptions);
        return written ? 0 : fail(written.error());
    }

    int runCheck()
    {
        const Result<Scene> scene = mFiles.read(mOptions.input);
        if (!scene)
            return fail(scene.error());
        MapReport report = reportOn(scene.value(), mOptions.unwrap.packing.textureSize);
        report.input = mOptions.input;
        if (mOptions.json) {
            report.status = QStringLiteral("done");
            mOut << QString::fromUtf8(reportJson(report));
        } else {
            printFigures(scene.value(), report);
        }
        mOut << Qt::flush;
        if (mOut.status() != QTextStream::Ok)
            return fail(
                {QStringLiteral("the figures could not be written to the standard output"), {}, 0, {}});
        return 0;
    }

    int runReplay()
    {
        if (!mOptions.output.isEmpty()) {
            if (const Result<Done> writable = checkTargets(); !writable)
                return fail(writable.error());
        }
        const Result<LoadedProject> project = loadProject(mOptions.input);
        if (!project)
            return fail(project.error());
        const std::optional<Journal> &journal = project->extras.journal;
        if (!journal) {
            for (const QString &note : project->notes)
                mErr << "autocuts-cli: note: " << note << Qt::endl;
            return fail({QStringLiteral("the session has no journal that could be replayed"), mOptions.input,
                         0, QStringLiteral("Use convert to write its present state")});
        }
        Result<std::unique_ptr<Document>> document = replay(*journal);
        if (!document)
            return fail(document.error());
        const bool same = sameWork(document.value()->state(), project->state);
        mOut << "replayed commands: " << journal->commands.size() << '\n'
             << (same ? "the result is what the session holds"
                      : "the result differs from what the session holds")
             << Qt::endl;
        if (!mOptions.output.isEmpty()) {
            const Scene scene = mFiles.take(std::move(document).value(), *journal);
            sayLosses(scene);
            if (const Result<Done> written = mFiles.write(scene, mOptions); !written)
                return fail(written.error());
        }
        return same ? 0 : 1;
    }

    //! Checks before the long computation that all output files can be written.
    Result<Done> checkTargets() const
    {
        for (const QString &target : {mOptions.output, mOptions.layout, mOptions.report}) {
            if (target.isEmpty())
                continue;
            const QFileInfo folder(QFileInfo(target).absolutePath());
            if (!folder.isDir())
                return Error{QStringLiteral("the output folder does not exist"), folder.filePath(), 0,
                             QStringLiteral("Create it first")};
            if (QFileInfo(target).isDir())
                return Error{QStringLiteral("this is a folder, not a file"), target, 0,
                             QStringLiteral("Add a file name to the path")};
            if (!folder.isWritable())
                return Error{QStringLiteral("the output folder is read-only"), folder.filePath(), 0,
                             QStringLiteral("Check its permissions or choose another one")};
        }
        return isProjectPath(mOptions.output) ? Done{} : checkWriteFormat(mOptions.output);
    }

    template <class Work>
    int runMapping(Work &&work)
    {
        if (const Result<Done> writable = checkTargets(); !writable)
            return fail(writable.error());
        Result<Scene> scene = mFiles.read(mOptions.input);
        if (!scene)
            return fail(scene.error());
        mFiles.mergeSettings(mOptions);
        if (!(scene->mesh->area > 0))
            return fail({QStringLiteral("all faces are without area, there is nothing to map"),
                         mOptions.input, 0, QStringLiteral("Check the scale and the vertices of the model")});
        const StopTimer timer(mOptions.timeLimit, mStop);
        Result<Outcome> outcome = work(scene.value());
        mProgress.clear();
        if (!outcome)
            return fail(outcome.error());
        return writeResults(scene.value(), outcome.value());
    }

    Result<Outcome> unwrapScene(Scene &scene)
    {
        const Result<Snapshot> snapshot = mFiles.snapshot(scene, mOptions.settings);
        if (!snapshot)
            return snapshot.error();
        const unwrap::UnwrapResult result =
            unwrap::unwrapMesh(snapshot.value(), mOptions.unwrap, jobContext());
        if (mOptions.unwrap.pack && !result.packed)
            return noRoomError(mOptions);
        setUv(scene, result.uv);
        Outcome outcome;
        outcome.iterations = result.iterations;
        outcome.lambda = result.lambda;
        outcome.delta = result.delta;
        if (result.symmetry == 0.0)
            outcome.warnings << QStringLiteral("the mesh is not symmetric: nor are the cuts");
        else if (result.symmetry)
            outcome.notes
                << QStringLiteral("symmetric part of the seams: %1 %").arg(100 * *result.symmetry, 0, 'f', 1);
        if (!result.withinBound)
            outcome.warnings << boundMissed(result.distortion);
        return outcome;
    }

    Result<Outcome> packScene(Scene &scene)
    {
        if (!scene.hasUv())
            return noUvs();
        UvMatrix uv = scene.uvSets.front().uv;
        const MeshData &mesh = *scene.mesh;
        const Result<unwrap::PackJob> pack = batchPacking(mOptions, mFiles, mesh);
        if (!pack)
            return pack.error();
        const JobContext job = jobContext().part(0, 1, JobStage::Packing);
        if (!unwrap::packCharts(mesh, findCharts(mesh, uv), pack.value(), uv, job))
            return noRoomError(mOptions);
        setUv(scene, uv);
        return Outcome{};
    }

    Result<Outcome> separateScene(Scene &scene)
    {
        using Separation = unwrap::SeparateResult::Outcome;
        if (!scene.hasUv())
            return noUvs();
        const Result<Snapshot> snapshot = mFiles.snapshot(scene, mOptions.settings);
        if (!snapshot)
            return snapshot.error();
        const Result<unwrap::PackJob> pack = batchPacking(mOptions, mFiles, *scene.mesh);
        if (!pack)
            return pack.error();
        const unwrap::SeparateResult made =
            unwrap::separateMap(snapshot.value(), scene.uvSets.front().uv, pack.value(), jobContext());
        Outcome outcome;
        switch (made.outcome) {
        case Separation::Done:
            setUv(scene, made.uv);
            outcome.notes << QStringLiteral("edges cut to take overlaps apart: %1").arg(made.newSeams);
            if (made.unresolvedPairs > 0)
                outcome.warnings << QStringLiteral("overlaps inside single polygons or across joined edges, "
                                                   "which stay whole: %1")
                                        .arg(made.unresolvedPairs);
            break;
        case Separation::NoOverlaps:
            outcome.notes << QStringLiteral("there are no overlaps: the map stays as it is");
            break;
        case Separation::Stopped:
            outcome.warnings << QStringLiteral("stopped before the overlaps were taken apart");
            break;
        case Separation::NoRoom:
            return noRoomError(mOptions);
        }
        return outcome;
    }

    Result<Outcome> finishScene(Scene &scene)
    {
        if (!scene.hasUv())
            return noUvs();
        const Result<Snapshot> snapshot = mFiles.snapshot(scene, mOptions.settings);
        if (!snapshot)
            return snapshot.error();
        unwrap::FinishInput finish;
        finish.snapshot = snapshot.value();
        finish.uv = scene.uvSets.front().uv;
        finish.uvScale = mFiles.uvScale(scene);
        finish.maxDistortion = mOptions.unwrap.maxDistortion;
        finish.packing = mOptions.unwrap.packing;
        const unwrap::FinishResult made = unwrap::finishMap(finish, jobContext());
        Outcome outcome;
        if (made.uv.rows() == 0) {
            outcome.warnings << QStringLiteral("stopped before there was a finished map");
            return outcome;
        }
        if (made.noRoom)
            return noRoomError(mOptions);
        setUv(scene, made.uv);
        if (made.heldTogether)
            outcome.warnings << QStringLiteral("the map still covers itself: joined edges hold it together");
        if (made.distortion > mOptions.unwrap.maxDistortion)
            outcome.warnings << boundMissed(made.distortion);
        return outcome;
    }

    JobContext jobContext()
    {
        return {&mStop.stop, mOptions.threads,
                [this](const JobProgress &progress) { mProgress.show(progress); }};
    }

    QString boundMissed(double distortion) const
    {
        return QStringLiteral("the distortion is %1, above the bound of %2")
            .arg(distortion, 0, 'g', 6)
            .arg(mOptions.unwrap.maxDistortion);
    }

    Error noUvs() const
    {
        return {QStringLiteral("the file has no UVs"), mOptions.input, 0,
                QStringLiteral("Make them with autocuts-cli unwrap")};
    }

    static void setUv(Scene &scene, const UvMatrix &uv)
    {
        if (scene.uvSets.empty())
            scene.uvSets.push_back({QStringLiteral("UVMap"), {}});
        scene.uvSets.front().uv = uv;
    }

    int writeResults(const Scene &scene, const Outcome &outcome)
    {
        sayLosses(scene);
        if (const Result<Done> written = mFiles.write(scene, mOptions); !written)
            return fail(written.error());
        const int textureSize = mOptions.unwrap.packing.textureSize;
        MapReport report = reportOn(scene, textureSize);
        report.input = mOptions.input;
        report.output = mOptions.output;
        report.layout = mOptions.layout;
        if (outcome.iterations)
            report.iterations = *outcome.iterations;
        report.lambda = outcome.lambda;
        report.delta = outcome.delta;
        report.status = statusWord(mStop);
        report.notes += outcome.notes;
        if (!mOptions.quiet)
            printFigures(scene, report);
        for (const QString &warning : outcome.warnings)
            mErr << "autocuts-cli: warning: " << warning << Qt::endl;
        report.notes += outcome.warnings;
        if (!mOptions.layout.isEmpty()) {
            const bool overlaps = report.overlapPairs.value_or(0) > 0;
            if (const Result<Done> drawn = writeLayout(mOptions.layout, scene, textureSize, overlaps); !drawn)
                return fail(drawn.error());
        }
        report.seconds = double(mClock.elapsed()) / 1000;
        if (!mOptions.report.isEmpty()) {
            if (const Result<Done> saved = saveAtomically(mOptions.report, reportJson(report)); !saved)
                return fail(saved.error());
        }
        return mStop.reason == StopReason::Interrupted ? 130 : 0;
    }

    void printFigures(const Scene &scene, const MapReport &report)
    {
        mOut << reportTable(report);
        for (const QString &note : report.notes)
            mOut << "note: " << note << '\n';
        const QStringList problems = mapProblems(scene, report);
        for (const QString &problem : problems)
            mOut << "problem: " << problem << '\n';
        if (problems.isEmpty())
            mOut << "no problems found\n";
        mOut << Qt::flush;
    }

    void sayLosses(const Scene &scene)
    {
        for (const QString &loss : BatchFiles::losses(scene, mOptions.output))
            mErr << "autocuts-cli: note: " << loss << Qt::endl;
    }

    CliOptions mOptions;
    BatchFiles mFiles;
    StopSource &mStop;
    QTextStream &mOut;
    QTextStream &mErr;
    ProgressLine mProgress;
    QElapsedTimer mClock;
};

} // namespace

int runCommand(const CliOptions &options, StopSource &stop, bool showProgress, QTextStream &out,
               QTextStream &err)
{
    Job job(options, stop, showProgress, out, err);
    const auto failure = [&](const QString &what, const QString &remedy) {
        return job.fail({what, options.input, 0, remedy});
    };
    try {
        return job.run();
    } catch (const std::bad_alloc &) {
        return failure(QStringLiteral("not enough memory"),
                       QStringLiteral("Close other programs or use a smaller model"));
    } catch (const std::exception &e) {
        return failure(QString::fromUtf8(e.what()), {});
    }
}

} // namespace autocuts
