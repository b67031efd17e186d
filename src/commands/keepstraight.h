// The command that keeps edges straight in the map, and releases them.
#pragma once

#include "commands/changeelements.h"

namespace autocuts {

//! Sets whether edges are to lie on lines of the map. Diagonals are left out.
class KeepStraight final : public ChangeElements
{
public:
    //! \param on false releases the edges
    //! \param cornerPairs both pairs of each edge, see cornerPairsOfEdges()
    KeepStraight(Document &document, bool on, const IndexRanges &cornerPairs);

    CommandId commandId() const override { return CommandId::KeepStraight; }
    static std::unique_ptr<KeepStraight> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;

private:
    bool mOn;
};

} // namespace autocuts
