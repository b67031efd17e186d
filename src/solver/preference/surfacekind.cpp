#include "solver/preference/surfacekind.h"

#include "solver/preference/creases.h"

namespace autocuts::preference {

namespace {

// Chosen by hand, so that the models of the tests are told as a person would.
constexpr double creaseShare = 0.01; // least share of creases in all edges of a hard surface,
constexpr double clearShare = 0.7;   // in its sharp edges,
constexpr double nearlyClear = 0.6;  // the same for a part of a model that is one,
constexpr double leastFlat = 0.01;   // and of flat polygons in its area: a stuffed toy has creases, too;
constexpr double flatShare = 0.5;    // or so many flat polygons that its edges do not matter
constexpr double smallShare = 0.1;   // of the area: a smaller part follows the whole
//! Angle up to which two polygons lie in one plane, radians.
constexpr double coplanar = 0.5 * std::numbers::pi / 180;

//! Sums of one connected component.
struct Sums
{
    double edges = 0, sharp = 0, creases = 0; // lengths
    double area = 0, flat = 0;

    void add(const Sums &other)
    {
        edges += other.edges;
        sharp += other.sharp;
        creases += other.creases;
        area += other.area;
        flat += other.flat;
    }
    //! \param clear least share of creases in the sharp edges
    bool isHard(double clear = clearShare) const
    {
        const bool creased = creases > 0 && creases >= creaseShare * edges && creases >= clear * sharp;
        return (creased && flat >= leastFlat * area) || (sharp > 0 && flat >= flatShare * area);
    }
};

} // namespace

SurfaceParts surfaceParts(const MeshData &mesh, SurfaceKind kind)
{
    SurfaceParts parts;
    parts.hard.assign(mesh.componentCount, kind == SurfaceKind::HardSurface);
    parts.hardShare = kind == SurfaceKind::HardSurface ? 1 : 0;
    if (kind != SurfaceKind::Auto)
        return parts;
    const std::vector<double> angles = dihedralAngles(mesh);
    const std::vector<bool> crease = creases(mesh, angles);
    std::vector<Sums> sums(mesh.componentCount);
    std::vector<bool> bends(mesh.faceCount(), false); // per face: over an edge that is not sharp
    for (std::size_t e = 0; e < angles.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if (pair.diagonal)
            continue;
        Sums &own = sums[mesh.component[pair.triangle[0]]];
        const bool isSharp = angles[e] >= sharpAngle;
        own.edges += pair.length;
        own.sharp += isSharp ? pair.length : 0;
        own.creases += crease[e] ? pair.length : 0;
        for (const int t : pair.triangle) {
            if (!isSharp && angles[e] > coplanar)
                bends[mesh.triangleFace[t]] = true;
        }
    }
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        Sums &own = sums[mesh.component[t]];
        own.area += mesh.triangleArea[t];
        own.flat += bends[mesh.triangleFace[t]] ? 0 : mesh.triangleArea[t];
    }
    Sums whole;
    for (const Sums &own : sums)
        whole.add(own);
    double hard = 0;
    for (int part = 0; part < mesh.componentCount; ++part) {
        // A small part has too few edges to tell, and one that nearly passes is like the rest of its model.
        const bool follows = sums[part].area < smallShare * whole.area || sums[part].isHard(nearlyClear);
        parts.hard[part] = sums[part].isHard() || (follows && whole.isHard());
        hard += parts.hard[part] ? sums[part].area : 0;
    }
    parts.hardShare = mesh.area > 0 ? hard / mesh.area : 0;
    return parts;
}

} // namespace autocuts::preference
