// Commands that change the settings of the solver and the packer.
#pragma once

#include "commands/documentcommand.h"
#include "model/document/cborvalues.h"
#include "model/document/result.h"

namespace autocuts {

//! Changes settings. Commands of one slider drag merge when they change the same properties.
class ChangeSettings final : public DocumentCommand
{
public:
    //! Invalid settings are ignored.
    ChangeSettings(Document &document, const SolveSettings &solve, const PackingSettings &packing);
    ChangeSettings(Document &document, const SolveSettings &solve)
        : ChangeSettings(document, solve, document.packingSettings())
    {}
    ChangeSettings(Document &document, const PackingSettings &packing)
        : ChangeSettings(document, document.solveSettings(), packing)
    {}

    CommandId commandId() const override { return CommandId::ChangeSettings; }
    bool hasAnyChanges() const override;
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override;
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override { return 0; }
    void clearPayload() override {}

private:
    SolveSettings mSolveBefore, mSolveAfter;
    PackingSettings mPackingBefore, mPackingAfter;
    //! The properties that this command changes; kept when a drag returns to its start.
    int mSolveProperties, mPackingProperties;
};

} // namespace autocuts
