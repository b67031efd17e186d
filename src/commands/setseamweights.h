// The command that paints seam weights.
#pragma once

#include "commands/changeelements.h"

namespace autocuts {

//! Sets the painted weights of corner pairs, limited to [0, maxPaintedWeight]. Diagonals are left out.
//! Commands of one brush stroke merge.
class SetSeamWeights final : public ChangeElements
{
public:
    //! \param weights one per corner pair; NaN leaves the weight of the pair unchanged
    SetSeamWeights(Document &document, const IndexRanges &cornerPairs, std::span<const double> weights);

    CommandId commandId() const override { return CommandId::SetSeamWeights; }
    static std::unique_ptr<SetSeamWeights> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
};

} // namespace autocuts
