// Everything that the actions ask the user, in one place, so that tests can answer.
#pragma once

#include "model/document/result.h"

#include <QCoreApplication>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QWidget>

class QDialog;

namespace autocuts {

//! Asks with dialogs over a window. Tests override what they want to answer.
class Questions
{
    Q_DECLARE_TR_FUNCTIONS(autocuts::Questions)

public:
    enum class Unsaved { Save, Discard, Cancel };

    explicit Questions(QWidget *window = nullptr) : mWindow(window) {}
    virtual ~Questions() = default;

    //! The window that the questions are about; null for none.
    QWidget *window() const { return mWindow; }
    void setWindow(QWidget *window) { mWindow = window; }

    //! \param name of the session
    virtual Unsaved askUnsaved(const QString &name);
    //! \returns true for the button with the text `action`, false for Cancel
    virtual bool confirm(const QString &question, const QString &detail, const QString &action);
    //! \param filters as QFileDialog's; \returns an empty text when the user cancelled
    virtual QString fileToOpen(const QString &title, const QString &folder, const QStringList &filters);
    //! Asks before an existing file is replaced. \param path proposed
    virtual QString fileToSave(const QString &title, const QString &path, const QStringList &filters);
    //! Shows one of the program's own dialogs; \returns what QDialog::exec() does
    virtual int run(QDialog &dialog);
    //! Returns at once; the message stays until the user closes it.
    virtual void showError(const Error &error);
    //! Opens a folder in the desktop's file manager.
    virtual void showFolder(const QString &folder);

private:
    QPointer<QWidget> mWindow;
};

} // namespace autocuts
