// The command that cuts, joins and frees edges.
#pragma once

#include "commands/changeelements.h"

namespace autocuts {

//! Sets the state of corner pairs. Pairs along diagonals are left out, because polygons are cut along whole
//! sides only.
class SetSeamState final : public ChangeElements
{
public:
    enum class Edit { Clear, Cut, Join };

    //! \param cornerPairs one of the two pairs of an edge makes a half-cut
    SetSeamState(Document &document, Edit edit, const IndexRanges &cornerPairs);

    CommandId commandId() const override { return CommandId::SetSeamState; }
    static std::unique_ptr<SetSeamState> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;

private:
    Edit mEdit;
};

//! Both corner pairs of each edge. Edge numbers are those of MeshAdjacency; boundary sides and diagonals are
//! left out. \param edges in any order
IndexRanges cornerPairsOfEdges(const MeshData &mesh, std::span<const int> edges);
//! The corner pairs without those along diagonals.
IndexRanges withoutDiagonals(const MeshData &mesh, const IndexRanges &cornerPairs);
//! The number of edges to which the corner pairs belong.
int edgeCountOf(const IndexRanges &cornerPairs);

} // namespace autocuts
