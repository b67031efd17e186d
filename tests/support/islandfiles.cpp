#include "support/islandfiles.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace autocuts::test {

UvMesh readUvMesh(const std::string &path)
{
    std::ifstream in(path);
    std::vector<Vec3> positions;
    std::vector<Vec2> uvs;
    std::vector<int> faceStart{0}, cornerVertex, cornerUv;
    std::string line, word;
    while (std::getline(in, line)) {
        std::istringstream words(line);
        words >> word;
        if (word == "v") {
            Vec3 p = Vec3::Zero();
            words >> p.x() >> p.y() >> p.z();
            positions.push_back(p);
        } else if (word == "vt") {
            Vec2 p = Vec2::Zero();
            words >> p.x() >> p.y();
            uvs.push_back(p);
        } else if (word == "f") {
            while (words >> word) {
                const std::size_t slash = word.find('/');
                cornerVertex.push_back(std::stoi(word) - 1);
                cornerUv.push_back(slash == std::string::npos ? -1 : std::stoi(word.substr(slash + 1)) - 1);
            }
            faceStart.push_back(static_cast<int>(cornerVertex.size()));
        }
        word.clear();
    }
    UvMesh result;
    if (cornerVertex.empty())
        return result;
    PositionMatrix matrix(static_cast<int>(positions.size()), 3);
    for (int i = 0; i < matrix.rows(); ++i)
        matrix.row(i) = positions[i].transpose();
    result.uv.resize(static_cast<int>(cornerUv.size()), 2);
    const Vec2 missing = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
    for (int c = 0; c < result.uv.rows(); ++c)
        result.uv.row(c) = (cornerUv[c] < 0 ? missing : uvs[cornerUv[c]]).transpose();
    const std::vector<int> objects(faceStart.size() - 1, 0);
    result.mesh = MeshData::build(matrix, faceStart, cornerVertex, objects);
    return result;
}

bool writeUvMesh(const std::string &path, const UvMesh &data)
{
    std::ofstream out(path);
    out.precision(17);
    const MeshData &mesh = *data.mesh;
    for (int i = 0; i < mesh.vertexCount(); ++i)
        out << "v " << mesh.positions(i, 0) << ' ' << mesh.positions(i, 1) << ' ' << mesh.positions(i, 2)
            << '\n';
    for (int c = 0; c < data.uv.rows(); ++c)
        out << "vt " << data.uv(c, 0) << ' ' << data.uv(c, 1) << '\n';
    for (int f = 0; f < mesh.faceCount(); ++f) {
        out << 'f';
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
            out << ' ' << mesh.cornerVertex[c] + 1 << '/' << c + 1;
        out << '\n';
    }
    return static_cast<bool>(out);
}

std::vector<std::string> islandFiles()
{
    const char *variable = std::getenv("AUTOCUTS_ISLANDS");
    const std::filesystem::path folder =
        variable ? std::filesystem::path(variable)
                 : std::filesystem::path(AUTOCUTS_SOURCE_DIR) / ".." / "shared" / "islands";
    std::vector<std::string> files;
    std::error_code error;
    for (const auto &entry : std::filesystem::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".obj")
            files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace autocuts::test
