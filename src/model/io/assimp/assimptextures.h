// The pictures of materials in Assimp's scenes.
#pragma once

#include "model/document/scene.h"

#include <map>

struct aiMaterial;
struct aiScene;
struct aiTexture;

namespace autocuts {

//! Finds the pictures of base colours. Those inside of the file are shared by the materials that have them.
class AssimpTextures final
{
public:
    explicit AssimpTextures(const aiScene &scene) : mScene(scene) {}

    //! Empty where the file names none.
    SceneTexture ofMaterial(const aiMaterial &material);

private:
    QByteArray contentOf(const aiTexture &texture);

    const aiScene &mScene;
    std::map<const aiTexture *, QByteArray> mContents;
};

} // namespace autocuts
