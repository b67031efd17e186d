// The command that lets objects share no meshes any more.
#pragma once

#include "commands/changevalue.h"

namespace autocuts {

//! From now on each object that shares a mesh with others in the model's file gets a mesh and a map of its
//! own when that file is written.
class MakeUnique final : public ChangeValue<bool>
{
public:
    explicit MakeUnique(Document &document);

    CommandId commandId() const override { return CommandId::MakeUnique; }
    static std::unique_ptr<MakeUnique> fromCbor(Document &document, CborReader &reader);

protected:
    void set(const bool &unique) override { editor().setUniqueMeshes(unique); }
    void writePayload(QCborMap &) const override {}
    QString label() const override;
};

} // namespace autocuts
