#include "solver/definite/seamfitting.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace autocuts::definite {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Two sides lie on each other when they are at most this far apart, as a share of their length, and may
//! belong together up to the second distance. The first was chosen by hand, the second is that of
//! chartjoining.
constexpr double sewnDistance = 0.05, looseDistance = 0.6;
//! Sides that were one are at most this far apart, as a share of their length, in files of 32-bit numbers
//! too.
constexpr double exactDistance = 1e-4;
//! How many edges of a seam, about, are asked for the similarity of which they are exact.
constexpr std::size_t mostSamples = 50;
//! Fewer edges, or less of the length of a seam, fit anywhere.
constexpr std::size_t fewestToFit = 3;
constexpr double leastShareToFit = 0.25;
//! How often the worst third of the edges is left out.
constexpr int rounds = 5;

double lengthOf(const std::vector<EdgeMatch> &edges, const std::vector<int> &some)
{
    return std::accumulate(some.begin(), some.end(), 0.0,
                           [&](double sum, int i) { return sum + edges[i][0].weight; });
}

std::vector<EdgeMatch> chosen(const std::vector<EdgeMatch> &edges, const std::vector<int> &some)
{
    std::vector<EdgeMatch> result(some.size());
    std::transform(some.begin(), some.end(), result.begin(), [&](int i) { return edges[i]; });
    return result;
}

double distanceOf(const EdgeMatch &edge, const SimilarMotion &motion)
{
    return std::max((motion(edge[0].moving) - edge[0].fixed).norm(),
                    (motion(edge[1].moving) - edge[1].fixed).norm());
}

//! As a share of its length in the map.
double misfitOf(const EdgeMatch &edge, const SimilarMotion &motion)
{
    const double length = (edge[0].fixed - edge[1].fixed).norm();
    return distanceOf(edge, motion) / std::max(length, std::numeric_limits<double>::min());
}

std::vector<int> near(const std::vector<EdgeMatch> &edges, const SimilarMotion &motion, double distance)
{
    std::vector<int> result;
    for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
        if (misfitOf(edges[i], motion) <= distance)
            result.push_back(i);
    }
    return result;
}

} // namespace

SimilarMotion fitEdges(const std::vector<EdgeMatch> &edges)
{
    std::vector<PointMatch> points;
    for (const EdgeMatch &edge : edges)
        points.insert(points.end(), edge.begin(), edge.end());
    return fitSimilar(points);
}

bool fitLoosely(const std::vector<EdgeMatch> &edges)
{
    const SimilarMotion motion = fitEdges(edges);
    return std::all_of(edges.begin(), edges.end(),
                       [&](const EdgeMatch &edge) { return misfitOf(edge, motion) <= looseDistance; });
}

std::vector<int> fittingEdges(const std::vector<EdgeMatch> &edges)
{
    std::vector<int> kept(edges.size());
    std::iota(kept.begin(), kept.end(), 0);
    const double all = lengthOf(edges, kept);
    SimilarMotion motion = fitEdges(edges);
    for (int round = 0;
         round < rounds && near(chosen(edges, kept), motion, sewnDistance).size() < kept.size(); ++round) {
        std::stable_sort(kept.begin(), kept.end(), [&](int a, int b) {
            return distanceOf(edges[a], motion) < distanceOf(edges[b], motion);
        });
        kept.resize(kept.size() - kept.size() / 3);
        motion = fitEdges(chosen(edges, kept));
    }
    const std::vector<int> fitting = near(edges, motion, sewnDistance);
    const bool few = fitting.size() < fewestToFit || lengthOf(edges, fitting) < leastShareToFit * all;
    return few ? std::vector<int>() : fitting;
}

std::vector<int> exactEdges(const std::vector<EdgeMatch> &edges)
{
    std::vector<int> best;
    double longest = 0;
    const std::size_t stride = std::max<std::size_t>(1, edges.size() / mostSamples);
    for (std::size_t sample = 0; sample < edges.size(); sample += stride) {
        std::vector<int> agreeing = near(edges, fitEdges({edges[sample]}), exactDistance);
        const double length = lengthOf(edges, agreeing);
        if (agreeing.size() > 1 && length > longest) {
            longest = length;
            best = std::move(agreeing);
        }
    }
    return best;
}

std::vector<int> touchingEdges(const std::vector<EdgeMatch> &edges)
{
    return near(edges, SimilarMotion(), sewnDistance);
}

} // namespace autocuts::definite
