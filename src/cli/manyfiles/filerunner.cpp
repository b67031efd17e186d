#include "cli/manyfiles/filerunner.h"

#include "cli/clitable.h"
#include "cli/manyfiles/machine.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QJsonDocument>
#include <QTimer>

#include <algorithm>

namespace autocuts::manyfiles {

namespace {

using namespace Qt::Literals::StringLiterals;

constexpr int lookEvery = 50; //!< milliseconds
constexpr qint64 programMemory = 100'000'000;
constexpr qint64 memoryPerByte = 150;
constexpr int pictureSide = 160;

const CliCommand &commandOf(const ManyChoice &choice)
{
    return *std::find_if(cliCommands().begin(), cliCommands().end(),
                         [&](const CliCommand &row) { return row.name == choice.command; });
}

bool isGiven(const QStringList &passed, const QString &name)
{
    return std::any_of(passed.begin(), passed.end(), [&](const QString &option) {
        return option == name || option.startsWith(name + u'=');
    });
}

//! What the lines that begin in a certain way say.
QStringList linesWith(const QByteArray &output, QLatin1StringView beginning)
{
    QStringList lines;
    for (const QString &line : QString::fromUtf8(output).split(u'\n')) {
        if (line.startsWith(beginning))
            lines << line.mid(beginning.size());
    }
    return lines;
}

//! What check says that --fail-on names.
QStringList findings(const QByteArray &errors)
{
    QStringList lines = linesWith(errors, "autocuts-cli: "_L1);
    lines.removeIf(
        [](const QString &line) { return line.startsWith("warning: "_L1) || line.startsWith("note: "_L1); });
    return lines;
}

} // namespace

qint64 expectedMemory(const FileTask &task)
{
    return programMemory + memoryPerByte * task.bytes;
}

bool mayBegin(const FileTask &task, const RunLimits &limits, int running, qint64 taken)
{
    return running == 0 || (running < limits.jobs && taken + expectedMemory(task) <= limits.memory);
}

struct FileRunner::Running
{
    FileTask task;
    QProcess process;
    QElapsedTimer clock;
    QString report;
    bool late = false;                //!< ended because it took too long
    bool drawing = false;             //!< the process makes the picture
    std::optional<FileResult> result; //!< when the work is done
    bool ended = false;
};

FileRunner::FileRunner(const ManyChoice &choice, const QString &folder, const QString &pictures,
                       const RunLimits &limits)
    : mChoice(choice), mFolder(folder), mPictures(pictures), mLimits(limits)
{}

FileRunner::~FileRunner()
{
    for (const auto &running : mRunning) {
        running->process.kill();
        running->process.waitForFinished();
    }
}

QStringList FileRunner::argumentsFor(const FileTask &task, const QString &report) const
{
    const CliCommand &command = commandOf(mChoice);
    QStringList arguments = QStringList{command.name} + mChoice.passed;
    if (command.takes(OptionGroup::Output) && !mFolder.isEmpty())
        arguments << u"-o"_s << QDir(mFolder).filePath(task.output);
    if (command.takes(OptionGroup::Reporting))
        arguments << u"--report"_s << report;
    if (command.takes(OptionGroup::Limiting) && !isGiven(mChoice.passed, u"--threads"_s))
        arguments << u"--threads"_s << QString::number(mLimits.threads);
    return arguments << u"--"_s << task.input;
}

QString FileRunner::pictureName(const FileTask &task)
{
    const QByteArray hash = QCryptographicHash::hash(task.output.toUtf8(), QCryptographicHash::Sha1);
    return QString::fromLatin1(hash.toHex()) + u".png"_s;
}

void FileRunner::run(const std::vector<FileTask> &tasks, const std::atomic<bool> &stop,
                     const std::function<bool(const FileResult &)> &finished)
{
    std::size_t next = 0;
    bool goOn = true;
    QEventLoop loop;
    QTimer timer;
    const auto step = [&] {
        for (const auto &running : mRunning)
            look(*running);
        for (auto each = mRunning.begin(); each != mRunning.end();) {
            if (!(*each)->ended) {
                ++each;
                continue;
            }
            const FileResult result = *(*each)->result;
            each = mRunning.erase(each);
            goOn = finished(result) && goOn;
        }
        if (stop || !goOn)
            return loop.quit();
        qint64 taken = 0;
        for (const auto &running : mRunning)
            taken += expectedMemory(running->task);
        while (next < tasks.size() && mayBegin(tasks[next], mLimits, int(mRunning.size()), taken)) {
            taken += expectedMemory(tasks[next]);
            start(tasks[next++]);
        }
        if (mRunning.empty())
            loop.quit();
    };
    QObject::connect(&timer, &QTimer::timeout, &loop, step);
    timer.start(lookEvery);
    loop.exec();
    for (const auto &running : mRunning) {
        running->process.kill();
        running->process.waitForFinished();
    }
    mRunning.clear();
}

void FileRunner::start(const FileTask &task)
{
    auto &running = *mRunning.emplace_back(std::make_unique<Running>());
    running.task = task;
    running.report = mReports.filePath(pictureName(task) + u".json"_s);
    if (!mFolder.isEmpty())
        QDir().mkpath(QFileInfo(QDir(mFolder).filePath(task.output)).path());
    endWithProgram(running.process);
    running.process.setStandardInputFile(QProcess::nullDevice());
    running.clock.start();
    running.process.start(QCoreApplication::applicationFilePath(), argumentsFor(task, running.report));
}

//! Takes notice of what has become of a process.
void FileRunner::look(Running &running)
{
    if (running.process.state() != QProcess::NotRunning) {
        if (mLimits.secondsPerFile > 0 && double(running.clock.elapsed()) > 1000 * mLimits.secondsPerFile) {
            running.late = true;
            running.process.kill();
            running.process.waitForFinished();
        } else {
            return;
        }
    }
    if (running.drawing) { // a missing picture is no reason to call a file bad
        running.ended = true;
        return;
    }
    running.result = resultOf(running);
    QFile::remove(running.report);
    running.late = false;
    running.ended = !running.result->succeeded() || mPictures.isEmpty();
    if (!running.ended)
        startPicture(running);
}

FileResult FileRunner::resultOf(Running &running) const
{
    FileResult result;
    result.task = running.task;
    result.seconds = double(running.clock.elapsed()) / 1000;
    QFile report(running.report);
    if (report.open(QIODevice::ReadOnly)) {
        const QJsonObject content = QJsonDocument::fromJson(report.readAll()).object();
        for (auto each = content.begin(); each != content.end(); ++each) {
            if (each->isDouble() && each.key() != u"seconds")
                result.figures.insert(each.key(), each.value());
        }
    }
    const QByteArray errors = running.process.readAllStandardError();
    result.warnings = linesWith(errors, "autocuts-cli: warning: "_L1) +
                      linesWith(running.process.readAllStandardOutput(), "problem: "_L1);
    const auto failed = [&](const QString &status, const QString &message) {
        const QString place = result.task.input + u": "_s; // is said beside the message
        result.status = status;
        result.message = message.startsWith(place) ? message.mid(place.size()) : message;
    };
    if (running.late)
        failed(u"timed_out"_s, u"took longer than %1 s"_s.arg(mLimits.secondsPerFile));
    else if (running.process.error() == QProcess::FailedToStart)
        failed(u"failed"_s, running.process.errorString());
    else if (running.process.exitStatus() == QProcess::CrashExit)
        failed(u"crashed"_s, u"the program crashed"_s);
    else if (const int code = running.process.exitCode(); code == 0)
        result.status = u"done"_s;
    else if (code == 3)
        result.status = u"bound_missed"_s;
    else if (code == 4)
        failed(u"check_failed"_s, findings(errors).join(u"; "_s));
    else
        failed(u"failed"_s, linesWith(errors, "autocuts-cli: "_L1).value(0, u"exit code %1"_s.arg(code)));
    return result;
}

void FileRunner::startPicture(Running &running)
{
    const bool writesModel = commandOf(mChoice).takes(OptionGroup::Output) && !mFolder.isEmpty() &&
                             !QFileInfo(QDir(mFolder).filePath(running.task.output)).isDir() &&
                             mChoice.command != u"lightbake" && mChoice.command != u"thumbnail";
    running.drawing = true;
    running.clock.start();
    running.process.start(QCoreApplication::applicationFilePath(),
                          {u"thumbnail"_s, u"--show"_s, u"both"_s, u"--size"_s, QString::number(pictureSide),
                           u"-o"_s, QDir(mPictures).filePath(pictureName(running.task)), u"--"_s,
                           writesModel ? QDir(mFolder).filePath(running.task.output) : running.task.input});
}

} // namespace autocuts::manyfiles
