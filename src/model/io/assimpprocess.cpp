#include "model/io/assimpprocess.h"

#include "model/io/assimpstream.h"
#include "model/io/savefile.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QStringList>

#include <assimp/scene.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <fcntl.h>
#include <optional>
#include <poll.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

// Limits for files of any size, and what each byte adds. Chosen by hand from all files that are at hand.
constexpr qint64 memoryBase = qint64(512) << 20;
constexpr qint64 memoryPerByte = 128;
constexpr qint64 secondsBase = 10;
constexpr qint64 bytesPerSecond = 20'000;
constexpr qint64 wallFactor = 6;

constexpr int pollInterval = 20; //!< milliseconds
constexpr std::size_t chunkSize = std::size_t(1) << 18;

Error unreadable(const QString &path, const QString &reason)
{
    if (path.endsWith(".blend"_L1, Qt::CaseInsensitive)) {
        const QString why =
            reason.contains("resolving pointer"_L1)
                ? u"it refers to data that was not saved with it, which Blender alone can read"_s
                : reason.simplified();
        return {u"the file cannot be read: %1"_s.arg(why), path, 0,
                u"Open it in Blender and export it as glb or OBJ"_s};
    }
    QString why = reason.simplified();
    while (why.endsWith(u'.'))
        why.chop(1);
    return {u"the file cannot be read: %1"_s.arg(why.isEmpty() ? u"its contents are damaged"_s : why), path,
            0, u"It may be damaged or of a newer version: export the model again, or as OBJ"_s};
}

Error noReader(const QString &path)
{
    return {u"the program autocuts-reader, which reads files of this format, cannot be started"_s, path, 0,
            u"Install Autocuts again, or export the model as OBJ"_s};
}

//! Where the reader is: beside the program, or where distributions put helpers, or in the build tree of a
//! test.
QString readerProgram()
{
    const QString given = qEnvironmentVariable("AUTOCUTS_READER");
    if (!given.isEmpty())
        return given;
    const QString folder = QCoreApplication::applicationDirPath();
    for (const QString &place : {u"/"_s, u"/../libexec/autocuts/"_s, u"/../src/"_s}) {
        if (const QString program = folder + place + u"autocuts-reader"_s; QFileInfo(program).isExecutable())
            return program;
    }
    return {};
}

//! A running reader. It is ended and waited for at the latest by the destructor.
class Reader
{
public:
    Reader(const QString &path, const ReaderLimits &limits);
    ~Reader() { end(); }
    Reader(const Reader &) = delete;
    Reader &operator=(const Reader &) = delete;

    bool started() const { return mOutput >= 0; }
    //! Appends what the reader has written to the bytes, after a short while at most. False at the end.
    bool read(std::vector<char> &bytes);
    //! Kills the reader unless it has ended, and returns the status of waitpid().
    int end();

private:
    pid_t mProcess = -1;
    int mOutput = -1;
    int mStatus = 0;
};

Reader::Reader(const QString &path, const ReaderLimits &limits)
{
    const std::string program = QFile::encodeName(readerProgram()).toStdString();
    std::array<std::string, 4> arguments{program, QFile::encodeName(path).toStdString(),
                                         std::to_string(limits.memory), std::to_string(limits.cpuSeconds)};
    std::array<char *, 5> argv{};
    for (std::size_t i = 0; i < arguments.size(); ++i)
        argv[i] = arguments[i].data();
    std::array<int, 2> ends{};
    if (program.empty() || pipe2(ends.data(), O_CLOEXEC) != 0)
        return;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    const bool started =
        posix_spawn(&mProcess, program.c_str(), &actions, nullptr, argv.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (started)
        mOutput = ends[0];
    else
        close(ends[0]);
}

bool Reader::read(std::vector<char> &bytes)
{
    pollfd output{mOutput, POLLIN, 0};
    if (poll(&output, 1, pollInterval) <= 0)
        return true; // nothing yet
    const std::size_t size = bytes.size();
    bytes.resize(size + chunkSize);
    const ssize_t got = ::read(mOutput, bytes.data() + size, chunkSize);
    bytes.resize(size + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    return got > 0 || (got < 0 && errno == EINTR);
}

int Reader::end()
{
    if (!started())
        return mStatus;
    // At the end of its output it has ended by itself already, and this changes nothing.
    kill(mProcess, SIGKILL);
    while (waitpid(mProcess, &mStatus, 0) < 0 && errno == EINTR) {
    }
    close(mOutput);
    mOutput = -1;
    return mStatus;
}

Error tooLong(const QString &path, qint64 seconds)
{
    return {u"reading the file takes longer than %1 s, too long for its size"_s.arg(seconds), path, 0,
            u"It is probably damaged: export the model again, or as OBJ"_s};
}

Error tooLarge(const QString &path, qint64 memory)
{
    return {u"reading the file takes more than %1 MB of memory, too much for its size"_s.arg(memory >> 20),
            path, 0, u"It is probably damaged: export the model again, or as OBJ"_s};
}

//! Why the reader ended without a scene.
Error failure(int status, const std::vector<char> &output, const QString &path, const ReaderLimits &limits)
{
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return tooLong(path, limits.cpuSeconds);
    if (WIFEXITED(status) && WEXITSTATUS(status) == readerexit::outOfMemory)
        return tooLarge(path, limits.memory);
    if (WIFEXITED(status) && WEXITSTATUS(status) == readerexit::unreadable) {
        const QByteArrayView text(output.data(), static_cast<qsizetype>(output.size()));
        return unreadable(path, QString::fromUtf8(text.sliced(text.lastIndexOf('\0') + 1)));
    }
    return unreadable(path, u"its contents are damaged"_s);
}

} // namespace

ReaderLimits readerLimits(qint64 size)
{
    const qint64 seconds = secondsBase + size / bytesPerSecond;
    return {memoryBase + memoryPerByte * size, seconds, wallFactor * seconds};
}

Result<std::shared_ptr<aiScene>> readInProcess(const QString &path, const ReaderLimits &limits,
                                               const std::atomic<bool> *stop)
{
    Reader reader(path, limits);
    if (!reader.started())
        return noReader(path);
    QElapsedTimer clock;
    clock.start();
    std::vector<char> output;
    while (reader.read(output)) {
        if (stop && *stop)
            return readingCancelled(path);
        if (clock.elapsed() > limits.wallSeconds * 1000)
            return tooLong(path, limits.wallSeconds);
        if (std::ssize(output) > limits.memory)
            return tooLarge(path, limits.memory);
    }
    const int status = reader.end();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != readerexit::done)
        return failure(status, output, path, limits);
    try {
        return std::shared_ptr<aiScene>(readAssimpScene(output, static_cast<std::size_t>(limits.memory)));
    } catch (const std::runtime_error &e) {
        return unreadable(path, QString::fromUtf8(e.what()));
    }
}

} // namespace autocuts
