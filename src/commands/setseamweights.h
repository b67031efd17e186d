// The command that paints seam weights.
#pragma once

#include "commands/documentcommand.h"
#include "commands/xordelta.h"
#include "model/document/result.h"

namespace autocuts {

//! Sets the painted weights of corner pairs, limited to [0, maxPaintedWeight]. Diagonals are left out.
//! Commands of one brush stroke merge.
class SetSeamWeights final : public DocumentCommand
{
public:
    //! \param weights one per corner pair; NaN leaves the weight of the pair unchanged
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
