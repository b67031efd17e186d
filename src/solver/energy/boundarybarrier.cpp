#include "solver/energy/boundarybarrier.h"

#include "solver/base/cornerat.h"
#include "solver/base/segmentcrossing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace autocuts::energy {

namespace {

struct Nearest
{
    double distance;
    double t;    //!< position along the segment, 0 at its start
    Vec2 normal; //!< from the segment to the point
};

Nearest nearestOnSegment(const Vec2 &p, const Vec2 &a, const Vec2 &b)
{
    const Vec2 d = b - a;
    const double length = d.squaredNorm();
    const double t = length > 0 ? std::clamp((p - a).dot(d) / length, 0.0, 1.0) : 0;
    const Vec2 away = p - (a + t * d);
    const double distance = away.norm();
    return {distance, t, distance > 0 ? Vec2(away / distance) : Vec2::Zero()};
}

} // namespace

BoundaryBarrierTerm::BoundaryBarrierTerm(const Soup &soup, const CutMesh &cut, std::span<const double> x,
                                         double factor, double reach)
    : mFactor(factor), mReach(reach)
{
    std::map<std::pair<double, double>, int> places;
    const auto placeOf = [&](int soupCorner) {
        const Vec2 p = cornerAt(x, soupCorner);
        return places.try_emplace({p.x(), p.y()}, static_cast<int>(places.size())).first->second;
    };
    // One soup corner represents each UV vertex, so that equal UV vertices have equal numbers.
    std::vector<int> corner(cut.uvVertexCount, -1);
    for (int c = soup.mesh->soupCornerCount() - 1; c >= 0; --c)
        corner[cut.uvVertex[c]] = c;
    for (int side = 0; side < static_cast<int>(cut.neighbour.size()); ++side) {
        if (cut.neighbour[side] >= 0)
            continue;
        const int from = corner[cut.uvVertex[side]];
        const int to = corner[cut.uvVertex[side / 3 * 3 + (side + 1) % 3]];
        mSegments.push_back({from, to, placeOf(from), placeOf(to), cut.chart[side / 3]});
    }
}

bool BoundaryBarrierTerm::collect(std::span<const double> x, std::vector<Contact> &contacts) const
{
    // Sweep in u over the bounding boxes of the segments.
    struct Box
    {
        double low, high, bottom, top;
        int segment;
    };
    std::vector<Box> boxes(mSegments.size());
    for (std::size_t s = 0; s < mSegments.size(); ++s) {
        const Vec2 a = cornerAt(x, mSegments[s].from), b = cornerAt(x, mSegments[s].to);
        boxes[s] = {std::min(a.x(), b.x()) - mReach, std::max(a.x(), b.x()) + mReach,
                    std::min(a.y(), b.y()) - mReach, std::max(a.y(), b.y()) + mReach, static_cast<int>(s)};
    }
    std::sort(boxes.begin(), boxes.end(), [](const Box &a, const Box &b) {
        return a.low != b.low ? a.low < b.low : a.segment < b.segment;
    });
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size() && boxes[j].low <= boxes[i].high; ++j) {
            const Segment &s = mSegments[boxes[i].segment], &t = mSegments[boxes[j].segment];
            if (s.chart != t.chart || boxes[i].bottom > boxes[j].top || boxes[j].bottom > boxes[i].top)
                continue;
            const bool fromApart = s.fromPlace != t.fromPlace && s.fromPlace != t.toPlace;
            if (s.from != t.from && s.from != t.to && s.to != t.from && s.to != t.to &&
                segmentsCross(cornerAt(x, s.from), cornerAt(x, s.to), cornerAt(x, t.from), cornerAt(x, t.to)))
                return false;
            if (fromApart)
                contacts.push_back({s.from, boxes[j].segment});
            if (t.fromPlace != s.fromPlace && t.fromPlace != s.toPlace)
                contacts.push_back({t.from, boxes[i].segment});
        }
    }
    return true;
}

double BoundaryBarrierTerm::value(std::span<const double> x) const
{
    std::vector<Contact> contacts;
    if (!collect(x, contacts))
        return std::numeric_limits<double>::infinity();
    double sum = 0;
    for (const Contact &contact : contacts) {
        const Segment &s = mSegments[contact.segment];
        const double d =
            nearestOnSegment(cornerAt(x, contact.point), cornerAt(x, s.from), cornerAt(x, s.to)).distance;
        if (d >= mReach)
            continue;
        if (d == 0)
            return std::numeric_limits<double>::infinity();
        sum += (mReach / d - 1) * (mReach / d - 1);
    }
    return mFactor * sum;
}

double BoundaryBarrierTerm::addDerivatives(std::span<const double> x, std::span<double> gradient,
                                           HessianBlocks &blocks) const
{
    std::vector<Contact> contacts;
    collect(x, contacts);
    std::vector<double> &ground = blocks.addedGround();
    double sum = 0;
    for (const Contact &contact : contacts) {
        const Segment &s = mSegments[contact.segment];
        const Nearest near =
            nearestOnSegment(cornerAt(x, contact.point), cornerAt(x, s.from), cornerAt(x, s.to));
        if (near.distance >= mReach || near.distance == 0)
            continue;
        const double q = mReach / near.distance;
        sum += (q - 1) * (q - 1);
        const double slope = -2 * mFactor * (q - 1) * q / near.distance;
        const double curvature = 2 * mFactor * q * (3 * q - 2) / (near.distance * near.distance);
        const std::array<int, 3> corner{contact.point, s.from, s.to};
        const std::array<double, 3> share{1, -(1 - near.t), -near.t};
        for (int k = 0; k < 3; ++k) {
            for (int axis = 0; axis < 2; ++axis) {
                const std::size_t i = 2 * static_cast<std::size_t>(corner[k]) + axis;
                gradient[i] += slope * share[k] * near.normal[axis];
                // The full matrix is curvature * v v^T over six coordinates; |v| <= 2 bounds it by a
                // diagonal.
                ground[i] += 2 * curvature * std::abs(share[k]) *
                             (std::abs(near.normal.x()) + std::abs(near.normal.y())) *
                             std::abs(near.normal[axis]);
            }
        }
    }
    return mFactor * sum;
}

} // namespace autocuts::energy
