// A note beside files that are replaced together: with it, a program that was killed leaves no mixture.
#pragma once

#include <QFile>
#include <QStringList>

#include <memory>
#include <vector>

namespace autocuts {

//! Says in a hidden file of each folder, .autocuts-ID.set, which files are about to be replaced, there and in
//! the other folders of the set. First NAME.ID.new gets the content of each file and NAME.ID.old a hard link
//! to the old one, in this order of the files; then each NAME.ID.new becomes NAME. So whoever finds the note
//! knows what to do: where the last NAME.ID.new is there, all were ready, and the rest of them can be put in
//! place. Files of another folder are touched only where that folder has the same note.
class SetJournal
{
public:
    SetJournal();
    ~SetJournal();
    SetJournal(const SetJournal &) = delete;
    SetJournal &operator=(const SetJournal &) = delete;

    //! Before anything else is written beside the targets. \returns 0, or the number of the error (errno)
    int begin(const QStringList &targets);
    //! Nothing is left to be done.
    void end();

    QString newName(const QString &target) const { return target + mEnding + QLatin1String(".new"); }
    QString oldName(const QString &target) const { return target + mEnding + QLatin1String(".old"); }

private:
    QString mEnding; //!< .ID
    //! They are locked as long as they are open.
    std::vector<std::unique_ptr<QFile>> mNotes;
};

//! Ends what programs that were killed have begun in the folders of files, or in folders: where all files of
//! a set were ready, the rest of them is put in place, otherwise what there is of them is removed. Sets on
//! which a program is at work, and those of other users, stay. Files that were changed since are not
//! replaced. \returns a line for the user on each set
QStringList endBrokenSets(const QStringList &paths);

} // namespace autocuts
