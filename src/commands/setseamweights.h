// Painting where seams are welcome and where not.
#pragma once

#include "commands/documentcommand.h"
#include "commands/xordelta.h"
#include "model/document/result.h"

namespace autocuts {

//! Sets the painted weights of corner pairs; the commands of one brush stroke merge. Diagonals are left out,
//! weights are limited to [0, maxPaintedWeight].
class SetSeamWeights final : public DocumentCommand
{
public:
    //! \param weights one per corner pair; one that is not a number leaves the pair as it is
    SetSeamWeights(Document &document, const IndexRanges &cornerPairs, std::span<const double> weights);

    CommandId commandId() const override { return CommandId::SetSeamWeights; }
    bool hasAnyChanges() const override { return !mDelta.isEmpty(); }
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override { apply(); }
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override { return mDelta.byteCount(); }
    void clearPayload() override { mDelta = XorDelta(sizeof(double)); }
    void compact() override { mDelta.pack(document().undoStack().pool()); }

private:
    XorDelta mDelta; //!< over Seams::weights
};

} // namespace autocuts
