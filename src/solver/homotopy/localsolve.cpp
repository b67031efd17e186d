#include "solver/homotopy/localsolve.h"

#include "model/plain/texelweights.h"
#include "solver/base/cornerat.h"
#include "solver/base/soup.h"
#include "solver/base/springladder.h"
#include "solver/energy/constraintterms.h"
#include "solver/energy/distortion.h"
#include "solver/newton/minimizer.h"
#include "solver/newton/newtondirection.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace autocuts::homotopy {

namespace {

//! Springs that pull the points to their targets, and the steps with each; then the most steps of the
//! relaxation and the relative change of energy at which it ends. Chosen by hand.
constexpr double firstPull = 1;
constexpr int pulls = 8; // stiffness 1, 10, ... 1e7
constexpr int stepsPerPull = 8;
constexpr int mostSteps = 80;
constexpr double stall = 1e-7;
//! Each triangle must keep this share of its area at rest when points are put onto their targets. Chosen by
//! hand.
constexpr double smallestDeterminant = 1e-4;

//! The faces to solve for, as a mesh of their own in solver units.
class Part
{
public:
    Part(const MeshData &mesh, const UvMatrix &uv, const LocalProblem &problem)
        : mMesh(mesh), mUv(uv), mProblem(problem), mHeld(mesh.cornerCount())
    {
        for (int point : problem.held)
            mHeld[point] = true;
        chooseFaces();
        if (mFaces.empty())
            return;
        build();
    }

    bool canMove() const { return mSoup && mMap.count > 0; }
    int folded() const { return mFolded; }
    const std::shared_ptr<const Soup> &soup() const { return mSoup; }
    const newton::UnknownMap &unknowns() const { return mMap; }
    std::vector<double> &x() { return mX; }

    //! Springs to the targets, each on one corner of its point.
    std::vector<Pin> pins(double weight) const
    {
        std::vector<Pin> pins;
        for (const auto &[point, place] : mProblem.targets) {
            if (const auto corners = mSoupCorners.find(point); corners != mSoupCorners.end())
                pins.push_back({corners->second.front(), toSolver(place), false, weight});
        }
        return pins;
    }

    //! Puts the points onto their targets. Returns false and changes nothing when that would flip a triangle.
    bool reachTargets()
    {
        std::vector<double> x = mX;
        for (const auto &[point, place] : mProblem.targets) {
            const auto corners = mSoupCorners.find(point);
            if (corners == mSoupCorners.end())
                continue;
            for (int soupCorner : corners->second)
                cornerAt(x, soupCorner) = toSolver(place);
        }
        for (int t = 0; t < mSoup->triangleCount(); ++t) {
            if (!(jacobianDeterminant(*mSoup, x.data(), t) > smallestDeterminant))
                return false;
        }
        mX = std::move(x);
        for (const auto &[point, place] : mProblem.targets)
            mHeld[point] = true;
        numberUnknowns();
        return true;
    }

    UvMatrix result() const
    {
        UvMatrix uv = mUv;
        std::map<int, Vec2> exact(mProblem.targets.begin(), mProblem.targets.end());
        for (int c = 0; c < mMesh.cornerCount(); ++c) {
            const int point = mProblem.pointOfCorner[c];
            const auto corners = mSoupCorners.find(point);
            if (corners == mSoupCorners.end())
                continue;
            if (const auto target = exact.find(point); target != exact.end()) {
                uv.row(c) = target->second.transpose();
            } else if (!mHeld[point]) {
                uv.row(c) = toTexture(cornerAt(mX, corners->second.front())).transpose();
            }
        }
        return uv;
    }

private:
    Vec2 toSolver(const Vec2 &uv) const { return {mSide * mScale * uv.x(), mScale * uv.y()}; }
    Vec2 toTexture(const Vec2 &x) const { return {mSide * x.x() / mScale, x.y() / mScale}; }
    Vec2 placeOf(int corner) const { return mUv.row(mProblem.pointOfCorner[corner]).transpose(); }
    double signedArea(int triangle) const
    {
        const auto &c = mMesh.triangles[triangle];
        return 0.5 * cross2(placeOf(c[0]), placeOf(c[1]), placeOf(c[2]));
    }

    //! Chooses the faces that can be solved. Faces with an orientation opposite to the others are held; faces
    //! without area or UVs are left out.
    void chooseFaces()
    {
        std::vector<char> wanted(mMesh.faceCount()), usable(mMesh.faceCount(), 1), folded(mMesh.faceCount());
        for (int face : mProblem.faces)
            wanted[face] = 1;
        double sum = 0;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const double area = signedArea(t);
            if (wanted[mMesh.triangleFace[t]] && std::isfinite(area))
                sum += area;
        }
        mSide = sum < 0 ? -1 : 1;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const int face = mMesh.triangleFace[t];
            if (mMesh.triangleDegenerate[t] || !std::isfinite(signedArea(t)))
                usable[face] = 0;
            else if (!(mSide * signedArea(t) > 0))
                folded[face] = 1;
        }
        for (int face : mProblem.faces) {
            if (!usable[face])
                continue;
            if (!folded[face]) {
                mFaces.push_back(face);
                continue;
            }
            ++mFolded;
            for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c)
                mHeld[mProblem.pointOfCorner[c]] = true;
        }
    }

    void build()
    {
        std::map<int, int> vertexOf;
        std::vector<int> starts{0}, cornerVertex;
        for (int face : mFaces) {
            for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c) {
                const int vertex = mMesh.cornerVertex[c];
                cornerVertex.push_back(
                    vertexOf.try_emplace(vertex, static_cast<int>(vertexOf.size())).first->second);
                mCorners.push_back(c);
            }
            starts.push_back(static_cast<int>(cornerVertex.size()));
        }
        PositionMatrix positions(vertexOf.size(), 3);
        for (const auto &[vertex, row] : vertexOf)
            positions.row(row) = mMesh.positions.row(vertex);
        const auto part = MeshData::build(std::move(positions), std::move(starts), std::move(cornerVertex),
                                          std::vector<int>(mFaces.size(), 0));
        std::vector<double> texelWeight;
        for (int face : mFaces)
            texelWeight.push_back(mMesh.texelWeight.empty() ? 1 : mMesh.texelWeight[face]);
        mSoup = Soup::build(withTexelWeights(part, storedTexelWeights(std::move(texelWeight))));
        mScale = mSoup->scale * worldPerTexture();
        mX.resize(mSoup->coordinateCount());
        for (int s = 0; s < part->soupCornerCount(); ++s) {
            const int corner = mCorners[part->cornerOfSoup(s)];
            mSoupCorners[mProblem.pointOfCorner[corner]].push_back(s);
            cornerAt(mX, s) = toSolver(placeOf(corner));
        }
        numberUnknowns();
    }

    double worldPerTexture() const
    {
        const std::vector<int> &faces = mProblem.reference.empty() ? mProblem.faces : mProblem.reference;
        double area = 0, uvArea = 0;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (!std::binary_search(faces.begin(), faces.end(), mMesh.triangleFace[t]))
                continue;
            area += mMesh.targetArea(t);
            if (const double own = std::abs(signedArea(t)); std::isfinite(own))
                uvArea += own;
        }
        return std::sqrt(area / uvArea);
    }

    void numberUnknowns()
    {
        mMap.unknown.assign(mSoup->mesh->soupCornerCount(), -1);
        mMap.count = 0;
        for (const auto &[point, corners] : mSoupCorners) {
            if (mHeld[point])
                continue;
            for (int s : corners)
                mMap.unknown[s] = mMap.count;
            ++mMap.count;
        }
    }

    const MeshData &mMesh;
    const UvMatrix &mUv;
    const LocalProblem &mProblem;
    std::vector<char> mHeld; //!< per point
    std::vector<int> mFaces,
        mCorners; //!< the chosen faces, and the mesh corner of each of their corners
    int mFolded = 0;
    double mSide = 1, mScale = 1; //!< orientation of the faces (-1: mirrored); texture space to solver units
    std::shared_ptr<const Soup> mSoup;
    std::map<int, std::vector<int>> mSoupCorners; //!< of each point
    newton::UnknownMap mMap;
    std::vector<double> mX;
};

//! Pulls the points with stiffer and stiffer springs until they can be put onto their targets.
bool pullToTargets(Part &part, const energy::DistortionTerm &distortion, const JobContext &job)
{
    int pull = 0;
    return climbSprings(firstPull, pulls, [&](double weight) {
        if (job.stopped())
            return false;
        const energy::PinTerm springs(part.pins(weight));
        newton::Minimizer minimizer(part.soup(), newton::makeExactDirection(part.soup(), part.unknowns()));
        minimizer.setTerms({&distortion, &springs});
        for (int i = 0; i < stepsPerPull && !job.stopped(); ++i)
            minimizer.step(part.x());
        job.report(0.5 * ++pull / pulls);
        return part.reachTargets();
    });
}

} // namespace

LocalSolution solveLocally(const MeshData &mesh, const UvMatrix &uv, const LocalProblem &problem,
                           const JobContext &job)
{
    LocalSolution solution;
    solution.uv = uv;
    Part part(mesh, uv, problem);
    solution.foldedFaces = part.folded();
    if (!part.canMove())
        return solution;
    const auto distortion = energy::makeDistortionTerm(part.soup(), DistortionEnergy::SymmetricDirichlet);
    distortion->setFactor(1);
    solution.before = distortion->value(part.x());
    const bool reached = problem.targets.empty() || pullToTargets(part, *distortion, job);
    if (reached && part.unknowns().count > 0) {
        newton::Minimizer minimizer(part.soup(), newton::makeExactDirection(part.soup(), part.unknowns()));
        minimizer.setTerms({distortion.get()});
        for (int i = 0; i < mostSteps && !job.stopped(); ++i) {
            const newton::Minimizer::Step step = minimizer.step(part.x());
            job.report(0.5 + 0.5 * (i + 1) / mostSteps);
            if (step.before - step.after <= stall * std::abs(step.before))
                break;
        }
    }
    solution.after = distortion->value(part.x());
    solution.outcome = job.stopped() ? LocalSolution::Outcome::Cancelled
                       : reached     ? LocalSolution::Outcome::Solved
                                     : LocalSolution::Outcome::Stuck;
    if (reached)
        solution.uv = part.result();
    if (job.stopped())
        solution.uv = uv;
    return solution;
}

} // namespace autocuts::homotopy
