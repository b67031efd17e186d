// The command that cuts, joins and frees edges.
#pragma once

#include "commands/documentcommand.h"
#include "commands/xordelta.h"
#include "model/document/result.h"

namespace autocuts {

//! Sets the state of corner pairs. Pairs along diagonals are left out, because polygons are cut along whole
//! sides only.
class SetSeamState final : public DocumentCommand
{
public:
    enum class Edit { Clear, Cut, Join };

    //! \param cornerPairs one of the two pairs of an edge makes a half-cut
    SetSeamState(Document &document, Edit edit, const IndexRanges &cornerPairs);

    CommandId commandId() const override { return CommandId::SetSeamState; }
    bool hasAnyChanges() const override { return !mDelta.isEmpty(); }
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override { apply(); }
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override { return mDelta.byteCount(); }
    void clearPayload() override { mDelta = XorDelta(sizeof(PairState)); }
    void compact() override { mDelta.pack(document().undoStack().pool()); }

private:
    Edit mEdit;
    XorDelta mDelta; //!< over Seams::states
};

//! Both corner pairs of each edge. Edge numbers are those of MeshAdjacency; boundary sides and diagonals are
//! left out. \param edges in any order
IndexRanges cornerPairsOfEdges(const MeshData &mesh, std::span<const int> edges);
//! The corner pairs without those along diagonals.
IndexRanges withoutDiagonals(const MeshData &mesh, const IndexRanges &cornerPairs);
//! The number of edges to which the corner pairs belong.
int edgeCountOf(const IndexRanges &cornerPairs);

} // namespace autocuts
