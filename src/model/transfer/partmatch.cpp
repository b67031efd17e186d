#include "model/transfer/partmatch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace autocuts {

namespace {

//! Shapes are the same where their sides, in parts of their whole length, differ by less than this in all:
//! text files often have six digits. Chosen by hand.
constexpr double sameShape = 1e-3;
//! How many parts with the same polygons are compared. Programs keep the order of parts, so the right one is
//! among the first that are left.
constexpr int mostCompared = 64;

using Faces = std::vector<int>;

//! The connected components, each with its faces in their order, by their first faces.
std::vector<Faces> partsOf(const MeshData &mesh)
{
    std::vector<Faces> parts;
    std::vector<int> place(static_cast<std::size_t>(mesh.componentCount), -1);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        int &part = place[mesh.component[mesh.faceTriangle[face]]];
        if (part < 0) {
            part = static_cast<int>(parts.size());
            parts.emplace_back();
        }
        parts[part].push_back(face);
    }
    return parts;
}

//! Keeps the parts of which less than half of the faces have `counterpart` >= 0.
std::vector<Faces> unmatchedParts(const MeshData &mesh, const std::vector<int> &counterpart)
{
    std::vector<Faces> parts = partsOf(mesh);
    std::erase_if(parts, [&](const Faces &faces) {
        const auto matched = std::ranges::count_if(faces, [&](int face) { return counterpart[face] >= 0; });
        return 2 * matched >= static_cast<std::ptrdiff_t>(faces.size());
    });
    return parts;
}

//! The polygons of a part: for each face its number of corners and their vertices, numbered as they first
//! come. \param number work space, -1 for each vertex before and after
std::vector<int> polygonsOf(const MeshData &mesh, const Faces &faces, std::vector<int> &number)
{
    std::vector<int> polygons;
    int count = 0;
    for (const int face : faces) {
        polygons.push_back(mesh.faceStart[face + 1] - mesh.faceStart[face]);
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
            int &vertex = number[mesh.vertexWeld[mesh.cornerVertex[c]]];
            vertex = vertex < 0 ? count++ : vertex;
            polygons.push_back(vertex);
        }
    }
    for (const int face : faces) {
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
            number[mesh.vertexWeld[mesh.cornerVertex[c]]] = -1;
    }
    return polygons;
}

//! The lengths of all sides of the faces in parts of their sum: the same in any size and direction.
std::vector<double> shapeOf(const MeshData &mesh, const Faces &faces)
{
    std::vector<double> lengths;
    double sum = 0;
    for (const int face : faces) {
        const int start = mesh.faceStart[face], end = mesh.faceStart[face + 1];
        for (int c = start; c < end; ++c) {
            const int next = c + 1 < end ? c + 1 : start;
            lengths.push_back((mesh.cornerPosition(next) - mesh.cornerPosition(c)).norm());
            sum += lengths.back();
        }
    }
    for (double &length : lengths)
        length /= std::max(sum, std::numeric_limits<double>::min());
    return lengths;
}

//! The whole difference of two shapes, or a larger number than `most` where it is larger.
double difference(const std::vector<double> &a, const std::vector<double> &b, double most)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size() && sum <= most; ++i)
        sum += std::abs(a[i] - b[i]);
    return sum;
}

//! The place of the part in `candidates` that is the counterpart of one with `shape`.
std::optional<std::size_t> counterpartOf(const std::vector<double> &shape, bool isLarge,
                                         const MeshData &after, const std::vector<Faces> &candidates)
{
    double least = isLarge ? std::numeric_limits<double>::max() : sameShape;
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < candidates.size() && i < mostCompared && !(best && least < sameShape); ++i) {
        const double error = difference(shape, shapeOf(after, candidates[i]), least);
        if (error < least) {
            least = error;
            best = i;
        }
    }
    return best;
}

std::vector<int> inverseOf(const FaceMatch &match, const MeshData &after)
{
    std::vector<int> inverse(static_cast<std::size_t>(after.faceCount()), -1);
    for (std::size_t face = 0; face < match.face.size(); ++face) {
        if (match.face[face] >= 0)
            inverse[match.face[face]] = static_cast<int>(face);
    }
    return inverse;
}

void setCounterpart(const MeshData &before, int face, const MeshData &after, int other, FaceMatch &match)
{
    match.face[face] = other;
    for (int c = before.faceStart[face]; c < before.faceStart[face + 1]; ++c)
        match.corner[c] = other < 0 ? -1 : after.faceStart[other] + c - before.faceStart[face];
}

} // namespace

void matchParts(const MeshData &before, const MeshData &after, FaceMatch &match)
{
    const std::vector<Faces> old = unmatchedParts(before, match.face);
    if (old.empty())
        return;
    const std::vector<int> inverse = inverseOf(match, after);
    std::map<std::vector<int>, std::vector<Faces>> fresh; // by their polygons
    std::vector<int> number(static_cast<std::size_t>(std::max(before.vertexCount(), after.vertexCount())),
                            -1);
    for (Faces &faces : unmatchedParts(after, inverse)) {
        std::vector<int> polygons = polygonsOf(after, faces, number);
        fresh[std::move(polygons)].push_back(std::move(faces));
    }
    for (const Faces &faces : old) {
        const auto found = fresh.find(polygonsOf(before, faces, number));
        if (found == fresh.end())
            continue;
        std::vector<Faces> &candidates = found->second;
        const auto chosen =
            counterpartOf(shapeOf(before, faces), std::ssize(faces) >= facesToRecognise, after, candidates);
        if (!chosen)
            continue;
        const Faces &other = candidates[*chosen];
        // Single faces may have been matched with others that lie there by chance.
        for (const int face : other) {
            if (inverse[face] >= 0 && match.face[inverse[face]] == face)
                setCounterpart(before, inverse[face], after, -1, match);
        }
        for (std::size_t i = 0; i < faces.size(); ++i)
            setCounterpart(before, faces[i], after, other[i], match);
        candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(*chosen));
    }
}

} // namespace autocuts
