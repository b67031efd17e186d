#include "solver/unwrap/alikeparts.h"

#include "model/plain/copymatcher.h"
#include "solver/base/cornerat.h"
#include "solver/base/soup.h"
#include "solver/preference/seampreference.h"
#include "solver/search/seamtrial.h"
#include "solver/search/trianglekernel.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace autocuts::unwrap {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Areas of copies differ by less than this share. Only saves time: lengths decide.
constexpr double areaTolerance = 0.15;
//! Share of a part's area in rigid regions from which near copies of it may have its cuts.
constexpr double rigidPartShare = 0.95;
//! Newton steps that relax near copies, at most.
constexpr int nearCopySteps = 30;
//! How much more the seams may cost where all copies get the map of one.
constexpr double dearestUnified = 1.05;

//! True when alike parts may be solved once.
bool suits(const Snapshot &snapshot)
{
    const SolveSettings &settings = snapshot.settings;
    return settings.alike != AlikeMode::Off && settings.seams == SeamMode::Free && settings.visibility == 0 &&
           settings.start != StartMode::ExistingUv && !snapshot.placesIslands() &&
           snapshot.mesh->componentCount > 1;
}

} // namespace

//! Sorts the connected parts by what they are copies of.
class AlikeParts::Finder
{
public:
    Finder(const Snapshot &snapshot, const JobContext &job)
        : mSnapshot(snapshot), mJob(job), mMesh(*snapshot.mesh), mPartOfFace(mMesh.faceCount(), -1),
          mFaces(mMesh.componentCount), mAlone(mMesh.componentCount, false), mArea(mMesh.componentCount, 0),
          mCopies(mMesh.componentCount, 1), mIsCopy(mMesh.componentCount, false),
          mIsNear(mMesh.componentCount, false), mSourceCorner(mMesh.cornerCount()),
          mSourceEdge(mMesh.edgePairs.size()), mMirrored(mMesh.faceCount(), false)
    {
        std::iota(mSourceCorner.begin(), mSourceCorner.end(), 0);
        std::iota(mSourceEdge.begin(), mSourceEdge.end(), 0);
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            mPartOfFace[face] = mMesh.component[mMesh.faceTriangle[face]];
            mFaces[mPartOfFace[face]].push_back(face);
        }
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            mArea[mMesh.component[t]] += mMesh.triangleArea[t];
            // A polygon in two parts.
            if (mMesh.component[t] != mPartOfFace[mMesh.triangleFace[t]])
                mAlone[mMesh.component[t]] = mAlone[mPartOfFace[mMesh.triangleFace[t]]] = true;
        }
        leaveSteeredAlone();
    }

    std::optional<AlikeParts> find()
    {
        std::map<std::pair<std::size_t, int>, std::vector<int>> bySize; // faces and corners: parts
        for (int part = 0; part < mMesh.componentCount; ++part) {
            int corners = 0;
            for (const int face : mFaces[part])
                corners += mMesh.faceStart[face + 1] - mMesh.faceStart[face];
            if (!mAlone[part] && !mFaces[part].empty())
                bySize[{mFaces[part].size(), corners}].push_back(part);
        }
        std::erase_if(bySize, [](const auto &entry) { return entry.second.size() < 2; });
        if (bySize.empty())
            return std::nullopt;
        const MeshAdjacency adjacency(mMesh);
        CopyMatcher matcher(mMesh, adjacency, mPartOfFace, mFaces);
        for (const auto &[size, parts] : bySize)
            sortOut(parts, adjacency, matcher);
        if (mJob.stopped() || std::find(mIsCopy.begin(), mIsCopy.end(), true) == mIsCopy.end())
            return std::nullopt;
        return result();
    }

private:
    void leaveSteeredAlone()
    {
        const Steering &steering = *mSnapshot.steering;
        const auto leave = [&](std::size_t edge) {
            mAlone[mMesh.component[mMesh.edgePairs[edge].triangle[0]]] = true;
        };
        for (std::size_t p = 0; p < steering.pairState.size(); ++p) {
            if (steering.pairState[p] != PairState::Free)
                leave(p / 2);
        }
        for (std::size_t p = 0; p < steering.pairWeight.size(); ++p) {
            if (steering.pairWeight[p] != 1)
                leave(p / 2);
        }
        for (const std::vector<int> &loop : steering.straightLoops) {
            for (const int edge : loop)
                leave(edge);
        }
    }

    //! True for a part that keeps its shape: near copies of it have the same distortion, none.
    bool isRigid(int part)
    {
        if (mIsRigid.empty())
            findRigidParts();
        return mIsRigid[part];
    }

    void findRigidParts()
    {
        mIsRigid.assign(mMesh.componentCount, false);
        const Snapshot preferred = preference::SeamPreference().applied(mSnapshot);
        if (!preferred.rigid)
            return;
        std::vector<double> rigid(mMesh.componentCount, 0);
        for (int t = 0; t < mMesh.triangleCount(); ++t)
            rigid[mMesh.component[t]] += preferred.rigid->region[t] >= 0 ? mMesh.triangleArea[t] : 0;
        for (int part = 0; part < mMesh.componentCount; ++part)
            mIsRigid[part] = rigid[part] >= rigidPartShare * mArea[part];
    }

    //! \param parts with the same numbers of faces and corners, ascending
    void sortOut(const std::vector<int> &parts, const MeshAdjacency &adjacency, CopyMatcher &matcher)
    {
        struct Kind
        {
            int part;
            std::vector<std::uint64_t> colours, sorted;
            std::vector<double> lengths;
        };
        std::vector<Kind> kinds;
        for (const int part : parts) {
            if (mJob.stopped())
                return;
            Kind kind{part, matcher.colours(part), {}, {}};
            kind.sorted = kind.colours;
            std::sort(kind.sorted.begin(), kind.sorted.end());
            kind.lengths = matcher.sideLengths(part);
            const auto isCopy = [&](CopyLikeness likeness) {
                return std::any_of(kinds.begin(), kinds.end(), [&](const Kind &other) {
                    return std::abs(mArea[other.part] - mArea[part]) <= areaTolerance * mArea[part] &&
                           other.sorted == kind.sorted &&
                           CopyMatcher::sameLengths(other.lengths, kind.lengths, likeness) &&
                           (likeness == CopyLikeness::Exact || isRigid(part)) &&
                           copies(other.part, part, other.colours, kind.colours, likeness, adjacency,
                                  matcher);
                });
            };
            if (!isCopy(CopyLikeness::Exact) && !isCopy(CopyLikeness::Near))
                kinds.push_back(std::move(kind));
        }
    }

    //! When one part is a copy of another one: notes so. \returns whether it is
    bool copies(int from, int to, const std::vector<std::uint64_t> &fromColours,
                const std::vector<std::uint64_t> &toColours, CopyLikeness likeness,
                const MeshAdjacency &adjacency, CopyMatcher &matcher)
    {
        for (const bool mirrored : {false, true}) {
            if (!matcher.match(from, to, mirrored, fromColours, toColours, likeness) ||
                !sameTexels(to, adjacency, matcher) || !samePairs(to, adjacency, matcher))
                continue;
            for (const int face : mFaces[to]) {
                mMirrored[face] = mirrored;
                for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c) {
                    mSourceCorner[c] = matcher.sourceCorner(c);
                    const auto edge = static_cast<std::size_t>(adjacency.edgeOfCorner(c));
                    if (edge < mSourceEdge.size())
                        mSourceEdge[edge] = adjacency.edgeOfCorner(matcher.sourceSide(c));
                }
            }
            mIsCopy[to] = true;
            mIsNear[to] = likeness == CopyLikeness::Near;
            ++mCopies[from];
            return true;
        }
        return false;
    }

    //! True when matching polygon sides are both paired, or both not.
    bool samePairs(int part, const MeshAdjacency &adjacency, const CopyMatcher &matcher) const
    {
        const auto isPaired = [&](int corner) {
            return adjacency.edgeOfCorner(corner) < static_cast<int>(mMesh.edgePairs.size());
        };
        return std::all_of(mFaces[part].begin(), mFaces[part].end(), [&](int face) {
            for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c) {
                if (isPaired(c) != isPaired(matcher.sourceSide(c)))
                    return false;
            }
            return true;
        });
    }

    bool sameTexels(int part, const MeshAdjacency &adjacency, const CopyMatcher &matcher) const
    {
        const std::vector<double> &weight = mMesh.texelWeight;
        return weight.empty() || std::all_of(mFaces[part].begin(), mFaces[part].end(), [&](int face) {
                   return weight[face] ==
                          weight[adjacency.faceOfCorner(matcher.sourceCorner(mMesh.faceStart[face]))];
               });
    }

    AlikeParts result()
    {
        AlikeParts found;
        found.mWhole = mSnapshot.mesh;
        std::vector<bool> faces(mMesh.faceCount());
        for (int face = 0; face < mMesh.faceCount(); ++face)
            faces[face] = !mIsCopy[mPartOfFace[face]];
        MeshPart part = partOf(mMesh, faces);
        const auto mesh = std::make_shared<MeshData>(*part.mesh);
        for (const int face : part.face)
            mesh->faceCopies.push_back(mCopies[mPartOfFace[face]]);
        part.mesh = mesh;
        found.mSnapshot.mesh = mesh;
        found.mSnapshot.settings = mSnapshot.settings;
        found.mSnapshot.settings.alike = AlikeMode::Off;
        found.mSnapshot.settings.symmetry = SymmetryMode::Off;
        addSteering(part, found.mSnapshot);
        found.mPart = std::move(part);
        found.mSourceCorner = inPart(found.mPart.corner, mSourceCorner);
        found.mSourceEdge = inPart(found.mPart.edgePair, mSourceEdge);
        found.mMirrored = std::move(mMirrored);
        found.mSettings = mSnapshot.settings;
        for (int face = 0; face < mMesh.faceCount(); ++face)
            faces[face] = mIsNear[mPartOfFace[face]];
        if (std::find(faces.begin(), faces.end(), true) != faces.end())
            found.mNear = partOf(mMesh, faces);
        return found;
    }

    //! Seams that stand for those of copies cost as much.
    void addSteering(const MeshPart &part, Snapshot &snapshot) const
    {
        const Steering &whole = *mSnapshot.steering;
        const double perCopy = Soup::build(part.mesh)->perCopy;
        Steering &steering = snapshot.editSteering();
        for (std::size_t e = 0; e < part.edgePair.size(); ++e) {
            const int copies = part.mesh->copiesOf(part.mesh->edgePairs[e].triangle[0]);
            for (int end = 0; end < 2; ++end) {
                const std::size_t pair = 2 * static_cast<std::size_t>(part.edgePair[e]) + end;
                if (!whole.pairState.empty())
                    steering.pairState.push_back(whole.pairState[pair]);
                steering.pairWeight.push_back(perCopy * copies *
                                              (whole.pairWeight.empty() ? 1 : whole.pairWeight[pair]));
            }
        }
    }

    //! \param all of the whole mesh, by number in the part \param source by number in the whole mesh
    static std::vector<int> inPart(const std::vector<int> &all, std::vector<int> source)
    {
        std::vector<int> number(source.size(), -1);
        for (std::size_t i = 0; i < all.size(); ++i)
            number[all[i]] = static_cast<int>(i);
        for (int &one : source)
            one = number[one];
        return source;
    }

    const Snapshot &mSnapshot;
    const JobContext &mJob;
    const MeshData &mMesh;
    std::vector<int> mPartOfFace;
    std::vector<std::vector<int>> mFaces; //!< per part
    std::vector<bool> mAlone;             //!< per part: never a copy
    std::vector<double> mArea;            //!< per part
    std::vector<int> mCopies;             //!< per part: how many there are, itself included
    std::vector<bool> mIsCopy;            //!< per part: of one with a lower number
    std::vector<bool> mIsNear;            //!< per part: it is not an exact copy
    std::vector<bool> mIsRigid;           //!< per part: flat faces, or what unrolls; empty until asked for
    std::vector<int> mSourceCorner, mSourceEdge;
    std::vector<bool> mMirrored; //!< per face
};

std::optional<AlikeParts> AlikeParts::of(const Snapshot &snapshot, const JobContext &job)
{
    if (!suits(snapshot))
        return std::nullopt;
    return Finder(snapshot, job).find();
}

SeamedMap AlikeParts::expanded(const SeamedMap &map, const JobContext &job) const
{
    const MeshData &mesh = *mWhole;
    std::vector<Vec2> place(mPart.corner.size());
    for (int c = 0; c < mPart.mesh->soupCornerCount(); ++c)
        place[mPart.mesh->cornerOfSoup(c)] = cornerAt(map.x, c);
    // From solver units of the part to those of the whole mesh.
    const double unit = std::sqrt(mPart.mesh->area / mesh.area);
    SeamedMap whole;
    whole.x.resize(2 * static_cast<std::size_t>(mesh.soupCornerCount()));
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        Vec2 own = unit * place[mSourceCorner[mesh.cornerOfSoup(c)]];
        if (mMirrored[mesh.triangleFace[c / 3]])
            own.x() = -own.x();
        cornerAt(whole.x, c) = own;
    }
    whole.cut.resize(mesh.edgePairs.size());
    for (std::size_t e = 0; e < whole.cut.size(); ++e)
        whole.cut[e] = !mesh.edgePairs[e].diagonal && map.cut[mSourceEdge[e]];
    if (mNear.mesh)
        relaxNearCopies(whole, job);
    return whole;
}

double AlikeParts::seamLength(const CutFlags &cut, const Soup &whole) const
{
    double length = 0;
    for (std::size_t e = 0; e < mWhole->edgePairs.size(); ++e) {
        if (!mWhole->edgePairs[e].diagonal && cut[mSourceEdge[e]])
            length += whole.pairLength[2 * e];
    }
    return length;
}

//! Per connected component of the whole mesh: the component of the part that it is a copy of.
std::vector<int> AlikeParts::kinds() const
{
    std::vector<int> ofCorner(mPart.mesh->cornerCount(), -1);
    for (int c = 0; c < mPart.mesh->soupCornerCount(); ++c)
        ofCorner[mPart.mesh->cornerOfSoup(c)] = mPart.mesh->component[c / 3];
    std::vector<int> kinds(mWhole->componentCount, -1);
    for (int c = 0; c < mWhole->soupCornerCount(); ++c)
        kinds[mWhole->component[c / 3]] = ofCorner[mSourceCorner[mWhole->cornerOfSoup(c)]];
    return kinds;
}

//! The map of the part, with the maps of chosen copies. \param donor per component of the part: the copy
SeamedMap AlikeParts::chosenMap(const SeamedMap &map, const std::vector<int> &kind,
                                const std::vector<int> &donor) const
{
    const auto gives = [&](int triangle) {
        const int component = mWhole->component[triangle];
        return donor[kind[component]] == component;
    };
    const double unit = std::sqrt(mPart.mesh->area / mWhole->area);
    std::vector<Vec2> place(mPart.corner.size());
    for (int c = 0; c < mWhole->soupCornerCount(); ++c) {
        if (!gives(c / 3))
            continue;
        Vec2 &own = place[mSourceCorner[mWhole->cornerOfSoup(c)]];
        own = cornerAt(map.x, c) / unit;
        if (mMirrored[mWhole->triangleFace[c / 3]])
            own.x() = -own.x();
    }
    SeamedMap part;
    part.x.resize(2 * static_cast<std::size_t>(mPart.mesh->soupCornerCount()));
    for (int c = 0; c < mPart.mesh->soupCornerCount(); ++c)
        cornerAt(part.x, c) = place[mPart.mesh->cornerOfSoup(c)];
    part.cut.assign(mPart.mesh->edgePairs.size(), false);
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        if (map.cut[e] && gives(mWhole->edgePairs[e].triangle[0]) && mSourceEdge[e] >= 0)
            part.cut[mSourceEdge[e]] = true;
    }
    return part;
}

SeamedMap AlikeParts::unified(const SeamedMap &map, const Snapshot &preferred, double mu, double bound,
                              const JobContext &job) const
{
    const std::shared_ptr<const Soup> soup = Soup::build(mWhole);
    const std::vector<int> kind = kinds();
    std::vector<double> energy(mWhole->componentCount, 0), cost(mWhole->componentCount, 0);
    for (int t = 0; t < soup->triangleCount(); ++t) {
        const double own =
            search::triangleEnergy(&map.x[6 * static_cast<std::size_t>(t)], soup->basis[t]) - 4;
        energy[mWhole->component[t]] +=
            soup->weight[t] * (preferred.rigid ? preferred.rigid->stiffness[t] : 1) * own;
    }
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        if (map.cut[e])
            cost[mWhole->component[mWhole->edgePairs[e].triangle[0]]] +=
                preferred.edgeWeight(e) * soup->pairLength[2 * e];
    }
    // The map of a near copy would be stretched on the others.
    std::vector<bool> gives(mWhole->componentCount, true);
    for (const int face : mNear.face)
        gives[mWhole->component[mWhole->faceTriangle[face]]] = false;
    const double most = dearestUnified * map.seamCost(*soup, preferred);
    // The copies with the shortest seams where the bound allows them, else those with less and less stretch.
    for (const double stretch : {0 / mu, 1 / mu, 4 / mu, 16 / mu}) {
        std::vector<int> donor(mPart.mesh->componentCount, -1);
        const auto score = [&](int component) { return cost[component] + stretch * energy[component]; };
        for (int component = 0; component < mWhole->componentCount; ++component) {
            int &best = donor[kind[component]];
            if (gives[component] && (best < 0 || score(component) < score(best)))
                best = component;
        }
        SeamedMap whole = expanded(chosenMap(map, kind, donor), job);
        if (job.stopped())
            break;
        if (whole.validate(*soup).empty() && whole.seamCost(*soup, preferred) <= most &&
            whole.distortion(*soup) <= std::max(bound, map.distortion(*soup)))
            return whole;
    }
    return map;
}

//! The copied map is a little stretched on them.
void AlikeParts::relaxNearCopies(SeamedMap &map, const JobContext &job) const
{
    Snapshot snapshot;
    snapshot.mesh = mNear.mesh;
    snapshot.settings = mSettings;
    snapshot = preference::SeamPreference().applied(snapshot);
    const std::shared_ptr<const Soup> soup = Soup::build(mNear.mesh);
    // To solver units of the near copies.
    const double unit = std::sqrt(mWhole->area / mNear.mesh->area);
    SeamedMap own;
    own.x.resize(soup->coordinateCount());
    for (int c = 0; c < mNear.mesh->soupCornerCount(); ++c)
        cornerAt(own.x, c) = unit * cornerAt(map.x, mNear.soupCornerOf(c));
    for (const int edge : mNear.edgePair)
        own.cut.push_back(map.cut[edge]);
    if (!own.validate(*soup).empty())
        return;
    search::CutState state = search::CutState::from(search::SeamGraph::build(soup, snapshot), own, true);
    search::SeamTrial(state).relaxAll(nearCopySteps, true, job);
    own = state.map();
    for (int c = 0; c < mNear.mesh->soupCornerCount(); ++c)
        cornerAt(map.x, mNear.soupCornerOf(c)) = cornerAt(own.x, c) / unit;
}

} // namespace autocuts::unwrap
