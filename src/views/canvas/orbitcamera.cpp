#include "views/canvas/orbitcamera.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts {

namespace {

constexpr double minDistance = 1e-5, maxDistance = 1e4;
constexpr double radiansPerPixel = 0.008;

} // namespace

ViewSide opposite(ViewSide side)
{
    return static_cast<ViewSide>(static_cast<int>(side) ^ 1);
}

Vec3 directionOf(ViewSide side)
{
    const int number = static_cast<int>(side);
    return (number % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(number / 2);
}

OrbitCamera::OrbitCamera() : mYaw(0.6), mPitch(0.35), mDistance(0.92 / std::sin(0.5 * fieldOfView)) {}

void OrbitCamera::setViewSize(const QSizeF &size)
{
    mSize = QSizeF(std::max(size.width(), 1.0), std::max(size.height(), 1.0));
}

void OrbitCamera::setDirection(double yaw, double pitch)
{
    mYaw = std::remainder(yaw, 2 * std::numbers::pi);
    mPitch = std::clamp(pitch, -0.5 * std::numbers::pi, 0.5 * std::numbers::pi);
}

void OrbitCamera::lookFrom(ViewSide side)
{
    const Vec3 direction = directionOf(side);
    const double yaw = direction.y() == 0 ? std::atan2(direction.x(), direction.z()) : 0;
    setDirection(yaw, std::asin(direction.y()));
}

void OrbitCamera::setDistance(double distance)
{
    mDistance = std::clamp(distance, minDistance, maxDistance);
}

void OrbitCamera::orbit(const QPointF &pixels)
{
    setDirection(mYaw - radiansPerPixel * pixels.x(), mPitch + radiansPerPixel * pixels.y());
}

void OrbitCamera::pan(const QPointF &pixels)
{
    mTarget += unitsPerPixel() * (pixels.y() * up() - pixels.x() * right());
}

void OrbitCamera::zoom(double factor)
{
    setDistance(mDistance / factor);
}

void OrbitCamera::frame(const Vec3 &centre, double radius)
{
    mTarget = centre;
    setDistance(0.92 * radius / std::sin(0.5 * fieldOfView));
}

double OrbitCamera::unitsPerPixel() const
{
    return 2 * mDistance * std::tan(0.5 * fieldOfView) / std::min(mSize.width(), mSize.height());
}

Vec3 OrbitCamera::eye() const
{
    return mTarget - mDistance * forward();
}

Vec3 OrbitCamera::forward() const
{
    return -Vec3(std::sin(mYaw) * std::cos(mPitch), std::sin(mPitch), std::cos(mYaw) * std::cos(mPitch));
}

Vec3 OrbitCamera::right() const
{
    return Vec3(std::cos(mYaw), 0, -std::sin(mYaw));
}

Vec3 OrbitCamera::up() const
{
    return right().cross(forward());
}

Eigen::Matrix4d OrbitCamera::viewMatrix() const
{
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.row(0).head<3>() = right();
    matrix.row(1).head<3>() = up();
    matrix.row(2).head<3>() = -forward();
    matrix.block<3, 1>(0, 3) = -matrix.block<3, 3>(0, 0) * eye();
    return matrix;
}

Eigen::Matrix4d OrbitCamera::projectionMatrix(double sceneRadius) const
{
    const double middle = -forward().dot(eye());
    const double halfHeight = 0.5 * unitsPerPixel() * mSize.height() / mDistance; // at depth 1
    const double halfWidth = 0.5 * unitsPerPixel() * mSize.width() / mDistance;
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    if (mOrthographic) {
        matrix(0, 0) = 1 / (halfWidth * mDistance);
        matrix(1, 1) = 1 / (halfHeight * mDistance);
        matrix(2, 2) = -1 / sceneRadius;
        matrix(2, 3) = -middle / sceneRadius;
        matrix(3, 3) = 1;
        return matrix;
    }
    const double farPlane = std::max(middle + sceneRadius, 1e-4);
    // A 24-bit depth buffer distinguishes 1 part in 1e7, which limits how near the near plane can be.
    const double nearPlane = std::max(middle - sceneRadius, farPlane * 1e-4);
    matrix(0, 0) = 1 / halfWidth;
    matrix(1, 1) = 1 / halfHeight;
    matrix(2, 2) = -(farPlane + nearPlane) / (farPlane - nearPlane);
    matrix(2, 3) = -2 * farPlane * nearPlane / (farPlane - nearPlane);
    matrix(3, 2) = -1;
    return matrix;
}

ViewRay OrbitCamera::ray(const QPointF &pixel) const
{
    const double x = (pixel.x() - 0.5 * mSize.width()) * unitsPerPixel();
    const double y = (0.5 * mSize.height() - pixel.y()) * unitsPerPixel();
    const Vec3 onTargetPlane = mTarget + x * right() + y * up();
    if (mOrthographic)
        return {onTargetPlane - (mTarget.norm() + 4) * forward(), forward()};
    return {eye(), (onTargetPlane - eye()).normalized()};
}

std::optional<ScreenPoint> OrbitCamera::project(const Vec3 &point) const
{
    ScreenPoint result;
    if (!OrbitProjector(*this).project(point, result))
        return {};
    return result;
}

OrbitProjector::OrbitProjector(const OrbitCamera &camera)
    : mEye(camera.eye()), mForward(camera.forward()), mRight(camera.right()), mUp(camera.up()),
      mMiddle(0.5 * camera.viewSize().width(), 0.5 * camera.viewSize().height()),
      mScale((camera.isOrthographic() ? 1 : camera.distance()) / camera.unitsPerPixel()),
      mPerspective(!camera.isOrthographic())
{}

} // namespace autocuts
