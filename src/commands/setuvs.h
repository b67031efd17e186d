// Every edit of UV values: solving, finishing, packing, moving islands, dragging vertices.
#pragma once

#include "commands/documentcommand.h"
#include "commands/editpins.h"
#include "commands/xordelta.h"
#include "model/document/result.h"

namespace autocuts {

//! What an edit of UVs is called and which edits can merge. Numbers stand in journals: new ones go to the
//! end.
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
    Relax
};

//! What an edit of UVs changes besides them.
struct UvEditExtras
{
    int count = 0;                //!< islands or vertices concerned, for the text in the history
    std::optional<double> scale;  //!< new scale of the UV set (DocumentState::uvScales), when it changes
    std::vector<UvPin> pins = {}; //!< new pins at corners that have one
};

//! Sets UVs of the active UV set, and with them its scale and the pins that travel along. Commands of one
//! drag, or of one solver run, merge; only the difference to the start is kept, once.
class SetUvs final : public DocumentCommand
{
public:
    //! \param uv the new UVs, in texture space \pre one row per corner
    SetUvs(Document &document, UvEdit edit, const UvMatrix &uv, const UvEditExtras &extras = {});

    CommandId commandId() const override { return CommandId::SetUvs; }
    bool hasAnyChanges() const override;
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);

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

    UvEdit mEdit;
    int mUvSet;
    int mCount;
    XorDelta mDelta; //!< over the rows of the UV set
    double mScaleBefore, mScaleAfter;
    PinChanges mPins;
};

} // namespace autocuts
