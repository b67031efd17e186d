// The command for all edits of UVs: solving, finishing, packing, moving islands, dragging vertices.
#pragma once

#include "commands/documentcommand.h"
#include "commands/editpins.h"
#include "commands/xordelta.h"

namespace autocuts {

//! Names an edit of UVs; decides its text in the history and which edits merge. The numbers are stored in
//! journals: add new values at the end.
enum class UvEdit {
    Move,
    Rotate,
    Scale,
    Drag,
    Solve,
    Finish,
    Pack,
    Separate,
    Clear,
    Align,
    Distribute,
    Mirror,
    Orient,
    Scatter,
    Straighten,
    Relax,
    Unwrap,
    Grid,
    BrushRelax,
    BrushPinch,
    BrushGrab,
    AlignToAxes,
    Transfer,
    UnwrapSelection,
    FinishSelection
};

//! Changes that an edit of UVs makes besides the UVs.
struct UvEditExtras
{
    int count = 0;                //!< number of islands or vertices, for the text in the history
    std::optional<double> scale;  //!< new scale of the UV set (DocumentState::uvScales), if it changes
    std::vector<UvPin> pins = {}; //!< new pins at corners that have a pin
    //! New flags of all faces; empty: they stay. An edit that turns islands may take IslandFlags::aligned
    //! away.
    std::vector<IslandFlags> flags = {};
};

//! Sets UVs of the active UV set, and optionally its scale, the pins that move with the UVs and flags.
//! Commands of one drag or one solver run merge; only the difference from the start is stored.
class SetUvs final : public DocumentCommand
{
public:
    //! \param uv the new UVs in texture space, one row per corner
    SetUvs(Document &document, UvEdit edit, const UvMatrix &uv, const UvEditExtras &extras = {});

    CommandId commandId() const override { return CommandId::SetUvs; }
    bool hasAnyChanges() const override;
    //! The scale of the UV set after the command (DocumentState::uvScales).
    double scale() const { return mScaleAfter; }
    static std::unique_ptr<SetUvs> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override;
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override;
    void clearPayload() override;
    void compact() override;

private:
    void toggleUvs();
    void toggleFlags();

    UvEdit mEdit;
    int mUvSet;
    int mCount;
    XorDelta mDelta; //!< over the rows of the UV set
    double mScaleBefore, mScaleAfter;
    PinChanges mPins;
    XorDelta mFlags{sizeof(IslandFlags)}; //!< over IslandMarks::faceFlags
};

} // namespace autocuts
