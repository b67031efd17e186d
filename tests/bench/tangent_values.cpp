// Prints a mesh with its shading normals and tangents, for scripts/tangents.
// Usage: tangent_values [--polygons] [--hard N] FILE|SAMPLE
//   --polygons  keeps polygons of more than four corners, which have no tangents then
//   --hard N    every N-th edge is hard, instead of those of more than 40 degrees
// Positions and UVs are rounded to single precision first, and moved and scaled to a box of size 1; all
// objects are one. A mesh without UVs gets its x and y. Lines: "v" position, "f" vertices of a face from 0,
// "e" vertices of a hard edge, and for each corner of each face "c" UV, normal, tangent and sign.
#include "model/io/meshes/meshfile.h"
#include "model/plain/shadingnormals.h"
#include "model/plain/tangents.h"
#include "model/samples/samples.h"

#include <QCoreApplication>

#include <cstdio>
#include <cstring>
#include <set>

using namespace autocuts;

namespace {

struct Options
{
    bool polygons = false;
    int hard = 0;
    QString mesh;
};

//! A mesh as other programs read it, and the UVs of its corners.
struct Input
{
    std::shared_ptr<const MeshData> mesh;
    UvMatrix uv;
};

Options readOptions(int argc, char **argv)
{
    Options options;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--polygons") == 0)
            options.polygons = true;
        else if (std::strcmp(argv[i], "--hard") == 0 && i + 1 < argc)
            options.hard = std::atoi(argv[++i]);
        else
            options.mesh = QString::fromLocal8Bit(argv[i]);
    }
    return options;
}

PositionMatrix roundedPositions(const MeshData &mesh)
{
    const Eigen::RowVector3d low = mesh.positions.colwise().minCoeff();
    const double size = (mesh.positions.colwise().maxCoeff() - low).maxCoeff();
    const PositionMatrix moved = (mesh.positions.rowwise() - low) / (size > 0 ? size : 1);
    return moved.cast<float>().cast<double>();
}

Input roundedInput(const Scene &scene, bool polygons)
{
    const MeshData &mesh = *scene.mesh;
    const PositionMatrix positions = roundedPositions(mesh);
    std::vector<int> faceStart{0}, cornerVertex, corners;
    const auto add = [&](int corner) {
        cornerVertex.push_back(mesh.cornerVertex[corner]);
        corners.push_back(corner);
    };
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (polygons || mesh.faceStart[f + 1] - mesh.faceStart[f] <= 4) {
            for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
                add(c);
            faceStart.push_back(static_cast<int>(corners.size()));
            continue;
        }
        for (const int t : mesh.trianglesOf(f)) {
            for (const int c : mesh.triangles[t])
                add(c);
            faceStart.push_back(static_cast<int>(corners.size()));
        }
    }
    Input input;
    input.uv.resize(static_cast<Eigen::Index>(corners.size()), 2);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 uv = scene.hasUv() ? Vec2(scene.uvSets[0].uv.row(corners[i]))
                                      : Vec2(positions.row(cornerVertex[i]).head<2>());
        input.uv.row(static_cast<Eigen::Index>(i)) = uv.cast<float>().cast<double>();
    }
    const std::size_t faces = faceStart.size() - 1;
    input.mesh =
        MeshData::build(positions, std::move(faceStart), std::move(cornerVertex), std::vector<int>(faces, 0));
    return input;
}

void print(const Input &input, const Options &options)
{
    const MeshData &mesh = *input.mesh;
    for (const auto &p : mesh.positions.rowwise())
        std::printf("v %.9g %.9g %.9g\n", p.x(), p.y(), p.z());
    std::vector<bool> hard;
    if (options.hard > 0) {
        hard.resize(mesh.edgePairs.size());
        for (std::size_t e = 0; e < hard.size(); e += static_cast<std::size_t>(options.hard)) {
            hard[e] = true;
            std::printf("e %d %d\n", mesh.vertexOfSoup(mesh.edgePairs[e].corner[0][0]),
                        mesh.vertexOfSoup(mesh.edgePairs[e].corner[1][0]));
        }
    }
    const std::vector<Eigen::Vector3f> normals = shadingNormals(mesh, hard);
    const std::vector<Tangent> soup = mikkTangents(mesh, input.uv, normals);
    std::vector<Tangent> tangents(mesh.cornerCount());
    for (int s = 0; s < mesh.soupCornerCount(); ++s)
        tangents[mesh.cornerOfSoup(s)] = soup[s];
    for (int f = 0; f < mesh.faceCount(); ++f) {
        std::printf("f");
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
            std::printf(" %d", mesh.vertexWeld[mesh.cornerVertex[c]]);
        std::printf("\n");
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c) {
            const Eigen::Vector3f &n = normals[c], &t = tangents[c].direction;
            std::printf("c %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %g\n", input.uv(c, 0), input.uv(c, 1),
                        double(n.x()), double(n.y()), double(n.z()), double(t.x()), double(t.y()),
                        double(t.z()), double(tangents[c].sign));
        }
    }
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    const Options options = readOptions(argc, argv);
    const bool isSample = sampleNames().contains(options.mesh);
    const Result<Scene> scene = isSample ? makeSample(options.mesh) : readMesh(options.mesh);
    if (!scene) {
        std::fprintf(stderr, "%s\n", qPrintable(scene.error().message));
        return 1;
    }
    print(roundedInput(scene.value(), options.polygons), options);
    return 0;
}
