// Unwraps a mesh that was made by a program, and writes it as an OBJ with its UVs.
#include <autocuts/autocuts.hpp>

#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>
#include <vector>

int main(int argc, char *argv[])
try {
    constexpr int around = 48, across = 24;
    std::vector<double> positions;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
            const double r = 1 + 0.1 * std::sin(5 * a);
            positions.insert(positions.end(), {(3 + r * std::cos(b)) * std::cos(a), r * std::sin(b),
                                               (3 + r * std::cos(b)) * std::sin(a)});
            const auto vertex = [](int k, int l) { return std::uint32_t(k % around * across + l % across); };
            indices.insert(indices.end(),
                           {vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)});
        }
    }
    const std::vector<std::uint32_t> faceSizes(indices.size() / 4, 4);
    const autocuts::Map map = autocuts::unwrap({positions, indices, faceSizes}, {}, [](double fraction) {
        std::cerr << '\r' << int(100 * fraction) << " %";
        return true; // go on
    });
    std::ofstream obj(argc > 1 ? argv[1] : "wavytorus.obj");
    for (std::size_t v = 0; v < positions.size(); v += 3)
        obj << "v " << positions[v] << ' ' << positions[v + 1] << ' ' << positions[v + 2] << '\n';
    for (std::size_t c = 0; c < indices.size(); ++c)
        obj << "vt " << map.uvs()[2 * c] << ' ' << map.uvs()[2 * c + 1] << '\n';
    for (std::size_t c = 0; c < indices.size(); ++c)
        obj << (c % 4 == 0 ? "f " : " ") << indices[c] + 1 << '/' << c + 1 << (c % 4 == 3 ? "\n" : "");
    const autocuts::Figures figures = map.measure();
    std::cout << "islands " << figures.islands << ", distortion " << figures.distortion << ", seams "
              << figures.seam_norm << '\n';
    return obj.good() ? 0 : 1;
} catch (const autocuts::Error &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
