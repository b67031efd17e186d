#include "cli/manyfiles/manyfiles.h"

#include "cli/manyfiles/filerunner.h"
#include "cli/manyfiles/machine.h"
#include "cli/manyfiles/runreport.h"
#include "cli/outputcheck.h"
#include "cli/progressline.h"
#include "model/io/files/savefile.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QThread>

#include <algorithm>

namespace autocuts::manyfiles {

namespace {

using namespace Qt::Literals::StringLiterals;

//! What a file costs besides its bytes, for the estimate of the time.
constexpr qint64 weightOfFile = 20'000;

qint64 weightOf(const FileTask &task)
{
    return task.bytes + weightOfFile;
}

QString durationText(double seconds)
{
    if (seconds < 100)
        return u"%1 s"_s.arg(seconds, 0, 'f', 0);
    return seconds < 6000 ? u"%1 min"_s.arg(seconds / 60, 0, 'f', 0)
                          : u"%1 h"_s.arg(seconds / 3600, 0, 'f', 1);
}

//! Says how far a batch is.
class BatchProgress final
{
public:
    BatchProgress(const CliOptions &options, bool onTerminal, QTextStream &err,
                  const std::vector<FileTask> &tasks)
        : mJson(options.jsonProgress), mLines(!options.quiet && !onTerminal), mErr(err),
          mLine(onTerminal && !options.quiet && !mJson ? ProgressStyle::Line : ProgressStyle::None, err),
          mTotal(int(tasks.size()))
    {
        for (const FileTask &task : tasks)
            mWeightLeft += weightOf(task);
        mClock.start();
        mLine.show(u"0 of %1"_s.arg(mTotal));
    }

    void add(const FileResult &result)
    {
        ++mDone;
        mFailed += !result.succeeded();
        mWeightDone += weightOf(result.task);
        mWeightLeft -= weightOf(result.task);
        const double left = double(mClock.elapsed()) / 1000 * double(mWeightLeft) / double(mWeightDone);
        if (mJson) {
            const QJsonObject event{{u"done"_s, mDone},
                                    {u"total"_s, mTotal},
                                    {u"failed"_s, mFailed},
                                    {u"seconds_left"_s, left},
                                    {u"input"_s, result.task.input},
                                    {u"output"_s, result.task.output},
                                    {u"status"_s, result.status},
                                    {u"message"_s, result.message}};
            mErr << QString::fromUtf8(QJsonDocument(event).toJson(QJsonDocument::Compact)) << Qt::endl;
            return;
        }
        if (!result.succeeded()) {
            mLine.clear();
            mErr << "autocuts-cli: " << result.status << ": " << result.task.input << ": " << result.message
                 << Qt::endl;
        } else if (mLines) {
            mErr << mDone << " of " << mTotal << ": " << result.task.input << ": " << result.status
                 << Qt::endl;
        }
        QString text = u"%1 of %2"_s.arg(mDone).arg(mTotal);
        if (mFailed > 0)
            text += u", %1 failed"_s.arg(mFailed);
        mLine.show(text + u", about %1 left"_s.arg(durationText(left)));
    }

    void clear() { mLine.clear(); }

private:
    bool mJson, mLines;
    QTextStream &mErr;
    ProgressLine mLine;
    QElapsedTimer mClock;
    int mTotal, mDone = 0, mFailed = 0;
    qint64 mWeightDone = 0, mWeightLeft = 0;
};

//! One batch.
class Batch final
{
public:
    Batch(const CliOptions &options, StopSource &stop, bool onTerminal, QTextStream &out, QTextStream &err)
        : mOptions(options), mChoice(*options.many), mStop(stop), mOnTerminal(onTerminal), mOut(out),
          mErr(err), mNotes(notesOf(options)), mPictures(QDir(mNotes).filePath(u".autocuts-batch"_s)),
          mJournal(mChoice, mNotes)
    {}

    int run()
    {
        const auto tasks = fileTasks(mChoice, mOptions.output);
        if (!tasks)
            return fail(tasks.error());
        for (std::size_t i = 0; i < tasks.value().size(); ++i) {
            if (mChoice.parts == 0 || int(i % std::size_t(mChoice.parts)) == mChoice.part - 1)
                mTasks.push_back(tasks.value()[i]);
        }
        if (isModelName(mOptions.output) && !QFileInfo(mOptions.output).isDir())
            return fail({u"several files need a folder, and this looks like a file"_s, mOptions.output, 0,
                         u"Name a folder behind -o, with a slash at its end"_s});
        if (mOptions.dryRun)
            return sayPlan();
        for (const QString &folder : {mOptions.output, mNotes}) {
            if (!folder.isEmpty() && !QDir().mkpath(folder))
                return fail({u"the folder cannot be made"_s, folder, 0, u"Check the permissions"_s});
        }
        if (!mChoice.report.isEmpty()) {
            if (const Result<Done> writable = checkOutputFile(mChoice.report); !writable)
                return fail(writable.error());
        }
        const auto lock = RunJournal::lock(mChoice, mNotes);
        if (!lock)
            return fail(lock.error());
        if (const Result<Done> begun = begin(); !begun)
            return fail(begun.error());
        const Result<Done> worked = work();
        if (!worked)
            return fail(worked.error());
        if (const Result<Done> reported = writeReport(); !reported)
            return fail(reported.error());
        return mStop.stop ? 130 : saySummary();
    }

private:
    int fail(const Error &error)
    {
        mErr << "autocuts-cli: " << error.toString() << Qt::endl;
        return 1;
    }

    //! The folder of the journal. Without a place for it, it is one that goes with the batch.
    QString notesOf(const CliOptions &options)
    {
        if (!mChoice.journal.isEmpty())
            return mChoice.journal;
        if (!options.output.isEmpty())
            return options.output;
        mOwnNotes.emplace();
        return mOwnNotes->path();
    }

    bool isCheck() const { return mOptions.each == CliOptions::Command::Check; }

    int sayPlan()
    {
        for (const FileTask &task : mTasks) {
            if (isCheck() || mOptions.output.isEmpty())
                mOut << task.input << ": nothing would be written\n";
            else
                mOut << task.input << " -> " << QDir(mOptions.output).filePath(task.output) << '\n';
        }
        if (!mChoice.report.isEmpty())
            mOut << "all of them -> " << mChoice.report << '\n';
        mOut << Qt::flush;
        return 0;
    }

    Result<Done> begin()
    {
        if (!mChoice.resume)
            return mJournal.begin(mChoice);
        const Result<FileResults> known = mJournal.resume(mChoice);
        if (!known)
            return known.error();
        mKnown = known.value();
        return mChoice.parts == 0 ? takeOverParts() : Done{};
    }

    //! Adds to the journal what those of the parts know better.
    Result<Done> takeOverParts()
    {
        for (const auto &[output, result] : mJournal.ofParts(mChoice)) {
            const auto found = mKnown.find(output);
            const bool isNews = found == mKnown.end() || found->second.task.modified < result.task.modified ||
                                (!found->second.succeeded() && result.succeeded());
            if (!isNews)
                continue;
            if (const Result<Done> added = mJournal.add(result); !added)
                return added;
            mKnown[output] = result;
        }
        return Done{};
    }

    //! True when the journal says what came of the file, and that is still so.
    bool isKnown(const FileTask &task) const
    {
        const auto found = mKnown.find(task.output);
        if (found == mKnown.end() || !found->second.isOf(task))
            return false;
        if (!found->second.succeeded())
            return !mChoice.retry;
        return isCheck() || QFileInfo::exists(QDir(mOptions.output).filePath(task.output));
    }

    RunLimits limits() const
    {
        const int cores = std::max(1, QThread::idealThreadCount());
        RunLimits limits;
        limits.jobs = mChoice.jobs > 0 ? mChoice.jobs : cores;
        limits.threads = std::max(1, cores / limits.jobs);
        limits.memory = mChoice.memory > 0 ? qint64(mChoice.memory * 1e9) : freeMemory() / 4 * 3;
        limits.secondsPerFile = mChoice.fileLimit;
        return limits;
    }

    Result<Done> work()
    {
        std::vector<FileTask> waiting;
        std::copy_if(mTasks.begin(), mTasks.end(), std::back_inserter(waiting),
                     [this](const FileTask &task) { return !isKnown(task); });
        if (draws() && !QDir().mkpath(mPictures))
            return Error{u"the folder cannot be made"_s, mPictures, 0, u"Check the permissions"_s};
        BatchProgress progress(mOptions, mOnTerminal, mErr, waiting);
        if (mChoice.elsewhere)
            return workElsewhere(waiting, progress);
        FileRunner runner(mChoice, mOptions.output, draws() ? mPictures : QString(), limits());
        Result<Done> noted = Done{};
        runner.run(waiting, mStop.stop, [&](const FileResult &result) {
            noted = note(result, progress);
            return noted.ok();
        });
        return noted;
    }

    bool draws() const { return mChoice.report.endsWith(u".html"_s); }

    //! The journal comes first: what progress says is done must not be done again after a kill.
    Result<Done> note(const FileResult &result, BatchProgress &progress)
    {
        Result<Done> noted = mJournal.add(result);
        mKnown[result.task.output] = result;
        progress.add(result);
        return noted;
    }

    void say(const QJsonObject &line)
    {
        mOut << QString::fromUtf8(QJsonDocument(line).toJson(QJsonDocument::Compact)) << '\n';
    }

    //! Says what is to be done: first how, then a line for each file. Then reads lines of the journals of
    //! those who have done it, until there are no more.
    Result<Done> workElsewhere(const std::vector<FileTask> &waiting, BatchProgress &progress)
    {
        QStringList arguments = QStringList{u"batch"_s, mChoice.command} + mChoice.passed;
        if (!mChoice.format.isEmpty())
            arguments << u"--format=%1"_s.arg(mChoice.format);
        if (mChoice.fileLimit > 0)
            arguments << u"--file-limit=%1"_s.arg(mChoice.fileLimit);
        say({{u"autocuts"_s, QCoreApplication::applicationVersion()},
             {u"arguments"_s, QJsonArray::fromStringList(arguments)},
             {u"folder"_s, mOptions.output},
             {u"pictures"_s, draws() ? mPictures : QString()},
             {u"files"_s, qint64(waiting.size())}});
        std::map<QString, FileTask> tasks;
        for (const FileTask &task : waiting) {
            tasks[task.output] = task;
            say({{u"input"_s, task.input},
                 {u"output"_s, task.output},
                 {u"memory"_s, expectedMemory(task)},
                 {u"picture"_s, FileRunner::pictureName(task)}});
        }
        mOut << Qt::flush;
        QFile input;
        if (!input.open(stdin, QIODevice::ReadOnly))
            return Error{input.errorString(), u"standard input"_s, 0, {}};
        for (QByteArray line = input.readLine(); line.endsWith('\n'); line = input.readLine()) {
            FileResult result = FileResult::fromJson(QJsonDocument::fromJson(line).object());
            const auto task = tasks.find(result.task.output);
            if (task == tasks.end())
                return Error{u"a line is about no file that is to be done"_s, u"standard input"_s, 0, {}};
            result.task = task->second;
            if (const Result<Done> noted = note(result, progress); !noted)
                return noted;
        }
        return Done{};
    }

    //! The results of the files that were named.
    std::vector<FileResult> results() const
    {
        std::vector<FileResult> results;
        for (const FileTask &task : mTasks) {
            if (const auto found = mKnown.find(task.output); found != mKnown.end())
                results.push_back(found->second);
        }
        return results;
    }

    Result<Done> writeReport() const
    {
        if (mChoice.report.isEmpty())
            return Done{};
        const RunReport report{mChoice, results(), mJournal.before(), mPictures};
        if (mChoice.report.endsWith(u".csv"_s))
            return saveAtomically(mChoice.report, csvReport(report));
        if (mChoice.report.endsWith(u".json"_s))
            return saveAtomically(mChoice.report, jsonReport(report));
        return saveAtomically(mChoice.report, htmlReport(report));
    }

    //! Of files that are checked, what was found in each.
    void sayFindings()
    {
        if (mOptions.json) {
            mOut << QString::fromUtf8(jsonReport({mChoice, results(), {}, {}})) << Qt::flush;
            return;
        }
        for (const FileResult &result : results()) {
            QStringList found = result.warnings + QStringList{result.message};
            found.removeAll(QString());
            mOut << result.task.input << ": "
                 << (found.isEmpty() ? u"no problems found"_s : found.join(u"; "_s)) << '\n';
        }
    }

    int saySummary()
    {
        std::map<QString, int> counts = countsOf(results());
        if (isCheck() && (mOptions.json || !mOptions.quiet))
            sayFindings();
        if (!mOptions.quiet && !mOptions.json) {
            for (const auto &[status, count] : counts)
                mOut << status << ": " << count << '\n';
            mOut << Qt::flush;
        }
        if (counts[u"failed"_s] + counts[u"crashed"_s] + counts[u"timed_out"_s] > 0)
            return 1;
        if (counts[u"check_failed"_s] > 0)
            return 4;
        return counts[u"bound_missed"_s] > 0 ? 3 : 0;
    }

    const CliOptions &mOptions;
    const ManyChoice &mChoice;
    StopSource &mStop;
    bool mOnTerminal;
    QTextStream &mOut;
    QTextStream &mErr;
    std::optional<QTemporaryDir> mOwnNotes;
    QString mNotes, mPictures; //!< the folder of the journal, and the one of pictures there
    RunJournal mJournal;
    std::vector<FileTask> mTasks;
    FileResults mKnown;
};

} // namespace

int runBatch(const CliOptions &options, StopSource &stop, bool showProgress, QTextStream &out,
             QTextStream &err)
{
    return Batch(options, stop, showProgress, out, err).run();
}

} // namespace autocuts::manyfiles
