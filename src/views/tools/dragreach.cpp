#include "views/tools/dragreach.h"

#include "model/plain/nearestfirst.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts {

namespace {

//! Traverses the soup, starting at the dragged corners.
class Spreading
{
public:
    Spreading(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<float> &separation)
        : mUv(soupUv), mPartners(mesh.soupCornerCount(), {-1, -1})
    {
        for (int pair = 0; pair < mesh.cornerPairCount(); ++pair) {
            if (separation[pair] >= 0.5f)
                continue;
            const auto [a, b] = mesh.edgePairs[pair / 2].corner[pair % 2];
            addPartner(a, b);
            addPartner(b, a);
        }
    }

    //! All soup corners connected to the handles, ascending.
    std::vector<int> pieces(const std::vector<int> &handles) const
    {
        std::vector<int> found;
        std::vector<bool> seen(mPartners.size());
        const auto visit = [&](int corner) {
            if (!seen[corner])
                found.push_back(corner);
            seen[corner] = true;
        };
        for (int handle : handles)
            visit(handle);
        for (std::size_t head = 0; head < found.size(); ++head)
            forNeighbours(found[head], visit);
        std::sort(found.begin(), found.end());
        return found;
    }

    //! Straight distance of each soup corner from the handle whose path reaches it first; infinite from the
    //! radius on.
    std::vector<double> distances(const std::vector<int> &handles, double radius) const
    {
        std::vector<double> distance(mPartners.size(), std::numeric_limits<double>::infinity());
        std::vector<int> source(mPartners.size(), -1);
        NearestFirst queue(distance);
        for (int handle : handles) {
            queue.reach(handle, 0);
            source[handle] = handle;
        }
        for (int corner = queue.next(); corner >= 0; corner = queue.next()) {
            forNeighbours(corner, [&](int next) {
                const double way = (mUv.row(next) - mUv.row(source[corner])).norm();
                if (way < radius && queue.reach(next, way))
                    source[next] = source[corner];
            });
        }
        return distance;
    }

private:
    void addPartner(int corner, int partner)
    {
        std::array<int, 2> &known = mPartners[corner];
        known[known[0] < 0 ? 0 : 1] = partner;
    }

    template <typename Visit>
    void forNeighbours(int corner, const Visit &visit) const
    {
        const int first = corner - corner % 3;
        visit(first + (corner + 1) % 3);
        visit(first + (corner + 2) % 3);
        for (int partner : mPartners[corner]) {
            if (partner >= 0)
                visit(partner);
        }
    }

    const UvMatrix &mUv;
    std::vector<std::array<int, 2>> mPartners; //!< across the closed corner pairs; -1: none
};

} // namespace

DragReach dragReach(const MeshData &mesh, const UvMatrix &soupUv, const std::vector<float> &separation,
                    const std::vector<int> &handles, double radius)
{
    std::vector<int> start;
    std::copy_if(handles.begin(), handles.end(), std::back_inserter(start),
                 [&](int handle) { return soupUv.row(handle).allFinite(); });
    const Spreading spreading(mesh, soupUv, separation);
    DragReach reach;
    reach.corners = spreading.pieces(start);
    reach.weight.assign(mesh.soupCornerCount(), 0);
    const std::vector<double> distance = spreading.distances(start, radius);
    for (int corner : reach.corners) {
        if (distance[corner] == 0) {
            reach.weight[corner] = 1;
        } else if (distance[corner] < radius) {
            const double share = distance[corner] / radius;
            reach.weight[corner] = (1 - share * share) * (1 - share * share);
        }
    }
    return reach;
}

double shareWithoutFlips(const UvMatrix &soupUv, const UvMatrix &ways)
{
    constexpr double keptArea = 0.01;
    double share = 1;
    const auto cross = [](const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); };
    for (Eigen::Index first = 0; first < soupUv.rows(); first += 3) {
        if (ways.middleRows(first, 3).isZero(0))
            continue;
        const Vec2 p = soupUv.row(first + 1) - soupUv.row(first),
                   q = soupUv.row(first + 2) - soupUv.row(first);
        const Vec2 dp = ways.row(first + 1) - ways.row(first), dq = ways.row(first + 2) - ways.row(first);
        // The area is a quadratic function of the share: area(t) = area + slope t + bend t^2. Its sign is
        // chosen so that it starts above 0, and it is lowered by the area that must remain.
        const double area = cross(p, q);
        const double side = area < 0 ? -1 : 1;
        const double height = (1 - keptArea) * std::abs(area);
        const double slope = side * (cross(dp, q) + cross(p, dq));
        const double bend = side * cross(dp, dq);
        const double root = slope * slope - 4 * bend * height;
        if (!(height > 0) || !(root >= 0))
            continue;
        const double half = -0.5 * (slope + std::copysign(std::sqrt(root), slope));
        for (double t : {half / bend, height / half}) {
            if (t > 0 && t < share)
                share = t;
        }
    }
    return share;
}

} // namespace autocuts
