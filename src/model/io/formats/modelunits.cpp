#include "model/io/formats/modelunits.h"

#include "model/io/formats/filesource.h"

namespace autocuts {

ModelUnits unitsOfFormat(const QString &format)
{
    if (format == QLatin1String("fbx"))
        return {0.01, false};
    return {1, format == QLatin1String("ply") || format == QLatin1String("stl")};
}

ModelUnits unitsOf(const Scene &scene)
{
    const FileSource *source = sourceOf(scene);
    const std::optional<double> metres = source ? source->metres() : std::nullopt;
    return metres ? ModelUnits{*metres, false} : unitsOfFormat(scene.format);
}

Eigen::Matrix4d unitChange(const ModelUnits &from, const ModelUnits &to)
{
    Eigen::Matrix4d change = Eigen::Matrix4d::Identity();
    if (from.zUp != to.zUp) {
        const double sign = from.zUp ? 1 : -1;
        change.block<2, 2>(1, 1) << 0, sign, -sign, 0;
    }
    change.topLeftCorner<3, 3>() *= from.metres / to.metres;
    return change;
}

PositionMatrix inUnits(const PositionMatrix &positions, const ModelUnits &from, const ModelUnits &to)
{
    PositionMatrix result = positions;
    if (from.zUp != to.zUp) {
        const double sign = from.zUp ? 1 : -1;
        result.col(1) = sign * positions.col(2);
        result.col(2) = -sign * positions.col(1);
    }
    if (from.metres != to.metres)
        result *= from.metres / to.metres;
    return result;
}

Scene inUnitsOf(Scene scene, const ModelUnits &units)
{
    const ModelUnits own = unitsOf(scene);
    if (own == units)
        return scene;
    scene.mesh = MeshData::build(inUnits(scene.mesh->positions, own, units), scene.mesh->faceStart,
                                 scene.mesh->cornerVertex, scene.mesh->faceObject);
    scene.source.reset();
    return scene;
}

} // namespace autocuts
