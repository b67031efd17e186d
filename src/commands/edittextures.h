// The command that chooses the pictures of materials.
#pragma once

#include "commands/changevalue.h"

namespace autocuts {

//! Replaces the user's texture sets.
class EditTextures final : public ChangeValue<std::vector<TextureSet>>
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
    static std::unique_ptr<EditTextures> fromCbor(Document &document, CborReader &reader);

protected:
    void set(const std::vector<TextureSet> &sets) override { editor().setTextureSets(sets); }
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override;

private:
    Origin mOrigin;
    bool mIsFirst = false; //!< there were no pictures before
};

} // namespace autocuts
