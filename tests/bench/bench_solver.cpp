// Measures the solver on OBJ files: cost of a step by part, time to an energy, latency after an edit, time to
// a finished map, memory; the fast step against the exact one in the same run. CPU time throughout. Usage:
// bench_solver MESH... [--threads N] [--json] [--subdivide N] [--no-exact] [--steps-only] [--map QUALITY]
// [--quality]
#include "bench/benchoptions.h"
#include "bench/benchreport.h"
#include "bench/solverbench.h"
#include "bench/subdivide.h"
#include "support/objpolygons.h"

#include <cstdio>
#include <exception>

using namespace autocuts;
using namespace autocuts::unwrap;

namespace {

//! Maps by the homotopy alone are made of meshes up to this size: larger ones take minutes.
constexpr int largestSoupMap = 20'000;

//! \param lambda balance of the homotopy; nothing: the automatic mode
bench::MapReport finishedMap(const test::MeshPtr &mesh, const bench::Options &options, SolverKind solver,
                             std::optional<double> lambda)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    snapshot.settings.solver = solver;
    UnwrapOptions unwrapping;
    unwrapping.quality = lambda ? UnwrapQuality::Draft : *options.map;
    unwrapping.lambda = lambda;
    const bench::Time start = bench::Time::now();
    const UnwrapResult result = unwrapMesh(snapshot, unwrapping, {nullptr, options.threads});
    return {(bench::Time::now() - start).cpu, result.distortion, result.seamLength};
}

bench::MeshReport measure(const std::string &file, const bench::Options &options)
{
    bench::MeshReport report;
    test::MeshPtr mesh = test::readObjPolygons(file);
    if (!mesh)
        throw std::runtime_error("cannot read " + file);
    for (int i = 0; i < options.subdivisions; ++i)
        mesh = bench::subdivided(*mesh);
    report.mesh = file.substr(file.find_last_of('/') + 1);
    report.triangles = mesh->triangleCount();
    constexpr double lambda = 0.05;
    if (options.quality) {
        report.quality = bench::compareQuality(mesh, lambda, 5, options.threads);
        return report;
    }
    for (const double delta : {1e-3, 2.4e-4}) {
        const bench::WarmState state = bench::warmState(mesh, lambda, delta, options.threads);
        if (delta == 1e-3)
            report.steps = bench::measureSteps(state, options.exact, options.threads);
        if (options.stepsOnly)
            break;
        if (options.exact)
            report.races.emplace_back(delta, bench::race(state, 10, options.threads));
        if (delta == 1e-3)
            report.edits = bench::measureEdits(state, options.threads);
    }
    if (options.map) {
        report.map = finishedMap(mesh, options, SolverKind::Fast, {});
        if (mesh->triangleCount() <= largestSoupMap) {
            report.soupMap = finishedMap(mesh, options, SolverKind::Fast, lambda);
            if (options.exact)
                report.exactSoupMap = finishedMap(mesh, options, SolverKind::Exact, lambda);
        }
    }
    report.memory = bench::peakMemory();
    return report;
}

} // namespace

int main(int argc, char **argv)
{
    std::string problem;
    const auto options = bench::readOptions({argv + 1, argv + argc}, problem);
    if (!options) {
        std::fprintf(stderr, "bench_solver: %s\n%s", problem.c_str(), bench::usage);
        return 2;
    }
    std::vector<bench::MeshReport> reports;
    for (const std::string &file : options->files) {
        try {
            reports.push_back(measure(file, *options));
        } catch (const std::exception &error) {
            std::fprintf(stderr, "bench_solver: %s\n", error.what());
            return 1;
        }
        if (!options->json)
            std::fputs(bench::asText(reports.back()).c_str(), stdout);
    }
    if (options->json)
        std::fputs(bench::asJson(reports, options->threads).c_str(), stdout);
}
