// The command that paints texel weights.
#pragma once

#include "commands/documentcommand.h"
#include "commands/xordelta.h"
#include "model/document/result.h"

namespace autocuts {

//! Sets the texel weights of faces, limited to [minTexelWeight, maxTexelWeight]. Commands of one brush stroke
//! merge.
class SetTexelWeights final : public DocumentCommand
{
public:
    //! \param weights one per face; NaN leaves the weight of the face unchanged
    SetTexelWeights(Document &document, const IndexRanges &faces, std::span<const double> weights);
    //! Gives all these faces one weight. \param faces strictly ascending
    static std::unique_ptr<SetTexelWeights> uniform(Document &document, const IndexRanges &faces,
                                                    double weight);

    CommandId commandId() const override { return CommandId::SetTexelWeights; }
    bool hasAnyChanges() const override { return !mDelta.isEmpty(); }
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override { apply(); }
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override { mDelta.write(map); }
    QString label() const override;
    qint64 payloadBytes() const override { return mDelta.byteCount(); }
    void clearPayload() override { mDelta = XorDelta(sizeof(double)); }
    void compact() override { mDelta.pack(document().undoStack().pool()); }

private:
    XorDelta mDelta; //!< over Document::texelWeights()
};

} // namespace autocuts
