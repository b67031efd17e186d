#include "model/io/files/readerprocess.h"

#include <algorithm>
#ifdef Q_OS_UNIX
#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#else
#include <QProcess>
#endif

namespace autocuts {

namespace {

constexpr int pollInterval = 20; //!< milliseconds

} // namespace

ReaderProcess::~ReaderProcess()
{
    end();
}

bool ReaderProcess::started() const
{
    return mProcess != nullptr;
}

#ifdef Q_OS_UNIX

namespace {

constexpr std::size_t chunkSize = std::size_t(1) << 18;

} // namespace

struct ReaderProcess::Process
{
    pid_t id = -1;
    int output = -1;
};

ReaderProcess::ReaderProcess(std::vector<std::string> command)
{
    std::vector<char *> argv;
    for (std::string &argument : command)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    std::array<int, 2> ends{};
    if (command.front().empty() || pipe2(ends.data(), O_CLOEXEC) != 0)
        return;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    auto process = std::make_unique<Process>();
    process->output = ends[0];
    const bool started =
        posix_spawn(&process->id, argv.front(), &actions, nullptr, argv.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (started)
        mProcess = std::move(process);
    else
        close(ends[0]);
}

bool ReaderProcess::read(std::vector<char> &bytes)
{
    pollfd output{mProcess->output, POLLIN, 0};
    if (poll(&output, 1, pollInterval) <= 0)
        return true; // nothing yet
    const std::size_t size = bytes.size();
    bytes.resize(size + chunkSize);
    const ssize_t got = ::read(mProcess->output, bytes.data() + size, chunkSize);
    bytes.resize(size + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    return got > 0 || (got < 0 && errno == EINTR);
}

ReaderEnd ReaderProcess::end()
{
    if (!mProcess)
        return {};
    // At the end of its output it has ended by itself already, and this changes nothing.
    kill(mProcess->id, SIGKILL);
    int status = 0;
    while (waitpid(mProcess->id, &status, 0) < 0 && errno == EINTR) {
    }
    close(mProcess->output);
    mProcess.reset();
    if (WIFEXITED(status))
        return {WEXITSTATUS(status), false};
    return {std::nullopt, WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU};
}

#else

struct ReaderProcess::Process
{
    QProcess process;
};

ReaderProcess::ReaderProcess(std::vector<std::string> command)
{
    if (command.front().empty())
        return;
    QStringList arguments;
    for (const std::string &argument : command)
        arguments << QString::fromLocal8Bit(argument);
    auto process = std::make_unique<Process>();
    process->process.start(arguments.takeFirst(), arguments, QIODevice::ReadOnly);
    if (process->process.waitForStarted())
        mProcess = std::move(process);
}

bool ReaderProcess::read(std::vector<char> &bytes)
{
    QProcess &process = mProcess->process;
    process.waitForReadyRead(pollInterval);
    const QByteArray got = process.readAllStandardOutput();
    bytes.insert(bytes.end(), got.begin(), got.end());
    return !got.isEmpty() || process.state() != QProcess::NotRunning;
}

ReaderEnd ReaderProcess::end()
{
    if (!mProcess)
        return {};
    QProcess &process = mProcess->process;
    process.kill();
    process.waitForFinished();
    const ReaderEnd end{process.exitStatus() == QProcess::NormalExit ? std::optional(process.exitCode())
                                                                     : std::nullopt,
                        false};
    mProcess.reset();
    return end;
}

#endif

} // namespace autocuts
