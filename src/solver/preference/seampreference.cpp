#include "solver/preference/seampreference.h"

#include "model/plain/edgeangles.h"
#include "solver/base/constant.h"
#include "solver/preference/creases.h"
#include "solver/preference/openness.h"
#include "solver/preference/surfacekind.h"
#include "solver/rigid/stiffregions.h"

#include <algorithm>
#include <cmath>

namespace autocuts::preference {

namespace {

// Numbers in this file without another source were chosen by hand.

//! At full strength a fully open edge costs e^3 (about 20) times as much as a hidden one: natural logarithm
//! of that ratio.
AUTOCUTS_CONSTANT(double, visibilityRange, 3);

//! Factor on the cost of a seam inside of a flat region: nobody tears a flat face. Measured in standard:
//! with 1.5 the faces of plate stay whole, seams inside of those of truck are a quarter as long, and gear has
//! shorter seams, too. With 1.35 truck keeps longer seams, with 2.5 gear does.
AUTOCUTS_CONSTANT(double, tearFactor, 1.5);
constexpr double flatAngle = 0.0175; // one degree, twice what rigid regions allow: room for rounding

//! Share of the area from which a mesh that is judged as a whole is like these parts.
constexpr double mostOfIt = 0.5;

//! Share of the area from which the flat regions of a rough surface are no accident. Measured: up to .092 on
//! noisy surfaces without any that are meant.
constexpr double flatByAccident = 0.1;

//! Per connected component: true where a mode applies. Empty: nowhere.
template <typename Recognise>
std::vector<bool> partsFor(CreaseMode mode, const MeshData &mesh, Recognise recognise)
{
    if (mode == CreaseMode::Off)
        return {};
    std::vector<bool> parts =
        mode == CreaseMode::On ? std::vector<bool>(mesh.componentCount, true) : recognise();
    return std::find(parts.begin(), parts.end(), true) != parts.end() ? parts : std::vector<bool>();
}

bool sameAims(const SolveSettings &a, const SolveSettings &b)
{
    return a.surface == b.surface && a.creases == b.creases && a.creaseStrength == b.creaseStrength &&
           a.visibility == b.visibility;
}

//! Scales the factors so that the dearest edge has factor 1: the balance with the distortion keeps its scale.
void normalize(const MeshData &mesh, std::vector<double> &factors)
{
    double most = 0;
    for (std::size_t e = 0; e < factors.size(); ++e) {
        if (!mesh.edgePairs[e].diagonal)
            most = std::max(most, factors[e]);
    }
    for (std::size_t e = 0; e < factors.size(); ++e)
        factors[e] = most > 0 && !mesh.edgePairs[e].diagonal ? factors[e] / most : 1;
}

//! The edges between coplanar triangles of one region: also within regions that unroll, at whose other edges
//! a seam is as good as anywhere.
std::vector<int> edgesInFlatRegions(const MeshData &mesh, const RigidRegions &regions)
{
    std::vector<int> inFlat;
    const std::vector<double> angles = edgeAngles(mesh);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const auto [a, b] = mesh.edgePairs[e].triangle;
        if (regions.region[a] >= 0 && regions.region[a] == regions.region[b] && angles[e] < flatAngle)
            inFlat.push_back(static_cast<int>(e));
    }
    return inFlat;
}

//! Nothing on a rough surface that has hardly any flat regions.
std::shared_ptr<const RigidRegions> rigidRegions(const std::shared_ptr<const MeshData> &mesh)
{
    const std::vector<double> angles = edgeAngles(*mesh);
    std::shared_ptr<const RigidRegions> regions = rigid::rigidRegions(mesh, creases(*mesh, angles));
    return regions && regions->share < flatByAccident && isRough(*mesh, angles) ? nullptr : regions;
}

} // namespace

std::vector<bool> creasedParts(const SolveSettings &settings, const MeshData &mesh)
{
    return partsFor(settings.creases, mesh, [&] { return surfaceParts(mesh, settings.surface).creased; });
}

std::vector<bool> alignedParts(const SolveSettings &settings, const MeshData &mesh)
{
    return partsFor(settings.align, mesh, [&] { return surfaceParts(mesh, settings.surface).hard; });
}

SolveSettings decidedForAll(SolveSettings settings, const std::shared_ptr<const MeshData> &mesh)
{
    // A coarser version is smoother, so that it may no longer count as rough.
    if (settings.flat == FlatMode::Rigid && isRough(*mesh, edgeAngles(*mesh)) && !rigidRegions(mesh))
        settings.flat = FlatMode::Free;
    if (settings.creases != CreaseMode::Auto && settings.align != CreaseMode::Auto)
        return settings;
    const SurfaceParts parts = surfaceParts(*mesh, settings.surface);
    const auto decide = [](CreaseMode &mode, double share) {
        if (mode == CreaseMode::Auto)
            mode = share >= mostOfIt ? CreaseMode::On : CreaseMode::Off;
    };
    decide(settings.creases, parts.creasedShare);
    decide(settings.align, parts.hardShare);
    return settings;
}

const std::vector<double> &SeamPreference::factors(const Snapshot &snapshot, int threads)
{
    const SolveSettings &settings = snapshot.settings;
    if (mMesh && samePolygons(*mMesh, *snapshot.mesh) && sameAims(settings, mSettings))
        return mFactors;
    mMesh = snapshot.mesh;
    mSettings = settings;
    mFactors.clear();
    const std::vector<bool> creased =
        settings.creaseStrength > 0 ? creasedParts(settings, *mMesh) : std::vector<bool>();
    if (!creased.empty()) {
        mFactors = creaseFactors(*mMesh, settings.creaseStrength);
        for (std::size_t e = 0; e < mFactors.size(); ++e) {
            if (!creased[mMesh->component[mMesh->edgePairs[e].triangle[0]]])
                mFactors[e] = 1;
        }
    }
    if (settings.visibility > 0) {
        const std::vector<double> openness = edgeOpenness(*mMesh, threads);
        mFactors.resize(openness.size(), 1);
        for (std::size_t e = 0; e < openness.size(); ++e)
            mFactors[e] *= std::exp(-visibilityRange * settings.visibility * (1 - openness[e]));
    }
    normalize(*mMesh, mFactors);
    return mFactors;
}

Snapshot SeamPreference::applied(const Snapshot &snapshot, int threads)
{
    Snapshot result = snapshot;
    const SolveSettings &settings = snapshot.settings;
    if (std::vector<bool> aligned = alignedParts(settings, *snapshot.mesh); !aligned.empty())
        result.aligned = std::make_shared<const std::vector<bool>>(std::move(aligned));
    if (settings.flat == FlatMode::Rigid && settings.surface != SurfaceKind::Organic &&
        settings.energy == DistortionEnergy::SymmetricDirichlet) {
        if (mRigidMesh != snapshot.mesh) {
            mRigidMesh = snapshot.mesh;
            mRigid = rigidRegions(snapshot.mesh);
            mInFlat = mRigid ? edgesInFlatRegions(*snapshot.mesh, *mRigid) : std::vector<int>();
        }
        result.rigid = mRigid;
    }
    const std::vector<double> &factor = factors(snapshot, threads);
    const bool hasTears = result.rigid && !mInFlat.empty();
    if (factor.empty() && !hasTears)
        return result;
    std::vector<double> &weight = result.editSteering().pairWeight;
    weight.resize(snapshot.mesh->cornerPairCount(), 1);
    const auto multiply = [&weight](std::size_t e, double by) {
        weight[2 * e] *= by;
        weight[2 * e + 1] *= by;
    };
    for (std::size_t e = 0; e < factor.size(); ++e)
        multiply(e, factor[e]);
    for (std::size_t i = 0; hasTears && i < mInFlat.size(); ++i)
        multiply(mInFlat[i], tearFactor);
    return result;
}

} // namespace autocuts::preference
