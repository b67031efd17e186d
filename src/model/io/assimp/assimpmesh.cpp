#include "model/io/assimp/assimpmesh.h"

#include <assimp/mesh.h>

#include <algorithm>
#include <cstring>
#include <unordered_map>

namespace autocuts {

namespace {

//! Two corners become one vertex of an exported mesh when their vertex, their normal, their colour and all
//! their UVs have the same bits.
using VertexKey = std::array<std::uint32_t, 1 + 3 + 2 + 2 * maxAssimpUvSets>;

struct VertexKeyHash
{
    std::size_t operator()(const VertexKey &key) const
    {
        std::uint64_t h = 0;
        for (std::uint32_t word : key) {
            h = (h ^ word) * 0x9E3779B97F4A7C15ull;
            h ^= h >> 29;
        }
        return h;
    }
};

std::uint32_t bitsOf(float value)
{
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

aiVector3D toVector(const Vec3 &v)
{
    return {static_cast<ai_real>(v.x()), static_cast<ai_real>(v.y()), static_cast<ai_real>(v.z())};
}

//! Builds one exported mesh from faces of the polygon soup.
class MeshMaker
{
public:
    MeshMaker(const Scene &scene, const MeshOptions &options)
        : mSceneIn(scene), mSoup(*scene.mesh), mNormals(options.normals), mOriginal(options.original),
          mPiece(options.piece), mPlace(options.place), mTriangulate(options.triangulate),
          mToFile(options.color), mColors(mOriginal ? nullptr : scene.cornerColors.get())
    {}

    aiMesh *make(const std::vector<int> &faces);

private:
    void collectPolygons(const std::vector<int> &faces);
    void findSets();
    void splitVertices();
    VertexKey keyOf(int corner) const;
    aiVector3D uvAt(int set, int corner) const;
    Vec3 normalAt(int corner) const;
    unsigned originalVertex(int corner) const { return mSoup.cornerVertex[corner] - mPiece.firstVertex; }
    template <typename T>
    T *gather(const T *values) const;
    void fillFaces(aiMesh &out) const;
    void fillColors(aiMesh &out) const;
    void convertColors(aiMesh &out) const;
    void fillAttributes(aiMesh &out) const;
    void fillBones(aiMesh &out) const;

    const Scene &mSceneIn;
    const MeshData &mSoup;
    const PositionMatrix *mNormals;
    const aiMesh *mOriginal;
    const AssimpPiece &mPiece;
    const Eigen::Matrix3d &mPlace;
    bool mTriangulate;
    float (*mToFile)(float);
    const CornerColors *mColors;                 //!< null: there are none, or the original mesh has them
    std::vector<int> mPolygonStart{0}, mCorners; //!< the faces to write, as polygon corners of the soup
    std::vector<int> mSets;                      //!< UV sets with at least one UV in these faces
    std::vector<unsigned> mCornerVertex;         //!< exported vertex of each entry of mCorners
    std::vector<int> mVertexCorner;              //!< one corner of each exported vertex
};

void MeshMaker::collectPolygons(const std::vector<int> &faces)
{
    for (int f : faces) {
        const int begin = mSoup.faceStart[f];
        const int end = mSoup.faceStart[f + 1];
        const int parts = mTriangulate ? end - begin - 2 : 1;
        for (int part = 0; part < parts; ++part) {
            const auto first = static_cast<std::ptrdiff_t>(mCorners.size());
            if (mTriangulate) {
                const auto &triangle = mSoup.triangles[mSoup.faceTriangle[f] + part];
                mCorners.insert(mCorners.end(), triangle.begin(), triangle.end());
            } else {
                for (int c = begin; c < end; ++c)
                    mCorners.push_back(c);
            }
            if (mPiece.mirrored)
                std::reverse(mCorners.begin() + first, mCorners.end());
            mPolygonStart.push_back(static_cast<int>(mCorners.size()));
        }
    }
}

void MeshMaker::findSets()
{
    const int count = std::min<int>(maxAssimpUvSets, static_cast<int>(mSceneIn.uvSets.size()));
    for (int set = 0; set < count; ++set) {
        const UvMatrix &uv = mSceneIn.uvSets[set].uv;
        if (std::any_of(mCorners.begin(), mCorners.end(), [&uv](int c) { return uv.row(c).allFinite(); }))
            mSets.push_back(set);
    }
}

aiVector3D MeshMaker::uvAt(int set, int corner) const
{
    const auto uv = mSceneIn.uvSets[set].uv.row(corner);
    if (!uv.allFinite())
        return {0, 0, 0};
    return {static_cast<ai_real>(uv.x()), static_cast<ai_real>(uv.y()), 0};
}

Vec3 MeshMaker::normalAt(int corner) const
{
    const Vec3 normal = mNormals->row(corner);
    return normal.allFinite() ? normal : Vec3::Zero();
}

VertexKey MeshMaker::keyOf(int corner) const
{
    VertexKey key{};
    key[0] = static_cast<std::uint32_t>(mSoup.cornerVertex[corner]);
    std::size_t at = 1;
    if (mNormals) {
        const aiVector3D normal = toVector(normalAt(corner));
        for (unsigned k = 0; k < 3; ++k)
            key[at++] = bitsOf(normal[k]);
    }
    if (mColors) {
        const CornerColor &color = (*mColors)[static_cast<std::size_t>(corner)];
        key[4] = color.linear[0] | std::uint32_t(color.linear[1]) << 16;
        key[5] = color.linear[2] | std::uint32_t(color.known) << 16;
    }
    at = 6;
    for (int set : mSets) {
        const aiVector3D uv = uvAt(set, corner);
        key[at++] = bitsOf(uv.x);
        key[at++] = bitsOf(uv.y);
    }
    return key;
}

void MeshMaker::splitVertices()
{
    std::unordered_map<VertexKey, unsigned, VertexKeyHash> known;
    known.reserve(mCorners.size() / 2);
    mCornerVertex.reserve(mCorners.size());
    for (int corner : mCorners) {
        const auto [it, isNew] =
            known.try_emplace(keyOf(corner), static_cast<unsigned>(mVertexCorner.size()));
        if (isNew)
            mVertexCorner.push_back(corner);
        mCornerVertex.push_back(it->second);
    }
}

//! Copies per-vertex values of the original mesh to the exported vertices. nullptr stays nullptr.
template <typename T>
T *MeshMaker::gather(const T *values) const
{
    if (!values)
        return nullptr;
    T *result = new T[mVertexCorner.size()];
    for (std::size_t v = 0; v < mVertexCorner.size(); ++v)
        result[v] = values[originalVertex(mVertexCorner[v])];
    return result;
}

void MeshMaker::fillFaces(aiMesh &out) const
{
    out.mNumFaces = static_cast<unsigned>(mPolygonStart.size() - 1);
    out.mFaces = new aiFace[out.mNumFaces];
    for (unsigned f = 0; f < out.mNumFaces; ++f) {
        const int begin = mPolygonStart[f];
        aiFace &face = out.mFaces[f];
        face.mNumIndices = static_cast<unsigned>(mPolygonStart[f + 1] - begin);
        face.mIndices = new unsigned[face.mNumIndices];
        std::copy_n(mCornerVertex.begin() + begin, face.mNumIndices, face.mIndices);
        out.mPrimitiveTypes |= face.mNumIndices == 3 ? aiPrimitiveType_TRIANGLE : aiPrimitiveType_POLYGON;
    }
}

//! White where the scene says nothing.
void MeshMaker::fillColors(aiMesh &out) const
{
    const auto known = [this](int corner) { return (*mColors)[static_cast<std::size_t>(corner)].known; };
    if (!mColors || std::ranges::none_of(mVertexCorner, known))
        return;
    out.mColors[0] = new aiColor4D[out.mNumVertices];
    for (unsigned v = 0; v < out.mNumVertices; ++v) {
        const CornerColor &color = (*mColors)[static_cast<std::size_t>(mVertexCorner[v])];
        const Eigen::Vector3f value = color.known ? color.value() : Eigen::Vector3f(Eigen::Vector3f::Ones());
        out.mColors[0][v] = {value.x(), value.y(), value.z(), 1};
    }
}

void MeshMaker::convertColors(aiMesh &out) const
{
    if (!mToFile)
        return;
    for (aiColor4D *colors : out.mColors) {
        for (unsigned v = 0; colors && v < out.mNumVertices; ++v)
            colors[v] = {mToFile(colors[v].r), mToFile(colors[v].g), mToFile(colors[v].b), colors[v].a};
    }
}

void MeshMaker::fillAttributes(aiMesh &out) const
{
    out.mNumVertices = static_cast<unsigned>(mVertexCorner.size());
    if (mOriginal) {
        out.mVertices = gather(mOriginal->mVertices);
        out.mNormals = gather(mOriginal->mNormals);
        // Tangents belong to the old UVs. They are left out, so that the reader of the file computes new
        // ones.
        for (unsigned set = 0; set < AI_MAX_NUMBER_OF_COLOR_SETS; ++set)
            out.mColors[set] = gather(mOriginal->mColors[set]);
    } else {
        fillColors(out);
        out.mVertices = new aiVector3D[out.mNumVertices];
        for (unsigned v = 0; v < out.mNumVertices; ++v)
            out.mVertices[v] = toVector(mPlace * mSoup.cornerPosition(mVertexCorner[v]));
        if (mNormals) {
            out.mNormals = new aiVector3D[out.mNumVertices];
            for (unsigned v = 0; v < out.mNumVertices; ++v)
                out.mNormals[v] = toVector((mPlace * normalAt(mVertexCorner[v])).normalized());
        }
    }
    convertColors(out);
    for (unsigned channel = 0; channel < mSets.size(); ++channel) {
        const int set = mSets[channel];
        out.mNumUVComponents[channel] = 2;
        out.mTextureCoords[channel] = new aiVector3D[out.mNumVertices];
        for (unsigned v = 0; v < out.mNumVertices; ++v)
            out.mTextureCoords[channel][v] = uvAt(set, mVertexCorner[v]);
    }
}

void MeshMaker::fillBones(aiMesh &out) const
{
    if (!mOriginal || mOriginal->mNumBones == 0)
        return;
    std::vector<std::vector<unsigned>> copies(mOriginal->mNumVertices);
    for (unsigned v = 0; v < out.mNumVertices; ++v)
        copies[originalVertex(mVertexCorner[v])].push_back(v);
    out.mNumBones = mOriginal->mNumBones;
    out.mBones = new aiBone *[out.mNumBones];
    for (unsigned b = 0; b < out.mNumBones; ++b) {
        const aiBone &from = *mOriginal->mBones[b];
        std::vector<aiVertexWeight> weights;
        for (unsigned w = 0; w < from.mNumWeights; ++w) {
            if (from.mWeights[w].mVertexId >= copies.size())
                continue;
            for (unsigned v : copies[from.mWeights[w].mVertexId])
                weights.emplace_back(v, from.mWeights[w].mWeight);
        }
        auto *bone = new aiBone;
        bone->mName = from.mName;
        bone->mOffsetMatrix = from.mOffsetMatrix;
        bone->mNumWeights = static_cast<unsigned>(weights.size());
        bone->mWeights = new aiVertexWeight[weights.size()];
        std::copy(weights.begin(), weights.end(), bone->mWeights);
        out.mBones[b] = bone;
    }
}

aiMesh *MeshMaker::make(const std::vector<int> &faces)
{
    collectPolygons(faces);
    findSets();
    splitVertices();
    auto *out = new aiMesh;
    if (mOriginal) {
        out->mName = mOriginal->mName;
        out->mMaterialIndex = mOriginal->mMaterialIndex;
    }
    fillFaces(*out);
    fillAttributes(*out);
    fillBones(*out);
    return out;
}

} // namespace

aiMesh *makeExportMesh(const Scene &scene, const std::vector<int> &faces, const MeshOptions &options)
{
    return MeshMaker(scene, options).make(faces);
}

} // namespace autocuts
