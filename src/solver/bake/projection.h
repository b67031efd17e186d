// Finds the point of the detailed model that belongs to a point of the simple one.
#pragma once

#include "solver/bake/rayscene.h"

#include <span>
#include <vector>

namespace autocuts::bake {

//! In which direction rays leave the simple model. They begin outside of it, at the cage, and run inwards.
enum class CageDirection {
    Smoothed, //!< along normals that are smoothed over all edges: no gaps at hard edges
    Shading,  //!< along the shading normals: gaps at hard edges, details are not skewed
    Corrected //!< smoothed beside bent edges, along the face's normal elsewhere
};

//! How a detailed model is looked for. Distances are shares of the simple model's size (Frame::size).
struct CageSettings
{
    double distance = 0.02; //!< of the cage from the surface; rays end as far behind the surface
    CageDirection direction = CageDirection::Smoothed;
    //! Positions of the cage's vertices, one row for each of the simple model's; no rows: by distance.
    PositionMatrix positions;
};

//! A point of the detailed model.
struct Source
{
    const ShadedSurface *surface = nullptr; //!< null: there is none
    const RayScene *rays = nullptr;         //!< of the model around it, for further rays; null without them
    SurfacePoint point;
    float height = 0; //!< above the simple model, in the frame
};

//! Looks for points of a detailed model, or gives those of the simple model itself. Immutable.
class Projection final
{
public:
    //! The same triangles, with other UVs and textures or with the same ones. \param job see RayScene
    //! \param withRays the maps look around, see Source::rays
    Projection(const ShadedSurface &low, const ShadedSurface &same, const Frame &frame,
               const JobContext &job = {}, bool withRays = true);
    //! Faces of the simple model see faces of the detailed one that have the same group. Groups are numbered
    //! from 0.
    Projection(const ShadedSurface &low, const ShadedSurface &high, const Frame &frame,
               const CageSettings &cage, const JobContext &job = {});

    //! The model that is baked from.
    const ShadedSurface &source() const { return mHigh; }
    Source find(const SurfacePoint &low) const;

private:
    void prepareRays(const ShadedSurface &surface, const JobContext &job);
    void prepareDirections(const CageSettings &cage);
    Vec3f direction(const SurfacePoint &low) const;

    const ShadedSurface &mLow, &mHigh;
    Frame mFrame;
    bool mSame = true;
    std::vector<RayScene> mRays; //!< per group
    float mDistance = 0;
    CageDirection mDirection = CageDirection::Smoothed;
    std::vector<Vec3f> mSmoothed; //!< per welded vertex
    std::vector<Vec3f> mCage;     //!< per vertex, in the frame; empty: by distance
    //! Per triangle: bent edges of its flat surroundings that are near enough to turn its rays.
    std::vector<std::vector<std::array<Vec3f, 2>>> mBends;
};

} // namespace autocuts::bake
