#include "support/objpolygons.h"

#include <cstdlib>
#include <fstream>

namespace autocuts::test {

MeshPtr readObjPolygons(const std::string &path)
{
    std::ifstream file(path);
    if (!file)
        return nullptr;
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    std::string line;
    while (std::getline(file, line)) {
        char *at = line.data();
        if (line.starts_with("v ")) {
            Vec3 p;
            ++at;
            for (int k = 0; k < 3; ++k)
                p[k] = std::strtod(at, &at);
            points.push_back(p);
        } else if (line.starts_with("f ")) {
            std::vector<int> face;
            ++at;
            for (char *end = at;; at = end) {
                const long index = std::strtol(at, &end, 10);
                if (end == at)
                    break;
                face.push_back(
                    static_cast<int>(index > 0 ? index - 1 : static_cast<long>(points.size()) + index));
                while (*end == '/' || *end == '-' || (*end >= '0' && *end <= '9'))
                    ++end;
            }
            if (face.size() >= 3)
                faces.push_back(std::move(face));
        }
    }
    return polygonMesh(points, faces);
}

} // namespace autocuts::test
