// The command that lets objects share no meshes any more.
#pragma once

#include "commands/documentcommand.h"

namespace autocuts {

//! From now on each object that shares a mesh with others in the model's file gets a mesh and a map of its
//! own when that file is written.
class MakeUnique final : public DocumentCommand
{
public:
    explicit MakeUnique(Document &document);

    CommandId commandId() const override { return CommandId::MakeUnique; }
    bool hasAnyChanges() const override { return !mBefore; }

protected:
    void apply() override { setUniqueMeshes(true); }
    void revert() override { setUniqueMeshes(mBefore); }
    void writePayload(QCborMap &) const override {}
    QString label() const override;
    qint64 payloadBytes() const override { return 0; }
    void clearPayload() override {}

private:
    bool mBefore;
};

} // namespace autocuts
