#include "solver/unwrap/flatpatches.h"

#include "solver/base/cornerat.h"
#include "solver/definite/definitemap.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/search/tutte.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace autocuts::unwrap {

namespace {

//! Least cosine of the angle between the normals of a patch and the direction that it is projected along: 45
//! degrees, at which a triangle has a distortion of 4.5.
constexpr double leastCosine = 0.7071;

//! Grows the patches and projects them.
class PatchMaker
{
public:
    PatchMaker(const Soup &soup, const Snapshot &snapshot)
        : mSoup(soup), mMesh(*soup.mesh), mSnapshot(snapshot), mPatch(mMesh.faceCount(), -1)
    {
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const Vec3 a = cornerOf(t, 0);
            mNormal.push_back((cornerOf(t, 1) - a).cross(cornerOf(t, 2) - a).stableNormalized());
        }
    }

    SeamedMap make()
    {
        std::vector<std::vector<int>> pairsOf(mMesh.faceCount());
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e) {
            if (mMesh.edgePairs[e].diagonal || isCut(e))
                continue;
            for (const int t : mMesh.edgePairs[e].triangle)
                pairsOf[mMesh.triangleFace[t]].push_back(static_cast<int>(e));
        }
        std::vector<int> waiting;
        for (int seed = 0; seed < mMesh.faceCount(); ++seed) {
            if (mPatch[seed] >= 0)
                continue;
            const int patch = static_cast<int>(mDirection.size());
            mDirection.push_back(directionOf(seed));
            mFlat.push_back(faces(seed, mDirection.back()));
            mPatch[seed] = patch;
            waiting.assign(mFlat.back() ? 1 : 0, seed);
            while (!waiting.empty()) {
                const int face = waiting.back();
                waiting.pop_back();
                for (const int e : pairsOf[face]) {
                    for (const int t : mMesh.edgePairs[e].triangle) {
                        const int next = mMesh.triangleFace[t];
                        if (mPatch[next] >= 0 || !faces(next, mDirection[patch]))
                            continue;
                        mPatch[next] = patch;
                        waiting.push_back(next);
                    }
                }
            }
        }
        return project();
    }

    //! Per triangle: its patch; a number of its own where the patch is one convex polygon.
    std::vector<int> projected() const
    {
        std::vector<int> group;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const int patch = mPatch[mMesh.triangleFace[t]];
            group.push_back(mFlat[patch] ? patch : static_cast<int>(mDirection.size()) + t);
        }
        return group;
    }

private:
    Vec3 cornerOf(int t, int k) const { return mMesh.cornerPosition(mMesh.triangles[t][k]); }
    bool isCut(std::size_t edge) const
    {
        const std::vector<PairState> &states = mSnapshot.steering->pairState;
        return !states.empty() &&
               (states[2 * edge] == PairState::Cut || states[2 * edge + 1] == PairState::Cut);
    }

    Vec3 directionOf(int face) const
    {
        Vec3 sum = Vec3::Zero();
        for (const int t : mMesh.trianglesOf(face))
            sum += mSoup.weight[t] * mNormal[t];
        return sum.stableNormalized();
    }

    //! True when the face can be projected along the direction.
    bool faces(int face, const Vec3 &direction) const
    {
        const auto own = mMesh.trianglesOf(face);
        return std::all_of(own.begin(), own.end(), [&](int t) {
            return !mMesh.triangleDegenerate[t] && mNormal[t].dot(direction) >= leastCosine;
        });
    }

    SeamedMap project() const
    {
        SeamedMap map;
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e) {
            const auto [a, b] = mMesh.edgePairs[e].triangle;
            map.cut.push_back(mPatch[mMesh.triangleFace[a]] != mPatch[mMesh.triangleFace[b]] ||
                              (!mMesh.edgePairs[e].diagonal && isCut(e)));
        }
        if (std::find(mFlat.begin(), mFlat.end(), false) != mFlat.end())
            map.x = search::tutteEmbedding(mSoup, CutMesh(mMesh, map.cut));
        else
            map.x.resize(mSoup.coordinateCount());
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const int face = mMesh.triangleFace[t], patch = mPatch[face];
            if (!mFlat[patch]) {
                if (mMesh.trianglesOf(face).size() == 1)
                    std::copy_n(mSoup.restShape[t].begin(), 6, &map.x[6 * static_cast<std::size_t>(t)]);
                continue;
            }
            const Vec3 along = mDirection[patch].unitOrthogonal(), across = mDirection[patch].cross(along);
            for (int k = 0; k < 3; ++k) {
                const Vec3 p = mSoup.scale * cornerOf(t, k);
                cornerAt(map.x, 3 * t + k) = Vec2(along.dot(p), across.dot(p));
            }
        }
        return map;
    }

    const Soup &mSoup;
    const MeshData &mMesh;
    const Snapshot &mSnapshot;
    std::vector<Vec3> mNormal;    //!< per triangle
    std::vector<int> mPatch;      //!< per face
    std::vector<Vec3> mDirection; //!< per patch, that it is projected along
    std::vector<bool> mFlat;      //!< per patch: false for one face that cannot be projected
};

} // namespace

SeamedMap flatPatches(const Soup &soup, const Snapshot &snapshot)
{
    PatchMaker maker(soup, snapshot);
    SeamedMap map = maker.make();
    if (!overlap::visitOverlapsWithin(rowsOf(map.x), maker.projected(), {},
                                      [](int, int, double) { return false; }))
        (void)definite::removeOverlaps(soup, snapshot, map);
    return map;
}

} // namespace autocuts::unwrap
