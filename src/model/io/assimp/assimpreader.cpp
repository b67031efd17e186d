#include "model/io/assimp/assimpreader.h"

#include "model/document/materialcolor.h"
#include "model/io/assimp/assimplimbs.h"
#include "model/io/assimp/assimpmatrix.h"
#include "model/io/assimp/assimpplacing.h"
#include "model/io/assimp/assimpprocess.h"
#include "model/io/assimp/assimpscene.h"
#include "model/io/assimp/assimptextures.h"
#include "model/io/files/meshlimits.h"
#include "model/io/formats/meshformats.h"
#include "model/io/formats/modelunits.h"
#include "model/plain/hardedges.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSet>
#include <QUrl>

#include <Eigen/Dense>

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

namespace autocuts {

namespace {

QString toName(const aiString &name)
{
    return QString::fromUtf8(name.C_Str());
}

//! 0 when the file says none.
QRgb diffuseColor(const aiMaterial &material)
{
    aiColor3D color;
    return material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS
               ? materialColor(color.r, color.g, color.b)
               : 0;
}

//! Collects the meshes of all nodes into one polygon soup.
class SoupBuilder
{
public:
    SoupBuilder(const aiScene &scene, const QString &path) : mAi(scene), mPath(path) {}

    //! False on an error; see error().
    bool build(Scene &scene, AssimpSource &source);
    const Error &error() const { return *mError; }

private:
    bool addNode(const aiNode &node, const Eigen::Matrix4d &parent);
    bool addMesh(const aiNode &node, unsigned meshIndex, const Eigen::Matrix4d &transform);
    bool addVertices(const aiNode &node, const aiMesh &mesh, const Eigen::Matrix4d &transform);
    bool addFaces(const aiNode &node, const aiMesh &mesh, int firstVertex, bool mirrored);
    void fillUvSets(Scene &scene) const;
    FileShading shading() const;
    CornerColors colors() const;
    //! The name of the node; of its first mesh when the node has none.
    QString objectName(const aiNode &node) const
    {
        const bool borrow = node.mName.length == 0 && node.mNumMeshes > 0 && node.mMeshes[0] < mAi.mNumMeshes;
        return toName(borrow ? mAi.mMeshes[node.mMeshes[0]]->mName : node.mName);
    }
    bool fail(const QString &message)
    {
        mError =
            Error{message, mPath, 0, QStringLiteral("Export the model again from the program that made it")};
        return false;
    }

    const aiScene &mAi;
    QString mPath;
    std::optional<Error> mError;
    int mNodes = 0;
    std::vector<double> mPositions;
    std::vector<int> mFaceStart{0}, mCornerVertex, mFaceObject, mFaceMaterial;
    std::vector<QString> mObjectNames;
    std::vector<AssimpPiece> mPieces;
    int mSkippedFaces = 0;
};

bool SoupBuilder::addVertices(const aiNode &node, const aiMesh &mesh, const Eigen::Matrix4d &transform)
{
    if (mPositions.size() / 3 + mesh.mNumVertices > maxElements)
        return fail(QStringLiteral("the model has too many vertices"));
    const bool identity = transform.isIdentity(0);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D &p = mesh.mVertices[v];
        Vec3 position(p.x, p.y, p.z);
        if (!identity)
            position = (transform * position.homogeneous()).head<3>();
        if (!position.allFinite() || position.cwiseAbs().maxCoeff() > maxCoordinate)
            return fail(
                QStringLiteral("a vertex of \"%1\" has a coordinate that is not finite or is too large")
                    .arg(objectName(node)));
        mPositions.insert(mPositions.end(), position.data(), position.data() + 3);
    }
    return true;
}

bool SoupBuilder::addFaces(const aiNode &node, const aiMesh &mesh, int firstVertex, bool mirrored)
{
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace &face = mesh.mFaces[f];
        if (face.mNumIndices < 3) {
            ++mSkippedFaces;
            continue;
        }
        if (mCornerVertex.size() + face.mNumIndices > maxElements)
            return fail(QStringLiteral("the model has too many face corners"));
        for (unsigned k = 0; k < face.mNumIndices; ++k) {
            const unsigned v = face.mIndices[mirrored ? face.mNumIndices - 1 - k : k];
            if (v >= mesh.mNumVertices)
                return fail(
                    QStringLiteral("a face of \"%1\" has a wrong vertex index").arg(objectName(node)));
            mCornerVertex.push_back(firstVertex + static_cast<int>(v));
        }
        mFaceStart.push_back(static_cast<int>(mCornerVertex.size()));
        mFaceObject.push_back(static_cast<int>(mObjectNames.size()));
        mFaceMaterial.push_back(
            mesh.mMaterialIndex < mAi.mNumMaterials ? static_cast<int>(mesh.mMaterialIndex) : -1);
    }
    return true;
}

bool SoupBuilder::addMesh(const aiNode &node, unsigned meshIndex, const Eigen::Matrix4d &transform)
{
    if (meshIndex >= mAi.mNumMeshes || !mAi.mMeshes[meshIndex])
        return fail(
            QStringLiteral("the node \"%1\" refers to a mesh that is not there").arg(objectName(node)));
    const aiMesh &mesh = *mAi.mMeshes[meshIndex];
    if ((mesh.mNumVertices > 0 && !mesh.mVertices) || (mesh.mNumFaces > 0 && !mesh.mFaces))
        return fail(QStringLiteral("the mesh \"%1\" has no data").arg(toName(mesh.mName)));
    AssimpPiece piece;
    piece.node = mNodes - 1;
    piece.mesh = meshIndex;
    piece.firstVertex = static_cast<int>(mPositions.size() / 3);
    piece.firstFace = static_cast<int>(mFaceObject.size());
    piece.mirrored = transform.topLeftCorner<3, 3>().determinant() < 0;
    if (!addVertices(node, mesh, transform) || !addFaces(node, mesh, piece.firstVertex, piece.mirrored))
        return false;
    piece.faceCount = static_cast<int>(mFaceObject.size()) - piece.firstFace;
    mPieces.push_back(piece);
    return true;
}

bool SoupBuilder::addNode(const aiNode &node, const Eigen::Matrix4d &parent)
{
    ++mNodes;
    const Eigen::Matrix4d transform = parent * toEigen(node.mTransformation);
    const std::size_t firstFace = mFaceObject.size();
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        if (!addMesh(node, node.mMeshes[m], transform))
            return false;
    }
    if (mFaceObject.size() > firstFace)
        mObjectNames.push_back(objectName(node));
    for (unsigned c = 0; c < node.mNumChildren; ++c) {
        if (!addNode(*node.mChildren[c], transform))
            return false;
    }
    return true;
}

void SoupBuilder::fillUvSets(Scene &scene) const
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (int set = 0; set < maxAssimpUvSets; ++set) {
        UvSet result;
        for (const AssimpPiece &piece : mPieces) {
            const aiMesh &mesh = *mAi.mMeshes[piece.mesh];
            if (!mesh.HasTextureCoords(static_cast<unsigned>(set)))
                continue;
            if (result.uv.rows() == 0)
                result.uv = UvMatrix::Constant(static_cast<Eigen::Index>(mCornerVertex.size()), 2, nan);
            if (const aiString *name = mesh.GetTextureCoordsName(static_cast<unsigned>(set));
                name && result.name.isEmpty())
                result.name = toName(*name);
            for (int c = mFaceStart[piece.firstFace]; c < mFaceStart[piece.firstFace + piece.faceCount];
                 ++c) {
                const aiVector3D &uv = mesh.mTextureCoords[set][mCornerVertex[c] - piece.firstVertex];
                result.uv.row(c) << uv.x, uv.y;
            }
        }
        // A set that no mesh has ends the list: files number their UV sets without gaps.
        if (result.uv.rows() == 0)
            return;
        if (result.name.isEmpty())
            result.name = set == 0 ? QStringLiteral("UVMap") : QStringLiteral("UVMap%1").arg(set + 1);
        scene.uvSets.push_back(std::move(result));
    }
}

//! Normals are compared within nodes only, so they need not be transformed.
FileShading SoupBuilder::shading() const
{
    FileShading result;
    for (const AssimpPiece &piece : mPieces) {
        const aiMesh &mesh = *mAi.mMeshes[piece.mesh];
        if (!mesh.HasNormals())
            continue;
        if (result.normals.rows() == 0)
            result.normals = PositionMatrix::Zero(static_cast<Eigen::Index>(mCornerVertex.size()), 3);
        for (int c = mFaceStart[piece.firstFace]; c < mFaceStart[piece.firstFace + piece.faceCount]; ++c) {
            const aiVector3D &normal = mesh.mNormals[mCornerVertex[c] - piece.firstVertex];
            result.normals.row(c) << normal.x, normal.y, normal.z;
        }
    }
    return result;
}

CornerColors SoupBuilder::colors() const
{
    CornerColors result;
    for (const AssimpPiece &piece : mPieces) {
        const aiMesh &mesh = *mAi.mMeshes[piece.mesh];
        if (!mesh.HasVertexColors(0))
            continue;
        result.resize(mCornerVertex.size());
        for (int c = mFaceStart[piece.firstFace]; c < mFaceStart[piece.firstFace + piece.faceCount]; ++c) {
            const aiColor4D &color = mesh.mColors[0][mCornerVertex[c] - piece.firstVertex];
            result[static_cast<std::size_t>(c)] = CornerColor::fromSrgb(color.r, color.g, color.b);
        }
    }
    return result;
}

bool SoupBuilder::build(Scene &scene, AssimpSource &source)
{
    if (!addNode(*mAi.mRootNode, Eigen::Matrix4d::Identity()))
        return false;
    if (mFaceObject.empty())
        return fail(QStringLiteral("the file has no faces"));
    if (mSkippedFaces > 0)
        scene.notes.push_back(
            QStringLiteral("%1 point(s) and line(s) left out: they cannot be unwrapped").arg(mSkippedFaces));
    fillUvSets(scene);
    AssimpTextures textures(mAi);
    for (unsigned m = 0; m < mAi.mNumMaterials; ++m) {
        scene.materialNames.push_back(toName(mAi.mMaterials[m]->GetName()));
        scene.materialColors.push_back(diffuseColor(*mAi.mMaterials[m]));
        scene.materialTextures.push_back(textures.ofMaterial(*mAi.mMaterials[m]));
    }
    scene.objectNames = std::move(mObjectNames);
    scene.faceMaterial = std::move(mFaceMaterial);
    const FileShading said = shading(); // while the faces are here
    scene.cornerColors = sharedColors(colors(), mCornerVertex.size());
    PositionMatrix positions = Eigen::Map<const PositionMatrix>(
        mPositions.data(), static_cast<Eigen::Index>(mPositions.size() / 3), 3);
    scene.mesh = MeshData::build(std::move(positions), std::move(mFaceStart), std::move(mCornerVertex),
                                 std::move(mFaceObject));
    scene.hardEdges = hardEdges(*scene.mesh, said);
    source.pieces = std::move(mPieces);
    return true;
}

//! The header of a PLY file has to end within this many bytes. Chosen by hand.
constexpr qint64 maxPlyHeader = 1 << 20;

//! Checks that need no Assimp: its messages about missing and empty files are not helpful.
std::optional<Error> checkFile(const QString &path)
{
    const QFileInfo info(path);
    if (!info.exists())
        return Error{QStringLiteral("there is no such file"), path, 0, QStringLiteral("Check the path")};
    if (!info.isFile())
        return Error{QStringLiteral("this is a folder or a device, not a file"), path, 0,
                     QStringLiteral("Name a mesh file")};
    if (info.size() == 0)
        return Error{QStringLiteral("the file is empty"), path, 0, QStringLiteral("Export the model again")};
    if (info.size() > maxMeshFileSize)
        return Error{
            QStringLiteral("the file has %1 bytes, the limit is %2").arg(info.size()).arg(maxMeshFileSize),
            path, 0, QStringLiteral("Split the model into several files")};
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{QStringLiteral("the file cannot be read (%1)").arg(file.errorString()), path, 0,
                     QStringLiteral("Check its permissions")};
    // Assimp hangs on a PLY header without an end.
    if (info.suffix().toLower() == QLatin1String("ply") && !file.peek(maxPlyHeader).contains("end_header"))
        return Error{QStringLiteral("the PLY header has no end"), path, 0,
                     QStringLiteral("The file is damaged or cut off: export the model again")};
    return {};
}

//! The size of the objects that a LightWave scene names.
qint64 sizeOfObjects(const QString &scene, const QByteArray &text)
{
    qint64 size = 0;
    QSet<QByteArray> known;
    for (const QByteArray &line : text.split('\n')) {
        const QByteArray name = line.trimmed().split(' ').last();
        if (!line.trimmed().startsWith("LoadObject") || known.contains(name))
            continue;
        known << name;
        size += QFileInfo(QFileInfo(scene).dir(), QFile::decodeName(name)).size();
    }
    return size;
}

//! The size of a file with the files that it is made of: the buffers of a glTF file, the objects of a
//! LightWave scene.
qint64 sizeToRead(const QString &path)
{
    QFile file(path);
    qint64 size = file.size();
    const bool isScene = path.endsWith(QLatin1String(".lws"), Qt::CaseInsensitive);
    const bool hasParts = isScene || path.endsWith(QLatin1String(".gltf"), Qt::CaseInsensitive);
    if (!hasParts || !file.open(QIODevice::ReadOnly))
        return size;
    const QByteArray text = file.readAll();
    if (isScene)
        return size + sizeOfObjects(path, text);
    for (qsizetype at = text.indexOf("\"uri\""); at >= 0; at = text.indexOf("\"uri\"", at + 5)) {
        const qsizetype begin = text.indexOf('"', at + 5) + 1;
        const qsizetype end = begin > 0 ? text.indexOf('"', begin) : -1;
        if (end < 0)
            break;
        const QByteArray uri = text.mid(begin, end - begin);
        if (!uri.startsWith("data:"))
            size += QFileInfo(QFileInfo(path).dir(), QUrl::fromPercentEncoding(uri)).size();
    }
    return size;
}

} // namespace

Result<Scene> readWithAssimp(const QString &path, const std::atomic<bool> *stop,
                             const Eigen::Matrix4d &placement, const CompleteScene &complete)
{
    if (const std::optional<Error> error = checkFile(path))
        return *error;
    Result<std::shared_ptr<aiScene>> read = readInProcess(path, readerLimits(sizeToRead(path)), stop);
    if (!read)
        return read.error();
    auto source = std::make_shared<AssimpSource>();
    source->limbs = takeLimbs(*read.value()->mRootNode);
    if (complete)
        complete(*read.value(), *source);
    turnViews(*read.value());
    const QString suffix = QFileInfo(path).suffix().toLower();
    Eigen::Matrix4d place = placement;
    if (suffix == QLatin1String("blend"))
        place = unitChange({1, true}, {});
    if (hasMadeUpRoot(suffix)) {
        place = place * toEigen(read.value()->mRootNode->mTransformation);
        read.value()->mRootNode->mTransformation = {};
    }
    if (!place.isIdentity(0))
        placeScene(*read.value(), place);
    source->scene = std::move(read).value();
    Scene scene;
    scene.path = path;
    scene.format = suffix;
    SoupBuilder builder(*source->scene, path);
    try {
        if (!builder.build(scene, *source))
            return builder.error();
    } catch (const std::invalid_argument &) {
        return Error{QStringLiteral("the file cannot be read: its data contradict each other"), path, 0,
                     QStringLiteral("Export the model again from the program that made it, or as OBJ")};
    }
    source->contents = contentsOf(*source);
    scene.source = std::move(source);
    return scene;
}

} // namespace autocuts
