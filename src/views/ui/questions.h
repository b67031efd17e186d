// All questions that the program asks the user; tests replace them by answers.
#pragma once

#include "model/document/result.h"

#include <QCoreApplication>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QWidget>

class QDialog;

namespace autocuts {

//! Asks by dialogs over a window. Tests override the functions.
class Questions
{
    Q_DECLARE_TR_FUNCTIONS(autocuts::Questions)

public:
    enum class Unsaved { Save, Discard, Cancel };
    enum class Hidden { OnlyShown, All, Cancel };
    enum class Changed { Overwrite, SaveAs, Reload, Cancel };

    explicit Questions(QWidget *window = nullptr) : mWindow(window) {}
    virtual ~Questions() = default;

    //! The parent window of the dialogs; null for none.
    QWidget *window() const { return mWindow; }
    void setWindow(QWidget *window) { mWindow = window; }

    //! \param name name of the session
    //! \param fileIsGone another program has removed the session's file
    virtual Unsaved askUnsaved(const QString &name, bool fileIsGone);
    //! Asks what to do when another program has changed the file of the session. \param name of the file
    virtual Changed askChanged(const QString &name);
    //! Asks what a job is to change that would change all faces. \param hidden how many faces are hidden
    virtual Hidden askHidden(qsizetype hidden);
    //! \returns true for the button with the text `action`, false for Cancel
    virtual bool confirm(const QString &question, const QString &detail, const QString &action);
    //! Asks before pictures are replaced. \param files paths \returns true as well where there are none
    bool confirmReplacing(const QStringList &files);
    //! \param filters as for QFileDialog
    //! \returns an empty string when the user cancelled
    virtual QString fileToOpen(const QString &title, const QString &folder, const QStringList &filters);
    //! \returns an empty string when the user cancelled
    virtual QString folderToOpen(const QString &title, const QString &folder);
    //! Asks before an existing file is replaced. \param path the proposed path
    virtual QString fileToSave(const QString &title, const QString &path, const QStringList &filters);
    //! Shows one of the program's own dialogs. \returns the result of QDialog::exec()
    virtual int run(QDialog &dialog);
    //! Shows an error; returns at once, and the message stays until the user closes it.
    virtual void showError(const Error &error);
    //! Opens a folder in the file manager of the desktop.
    virtual void showFolder(const QString &folder);

private:
    QPointer<QWidget> mWindow;
};

} // namespace autocuts
