#include "model/transfer/faceplacer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts::transfer {

namespace {

// Chosen by hand, on the models of the tests.
//! Where in a face its samples are, from its centre to its corners.
constexpr double sampleShare = 0.6;
//! UV lengths within a face are at most this times its length on the model times the source's stretch there;
//! anything longer leads around the end of a seam.
constexpr double longestPath = 1.6;
//! Distances that are equal but for rounding, as a share of the frame's size, squared.
constexpr double equalSquared = 1e-18;

double squaredToSegment(const Vec3 &a, const Vec3 &b, const Vec3 &point)
{
    const Vec3 along = b - a;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0;
    return (a + t * along - point).squaredNorm();
}

} // namespace

FacePlacer::FacePlacer(const SourceSurface &source, const MeshData &mesh, const Frame &frame)
    : mSource(source), mMesh(mesh), mPositions(mesh.positions.rows(), 3),
      mSeen(static_cast<std::size_t>(source.triangleCount()), -1)
{
    for (int v = 0; v < mesh.vertexCount(); ++v)
        mPositions.row(v) = frame.toFrame(mesh.positions.row(v));
    findVertexNormals();
}

void FacePlacer::findVertexNormals()
{
    mVertexNormals.assign(static_cast<std::size_t>(mMesh.vertexCount()), Vec3::Zero());
    std::vector<double> area(mVertexNormals.size(), 0);
    for (int f = 0; f < mMesh.faceCount(); ++f) {
        const int first = mMesh.faceStart[f], end = mMesh.faceStart[f + 1];
        Vec3 sum = Vec3::Zero();
        const Vec3 origin = position(first);
        for (int c = first + 1; c + 1 < end; ++c)
            sum += (position(c) - origin).cross(position(c + 1) - origin);
        const double twice = sum.stableNorm();
        mFaceNormals.push_back(twice > 0 ? Vec3(sum / twice) : Vec3(Vec3::Zero()));
        for (int c = first; c < end; ++c) {
            const int v = mMesh.vertexWeld[mMesh.cornerVertex[c]];
            mVertexNormals[v] += sum;
            area[v] += twice;
        }
    }
    for (std::size_t v = 0; v < area.size(); ++v) {
        const double length = mVertexNormals[v].stableNorm();
        if (length > 0.3 * area[v]) // by hand: half a turn around the vertex still has a direction
            mVertexNormals[v] /= length;
        else
            mVertexNormals[v].setZero();
    }
}

//! The nearest point that faces the same way as the face, or the very nearest when there is none near it.
FacePlacer::Spot FacePlacer::spotOf(const Vec3 &point) const
{
    const SurfaceTree &tree = mSource.tree();
    Spot spot{tree.nearest(point)};
    const Vec3 &normal = mFaceNormals[mFace];
    if (spot.near.triangle < 0 || normal.isZero() || tree.normal(spot.near.triangle).dot(normal) > 0.17)
        return spot;
    const double reach = std::sqrt(spot.near.squared) + 2 * mRadius;
    const NearPoint facing = tree.nearestFacing(point, normal, reach * reach);
    if (facing.triangle >= 0)
        spot.near = facing;
    else
        spot.facesAway = tree.normal(spot.near.triangle).dot(normal) < 0;
    return spot;
}

//! Appends the triangles that are connected with the first one near the face. Returns whether the map has a
//! seam or border there.
bool FacePlacer::growPatch(int first, std::size_t begin)
{
    bool meetsSeam = false;
    mPatch.push_back(first);
    mSeen[first] = mMark;
    for (std::size_t i = begin; i < mPatch.size(); ++i) {
        const int t = mPatch[i];
        const Triangle3 &corners = mSource.tree().triangle(t);
        for (int k = 0; k < 3; ++k) {
            if (squaredToSegment(corners[k], corners[(k + 1) % 3], mCentre) > mReach * mReach)
                continue;
            const int next = mSource.neighbour(t, k);
            meetsSeam = meetsSeam || next < 0;
            if (next >= 0 && mSeen[next] != mMark) {
                mSeen[next] = mMark;
                mPatch.push_back(next);
            }
        }
    }
    return meetsSeam;
}

//! The point of a patch that is nearest to the centre of the face.
FacePlacer::Spot FacePlacer::centreIn(std::size_t begin) const
{
    Spot spot;
    for (std::size_t i = begin; i < mPatch.size(); ++i) {
        NearPoint near = nearestOnTriangle(mSource.tree().triangle(mPatch[i]), mCentre);
        near.triangle = mPatch[i];
        if (near.squared < spot.near.squared)
            spot.near = near;
    }
    spot.facesAway = mSource.tree().normal(spot.near.triangle).dot(mFaceNormals[mFace]) < 0;
    return spot;
}

FacePlacing FacePlacer::placing(const Spot &spot, std::size_t begin) const
{
    const int centre = spot.near.triangle;
    const Vec2 centreUv = mSource.uvAt(spot.near);
    FacePlacing result;
    result.seed = centre;
    result.shape = {mSource.areaRatio(centre) * (spot.facesAway ? -1 : 1), mSource.energy(centre)};
    for (int c = mMesh.faceStart[mFace]; c < mMesh.faceStart[mFace + 1]; ++c) {
        const Vec3 point = position(c);
        const Vec3 &normal = mVertexNormals[mMesh.vertexWeld[mMesh.cornerVertex[c]]];
        const Vec2 expected = mSource.continuedUv(centre, point);
        const double length = (point - mCentre).norm() + mCentreDistance;
        int bestRank = 3;
        NearPoint best;
        for (std::size_t i = begin; i < mPatch.size(); ++i) {
            const int t = mPatch[i];
            NearPoint near = nearestOnTriangle(mSource.tree().triangle(t), point);
            if (bestRank == 0 && near.squared > best.squared + equalSquared)
                continue;
            near.triangle = t;
            const Vec2 uv = mSource.uvAt(near);
            const double stretch = std::max(mSource.stretch(centre), mSource.stretch(t));
            const bool around =
                (uv - centreUv).norm() > longestPath * stretch * length + 1e-9 * mSource.uvSize();
            const bool away = !spot.facesAway && mSource.tree().normal(t).dot(normal) < -0.2;
            const int rank = around ? 2 : away ? 1 : 0;
            const bool equal = rank == bestRank && std::abs(near.squared - best.squared) <= equalSquared;
            if (rank < bestRank || (!equal && rank == bestRank && near.squared < best.squared) ||
                (equal &&
                 (uv - expected).norm() < (mSource.uvAt(best) - expected).norm() - 1e-9 * mSource.uvSize())) {
                best = near;
                bestRank = rank;
            }
        }
        result.distance.push_back(std::sqrt(best.squared));
        result.uv.push_back(bestRank < 2 ? mSource.uvAt(best) : expected);
        result.continued.push_back(bestRank < 2 ? mSource.continuedUv(best.triangle, point) : expected);
    }
    return result;
}

std::vector<FacePlacing> FacePlacer::placings(int face, const std::vector<int> &seeds)
{
    const int first = mMesh.faceStart[face], end = mMesh.faceStart[face + 1];
    mFace = face;
    ++mMark;
    mPatch.clear();
    mCentre.setZero();
    for (int c = first; c < end; ++c)
        mCentre += position(c) / (end - first);
    mRadius = 0;
    for (int c = first; c < end; ++c)
        mRadius = std::max(mRadius, (position(c) - mCentre).norm());
    const Spot centre = spotOf(mCentre);
    mCentreDistance = std::sqrt(centre.near.squared);
    std::vector<FacePlacing> result;
    if (centre.near.triangle < 0 || !(mCentreDistance <= matchReach))
        return result;
    mReach = 1.1 * mRadius + 2 * mCentreDistance;
    const bool meetsSeam = growPatch(centre.near.triangle, 0);
    result.push_back(placing(centre, 0));
    std::vector<int> tried = seeds;
    for (int c = first; c < end && meetsSeam; ++c) {
        const Spot spot = spotOf(mCentre + sampleShare * (position(c) - mCentre));
        if (spot.near.squared <= matchReach * matchReach)
            tried.push_back(spot.near.triangle);
    }
    for (int triangle : tried) {
        if (mSeen[triangle] == mMark)
            continue;
        const std::size_t begin = mPatch.size();
        growPatch(triangle, begin);
        result.push_back(placing(centreIn(begin), begin));
    }
    for (int i = 0; i < end - first; ++i) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const FacePlacing &placing : result)
            nearest = std::min(nearest, placing.distance[i]);
        for (FacePlacing &placing : result)
            placing.beyond += placing.distance[i] - nearest;
    }
    return result;
}

} // namespace autocuts::transfer
