#include "support/objuv.h"

#include <fstream>
#include <limits>
#include <sstream>

namespace autocuts::test {

namespace {

struct Corner
{
    int vertex = -1, uv = -1;
};

//! Reads "v", "v/t", "v//n" or "v/t/n"; negative indices count from the end.
bool parseCorner(const std::string &word, int vertexCount, int uvCount, Corner &corner)
{
    const auto index = [](const std::string &text, int count) {
        const int i = std::atoi(text.c_str());
        return i > 0 ? i - 1 : i < 0 ? count + i : -1;
    };
    const std::size_t slash = word.find('/');
    corner.vertex = index(word.substr(0, slash), vertexCount);
    if (slash != std::string::npos) {
        const std::string rest = word.substr(slash + 1);
        corner.uv = index(rest.substr(0, rest.find('/')), uvCount);
    }
    return corner.vertex >= 0;
}

} // namespace

ObjUv parseObjUv(const std::string &text)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Vec3> points;
    std::vector<Vec2> uvs;
    std::vector<std::vector<Corner>> faces;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind, x, y, z;
        words >> kind;
        if (kind == "v") {
            words >> x >> y >> z;
            points.emplace_back(std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr),
                                std::strtod(z.c_str(), nullptr));
        } else if (kind == "vt") {
            words >> x >> y;
            uvs.emplace_back(std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr));
        } else if (kind == "f") {
            std::vector<Corner> face;
            bool good = true;
            for (std::string word; words >> word && word[0] != '#';) {
                face.emplace_back();
                good = parseCorner(word, static_cast<int>(points.size()), static_cast<int>(uvs.size()),
                                   face.back()) &&
                       good;
            }
            if (good && face.size() >= 3)
                faces.push_back(std::move(face));
        }
    }

    std::vector<std::vector<int>> indices;
    std::vector<Vec2> cornerUv;
    for (const auto &face : faces) {
        bool inRange = true;
        for (const Corner &c : face) {
            inRange =
                inRange && c.vertex < static_cast<int>(points.size()) && c.uv < static_cast<int>(uvs.size());
        }
        if (!inRange)
            continue;
        indices.emplace_back();
        for (const Corner &c : face) {
            indices.back().push_back(c.vertex);
            cornerUv.push_back(c.uv >= 0 ? uvs[c.uv] : Vec2(nan, nan));
        }
    }
    ObjUv result;
    result.mesh = polygonMesh(points, indices);
    result.uv.resize(static_cast<Eigen::Index>(cornerUv.size()), 2);
    for (std::size_t i = 0; i < cornerUv.size(); ++i)
        result.uv.row(static_cast<Eigen::Index>(i)) = cornerUv[i].transpose();
    return result;
}

ObjUv readObjUv(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return parseObjUv(text.str());
}

std::vector<bool> seamsOf(const MeshData &mesh, const UvMatrix &soup)
{
    std::vector<bool> seam;
    seam.reserve(mesh.edgePairs.size());
    const double size = soup.rows() == 0 ? 0 : (soup.colwise().maxCoeff() - soup.colwise().minCoeff()).norm();
    for (const EdgePair &pair : mesh.edgePairs) {
        bool apart = false;
        for (int end = 0; end < 2; ++end) {
            const double gap = (soup.row(pair.corner[end][0]) - soup.row(pair.corner[end][1])).norm();
            apart = apart || !(gap <= 1e-6 * size);
        }
        seam.push_back(apart);
    }
    return seam;
}

} // namespace autocuts::test
