#include "model/io/fbx/fbxrewriter.h"

#include "model/io/fbx/fbxeditor.h"
#include "model/io/fbx/fbxgeometry.h"
#include "model/io/fbx/fbxparsing.h"
#include "model/io/fbx/fbxshading.h"
#include "model/io/fbx/fbxuvelements.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace autocuts {

namespace {

bool hasUv(const UvMatrix &uv, Eigen::Index row)
{
    return uv.row(row).allFinite();
}

//! True when the rows have the same bits; two missing UVs are equal.
bool sameRows(const UvMatrix &a, Eigen::Index rowA, const UvMatrix &b, Eigen::Index rowB)
{
    if (hasUv(a, rowA) != hasUv(b, rowB))
        return false;
    const auto sameBits = [&](Eigen::Index column) {
        return std::bit_cast<std::uint64_t>(a(rowA, column)) == std::bit_cast<std::uint64_t>(b(rowB, column));
    };
    return !hasUv(a, rowA) || (sameBits(0) && sameBits(1));
}

bool sameUv(const UvMatrix &a, const UvMatrix &b)
{
    for (Eigen::Index row = 0; row < a.rows(); ++row) {
        if (!sameRows(a, row, b, row))
            return false;
    }
    return true;
}

bool hasAnyUv(const UvMatrix &uv)
{
    for (Eigen::Index row = 0; row < uv.rows(); ++row) {
        if (hasUv(uv, row))
            return true;
    }
    return false;
}

//! Which set of the scene each set of the source is now, and which sets are new.
struct SetPlan
{
    std::vector<int> now; //!< by set of the source: index of a set of the scene, -1: taken out
    std::vector<int> added;
};

SetPlan planSets(const FbxSource &source, const Scene &scene)
{
    SetPlan plan;
    std::vector<bool> known(scene.uvSets.size(), false);
    for (const QString &name : source.setNames) {
        const auto found = std::find_if(scene.uvSets.begin(), scene.uvSets.end(),
                                        [&](const UvSet &set) { return set.name == name; });
        plan.now.push_back(found == scene.uvSets.end() ? -1 : static_cast<int>(found - scene.uvSets.begin()));
        if (plan.now.back() >= 0)
            known[static_cast<std::size_t>(plan.now.back())] = true;
    }
    auto missing = plan.now.begin();
    for (std::size_t set = 0; set < known.size(); ++set) {
        if (known[set])
            continue;
        missing = std::find(missing, plan.now.end(), -1);
        if (missing == plan.now.end())
            plan.added.push_back(static_cast<int>(set));
        else
            *missing = static_cast<int>(set);
    }
    return plan;
}

//! Changes the UV sets of one geometry.
class GeometryRewriter
{
public:
    GeometryRewriter(const FbxTree &tree, const FbxSource &source, const Scene &scene, const FbxUse &use,
                     FbxGeometry geometry, FbxEditor &editor)
        : mTree(tree), mSource(source), mScene(scene), mUse(use), mGeometry(std::move(geometry)),
          mElements(tree, use.node, editor)
    {
        for (const FbxUse::Instance &instance : use.instances)
            mSoup.push_back(fbxSoupCorners(*scene.mesh, mGeometry, instance));
    }

    void run(const SetPlan &plan);

private:
    UvMatrix wanted(const UvMatrix &original, const UvMatrix &uv) const;
    FbxUvData dataOf(const UvMatrix &uv) const;
    void rewrite(const FbxUvElement &element, int set);
    void add(int set);

    const FbxTree &mTree;
    const FbxSource &mSource;
    const Scene &mScene;
    const FbxUse &mUse;
    FbxGeometry mGeometry;
    FbxUvElements mElements;
    std::vector<std::vector<int>> mSoup; //!< fbxSoupCorners() of each instance
};

//! The UVs of the first instance that differ from the original ones; the original ones if none do.
UvMatrix GeometryRewriter::wanted(const UvMatrix &original, const UvMatrix &uv) const
{
    for (const std::vector<int> &soup : mSoup) {
        UvMatrix now = original;
        for (std::size_t c = 0; c < soup.size(); ++c) {
            if (soup[c] >= 0)
                now.row(static_cast<Eigen::Index>(c)) = uv.row(soup[c]);
        }
        if (!sameUv(now, original))
            return now;
    }
    return original;
}

FbxUvData GeometryRewriter::dataOf(const UvMatrix &uv) const
{
    // Corners of polygons that are left out may name control points that are not there.
    const int points = static_cast<int>(mGeometry.points.rows());
    std::vector<int> point = mGeometry.cornerPoint;
    std::replace_if(
        point.begin(), point.end(), [points](int p) { return p < 0 || p >= points; }, points);
    return fbxUvData(point, points + 1, uv);
}

void GeometryRewriter::rewrite(const FbxUvElement &element, int set)
{
    const UvSet &now = mScene.uvSets[static_cast<std::size_t>(set)];
    bool fits = false;
    const UvMatrix original = readFbxUv(mTree, element.node, mGeometry, fits);
    const UvMatrix uv = wanted(original, now.uv);
    const bool changed = !sameUv(uv, original);
    if (changed && !hasAnyUv(uv)) {
        mElements.remove(element.node);
        return;
    }
    if (now.name != mSource.setNames[static_cast<std::size_t>(element.set)])
        mElements.rename(element.node, now.name);
    if (changed)
        mElements.setData(element.node, dataOf(uv));
}

void GeometryRewriter::add(int set)
{
    const UvSet &now = mScene.uvSets[static_cast<std::size_t>(set)];
    const UvMatrix none = UvMatrix::Constant(mGeometry.cornerCount(), 2, std::nan(""));
    const UvMatrix uv = wanted(none, now.uv);
    if (hasAnyUv(uv))
        mElements.add(now.name, dataOf(uv));
}

void GeometryRewriter::run(const SetPlan &plan)
{
    std::vector<bool> here(plan.now.size(), false);
    for (const FbxUvElement &element : mUse.elements) {
        const auto set = static_cast<std::size_t>(element.set);
        here[set] = true;
        if (plan.now[set] < 0)
            mElements.remove(element.node);
        else
            rewrite(element, plan.now[set]);
    }
    for (std::size_t set = 0; set < plan.now.size(); ++set) {
        if (!here[set] && plan.now[set] >= 0)
            add(plan.now[set]);
    }
    for (const int set : plan.added)
        add(set);
    mElements.finish();
}

} // namespace

QByteArray rewriteFbx(const FbxSource &source, const Scene &scene)
{
    const Result<FbxTree> tree = parseFbxTree(source.bytes, scene.path);
    if (!tree)
        return source.bytes; // they were read before
    const SetPlan plan = planSets(source, scene);
    FbxEditor editor(tree.value());
    for (const FbxUse &use : source.uses) {
        if (use.instances.empty())
            continue;
        if (std::optional<FbxGeometry> geometry = readFbxGeometry(tree.value(), use.node))
            GeometryRewriter(tree.value(), source, scene, use, std::move(*geometry), editor).run(plan);
    }
    return editor.result();
}

bool hasUnequalInstances(const FbxSource &source, const Scene &scene)
{
    const MeshData &mesh = *scene.mesh;
    const auto differ = [&](const FbxUse::Instance &a, const FbxUse::Instance &b, int face) {
        const int beginA = mesh.faceStart[a.firstFace + face];
        const int beginB = mesh.faceStart[b.firstFace + face];
        const int size = mesh.faceStart[a.firstFace + face + 1] - beginA;
        for (int k = 0; k < size; ++k) {
            const int rowB = beginB + (a.mirrored == b.mirrored ? k : size - 1 - k);
            if (std::any_of(scene.uvSets.begin(), scene.uvSets.end(),
                            [&](const UvSet &set) { return !sameRows(set.uv, beginA + k, set.uv, rowB); }))
                return true;
        }
        return false;
    };
    for (const FbxUse &use : source.uses) {
        for (std::size_t i = 1; i < use.instances.size(); ++i) {
            for (int face = 0; face < use.faceCount; ++face) {
                if (differ(use.instances[0], use.instances[i], face))
                    return true;
            }
        }
    }
    return false;
}

} // namespace autocuts
