// The command that keeps edges straight in the map, and releases them.
#pragma once

#include "commands/documentcommand.h"
#include "commands/xordelta.h"
#include "model/document/result.h"

namespace autocuts {

//! Sets whether edges are to lie on lines of the map. Diagonals are left out.
class KeepStraight final : public DocumentCommand
{
public:
    //! \param on false releases the edges
    //! \param cornerPairs both pairs of each edge, see cornerPairsOfEdges()
    KeepStraight(Document &document, bool on, const IndexRanges &cornerPairs);

    CommandId commandId() const override { return CommandId::KeepStraight; }
    bool hasAnyChanges() const override { return !mDelta.isEmpty(); }
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override { apply(); }
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override { return mDelta.byteCount(); }
    void clearPayload() override { mDelta = XorDelta(sizeof(std::uint8_t)); }
    void compact() override { mDelta.pack(document().undoStack().pool()); }

private:
    bool mOn;
    XorDelta mDelta; //!< over Seams::straight
};

} // namespace autocuts
