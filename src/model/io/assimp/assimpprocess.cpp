#include "model/io/assimp/assimpprocess.h"

#include "model/io/assimp/assimpstream.h"
#include "model/io/files/readerprocess.h"
#include "model/io/files/savefile.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QStringList>

#include <assimp/scene.h>

#include <exception>
#include <string>
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
    // What the standard library throws names its functions: "vector::_M_default_append".
    QString why = reason.contains("::"_L1) ? QString() : reason.simplified();
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

//! The reader with its arguments.
std::vector<std::string> commandFor(const QString &path, const ReaderLimits &limits)
{
    return {QFile::encodeName(readerProgram()).toStdString(), QFile::encodeName(path).toStdString(),
            std::to_string(limits.memory), std::to_string(limits.cpuSeconds)};
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
Error failure(const ReaderEnd &end, const std::vector<char> &output, const QString &path,
              const ReaderLimits &limits)
{
    if (end.tookTooLong)
        return tooLong(path, limits.cpuSeconds);
    if (end.code == readerexit::outOfMemory)
        return tooLarge(path, limits.memory);
    if (end.code == readerexit::unreadable) {
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
    ReaderProcess reader(commandFor(path, limits));
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
    const ReaderEnd end = reader.end();
    if (end.code != readerexit::done)
        return failure(end, output, path, limits);
    try {
        return std::shared_ptr<aiScene>(readAssimpScene(output, static_cast<std::size_t>(limits.memory)));
    } catch (const std::runtime_error &e) {
        return unreadable(path, QString::fromUtf8(e.what()));
    }
}

} // namespace autocuts
