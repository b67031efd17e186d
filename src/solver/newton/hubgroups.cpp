#include "solver/newton/hubgroups.h"

#include "model/plain/unionfind.h"

#include <algorithm>
#include <numeric>

namespace autocuts::newton {

namespace {

//! How many pairs may have opened within hubs, and how many may have closed between hubs, before the groups
//! are built again. Measured: the iterations grow with the number of these pairs, not with their share of the
//! mesh. With shares instead, 1 % was far too late on 124,000 triangles and 0.02 % too early on small meshes.
constexpr int changesTolerated = 64;
//! The limit on small meshes, as a share of all pairs. Chosen by hand.
constexpr double shareTolerated = 0.01;

//! Calls visit(row, column) with row > column for every two hubs that a triangle or a spring connects.
template <class Visit>
void visitTies(const Soup &soup, const HubGroups &groups, Visit &&visit)
{
    const auto tie = [&](int a, int b) {
        if (a >= 0 && b >= 0 && a != b)
            visit(std::max(a, b), std::min(a, b));
    };
    for (int t = 0; t < soup.triangleCount(); ++t) {
        const int *hub = &groups.hub[3 * static_cast<std::size_t>(t)];
        tie(hub[0], hub[1]);
        tie(hub[1], hub[2]);
        tie(hub[2], hub[0]);
    }
    for (const auto &corners : soup.pairCorners)
        tie(groups.hub[corners[0]], groups.hub[corners[1]]);
}

} // namespace

HubGroups HubGroups::build(const Soup &soup, const energy::HessianBlocks &blocks,
                           const std::vector<int> &rank)
{
    const MeshData &mesh = *soup.mesh;
    const int corners = mesh.soupCornerCount();
    UnionFind sets(corners);
    for (std::size_t p = 0; p < soup.pairCorners.size(); ++p) {
        if (blocks.pairClosed[p])
            sets.unite(soup.pairCorners[p][0], soup.pairCorners[p][1]);
    }
    std::vector<int> root(corners), size(corners, 0);
    for (int c = 0; c < corners; ++c)
        ++size[root[c] = sets.find(c)];
    // Groups ordered by the rank of their vertex, then by their root (counting sort).
    std::vector<int> next(rank.size() + 1, 0);
    for (int c = 0; c < corners; ++c) {
        if (root[c] == c && size[c] > 1)
            ++next[rank[mesh.vertexOfSoup(c)] + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    HubGroups groups;
    groups.count = next.back();
    groups.begin.assign(groups.count + 1, 0);
    std::vector<int> number(corners, -1);
    for (int c = 0; c < corners; ++c) {
        if (root[c] != c || size[c] < 2)
            continue;
        number[c] = next[rank[mesh.vertexOfSoup(c)]]++;
        groups.begin[number[c] + 1] = size[c];
    }
    std::partial_sum(groups.begin.begin(), groups.begin.end(), groups.begin.begin());
    groups.hub.resize(corners);
    groups.corners.resize(corners);
    std::vector<int> place(groups.begin);
    int alone = groups.begin.back();
    for (int c = 0; c < corners; ++c) {
        groups.hub[c] = number[root[c]];
        groups.corners[groups.hub[c] < 0 ? alone++ : place[groups.hub[c]]++] = c;
    }
    return groups;
}

bool HubGroups::stillFit(const Soup &soup, const energy::HessianBlocks &blocks) const
{
    int opened = 0, closed = 0;
    for (std::size_t p = 0; p < soup.pairCorners.size(); ++p) {
        const int a = hub[soup.pairCorners[p][0]], b = hub[soup.pairCorners[p][1]];
        const bool together = a >= 0 && a == b;
        closed += blocks.pairClosed[p] && !together;
        opened += together && !blocks.pairClosed[p];
    }
    const double tolerated = std::min<double>(changesTolerated, shareTolerated * soup.pairCorners.size());
    return closed <= tolerated && opened <= tolerated;
}

void HubMatrix::setPattern(const Soup &soup, const HubGroups &groups)
{
    const int n = groups.count;
    std::vector<int> begin(n + 1, 0);
    visitTies(soup, groups, [&](int, int column) { ++begin[column + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<int> rows(begin.back()), next(begin.begin(), begin.end() - 1);
    visitTies(soup, groups, [&](int row, int column) { rows[next[column]++] = row; });
    int end = 0;
    for (int column = 0; column < n; ++column) {
        const auto first = rows.begin() + begin[column], last = rows.begin() + begin[column + 1];
        std::sort(first, last);
        const auto unique = std::unique(first, last);
        begin[column] = end;
        end += static_cast<int>(std::copy(first, unique, rows.begin() + end) - (rows.begin() + end));
    }
    begin[n] = end;

    mMatrix.resize(2 * n, 2 * n);
    mMatrix.resizeNonZeros(4 * end + 3 * n);
    int *outer = mMatrix.outerIndexPtr(), *inner = mMatrix.innerIndexPtr();
    int at = 0;
    for (int column = 0; column < 2 * n; ++column) {
        outer[column] = at;
        for (int i = column; i < (column / 2 + 1) * 2; ++i)
            inner[at++] = i;
        for (int k = begin[column / 2]; k < begin[column / 2 + 1]; ++k) {
            inner[at++] = 2 * rows[k];
            inner[at++] = 2 * rows[k] + 1;
        }
    }
    outer[2 * n] = at;

    // Positions of the block of each triangle and each pair, in the order in which fill() visits them.
    mPlaces.clear();
    visitTies(soup, groups, [&](int row, int column) {
        const auto first = rows.begin() + begin[column];
        const auto found = std::lower_bound(first, rows.begin() + begin[column + 1], row);
        mPlaces.push_back(outer[2 * column] + 2 + 2 * static_cast<int>(found - first));
    });
}

//! \param place position of the block's first value in the first of its two columns
double *HubMatrix::secondColumn(int place, int column)
{
    const int *outer = mMatrix.outerIndexPtr();
    return mMatrix.valuePtr() + place + outer[2 * column + 1] - outer[2 * column] - 1;
}

//! \returns how many of `places` belong to the triangle
int HubMatrix::addTriangle(const int *hub, const int *places, const BlockInverse &inverse, int lane)
{
    double *values = mMatrix.valuePtr();
    const int *outer = mMatrix.outerIndexPtr();
    // -D S^-1 D = -D diag(give) D + F E^T C E F with F = D diag(give).
    float share[6], stiffness[10], edges[6][6];
    for (int i = 0; i < 6; ++i)
        share[i] = inverse.star[i / 2][lane] * inverse.give[i][lane];
    for (int i = 0; i < 10; ++i)
        stiffness[i] = inverse.stiffness[i][lane];
    constexpr int place[4] = {2, 4, 3, 5}; // position of an edge vector's end among the six coordinates
    int at = 0;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j <= i; ++j)
            edges[place[i]][place[j]] = edges[place[j]][place[i]] = stiffness[at++];
    }
    for (int axis = 0; axis < 2; ++axis) {
        for (int i = 2; i < 6; ++i)
            edges[axis][i] = edges[i][axis] = -(edges[2 + axis][i] + edges[4 + axis][i]);
    }
    for (int axis = 0; axis < 2; ++axis) {
        for (int i = 0; i < 2; ++i)
            edges[axis][i] = -(edges[2 + axis][i] + edges[4 + axis][i]);
    }
    const auto entry = [&](int i, int j) { return double(share[i]) * edges[i][j] * share[j]; };
    for (int a = 0; a < 3; ++a) {
        if (hub[a] < 0)
            continue;
        double *diagonal = values + outer[2 * hub[a]];
        const float star = inverse.star[a][lane];
        diagonal[0] += star * (1 - double(share[2 * a])) + entry(2 * a, 2 * a);
        diagonal[1] += entry(2 * a + 1, 2 * a);
        values[outer[2 * hub[a] + 1]] += star * (1 - double(share[2 * a + 1])) + entry(2 * a + 1, 2 * a + 1);
    }
    int used = 0;
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3;
        if (hub[a] < 0 || hub[b] < 0)
            continue;
        if (hub[a] == hub[b]) {
            // Two corners of one triangle in one hub: both symmetric halves add to the diagonal block.
            double *diagonal = values + outer[2 * hub[a]];
            diagonal[0] += 2 * entry(2 * a, 2 * b);
            diagonal[1] += entry(2 * a + 1, 2 * b) + entry(2 * a, 2 * b + 1);
            values[outer[2 * hub[a] + 1]] += 2 * entry(2 * a + 1, 2 * b + 1);
            continue;
        }
        const int i = hub[a] > hub[b] ? a : b, j = a + b - i; // row and column
        double *first = values + places[used];
        double *second = secondColumn(places[used++], hub[j]);
        first[0] += entry(2 * i, 2 * j);
        first[1] += entry(2 * i + 1, 2 * j);
        second[0] += entry(2 * i, 2 * j + 1);
        second[1] += entry(2 * i + 1, 2 * j + 1);
    }
    return used;
}

void HubMatrix::fill(const Soup &soup, const energy::HessianBlocks &blocks, const HubGroups &groups,
                     const std::vector<BlockInverse> &inverses)
{
    double *values = mMatrix.valuePtr();
    const int *outer = mMatrix.outerIndexPtr();
    std::fill(values, values + mMatrix.nonZeros(), 0.0);
    const int *place = mPlaces.data();
    for (int t = 0; t < soup.triangleCount(); ++t)
        place += addTriangle(&groups.hub[3 * static_cast<std::size_t>(t)], place, inverses[t / laneCount],
                             t % laneCount);
    for (std::size_t p = 0; p < soup.pairCorners.size(); ++p) {
        const int a = groups.hub[soup.pairCorners[p][0]], b = groups.hub[soup.pairCorners[p][1]];
        if (a < 0 || b < 0 || a == b)
            continue;
        const double w = blocks.pair[p];
        values[*place] -= w;
        secondColumn(*place++, std::min(a, b))[1] -= w;
        for (const int hub : {a, b}) {
            values[outer[2 * hub]] += w;
            values[outer[2 * hub + 1]] += w;
        }
    }
}

void HubMatrix::addToDiagonal(double shift)
{
    for (int i = 0; i < mMatrix.cols(); ++i)
        mMatrix.valuePtr()[mMatrix.outerIndexPtr()[i]] += shift;
}

} // namespace autocuts::newton
