#include "model/plain/meshpart.h"

#include "model/plain/unionfind.h"

#include <tuple>

namespace autocuts {

namespace {

//! Builds the part piece by piece.
class PartBuilder
{
public:
    PartBuilder(const MeshData &whole, const std::vector<bool> &faces)
        : mWhole(whole), mFaces(faces), mMesh(std::make_shared<MeshData>())
    {}

    MeshPart build()
    {
        addFaces();
        addTriangles();
        addSides();
        UnionFind components(mMesh->triangleCount());
        for (const EdgePair &pair : mMesh->edgePairs)
            components.unite(pair.triangle[0], pair.triangle[1]);
        std::tie(mMesh->component, mMesh->componentCount) = components.labels();
        mPart.mesh = mMesh;
        return std::move(mPart);
    }

private:
    void addFaces()
    {
        mMesh->positions = mWhole.positions;
        mMesh->vertexWeld = mWhole.vertexWeld;
        mNewFace.assign(mWhole.faceCount(), -1);
        mNewCorner.assign(mWhole.cornerCount(), -1);
        for (int f = 0; f < mWhole.faceCount(); ++f) {
            if (!mFaces[f])
                continue;
            mNewFace[f] = static_cast<int>(mPart.face.size());
            mPart.face.push_back(f);
            mMesh->faceObject.push_back(mWhole.faceObject[f]);
            if (!mWhole.texelWeight.empty())
                mMesh->texelWeight.push_back(mWhole.texelWeight[f]);
            for (int c = mWhole.faceStart[f]; c < mWhole.faceStart[f + 1]; ++c) {
                mNewCorner[c] = static_cast<int>(mPart.corner.size());
                mPart.corner.push_back(c);
                mMesh->cornerVertex.push_back(mWhole.cornerVertex[c]);
            }
            mMesh->faceStart.push_back(mMesh->cornerCount());
        }
    }

    void addTriangles()
    {
        mNewTriangle.assign(mWhole.triangleCount(), -1);
        mMesh->faceTriangle.assign(mPart.face.size(), -1);
        for (int t = 0; t < mWhole.triangleCount(); ++t) {
            const int face = mNewFace[mWhole.triangleFace[t]];
            if (face < 0)
                continue;
            mNewTriangle[t] = mMesh->triangleCount();
            if (mMesh->faceTriangle[face] < 0)
                mMesh->faceTriangle[face] = mMesh->triangleCount();
            const auto &corners = mWhole.triangles[t];
            mPart.triangle.push_back(t);
            mMesh->triangles.push_back(
                {mNewCorner[corners[0]], mNewCorner[corners[1]], mNewCorner[corners[2]]});
            mMesh->triangleFace.push_back(face);
            mMesh->triangleArea.push_back(mWhole.triangleArea[t]);
            mMesh->triangleDegenerate.push_back(mWhole.triangleDegenerate[t]);
            mMesh->area += mWhole.triangleArea[t];
        }
    }

    void addSides()
    {
        for (std::size_t e = 0; e < mWhole.edgePairs.size(); ++e) {
            EdgePair pair = mWhole.edgePairs[e];
            const std::array<int, 2> inside{mNewTriangle[pair.triangle[0]], mNewTriangle[pair.triangle[1]]};
            for (int which = 0; which < 2; ++which) {
                if (inside[which] >= 0 && inside[1 - which] < 0)
                    mMesh->boundarySides.push_back({inside[which], pair.side(which), OpenSide::Boundary});
            }
            if (inside[0] < 0 || inside[1] < 0)
                continue;
            for (int which = 0; which < 2; ++which) {
                pair.triangle[which] = inside[which];
                for (int end = 0; end < 2; ++end)
                    pair.corner[end][which] = 3 * inside[which] + pair.corner[end][which] % 3;
            }
            mPart.edgePair.push_back(static_cast<int>(e));
            mMesh->edgePairs.push_back(pair);
        }
        for (BoundarySide side : mWhole.boundarySides) {
            side.triangle = mNewTriangle[side.triangle];
            if (side.triangle >= 0)
                mMesh->boundarySides.push_back(side);
        }
    }

    const MeshData &mWhole;
    const std::vector<bool> &mFaces;
    std::shared_ptr<MeshData> mMesh;
    MeshPart mPart;
    std::vector<int> mNewFace, mNewCorner, mNewTriangle; //!< -1 outside the part
};

} // namespace

MeshPart partOf(const MeshData &mesh, const std::vector<bool> &faces)
{
    return PartBuilder(mesh, faces).build();
}

} // namespace autocuts
