#include "cli/batch.h"

#include "cli/batchpictures.h"
#include "cli/batchscope.h"
#include "cli/clicompletion.h"
#include "cli/clihelp.h"
#include "cli/mapmaking.h"
#include "cli/mapreporting.h"
#include "cli/outputcheck.h"
#include "cli/progressline.h"
#include "cli/standardstreams.h"
#include "commands/replay.h"
#include "model/io/files/savefile.h"
#include "model/io/files/sessionlock.h"
#include "model/io/files/setjournal.h"
#include "model/io/meshes/instances.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "model/layouts/uvexport.h"
#include "model/samples/samples.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <exception>
#include <functional>
#include <new>
#include <system_error>

namespace autocuts {

namespace {

using Command = CliOptions::Command;

QString statusWord(const StopSource &stop, bool boundMissed)
{
    switch (stop.reason.load()) {
    case StopReason::Interrupted:
        return QStringLiteral("interrupted");
    case StopReason::TimeLimit:
        return QStringLiteral("time_limit");
    case StopReason::None:
        break;
    }
    return boundMissed ? QStringLiteral("bound_missed") : QStringLiteral("done");
}

ProgressStyle styleFor(const CliOptions &options, bool onTerminal)
{
    if (options.jsonProgress)
        return ProgressStyle::Json;
    if (options.quiet)
        return ProgressStyle::None;
    return onTerminal ? ProgressStyle::Line : ProgressStyle::Lines;
}

//! Runs one command.
class Job final
{
public:
    Job(const CliOptions &options, const StandardStreams &streams, StopSource &stop, bool onTerminal,
        QTextStream &out, QTextStream &err)
        : mOptions(options), mStreams(streams), mStop(stop), mOut(out), mErr(err),
          mProgress(styleFor(options, onTerminal), err)
    {
        mClock.start();
        if (options.command == Command::Bake || options.command == Command::LightBake)
            mProgress.setWorkingWord(QStringLiteral("baking"));
        if (options.command == Command::Transfer)
            mProgress.setWorkingWord(QStringLiteral("transferring"));
    }

    int run()
    {
        if (!mOptions.dryRun)
            sayWarnings(endBrokenSets(namedFiles(mOptions)));
        const int code = runCommand();
        mOut << Qt::flush;
        if (code == 0 && mOut.status() != QTextStream::Ok)
            return fail({QStringLiteral("the standard output cannot be written"),
                         {},
                         0,
                         QStringLiteral("Check where it leads, and the space there")});
        return code;
    }

    int fail(const Error &error)
    {
        mProgress.clear();
        mErr << "autocuts-cli: " << mStreams.named(error.toString()) << Qt::endl;
        return 1;
    }

private:
    int runCommand()
    {
        switch (mOptions.command) {
        case Command::Help:
            mOut << usageText(mOptions.each) << Qt::flush;
            return 0;
        case Command::ManPage:
            mOut << manualPage() << Qt::flush;
            return 0;
        case Command::Markdown:
            mOut << markdownTables() << Qt::flush;
            return 0;
        case Command::Completion:
            mOut << completionScript(mOptions.input) << Qt::flush;
            return 0;
        case Command::Settings:
            mOut << mOptions.settingsText << Qt::flush;
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
        case Command::Thumbnail:
            return runThumbnail();
        case Command::Batch:
            break; // manyfiles::runBatch() does that
        case Command::Unwrap:
            return runMapping(&MapMaking::unwrap);
        case Command::Pack:
            return runMapping(&MapMaking::pack);
        case Command::Finish:
            return runMapping(&MapMaking::finish);
        case Command::Lightmap:
            return runMapping(&MapMaking::lightmap);
        case Command::Separate:
            return runMapping(&MapMaking::separate);
        case Command::Bake:
            return runBake(bakeMaps);
        case Command::LightBake:
            return runBake(bakeLights);
        case Command::Transfer:
            if (!mOptions.textures.isEmpty())
                return runBake(carryTextures);
            return runMapping(&MapMaking::transfer);
        }
        return 1;
    }

    int runSample()
    {
        if (const Result<Done> writable = checkTargets(mOptions); !writable)
            return fail(writable.error());
        const Result<Scene> scene = makeSample(mOptions.input);
        if (!scene)
            return fail(scene.error());
        sayLosses(scene.value());
        if (mOptions.dryRun)
            return sayPlan();
        const Result<Done> written = writeOutput(scene.value());
        return written ? 0 : fail(written.error());
    }

    //! In place of the work: what it would write.
    int sayPlan()
    {
        QStringList targets{mOptions.output, mOptions.layout, mOptions.report};
        targets.removeAll(QString());
        if (targets.isEmpty())
            mOut << mStreams.named(mOptions.input) << ": nothing would be written" << Qt::endl;
        for (const QString &target : targets)
            mOut << mStreams.named(mOptions.input + QStringLiteral(" -> ") + target) << Qt::endl;
        return 0;
    }

    Result<Done> saveReport(const QByteArray &report) const
    {
        return saveAtomically(mOptions.report, mStreams.named(QString::fromUtf8(report)).toUtf8());
    }

    //! What a command reports that makes no map. \param scene as it is in the file
    MapReport reportOnFile(const Scene &scene, const std::vector<bool> &faces = {}) const
    {
        MapReport report = reportOn(scene, withInstanceStacks(scene, mFiles.islandFlags()),
                                    mFiles.packingSettings(mOptions), faces);
        report.input = mOptions.input;
        report.output = mOptions.output;
        report.status = QStringLiteral("done");
        return report;
    }

    //! Writes what was read or replayed, and the report on it.
    Result<Done> writeWithReport(const Scene &scene, const QString &status, const QStringList &notes)
    {
        const QStringList losses = mOptions.output.isEmpty() ? QStringList() : sayLosses(scene);
        const Result<Done> written = mOptions.output.isEmpty() ? Done{} : writeOutput(scene);
        if (!written || mOptions.report.isEmpty())
            return written;
        const QString format = mOptions.output.isEmpty() ? scene.format : QFileInfo(mOptions.output).suffix();
        MapReport report =
            reportOnFile(asWritten(scene, format.toLower(), mFiles.packingSettings(mOptions).tileHeight()));
        report.status = status;
        report.seconds = double(mClock.elapsed()) / 1000;
        report.notes += notes + losses;
        return saveReport(reportJson(report));
    }

    //! Says on stderr what a session has lost, also with --quiet.
    Result<Scene> readInput(const std::atomic<bool> *stop = nullptr)
    {
        Result<Scene> scene = mFiles.read(mOptions, stop);
        sayWarnings(mFiles.warnings());
        return scene;
    }

    Result<Done> writeOutput(const Scene &scene)
    {
        if (isProjectPath(mOptions.output)) {
            const QString holder = SessionLock(mOptions.output).holder();
            if (!holder.isEmpty())
                sayWarnings(
                    {QStringLiteral("the session is open in %1, which asks before it replaces this one")
                         .arg(holder)});
        }
        const qsizetype before = mFiles.warnings().size();
        Result<Done> written = mFiles.write(scene, mOptions);
        sayWarnings(mFiles.warnings().mid(before));
        return written;
    }

    void sayWarnings(const QStringList &warnings)
    {
        for (const QString &warning : warnings)
            mErr << "autocuts-cli: warning: " << mStreams.named(warning) << Qt::endl;
    }

    int runConvert()
    {
        if (const Result<Done> writable = checkTargets(mOptions); !writable)
            return fail(writable.error());
        const Result<Scene> scene = readInput();
        if (!scene)
            return fail(scene.error());
        if (const Result<Done> fine = checkClashes(mOptions, mFiles.modelOf(scene.value())); !fine)
            return fail(fine.error());
        if (!mFiles.warnings().isEmpty() && isProjectPath(mOptions.output) && !mOptions.force)
            return fail(
                {QStringLiteral("the session is damaged, and nothing was written"), mOptions.input, 0,
                 QStringLiteral("Convert a backup of it, the same name with .1 or .2 behind it, or use "
                                "--force for what is left")});
        if (mOptions.dryRun)
            return sayPlan();
        const Result<Done> written = writeWithReport(scene.value(), QStringLiteral("done"), {});
        return written ? 0 : fail(written.error());
    }

    int runCheck()
    {
        if (const Result<Done> writable = checkTargets(mOptions); !writable)
            return fail(writable.error());
        const Result<Scene> scene = readInput();
        if (!scene)
            return fail(scene.error());
        mFiles.mergeSettings(mOptions);
        const auto scope = batchScope(mOptions, scene.value());
        if (!scope)
            return fail(scope.error());
        if (mOptions.dryRun)
            return sayPlan();
        const MapReport report =
            reportOnFile(asWritten(scene.value(), scene->format, mOptions.unwrap.packing.tileHeight()),
                         scope.value() ? scope.value()->faces : std::vector<bool>());
        if (mOptions.json)
            mOut << mStreams.named(QString::fromUtf8(reportJson(report)));
        else if (!mOptions.quiet)
            printFigures(report);
        if (!mOptions.report.isEmpty()) {
            if (const Result<Done> saved = saveReport(reportJson(report)); !saved)
                return fail(saved.error());
        }
        if (!mOptions.failOn)
            return 0;
        const QStringList found = failures(report, *mOptions.failOn);
        for (const QString &text : found)
            mErr << "autocuts-cli: " << text << Qt::endl;
        return found.isEmpty() ? 0 : 4;
    }

    int runReplay()
    {
        if (const Result<Done> writable = checkTargets(mOptions); !writable)
            return fail(writable.error());
        const Result<LoadedProject> project = loadProject(mOptions.input);
        if (!project)
            return fail(project.error());
        sayWarnings(project->warnings);
        const std::optional<Journal> &journal = project->extras.journal;
        if (!journal) {
            for (const QString &note : project->notes.mid(project->warnings.size()))
                mErr << "autocuts-cli: note: " << note << Qt::endl;
            return fail({QStringLiteral("the session has no journal that could be replayed"), mOptions.input,
                         0, QStringLiteral("Use convert to write its present state")});
        }
        if (mOptions.dryRun)
            return sayPlan();
        Result<std::unique_ptr<Document>> document = replay(*journal);
        if (!document)
            return fail(document.error());
        const bool same = sameWork(document.value()->state(), project->state);
        const QStringList outcome{QStringLiteral("replayed commands: %1").arg(journal->commands.size()),
                                  same ? QStringLiteral("the result is what the session holds")
                                       : QStringLiteral("the result differs from what the session holds")};
        if (!mOptions.quiet)
            mOut << outcome.join(QLatin1Char('\n')) << Qt::endl;
        const Scene scene = mFiles.take(std::move(document).value(), *journal);
        const Result<Done> written =
            writeWithReport(scene, same ? QStringLiteral("done") : QStringLiteral("differs"), outcome);
        if (!written)
            return fail(written.error());
        return same ? 0 : 1;
    }

    int runThumbnail()
    {
        if (const Result<Done> writable = checkTargets(mOptions); !writable)
            return fail(writable.error());
        QImage picture;
        if (isProjectPath(mOptions.input) && mOptions.show == CliOptions::Show::Model) {
            const Result<ProjectSummary> summary = loadProjectSummary(mOptions.input);
            if (!summary)
                return fail(summary.error());
            picture = QImage::fromData(summary->thumbnail);
        }
        if (picture.isNull()) {
            const Result<Scene> scene = readInput();
            if (!scene)
                return fail(scene.error());
            picture = thumbnailOf(mOptions, scene.value());
        } else {
            picture = picture.scaled(mOptions.pictureSide, mOptions.pictureSide, Qt::KeepAspectRatio,
                                     Qt::SmoothTransformation);
        }
        if (mOptions.dryRun)
            return sayPlan();
        QByteArray png;
        QBuffer buffer(&png);
        buffer.open(QIODevice::WriteOnly);
        picture.save(&buffer, "PNG");
        const Result<Done> saved = saveAtomically(mOptions.output, png);
        return saved ? 0 : fail(saved.error());
    }

    int runMapping(Result<MadeMap> (MapMaking::*make)(Scene &) const)
    {
        if (const Result<Done> writable = checkTargets(mOptions); !writable)
            return fail(writable.error());
        const StopTimer timer(mOptions.timeLimit, mStop);
        setPreparing(mOptions.command == Command::Transfer); // the others have a map as soon as they begin
        Result<Scene> scene = readInput(&mStop.stop);
        if (!scene)
            return failReading(scene.error());
        if (const Result<Done> fine = checkClashes(mOptions, mFiles.modelOf(scene.value())); !fine)
            return fail(fine.error());
        mFiles.mergeSettings(mOptions);
        // Now, because islands have other numbers in the new map.
        const auto scope = batchScope(mOptions, scene.value());
        if (!scope)
            return fail(scope.error());
        mScope = scope.value();
        if (!(scene->mesh->area > 0))
            return fail({QStringLiteral("all faces are without area, there is nothing to map"),
                         mOptions.input, 0, QStringLiteral("Check the scale and the vertices of the model")});
        if (mOptions.dryRun)
            return sayPlan();
        const JobContext job = jobContext();
        const MapMaking making(mOptions, mFiles, job);
        const Result<MadeMap> made = (making.*make)(scene.value());
        setPreparing(false);
        mProgress.clear();
        if (!made)
            return fail(made.error());
        mFiles.setIslandFlags(made->flags);
        return writeResults(scene.value(), made.value());
    }

    //! Temporary files would outlive a program that is ended at once.
    void setPreparing(bool on) { mStop.isPreparing = on && !mStreams.areUsed(); }

    JobContext jobContext()
    {
        return {&mStop.stop, mOptions.threads, [this](const JobProgress &progress) {
                    setPreparing(progress.stage == JobStage::Preparing);
                    mProgress.show(progress);
                }};
    }

    //! Makes pictures instead of a map.
    int runBake(Result<jobs::MadePictures> (*bake)(const CliOptions &, const BatchFiles &, const Scene &,
                                                   const JobContext &))
    {
        if (const Result<Done> writable = checkTargets(mOptions); !writable)
            return fail(writable.error());
        const StopTimer timer(mOptions.timeLimit, mStop);
        setPreparing(true);
        const Result<Scene> scene = readInput(&mStop.stop);
        if (!scene)
            return failReading(scene.error());
        if (const Result<Done> fine = checkClashes(mOptions, mFiles.modelOf(scene.value())); !fine)
            return fail(fine.error());
        if (mOptions.dryRun)
            return sayPlan();
        mFiles.mergeSettings(mOptions);
        const JobContext job = jobContext();
        const Result<jobs::MadePictures> baked = bake(mOptions, mFiles, scene.value(), job);
        setPreparing(false);
        mProgress.clear();
        if (!baked)
            return failReading(baked.error());
        QStringList warnings = jobs::textsOf(baked->warnings);
        if (baked->stopped && baked->files.isEmpty())
            warnings << QStringLiteral("stopped before all pictures were finished: none was written");
        sayWarnings(warnings);
        if (!mOptions.quiet) {
            for (const QString &file : baked->files)
                mOut << mStreams.named(file) << '\n';
            mOut << Qt::flush;
        }
        if (!mOptions.report.isEmpty()) {
            QJsonObject report = pictureReport(baked.value());
            report.insert(QStringLiteral("input"), mOptions.input);
            report.insert(QStringLiteral("notes"), QJsonArray::fromStringList(mFiles.warnings() + warnings));
            report.insert(QStringLiteral("status"), statusWord(mStop, false));
            report.insert(QStringLiteral("seconds"), double(mClock.elapsed()) / 1000);
            if (const Result<Done> saved = saveReport(QJsonDocument(report).toJson()); !saved)
                return failAfter(baked->files, saved.error());
        }
        return mStop.reason == StopReason::Interrupted ? 130 : 0;
    }

    //! Names the files that are written already and stay.
    int failAfter(QStringList written, Error error)
    {
        written.removeAll(QString());
        if (!written.isEmpty())
            error.message += QStringLiteral("; written already: %1").arg(written.join(QStringLiteral(", ")));
        return fail(error);
    }

    int failReading(const Error &error)
    {
        switch (mStop.reason.load()) {
        case StopReason::Interrupted:
            fail({QStringLiteral("interrupted before the model was read, nothing was written"),
                  mOptions.input,
                  0,
                  {}});
            return 130;
        case StopReason::TimeLimit:
            return fail({QStringLiteral("the time limit was over before the model was read"), mOptions.input,
                         0, QStringLiteral("Give it a longer --time-limit")});
        case StopReason::None:
            break;
        }
        return fail(error);
    }

    //! Figures and pictures are those of the file that is written
    int writeResults(const Scene &mapped, const MadeMap &made)
    {
        sayLosses(mapped);
        if (const Result<Done> written = writeOutput(mapped); !written)
            return fail(written.error());
        const PackingSettings &packing = mOptions.unwrap.packing;
        const Scene scene =
            asWritten(mapped, QFileInfo(mOptions.output).suffix().toLower(), packing.tileHeight());
        const std::vector<IslandFlags> flags = withInstanceStacks(scene, mFiles.islandFlags());
        MapReport report = reportOn(scene, flags, packing);
        report.input = mOptions.input;
        report.output = mOptions.output;
        report.layout = mOptions.layout;
        if (made.iterations)
            report.iterations = *made.iterations;
        report.lambda = made.lambda;
        report.delta = made.delta;
        report.hardSurfaceShare = made.hardShare;
        report.status = statusWord(mStop, made.boundMissed);
        const bool wasStopped = mStop.stop; // what was found until then is drawn
        report.notes += made.notes;
        report.transfer = made.transfer;
        if (!mOptions.quiet)
            printFigures(report);
        const QStringList warnings = made.warnings + mapWarnings(report);
        sayWarnings(warnings);
        report.notes += warnings;
        if (!mOptions.layout.isEmpty()) {
            const StopSource *stop = wasStopped ? nullptr : &mStop;
            std::vector<int> hatched;
            if (report.overlapPairs.value_or(0) > 0)
                hatched = overlappingTriangles(scene, flags, stop);
            const std::vector<bool> faces = mScope ? mScope->faces : std::vector<bool>();
            const Result<Done> drawn = writeLayout(mOptions, scene, hatched, faces, stop);
            if (!drawn && (wasStopped || mStop.reason != StopReason::Interrupted))
                return failAfter({mOptions.output}, drawn.error());
            if (!drawn) {
                sayWarnings({drawn.error().toString()});
                report.layout.clear();
            }
        }
        report.seconds = double(mClock.elapsed()) / 1000;
        if (!mOptions.report.isEmpty()) {
            if (const Result<Done> saved = saveReport(reportJson(report)); !saved)
                return failAfter({mOptions.output, mOptions.layout}, saved.error());
        }
        if (mStop.reason == StopReason::Interrupted)
            return 130;
        return report.status == QLatin1String("bound_missed") ? 3 : 0;
    }

    void printFigures(const MapReport &report)
    {
        mOut << reportTable(report);
        for (const QString &note : report.notes)
            mOut << "note: " << mStreams.named(note) << '\n';
        const QStringList problems = mapProblems(report);
        for (const QString &problem : problems)
            mOut << "problem: " << problem << '\n';
        if (problems.isEmpty())
            mOut << "no problems found\n";
        mOut << Qt::flush;
    }

    QStringList sayLosses(const Scene &scene)
    {
        const QStringList losses = BatchFiles::losses(scene, mOptions.output);
        for (const QString &loss : losses)
            mErr << "autocuts-cli: note: " << loss << Qt::endl;
        return losses;
    }

    CliOptions mOptions;
    const StandardStreams &mStreams;
    BatchFiles mFiles;
    std::shared_ptr<const JobScope> mScope; //!< of --only; null: everything
    StopSource &mStop;
    QTextStream &mOut;
    QTextStream &mErr;
    ProgressLine mProgress;
    QElapsedTimer mClock;
};

} // namespace

int runCommand(const CliOptions &given, StopSource &stop, bool onTerminal, QTextStream &out, QTextStream &err)
{
    CliOptions options = given;
    StandardStreams streams;
    const Result<Done> taken = streams.take(options);
    Job job(options, streams, stop, onTerminal, streams.hasOutput() && !options.dryRun ? err : out, err);
    if (!taken)
        return job.fail(taken.error());
    const auto failure = [&](const QString &what, const QString &remedy) {
        return job.fail({what, options.input, 0, remedy});
    };
    const auto noMemory = [&] {
        return failure(QStringLiteral("not enough memory"),
                       QStringLiteral("Close other programs or use a smaller model"));
    };
    try {
        const int code = job.run();
        if (const Result<Done> written = streams.give(code == 0 && !options.dryRun); !written)
            return job.fail(written.error());
        return code;
    } catch (const std::bad_alloc &) {
        return noMemory();
    } catch (const std::system_error &) { // no room for another thread
        return noMemory();
    } catch (const std::exception &e) {
        return failure(QString::fromUtf8(e.what()), {});
    }
}

} // namespace autocuts
