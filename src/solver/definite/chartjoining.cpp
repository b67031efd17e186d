#include "solver/definite/chartjoining.h"

#include "solver/base/constant.h"
#include "solver/base/cornerat.h"
#include "solver/base/rigidfit.h"
#include "solver/energy/distortion.h"
#include "solver/newton/minimizer.h"
#include "solver/overlap/overlapfinder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace autocuts::definite {

namespace {

// Numbers in this file without another source were chosen by hand.

//! How many rings of triangles around a closed seam may move, for joined charts and for zipped edges, and the
//! Newton steps in which they do.
AUTOCUTS_CONSTANT(int, looseRings, 8);
constexpr int zipRings = 5;
AUTOCUTS_CONSTANT(int, localSteps, 10);
//! An edge can be closed when its two sides are at most this far apart, as a share of its length.
AUTOCUTS_CONSTANT(double, fitDistance, 0.6);
//! Least UV area of each triangle at a closed seam, as a share of its area at rest.
constexpr double smallestDeterminant = 0.05;

//! Joins charts and zips seams of one map within the limits.
class ChartJoiner
{
public:
    ChartJoiner(std::shared_ptr<const Soup> soup, const Snapshot &snapshot, SeamedMap &map,
                const JoinOptions &options)
        : mSoup(std::move(soup)), mMesh(*mSoup->mesh), mSnapshot(snapshot), mMap(map), mOptions(options)
    {}

    int joinCharts()
    {
        int joins = 0, tries = 0;
        bool again = true;
        while (again) {
            again = false;
            const CutMesh state(mMesh, mMap.cut);
            mDistortion = mMap.distortion(*mSoup);
            std::set<int> touched; // charts that were changed in this round
            for (const auto &[charts, edges] : neighbours(state)) {
                if (tries >= mOptions.tries || mOptions.job.stopped())
                    return joins;
                if (touched.count(charts.first) || touched.count(charts.second) ||
                    mFailed.count(edges.front()))
                    continue;
                ++tries;
                if (join(state, charts.first, charts.second, edges)) {
                    touched.insert({charts.first, charts.second});
                    ++joins;
                    again = true;
                } else {
                    mFailed.insert(edges.front());
                }
            }
        }
        return joins;
    }

    //! Closes seams edge by edge from their ends inside charts.
    int zipSeams()
    {
        int zipped = 0, tries = 0;
        mDistortion = mMap.distortion(*mSoup);
        bool again = true;
        while (again) {
            again = false;
            for (const int e : looseEnds()) {
                if (mFailed.count(e))
                    continue;
                if (++tries > mOptions.tries || mOptions.job.stopped())
                    return zipped;
                if (close({e}, mMap.x, zipRings)) {
                    ++zipped;
                    again = true;
                } else {
                    mFailed.insert(e);
                }
            }
        }
        return zipped;
    }

private:
    using ChartPair = std::pair<int, int>; //!< the larger chart first

    //! Pairs of adjacent charts and the edges of their common seam, the longest seam first.
    std::vector<std::pair<ChartPair, std::vector<int>>> neighbours(const CutMesh &state) const
    {
        std::vector<double> area(state.chartCount, 0);
        for (int t = 0; t < mMesh.triangleCount(); ++t)
            area[state.chart[t]] += mSoup->weight[t];
        std::map<ChartPair, std::vector<int>> seams;
        for (std::size_t e = 0; e < mMap.cut.size(); ++e) {
            if (!mMap.cut[e] || cutByUser(e))
                continue;
            int a = state.chart[mMesh.edgePairs[e].triangle[0]];
            int b = state.chart[mMesh.edgePairs[e].triangle[1]];
            if (a == b)
                continue;
            if (area[a] < area[b] || (area[a] == area[b] && b < a))
                std::swap(a, b);
            seams[{a, b}].push_back(static_cast<int>(e));
        }
        std::vector<std::pair<ChartPair, std::vector<int>>> result(seams.begin(), seams.end());
        const auto length = [this](const std::vector<int> &edges) {
            return std::accumulate(edges.begin(), edges.end(), 0.0, [this](double sum, int e) {
                return sum + mSoup->pairLength[2 * static_cast<std::size_t>(e)];
            });
        };
        std::stable_sort(result.begin(), result.end(),
                         [&](const auto &a, const auto &b) { return length(a.second) > length(b.second); });
        return result;
    }

    //! Cut edges at one of whose ends the seam ends inside a chart.
    std::vector<int> looseEnds() const
    {
        const CutMesh state(mMesh, mMap.cut);
        std::vector<int> result;
        for (std::size_t e = 0; e < mMap.cut.size(); ++e) {
            if (!mMap.cut[e] || cutByUser(e))
                continue;
            const EdgePair &pair = mMesh.edgePairs[e];
            if (state.uvVertex[pair.corner[0][0]] == state.uvVertex[pair.corner[0][1]] ||
                state.uvVertex[pair.corner[1][0]] == state.uvVertex[pair.corner[1][1]])
                result.push_back(static_cast<int>(e));
        }
        return result;
    }

    bool cutByUser(std::size_t edge) const
    {
        return !mSnapshot.steering->pairState.empty() &&
               (mSnapshot.steering->pairState[2 * edge] == PairState::Cut ||
                mSnapshot.steering->pairState[2 * edge + 1] == PairState::Cut);
    }

    Vec2 place(int corner) const { return cornerAt(mMap.x, corner); }

    //! The two corner pairs of an edge; the fixed point is the one in `fixedChart`.
    std::array<PointMatch, 2> seamPoints(const CutMesh &state, int edge, int fixedChart) const
    {
        const EdgePair &pair = mMesh.edgePairs[edge];
        const int fixed = state.chart[pair.triangle[0]] == fixedChart ? 0 : 1;
        const double w = mSoup->pairLength[2 * static_cast<std::size_t>(edge)];
        std::array<PointMatch, 2> points;
        for (int end = 0; end < 2; ++end)
            points[end] = {place(pair.corner[end][fixed]), place(pair.corner[end][1 - fixed]), w};
        return points;
    }

    //! Finds the rigid motion of the moving chart and the edges that fit under it. Fits, drops edges and fits
    //! again, six times at most.
    std::pair<RigidMotion, std::vector<int>> align(const CutMesh &state, int fixedChart,
                                                   const std::vector<int> &edges) const
    {
        std::vector<int> kept = edges;
        RigidMotion motion;
        for (int round = 0; round < 6 && !kept.empty(); ++round) {
            std::vector<PointMatch> points;
            for (const int e : kept) {
                for (const PointMatch &p : seamPoints(state, e, fixedChart))
                    points.push_back(p);
            }
            motion = fitRigid(points);
            // The first three rounds drop the worst third; the others keep exactly the edges that fit.
            std::vector<std::pair<double, int>> misfit;
            for (const int e : round < 3 ? kept : edges) {
                double worst = 0;
                for (const PointMatch &p : seamPoints(state, e, fixedChart))
                    worst = std::max(worst, (motion(p.moving) - p.fixed).norm() / p.weight);
                misfit.emplace_back(worst, e);
            }
            std::sort(misfit.begin(), misfit.end());
            if (round < 3 && misfit.back().first > fitDistance)
                misfit.resize(misfit.size() - misfit.size() / 3);
            kept.clear();
            for (const auto &[worst, e] : misfit) {
                if (round < 3 || worst <= fitDistance)
                    kept.push_back(e);
            }
        }
        std::sort(kept.begin(), kept.end());
        return {motion, kept};
    }

    bool join(const CutMesh &state, int fixedChart, int movingChart, const std::vector<int> &edges)
    {
        const auto [motion, kept] = align(state, fixedChart, edges);
        if (kept.empty())
            return false;
        std::vector<double> x = mMap.x;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (state.chart[t] != movingChart)
                continue;
            for (int c = 3 * t; c < 3 * t + 3; ++c)
                cornerAt(x, c) = motion(place(c));
        }
        return close(kept, std::move(x), looseRings);
    }

    //! Closes edges whose sides are near each other in x. Keeps the result and returns true when the limits
    //! allow it.
    bool close(const std::vector<int> &edges, std::vector<double> x, int rings)
    {
        SeamedMap trial{mMap.cut, std::move(x)};
        double gain = 0;
        for (const int e : edges) {
            trial.cut[e] = false;
            gain += mSnapshot.edgeWeight(e) * mSoup->pairLength[2 * static_cast<std::size_t>(e)];
        }
        const CutMesh joined(mMesh, trial.cut);
        if (!snapSeam(joined, edges, trial.x))
            return false;
        relaxAround(joined, edges, rings, trial.x);
        const double distortion = trial.distortion(*mSoup);
        const double cost = distortion - mDistortion;
        if (!(cost <= mOptions.costPerLength * gain) || (distortion > mOptions.maxDistortion && cost > 0))
            return false;
        const int chart = joined.chart[mMesh.edgePairs[edges[0]].triangle[0]];
        if (!mOptions.allowOverlaps && coversItself(joined, chart, trial.x))
            return false;
        mMap = std::move(trial);
        mDistortion = distortion;
        return true;
    }

    //! Moves the corners of each UV vertex on the closed edges to their mean; returns false when that flips
    //! or nearly flattens a triangle.
    bool snapSeam(const CutMesh &joined, const std::vector<int> &kept, std::vector<double> &x) const
    {
        std::set<int> vertices;
        for (const int e : kept) {
            for (int end = 0; end < 2; ++end)
                vertices.insert(joined.uvVertex[mMesh.edgePairs[e].corner[end][0]]);
        }
        std::map<int, std::pair<Vec2, int>> sums;
        std::set<int> triangles;
        for (int c = 0; c < mMesh.soupCornerCount(); ++c) {
            const int v = joined.uvVertex[c];
            if (!vertices.count(v))
                continue;
            auto &[sum, count] = sums.try_emplace(v, Vec2::Zero(), 0).first->second;
            sum += cornerAt(x, c);
            ++count;
            triangles.insert(c / 3);
        }
        for (const int t : triangles) {
            for (int c = 3 * t; c < 3 * t + 3; ++c) {
                const auto found = sums.find(joined.uvVertex[c]);
                if (found == sums.end())
                    continue;
                cornerAt(x, c) = found->second.first / found->second.second;
            }
            if (!(jacobianDeterminant(*mSoup, x.data(), t) > smallestDeterminant))
                return false;
        }
        return true;
    }

    //! Minimises the distortion of the triangles around the closed edges; everything else is held.
    void relaxAround(const CutMesh &joined, const std::vector<int> &kept, int rings,
                     std::vector<double> &x) const
    {
        std::vector<int> ring;
        std::vector<bool> loose(mMesh.triangleCount(), false);
        for (const int e : kept) {
            for (const int t : mMesh.edgePairs[e].triangle) {
                if (!loose[t])
                    ring.push_back(t);
                loose[t] = true;
            }
        }
        for (int i = 0; i < rings; ++i) {
            std::vector<int> next;
            for (const int t : ring) {
                for (int k = 0; k < 3; ++k) {
                    const int other = joined.neighbour[3 * t + k];
                    if (other >= 0 && !loose[other / 3]) {
                        loose[other / 3] = true;
                        next.push_back(other / 3);
                    }
                }
            }
            ring = std::move(next);
        }
        // A UV vertex may move when all its triangles may.
        std::vector<bool> held(joined.uvVertexCount, false);
        for (int c = 0; c < mMesh.soupCornerCount(); ++c) {
            if (!loose[c / 3])
                held[joined.uvVertex[c]] = true;
        }
        std::vector<int> number(joined.uvVertexCount, -1);
        newton::UnknownMap unknowns;
        for (int v = 0; v < joined.uvVertexCount; ++v) {
            if (!held[v])
                number[v] = unknowns.count++;
        }
        for (int c = 0; c < mMesh.soupCornerCount(); ++c)
            unknowns.unknown.push_back(number[joined.uvVertex[c]]);
        if (unknowns.count == 0)
            return;
        const auto distortion = energy::makeDistortionTerm(mSoup, mSnapshot.settings.energy);
        newton::Minimizer minimizer(mSoup, newton::makeExactDirection(mSoup, std::move(unknowns)));
        minimizer.setTerms({distortion.get()});
        for (int i = 0; i < localSteps; ++i) {
            const newton::Minimizer::Step step = minimizer.step(x);
            if (step.before - step.after < 1e-6 * step.before)
                break;
        }
    }

    bool coversItself(const CutMesh &joined, int chart, const std::vector<double> &x) const
    {
        std::vector<int> triangles;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (joined.chart[t] == chart)
                triangles.push_back(t);
        }
        overlap::OverlapOptions options;
        options.maxPairs = 1;
        const UvMatrix uv = Eigen::Map<const UvMatrix>(x.data(), mMesh.soupCornerCount(), 2);
        options.totalArea = overlap::totalUvArea(uv);
        return !overlap::findOverlapsAmong(uv, triangles, options).pairs.empty();
    }

    std::shared_ptr<const Soup> mSoup;
    const MeshData &mMesh;
    const Snapshot &mSnapshot;
    SeamedMap &mMap;
    const JoinOptions &mOptions;
    double mDistortion = 0;
    std::set<int> mFailed; //!< first edge of each seam that could not be closed
};

} // namespace

int joinCharts(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map,
               const JoinOptions &options)
{
    return ChartJoiner(soup, snapshot, map, options).joinCharts();
}

int zipSeams(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map,
             const JoinOptions &options)
{
    return ChartJoiner(soup, snapshot, map, options).zipSeams();
}

} // namespace autocuts::definite
