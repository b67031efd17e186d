#include "solver/rigid/rigidregions.h"

#include "solver/base/constant.h"
#include "solver/rigid/surfaceshape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

namespace autocuts::rigid {

namespace {

constexpr double degree = std::numbers::pi / 180;
//! Edges from this angle on are sharp: borders of regions. The angle of creases (preference/creases).
const double sharpCosine = std::cos(40 * degree);
//! Borders that do for large regions, such as those to a bevel.
const double softCosine = std::cos(10 * degree);
//! Share of the mesh's area, or of its component's, from which a region is seen.
constexpr double leastArea = 2e-4, leastPart = 0.01;
//! Components that have less than this share of the largest one's area are dust: nobody sees their shape.
constexpr double dust = 1e-4;
constexpr double leastSharp = 0.5; // share of the border
//! Area of a flat region beside the mean polygon from which soft borders do; the same as a share of the
//! mesh's area.
AUTOCUTS_CONSTANT(double, largeFace, 20);
constexpr double leastSoftArea = 5e-3;
//! Thin triangles belong to a plane when their corners lie in it. Share of the mesh's size.
constexpr double planeDistance = 2e-6;
//! A developable region with smooth borders needs this many inner vertices without defect, and this share of
//! the area. A curved region needs the latter.
constexpr int leastInner = 12;
constexpr double leastSmoothArea = 0.01;

//! A connected component is made of flat faces, or what unrolls, when these have this share of its area. In
//! others only clear caps keep their shape: of many triangles or much larger than the polygons around, with a
//! sharp border.
AUTOCUTS_CONSTANT(double, hardShare, 0.43);
constexpr double clearBorder = 0.6;
constexpr int capTriangles = 6;
//! Share of sharp border with which a developable ring without inner vertices needs no creases.
constexpr double ringBorder = 0.9;
//! Share of its component that a developable ring has at least. The narrow rings of a turned shape may be
//! stretched.
constexpr double leastDevelopable = 0.1;

//! A curved region: least share of its border that is soft or sharp, of flat places in its area at most, and
//! how much its inner vertices bend it, the sum of their angle defects without sign. Radians; a hemisphere
//! has 2 pi.
constexpr double panelBorder = 0.9, mostFlatOfPanel = 0.2;
//! Where its border is soft, least share of its component that is in regions.
constexpr double softPanelShare = 0.9;
constexpr double leastPanelBend = 0.01, mostPanelBend = 0.5;

constexpr int thinSweeps = 16; // in which thin triangles join the regions beside them

class RegionFinder
{
public:
    RegionFinder(const MeshData &mesh, const std::vector<bool> &creases, const std::vector<bool> &bent)
        : mMesh(mesh), mShape(mesh),
          mBent(bent.empty() ? std::vector<bool>(mesh.triangleCount(), false) : bent),
          mCrease(mesh.soupCornerCount(), false), mRegion(mesh.triangleCount(), -1)
    {
        for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
            const EdgePair &pair = mesh.edgePairs[e];
            for (int which = 0; which < 2 && creases[e]; ++which)
                mCrease[3 * pair.triangle[which] + pair.side(which)] = true;
        }
        mComponentArea.assign(mesh.componentCount, 0);
        for (int t = 0; t < mesh.triangleCount(); ++t)
            mComponentArea[mesh.component[t]] += mesh.triangleArea[t];
        mDust = dust * *std::max_element(mComponentArea.begin(), mComponentArea.end());
    }

    RigidRegions find()
    {
        do {
            std::fill(mRegion.begin(), mRegion.end(), -1);
            mKind.clear();
            mCurved.clear();
            mCount = 0;
            findFlat();
            findPanels();
            findDevelopable();
        } while (refuseSoftPanels());
        dropFromCurvedComponents();
        takeInThinTriangles();
        return {std::move(mRegion), mCount, 0, std::move(mCurved), {}, {}};
    }

private:
    Vec3 cornerPosition(int soupCorner) const { return mMesh.cornerPosition(mMesh.cornerOfSoup(soupCorner)); }

    bool liesInPlane(int t, const Vec3 &normal, const Vec3 &origin) const
    {
        for (int k = 0; k < 3; ++k) {
            if (std::abs(normal.dot(cornerPosition(3 * t + k) - origin)) > planeDistance * mShape.size)
                return false;
        }
        return true;
    }

    //! Marks the triangles that can be reached from one over sides that pass a test. \returns them
    template <typename Test>
    std::vector<int> reach(int from, std::vector<int> &mark, int number, Test passes) const
    {
        std::vector<int> found{from};
        mark[from] = number;
        for (std::size_t i = 0; i < found.size(); ++i) {
            for (int side = 3 * found[i]; side < 3 * found[i] + 3; ++side) {
                const int across = mShape.uncut.neighbour[side];
                if (across < 0 || mark[across / 3] >= 0 || !passes(found[i], across / 3))
                    continue;
                mark[across / 3] = number;
                found.push_back(across / 3);
            }
        }
        return found;
    }

    bool sameTexels(int a, int b) const { return mMesh.texelWeightOf(a) == mMesh.texelWeightOf(b); }

    struct Border
    {
        double all = 0, crease = 0, sharp = 0, soft = 0;
    };
    //! Length of the border of marked triangles, and how much of it is open or a crease, open or sharp, open
    //! or soft.
    Border borderOf(const std::vector<int> &triangles, const std::vector<int> &mark) const
    {
        Border border;
        for (const int t : triangles) {
            for (int side = 3 * t; side < 3 * t + 3; ++side) {
                const int across = mShape.uncut.neighbour[side];
                if (across >= 0 && mark[across / 3] == mark[t])
                    continue;
                const double length = (cornerPosition(3 * t + (side + 1) % 3) - cornerPosition(side)).norm();
                const double cosine = across < 0 ? -1 : mShape.normal[t].dot(mShape.normal[across / 3]);
                border.all += length;
                border.crease += across < 0 || mCrease[side] || mShape.thin[across / 3] ? length : 0;
                border.sharp += cosine < sharpCosine || (across >= 0 && mShape.thin[across / 3]) ? length : 0;
                border.soft += cosine < softCosine ? length : 0;
            }
        }
        return border;
    }

    double areaOf(const std::vector<int> &triangles) const
    {
        double area = 0;
        for (const int t : triangles)
            area += mMesh.triangleArea[t];
        return area;
    }

    bool isLarge(double area, int triangle) const
    {
        const double component = mComponentArea[mMesh.component[triangle]];
        return area >= leastArea * mShape.wholeArea || (area >= leastPart * component && component >= mDust);
    }

    //! What a region has to be to keep its shape.
    enum class Kind {
        Sure,
        Cap,       //!< keeps its shape on curved components, too
        SoftPanel, //!< counts where a component is made of such regions
        Small      //!< single polygons with a sharp border, which mean nothing on a rough surface
    };

    void accept(const std::vector<int> &triangles, Kind kind, bool curved = false)
    {
        for (const int t : triangles)
            mRegion[t] = mCount;
        mKind.push_back(kind);
        mCurved.push_back(curved);
        ++mCount;
    }

    //! Per component: area of its regions, but for small ones.
    std::vector<double> rigidAreas() const
    {
        std::vector<double> rigid(mMesh.componentCount, 0);
        for (int t = 0; t < mMesh.triangleCount(); ++t)
            rigid[mMesh.component[t]] +=
                mRegion[t] >= 0 && mKind[mRegion[t]] != Kind::Small ? mMesh.triangleArea[t] : 0;
        return rigid;
    }

    //! Marks panels with soft borders as too bent on components with other curved surface: a smooth body of a
    //! car is to stay whole. \returns true when there were any
    bool refuseSoftPanels()
    {
        const std::vector<double> rigid = rigidAreas();
        bool any = false;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const int c = mMesh.component[t];
            if (mRegion[t] >= 0 && mKind[mRegion[t]] == Kind::SoftPanel &&
                rigid[c] < softPanelShare * mComponentArea[c])
                mBent[t] = any = true;
        }
        return any;
    }

    void dropFromCurvedComponents()
    {
        const std::vector<double> rigid = rigidAreas();
        std::vector<int> number(mCount, -1);
        std::vector<bool> curved;
        int left = 0;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (mRegion[t] < 0)
                continue;
            const int c = mMesh.component[t];
            if (rigid[c] < hardShare * mComponentArea[c] && mKind[mRegion[t]] != Kind::Cap) {
                mRegion[t] = -1;
                continue;
            }
            int &own = number[mRegion[t]];
            if (own < 0) {
                own = left++;
                curved.push_back(mCurved[mRegion[t]]);
            }
            mRegion[t] = own;
        }
        mCount = left;
        mCurved = std::move(curved);
    }

    //! Largest triangles first: their normals are the most exact.
    void findFlat()
    {
        std::vector<int> order(mMesh.triangleCount());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&](int a, int b) { return mMesh.triangleArea[a] > mMesh.triangleArea[b]; });
        std::vector<int> mark(mMesh.triangleCount(), -1);
        const double meanPolygon = mShape.wholeArea / mShape.wholeFaces;
        int number = 0;
        for (const int seed : order) {
            if (mark[seed] >= 0 || mShape.thin[seed] || !mShape.planeFace[mMesh.triangleFace[seed]])
                continue;
            const Vec3 normal = mShape.normal[seed], origin = cornerPosition(3 * seed);
            const std::vector<int> found = reach(seed, mark, number++, [&](int from, int t) {
                return sameTexels(from, t) && mShape.planeFace[mMesh.triangleFace[t]] &&
                       (mShape.thin[t] ? liesInPlane(t, normal, origin)
                                       : normal.dot(mShape.normal[t]) > SurfaceShape::planeCosine());
            });
            const double area = areaOf(found);
            if (!isLarge(area, seed))
                continue;
            const Border border = borderOf(found, mark);
            const bool large = area >= largeFace * meanPolygon && area >= leastSoftArea * mShape.wholeArea;
            // On a rough surface, sharp edges around single polygons mean nothing.
            const bool clear =
                static_cast<int>(found.size()) >= capTriangles || area >= largeFace * meanPolygon;
            if (clear && border.sharp >= clearBorder * border.all)
                accept(found, Kind::Cap);
            else if (border.crease >= leastSharp * border.all ||
                     (large && border.soft >= leastSharp * border.all) ||
                     (clear && border.sharp >= leastSharp * border.all))
                accept(found, Kind::Sure);
            else if (border.sharp >= leastSharp * border.all)
                accept(found, Kind::Small);
        }
    }

    //! Regions of what is not flat: between sharp edges, around vertices without defect.
    void findDevelopable()
    {
        // Smooth pieces between sharp edges and flat regions.
        std::vector<int> piece(mMesh.triangleCount(), -1);
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (mRegion[t] >= 0)
                piece[t] = std::numeric_limits<int>::max();
        }
        const auto smooth = [&](int from, int t) {
            return sameTexels(from, t) && (mShape.thin[from] || mShape.thin[t] ||
                                           mShape.normal[from].dot(mShape.normal[t]) > sharpCosine);
        };
        int pieces = 0;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (piece[t] < 0)
                reach(t, piece, pieces++, smooth);
        }
        // Vertices within one piece that bend the surface in both directions.
        std::vector<int> pieceOfPoint(mShape.uncut.uvVertexCount, -1);
        std::vector<bool> within = mShape.inner;
        for (int c = 0; c < mMesh.soupCornerCount(); ++c) {
            int &own = pieceOfPoint[mShape.uncut.uvVertex[c]];
            if (own >= 0 && own != piece[c / 3])
                within[mShape.uncut.uvVertex[c]] = false;
            own = piece[c / 3];
        }
        std::vector<bool> bent(mShape.uncut.uvVertexCount);
        for (std::size_t v = 0; v < bent.size(); ++v)
            bent[v] = within[v] && !mShape.flatPoint[v];
        allowTips(bent);
        // What remains of the pieces: whole polygons.
        std::vector<int> mark(mMesh.triangleCount(), -1);
        for (int f = 0; f < mMesh.faceCount(); ++f) {
            const int first = mMesh.faceTriangle[f];
            bool leaves = false;
            for (const int t : mMesh.trianglesOf(f)) {
                leaves = leaves || mRegion[t] >= 0 || piece[t] != piece[first];
                for (int k = 0; k < 3; ++k)
                    leaves = leaves || bent[mShape.uncut.uvVertex[3 * t + k]];
            }
            for (const int t : mMesh.trianglesOf(f))
                mark[t] = leaves ? std::numeric_limits<int>::max() : -1;
        }
        int number = 0;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (mark[t] >= 0)
                continue;
            const std::vector<int> found =
                reach(t, mark, number++, [&](int from, int to) { return piece[from] == piece[to]; });
            if (isDevelopable(found, mark, within))
                accept(found, Kind::Sure);
        }
    }

    //! Smooth and slightly curved regions with a sharp border. They take in flat places, such as their
    //! corners.
    void findPanels()
    {
        std::vector<int> mark(mMesh.triangleCount(), -1);
        int number = 0;
        for (int seed = 0; seed < mMesh.triangleCount(); ++seed) {
            if (mark[seed] >= 0)
                continue;
            const std::vector<int> found = reach(seed, mark, number++, [&](int from, int t) {
                return sameTexels(from, t) && mShape.normal[from].dot(mShape.normal[t]) > softCosine;
            });
            if (const std::optional<Kind> kind = panelKind(found, mark))
                accept(found, *kind, true);
        }
    }

    //! What kind of a curved region marked triangles are; none: they are no such region.
    std::optional<Kind> panelKind(const std::vector<int> &triangles, const std::vector<int> &mark) const
    {
        const double area = areaOf(triangles);
        double flat = 0;
        bool isBent = false;
        for (const int t : triangles) {
            flat += mRegion[t] >= 0 ? mMesh.triangleArea[t] : 0;
            isBent = isBent || mBent[t];
        }
        if (isBent || area < leastSmoothArea * mShape.wholeArea || flat > mostFlatOfPanel * area ||
            !isDisk(triangles, mark))
            return std::nullopt;
        const Border border = borderOf(triangles, mark);
        double bend = 0;
        for (const int v : innerPoints(triangles, mark))
            bend += std::abs(mShape.defect[v]);
        if (border.soft < panelBorder * border.all || bend < leastPanelBend || bend > mostPanelBend)
            return std::nullopt;
        return border.crease >= panelBorder * border.all ? Kind::Sure : Kind::SoftPanel;
    }

    //! The vertices of marked triangles that are not on their border.
    std::vector<int> innerPoints(const std::vector<int> &triangles, const std::vector<int> &mark) const
    {
        std::vector<int> all, border, inner;
        for (const int t : triangles) {
            for (int k = 0; k < 3; ++k) {
                const int across = mShape.uncut.neighbour[3 * t + k];
                all.push_back(mShape.uncut.uvVertex[3 * t + k]);
                if (across >= 0 && mark[across / 3] == mark[t])
                    continue;
                border.push_back(mShape.uncut.uvVertex[3 * t + k]);
                border.push_back(mShape.uncut.uvVertex[3 * t + (k + 1) % 3]);
            }
        }
        for (std::vector<int> *points : {&all, &border}) {
            std::sort(points->begin(), points->end());
            points->erase(std::unique(points->begin(), points->end()), points->end());
        }
        std::set_difference(all.begin(), all.end(), border.begin(), border.end(), std::back_inserter(inner));
        return inner;
    }

    //! The tip of a cone is no bent vertex when none of its neighbours is one: the seam runs to it.
    void allowTips(std::vector<bool> &bent) const
    {
        std::vector<bool> tip = bent;
        for (int side = 0; side < mMesh.soupCornerCount(); ++side) {
            const int a = mShape.uncut.uvVertex[side],
                      b = mShape.uncut.uvVertex[side / 3 * 3 + (side + 1) % 3];
            if (bent[a] && bent[b])
                tip[a] = tip[b] = false;
        }
        for (std::size_t v = 0; v < bent.size(); ++v)
            bent[v] = bent[v] && !tip[v];
    }

    bool isDevelopable(const std::vector<int> &triangles, const std::vector<int> &mark,
                       const std::vector<bool> &within) const
    {
        const double area = areaOf(triangles);
        if (!isLarge(area, triangles.front()))
            return false;
        const double component = mComponentArea[mMesh.component[triangles.front()]];
        const bool isRing = !isDisk(triangles, mark);
        if (isRing && area < leastDevelopable * component)
            return false;
        const Border border = borderOf(triangles, mark);
        if (border.crease >= leastSharp * border.all)
            return true;
        std::vector<int> points;
        for (const int t : triangles) {
            for (int k = 0; k < 3; ++k) {
                if (const int v = mShape.uncut.uvVertex[3 * t + k]; within[v] && mShape.flatPoint[v])
                    points.push_back(v);
            }
        }
        std::sort(points.begin(), points.end());
        const auto inner = std::unique(points.begin(), points.end()) - points.begin();
        // The ends of a cylinder with few sides are no creases: the edges that meet there are nearly sharp.
        if (isRing && inner == 0 && border.sharp >= ringBorder * border.all)
            return true;
        return area >= leastSmoothArea * mShape.wholeArea && inner >= leastInner;
    }

    //! True when marked triangles have one border only: Euler's characteristic is 1.
    bool isDisk(const std::vector<int> &triangles, const std::vector<int> &mark) const
    {
        std::vector<int> points;
        int sides = 0, inner = 0;
        for (const int t : triangles) {
            for (int side = 3 * t; side < 3 * t + 3; ++side) {
                points.push_back(mShape.uncut.uvVertex[side]);
                const int across = mShape.uncut.neighbour[side];
                ++sides;
                inner += across >= 0 && mark[across / 3] == mark[t];
            }
        }
        std::sort(points.begin(), points.end());
        const auto count = std::unique(points.begin(), points.end()) - points.begin();
        return count - (sides - inner / 2) + static_cast<std::ptrdiff_t>(triangles.size()) == 1;
    }

    //! Triangles too thin to have a normal join the region on their longest side.
    void takeInThinTriangles()
    {
        bool again = true;
        for (int sweep = 0; sweep < thinSweeps && again; ++sweep) {
            again = false;
            for (int t = 0; t < mMesh.triangleCount(); ++t) {
                if (mRegion[t] >= 0 || !mShape.thin[t] || mMesh.trianglesOf(mMesh.triangleFace[t]).size() > 1)
                    continue;
                double longest = -1;
                int region = -1;
                for (int side = 3 * t; side < 3 * t + 3; ++side) {
                    const double length =
                        (cornerPosition(3 * t + (side + 1) % 3) - cornerPosition(side)).norm();
                    const int across = mShape.uncut.neighbour[side];
                    if (length > longest) {
                        longest = length;
                        region = across >= 0 && sameTexels(t, across / 3) ? mRegion[across / 3] : -1;
                    }
                }
                if (region >= 0) {
                    mRegion[t] = region;
                    again = true;
                }
            }
        }
    }

    const MeshData &mMesh;
    const SurfaceShape mShape;
    std::vector<bool> mBent;   //!< per triangle: in no curved region
    std::vector<bool> mCrease; //!< per triangle side
    double mDust = 0;          //!< area below which a component is dust
    std::vector<double> mComponentArea;
    std::vector<int> mRegion;
    int mCount = 0;
    std::vector<Kind> mKind;   //!< per region
    std::vector<bool> mCurved; //!< per region
};

} // namespace

RigidRegions findRigidRegions(const MeshData &mesh, const std::vector<bool> &creases,
                              const std::vector<bool> &bent)
{
    return RegionFinder(mesh, creases, bent).find();
}

double rigidShare(const MeshData &mesh, const RigidRegions &regions)
{
    double rigid = 0, all = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const double area = mesh.copiesOf(t) * mesh.triangleArea[t];
        rigid += regions.region[t] >= 0 ? area : 0;
        all += area;
    }
    return rigid / all;
}

} // namespace autocuts::rigid
