#include "solver/metrics/uvoverlaps.h"

#include "model/plain/rigidpieces.h"

#include <algorithm>
#include <cmath>

namespace autocuts::metrics {

namespace {

//! The triangles of a map that have an area, with the corners of each UV vertex in one place: they may differ
//! by the tolerance with which charts are found, and adjacent triangles only touch.
class OverlapSearch
{
public:
    OverlapSearch(const UvMatrix &uv, const UvTopology &topology, const UvTriangles &triangles,
                  const UvOverlapOptions &options)
        : mTriangles(triangles), mStacks(stackOfCharts(topology.charts, options.faceFlags)), mJob(options.job)
    {
        const auto place = [&](int corner) -> Vec2 { return uv.row(topology.cornerRoot[corner]); };
        for (int t = 0; t < triangles.count(); ++t) {
            if (!triangles.hasUv(t))
                continue;
            const auto &c = triangles.corners[t];
            const double area = 0.5 * cross2(place(c[0]), place(c[1]), place(c[2]));
            if (std::abs(area) >= 1e-14 * triangles.totalUvArea && area != 0)
                mSource.push_back(t);
        }
        mUv.resize(3 * static_cast<Eigen::Index>(mSource.size()), 2);
        for (std::size_t i = 0; i < mSource.size(); ++i) {
            for (int k = 0; k < 3; ++k)
                mUv.row(3 * static_cast<Eigen::Index>(i) + k) = place(triangles.corners[mSource[i]][k]);
        }
    }

    //! Calls visit(a, b, area) for all overlaps, until it returns false. \returns false when not complete
    bool visit(double minAreaRatio, const std::function<bool(int, int, double)> &visit) const
    {
        overlap::OverlapOptions options;
        options.minAreaRatio = minAreaRatio;
        options.totalArea = mTriangles.totalUvArea;
        options.job = mJob;
        return overlap::visitOverlaps(
            mUv, options, [&](int a, int b, double area) { return visit(mSource[a], mSource[b], area); });
    }

    bool inOneChart(int a, int b) const { return mTriangles.chart[a] == mTriangles.chart[b]; }
    bool inOneStack(int a, int b) const
    {
        const int stack = mStacks[mTriangles.chart[a]];
        return stack != 0 && stack == mStacks[mTriangles.chart[b]] && !inOneChart(a, b);
    }

private:
    const UvTriangles &mTriangles;
    std::vector<int> mStacks; //!< per chart
    JobContext mJob;
    std::vector<int> mSource; //!< the triangle of each three rows of mUv
    UvMatrix mUv;
};

} // namespace

UvOverlapFigures measureUvOverlaps(const UvMatrix &uv, const UvTopology &topology,
                                   const UvTriangles &triangles, const UvOverlapOptions &options)
{
    const OverlapSearch search(uv, topology, triangles, options);
    const double threshold = overlap::visibleOverlap * triangles.totalUvArea;
    UvOverlapFigures figures;
    std::vector<bool> overlapping(triangles.count(), false);
    figures.complete = search.visit(0, [&](int a, int b, double area) {
        if (search.inOneStack(a, b)) {
            figures.stackedPairs += area > threshold;
            return true;
        }
        figures.area += area;
        if (area > threshold) {
            ++figures.pairs;
            figures.sameChartPairs += search.inOneChart(a, b);
            overlapping[a] = overlapping[b] = true;
        }
        return true;
    });
    figures.triangles = std::count(overlapping.begin(), overlapping.end(), true);
    return figures;
}

overlap::OverlapList findUvOverlaps(const MeshData &mesh, const UvMatrix &uv, const UvOverlapOptions &options)
{
    const UvTopology topology = findUvTopology(mesh, uv);
    const UvTriangles triangles = collectUvTriangles(mesh, uv, topology);
    const OverlapSearch search(uv, topology, triangles, options);
    overlap::OverlapList list;
    list.complete = search.visit(overlap::visibleOverlap, [&](int a, int b, double area) {
        if (!search.inOneStack(a, b))
            list.pairs.push_back({a, b, area});
        return list.pairs.size() < options.maxPairs;
    });
    std::sort(list.pairs.begin(), list.pairs.end(),
              [](const overlap::OverlapPair &a, const overlap::OverlapPair &b) {
                  return std::pair(a.first, a.second) < std::pair(b.first, b.second);
              });
    return list;
}

std::vector<int> overlappingTriangles(const overlap::OverlapList &overlaps)
{
    std::vector<int> triangles;
    for (const overlap::OverlapPair &pair : overlaps.pairs)
        triangles.insert(triangles.end(), {pair.first, pair.second});
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
}

std::vector<int> overlappingTriangles(const MeshData &mesh, const UvMatrix &uv,
                                      const UvOverlapOptions &options)
{
    const UvTopology topology = findUvTopology(mesh, uv);
    const UvTriangles triangles = collectUvTriangles(mesh, uv, topology);
    const OverlapSearch search(uv, topology, triangles, options);
    std::vector<bool> overlaps(triangles.count(), false);
    search.visit(overlap::visibleOverlap, [&](int a, int b, double) {
        if (!search.inOneStack(a, b))
            overlaps[a] = overlaps[b] = true;
        return true;
    });
    std::vector<int> list;
    for (int t = 0; t < triangles.count(); ++t) {
        if (overlaps[t])
            list.push_back(t);
    }
    return list;
}

} // namespace autocuts::metrics
