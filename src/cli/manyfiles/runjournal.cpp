#include "cli/manyfiles/runjournal.h"

#include "model/io/files/filecalls.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>

namespace autocuts::manyfiles {

namespace {

using namespace Qt::Literals::StringLiterals;

QJsonObject headOf(const ManyChoice &choice)
{
    return {{u"autocuts"_s, QCoreApplication::applicationVersion()},
            {u"command"_s, choice.command},
            {u"format"_s, choice.format},
            {u"options"_s, QJsonArray::fromStringList(choice.passed)}};
}

//! The complete lines of a journal; nothing without a file. A kill may have left half of the last one.
struct Lines
{
    std::optional<QJsonObject> head;
    FileResults results;
    qint64 bytes = 0; //!< of the complete lines

    explicit Lines(const QString &path)
    {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return;
        while (!file.atEnd()) {
            const QByteArray line = file.readLine();
            const QJsonDocument content = QJsonDocument::fromJson(line);
            if (!line.endsWith('\n') || !content.isObject())
                return;
            bytes += line.size();
            if (!head) {
                head = content.object();
                continue;
            }
            const FileResult result = FileResult::fromJson(content.object());
            results[result.task.output] = result;
        }
    }
};

} // namespace

bool FileResult::succeeded() const
{
    return status == u"done" || status == u"bound_missed" || status == u"time_limit";
}

QJsonObject FileResult::toJson() const
{
    return {{u"input"_s, task.input},
            {u"output"_s, task.output},
            {u"bytes"_s, task.bytes},
            {u"modified"_s, task.modified.toString(Qt::ISODateWithMs)},
            {u"status"_s, status},
            {u"message"_s, message},
            {u"warnings"_s, QJsonArray::fromStringList(warnings)},
            {u"seconds"_s, seconds},
            {u"figures"_s, figures}};
}

FileResult FileResult::fromJson(const QJsonObject &line)
{
    FileResult result;
    result.task = {line[u"input"_s].toString(), line[u"output"_s].toString(), line[u"bytes"_s].toInteger(),
                   QDateTime::fromString(line[u"modified"_s].toString(), Qt::ISODateWithMs)};
    result.status = line[u"status"_s].toString();
    result.message = line[u"message"_s].toString();
    for (const QJsonValue &warning : line[u"warnings"_s].toArray())
        result.warnings << warning.toString();
    result.seconds = line[u"seconds"_s].toDouble();
    result.figures = line[u"figures"_s].toObject();
    return result;
}

bool FileResult::isOf(const FileTask &other) const
{
    return task.input == other.input && task.bytes == other.bytes && task.modified == other.modified;
}

RunJournal::RunJournal(const ManyChoice &choice, const QString &folder)
    : mFolder(folder), mPath(QDir(folder).filePath(nameFor(choice) + u".jsonl"_s)),
      mBefore(QDir(folder).filePath(nameFor(choice) + u".before.jsonl"_s)), mFile(mPath)
{}

QString RunJournal::nameFor(const ManyChoice &choice)
{
    const QString all = u"autocuts-batch"_s;
    return choice.parts == 0 ? all : u"%1.%2-of-%3"_s.arg(all).arg(choice.part).arg(choice.parts);
}

Result<std::unique_ptr<QLockFile>> RunJournal::lock(const ManyChoice &choice, const QString &folder)
{
    constexpr int soon = 1000; // milliseconds; batches that begin together look at each other's locks
    const auto lockOf = [&](const QString &name) {
        auto lock = std::make_unique<QLockFile>(QDir(folder).filePath(name));
        lock->setStaleLockTime(0);
        return lock;
    };
    const auto taken = [](const QLockFile &lock) {
        qint64 process = 0;
        QString host, program;
        lock.getLockInfo(&process, &host, &program);
        return Error{u"another batch works in this folder, on %1"_s.arg(host), lock.fileName(), 0,
                     u"Wait for it, or remove this file if that batch has ended"_s};
    };
    auto own = lockOf(u'.' + nameFor(choice) + u".lock"_s);
    if (!own->tryLock(soon))
        return taken(*own);
    const QString sameParts = u"-of-%1.lock"_s.arg(choice.parts);
    for (const QString &name :
         QDir(folder).entryList({u".autocuts-batch*.lock"_s}, QDir::Files | QDir::Hidden)) {
        const bool isOwn = name == QFileInfo(own->fileName()).fileName();
        if (isOwn || name.endsWith(sameParts))
            continue;
        if (const auto other = lockOf(name); !other->tryLock(soon))
            return taken(*other);
    }
    return own;
}

QStringList RunJournal::partPaths() const
{
    QStringList paths;
    for (const QString &name : QDir(mFolder).entryList({u"autocuts-batch.*-of-*.jsonl"_s}, QDir::Files)) {
        if (!name.contains(u".before."_s))
            paths << QDir(mFolder).filePath(name);
    }
    return paths;
}

FileResults RunJournal::ofParts(const ManyChoice &choice) const
{
    FileResults results;
    for (const QString &path : partPaths()) {
        Lines lines(path);
        if (lines.head == headOf(choice))
            results.merge(lines.results);
    }
    return results;
}

Result<Done> RunJournal::begin(const ManyChoice &choice)
{
    if (QFile::exists(mPath)) {
        QFile::remove(mBefore);
        QFile::rename(mPath, mBefore);
    }
    if (choice.parts == 0) {
        for (const QString &path : partPaths())
            QFile::remove(path);
    }
    return writeHead(choice);
}

Result<Done> RunJournal::writeHead(const ManyChoice &choice)
{
    const QByteArray head = QJsonDocument(headOf(choice)).toJson(QJsonDocument::Compact) + '\n';
    if (!mFile.open(QIODevice::WriteOnly) || mFile.write(head) != head.size() || !mFile.flush())
        return Error{u"the journal cannot be written: %1"_s.arg(mFile.errorString()), mPath, 0,
                     u"Check the folder and the space there"_s};
    return Done{};
}

Result<FileResults> RunJournal::resume(const ManyChoice &choice)
{
    const Lines lines(mPath);
    if (!lines.head) {
        if (Result<Done> begun = writeHead(choice); !begun)
            return begun.error();
        return FileResults{};
    }
    if (*lines.head != headOf(choice))
        return Error{
            u"the batch in this folder was made with another command, other options or another version"_s,
            mPath, 0, u"Give the same ones, or begin again without --resume"_s};
    if (!mFile.open(QIODevice::ReadWrite) || !mFile.resize(lines.bytes) || !mFile.seek(lines.bytes))
        return Error{u"the journal cannot be written: %1"_s.arg(mFile.errorString()), mPath, 0,
                     u"Check its permissions"_s};
    return lines.results;
}

Result<Done> RunJournal::add(const FileResult &result)
{
    const QByteArray line = QJsonDocument(result.toJson()).toJson(QJsonDocument::Compact) + '\n';
    if (mFile.write(line) != line.size() || !mFile.flush() || !filecalls::reachesDisk(mFile))
        return Error{u"the journal cannot be written: %1"_s.arg(mFile.errorString()), mPath, 0,
                     u"Make room, then go on with --resume"_s};
    return Done{};
}

FileResults RunJournal::before() const
{
    return Lines(mBefore).results;
}

} // namespace autocuts::manyfiles
