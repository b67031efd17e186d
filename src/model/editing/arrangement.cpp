#include "model/editing/arrangement.h"

#include "model/plain/udimtiles.h"
#include "model/plain/unionfind.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>

namespace autocuts {

namespace {

constexpr double quarter = std::numbers::pi / 2;

Eigen::Affine2d movedBy(const Vec2 &move)
{
    Eigen::Affine2d result = Eigen::Affine2d::Identity();
    result.translation() = move;
    return result;
}

//! A linear map that leaves one point in place.
Eigen::Affine2d about(const Vec2 &fixed, const Eigen::Matrix2d &linear)
{
    Eigen::Affine2d result = Eigen::Affine2d::Identity();
    result.linear() = linear;
    result.translation() = fixed - linear * fixed;
    return result;
}

Eigen::Matrix2d rotation(double angle)
{
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
    const double quarters = angle / quarter;
    return quarters == std::round(quarters) ? Eigen::Matrix2d(turn.array().round()) : turn;
}

//! The vertices of the convex hull, counter-clockwise.
std::vector<Vec2> convexHull(std::vector<Vec2> points)
{
    const auto before = [](const Vec2 &a, const Vec2 &b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3)
        return points;
    std::vector<Vec2> hull;
    const auto add = [&hull](const Vec2 &point, std::size_t keep) {
        while (hull.size() > keep && cross2(hull[hull.size() - 2], hull.back(), point) <= 0)
            hull.pop_back();
        hull.push_back(point);
    };
    for (const Vec2 &point : points)
        add(point, 1);
    const std::size_t lower = hull.size();
    for (auto it = points.rbegin() + 1; it != points.rend(); ++it)
        add(*it, lower);
    hull.pop_back();
    return hull;
}

//! The equivalent turn of at most 45 degrees either way: a quarter turn does not change how a box is aligned.
double smallestTurn(double angle)
{
    return std::remainder(angle, quarter);
}

//! A random number generator that gives the same numbers on all platforms (splitmix64).
class Dice
{
public:
    explicit Dice(std::uint64_t seed) : mState(seed) {}
    //! A number evenly distributed in [-1, 1).
    double next()
    {
        mState += 0x9E3779B97F4A7C15ull;
        std::uint64_t z = mState;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        z ^= z >> 31;
        return static_cast<double>(z >> 11) * 0x1.0p-52 - 1;
    }

private:
    std::uint64_t mState;
};

} // namespace

std::vector<IslandPiece> islandPieces(const Islands &islands, const IslandMarks &marks,
                                      const std::vector<int> &given)
{
    UnionFind joined(islands.count());
    std::map<int, int> firstOfStack, firstOfGroup;
    std::vector<IslandFlags> flags(islands.count());
    for (int i = 0; i < islands.count(); ++i) {
        flags[i] = marks.flagsOf(islands.faces(i));
        if (flags[i].stack != 0)
            joined.unite(i, firstOfStack.try_emplace(flags[i].stack, i).first->second);
        if (flags[i].group != 0)
            joined.unite(i, firstOfGroup.try_emplace(flags[i].group, i).first->second);
    }
    const auto [label, count] = joined.labels();
    std::vector<bool> wanted(count);
    for (int island : given)
        wanted[label[island]] = true;
    std::map<int, int> pieceOfLabel;
    std::vector<IslandPiece> pieces;
    for (int i = 0; i < islands.count(); ++i) {
        if (!wanted[label[i]])
            continue;
        const auto [entry, isNew] = pieceOfLabel.try_emplace(label[i], static_cast<int>(pieces.size()));
        if (isNew)
            pieces.emplace_back();
        IslandPiece &piece = pieces[entry->second];
        piece.islands.push_back(i);
        piece.box.extend(islands.box(i));
        piece.locked = piece.locked || flags[i].locked != 0;
    }
    return pieces;
}

std::vector<Eigen::Affine2d> alignedPieces(std::span<const IslandPiece> pieces, AlignTo to, double tileHeight)
{
    Eigen::AlignedBox2d frame, locked;
    for (const IslandPiece &piece : pieces) {
        frame.extend(piece.box);
        if (piece.locked)
            locked.extend(piece.box);
    }
    if (!locked.isEmpty()) {
        frame = locked;
    } else if (pieces.size() == 1) {
        frame = tileAt(frame.center(), tileHeight);
    }
    std::vector<Eigen::Affine2d> result;
    for (const IslandPiece &piece : pieces) {
        const Vec2 low = frame.min() - piece.box.min(), high = frame.max() - piece.box.max();
        const Vec2 middle = 0.5 * (low + high);
        Vec2 move = Vec2::Zero();
        switch (to) {
        case AlignTo::Left:
            move.x() = low.x();
            break;
        case AlignTo::Right:
            move.x() = high.x();
            break;
        case AlignTo::Bottom:
            move.y() = low.y();
            break;
        case AlignTo::Top:
            move.y() = high.y();
            break;
        case AlignTo::CentreU:
            move.x() = middle.x();
            break;
        case AlignTo::CentreV:
            move.y() = middle.y();
            break;
        }
        result.push_back(movedBy(move));
    }
    return result;
}

std::vector<Eigen::Affine2d> distributedPieces(std::span<const IslandPiece> pieces, Distribute distribute)
{
    std::vector<Eigen::Affine2d> result(pieces.size(), Eigen::Affine2d::Identity());
    if (pieces.size() < 3)
        return result;
    const int axis = distribute == Distribute::CentresU || distribute == Distribute::GapsU ? 0 : 1;
    const bool gaps = distribute == Distribute::GapsU || distribute == Distribute::GapsV;
    std::vector<int> order(pieces.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return pieces[a].box.center()[axis] < pieces[b].box.center()[axis];
    });
    const Eigen::AlignedBox2d &first = pieces[order.front()].box, &last = pieces[order.back()].box;
    const double steps = static_cast<double>(pieces.size() - 1);
    double gap = last.max()[axis] - first.min()[axis];
    for (const IslandPiece &piece : pieces)
        gap -= piece.box.sizes()[axis];
    gap /= steps;
    const double step = (last.center()[axis] - first.center()[axis]) / steps;
    double next = first.max()[axis] + gap;
    for (std::size_t i = 1; i + 1 < order.size(); ++i) {
        const Eigen::AlignedBox2d &box = pieces[order[i]].box;
        Vec2 move = Vec2::Zero();
        if (gaps)
            move[axis] = next - box.min()[axis];
        else
            move[axis] = first.center()[axis] + static_cast<double>(i) * step - box.center()[axis];
        next += box.sizes()[axis] + gap;
        result[order[i]] = movedBy(move);
    }
    return result;
}

Eigen::Affine2d mirroredPiece(const IslandPiece &piece, int axis)
{
    return about(piece.box.center(), Vec2(axis == 0 ? -1 : 1, axis == 0 ? 1 : -1).asDiagonal());
}

Eigen::Affine2d turnedAbout(const Vec2 &point, double angle)
{
    return angle == 0 ? Eigen::Affine2d(Eigen::Affine2d::Identity()) : about(point, rotation(angle));
}

Eigen::Affine2d scaledAbout(const Vec2 &point, const Vec2 &factor)
{
    return about(point, factor.asDiagonal());
}

Eigen::Affine2d turnedPiece(const IslandPiece &piece, double angle)
{
    return turnedAbout(piece.box.center(), angle);
}

Eigen::Affine2d fittedIntoTile(std::span<const IslandPiece> pieces, double border, double tileHeight)
{
    Eigen::AlignedBox2d box;
    for (const IslandPiece &piece : pieces)
        box.extend(piece.box);
    if (box.isEmpty() || !(box.sizes().maxCoeff() > 0))
        return Eigen::Affine2d::Identity();
    const Eigen::AlignedBox2d tile = tileAt(box.center(), tileHeight);
    const Vec2 room = tile.sizes() - Vec2::Constant(2 * border);
    const double factor = room.cwiseQuotient(box.sizes()).minCoeff();
    Eigen::Affine2d result = scaledAbout(box.center(), Vec2::Constant(factor));
    result.pretranslate(tile.center() - box.center());
    return result;
}

double turnToSmallestBox(std::span<const Vec2> points)
{
    std::vector<Vec2> finite;
    std::copy_if(points.begin(), points.end(), std::back_inserter(finite),
                 [](const Vec2 &p) { return p.allFinite(); });
    const std::vector<Vec2> hull = convexHull(std::move(finite));
    double best = 0, turn = 0;
    for (std::size_t i = 0; i < hull.size() && hull.size() >= 2; ++i) {
        const Vec2 along = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
        const Vec2 across(-along.y(), along.x());
        Eigen::AlignedBox2d box;
        for (const Vec2 &point : hull)
            box.extend(Vec2(along.dot(point), across.dot(point)));
        const double angle = smallestTurn(-std::atan2(along.y(), along.x()));
        // Among boxes of equal area, the one that needs the smaller turn is taken.
        const double area = box.volume();
        if (i == 0 || area < best * (1 - 1e-9) ||
            (area <= best * (1 + 1e-9) && std::abs(angle) < std::abs(turn))) {
            best = area;
            turn = angle;
        }
    }
    return std::abs(turn) < 1e-12 ? 0 : turn;
}

double turnToDirections(std::span<const Vec2> directions)
{
    // The fourth power maps directions that differ by quarter turns to the same one.
    std::complex<double> sum = 0;
    for (const Vec2 &direction : directions) {
        const double length = direction.norm();
        if (length > 0 && std::isfinite(length))
            sum += length * std::pow(std::complex(direction.x(), direction.y()) / length, 4);
    }
    const double turn = std::abs(sum) > 0 ? -std::arg(sum) / 4 : 0;
    return std::abs(turn) < 1e-12 ? 0 : turn;
}

std::vector<Eigen::Affine2d> scatteredPieces(std::span<const IslandPiece> pieces, const ScatterRanges &ranges)
{
    std::vector<Eigen::Affine2d> result;
    for (const IslandPiece &piece : pieces) {
        Dice dice(ranges.seed * 0x100000001ull + static_cast<std::uint64_t>(piece.islands.front()));
        const double u = dice.next(), v = dice.next();
        const double angle = ranges.angle * dice.next();
        const double factor = std::pow(1 + ranges.scale, dice.next());
        const Eigen::Affine2d turned = about(piece.box.center(), factor * rotation(angle));
        result.push_back(movedBy(ranges.move * Vec2(u, v)) * turned);
    }
    return result;
}

} // namespace autocuts
