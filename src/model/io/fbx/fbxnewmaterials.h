// The materials of a new FBX file, with their pictures.
#pragma once

#include "model/io/fbx/fbxnewobjects.h"
#include "model/io/formats/materiallooks.h"

namespace autocuts {

//! Writes the materials of a scene.
class FbxNewMaterials final
{
public:
    //! \param path of the file
    FbxNewMaterials(FbxNewObjects &objects, const Scene &scene, const QString &path)
        : mObjects(objects), mScene(scene), mLooks(scene, path)
    {}

    //! \returns their numbers
    std::vector<std::int64_t> add();

private:
    void addPictures(int material);
    std::int64_t addPicture(const SceneTexture &picture);

    FbxNewObjects &mObjects;
    const Scene &mScene;
    MaterialLooks mLooks;
    std::vector<std::int64_t> mMaterials;
    std::vector<std::pair<SceneTexture, std::int64_t>> mPictures; //!< videos
};

} // namespace autocuts
