#include "solver/preference/surfacekind.h"

#include "model/plain/edgeangles.h"
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
constexpr double mostlyHard = 0.5;   // share of the area, see isMostlyHard()
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
    bool isCreased(double clear = clearShare) const
    {
        return (creases > 0 && creases >= creaseShare * edges && creases >= clear * sharp) ||
               (sharp > 0 && flat >= flatShare * area);
    }
    bool isFlatInPlaces() const { return flat >= leastFlat * area; }
};

} // namespace

SurfaceParts surfaceParts(const MeshData &mesh, SurfaceKind kind)
{
    SurfaceParts parts;
    parts.creased.assign(mesh.componentCount, kind == SurfaceKind::HardSurface);
    parts.hard = parts.creased;
    parts.creasedShare = parts.hardShare = kind == SurfaceKind::HardSurface ? 1 : 0;
    if (kind != SurfaceKind::Auto)
        return parts;
    const std::vector<double> angles = edgeAngles(mesh);
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
    const double share = whole.area > 0 ? 1 / whole.area : 0;
    for (int part = 0; part < mesh.componentCount; ++part) {
        const Sums &own = sums[part];
        // A small part has too few edges to tell, and one that nearly passes is like the rest of its model.
        const bool isSmall = own.area < smallShare * whole.area;
        const bool follows = isSmall || own.isCreased(nearlyClear);
        parts.creased[part] = own.isCreased() || (follows && whole.isCreased());
        parts.hard[part] =
            parts.creased[part] && (own.isFlatInPlaces() || (isSmall && whole.isFlatInPlaces()));
        parts.creasedShare += parts.creased[part] ? share * own.area : 0;
        parts.hardShare += parts.hard[part] ? share * own.area : 0;
    }
    return parts;
}

bool isMostlyHard(const MeshData &mesh, SurfaceKind kind)
{
    return surfaceParts(mesh, kind).hardShare >= mostlyHard;
}

} // namespace autocuts::preference
