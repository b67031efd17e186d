#include "figures/paintedmodel.h"

#include "bench/subdivide.h"
#include "model/plain/picture.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace autocuts::figures {

namespace {

constexpr double scalesAcross = 52; // along the diagonal of the model
constexpr double stripesAcross = 9;

//! The middle points of all neighbours, by vertex.
PositionMatrix neighbourMeans(const MeshData &mesh, const PositionMatrix &positions)
{
    PositionMatrix sums = PositionMatrix::Zero(positions.rows(), 3);
    std::vector<int> counts(static_cast<std::size_t>(positions.rows()), 0);
    for (const auto &triangle : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.vertexWeld[mesh.cornerVertex[triangle[k]]];
            const int b = mesh.vertexWeld[mesh.cornerVertex[triangle[(k + 1) % 3]]];
            sums.row(a) += positions.row(b);
            sums.row(b) += positions.row(a);
            ++counts[std::size_t(a)];
            ++counts[std::size_t(b)];
        }
    }
    for (Eigen::Index v = 0; v < sums.rows(); ++v) {
        if (counts[std::size_t(v)] > 0)
            sums.row(v) /= counts[std::size_t(v)];
        else
            sums.row(v) = positions.row(v);
    }
    return sums;
}

//! G. Taubin, "A signal processing approach to fair surface design", SIGGRAPH 1995.
PositionMatrix smoothed(const MeshData &mesh)
{
    PositionMatrix positions = mesh.positions;
    for (int i = 0; i < 12; ++i) {
        for (const double factor : {0.5, -0.52})
            positions += factor * (neighbourMeans(mesh, positions) - positions);
    }
    return positions;
}

//! Outwards, also where the faces look inwards.
PositionMatrix vertexNormals(const MeshData &mesh, const PositionMatrix &positions)
{
    double volume = 0;
    PositionMatrix normals = PositionMatrix::Zero(positions.rows(), 3);
    for (const auto &triangle : mesh.triangles) {
        std::array<int, 3> v;
        for (std::size_t k = 0; k < 3; ++k)
            v[k] = mesh.vertexWeld[mesh.cornerVertex[triangle[k]]];
        const Vec3 a = positions.row(v[0]), b = positions.row(v[1]), c = positions.row(v[2]);
        volume += a.dot(b.cross(c));
        for (const int vertex : v)
            normals.row(vertex) += (b - a).cross(c - a);
    }
    normals.rowwise().normalize();
    return volume < 0 ? PositionMatrix(-normals) : normals;
}

//! A number from 0 to 1 that belongs to a cell of a grid.
double hashed(const Eigen::Vector3i &cell, unsigned salt)
{
    unsigned h = salt * 0x9E3779B9U;
    for (int k = 0; k < 3; ++k)
        h = (h ^ static_cast<unsigned>(cell[k])) * 0x85EBCA6BU, h ^= h >> 15;
    return (h * 0xC2B2AE35U >> 8) / double(1U << 24);
}

//! The nearest of points that are spread at random, one in each cell, and how far away it is. S. Worley, "A
//! cellular texture basis function", SIGGRAPH 1996.
struct Scale
{
    double distance = std::numeric_limits<double>::max();
    double shade = 0; //!< 0 to 1, of its own
};

Scale nearestScale(const Vec3 &place)
{
    const Eigen::Vector3i middle = place.array().floor().cast<int>();
    Scale nearest;
    for (int i = 0; i < 27; ++i) {
        const Eigen::Vector3i cell = middle + Eigen::Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const Vec3 point = cell.cast<double>() + Vec3(hashed(cell, 1), hashed(cell, 2), hashed(cell, 3));
        if (const double distance = (point - place).norm(); distance < nearest.distance)
            nearest = {distance, hashed(cell, 4)};
    }
    return nearest;
}

double smoothStep(double low, double high, double value)
{
    const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace

Scene paintedModel(const MeshData &mesh, const Vec3 &up)
{
    const test::MeshPtr fine = bench::subdivided(*bench::subdivided(mesh));
    PositionMatrix positions = smoothed(*fine);
    const PositionMatrix normals = vertexNormals(*fine, positions);
    const Eigen::AlignedBox3d box(Vec3(positions.colwise().minCoeff()), Vec3(positions.colwise().maxCoeff()));
    const double size = box.diagonal().norm();
    Eigen::Index along = 0;
    box.sizes().maxCoeff(&along);
    std::vector<CornerColor> colors;
    for (Eigen::Index v = 0; v < positions.rows(); ++v) {
        const Vec3 place = positions.row(v), normal = normals.row(v);
        const Scale scale = nearestScale(scalesAcross / size * place);
        const double dome = 1 - smoothStep(0.1, 0.75, scale.distance);
        const Scale wave = nearestScale(0.12 * scalesAcross / size * place);
        const double turn = 2 * std::numbers::pi * stripesAcross * (place[along] - box.min()[along]) / size;
        const double stripe = smoothStep(-0.2, 0.5, std::sin(turn + 2.5 * wave.distance));
        const double belly = smoothStep(0.1, 0.6, -normal.dot(up));
        const Vec3 back = (1 - stripe) * Vec3(0.36, 0.17, 0.1) + stripe * Vec3(0.63, 0.55, 0.24);
        const Vec3 skin = (1 - belly) * back + belly * Vec3(0.85, 0.77, 0.6);
        const Vec3 color = (0.62 + 0.22 * scale.shade + 0.25 * dome) * skin;
        colors.push_back(CornerColor::fromSrgb(color.x(), color.y(), color.z()));
        if (normal.allFinite())
            positions.row(v) += 0.45 * size / scalesAcross * (dome - 0.5) * normal.transpose();
    }
    CornerColors ofCorners;
    for (const int vertex : fine->cornerVertex)
        ofCorners.push_back(colors[std::size_t(fine->vertexWeld[vertex])]);
    PositionMatrix welded(positions.rows(), 3);
    for (int v = 0; v < fine->vertexCount(); ++v)
        welded.row(v) = positions.row(fine->vertexWeld[v]);
    Scene scene;
    scene.mesh = MeshData::build(std::move(welded), fine->faceStart, fine->cornerVertex, fine->faceObject);
    scene.cornerColors = sharedColors(std::move(ofCorners), fine->cornerVertex.size());
    return scene;
}

QByteArray coloredObj(const Scene &scene)
{
    const MeshData &mesh = *scene.mesh;
    std::vector<CornerColor> colors(std::size_t(mesh.vertexCount()));
    for (int c = 0; c < mesh.cornerCount(); ++c)
        colors[std::size_t(mesh.cornerVertex[c])] = (*scene.cornerColors)[std::size_t(c)];
    QByteArray text;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        text += 'v';
        for (int k = 0; k < 3; ++k)
            text += ' ' + QByteArray::number(mesh.positions(v, k), 'g', 9);
        for (int k = 0; k < 3; ++k)
            text += ' ' + QByteArray::number(srgbFromLinear(colors[std::size_t(v)].value()[k]), 'f', 3);
        text += '\n';
    }
    for (int f = 0; f < mesh.faceCount(); ++f) {
        text += 'f';
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
            text += ' ' + QByteArray::number(mesh.cornerVertex[c] + 1);
        text += '\n';
    }
    return text;
}

} // namespace autocuts::figures
