#include "model/io/assimp/assimpsource.h"

#include <assimp/scene.h>

#include <algorithm>

namespace autocuts {

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
