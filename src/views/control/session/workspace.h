// The open document and its session.
#pragma once

#include "commands/journalrecorder.h"
#include "model/document/document.h"

#include <QStringList>

#include <memory>
#include <optional>

namespace autocuts {

struct MeshDrawing;

//! Owns the open document, if any. Other parts of the window use the workspace and never keep a document; the
//! signals of the open document are forwarded here.
class Workspace final : public QObject
{
    Q_OBJECT

public:
    explicit Workspace(QObject *parent = nullptr);
    ~Workspace() override;

    //! The open document; null when nothing is open.
    Document *document() const { return mDocument.get(); }

    //! Replaces the open document without asking.
    //! \param sessionPath the project file of the session; empty when it has none yet
    //! \param journal leads to the beginning of the document's history
    //! \param notes on the model for the user, one line each \param drawing of its mesh; null: it is made
    //! when it is needed
    void open(std::unique_ptr<Document> document, const QString &sessionPath,
              std::optional<Journal> journal = std::nullopt, const QStringList &notes = {},
              std::shared_ptr<const MeshDrawing> drawing = nullptr);
    void close();

    //! Project file of the session; empty when it was never saved.
    const QString &sessionPath() const { return mSessionPath; }
    //! The name for the title bar: the file name of the session, or of the model.
    QString name() const;
    //! False when everything is saved or nothing is open.
    bool isModified() const;
    //! Call it when saving the current state begins. Later edits count as edits of the saved state, but the
    //! session counts as modified until endSave(). \pre document()
    void beginSave();
    //! Call it when a save has ended; saves must end in the order in which they began.
    //! \pre the document is still the same
    //! \param path where the state was saved; empty when that failed
    void endSave(const QString &path);
    //! Marks a recovered session, whose content is saved only in the recovery file.
    void setRecovered(bool recovered);
    const QStringList &notes() const { return mNotes; }
    //! What is drawn of the document's mesh. \pre document()
    const std::shared_ptr<const MeshDrawing> &drawing() const;
    //! \pre document()
    JournalRecorder &recorder() { return *mRecorder; }

    //! True when the open document still has the map of the token's state. If false, a job that started in
    //! that state has been overtaken by an edit.
    bool hasMapOf(const StateToken &token) const;
    //! True when nothing except selection and view was edited since the token's state.
    bool isInState(const StateToken &token) const;

Q_SIGNALS:
    //! Another document is open, or none, or the document has another model: everything may differ.
    void documentReplaced();
    void changed(const autocuts::ChangeEvent &event);
    void selectionChanged();
    //! The index of the undo stack, its saved mark or the path of the session changed.
    void historyChanged();

private:
    void attach();

    std::unique_ptr<Document> mDocument;
    std::unique_ptr<JournalRecorder> mRecorder;
    QString mSessionPath;
    QStringList mNotes;
    mutable std::shared_ptr<const MeshDrawing>
        mDrawing;           //!< null, or of the document's mesh or the one before
    int mSaving = 0;        //!< number of saves under way
    bool mWasSaved = false; //!< before the last save began
    bool mRecovered = false;
};

} // namespace autocuts
