#include "solver/unwrap/candidates.h"

#include "solver/base/alignedborder.h"
#include "solver/search/bentregions.h"
#include "solver/search/cutstate.h"

#include <algorithm>

namespace autocuts::unwrap {

namespace {

//! What small charts count as, in seam cost. A smooth surface needs none; of a rough one, one more or less
//! means little. Chosen by hand, so that hundreds of them do not outweigh seams that are half as long.
double costOfSmallCharts(int count)
{
    return 0.3 * std::min(count, 10) + 0.03 * count;
}

} // namespace

double boundedDistortion(const Soup &soup, const Snapshot &snapshot, const SeamedMap &map)
{
    if (!snapshot.rigid)
        return map.distortion(soup);
    const std::vector<bool> bent = search::bentRegions(soup, *snapshot.rigid, map.x);
    const bool anyBent = std::find(bent.begin(), bent.end(), true) != bent.end();
    return anyBent ? map.distortion(soup, snapshot.stiffness()) : map.distortion(soup);
}

void Candidate::measure(const Soup &soup, const Snapshot &snapshot)
{
    distortion = map.distortion(soup);
    bounded = boundedDistortion(soup, snapshot, map);
    seamLength = map.seamLength(soup);
    seamCost = map.seamCost(soup, snapshot);
    const MeshData &mesh = *soup.mesh;
    const CutMesh charts(mesh, map.cut);
    seamCost += crookedCost(soup, map, charts, snapshot);
    std::vector<double> area(charts.chartCount, 0);
    for (int t = 0; t < mesh.triangleCount(); ++t)
        area[charts.chart[t]] += soup.shareOfCopy(t);
    std::vector<bool> isSmallPart(charts.chartCount, false);
    for (const EdgePair &pair : mesh.edgePairs) {
        const int one = charts.chart[pair.triangle[0]], other = charts.chart[pair.triangle[1]];
        const double smallest = search::CutState::smallestChart(soup, pair.triangle[0]);
        for (const int c : {one, other}) {
            if (one != other && area[c] < smallest)
                isSmallPart[c] = true;
        }
    }
    openJoins = 0;
    for (std::size_t e = 0; e < map.cut.size(); ++e)
        openJoins += map.cut[e] && snapshot.isJoined(e);
    smallCharts = static_cast<int>(std::count(isSmallPart.begin(), isSmallPart.end(), true));
}

bool Ranking::better(const Candidate &a, const Candidate &b) const
{
    if (a.anchorFaults != b.anchorFaults)
        return a.anchorFaults < b.anchorFaults;
    if (a.openJoins != b.openJoins)
        return a.openJoins < b.openJoins;
    if (mOptions.lambda) {
        const double mu = *mOptions.lambda / std::max(1 - *mOptions.lambda, 1e-9);
        return a.distortion + mu * a.seamCost < b.distortion + mu * b.seamCost;
    }
    const bool aFits = a.bounded <= mOptions.maxDistortion;
    const bool bFits = b.bounded <= mOptions.maxDistortion;
    if (aFits != bFits)
        return aFits;
    if (!aFits)
        return a.bounded < b.bounded;
    return a.seamCost + costOfSmallCharts(a.smallCharts) < b.seamCost + costOfSmallCharts(b.smallCharts);
}

void Ranking::setTotal(int steps)
{
    const std::scoped_lock lock(mMutex);
    mTotalSteps = std::max(steps, 1);
    mSteps = 0;
}

void Ranking::stepDone(int steps)
{
    const std::scoped_lock lock(mMutex);
    mSteps += steps;
    const double done = std::min(1.0, double(mSteps) / mTotalSteps);
    mProgress.fraction = std::max(mProgress.fraction, optimizingShare * (mBegin + (mEnd - mBegin) * done));
    mJob.report(mProgress);
}

void Ranking::noteFound(double distortion, double seamLength)
{
    mProgress.distortion = distortion;
    mProgress.seamLength = seamLength;
}

void Ranking::packing(double fraction)
{
    const std::scoped_lock lock(mMutex);
    mProgress.stage = JobStage::Packing;
    mProgress.fraction = fraction;
    mJob.report(mProgress);
}

} // namespace autocuts::unwrap
