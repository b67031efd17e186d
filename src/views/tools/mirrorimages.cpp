#include "views/tools/mirrorimages.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace autocuts {

namespace {

//! Chosen by hand.
constexpr double matchingShare = 0.25;

struct Place
{
    int element;
    Vec3 middle;
    double size;
};

//! A key with the same value for a point and its mirror image. The keys of two points differ by at most their
//! distance.
double sortingKey(const Vec3 &place)
{
    return 0.5 * std::abs(place.x()) + 0.7 * place.y() + 0.5 * place.z();
}

//! For each of `count` elements, the one nearest to its mirror image.
std::vector<int> mirrorImages(const std::vector<Place> &places, std::size_t count)
{
    // Only places with similar keys are compared exactly.
    std::vector<std::pair<double, int>> byKey;
    for (std::size_t p = 0; p < places.size(); ++p)
        byKey.emplace_back(sortingKey(places[p].middle), static_cast<int>(p));
    std::sort(byKey.begin(), byKey.end());
    std::vector<int> images(count, -1);
    for (const auto &[key, p] : byKey) {
        const auto &[element, middle, size] = places[p];
        const Vec3 mirrored(-middle.x(), middle.y(), middle.z());
        double nearest = matchingShare * size;
        auto candidate = std::lower_bound(byKey.begin(), byKey.end(), std::pair(key - nearest, -1));
        for (const double last = key + nearest; candidate != byKey.end() && candidate->first <= last;
             ++candidate) {
            const double distance = (places[candidate->second].middle - mirrored).stableNorm();
            if (distance < nearest || (distance == nearest && images[element] < 0)) {
                nearest = distance;
                images[element] = places[candidate->second].element;
            }
        }
    }
    return images;
}

} // namespace

std::vector<int> mirroredEdges(const MeshData &mesh)
{
    std::vector<Place> places;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &edge = mesh.edgePairs[e];
        if (!edge.diagonal)
            places.push_back({static_cast<int>(e),
                              0.5 * (mesh.cornerPosition(mesh.cornerOfSoup(edge.corner[0][0])) +
                                     mesh.cornerPosition(mesh.cornerOfSoup(edge.corner[1][0]))),
                              edge.length});
    }
    return mirrorImages(places, mesh.edgePairs.size());
}

std::vector<int> mirroredFaces(const MeshData &mesh)
{
    std::vector<Place> places;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        Vec3 sum = Vec3::Zero();
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
            sum += mesh.cornerPosition(c);
        double area = 0;
        for (const int t : mesh.trianglesOf(f))
            area += mesh.triangleArea[t];
        places.push_back({f, sum / (mesh.faceStart[f + 1] - mesh.faceStart[f]), std::sqrt(area)});
    }
    return mirrorImages(places, static_cast<std::size_t>(mesh.faceCount()));
}

} // namespace autocuts
