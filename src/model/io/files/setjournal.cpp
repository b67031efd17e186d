#include "model/io/files/setjournal.h"

#include "model/io/files/filecalls.h"

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
#include <optional>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

struct SetTexts
{
    Q_DECLARE_TR_FUNCTIONS(FileErrors)
};

constexpr qint64 largestNote = 64'000'000;

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
    QString note;               //!< path of the note of its folder

    bool isReady() const { return QFileInfo::exists(fresh); }
    bool isUntouched() const { return stampText(FileStamp::of(target)) == stamp; }
};

//! The files that a note names. Empty when it is not whole.
std::vector<SetFile> filesOf(QFile &note)
{
    if (note.size() > largestNote)
        return {};
    const QFileInfo info(note);
    const QString ending = u'.' + info.fileName().section(u'-', 1).section(u'.', 0, 0);
    const QDir here(info.canonicalPath());
    std::vector<SetFile> files;
    const QJsonArray entries = QJsonDocument::fromJson(note.readAll()).array();
    for (const auto &entry : entries) {
        const QString name = entry["name"_L1].toString();
        if (name.isEmpty() || name != QFileInfo(name).fileName())
            return {};
        const QDir folder(QDir::cleanPath(here.filePath(entry["folder"_L1].toString())));
        const QString target = folder.filePath(name);
        files.push_back({target, target + ending + u".new"_s, target + ending + u".old"_s,
                         entry["before"_L1].toString(), folder.filePath(info.fileName())});
    }
    return files;
}

//! A set that was found: its notes, which are locked, and what they name.
struct FoundSet
{
    std::vector<std::unique_ptr<QFile>> notes;
    std::vector<SetFile> files;
    //! The notes of all folders are there and say the same. Otherwise only the files beside the first one are
    //! its own.
    bool isWhole = true;
};

//! \returns false when it is not there, or belongs to another program or user
bool openNote(const QString &path, FoundSet &set)
{
    auto note = std::make_unique<QFile>(path);
    if (!note->open(QIODevice::ReadWrite | QIODevice::ExistingOnly) || !filecalls::belongsToUser(*note) ||
        !filecalls::lockUntilClosed(*note))
        return false;
    set.notes.push_back(std::move(note));
    return true;
}

//! Nothing when a program is at work on it.
std::optional<FoundSet> findSet(const QString &path)
{
    FoundSet set;
    if (!openNote(path, set))
        return std::nullopt;
    set.files = filesOf(*set.notes.front());
    QStringList known{QFileInfo(path).canonicalFilePath()};
    const auto namesTheSame = [](const SetFile &a, const SetFile &b) { return a.target == b.target; };
    for (const SetFile &file : set.files) {
        if (known.contains(file.note))
            continue;
        known << file.note;
        if (!QFileInfo::exists(file.note))
            set.isWhole = false;
        else if (!openNote(file.note, set))
            return std::nullopt;
        else
            set.isWhole =
                set.isWhole && std::ranges::equal(filesOf(*set.notes.back()), set.files, namesTheSame);
    }
    if (!set.isWhole)
        std::erase_if(set.files, [&](const SetFile &file) { return file.note != known.front(); });
    return set;
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

//! \returns a line for the user; empty when there is nothing to say. `isDone`: the notes can go
QString endSet(const FoundSet &set, const QString &folder, bool &isDone)
{
    isDone = true;
    const std::vector<SetFile> &files = set.files;
    const auto anything = [](const SetFile &file) { return file.isReady() || QFileInfo::exists(file.old); };
    const auto left = std::ranges::find_if(files, anything);
    if (left == files.end())
        return {};
    if (!set.isWhole) {
        isDone = false;
        return SetTexts::tr(
                   "A program ended while it replaced files of several folders together, and another of "
                   "these folders is gone or was changed. What was to be written is in files that end "
                   "with %1, what was there before in files that end with %2: rename or remove them "
                   "(in %3)")
            .arg(left->fresh.section(u'.', -2), left->old.section(u'.', -2), folder);
    }
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

//! {folder: the entries of its note}
std::map<QString, QJsonArray> notesOf(const QStringList &targets)
{
    std::map<QString, QJsonArray> notes;
    QStringList places;
    for (const QString &target : targets)
        notes[places.emplaceBack(QFileInfo(QFileInfo(target).path()).canonicalFilePath())];
    for (auto &[folder, entries] : notes) {
        for (qsizetype i = 0; i < targets.size(); ++i) {
            QJsonObject entry{{u"name"_s, QFileInfo(targets[i]).fileName()},
                              {u"before"_s, stampText(FileStamp::of(targets[i]))}};
            if (places[i] != folder) // relative, because folders may be moved together
                entry[u"folder"_s] = QDir(folder).relativeFilePath(places[i]);
            entries.append(entry);
        }
    }
    return notes;
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
    const std::map<QString, QJsonArray> folders = notesOf(targets);
    for (const auto &[folder, files] : folders) {
        const QByteArray text = QJsonDocument(files).toJson();
        auto note = std::make_unique<QFile>(QDir(folder).filePath(u".autocuts-%1.set"_s.arg(id)));
        errno = 0;
        if (!note->open(QIODevice::NewOnly | QIODevice::WriteOnly))
            return errno;
        filecalls::lockUntilClosed(*note);
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
            const std::optional<FoundSet> set = findSet(dir.filePath(name));
            if (!set)
                continue;
            bool isDone = true;
            const QString line = endSet(*set, QDir::toNativeSeparators(folder), isDone);
            if (!line.isEmpty())
                lines << line;
            for (std::size_t i = 0; isDone && i < (set->isWhole ? set->notes.size() : 1); ++i)
                set->notes[i]->remove();
        }
    }
    return lines;
}

} // namespace autocuts
