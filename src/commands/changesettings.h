// Commands that change the settings of the solver and the packer.
#pragma once

#include "commands/changevalue.h"

namespace autocuts {

struct BothSettings
{
    SolveSettings solve;
    PackingSettings packing;
    bool operator==(const BothSettings &) const = default;
};

//! Changes settings. Commands of one slider drag merge when they change the same properties.
class ChangeSettings final : public ChangeValue<BothSettings>
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
    static std::unique_ptr<ChangeSettings> fromCbor(Document &document, CborReader &reader);

protected:
    void set(const BothSettings &settings) override;
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;

private:
    //! The properties that this command changes; kept when a drag returns to its start.
    int mSolveProperties, mPackingProperties;
};

} // namespace autocuts
