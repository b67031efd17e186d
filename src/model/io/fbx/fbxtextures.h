// The textures of an FBX file.
#pragma once

#include "model/document/scene.h"
#include "model/io/fbx/fbxtree.h"

#include <map>

namespace autocuts {

//! Collects textures and the pictures (videos) behind them, and which material has which.
class FbxTextures final
{
public:
    explicit FbxTextures(const FbxTree &tree) : mTree(tree) {}

    //! Takes an object when it is a texture or a video. \param key what connections call it
    void addObject(std::string_view kind, const QByteArray &key, int node);
    //! Takes a connection from a texture to a property of a material, or from a video to a texture.
    //! \param material -1 when the parent is none \param property empty for connections between objects
    void connect(const QByteArray &child, const QByteArray &parent, int material, std::string_view property);
    //! The pictures of the base colours. \param materials how many there are
    std::vector<SceneTexture> ofMaterials(std::size_t materials);
    //! Those of the other channels.
    std::vector<TextureSet> setsOfMaterials(std::size_t materials);
    //! \param key of a texture
    SceneTexture read(const QByteArray &key);

private:
    QString fileOf(int node) const;
    QByteArray contentOf(int video) const;

    const FbxTree &mTree;
    std::map<QByteArray, int> mTextures, mVideos;          //!< nodes
    std::map<QByteArray, QByteArray> mVideoOfTexture;      //!< keys
    std::map<int, std::pair<int, QByteArray>> mOfMaterial; //!< rank of the property, and the texture
    std::map<int, std::map<TextureChannel, QByteArray>> mSets;
    std::map<int, QByteArray> mContents; //!< of videos: those with one picture share its bytes
};

} // namespace autocuts
