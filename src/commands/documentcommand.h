// The base of all commands: the only way to edit a document.
#pragma once

#include "commands/commandids.h"
#include "model/document/document.h"

#include <QCborMap>

#include <memory>

namespace autocuts {

//! One edit. It is built against the document's present state, takes what it needs from it, and is then given
//! to pushCommand() at once.
//!
//! Merging: commands of one gesture (a drag, a brush stroke, a solver run) get one number of
//! UndoStack::newGesture() and become one entry; without a number a command never merges. A gesture that
//! returns to where it began leaves no entry.
//!
//! Selection: undo and redo bring back the selection with which the command was made.
class DocumentCommand : public UndoEntry
{
public:
    void undo() final;
    void redo() final;
    int id() const final { return static_cast<int>(commandId()); }
    bool mergeWith(const QUndoCommand *newer) final;

    virtual CommandId commandId() const = 0;
    //! False when executing it would leave the document as it is.
    virtual bool hasAnyChanges() const = 0;
    void setGesture(quint64 gesture) { mGesture = gesture; }
    quint64 gesture() const { return mGesture; }

    //! "id" and what makeCommand() needs to build the same edit again on a document in the state before it.
    //! \pre !isReleased()
    QCborMap toCbor() const;

protected:
    explicit DocumentCommand(Document &document);

    Document &document() const { return mDocument; }

    virtual void apply() = 0;
    //! Brings back exactly the state before apply().
    virtual void revert() = 0;
    //! Becomes both edits in one; false when the two are of different kinds. The default is false.
    virtual bool absorb(const DocumentCommand &newer);
    virtual void writePayload(QCborMap &map) const = 0;
    //! Translated text for the history.
    virtual QString label() const = 0;
    //! Bytes of the contents of the derived class.
    virtual qint64 payloadBytes() const = 0;
    virtual void clearPayload() = 0;
    void compact() override {}

    // For commands that consist of others.
    static void applyPart(DocumentCommand &part) { part.apply(); }
    static void revertPart(DocumentCommand &part) { part.revert(); }
    static void compactPart(DocumentCommand &part) { part.compact(); }
    static qint64 bytesOfPart(const DocumentCommand &part) { return part.payloadBytes(); }
    static void clearPart(DocumentCommand &part) { part.clearPayload(); }
    static QString labelOfPart(const DocumentCommand &part) { return part.label(); }
    static QCborMap payloadOfPart(const DocumentCommand &part)
    {
        QCborMap map;
        part.writePayload(map);
        return map;
    }

    // The document's setters; see there.
    void setUvs(int uvSet, const IndexRanges &corners, const UvMatrix &values);
    void setUvScale(int uvSet, double scale);
    void setSeamStates(const IndexRanges &cornerPairs, std::span<const PairState> values);
    void setSeamWeights(const IndexRanges &cornerPairs, std::span<const double> values);
    void setPin(int corner, const std::optional<UvPin> &pin);
    void setRectangle(int id, const std::optional<LayoutRectangle> &rectangle);
    void setFaceFlags(const IndexRanges &faces, std::span<const IslandFlags> values);
    void setTag(const QString &name, const QList<int> &faces);
    void setSolveSettings(const SolveSettings &settings);
    void setPackingSettings(const PackingSettings &settings);
    void insertUvSet(int index, UvSet set, double scale);
    void removeUvSet(int index);
    void renameUvSet(int index, const QString &name);
    void setActiveUvSet(int index);

private:
    friend bool pushCommand(std::unique_ptr<DocumentCommand> command);
    friend bool cancelGesture(Document &document, quint64 gesture);

    qint64 contentBytes() const final;
    void clearContent() final;

    Document &mDocument;
    Selection mSelection;
    qint64 mSelectionBytes = 0; //!< not shared with the entry below
    quint64 mGesture = 0;
    bool mWasApplied = false;
    bool mVanishes = false; //!< leaves the stack when undone
};

//! Executes the command and puts it on its document's undo stack; returns false, and leaves the history as it
//! is, when it would change nothing.
bool pushCommand(std::unique_ptr<DocumentCommand> command);

//! Takes back the newest entry without a trace when it belongs to the gesture: Escape during a drag.
bool cancelGesture(Document &document, quint64 gesture);

//! Translated text for the history with a number in it. \param one, many English source texts with %n
QString countedText(const char *one, const char *many, int count);
//! Translated text for the history.
QString plainText(const char *text);

} // namespace autocuts
