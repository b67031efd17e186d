// Packs the charts of OBJ files and prints islands, efficiency and CPU seconds for a list of efforts.
// Usage: bench_packing [--out FOLDER] [--efforts 0.1,0.5,...] [--seed N] [--margin TEXELS] [file.obj ...]
#include "solver/packing/islandgeometry.h"
#include "support/islandfiles.h"

#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <sstream>

using namespace autocuts;
using namespace autocuts::packing;

namespace {

struct Options
{
    std::vector<std::string> files = test::islandFiles();
    std::vector<double> efforts{0.1, 0.5, 1, 10};
    std::string folder;
    PackOptions settings;
};

Options readOptions(int argc, char **argv)
{
    Options options;
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
        const bool hasValue = i + 1 < argc;
        if (hasValue && std::strcmp(argv[i], "--out") == 0) {
            options.folder = argv[++i];
        } else if (hasValue && std::strcmp(argv[i], "--seed") == 0) {
            options.settings.seed = static_cast<unsigned>(std::stoul(argv[++i]));
        } else if (hasValue && std::strcmp(argv[i], "--margin") == 0) {
            options.settings.margin = std::stod(argv[++i]);
        } else if (hasValue && std::strcmp(argv[i], "--efforts") == 0) {
            options.efforts.clear();
            std::istringstream list(argv[++i]);
            for (std::string number; std::getline(list, number, ',');)
                options.efforts.push_back(std::stod(number));
        } else {
            files.push_back(argv[i]);
        }
    }
    if (!files.empty())
        options.files = files;
    return options;
}

} // namespace

int main(int argc, char **argv)
{
    const Options options = readOptions(argc, argv);
    std::printf("%-34s %7s %7s %10s %8s\n", "set", "islands", "effort", "efficiency", "cpu s");
    for (const double effort : options.efforts) {
        double sum = 0;
        int count = 0;
        for (const std::string &file : options.files) {
            test::UvMesh data = test::readUvMesh(file);
            if (!data.mesh) {
                std::fprintf(stderr, "cannot read %s\n", file.c_str());
                continue;
            }
            const ChartMap charts = findCharts(*data.mesh, data.uv);
            const std::vector<PackIsland> islands = makePackIslands(*data.mesh, data.uv, charts);
            PackOptions settings = options.settings;
            settings.effort = effort;
            const std::clock_t start = std::clock();
            const PackResult result = packIslands(islands, settings);
            const double cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
            const std::filesystem::path path(file);
            std::printf("%-34s %7d %7g %10.4f %8.3f%s\n", path.stem().c_str(), charts.count, effort,
                        result.efficiency, cpu, result.complete ? "" : "  incomplete");
            sum += result.efficiency;
            ++count;
            if (!options.folder.empty()) {
                applyPlacements(result, *data.mesh, charts, data.uv);
                std::ostringstream name;
                name << path.stem().string() << '_' << effort << ".obj";
                test::writeUvMesh((std::filesystem::path(options.folder) / name.str()).string(), data);
            }
        }
        if (count > 0)
            std::printf("%-34s %7s %7g %10.4f\n", "mean", "", effort, sum / count);
    }
    return 0;
}
