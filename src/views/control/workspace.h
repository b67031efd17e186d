// What the window works on at present.
#pragma once

#include "commands/journalrecorder.h"
#include "model/document/document.h"

#include <QStringList>

#include <memory>
#include <optional>

namespace autocuts {

//! Holds the open document, or none. Everything in the window knows the workspace and never keeps a document:
//! the signals of whichever is open are passed on here.
class Workspace final : public QObject
{
    Q_OBJECT

public:
    explicit Workspace(QObject *parent = nullptr);
    ~Workspace() override;

    //! Null when nothing is open.
    Document *document() const { return mDocument.get(); }

    //! Replaces what is open, without asking.
    //! \param sessionPath the project file that it is saved to, empty when it has none yet
    //! \param journal leads to the document's present state
    //! \param notes what the user should know about the model, one line each
    void open(std::unique_ptr<Document> document, const QString &sessionPath,
              std::optional<Journal> journal = std::nullopt, const QStringList &notes = {});
    void close();

    //! Project file of the session; empty when it was never saved.
    const QString &sessionPath() const { return mSessionPath; }
    //! What the title bar calls it: the file name of the session, else of the model.
    QString name() const;
    //! False when everything is saved, or nothing is open.
    bool isModified() const;
    //! The state as it is now is being saved. It is the saved one from now on: later edits are told from it,
    //! but until endSave() the session counts as modified. \pre document()
    void beginSave();
    //! A save has ended; saves end in the order in which they began. \pre the document is still the same
    //! \param path where the state was saved, empty when that failed
    void endSave(const QString &path);
    //! What a recovered session contains is nowhere saved but in the recovery file.
    void setRecovered(bool recovered);
    const QStringList &notes() const { return mNotes; }
    //! \pre document()
    JournalRecorder &recorder() { return *mRecorder; }

    //! True when the open document still has the map that it had in the state of the token; a job that began
    //! in a state for which this is false was overtaken by an edit.
    bool hasMapOf(const StateToken &token) const;
    //! True when nothing was edited since the state of the token but selection and view.
    bool isInState(const StateToken &token) const;

Q_SIGNALS:
    //! Another document is open, or none: everything may differ.
    void documentReplaced();
    void changed(const autocuts::ChangeEvent &event);
    void selectionChanged();
    //! The index of the undo stack, or whether it is at its saved mark, or the path.
    void historyChanged();

private:
    void attach();

    std::unique_ptr<Document> mDocument;
    std::unique_ptr<JournalRecorder> mRecorder;
    QString mSessionPath;
    QStringList mNotes;
    int mSaving = 0;        //!< saves that have not ended
    bool mWasSaved = false; //!< before the last save began
    bool mRecovered = false;
};

} // namespace autocuts
