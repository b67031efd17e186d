// Pictures of materials in glTF files.
#pragma once

#include "model/document/scene.h"
#include "model/io/gltf/gltffile.h"

namespace autocuts {

class MaterialLooks;

//! Adds pictures to a file, each once.
class GltfPictures final
{
public:
    //! \param embed also pictures that are files of their own
    GltfPictures(GltfDocument &document, MaterialLooks &looks, bool embed)
        : mDocument(document), mLooks(looks), mEmbed(embed)
    {}

    //! The number of the picture's texture; nothing when glTF cannot hold it. PNG and JPEG stay as they are,
    //! other pictures become PNG.
    std::optional<std::size_t> add(const SceneTexture &picture);

private:
    Json imageOf(const SceneTexture &picture);

    GltfDocument &mDocument;
    MaterialLooks &mLooks;
    bool mEmbed;
    std::vector<std::pair<SceneTexture, std::size_t>> mAdded;
};

//! Sets the textures of a material's channels. \param set the scene's, with the base colour \param texcoord
//! which UV set they are for
void setGltfTextures(Json &material, const TextureSet &set, int texcoord, GltfPictures &pictures);

} // namespace autocuts
