// Follows light backwards from points of a surface.
#pragma once

#include "model/plain/litsurface.h"
#include "solver/bake/lighting.h"
#include "solver/bake/scrambledpoints.h"

namespace autocuts::bake {

using autocuts::LitSurface;

//! Light that arrives at a point, divided by pi: what a white surface there reflects.
struct ArrivingLight
{
    Vec3f direct = Vec3f::Zero();   //!< from the lights
    Vec3f indirect = Vec3f::Zero(); //!< reflected at least once
};

//! Traces paths. Immutable after construction.
class PathTracer final
{
public:
    //! \param surface must outlive this \param bounces how often light is reflected at most, before it
    //! arrives at the surface \param job see RayScene
    PathTracer(const LitSurface &surface, const Lighting &lighting, int bounces, const JobContext &job = {});

    //! One path from a point: an estimate of the arriving light. \param sample number of the path
    ArrivingLight trace(const SurfacePoint &at, const ScrambledPoints &points, std::uint32_t sample) const;

    const Frame &frame() const { return mFrame; }
    //! The unit normal at a point: that for shading, or else the face's; zero where there is none.
    Vec3f normalAt(const SurfacePoint &at) const;
    Vec3f positionAt(const SurfacePoint &at) const; //!< in the frame

private:
    //! A place on the surface from which rays go out.
    struct Place
    {
        Vec3f origin;  //!< a little above the surface
        Vec3f normal;  //!< unit, for shading
        Vec3f outside; //!< unit, the face's
    };

    //! A triangle or a parallelogram that emits light.
    struct Emitter
    {
        Vec3f corner, first, second; //!< sides from the corner
        Vec3f radiance;
        Vec3f normal; //!< unit
        float area = 0;
        bool isTriangle = false;
        float chance = 0; //!< of being chosen
    };

    //! The random points of one path at one place.
    struct Draw
    {
        const ScrambledPoints &points;
        std::uint32_t sample, bounce;

        enum Use { Direction, OnEmitter, Choice, OnSun };
        Eigen::Vector2f operator()(Use use, std::uint32_t number = 0) const
        {
            return points.at(sample, 4096 * number + 4 * bounce + static_cast<std::uint32_t>(use));
        }
    };

    void addEmitters(const Lighting &lighting);
    Place placeAt(const SurfacePoint &at, const Vec3f *from) const;
    Vec3f fromSuns(const Place &place, const Draw &draw) const;
    Vec3f fromEmitter(const Place &place, const Draw &draw) const;
    Vec3f along(const Place &place, const Vec3f &direction, const RayHit &hit) const;
    Vec3f seen(const Emitter &emitter, const Place &place, const Vec3f &direction, float distance) const;
    static float sharePerAngle(const Emitter &emitter, const Vec3f &direction, float distance);

    const LitSurface &mSurface;
    std::vector<Sun> mSuns;
    std::optional<Sky> mSky;
    int mBounces;
    Frame mFrame;
    RayScene mRays;
    std::vector<Emitter> mEmitters; //!< area lights, then triangles
    int mAreaLights = 0;
    std::vector<float> mChances;         //!< of the emitters up to each one
    std::vector<int> mEmitterOfTriangle; //!< -1 for none; empty: no face shines
};

} // namespace autocuts::bake
