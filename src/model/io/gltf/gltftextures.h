// The textures of a glTF file.
#pragma once

#include "model/document/scene.h"
#include "model/io/gltf/gltfelements.h"

#include <map>

namespace autocuts {

//! Finds the pictures of materials. Materials with the same picture share its bytes.
class GltfTextures final
{
public:
    //! \param data must outlive this
    explicit GltfTextures(GltfData &data) : mData(data) {}

    //! The picture of the base colour: a file beside the model, or bytes from a buffer or a data URI. Empty
    //! where there is none, or where the file contradicts itself.
    SceneTexture ofMaterial(const Json &material);
    //! All else of the metallic-roughness model: roughness, metalness, normals, occlusion, emission.
    TextureSet setOfMaterial(const Json &material);

private:
    SceneTexture pictureOf(const Json &info);
    std::size_t imageNumber(const Json &texture) const;
    SceneTexture readImage(const Json &image);

    GltfData &mData;
    std::map<std::size_t, SceneTexture> mImages; //!< by their numbers
    qsizetype mBytes = 0;                        //!< of all their contents
};

} // namespace autocuts
