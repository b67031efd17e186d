// The command that chooses the pictures of materials.
#pragma once

#include "commands/documentcommand.h"
#include "model/document/cborvalues.h"
#include "model/document/result.h"

namespace autocuts {

//! Replaces the user's texture sets.
class EditTextures final : public DocumentCommand
{
public:
    //! Where the new pictures come from. Those that are carried over or baked were made for the active map.
    enum class Origin { Chosen, Carried, Baked };

    //! \param sets as DocumentState::textureSets; sets that are not valid change nothing. Contents are left
    //! out
    EditTextures(Document &document, std::vector<TextureSet> sets, Origin origin = Origin::Chosen);

    //! Gives a material other pictures. \param material -1: the faces without one
    static std::unique_ptr<EditTextures> ofMaterial(Document &document, int material, TextureSet set);

    //! True when the pictures that it leaves are for the map that is active now: they were made for it, or
    //! there were none before.
    bool fitsMap() const { return mOrigin != Origin::Chosen || mIsFirst; }

    CommandId commandId() const override { return CommandId::EditTextures; }
    bool hasAnyChanges() const override { return mBefore != mAfter; }
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override { setTextureSets(mAfter); }
    void revert() override { setTextureSets(mBefore); }
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override;
    void clearPayload() override;

private:
    std::vector<TextureSet> mBefore, mAfter;
    Origin mOrigin;
    bool mIsFirst = false; //!< there were no pictures before
};

} // namespace autocuts
