#include "solver/search/chartclusters.h"

#include "model/plain/unionfind.h"
#include "solver/base/constant.h"
#include "solver/search/cutstate.h"

#include <Eigen/Geometry>

#include <limits>
#include <map>
#include <queue>

namespace autocuts::search {

namespace {

//! How much more spread a cluster may get by taking in one that is too small for a chart. Chosen by hand.
AUTOCUTS_CONSTANT(double, spreadOfSmall, 10);

class Clusters
{
public:
    Clusters(const SeamGraph &graph, const std::vector<double> &mostSpread)
        : mGraph(graph), mClusters(graph.triangleCount()), mSets(graph.triangleCount())
    {
        const MeshData &mesh = *graph.soup->mesh;
        for (int t = 0; t < graph.triangleCount(); ++t) {
            Cluster &own = mClusters[t];
            const Vec3 a = corner(t, 0);
            own.normal =
                graph.soup->weight[t] * (corner(t, 1) - a).cross(corner(t, 2) - a).stableNormalized();
            own.area = graph.soup->weight[t];
            own.share = graph.soup->shareOfCopy(t);
            own.mostSpread = mostSpread[t];
        }
        for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
            if (graph.rule[e] == SeamGraph::Rule::AlwaysCut)
                continue;
            const auto [a, b] = mesh.edgePairs[e].triangle;
            mClusters[a].seam[b] += graph.length[e];
            mClusters[b].seam[a] += graph.length[e];
        }
        for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
            const int a = mSets.find(mesh.edgePairs[e].triangle[0]);
            const int b = mSets.find(mesh.edgePairs[e].triangle[1]);
            if (graph.rule[e] == SeamGraph::Rule::NeverCut && a != b)
                join(a, b);
        }
    }

    //! Joins clusters, those whose normals spread least first.
    void joinAlike()
    {
        mQueue = {};
        for (int c = 0; c < mGraph.triangleCount(); ++c) {
            if (mSets.find(c) == c)
                offer(c);
        }
        while (!mQueue.empty()) {
            const Pair next = mQueue.top();
            mQueue.pop();
            if (mClusters[next.a].version != next.versions.first ||
                mClusters[next.b].version != next.versions.second)
                continue;
            offer(join(next.a, next.b));
        }
    }

    //! Joins clusters that are too small to be charts, the smallest first.
    void joinSmall()
    {
        std::priority_queue<std::tuple<double, int, int>, std::vector<std::tuple<double, int, int>>,
                            std::greater<>>
            small;
        const auto offerSmall = [&](int c) {
            if (mClusters[c].share < CutState::smallestChart(*mGraph.soup, c) && !mClusters[c].seam.empty())
                small.emplace(mClusters[c].share, c, mClusters[c].version);
        };
        for (int c = 0; c < mGraph.triangleCount(); ++c) {
            if (mSets.find(c) == c)
                offerSmall(c);
        }
        while (!small.empty()) {
            const auto [share, c, version] = small.top();
            small.pop();
            if (mClusters[c].version != version)
                continue;
            int best = -1;
            double least = std::numeric_limits<double>::infinity();
            for (const auto &[other, length] : mClusters[c].seam) {
                const double wider = spread(c, other, length);
                const double most = std::min(mClusters[c].mostSpread, mClusters[other].mostSpread);
                if (wider < least && wider <= spreadOfSmall * most) {
                    best = other;
                    least = wider;
                }
            }
            if (best >= 0)
                offerSmall(join(c, best));
        }
    }

    CutFlags seams()
    {
        const std::vector<EdgePair> &pairs = mGraph.soup->mesh->edgePairs;
        CutFlags cut(pairs.size());
        for (std::size_t e = 0; e < cut.size(); ++e)
            cut[e] = mGraph.rule[e] == SeamGraph::Rule::AlwaysCut ||
                     mSets.find(pairs[e].triangle[0]) != mSets.find(pairs[e].triangle[1]);
        return cut;
    }

private:
    struct Cluster
    {
        Vec3 normal = Vec3::Zero(); //!< sum over its triangles, weighted by area
        double area = 0;
        double mostSpread = 0;      //!< the least of its triangles
        double share = 0;           //!< see Soup::shareOfCopy()
        std::map<int, double> seam; //!< per neighbour: length of the edges between them
        int version = 0;            //!< rises with every change; -1: part of another one
    };
    struct Pair
    {
        double spread;
        int a, b;
        std::pair<int, int> versions;
        bool operator<(const Pair &other) const // the least spread is on top of a queue
        {
            return std::tie(other.spread, other.a, other.b) < std::tie(spread, a, b);
        }
    };

    Vec3 corner(int t, int k) const
    {
        const MeshData &mesh = *mGraph.soup->mesh;
        return mesh.cornerPosition(mesh.cornerOfSoup(3 * t + k));
    }

    static double error(const Vec3 &normal, double area)
    {
        return area > 0 ? area - normal.squaredNorm() / area : 0;
    }

    //! By how much joining two clusters spreads their normals, per length of the seam between them.
    double spread(int a, int b, double length) const
    {
        const Cluster &p = mClusters[a], &q = mClusters[b];
        const double rise =
            error(p.normal + q.normal, p.area + q.area) - error(p.normal, p.area) - error(q.normal, q.area);
        return rise / std::max(length, 1e-300);
    }

    //! Puts the pairs of a cluster and its neighbours into the queue.
    void offer(int c)
    {
        for (const auto &[other, length] : mClusters[c].seam) {
            const auto [a, b] = std::minmax(c, other);
            const double wider = spread(a, b, length);
            if (wider <= std::min(mClusters[a].mostSpread, mClusters[b].mostSpread))
                mQueue.push({wider, a, b, {mClusters[a].version, mClusters[b].version}});
        }
    }

    //! \returns the cluster that both are now
    int join(int a, int b)
    {
        mSets.unite(a, b);
        if (mSets.find(a) != a)
            std::swap(a, b);
        Cluster &whole = mClusters[a], &part = mClusters[b];
        whole.normal += part.normal;
        whole.area += part.area;
        whole.share += part.share;
        whole.mostSpread = std::min(whole.mostSpread, part.mostSpread);
        whole.seam.erase(b);
        part.seam.erase(a);
        for (const auto &[other, length] : part.seam) {
            whole.seam[other] += length;
            mClusters[other].seam.erase(b);
            mClusters[other].seam[a] += length;
        }
        part.seam.clear();
        part.version = -1;
        ++whole.version;
        return a;
    }

    const SeamGraph &mGraph;
    std::vector<Cluster> mClusters; //!< per triangle; those of a set are in its root
    UnionFind mSets;
    std::priority_queue<Pair> mQueue;
};

} // namespace

CutFlags clusterSeams(const SeamGraph &graph, const std::vector<double> &mostSpread)
{
    Clusters clusters(graph, mostSpread);
    clusters.joinAlike();
    clusters.joinSmall();
    return clusters.seams();
}

} // namespace autocuts::search
