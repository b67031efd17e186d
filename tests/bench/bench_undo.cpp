// Memory and CPU time of a thousand undo steps: bench_undo move|all|soup [FILE.obj]
//
// move: one island moved per step. all: every UV changes per step, corners of one vertex alike, as by a solve
// and its finish. soup: every corner changes by itself, as by a solve that is stopped half way. Without a
// file a grid of 50,000 triangles is taken.
#include "commands/islandtransform.h"
#include "support/editsupport.h"
#include "support/objpolygons.h"
#include "support/randomedits.h"

#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>

using namespace autocuts;

namespace {

constexpr int steps = 1000;

//! Memory of this process that is in use, in MB; 0 where the system does not tell.
double residentMegabytes()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.rfind("VmRSS:", 0) == 0)
            return std::stod(line.substr(6)) / 1024;
    }
    return 0;
}

double cpuSeconds()
{
    return double(std::clock()) / CLOCKS_PER_SEC;
}

UvMatrix jittered(const Document &document, test::Random &random, bool byVertex)
{
    const MeshData &mesh = document.mesh();
    UvMatrix uv = document.uv();
    UvMatrix shift(byVertex ? mesh.vertexCount() : mesh.cornerCount(), 2);
    for (Eigen::Index i = 0; i < shift.rows(); ++i) {
        shift(i, 0) = 0.01 * random.unit();
        shift(i, 1) = 0.01 * random.unit();
    }
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) += shift.row(byVertex ? mesh.vertexWeld[mesh.cornerVertex[c]] : c);
    return uv;
}

std::unique_ptr<DocumentCommand> makeStep(Document &document, const std::string &mode, test::Random &random)
{
    if (mode == "move") {
        const IslandTransform gesture(document, UvEdit::Move, {0});
        return gesture.command(Eigen::Affine2d(Eigen::Translation2d(random.unit(), 0.5)));
    }
    return std::make_unique<SetUvs>(document, UvEdit::Solve, jittered(document, random, mode == "all"));
}

} // namespace

int main(int argc, char *argv[])
{
    const std::string mode = argc > 1 ? argv[1] : "all";
    const test::MeshPtr mesh = argc > 2 ? test::readObjPolygons(argv[2]) : test::grid(158, 0.2);
    if (!mesh) {
        std::fprintf(stderr, "bench_undo: %s cannot be read\n", argv[2]);
        return 1;
    }
    const auto document = test::layoutDocument(mesh);
    UndoStack &stack = document->undoStack();
    test::Random random(3);
    const DocumentState first = document->state();
    const double residentBefore = residentMegabytes();
    const double start = cpuSeconds();
    for (int i = 0; i < steps; ++i)
        pushCommand(makeStep(*document, mode, random));
    const double done = cpuSeconds();
    const int undoable = stack.count() - stack.releasedCount();
    std::printf("%s, %d triangles: %d of %d steps can be undone, %.1f MB counted, %.1f MB resident\n",
                mode.c_str(), mesh->triangleCount(), undoable, steps,
                double(stack.memoryUsed()) / (1024 * 1024), residentMegabytes() - residentBefore);
    stack.setIndex(0);
    std::printf("%.2f ms per step, %.2f ms per undo; first state %s\n", 1000 * (done - start) / steps,
                1000 * (cpuSeconds() - done) / undoable,
                document->state() == first ? "restored" : "not restored (memory limit)");
    return 0;
}
