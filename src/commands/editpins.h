// Commands that add, remove and move pins.
#pragma once

#include "commands/documentcommand.h"
#include "commands/keyedchanges.h"

namespace autocuts {

//! The pins before and after an edit, by corner.
using PinChanges = KeyedChanges<int, UvPin>;

//! Adds, removes or changes pins. Commands of one drag merge.
class EditPins final : public DocumentCommand
{
public:
    enum class Edit { Pin, Unpin, Move, Change };

    //! Sets these pins and replaces those at the same corners. Invalid pins are ignored.
    //! \param edit decides the text in the history; must not be Unpin
    EditPins(Document &document, Edit edit, const std::vector<UvPin> &pins);
    //! Removes the pins at these corners.
    static std::unique_ptr<EditPins> unpin(Document &document, std::span<const int> corners);

    CommandId commandId() const override { return CommandId::EditPins; }
    bool hasAnyChanges() const override { return !mChanges.isEmpty(); }
    static std::unique_ptr<EditPins> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override;
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override { return mChanges.count() * qint64(sizeof(PinChanges::Change)); }
    void clearPayload() override { mChanges.clear(); }

private:
    Edit mEdit;
    PinChanges mChanges;
};

//! The changes that set these pins and replace those at the same corners.
PinChanges changesToPins(const Document &document, const std::vector<UvPin> &pins);
//! The pins after the changes, as an array of maps. \pre no pin is removed
QCborArray pinsToCbor(const PinChanges &changes);
//! Reads an array written by pinsToCbor().
std::vector<UvPin> readPins(CborReader &reader, QLatin1StringView key, const MeshData &mesh);

} // namespace autocuts
