#include "views/gl/soupbuffers.h"

#include "model/document/islandcolor.h"
#include "model/plain/parallel.h"
#include "model/plain/picture.h"
#include "model/plain/shadingnormals.h"
#include "model/plain/tangents.h"
#include "model/plain/unionfind.h"
#include "views/gl/colormap.h"

#include <Eigen/Geometry>

#include <cmath>

namespace autocuts {

namespace {

std::array<float, 3> toFloats(const Vec3 &v)
{
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

//! Without a branch for each number: it is asked for all triangles of large meshes.
bool hasUv(const UvMatrix &uv, int triangle)
{
    const double *value = uv.data() + 6 * static_cast<std::ptrdiff_t>(triangle);
    const double sum = (value[0] - value[0]) + (value[1] - value[1]) + (value[2] - value[2]) +
                       (value[3] - value[3]) + (value[4] - value[4]) + (value[5] - value[5]);
    return sum == 0; // a number that is not finite leaves none
}

} // namespace

std::vector<SoupVertex> soupVertices(const MeshData &mesh, const std::vector<bool> &hardEdges,
                                     const MeshFrame &frame)
{
    const std::vector<Eigen::Vector3f> normals = shadingNormals(mesh, hardEdges);
    std::vector<SoupVertex> vertices(mesh.soupCornerCount());
    for (int s = 0; s < mesh.soupCornerCount(); ++s) {
        const int corner = mesh.cornerOfSoup(s);
        const Eigen::Vector3f &normal = normals[corner];
        vertices[s] = {toFloats(frame.toFrame(mesh.cornerPosition(corner))),
                       {normal.x(), normal.y(), normal.z()}};
    }
    return vertices;
}

std::vector<float> soupTangents(const MeshData &mesh, const UvMatrix &uv, const std::vector<bool> &hardEdges)
{
    std::vector<float> result;
    result.reserve(4 * static_cast<std::size_t>(mesh.soupCornerCount()));
    for (const Tangent &tangent : mikkTangents(mesh, uv, shadingNormals(mesh, hardEdges)))
        result.insert(result.end(),
                      {tangent.direction.x(), tangent.direction.y(), tangent.direction.z(), tangent.sign});
    return result;
}

std::vector<float> soupUvs(const UvMatrix &uv)
{
    std::vector<float> result(2 * uv.rows(), noUv);
    const double *value = uv.data();
    for (std::size_t first = 0; first < result.size(); first += 6) {
        bool complete = true;
        for (std::size_t k = first; k < first + 6; ++k)
            complete = complete && std::abs(value[k]) < 1e15; // false for what is not a number
        for (std::size_t k = first; complete && k < first + 6; ++k)
            result[k] = static_cast<float>(value[k]);
    }
    return result;
}

UvMatrix ghostUv(const MeshData &mesh, const UvMatrix &uv, std::span<const float> separation)
{
    UnionFind sets(mesh.soupCornerCount());
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        for (int end = 0; end < 2; ++end) {
            if (separation[2 * e + end] < 0.5f)
                sets.unite(mesh.edgePairs[e].corner[end][0], mesh.edgePairs[e].corner[end][1]);
        }
    }
    UvMatrix sum = UvMatrix::Zero(uv.rows(), 2);
    std::vector<int> count(mesh.soupCornerCount(), 0);
    for (int s = 0; s < mesh.soupCornerCount(); ++s) {
        const int root = sets.find(s);
        sum.row(root) += uv.row(s);
        ++count[root];
    }
    UvMatrix ghost(uv.rows(), 2);
    for (int s = 0; s < mesh.soupCornerCount(); ++s)
        ghost.row(s) = sum.row(sets.find(s)) / count[sets.find(s)];
    return ghost;
}

std::vector<int> liveIslands(const MeshData &mesh, std::span<const float> separation)
{
    UnionFind sets(mesh.faceCount());
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        if (std::max(separation[2 * e], separation[2 * e + 1]) >= 0.5f)
            continue;
        const EdgePair &pair = mesh.edgePairs[e];
        sets.unite(mesh.triangleFace[pair.triangle[0]], mesh.triangleFace[pair.triangle[1]]);
    }
    return sets.labels().first;
}

namespace {

//! Colours of painted weights: for each face, the mean of the weights along its sides, on a logarithmic
//! scale.
std::vector<QRgb> paintColors(const FaceInput &input)
{
    const MeshData &mesh = input.mesh;
    std::vector<double> sum(mesh.faceCount(), 0);
    std::vector<int> count(mesh.faceCount(), 0);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if (pair.diagonal)
            continue;
        for (int end = 0; end < 2; ++end) {
            for (int triangle : pair.triangle) {
                sum[mesh.triangleFace[triangle]] += std::log(std::max(input.seamWeights[2 * e + end], 1e-3));
                ++count[mesh.triangleFace[triangle]];
            }
        }
    }
    std::vector<QRgb> colors(mesh.triangleCount());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        const double weight = count[face] > 0 ? std::exp(sum[face] / count[face]) : unpaintedWeight;
        colors[t] = paintColor(weight, input.plain.rgb());
    }
    return colors;
}

//! \param ratio of the density to the right one
QRgb densityColor(double ratio, const ViewOptions &options)
{
    double value = std::log2(ratio) / std::max(options.densityClamp, 1e-6);
    if (options.densityTolerance > 0 && std::isfinite(ratio))
        value = bandedDensity(ratio, options.densityTolerance);
    return heatColor(HeatMap::Density, false, value);
}

//! The mean of a triangle's vertex colours, in sRGB; the other colour where one is not known.
QRgb vertexColor(std::span<const CornerColor> colors, const std::array<int, 3> &corners, QRgb otherwise)
{
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const int corner : corners) {
        if (corner >= std::ssize(colors) || !colors[corner].known)
            return otherwise;
        sum += colors[corner].value();
    }
    const auto part = [&sum](int k) {
        return static_cast<int>(std::lround(255 * srgbFromLinear(sum[k] / 3)));
    };
    return qRgb(part(0), part(1), part(2));
}

//! True for colours that say something of the map, and so nothing where there is none.
bool showsMap(Coloring coloring)
{
    return coloring == Coloring::SignedStretch || coloring == Coloring::StretchMagnitude ||
           coloring == Coloring::Density;
}

//! A colour per island.
std::vector<QRgb> islandColors(const FaceInput &input)
{
    std::vector<QRgb> colors;
    if (input.options.coloring == Coloring::Islands && !input.islands.empty()) {
        const int islands = 1 + *std::max_element(input.islands.begin(), input.islands.end());
        for (int island = 0; island < islands; ++island)
            colors.push_back(islandColor(island));
    }
    return colors;
}

//! The colour of a triangle, but for painted weights.
QRgb triangleColor(const FaceInput &input, std::span<const QRgb> islandColors, int t)
{
    const QRgb plain = input.plain.rgb();
    if (showsMap(input.options.coloring) && !hasUv(input.uv, t))
        return plain;
    switch (input.options.coloring) {
    case Coloring::Islands: {
        const int island = input.islands[input.mesh.triangleFace[t]];
        return island >= 0 ? islandColors[island] : plain;
    }
    case Coloring::SignedStretch:
        return heatColor(HeatMap::SignedStretch, input.colorBlind,
                         input.stretch.areaLog2[t] / std::max(input.options.stretchClamp, 1e-6));
    case Coloring::StretchMagnitude:
        return heatColor(HeatMap::Magnitude, input.colorBlind,
                         (input.stretch.dirichlet[t] - 4) / std::max(input.options.magnitudeClamp - 4, 1e-6));
    case Coloring::Density:
        return densityColor(input.density[t] / input.rightDensity, input.options);
    case Coloring::TexelWeights:
        return texelWeightColor(input.texelWeights.empty() ? 1
                                                           : input.texelWeights[input.mesh.triangleFace[t]]);
    case Coloring::VertexColors:
        return vertexColor(input.vertexColors, input.mesh.triangles[t], plain);
    default:
        return plain;
    }
}

//! The colour of every triangle, without marks.
std::vector<QRgb> triangleColors(const FaceInput &input)
{
    if (input.options.coloring == Coloring::PaintWeights)
        return paintColors(input);
    std::vector<QRgb> colors(input.mesh.triangleCount());
    const std::vector<QRgb> ofIslands = islandColors(input);
    parallelRanges(input.mesh.triangleCount(), [&](int first, int end) {
        for (int t = first; t < end; ++t)
            colors[t] = triangleColor(input, ofIslands, t);
    });
    return colors;
}

} // namespace

std::vector<FaceTexel> faceTexels(const FaceInput &input)
{
    const MeshData &mesh = input.mesh;
    const std::vector<QRgb> colors = triangleColors(input);
    std::vector<quint8> faceMarks(mesh.faceCount(), 0);
    for (int face : input.selectedFaces)
        faceMarks[face] = FaceTexel::Selected;
    for (int face : input.hiddenFaces)
        faceMarks[face] |= FaceTexel::Hidden;
    std::vector<FaceTexel> texels(mesh.triangleCount());
    parallelRanges(mesh.triangleCount(), [&](int first, int end) {
        for (int t = first; t < end; ++t) {
            quint8 marks = faceMarks[mesh.triangleFace[t]];
            if (input.options.problems && input.flipped[t])
                marks |= FaceTexel::Flipped;
            if (!hasUv(input.uv, t))
                marks |= FaceTexel::WithoutUv;
            texels[t] = {static_cast<quint8>(qRed(colors[t])), static_cast<quint8>(qGreen(colors[t])),
                         static_cast<quint8>(qBlue(colors[t])), marks};
        }
    });
    if (input.options.problems) {
        for (int t : input.overlapping) {
            if (t >= 0 && t < mesh.triangleCount())
                texels[t].marks |= FaceTexel::Overlapping;
        }
    }
    return texels;
}

namespace {

quint8 toByte(double share)
{
    return static_cast<quint8>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

//! Opacity of a forced cut: pale while the map is closed along it. It opens when it reaches a border or
//! another cut, or with the next solve.
quint8 opacityOfCut(const SideInput &input, int pairIndex)
{
    constexpr quint8 open = 255, closed = 90;
    const EdgePair &pair = input.mesh.edgePairs[pairIndex];
    const bool hasMap = hasUv(input.uv, pair.triangle[0]) && hasUv(input.uv, pair.triangle[1]);
    const bool apart = std::max(input.separation[2 * pairIndex], input.separation[2 * pairIndex + 1]) >= 0.5f;
    return hasMap && !apart ? closed : open;
}

//! Sets the top line of a side of an edge pair. \param which index of the triangle in the pair
void setTopLine(const SideInput &input, int pairIndex, int which, SideTexel &texel)
{
    const EdgePair &pair = input.mesh.edgePairs[pairIndex];
    // The end of the pair at the side's first corner.
    const int firstEnd = pair.corner[0][which] % 3 == pair.side(which) ? 0 : 1;
    for (int i = 0; i < 2; ++i) {
        const int cornerPair = 2 * pairIndex + (i == 0 ? firstEnd : 1 - firstEnd);
        const PairState state = input.seams.states[cornerPair];
        if (input.options.steering && state != PairState::Free) {
            texel.top =
                static_cast<quint8>(state == PairState::Cut ? SideStyle::ForcedCut : SideStyle::Joined);
            texel.opacity[i] = state == PairState::Cut ? opacityOfCut(input, pairIndex) : quint8(255);
        }
    }
    if (texel.top == 0 && input.options.steering && !input.givenSeams.empty() &&
        input.givenSeams[static_cast<std::size_t>(pairIndex)])
        texel = {texel.base, {255, 255}, static_cast<quint8>(SideStyle::Given)};
    if (texel.top != 0 || !input.options.seams || !hasUv(input.uv, pair.triangle[0]) ||
        !hasUv(input.uv, pair.triangle[1]))
        return;
    texel.opacity[0] = toByte(input.separation[2 * pairIndex + firstEnd]);
    texel.opacity[1] = toByte(input.separation[2 * pairIndex + 1 - firstEnd]);
    if (texel.opacity[0] > 0 || texel.opacity[1] > 0)
        texel.top = static_cast<quint8>(SideStyle::Seam);
}

SideTexel sideTexel(const SideInput &input, int side)
{
    SideTexel texel;
    const int edge = input.topology.sideEdge[side];
    if (edge < 0)
        return texel;
    const bool border = edge >= std::ssize(input.mesh.edgePairs);
    if (input.options.wireframe || border)
        texel.base = static_cast<quint8>(border ? SideStyle::Border : SideStyle::Wire);
    if (!border && input.options.steering && input.seams.straight[2 * edge] != 0)
        texel.base = static_cast<quint8>(SideStyle::Straight); // a wide line below that of a seam
    if (!border)
        setTopLine(input, edge, input.topology.edgeSides[edge][0] == side ? 0 : 1, texel);
    return texel;
}

} // namespace

std::vector<SideTexel> sideTexels(const SideInput &input)
{
    std::vector<SideTexel> texels(input.topology.sideEdge.size());
    parallelRanges(static_cast<int>(texels.size()), [&](int first, int end) {
        for (int side = first; side < end; ++side)
            texels[side] = sideTexel(input, side);
    });
    for (int edge : input.selectedEdges) {
        for (int side : input.topology.edgeSides[edge]) {
            if (side >= 0)
                texels[side] = {texels[side].base, {255, 255}, static_cast<quint8>(SideStyle::Selected)};
        }
    }
    return texels;
}

} // namespace autocuts
