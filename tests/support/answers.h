// Answers in place of a user, for tests of everything that asks.
#pragma once

#include "views/ui/questions.h"

#include <QDialog>
#include <QStringList>

#include <functional>

namespace autocuts::test {

//! Answers as a test wants it, and notes what was asked.
class Answers final : public Questions
{
public:
    Unsaved unsaved = Unsaved::Discard;
    QStringList filesToOpen, filesToSave;       //!< taken from the front; none left: cancelled
    QStringList begins;                         //!< the folders or files at which these began
    std::function<int(QDialog &)> onDialog;     //!< not set: every dialog is cancelled
    QStringList errors, confirmations, folders; //!< what was shown, asked and opened
    bool confirms = true;
    int unsavedAsked = 0, changedAsked = 0, hiddenAsked = 0;
    Hidden hidden = Hidden::OnlyShown;
    Changed changed = Changed::Cancel;

    Unsaved askUnsaved(const QString &, bool) override
    {
        ++unsavedAsked;
        return unsaved;
    }
    Changed askChanged(const QString &) override
    {
        ++changedAsked;
        return changed;
    }
    Hidden askHidden(qsizetype) override
    {
        ++hiddenAsked;
        return hidden;
    }
    bool confirm(const QString &question, const QString &, const QString &) override
    {
        confirmations << question;
        return confirms;
    }
    QString fileToOpen(const QString &, const QString &begin, const QStringList &) override
    {
        begins << begin;
        return filesToOpen.isEmpty() ? QString() : filesToOpen.takeFirst();
    }
    QString folderToOpen(const QString &, const QString &begin) override
    {
        begins << begin;
        return filesToOpen.isEmpty() ? QString() : filesToOpen.takeFirst();
    }
    QString fileToSave(const QString &, const QString &begin, const QStringList &) override
    {
        begins << begin;
        return filesToSave.isEmpty() ? QString() : filesToSave.takeFirst();
    }
    int run(QDialog &dialog) override
    {
        return onDialog ? onDialog(dialog) : static_cast<int>(QDialog::Rejected);
    }
    void showError(const Error &error) override { errors << error.toString(); }
    void showFolder(const QString &folder) override { folders << folder; }
};

} // namespace autocuts::test
