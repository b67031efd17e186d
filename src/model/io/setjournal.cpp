#include "model/io/setjournal.h"

#include "model/io/sessionlock.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QUuid>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <map>
#ifdef Q_OS_UNIX
#include <sys/file.h>
#include <unistd.h>
#endif

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

struct SetTexts
{
    Q_DECLARE_TR_FUNCTIONS(FileErrors)
};

constexpr qint64 largestNote = 64'000'000;

//! Locks a file until it is closed. \returns true when that cannot be done: another program has locked it
bool isLocked([[maybe_unused]] const QFile &note)
{
#ifdef Q_OS_UNIX
    return flock(note.handle(), LOCK_EX | LOCK_NB) != 0;
#else
    return false;
#endif
}

bool isOwn([[maybe_unused]] const QFile &note)
{
#ifdef Q_OS_UNIX
    return QFileInfo(note).ownerId() == geteuid();
#else
    return true;
#endif
}

//! Numbers as text, because JSON has no whole numbers of this size.
QString stampText(const FileStamp &stamp)
{
    return u"%1 %2 %3 %4"_s.arg(stamp.size).arg(stamp.modified).arg(stamp.device).arg(stamp.number);
}

//! One file of a set that was found.
struct SetFile
{
    QString target, fresh, old; //!< paths
    QString stamp;              //!< of the target before

    bool isReady() const { return QFileInfo::exists(fresh); }
    bool isUntouched() const { return stampText(FileStamp::of(target)) == stamp; }
};

//! The files that a note names. Empty when it is not whole, or names others than those beside it.
std::vector<SetFile> filesOf(QFile &note)
{
    if (note.size() > largestNote)
        return {};
    const QFileInfo info(note);
    const QString ending = u'.' + info.fileName().section(u'-', 1).section(u'.', 0, 0);
    std::vector<SetFile> files;
    const QJsonArray entries = QJsonDocument::fromJson(note.readAll()).array();
    for (const auto &entry : entries) {
        const QString name = entry["name"_L1].toString();
        if (name.isEmpty() || name != QFileInfo(name).fileName())
            return {};
        const QString target = info.dir().filePath(name);
        files.push_back({target, target + ending + u".new"_s, target + ending + u".old"_s,
                         entry["before"_L1].toString()});
    }
    return files;
}

QString namesOf(const std::vector<SetFile> &files)
{
    constexpr std::size_t most = 5;
    QStringList names;
    for (std::size_t i = 0; i < std::min(most, files.size()); ++i)
        names << QFileInfo(files[i].target).fileName();
    return files.size() > most ? names.join(u", "_s) + u", ..."_s : names.join(u", "_s);
}

void removeAll(const std::vector<SetFile> &files)
{
    for (const SetFile &file : files) {
        QFile::remove(file.fresh);
        QFile::remove(file.old);
    }
}

//! \returns a line for the user; empty when there is nothing to say. `isDone`: the note can go
QString endSet(const std::vector<SetFile> &files, const QString &folder, bool &isDone)
{
    isDone = true;
    const auto anything = [](const SetFile &file) { return file.isReady() || QFileInfo::exists(file.old); };
    if (std::ranges::none_of(files, anything))
        return {};
    if (!files.back().isReady()) {
        // Either nothing has been replaced yet, or everything.
        const bool isNew = std::ranges::none_of(files, &SetFile::isReady);
        removeAll(files);
        return isNew ? QString()
                     : SetTexts::tr("A program ended before it replaced these files, which are as they were: "
                                    "%1 (in %2)")
                           .arg(namesOf(files), folder);
    }
    const auto wasChanged = [](const SetFile &file) { return file.isReady() && !file.isUntouched(); };
    if (const auto changed = std::ranges::find_if(files, wasChanged); changed != files.end()) {
        isDone = false;
        return SetTexts::tr(
                   "A program ended while it replaced files together, and %1 was changed since. What "
                   "was to be written is in files that end with %2: rename or remove them (in %3)")
            .arg(QFileInfo(changed->target).fileName(), changed->fresh.section(u'.', -2), folder);
    }
    for (const SetFile &file : files) {
        // Not QFile, which does not replace files.
        if (file.isReady() && std::rename(QFile::encodeName(file.fresh).constData(),
                                          QFile::encodeName(file.target).constData()) != 0)
            isDone = false;
    }
    if (!isDone)
        return SetTexts::tr(
                   "A program ended while it replaced files together, and the rest of them cannot be "
                   "replaced: %1 (in %2). Check the permissions of the folder")
            .arg(namesOf(files), folder);
    removeAll(files);
    return SetTexts::tr(
               "A program ended while it replaced files together. All of them are the new ones now: %1 "
               "(in %2)")
        .arg(namesOf(files), folder);
}

} // namespace

SetJournal::SetJournal() = default;

SetJournal::~SetJournal()
{
    end();
}

int SetJournal::begin(const QStringList &targets)
{
    const QString id = QUuid::createUuid().toString(QUuid::Id128).left(8);
    mEnding = u'.' + id;
    std::map<QString, QJsonArray> folders;
    for (const QString &target : targets) {
        const QFileInfo info(target);
        folders[info.path()].append(
            QJsonObject{{u"name"_s, info.fileName()}, {u"before"_s, stampText(FileStamp::of(target))}});
    }
    for (const auto &[folder, files] : folders) {
        const QByteArray text = QJsonDocument(files).toJson();
        auto note = std::make_unique<QFile>(QDir(folder).filePath(u".autocuts-%1.set"_s.arg(id)));
        errno = 0;
        if (!note->open(QIODevice::NewOnly | QIODevice::WriteOnly))
            return errno;
        isLocked(*note);
        mNotes.push_back(std::move(note));
        // Not synced: it is for programs that are killed, whose writes are not lost.
        if (mNotes.back()->write(text) != text.size() || !mNotes.back()->flush())
            return errno;
    }
    return 0;
}

void SetJournal::end()
{
    // QFile::remove() would not remove it when closing it fails.
    for (const std::unique_ptr<QFile> &note : mNotes)
        QFile::remove(note->fileName());
    mNotes.clear();
}

QStringList endBrokenSets(const QStringList &paths)
{
    QStringList folders, lines;
    for (const QString &path : paths) {
        const QFileInfo info(path);
        if (path.isEmpty())
            continue;
        // Links are not replaced: what they lead to is.
        folders << (info.isDir() ? info.absoluteFilePath() : info.absolutePath())
                << QFileInfo(info.canonicalFilePath()).path();
    }
    folders.removeDuplicates();
    folders.removeAll(QString());
    for (const QString &folder : folders) {
        const QDir dir(folder);
        for (const QString &name : dir.entryList({u".autocuts-*.set"_s}, QDir::Files | QDir::Hidden)) {
            QFile note(dir.filePath(name));
            if (!note.open(QIODevice::ReadWrite) || !isOwn(note) || isLocked(note))
                continue;
            const std::vector<SetFile> files = filesOf(note);
            bool isDone = true;
            const QString line =
                files.empty() ? QString() : endSet(files, QDir::toNativeSeparators(folder), isDone);
            if (!line.isEmpty())
                lines << line;
            if (isDone)
                note.remove();
        }
    }
    return lines;
}

} // namespace autocuts
