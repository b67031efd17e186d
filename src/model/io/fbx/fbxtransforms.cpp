#include "model/io/fbx/fbxtransforms.h"

#include "model/io/fbx/fbxobjects.h"
#include "model/io/fbx/fbxproperties.h"
#include "model/plain/types.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace autocuts {

namespace {

//! A rotation by Euler angles in degrees. \param order as in the property RotationOrder: 0 is x first, z last
Eigen::Matrix3d rotation(const Vec3 &degrees, int order = 0)
{
    // The axes from the first rotation to the last; the spheric order, 6, is read as x, y, z.
    static constexpr std::array<std::array<int, 3>, 6> orders{
        {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}}};
    const auto &axes = orders[order >= 0 && order < 6 ? static_cast<std::size_t>(order) : 0];
    Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
    for (const int axis : axes)
        result = Eigen::AngleAxisd(degrees[axis] * std::numbers::pi / 180, Vec3::Unit(axis)) * result;
    return result;
}

//! The transform of the geometry of a model, which its children do not inherit.
Eigen::Affine3d geometricTransform(const FbxProperties &p)
{
    Eigen::Affine3d result = Eigen::Affine3d::Identity();
    result.translate(p.vector("GeometricTranslation", Vec3::Zero()));
    result.rotate(rotation(p.vector("GeometricRotation", Vec3::Zero())));
    result.scale(p.vector("GeometricScaling", Vec3::Ones()));
    return result;
}

//! The settings of a file; until version 6 they are among the objects. -1: there are none.
int settingsOf(const FbxTree &tree)
{
    const int settings = tree.child(0, "GlobalSettings");
    return settings >= 0 ? settings : tree.child(tree.child(0, "Objects"), "GlobalSettings");
}

} // namespace

FbxPlacing fbxPlacing(const FbxProperties &p)
{
    const Vec3 zero = Vec3::Zero();
    return {p.vector("Lcl Translation", zero), p.vector("Lcl Rotation", zero),
            p.vector("Lcl Scaling", Vec3::Ones())};
}

Eigen::Affine3d fbxLocalTransform(const FbxProperties &p, const FbxPlacing &placing)
{
    const Vec3 zero = Vec3::Zero();
    const Vec3 rotationPivot = p.vector("RotationPivot", zero);
    const Vec3 scalingPivot = p.vector("ScalingPivot", zero);
    Eigen::Affine3d result = Eigen::Affine3d::Identity();
    result.translate(placing.translation + p.vector("RotationOffset", zero) + rotationPivot);
    const bool active = p.integer("RotationActive", 0) != 0;
    const bool around = active && p.integer("RotationSpaceForLimitOnly", 0) == 0;
    result.rotate(rotation(around ? p.vector("PreRotation", zero) : zero));
    result.rotate(rotation(placing.rotation, active ? p.integer("RotationOrder", 0) : 0));
    result.rotate(rotation(around ? p.vector("PostRotation", zero) : zero).transpose());
    result.translate(p.vector("ScalingOffset", zero) + scalingPivot - rotationPivot);
    result.scale(placing.scaling);
    result.translate(-scalingPivot);
    return result;
}

FbxSpace fbxSpace(const FbxTree &tree)
{
    FbxSpace space;
    const int settings = settingsOf(tree);
    if (settings < 0)
        return space;
    const FbxProperties p(tree, settings);
    const std::vector<double> centimetres = p.numbers("UnitScaleFactor");
    if (!centimetres.empty() && centimetres[0] > 1e-9 && centimetres[0] < 1e9)
        space.metres = centimetres[0] / 100;
    Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
    int row = 0;
    for (const char *axis : {"Coord", "Up", "Front"}) {
        const std::string name = std::string(axis) + "Axis";
        const int column = p.integer(name, row);
        if (column >= 0 && column < 3)
            axes(row, column) = p.integer(name + "Sign", 1) < 0 ? -1 : 1;
        ++row;
    }
    if (std::abs(axes.determinant()) == 1) // no axis is named twice
        space.axes = axes;
    return space;
}

std::vector<Eigen::Affine3d> fbxTransforms(const FbxTree &tree, const FbxObjects &objects)
{
    const std::size_t count = objects.models.size();
    std::vector<Eigen::Affine3d> world(count), result(count);
    enum class State : std::uint8_t { New, Open, Done };
    std::vector<State> states(count, State::New);
    std::vector<std::size_t> open;
    const Eigen::Affine3d toScene(fbxSpace(tree).axes);
    for (std::size_t m = 0; m < count; ++m) {
        // From the model up to the first one that is known, and back down. A circle ends at the root.
        std::size_t at = m;
        while (states[at] == State::New) {
            states[at] = State::Open;
            open.push_back(at);
            const int parent = objects.models[at].parent;
            if (parent < 0)
                break;
            at = static_cast<std::size_t>(parent);
        }
        for (; !open.empty(); open.pop_back()) {
            const std::size_t now = open.back();
            const int parent = objects.models[now].parent;
            const bool below = parent >= 0 && states[static_cast<std::size_t>(parent)] == State::Done;
            const FbxProperties p(tree, objects.models[now].node);
            world[now] = fbxLocalTransform(p, fbxPlacing(p));
            if (below)
                world[now] = world[static_cast<std::size_t>(parent)] * world[now];
            result[now] = toScene * world[now] * geometricTransform(p);
            states[now] = State::Done;
        }
    }
    return result;
}

} // namespace autocuts
