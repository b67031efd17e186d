#include "support/pieces.h"

#include "model/plain/uvlayout.h"

#include <algorithm>

namespace autocuts::test {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double uvPerUnit = 0.1;
const std::vector<Vec2> outline{{0, 0}, {1, 0}, {2.5, 0}, {2.5, 1}, {1, 1}, {0, 1}, {1, 2}, {0, 2}};
const std::vector<std::vector<int>> quads{{0, 1, 4, 5}, {1, 2, 3, 4}, {5, 4, 6, 7}};

} // namespace

std::unique_ptr<Document> partsDocument(const std::vector<PartPlace> &places)
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    std::vector<Vec2> uvs;
    for (const PartPlace &place : places) {
        const int first = static_cast<int>(points.size());
        const double side = place.mirrored ? -1 : 1;
        for (const Vec2 &p : outline)
            points.emplace_back(side * p.x() + 4 * static_cast<double>(faces.size()), p.y(), 0);
        for (std::vector<int> quad : quads) {
            if (place.mirrored)
                std::reverse(quad.begin(), quad.end());
            for (int &corner : quad) {
                const Vec2 p(side * outline[corner].x(), outline[corner].y());
                uvs.push_back(place.move + uvPerUnit * place.scale * (Eigen::Rotation2Dd(place.angle) * p));
                corner += first;
            }
            faces.push_back(quad);
        }
    }
    Scene scene = sceneOf(polygonMesh(points, faces));
    UvMatrix uv(uvs.size(), 2);
    for (std::size_t i = 0; i < uvs.size(); ++i)
        uv.row(static_cast<Eigen::Index>(i)) = uvs[i].transpose();
    scene.uvSets.push_back({u"first"_s, uv});
    return std::make_unique<Document>(std::move(scene));
}

} // namespace autocuts::test
