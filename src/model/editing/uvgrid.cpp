#include "model/editing/uvgrid.h"

#include "model/plain/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace autocuts {

namespace {

using Cell = std::array<int, 2>; //!< column and row of a point

Cell operator+(const Cell &a, const Cell &b)
{
    return {a[0] + b[0], a[1] + b[1]};
}

Cell operator-(const Cell &a, const Cell &b)
{
    return {a[0] - b[0], a[1] - b[1]};
}

//! The step after one to the left.
Cell turned(const Cell &step)
{
    return {-step[1], step[0]};
}

//! Mean lengths of the steps between neighbouring columns, or rows.
class Widths
{
public:
    void add(int from, double length)
    {
        Sum &sum = mSums[from];
        sum.length += length;
        ++sum.count;
    }
    //! The place of a column. \pre from the first to the last one there is an edge at every step
    std::map<int, double> places(int first, int last) const
    {
        std::map<int, double> result{{first, 0}};
        for (int i = first; i < last; ++i)
            result[i + 1] = result[i] + mSums.at(i).length / mSums.at(i).count;
        return result;
    }

private:
    struct Sum
    {
        double length = 0;
        int count = 0;
    };
    std::map<int, Sum> mSums;
};

//! Straightens the grids among some faces.
class GridFinder
{
public:
    GridFinder(const MeshData &mesh, const UvTopology &topology, const UvMatrix &uv,
               const std::vector<int> &faces)
        : mMesh(mesh), mTopology(topology), mUv(uv)
    {
        for (const int f : faces) {
            if (!isQuad(f)) {
                mResult.left.push_back(f);
                continue;
            }
            mWaiting.insert(f);
            for (int k = 0; k < 4; ++k)
                mFaceAt[{point(f, k), point(f, k + 1)}] = {f, k};
        }
    }

    UvGrids run()
    {
        while (!mWaiting.empty()) {
            const std::vector<int> faces = takeConnected(*mWaiting.begin());
            if (const auto cells = cellsOf(faces))
                mResult.grids.push_back(straightened(faces, *cells));
            else
                mResult.left.insert(mResult.left.end(), faces.begin(), faces.end());
        }
        std::sort(mResult.left.begin(), mResult.left.end());
        return std::move(mResult);
    }

private:
    bool isQuad(int face) const
    {
        if (mMesh.faceStart[face + 1] - mMesh.faceStart[face] != 4 || !mTopology.faceHasUv[face])
            return false;
        std::set<int> points;
        for (int k = 0; k < 4; ++k)
            points.insert(point(face, k));
        return points.size() == 4;
    }

    int point(int face, int k) const { return mTopology.cornerRoot[mMesh.faceStart[face] + k % 4]; }
    double length(int face, int k) const
    {
        const int start = mMesh.faceStart[face];
        return (mMesh.cornerPosition(start + k % 4) - mMesh.cornerPosition(start + (k + 1) % 4)).norm();
    }

    //! The face on the other side of an edge in the map, and which of its edges that is.
    std::optional<std::pair<int, int>> across(int face, int k) const
    {
        const auto other = mFaceAt.find({point(face, k + 1), point(face, k)});
        return other == mFaceAt.end() ? std::nullopt : std::optional(other->second);
    }

    std::vector<int> takeConnected(int first)
    {
        std::vector<int> faces{first};
        mWaiting.erase(first);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            for (int k = 0; k < 4; ++k) {
                if (const auto other = across(faces[i], k); other && mWaiting.erase(other->first) > 0)
                    faces.push_back(other->first);
            }
        }
        std::sort(faces.begin(), faces.end());
        return faces;
    }

    //! Column and row of each point; nothing when the faces are not a part of a grid.
    std::optional<std::map<int, Cell>> cellsOf(const std::vector<int> &faces) const
    {
        std::map<int, Cell> cells;
        std::map<Cell, int> pointAt;
        const auto put = [&](int p, const Cell &cell) {
            return cells.try_emplace(p, cell).first->second == cell &&
                   pointAt.try_emplace(cell, p).first->second == p;
        };
        //! A face, and the cell and direction of its first edge.
        struct Placed
        {
            int face;
            Cell at, step;
        };
        std::vector<Placed> placed{{faces.front(), {0, 0}, {1, 0}}};
        std::set<int> seen{faces.front()};
        for (std::size_t i = 0; i < placed.size(); ++i) {
            auto [face, at, step] = placed[i];
            for (int k = 0; k < 4; ++k) {
                const Cell next = at + step;
                if (!put(point(face, k), at) || !put(point(face, k + 1), next))
                    return std::nullopt;
                if (const auto other = across(face, k); other && seen.insert(other->first).second) {
                    // On the other side the edge goes from `next` to `at`; take the steps back to its first
                    // edge.
                    Cell cell = next, back = at - next;
                    for (int turn = other->second; turn > 0; --turn) {
                        back = turned(turned(turned(back)));
                        cell = cell - back;
                    }
                    placed.push_back({other->first, cell, back});
                }
                at = next;
                step = turned(step);
            }
        }
        return cells;
    }

    UvGrid straightened(const std::vector<int> &faces, const std::map<int, Cell> &cells) const
    {
        std::array<Widths, 2> widths;
        std::set<std::pair<int, int>> measured;
        double area3d = 0, areaUv = 0;
        for (const int face : faces) {
            for (int k = 0; k < 4; ++k) {
                const std::pair<int, int> edge = std::minmax(point(face, k), point(face, k + 1));
                const Cell a = cells.at(edge.first), b = cells.at(edge.second);
                const int axis = a[0] == b[0] ? 1 : 0;
                if (measured.insert(edge).second)
                    widths[axis].add(std::min(a[axis], b[axis]),
                                     mMesh.texelWeightOf(mMesh.faceTriangle[face]) * length(face, k));
            }
            for (const int t : mMesh.trianglesOf(face)) {
                const auto &c = mMesh.triangles[t];
                area3d += mMesh.targetArea(t);
                areaUv += cross2(mUv.row(c[0]), mUv.row(c[1]), mUv.row(c[2])) / 2;
            }
        }
        Cell low = cells.begin()->second, high = low;
        for (const auto &[p, cell] : cells) {
            for (int axis = 0; axis < 2; ++axis) {
                low[axis] = std::min(low[axis], cell[axis]);
                high[axis] = std::max(high[axis], cell[axis]);
            }
        }
        const auto columns = widths[0].places(low[0], high[0]), rows = widths[1].places(low[1], high[1]);
        const double density = area3d > 0 ? std::sqrt(std::abs(areaUv) / area3d) : 1;
        UvGrid grid{faces, {}};
        for (const auto &[p, cell] : cells)
            grid.places.emplace_back(
                p, density * Vec2(columns.at(cell[0]), (areaUv < 0 ? -1 : 1) * rows.at(cell[1])));
        lay(grid);
        return grid;
    }

    //! Turns the grid by quarters to where its points are now, and moves it there.
    void lay(UvGrid &grid) const
    {
        Vec2 centre = Vec2::Zero(), before = Vec2::Zero();
        for (const auto &[p, place] : grid.places) {
            centre += place;
            before += Vec2(mUv.row(p));
        }
        const double count = static_cast<double>(grid.places.size());
        centre /= count;
        before /= count;
        double along = 0, across = 0;
        for (const auto &[p, place] : grid.places) {
            const Vec2 from = place - centre, to = Vec2(mUv.row(p)) - before;
            along += from.dot(to);
            across += from.x() * to.y() - from.y() * to.x();
        }
        const bool isQuarter = std::abs(across) > std::abs(along);
        const double sign = (isQuarter ? across : along) < 0 ? -1 : 1;
        for (auto &[p, place] : grid.places) {
            const Vec2 from = sign * (place - centre);
            place = before + (isQuarter ? Vec2(-from.y(), from.x()) : from);
        }
    }

    const MeshData &mMesh;
    const UvTopology &mTopology;
    const UvMatrix &mUv;
    std::set<int> mWaiting;
    //! The face and its edge from one point to another.
    std::map<std::pair<int, int>, std::pair<int, int>> mFaceAt;
    UvGrids mResult;
};

} // namespace

UvGrids findUvGrids(const MeshData &mesh, const UvTopology &topology, const UvMatrix &uv,
                    const std::vector<int> &faces)
{
    return GridFinder(mesh, topology, uv, faces).run();
}

} // namespace autocuts
