// Unwraps, packs and bakes with the engine and nothing else. Prints the libraries that it has loaded.
#include "model/plain/snapshot.h"
#include "model/plain/uvlayout.h"
#include "solver/bake/bakejob.h"
#include "solver/unwrap/unwrap.h"

#include <fstream>
#include <iostream>
#include <set>
#include <string>

using namespace autocuts;

namespace {

std::shared_ptr<const MeshData> cube()
{
    PositionMatrix positions(8, 3);
    for (int v = 0; v < 8; ++v)
        positions.row(v) << (v & 1), (v >> 1 & 1), (v >> 2 & 1);
    return MeshData::build(positions, {0, 4, 8, 12, 16, 20, 24},
                           {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5},
                           {0, 0, 0, 0, 0, 0});
}

} // namespace

int main()
{
    Snapshot snapshot;
    snapshot.mesh = cube();
    const unwrap::UnwrapResult made = unwrap::unwrapMesh(snapshot, {});
    std::cout << "corners " << made.uv.rows() << '\n';
    bake::BakeJob job;
    job.low.mesh = snapshot.mesh;
    job.low.uv = made.uv;
    job.low.normals.assign(24, Vec3f::UnitZ());
    job.settings.maps = {{bake::MapKind::Occlusion, 0}};
    job.settings.grid.width = job.settings.grid.height = 16;
    const bake::BakeFigures figures =
        bake::runBake(job, [](std::size_t, int, const Picture &) { return true; }, {});
    std::cout << "texels " << figures.texels << '\n';
    std::set<std::string> libraries;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const auto path = line.find('/');
        if (path != std::string::npos && line.find(".so") != std::string::npos)
            libraries.insert(line.substr(path));
    }
    for (const std::string &library : libraries)
        std::cout << library << '\n';
    return made.uv.rows() == 24 && figures.texels > 0 ? 0 : 1;
}
