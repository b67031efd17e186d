// The command that paints texel weights.
#pragma once

#include "commands/changeelements.h"

namespace autocuts {

//! Sets the texel weights of faces, limited to [minTexelWeight, maxTexelWeight]. Commands of one brush stroke
//! merge.
class SetTexelWeights final : public ChangeElements
{
public:
    //! \param weights one per face; NaN leaves the weight of the face unchanged
    SetTexelWeights(Document &document, const IndexRanges &faces, std::span<const double> weights);
    //! Gives all these faces one weight. \param faces strictly ascending
    static std::unique_ptr<SetTexelWeights> uniform(Document &document, const IndexRanges &faces,
                                                    double weight);

    CommandId commandId() const override { return CommandId::SetTexelWeights; }
    static std::unique_ptr<SetTexelWeights> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void writePayload(QCborMap &map) const override { mDelta.write(map); }
    QString label() const override;
};

} // namespace autocuts
