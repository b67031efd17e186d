// Bakes of built models.
#pragma once

#include "model/plain/shadingnormals.h"
#include "solver/bake/bakejob.h"
#include "support/mappedmodels.h"

namespace autocuts::test {

inline ShadedSurface surfaceOf(const MappedModel &model)
{
    ShadedSurface surface;
    surface.mesh = model.mesh;
    surface.uv = model.uv;
    surface.normals = shadingNormals(*model.mesh, {});
    if (model.uv.rows() > 0)
        surface.tangents = mikkTangents(*model.mesh, model.uv, surface.normals);
    return surface;
}

//! A square of side `size` around the origin in the plane z = 0, seen from above; its map is the whole tile.
inline MappedModel plane(double size = 1)
{
    const double h = size / 2;
    return mapped(polygonMesh({{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}}, {{0, 1, 2, 3}}),
                  [=](const Vec3 &p, const Vec3 &) { return Vec2(p.x() / size + 0.5, p.y() / size + 0.5); });
}

inline bake::BakeJob jobFor(const MappedModel &low, std::vector<bake::MapRequest> maps, int size = 16)
{
    bake::BakeJob job;
    job.low = surfaceOf(low);
    job.settings.maps = std::move(maps);
    job.settings.grid.width = job.settings.grid.height = size;
    job.floats = true;
    return job;
}

inline void setDetailed(bake::BakeJob &job, const MeshPtr &mesh, double cage)
{
    job.high = surfaceOf({mesh, {}});
    job.kind = bake::SourceKind::Detailed;
    job.settings.cage.distance = cage;
}

struct Baked
{
    std::vector<Picture> maps;
    bake::BakeFigures figures;
};

inline Baked baked(const bake::BakeJob &job, int threads = 1)
{
    Baked result;
    result.maps.resize(job.settings.maps.size());
    result.figures = bake::runBake(
        job,
        [&](std::size_t map, int, const Picture &picture) {
            result.maps[map] = picture;
            return true;
        },
        JobContext(nullptr, threads));
    return result;
}

inline Picture only(const bake::BakeJob &job)
{
    return baked(job).maps.front();
}

inline Vec3f directionAt(const Picture &picture, int x, int y)
{
    const auto texel = picture.at(x, y);
    return 2 * Vec3f(texel[0], texel[1], texel[2]) - Vec3f::Ones();
}

//! A ball into the map of a coarse one, with two islands and four maps.
inline bake::BakeJob busyJob()
{
    const MappedModel low = mapped(sphere(6, 8), halvesMap);
    MappedModel fitted = low;
    const Eigen::RowVector2d least = low.uv.colwise().minCoeff(), size = low.uv.colwise().maxCoeff() - least;
    fitted.uv = ((low.uv.rowwise() - least).array().rowwise() / (1.05 * size).array()).matrix();
    bake::BakeJob job = jobFor(fitted,
                               {{bake::MapKind::Normal, 0},
                                {bake::MapKind::Occlusion, 0},
                                {bake::MapKind::Curvature, 0},
                                {bake::MapKind::Position, 0}},
                               64);
    setDetailed(job, sphere(40, 60), 0.2);
    job.settings.grid.perSide = 2;
    job.settings.rays.rays = 32;
    return job;
}

} // namespace autocuts::test
