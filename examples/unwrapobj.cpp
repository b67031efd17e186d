// Unwraps the vertices and faces of an OBJ: unwrapobj IN OUT [draft|standard|best] [THREADS]
#include <autocuts/autocuts.hpp>

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <vector>

int main(int argc, char *argv[])
try {
    if (argc < 3) {
        std::cerr << "usage: unwrapobj IN OUT [draft|standard|best] [THREADS]\n";
        return 2;
    }
    std::ifstream in(argv[1]);
    std::vector<double> positions;
    std::vector<std::uint32_t> indices, faceSizes;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "v") {
            double x = 0, y = 0, z = 0;
            words >> x >> y >> z;
            positions.insert(positions.end(), {x, y, z});
        } else if (word == "f") {
            faceSizes.push_back(0);
            for (; words >> word; ++faceSizes.back())
                indices.push_back(std::uint32_t(std::strtoul(word.c_str(), nullptr, 10)) - 1);
        }
    }
    autocuts::Options options;
    const std::string quality = argc > 3 ? argv[3] : "standard";
    options.quality = quality == "draft"  ? AUTOCUTS_DRAFT
                      : quality == "best" ? AUTOCUTS_BEST
                                          : AUTOCUTS_STANDARD;
    options.threads = argc > 4 ? std::atoi(argv[4]) : 1;
    const autocuts::Map map = autocuts::unwrap({positions, indices, faceSizes}, options);
    std::ofstream out(argv[2]);
    out << std::setprecision(17);
    for (std::size_t v = 0; v < positions.size(); v += 3)
        out << "v " << positions[v] << ' ' << positions[v + 1] << ' ' << positions[v + 2] << '\n';
    for (std::size_t c = 0; c < indices.size(); ++c)
        out << "vt " << map.uvs()[2 * c] << ' ' << map.uvs()[2 * c + 1] << '\n';
    std::size_t corner = 0;
    for (const std::uint32_t size : faceSizes) {
        out << 'f';
        for (std::uint32_t k = 0; k < size; ++k, ++corner)
            out << ' ' << indices[corner] + 1 << '/' << corner + 1;
        out << '\n';
    }
    return out.good() ? 0 : 1;
} catch (const autocuts::Error &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
