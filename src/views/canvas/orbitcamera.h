// The camera of the 3D view.
#pragma once

#include "model/plain/types.h"

#include <QPointF>
#include <QSizeF>

#include <optional>

namespace autocuts {

//! A ray in the frame of the mesh.
struct ViewRay
{
    Vec3 origin, direction; //!< the direction has length 1
};

//! A point as it is seen. Depth is the distance along the viewing direction.
struct ScreenPoint
{
    double x = 0, y = 0; //!< logical pixels from the upper left of the view
    double depth = 0;
};

//! A turntable: y is up, the camera looks at a target. Works in the frame of the mesh, see MeshFrame. Angles
//! in radians, screen coordinates in logical pixels from the upper left.
class OrbitCamera final
{
public:
    static constexpr double fieldOfView = 0.61; //!< of the shorter side of the view, 35 degrees

    //! Front, from above and to the right: what a model is first seen from.
    OrbitCamera();

    void setViewSize(const QSizeF &size);
    const QSizeF &viewSize() const { return mSize; }

    const Vec3 &target() const { return mTarget; }
    void setTarget(const Vec3 &target) { mTarget = target; }
    double yaw() const { return mYaw; }
    double pitch() const { return mPitch; }
    //! \param pitch clamped to straight down and up
    void setDirection(double yaw, double pitch);
    double distance() const { return mDistance; }
    void setDistance(double distance);
    bool isOrthographic() const { return mOrthographic; }
    void setOrthographic(bool on) { mOrthographic = on; }

    //! Turns as if the model were dragged by that many pixels.
    void orbit(const QPointF &pixels);
    //! Moves so that the target follows the mouse.
    void pan(const QPointF &pixels);
    //! \param factor above 1 comes nearer
    void zoom(double factor);
    //! Keeps the direction and shows a ball.
    void frame(const Vec3 &centre, double radius);

    //! Length in the frame of a pixel at the depth of the target.
    double unitsPerPixel() const;
    Vec3 eye() const;
    //! Unit vector from the eye to the target.
    Vec3 forward() const;
    Vec3 right() const;
    Vec3 up() const;

    //! From the frame to the eye.
    Eigen::Matrix4d viewMatrix() const;
    //! From the eye to the clip space; near and far hold a ball around the frame's origin of this radius.
    Eigen::Matrix4d projectionMatrix(double sceneRadius = 1.05) const;

    //! The ray under a pixel; for an orthographic camera it begins far before everything.
    ViewRay ray(const QPointF &pixel) const;
    //! Nothing when the point is not before the eye.
    std::optional<ScreenPoint> project(const Vec3 &point) const;

private:
    Vec3 mTarget = Vec3::Zero();
    double mYaw, mPitch;
    double mDistance;
    bool mOrthographic = false;
    QSizeF mSize{100, 100};
};

//! Projects many points of one camera.
class OrbitProjector final
{
public:
    explicit OrbitProjector(const OrbitCamera &camera);

    //! \returns false, and leaves the result undefined, when the point is not before the eye
    bool project(const Vec3 &point, ScreenPoint &result) const
    {
        const Vec3 offset = point - mEye;
        result.depth = offset.dot(mForward);
        if (mPerspective && result.depth < nearest)
            return false;
        const double scale = mPerspective ? mScale / result.depth : mScale;
        result.x = mMiddle.x() + offset.dot(mRight) * scale;
        result.y = mMiddle.y() - offset.dot(mUp) * scale;
        return true;
    }

private:
    static constexpr double nearest = 1e-6; //!< depth that is seen

    Vec3 mEye, mForward, mRight, mUp;
    Vec2 mMiddle;
    double mScale; //!< pixels per unit, at depth 1 in perspective
    bool mPerspective;
};

} // namespace autocuts
