// The materials of the polygons of an FBX file.
#pragma once

#include "model/io/fbx/fbxgeometry.h"
#include "model/io/fbx/fbxobjects.h"

#include <map>

namespace autocuts {

//! Of each polygon of a geometry its places in FbxModel::materials and FbxModel::textures, unchecked.
struct FbxFaceSlots
{
    std::vector<int> materials; //!< 0 where the file says nothing
    std::vector<int> textures;  //!< -1 where the file says nothing
};

FbxFaceSlots readFbxFaceSlots(const FbxTree &tree, const FbxGeometry &geometry);

//! Chooses the materials of faces. In version 6 models have the textures, and each face says which of them it
//! shows; in a Scene the materials have them. So the first texture that is seen with a material becomes that
//! of the material, and others get copies of it. A texture that the file connects to a material stays.
class FbxMaterials final
{
public:
    //! \param objects its materials get the textures; must outlive this
    explicit FbxMaterials(FbxObjects &objects);

    //! \return an index of FbxObjects::materialNames, or -1 for none
    int of(const FbxModel &model, int materialSlot, int textureSlot);

private:
    int added(int material, int texture);

    FbxObjects &mObjects;
    std::vector<bool> mSettled; //!< materials that have their texture, or are known to have none
    std::vector<bool> mOwn;     //!< materials with a texture of their own
    std::map<std::pair<int, int>, int> mKnown; //!< by material and texture
};

} // namespace autocuts
