#include "solver/straight/linenewton.h"

#include "model/plain/unionfind.h"
#include "solver/base/linesearch.h"
#include "solver/base/rigidfit.h"
#include "solver/linear/cholmodsolver.h"
#include "solver/search/trianglekernel.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::straight {

namespace {

// Chosen by hand.
constexpr int mostApproaches = 12;             // steps to the lines
constexpr int mostHalvings = 20;               // of the step length
constexpr std::size_t trianglesPerLook = 4096; // at the stop flag
constexpr double tolerance = 1e-7;  // predicted gain, as a share of the energy, below which steps end
constexpr double grounding = 1e-9;  // of the mean pivot, since nothing holds an island in its place
constexpr double leastSine = 0.342; // of the angle between two lines of one point: 20 degrees

using Pattern = std::vector<std::pair<int, int>>;

//! The opposite normal is that of the same line.
Vec2 unsignedNormal(const Vec2 &normal)
{
    return normal.x() < 0 || (normal.x() == 0 && normal.y() < 0) ? Vec2(-normal) : normal;
}

//! Per point, the lines that it stays on.
std::vector<std::array<int, 2>> linesAt(const std::vector<Line> &lines, int points)
{
    std::vector<std::array<int, 2>> at(points, {-1, -1});
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const int p : lines[i].points) {
            auto &[first, second] = at[p];
            if (first < 0)
                first = static_cast<int>(i);
            else if (second < 0 && std::abs(cross2({0, 0}, lines[first].normal, lines[i].normal)) > leastSine)
                second = static_cast<int>(i);
        }
    }
    return at;
}

//! The lines as the points of one half see them. A line that both halves see in another direction is
//! dropped. \param image per point: the one that stands for it
std::vector<Line> foldedLines(const std::vector<Line> &lines, const std::vector<int> &image)
{
    std::vector<Line> folded;
    for (const Line &line : lines) {
        Line own;
        bool fits = true;
        for (const int p : line.points) {
            const bool isImage = image[p] != p;
            const Vec2 normal =
                unsignedNormal(isImage ? Vec2(-line.normal.x(), line.normal.y()) : line.normal);
            fits = fits && (own.points.empty() || normal == own.normal);
            own.normal = normal;
            own.points.push_back(image[p]);
        }
        if (fits)
            folded.push_back(std::move(own));
    }
    return folded;
}

} // namespace

LineNewton::LineNewton(const Island &island, const std::vector<Line> &lines, const MirrorPoints &mirror)
    : mIsland(island), mLines(lines), mPlace(island.pointCount())
{
    std::vector<int> image(island.pointCount());
    std::vector<bool> onAxis(island.pointCount(), false);
    for (int p = 0; p < island.pointCount(); ++p) {
        image[p] = mirror.empty() ? p : std::min(p, mirror[p]);
        onAxis[p] = !mirror.empty() && mirror[p] == p;
    }
    placeOnLines(foldedLines(lines, image), image, onAxis);
    const Matrix reflection = Vec2(-1, 1).asDiagonal();
    for (int p = 0; p < island.pointCount(); ++p) {
        if (image[p] == p)
            continue;
        mPlace[p] = mPlace[image[p]];
        for (Source &source : mPlace[p].source)
            source.matrix = reflection * source.matrix;
    }
    analyze();
    for (const Island::Loop &loop : island.loops) {
        for (std::size_t i = 0; i < loop.point.size(); ++i)
            mBorder.addMoving(loop.point[i], loop.point[(i + 1) % loop.point.size()]);
    }
}

//! Expresses the points of one half by nodes.
void LineNewton::placeOnLines(const std::vector<Line> &lines, const std::vector<int> &image,
                              const std::vector<bool> &onAxis)
{
    const std::vector<std::array<int, 2>> at = linesAt(lines, mIsland.pointCount());
    UnionFind sets(static_cast<int>(lines.size()));
    std::vector<int> any(mIsland.pointCount(), -1);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const int p : lines[i].points) {
            for (const int other : at[p]) {
                if (other >= 0 && lines[other].normal == lines[i].normal)
                    sets.unite(other, static_cast<int>(i));
            }
        }
    }
    const auto [node, count] = sets.labels();
    mNodes = count;
    Matrix first = Matrix::Zero();
    for (int p = 0; p < mIsland.pointCount(); ++p) {
        if (image[p] != p)
            continue;
        const auto [one, other] = at[p];
        if (onAxis[p]) {
            // Its height is that of a line that crosses the axis, or its own.
            const int line = one >= 0 && std::abs(lines[one].normal.y()) > leastSine       ? one
                             : other >= 0 && std::abs(lines[other].normal.y()) > leastSine ? other
                                                                                           : -1;
            first << 0, 0, line < 0 ? 1 : 1 / lines[line].normal.y(), 0;
            mPlace[p].add(line < 0 ? mNodes++ : node[line], first);
        } else if (one < 0) {
            mPlace[p].add(mNodes++, Matrix::Identity());
        } else if (other < 0) {
            const Vec2 &n = lines[one].normal;
            first << n.x(), 0, n.y(), 0;
            mPlace[p].add(node[one], first);
            first << n.y(), 0, -n.x(), 0;
            mPlace[p].add(mNodes++, first);
        } else {
            Matrix normals;
            normals << lines[one].normal.transpose(), lines[other].normal.transpose();
            const Matrix inverse = normals.inverse();
            first << inverse.col(0), Vec2::Zero();
            mPlace[p].add(node[one], first);
            first << inverse.col(1), Vec2::Zero();
            mPlace[p].add(node[other], first);
        }
    }
}

void LineNewton::analyze()
{
    mUses.assign(2 * static_cast<std::size_t>(mNodes), false);
    for (const Place &place : mPlace) {
        for (int s = 0; s < place.count; ++s) {
            for (int k = 0; k < 2; ++k) {
                if (!place.source[s].matrix.col(k).isZero(0))
                    mUses[2 * place.source[s].node + k] = true;
            }
        }
    }
    Pattern pairs;
    const auto eachPair = [&](auto visit) {
        for (const auto &points : mIsland.points) {
            std::vector<int> nodes;
            for (const int p : points) {
                for (int s = 0; s < mPlace[p].count; ++s)
                    nodes.push_back(mPlace[p].source[s].node);
            }
            for (const int a : nodes) {
                for (const int b : nodes)
                    visit(a, b);
            }
        }
    };
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < mNodes; ++i)
        entries.emplace_back(i, i, 1);
    eachPair([&](int a, int b) {
        if (a > b)
            entries.emplace_back(a, b, 1);
    });
    linear::LinearSolver::Matrix lower(mNodes, mNodes);
    lower.setFromTriplets(entries.begin(), entries.end());
    mRank = linear::eliminationRanks(lower);
    eachPair([&](int a, int b) {
        if (mRank[a] > mRank[b])
            pairs.emplace_back(mRank[a], mRank[b]);
    });
    mSystem.analyze(mNodes, pairs);
}

//! The nodes with which the points lie as near to their positions as lines allow.
std::vector<Vec2> LineNewton::nodesOf(const Positions &position) const
{
    std::vector<Vec2> nodes(mNodes, Vec2::Zero());
    std::vector<Vec2> weight(mNodes, Vec2::Zero());
    for (std::size_t p = 0; p < mPlace.size(); ++p) {
        Matrix all[2];
        const Place &place = mPlace[p];
        for (int s = 0; s < place.count; ++s)
            all[s] = place.source[s].matrix;
        // The columns in use are independent: their coefficients follow from the position.
        Eigen::Matrix<double, 2, 4> columns = Eigen::Matrix<double, 2, 4>::Zero();
        for (int s = 0; s < place.count; ++s)
            columns.middleCols<2>(2 * s) = all[s];
        std::array<int, 2> used{-1, -1};
        int count = 0;
        for (int k = 0; k < 4 && count < 2; ++k) {
            if (!columns.col(k).isZero(0))
                used[count++] = k;
        }
        Vec2 value;
        if (count == 2) {
            Matrix basis;
            basis << columns.col(used[0]), columns.col(used[1]);
            value = basis.inverse() * position[p];
        } else {
            const Vec2 only = columns.col(used[0]);
            value = Vec2(only.dot(position[p]) / only.squaredNorm(), 0);
        }
        for (int i = 0; i < count; ++i) {
            const int node = place.source[used[i] / 2].node, k = used[i] % 2;
            nodes[node][k] += value[i];
            weight[node][k] += 1;
        }
    }
    for (int i = 0; i < mNodes; ++i)
        nodes[i] = nodes[i].cwiseQuotient(weight[i].cwiseMax(1));
    return nodes;
}

Vec2 LineNewton::pointOf(const std::vector<Vec2> &nodes, int point) const
{
    const Place &place = mPlace[point];
    Vec2 sum = place.source[0].matrix * nodes[place.source[0].node];
    if (place.count > 1)
        sum += place.source[1].matrix * nodes[place.source[1].node];
    return sum;
}

//! Adds a triangle to the system. \param gradient,hessian over its corners
void LineNewton::addTriangle(const std::array<int, 3> &points, const Corners &gradient,
                             const CornerMatrix &hessian, std::vector<double> &right)
{
    for (int a = 0; a < 3; ++a) {
        const Place &row = mPlace[points[a]];
        for (int i = 0; i < row.count; ++i) {
            const int r = mRank[row.source[i].node];
            const Matrix left = row.source[i].matrix.transpose();
            const Vec2 force = left * gradient.segment<2>(2 * a);
            right[2 * r] -= force.x();
            right[2 * r + 1] -= force.y();
            for (int b = 0; b < 3; ++b) {
                const Place &column = mPlace[points[b]];
                for (int j = 0; j < column.count; ++j) {
                    const int c = mRank[column.source[j].node];
                    if (r < c)
                        continue;
                    const Matrix block = left * hessian.block<2, 2>(2 * a, 2 * b) * column.source[j].matrix;
                    search::BlockCholesky::Block &to =
                        r == c ? mSystem.diagonal(r) : mSystem.offDiagonal(mSystem.place(r, c));
                    for (int k = 0; k < 4; ++k)
                        to[k] += block(k / 2, k % 2);
                }
            }
        }
    }
}

//! Sets the system of a step to the minimum of the quadratic model. \param shift how the points move besides
//! \param right receives the right-hand side, two numbers per node \returns false when stopped
bool LineNewton::assemble(const Positions &position, const Positions &shift, std::vector<double> &right,
                          const JobContext &job)
{
    mSystem.clear();
    right.assign(2 * static_cast<std::size_t>(mNodes), 0);
    double trace = 0;
    for (std::size_t t = 0; t < mIsland.points.size(); ++t) {
        if (t % trianglesPerLook == 0 && job.stopped())
            return false;
        const auto &points = mIsland.points[t];
        double at[6], g[6], h[21];
        Corners gradient, moved;
        CornerMatrix hessian;
        for (int i = 0; i < 6; ++i) {
            at[i] = position[points[i / 2]][i % 2];
            moved[i] = shift[points[i / 2]][i % 2];
        }
        search::triangleDerivatives(at, mIsland.basis[t], mIsland.stiffWeight(t), g, h);
        for (int i = 0, k = 0; i < 6; ++i) {
            gradient[i] = g[i];
            for (int j = 0; j <= i; ++j, ++k)
                hessian(i, j) = hessian(j, i) = h[k];
        }
        trace += hessian.trace();
        gradient += hessian * moved;
        addTriangle(points, gradient, hessian, right);
    }
    const double ground = grounding * trace / std::max<double>(1, 6.0 * double(mIsland.points.size()));
    for (int i = 0; i < mNodes; ++i) {
        search::BlockCholesky::Block &diagonal = mSystem.diagonal(mRank[i]);
        for (int k = 0; k < 2; ++k)
            diagonal[3 * k] += mFrozen[i] ? frozenPivot : mUses[2 * i + k] ? ground : 1;
    }
    return true;
}

double LineNewton::flipFreeStep(const Positions &position, const Positions &direction) const
{
    double step = 1 / flipMargin;
    for (const auto &[a, b, c] : mIsland.points) {
        const Vec2 e1 = position[b] - position[a], e2 = position[c] - position[a];
        const Vec2 d1 = direction[b] - direction[a], d2 = direction[c] - direction[a];
        step = search::flipFreeTriangleStep({e1.x(), e1.y(), e2.x(), e2.y()},
                                            {d1.x(), d1.y(), d2.x(), d2.y()}, step);
    }
    return flipMargin * step;
}

//! Solves for the step to the minimum of the quadratic model. Sets mChange and mDirection.
//! \returns the slope of the energy along what the step changes besides the way to the lines; nothing when
//! stopped
std::optional<double> LineNewton::findDirection(const Positions &position, const JobContext &job)
{
    for (int p = 0; p < mIsland.pointCount(); ++p)
        mDirection[p] = -mLeft * mAway[p];
    std::vector<double> right;
    if (!assemble(position, mDirection, right, job) || !mSystem.factorize(job))
        return std::nullopt;
    std::vector<double> solution = right;
    mSystem.solve(solution.data());
    double slope = 0;
    for (int i = 0; i < mNodes; ++i) {
        const std::size_t at = 2 * static_cast<std::size_t>(mRank[i]);
        mChange[i] = mFrozen[i] ? Vec2::Zero() : Vec2(solution[at], solution[at + 1]);
        slope -= mChange[i].dot(Vec2(right[at], right[at + 1]));
    }
    for (int p = 0; p < mIsland.pointCount(); ++p)
        mDirection[p] += pointOf(mChange, p);
    return slope;
}

//! Takes as much of the step as keeps the island valid. \returns false when the energy does not fall, or
//! sides of the border cross at the last attempt
bool LineNewton::takeStep(Positions &position, double slope, double &energy)
{
    double length = std::min(1.0, flipFreeStep(position, mDirection));
    int contacts = 0;
    std::vector<Vec2> nodes;
    for (int halving = 0; halving <= mostHalvings; ++halving, length *= 0.5) {
        nodes = mNode;
        for (int i = 0; i < mNodes; ++i)
            nodes[i] += length * mChange[i];
        const bool arrives = mLeft == 0 || length == 1;
        for (int p = 0; p < mIsland.pointCount(); ++p)
            mTrial[p] = arrives ? pointOf(nodes, p) : Vec2(position[p] + length * mDirection[p]);
        const double after = mIsland.energy(mTrial);
        if (!std::isfinite(after) || (mLeft == 0 && after > energy + armijo * length * slope))
            continue;
        if (borderCrosses()) {
            if (++contacts > contactHalvings)
                return false;
            continue;
        }
        energy = after;
        mNode.swap(nodes);
        mLeft *= 1 - length;
        position.swap(mTrial);
        return true;
    }
    return false;
}

//! True when sides of the border cross in mTrial. \param touched receives their points; null: not wanted
bool LineNewton::borderCrosses(std::vector<int> *touched)
{
    std::vector<double> flat;
    for (const Vec2 &p : mTrial)
        flat.insert(flat.end(), {p.x(), p.y()});
    return mBorder.cross(flat, touched);
}

bool LineNewton::step(Positions &position, double &energy, const JobContext &job)
{
    std::fill(mFrozen.begin(), mFrozen.end(), 0);
    for (int round = 0; round < freezeRounds; ++round) {
        const std::optional<double> slope = findDirection(position, job);
        if (!slope || (mLeft == 0 && !(*slope < -tolerance * energy)))
            return false;
        if (takeStep(position, *slope, energy))
            return true;
        std::vector<int> touched;
        if (!borderCrosses(&touched))
            return false;
        for (const int p : touched) {
            for (int s = 0; s < mPlace[p].count; ++s)
                mFrozen[mPlace[p].source[s].node] = 1;
        }
    }
    return false;
}

std::optional<double> LineNewton::minimize(Positions &position, int steps, const JobContext &job)
{
    const int count = mIsland.pointCount();
    mNode = nodesOf(position);
    mChange.resize(mNodes);
    mFrozen.assign(mNodes, 0);
    mDirection.resize(count);
    mTrial.resize(count);
    mAway.resize(count);
    mLeft = 0;
    for (int p = 0; p < count; ++p) {
        mAway[p] = position[p] - pointOf(mNode, p);
        if (mAway[p] != Vec2::Zero())
            mLeft = 1;
    }
    double energy = mIsland.energy(position);
    for (int approach = 0; approach < mostApproaches && mLeft > 0; ++approach) {
        if (!step(position, energy, job))
            return std::nullopt;
    }
    for (int i = 0; i < steps && mLeft == 0; ++i) {
        if (!step(position, energy, job))
            break;
    }
    return mLeft > 0 || job.stopped() ? std::nullopt : std::optional(energy);
}

std::vector<double> LineNewton::costs(const Positions &position, const Positions &free) const
{
    Positions gradient(mIsland.pointCount(), Vec2::Zero());
    std::vector<PointMatch> matches(mIsland.pointCount());
    for (std::size_t t = 0; t < mIsland.points.size(); ++t) {
        double at[6], g[6], h[21];
        for (int i = 0; i < 6; ++i)
            at[i] = position[mIsland.points[t][i / 2]][i % 2];
        search::triangleDerivatives(at, mIsland.basis[t], mIsland.stiffWeight(t), g, h);
        for (int i = 0; i < 6; ++i)
            gradient[mIsland.points[t][i / 2]][i % 2] += g[i];
    }
    for (int p = 0; p < mIsland.pointCount(); ++p)
        matches[p] = {position[p], free[p]};
    const RigidMotion motion = fitRigid(matches);
    const std::vector<std::array<int, 2>> at = linesAt(mLines, mIsland.pointCount());
    std::vector<double> costs(mLines.size(), 0);
    for (int p = 0; p < mIsland.pointCount(); ++p) {
        const auto [one, other] = at[p];
        if (one < 0)
            continue;
        // The force of the lines at the point, times half the way that it moved the point.
        const Vec2 way = position[p] - (motion.fixedCentre + motion.turned(free[p] - motion.movingCentre));
        Vec2 force(gradient[p].dot(mLines[one].normal), 0);
        if (other >= 0) {
            Matrix normals;
            normals << mLines[one].normal, mLines[other].normal;
            force = normals.inverse() * gradient[p];
            costs[other] += 0.5 * force.y() * mLines[other].normal.dot(way);
        }
        costs[one] += 0.5 * force.x() * mLines[one].normal.dot(way);
    }
    return costs;
}

} // namespace autocuts::straight
