// The base class of all commands. Commands are the only way to edit a document.
#pragma once

#include "commands/commandids.h"
#include "model/document/cborvalues.h"
#include "model/document/documenteditor.h"

#include <QCborMap>
#include <QCoreApplication>

#include <memory>

namespace autocuts {

//! One edit. It is constructed for the current state of the document, copies what it needs from it, and must
//! then be given to pushCommand() at once.
//!
//! Merging: the commands of one gesture (a drag, a brush stroke, a solver run) have the same number from
//! UndoStack::newGesture() and become one entry. A command without a number never merges. A gesture that
//! returns to its start leaves no entry.
//!
//! Selection: undo and redo restore the selection that was current when the command was made.
class DocumentCommand : public UndoEntry
{
public:
    void undo() final;
    void redo() final;
    int id() const final { return static_cast<int>(commandId()); }
    bool mergeWith(const QUndoCommand *newer) final;

    virtual CommandId commandId() const = 0;
    //! False when executing the command would not change the document.
    virtual bool hasAnyChanges() const = 0;
    //! True when journals do not contain it but begin with the state after it.
    virtual bool beginsJournal() const { return false; }
    void setGesture(quint64 gesture) { mGesture = gesture; }
    quint64 gesture() const { return mGesture; }

    //! The command's "id" and the data from which makeCommand() restores it, for a document in the state
    //! before it.
    //! \pre !isReleased()
    QCborMap toCbor() const;

protected:
    explicit DocumentCommand(Document &document);

    Document &document() const { return mDocument; }
    DocumentEditor editor() const { return DocumentEditor(mDocument); }

    virtual void apply() = 0;
    //! Restores exactly the state before apply().
    virtual void revert() = 0;
    //! Merges a newer command into this one. Returns false when their kinds differ; the default.
    virtual bool absorb(const DocumentCommand &newer);
    virtual void writePayload(QCborMap &map) const = 0;
    //! The translated text for the history.
    virtual QString label() const = 0;
    //! Bytes used by the contents of the derived class.
    virtual qint64 payloadBytes() const = 0;
    virtual void clearPayload() = 0;
    void compact() override {}

private:
    friend class CommandGroup;
    friend bool pushCommand(std::unique_ptr<DocumentCommand> command);
    friend bool cancelGesture(Document &document, quint64 gesture);

    qint64 contentBytes() const final;
    void clearContent() final;

    Document &mDocument;
    Selection mSelection;
    qint64 mSelectionBytes = 0; //!< without those shared with the entry below
    quint64 mGesture = 0;
    bool mWasApplied = false;
    bool mVanishes = false; //!< it is removed from the stack when undone
};

//! Executes the command and puts it on its document's undo stack. When it would change nothing, returns false
//! and leaves the history unchanged.
bool pushCommand(std::unique_ptr<DocumentCommand> command);

//! Undoes and removes the newest entry when it belongs to the gesture; for Escape during a drag.
bool cancelGesture(Document &document, quint64 gesture);

//! Translates the texts of the history.
struct UndoText
{
    Q_DECLARE_TR_FUNCTIONS(UndoText)
};

} // namespace autocuts
