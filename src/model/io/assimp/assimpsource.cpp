#include "model/io/assimp/assimpsource.h"

#include <assimp/scene.h>

#include <algorithm>

namespace autocuts {

namespace {

bool hasMorphTargets(const aiScene &scene)
{
    return std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes,
                       [](const aiMesh *mesh) { return mesh->mNumAnimMeshes > 0; });
}

bool hasBones(const aiScene &scene)
{
    return std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes,
                       [](const aiMesh *mesh) { return mesh->mNumBones > 0; });
}

bool isInstanced(const AssimpSource &source)
{
    std::vector<unsigned> meshes;
    for (const AssimpPiece &piece : source.pieces)
        meshes.push_back(piece.mesh);
    std::sort(meshes.begin(), meshes.end());
    return std::adjacent_find(meshes.begin(), meshes.end()) != meshes.end();
}

//! True when at least one node has several meshes.
bool hasSplitNodes(const AssimpSource &source)
{
    const auto sameNode = [](const AssimpPiece &a, const AssimpPiece &b) { return a.node == b.node; };
    return std::ranges::adjacent_find(source.pieces, sameNode) != source.pieces.end();
}

} // namespace

bool AssimpSource::isOf(const MeshData &mesh) const
{
    return !pieces.empty() && pieces.back().firstFace + pieces.back().faceCount == mesh.faceCount();
}

SourceContents contentsOf(const AssimpSource &source)
{
    const aiScene &from = *source.scene;
    SourceContents contents;
    contents.bones = hasBones(from);
    contents.shapeKeys = hasMorphTargets(from);
    for (unsigned a = 0; a < from.mNumAnimations; ++a) {
        const aiAnimation &animation = *from.mAnimations[a];
        contents.animations = true;
        contents.severalAnimations = a > 0;
        contents.otherAnimations |= animation.mNumMeshChannels + animation.mNumMorphMeshChannels > 0;
    }
    contents.lightsOrCameras = from.mNumLights > 0 || from.mNumCameras > 0;
    contents.embeddedTextures = from.mNumTextures > 0;
    contents.hierarchy = from.mRootNode->mNumChildren > 0;
    contents.instances = isInstanced(source);
    contents.splitObjects = hasSplitNodes(source);
    return contents;
}

int pieceCorner(const MeshData &mesh, const AssimpPiece &piece, int n)
{
    const int corner = mesh.faceStart[piece.firstFace] + n;
    if (!piece.mirrored)
        return corner;
    const auto end = std::upper_bound(mesh.faceStart.begin(), mesh.faceStart.end(), corner);
    return end[-1] + end[0] - 1 - corner;
}

std::vector<Vec3> pieceCorners(const AssimpSource &source, const AssimpPiece &piece)
{
    const aiMesh &mesh = *source.scene->mMeshes[piece.mesh];
    std::vector<Vec3> corners;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace &face = mesh.mFaces[f];
        for (unsigned k = 0; k < face.mNumIndices && face.mNumIndices >= 3; ++k) {
            const aiVector3D &p = mesh.mVertices[face.mIndices[k]];
            corners.emplace_back(p.x, p.y, p.z);
        }
    }
    return corners;
}

std::string pieceName(const AssimpSource &source, const AssimpPiece &piece)
{
    return source.scene->mMeshes[piece.mesh]->mName.C_Str();
}

} // namespace autocuts
