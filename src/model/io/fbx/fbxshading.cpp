#include "model/io/fbx/fbxshading.h"

#include "model/plain/hardedges.h"
#include "model/plain/polygonsides.h"

#include <algorithm>
#include <optional>

namespace autocuts {

namespace {

class ShadingReader
{
public:
    ShadingReader(const FbxTree &tree, const MeshData &mesh, const FbxSource &source,
                  const FbxGeometries &geometries)
        : mTree(tree), mMesh(mesh), mSource(source), mGeometries(geometries),
          mHard(mesh.edgePairs.size(), false)
    {}

    std::vector<bool> read();

private:
    bool readNormals(const FbxGeometry &geometry, const FbxUse &use);
    void readSmoothing(const FbxGeometry &geometry, const FbxUse &use);
    void readEdgeSmoothing(int element, const FbxGeometry &geometry, const FbxUse &use);
    void readGroups(int element, const FbxGeometry &geometry, const FbxUse &use);
    void compareGroups();
    void setHard(int soupCorner);

    const FbxTree &mTree;
    const MeshData &mMesh;
    const FbxSource &mSource;
    const FbxGeometries &mGeometries;
    FileShading mShading;
    std::vector<int> mPairBySide;            //!< made when it is needed
    std::vector<std::optional<int>> mGroups; //!< per face; empty when there are none
    bool mSmoothingRead = false;
    std::vector<bool> mHard;
};

bool ShadingReader::readNormals(const FbxGeometry &geometry, const FbxUse &use)
{
    const int element = mTree.child(geometry.node, "LayerElementNormal");
    if (element < 0)
        return false;
    const auto normals = readFbxLayer(mTree, element, geometry, "Normals", "NormalsIndex", 3);
    if (!normals)
        return false;
    if (mShading.normals.rows() == 0)
        mShading.normals = PositionMatrix::Zero(mMesh.cornerCount(), 3);
    for (const FbxUse::Instance &instance : use.instances) {
        const std::vector<int> soup = fbxSoupCorners(mMesh, geometry, instance);
        for (int c = 0; c < geometry.cornerCount(); ++c) {
            if (soup[c] >= 0)
                mShading.normals.row(soup[c]) = normals->row(c);
        }
    }
    return true;
}

void ShadingReader::setHard(int soupCorner)
{
    if (mPairBySide.empty())
        mPairBySide = edgePairsBySide(mMesh);
    if (const int pair = mPairBySide[static_cast<std::size_t>(soupCorner)]; pair >= 0)
        mHard[static_cast<std::size_t>(pair)] = true;
}

//! The list Edges names the file corner at which each edge starts; Smoothing is 0 for hard edges.
void ShadingReader::readEdgeSmoothing(int element, const FbxGeometry &geometry, const FbxUse &use)
{
    const auto smooth = mTree.integers(mTree.child(element, "Smoothing"));
    const auto edges = mTree.integers(mTree.child(geometry.node, "Edges"));
    if (!smooth || !edges || smooth->size() < edges->size())
        return;
    mSmoothingRead = true;
    std::vector<int> next(static_cast<std::size_t>(geometry.cornerCount()));
    for (int f = 0; f < geometry.polygonCount(); ++f) {
        for (int c = geometry.polygonStart[f]; c < geometry.polygonStart[f + 1]; ++c)
            next[c] = c + 1 < geometry.polygonStart[f + 1] ? c + 1 : geometry.polygonStart[f];
    }
    for (const FbxUse::Instance &instance : use.instances) {
        const std::vector<int> soup = fbxSoupCorners(mMesh, geometry, instance);
        for (std::size_t e = 0; e < edges->size(); ++e) {
            const int corner = (*edges)[e];
            if ((*smooth)[e] != 0 || corner < 0 || corner >= geometry.cornerCount())
                continue;
            if (const int start = soup[instance.mirrored ? next[corner] : corner]; start >= 0)
                setHard(start);
        }
    }
}

//! Each polygon has a bit for each of its smoothing groups.
void ShadingReader::readGroups(int element, const FbxGeometry &geometry, const FbxUse &use)
{
    const auto groups = mTree.integers(mTree.child(element, "Smoothing"));
    if (!groups || std::ssize(*groups) < geometry.polygonCount())
        return;
    mSmoothingRead = true;
    mGroups.resize(static_cast<std::size_t>(mMesh.faceCount()));
    for (const FbxUse::Instance &instance : use.instances) {
        for (std::size_t i = 0; i < geometry.faces.size(); ++i)
            mGroups[instance.firstFace + i] = (*groups)[geometry.faces[i]];
    }
}

//! An edge between polygons without a common smoothing group is hard.
void ShadingReader::compareGroups()
{
    for (std::size_t e = 0; !mGroups.empty() && e < mMesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mMesh.edgePairs[e];
        const std::optional<int> a = mGroups[mMesh.triangleFace[pair.triangle[0]]];
        const std::optional<int> b = mGroups[mMesh.triangleFace[pair.triangle[1]]];
        if (!pair.diagonal && a && b && (*a & *b) == 0)
            mHard[e] = true;
    }
}

void ShadingReader::readSmoothing(const FbxGeometry &geometry, const FbxUse &use)
{
    const int element = mTree.child(geometry.node, "LayerElementSmoothing");
    const std::string_view mapping =
        element < 0 ? "" : mTree.text(mTree.child(element, "MappingInformationType"));
    if (mapping == "ByEdge")
        readEdgeSmoothing(element, geometry, use);
    else if (mapping == "ByPolygon")
        readGroups(element, geometry, use);
}

std::vector<bool> ShadingReader::read()
{
    for (std::size_t u = 0; u < mSource.uses.size(); ++u) {
        if (!readNormals(mGeometries[u], mSource.uses[u]))
            readSmoothing(mGeometries[u], mSource.uses[u]);
    }
    compareGroups();
    const std::vector<bool> byNormals = hardEdges(mMesh, mShading);
    for (std::size_t e = 0; e < byNormals.size(); ++e)
        mHard[e] = mHard[e] || byNormals[e];
    if (!mSmoothingRead && !saysAnything(mShading))
        mHard.clear();
    return mHard;
}

} // namespace

std::vector<int> fbxSoupCorners(const MeshData &mesh, const FbxGeometry &geometry,
                                const FbxUse::Instance &instance)
{
    std::vector<int> result(static_cast<std::size_t>(geometry.cornerCount()), -1);
    for (std::size_t i = 0; i < geometry.faces.size(); ++i) {
        const int face = instance.firstFace + static_cast<int>(i);
        const int begin = geometry.polygonStart[geometry.faces[i]];
        const int size = geometry.polygonStart[geometry.faces[i] + 1] - begin;
        for (int k = 0; k < size; ++k)
            result[begin + k] = mesh.faceStart[face] + (instance.mirrored ? size - 1 - k : k);
    }
    return result;
}

std::vector<bool> fbxHardEdges(const FbxTree &tree, const MeshData &mesh, const FbxSource &source,
                               const FbxGeometries &geometries)
{
    return ShadingReader(tree, mesh, source, geometries).read();
}

} // namespace autocuts
