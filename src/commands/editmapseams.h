// The command that rips or tears a map along edges and stitches its seams, without a solve.
#pragma once

#include "commands/commandgroup.h"
#include "commands/setseamstate.h"
#include "commands/setuvs.h"

namespace autocuts {

//! Puts a map that was ripped, torn or stitched into the document together with the seam states that make
//! later solves keep it. Ripped and torn edges are cut; stitched edges that were cut become free. Pins move
//! with their corners. Changes UVs, pins and seam states as one entry. Those of one drag merge.
class EditMapSeams final : public CommandGroup
{
public:
    //! Stored in journals: add new values at the end.
    enum class Edit { Rip, Stitch, Tear };

    //! \param uv the new UVs in texture space, one row per corner
    //! \param edges the edge pairs that were ripped, torn or stitched
    static std::unique_ptr<EditMapSeams> make(Document &document, Edit edit, const UvMatrix &uv,
                                              std::span<const int> edges);

    EditMapSeams(Document &document, Edit edit, int count, std::unique_ptr<SetUvs> uvs,
                 std::unique_ptr<SetSeamState> states);

    CommandId commandId() const override { return CommandId::EditMapSeams; }
    static std::unique_ptr<EditMapSeams> fromCbor(Document &document, CborReader &reader);

protected:
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;

private:
    Edit mEdit;
    int mCount; //!< of edges
};

} // namespace autocuts
