// The camera of the 3D view.
#pragma once

#include "model/plain/types.h"

#include <QPointF>
#include <QSizeF>

#include <optional>

namespace autocuts {

//! A ray in the mesh frame.
struct ViewRay
{
    Vec3 origin, direction; //!< direction has length 1
};

//! A point on the screen. Depth is the distance along the viewing direction.
struct ScreenPoint
{
    double x = 0, y = 0; //!< logical pixels from the upper left of the view
    double depth = 0;
};

//! A side of the model from which the camera can look straight: right is at +x, top at +y, front at +z.
enum class ViewSide { Right, Left, Top, Bottom, Front, Back };

ViewSide opposite(ViewSide side);
//! From the model to the eye, length 1.
Vec3 directionOf(ViewSide side);

//! A turntable camera: y points up, and the camera looks at a target. All positions are in the mesh frame,
//! see MeshFrame; angles are in radians, screen coordinates in logical pixels from the upper left.
class OrbitCamera final
{
public:
    static constexpr double fieldOfView = 0.61; //!< of the shorter side of the view, 35 degrees

    //! The initial direction: from the front, above and to the right.
    OrbitCamera();

    void setViewSize(const QSizeF &size);
    const QSizeF &viewSize() const { return mSize; }

    const Vec3 &target() const { return mTarget; }
    void setTarget(const Vec3 &target) { mTarget = target; }
    double yaw() const { return mYaw; }
    double pitch() const { return mPitch; }
    //! \param pitch limited to straight down and straight up
    void setDirection(double yaw, double pitch);
    double distance() const { return mDistance; }
    void setDistance(double distance);
    void lookFrom(ViewSide side);
    bool isOrthographic() const { return mOrthographic; }
    void setOrthographic(bool on) { mOrthographic = on; }

    //! Turns the camera as if the model were dragged by so many pixels.
    void orbit(const QPointF &pixels);
    //! Moves the camera so that the target follows the mouse.
    void pan(const QPointF &pixels);
    //! \param factor above 1 zooms in
    void zoom(double factor);
    //! Shows a sphere without changing the direction.
    void frame(const Vec3 &centre, double radius);

    //! Length in the mesh frame of one pixel at the depth of the target.
    double unitsPerPixel() const;
    Vec3 eye() const;
    //! The unit vector from the eye to the target.
    Vec3 forward() const;
    Vec3 right() const;
    Vec3 up() const;

    //! From the mesh frame to eye space.
    Eigen::Matrix4d viewMatrix() const;
    //! From eye space to clip space. The near and far planes enclose a sphere of this radius around the
    //! origin of the mesh frame.
    Eigen::Matrix4d projectionMatrix(double sceneRadius = 1.05) const;

    //! The ray through a pixel. For an orthographic camera it starts far in front of the scene.
    ViewRay ray(const QPointF &pixel) const;
    //! The screen position of a point; nothing when it is behind the eye.
    std::optional<ScreenPoint> project(const Vec3 &point) const;

private:
    Vec3 mTarget = Vec3::Zero();
    double mYaw, mPitch;
    double mDistance;
    bool mOrthographic = false;
    QSizeF mSize{100, 100};
};

//! Projects many points with one camera.
class OrbitProjector final
{
public:
    explicit OrbitProjector(const OrbitCamera &camera);

    //! \returns false, with the result undefined, when the point is behind the eye
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
    static constexpr double nearest = 1e-6; //!< smallest visible depth

    Vec3 mEye, mForward, mRight, mUp;
    Vec2 mMiddle;
    double mScale; //!< pixels per unit; in perspective, at depth 1
    bool mPerspective;
};

} // namespace autocuts
