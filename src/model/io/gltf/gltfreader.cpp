#include "model/io/gltf/gltfreader.h"

#include "model/document/materialcolor.h"
#include "model/io/assimp/assimpreader.h"
#include "model/io/files/meshlimits.h"
#include "model/io/files/savefile.h"
#include "model/io/gltf/gltfnodes.h"
#include "model/io/gltf/gltfprimitive.h"
#include "model/io/gltf/gltftextures.h"
#include "model/io/gltf/gltfuvnames.h"
#include "model/plain/hardedges.h"

#include <QDir>
#include <QFileInfo>
#include <QUrl>

#include <Eigen/Dense>

#include <algorithm>
#include <limits>
#include <set>

namespace autocuts {

namespace {

//! The stop flag is looked at after so many vertices or triangles.
constexpr std::size_t stopInterval = 1 << 16;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

//! Collects the primitives of all nodes into one polygon soup.
class SoupBuilder
{
public:
    SoupBuilder(const GltfDocument &document, const std::atomic<bool> *stop) : mData(document), mStop(stop) {}

    //! \throws GltfError, GltfStopped
    void build(Scene &scene, GltfSource &source);

private:
    void addNode(const GltfMeshNode &node);
    void addPrimitive(const GltfMeshNode &node, std::size_t primitive, const Json &json);
    void addPositions(const GltfElements &positions, const std::vector<std::uint32_t> &used,
                      const Eigen::Matrix4d &transform);
    void addNormals(const GltfPrimitive &primitive, bool mirrored);
    void addUvs(const GltfPrimitive &primitive, bool mirrored);
    void addColors(const GltfPrimitive &primitive, bool mirrored);
    void addNotes(Scene &scene) const;
    void fill(Scene &scene, const GltfSource &source);
    template <typename Add>
    void eachCorner(const GltfPrimitive &primitive, bool mirrored, const Add &add);
    void checkStop(std::size_t step) const
    {
        if (step % stopInterval == 0 && mStop && *mStop)
            throw GltfStopped();
    }

    GltfData mData;
    const std::atomic<bool> *mStop;
    std::vector<double> mPositions, mNormals; //!< of vertices, of corners
    std::vector<int> mFaceStart{0}, mCornerVertex, mFaceObject, mFaceMaterial;
    std::map<int, std::vector<double>>
        mUvs;             //!< by texture coordinate set; they end at the last corner with UV
    CornerColors mColors; //!< they end at the last corner with one
    std::vector<QString> mObjectNames;
    std::vector<GltfPiece> mPieces;
    std::set<std::size_t> mMeshes, mInstancedMeshes;
    std::size_t mSkippedFaces = 0, mBrokenTriangles = 0, mBrokenColors = 0;
};

//! Calls add(vertex of the primitive) for the corners in the order of the soup.
template <typename Add>
void SoupBuilder::eachCorner(const GltfPrimitive &primitive, bool mirrored, const Add &add)
{
    for (std::size_t c = 0; c < primitive.corners.size(); ++c) {
        checkStop(c);
        add(primitive.corners[mirrored ? c + 2 - 2 * (c % 3) : c]);
    }
}

void SoupBuilder::addPositions(const GltfElements &positions, const std::vector<std::uint32_t> &used,
                               const Eigen::Matrix4d &transform)
{
    if (mPositions.size() / 3 + used.size() > maxElements)
        throw GltfError("the model has too many vertices");
    const bool identity = transform.isIdentity(0);
    for (std::size_t i = 0; i < used.size(); ++i) {
        checkStop(i);
        Vec3 position;
        for (int k = 0; k < 3; ++k)
            position[k] = positions.value(used[i], k);
        if (!identity)
            position = (transform * position.homogeneous()).head<3>();
        if (!position.allFinite() || position.cwiseAbs().maxCoeff() > maxCoordinate)
            throw GltfError("a vertex has a coordinate that is not finite or is too large");
        mPositions.insert(mPositions.end(), position.data(), position.data() + 3);
    }
}

void SoupBuilder::addNormals(const GltfPrimitive &primitive, bool mirrored)
{
    const auto normals = primitive.attributes.find("NORMAL");
    if (normals == primitive.attributes.end() || normals->second.components != 3)
        return;
    mNormals.resize(3 * (mCornerVertex.size() - primitive.corners.size()), 0.0);
    eachCorner(primitive, mirrored, [&](std::uint32_t vertex) {
        for (int k = 0; k < 3; ++k)
            mNormals.push_back(normals->second.value(vertex, k));
    });
}

void SoupBuilder::addUvs(const GltfPrimitive &primitive, bool mirrored)
{
    for (const auto &[name, elements] : primitive.attributes) {
        const int set = texcoordNumber(name);
        if (set < 0 || elements.components != 2)
            continue;
        std::vector<double> &uvs = mUvs[set];
        uvs.resize(2 * (mCornerVertex.size() - primitive.corners.size()), nan);
        eachCorner(primitive, mirrored, [&, &values = elements](std::uint32_t vertex) {
            uvs.push_back(values.value(vertex, 0));
            uvs.push_back(1 - values.value(vertex, 1)); // v points down in the file
        });
    }
}

//! Whole numbers are normalized, even where the file forgets to say so.
void SoupBuilder::addColors(const GltfPrimitive &primitive, bool mirrored)
{
    const auto found = primitive.attributes.find("COLOR_0");
    if (found == primitive.attributes.end())
        return;
    GltfElements colors = found->second;
    if (colors.isMatrix || colors.components < 3 || colors.components > 4) {
        ++mBrokenColors;
        return;
    }
    colors.normalized = true;
    mColors.resize(mCornerVertex.size() - primitive.corners.size());
    eachCorner(primitive, mirrored, [&](std::uint32_t vertex) {
        mColors.push_back(CornerColor::fromLinear(colors.value(vertex, 0), colors.value(vertex, 1),
                                                  colors.value(vertex, 2)));
    });
}

void SoupBuilder::addPrimitive(const GltfMeshNode &node, std::size_t number, const Json &json)
{
    if (!hasTriangles(json)) {
        mSkippedFaces += countPointsAndLines(mData, json);
        return;
    }
    const GltfPrimitive primitive = readPrimitive(mData, json);
    mBrokenTriangles += primitive.brokenTriangles;
    if (primitive.corners.empty())
        return;
    const GltfElements &positions = primitive.attributes.at("POSITION");
    if (positions.components != 3 || mCornerVertex.size() + primitive.corners.size() > maxElements)
        throw GltfError(positions.components != 3 ? "a mesh has positions of other than three numbers"
                                                  : "the model has too many face corners");
    std::vector<std::uint32_t> used = primitive.corners;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    const bool mirrored = node.transform.topLeftCorner<3, 3>().determinant() < 0;
    const auto firstVertex = static_cast<std::ptrdiff_t>(mPositions.size() / 3);
    addPositions(positions, used, node.transform);
    eachCorner(primitive, mirrored, [&](std::uint32_t vertex) {
        const auto place = std::lower_bound(used.begin(), used.end(), vertex) - used.begin();
        mCornerVertex.push_back(static_cast<int>(firstVertex + place));
    });
    addNormals(primitive, mirrored);
    addUvs(primitive, mirrored);
    addColors(primitive, mirrored);
    const std::size_t faces = primitive.corners.size() / 3;
    mPieces.push_back(
        {node.mesh, number, static_cast<int>(mFaceObject.size()), static_cast<int>(faces), mirrored});
    const std::optional<std::size_t> material = wholeNumber(json, "material");
    const bool known = material && *material < member(mData.json(), "materials").size();
    for (std::size_t f = 0; f < faces; ++f)
        mFaceStart.push_back(mFaceStart.back() + 3);
    mFaceObject.resize(mFaceObject.size() + faces, static_cast<int>(mObjectNames.size()));
    mFaceMaterial.resize(mFaceMaterial.size() + faces, known ? static_cast<int>(*material) : -1);
}

void SoupBuilder::addNode(const GltfMeshNode &node)
{
    const Json &mesh = element(mData.json(), "meshes", node.mesh);
    const Json &primitives = member(mesh, "primitives");
    const std::size_t before = mFaceObject.size();
    for (std::size_t p = 0; primitives.is_array() && p < primitives.size(); ++p)
        addPrimitive(node, p, primitives[p]);
    if (mFaceObject.size() == before)
        return;
    if (!mMeshes.insert(node.mesh).second)
        mInstancedMeshes.insert(node.mesh);
    const Json &json = element(mData.json(), "nodes", node.node);
    const Json &named = textOf(json, "name").empty() && !textOf(mesh, "name").empty() ? mesh : json;
    mObjectNames.push_back(QString::fromStdString(nameOr(named, "node", node.node)));
}

void SoupBuilder::addNotes(Scene &scene) const
{
    if (mSkippedFaces > 0)
        scene.notes.push_back(
            QStringLiteral("%1 point(s) and line(s) left out: they cannot be unwrapped").arg(mSkippedFaces));
    if (mBrokenTriangles > 0)
        scene.notes.push_back(QStringLiteral("%1 triangle(s) left out: they name vertices that are not there")
                                  .arg(mBrokenTriangles));
    if (mBrokenColors > 0)
        scene.notes.push_back(
            QStringLiteral(
                "the vertex colours of %1 mesh part(s) left out: they are not of three or four numbers")
                .arg(mBrokenColors));
    if (!mInstancedMeshes.empty())
        scene.notes.push_back(
            QStringLiteral("%1 mesh(es) appear at several nodes and have one map in the "
                           "file: saved as glTF, that of the first node is used, unless they are "
                           "made unique")
                .arg(mInstancedMeshes.size()));
}

//! The base colour of a material; 0 when it has none.
QRgb baseColor(const Json &material)
{
    const Json &factor = member(member(material, "pbrMetallicRoughness"), "baseColorFactor");
    if (!factor.is_array() || factor.size() < 3 || !factor[0].is_number() || !factor[1].is_number() ||
        !factor[2].is_number())
        return 0;
    return linearMaterialColor(factor[0].get<double>(), factor[1].get<double>(), factor[2].get<double>());
}

void SoupBuilder::fill(Scene &scene, const GltfSource &source)
{
    const std::size_t corners = mCornerVertex.size();
    for (auto &[set, values] : mUvs) {
        values.resize(2 * corners, nan);
        scene.uvSets.push_back(
            {source.setNames.at(set),
             Eigen::Map<const UvMatrix>(values.data(), static_cast<Eigen::Index>(corners), 2)});
    }
    const Json &materials = member(mData.json(), "materials");
    GltfTextures textures(mData);
    for (std::size_t m = 0; materials.is_array() && m < materials.size(); ++m) {
        scene.materialNames.push_back(QString::fromStdString(nameOr(materials[m], "material", m)));
        scene.materialColors.push_back(baseColor(materials[m]));
        scene.materialTextures.push_back(textures.ofMaterial(materials[m]));
        scene.materialSets.push_back(textures.setOfMaterial(materials[m]));
    }
    scene.cornerColors = sharedColors(std::move(mColors), corners);
    scene.objectNames = std::move(mObjectNames);
    scene.faceMaterial = std::move(mFaceMaterial);
    PositionMatrix positions = Eigen::Map<const PositionMatrix>(
        mPositions.data(), static_cast<Eigen::Index>(mPositions.size() / 3), 3);
    scene.mesh = MeshData::build(std::move(positions), std::move(mFaceStart), std::move(mCornerVertex),
                                 std::move(mFaceObject));
    if (!mNormals.empty()) {
        mNormals.resize(3 * corners, 0.0);
        FileShading shading;
        shading.normals =
            Eigen::Map<const PositionMatrix>(mNormals.data(), static_cast<Eigen::Index>(corners), 3);
        scene.hardEdges = hardEdges(*scene.mesh, shading);
    }
}

void SoupBuilder::build(Scene &scene, GltfSource &source)
{
    for (const GltfMeshNode &node : meshNodes(mData.json()))
        addNode(node);
    if (mFaceObject.empty())
        throw GltfError("it has no faces");
    addNotes(scene);
    for (const auto &[set, values] : mUvs)
        source.texcoords.push_back(set);
    source.pieces = std::move(mPieces);
    source.contents.instances = !mInstancedMeshes.empty();
    source.setNames = gltfUvNames(mData.json(), source.texcoords);
    fill(scene, source);
}

bool hasElements(const Json &root, const char *array)
{
    return member(root, array).is_array() && !member(root, array).empty();
}

//! All but instances.
void takeContents(const Json &root, GltfSource &source)
{
    SourceContents &contents = source.contents;
    const auto uses = [&](const char *extension) {
        const Json &used = member(root, "extensionsUsed");
        return used.is_array() && std::find(used.begin(), used.end(), extension) != used.end();
    };
    contents.animations = hasElements(root, "animations");
    contents.severalAnimations = contents.animations && member(root, "animations").size() > 1;
    for (const Json &animation : member(root, "animations")) {
        for (const Json &channel : member(animation, "channels")) {
            const std::string path = textOf(member(channel, "target"), "path");
            contents.otherAnimations |= path != "translation" && path != "rotation" && path != "scale";
        }
    }
    contents.bones = hasElements(root, "skins");
    contents.lightsOrCameras = hasElements(root, "cameras") || uses("KHR_lights_punctual");
    contents.hierarchy = member(root, "nodes").size() > 1;
    source.compressed = uses("KHR_draco_mesh_compression") || uses("EXT_meshopt_compression");
    for (const Json &image : member(root, "images"))
        contents.embeddedTextures |= !member(image, "bufferView").is_null();
    for (const Json &mesh : member(root, "meshes")) {
        contents.splitObjects |= member(mesh, "primitives").size() > 1;
        for (const Json &primitive : member(mesh, "primitives")) {
            contents.shapeKeys |= hasElements(primitive, "targets");
            source.tangents |= member(primitive, "attributes").contains("TANGENT");
        }
    }
}

//! The bytes of a file that is named by a URI beside the file at `path`.
QByteArray loadBeside(const QString &path, const QByteArray &uri)
{
    const QString name = QUrl::fromPercentEncoding(uri);
    if (QUrl(name).scheme().size() > 1 || QDir::isAbsolutePath(name))
        throw GltfError("it refers to \"" + uri.left(200).toStdString() +
                        "\", which is not a file beside it");
    Result<QByteArray> bytes = loadFile(QFileInfo(path).dir().filePath(name), maxMeshFileSize);
    if (!bytes)
        throw GltfError("its buffer \"" + name.left(200).toStdString() +
                        "\" cannot be read: " + bytes.error().message.toStdString());
    return std::move(bytes).value();
}

Result<Scene> parse(GltfFile file, const QString &path,
                    const std::function<QByteArray(const QByteArray &)> &fetch, const std::atomic<bool> *stop)
{
    Scene scene;
    scene.path = path;
    scene.format = QFileInfo(path).suffix().toLower();
    auto source = std::make_shared<GltfSource>();
    source->file = std::move(file);
    try {
        const GltfDocument document = openGltf(source->file, fetch, stop);
        takeContents(document.json, *source);
        SoupBuilder(document, stop).build(scene, *source);
    } catch (const GltfStopped &) {
        return readingCancelled(path);
    } catch (const GltfVersion1 &) {
        return readWithAssimp(path, stop);
    } catch (const std::invalid_argument &) {
        return Error{QStringLiteral("the file cannot be read: its data contradict each other"), path, 0,
                     QStringLiteral("Export the model again from the program that made it")};
    } catch (const std::bad_alloc &) {
        throw;
    } catch (const std::exception &e) {
        return Error{QStringLiteral("the glTF file cannot be read: %1").arg(QString::fromUtf8(e.what())),
                     path, 0, QStringLiteral("Export the model again from the program that made it")};
    }
    scene.source = std::move(source);
    return scene;
}

} // namespace

Result<Scene> parseGltf(GltfFile file, const QString &path, const std::atomic<bool> *stop)
{
    return parse(std::move(file), path, {}, stop);
}

Result<Scene> readGltf(const QString &path, const std::atomic<bool> *stop)
{
    Result<QByteArray> bytes = loadFile(path, maxMeshFileSize);
    if (!bytes)
        return bytes.error();
    if (bytes->isEmpty())
        return Error{QStringLiteral("the file is empty"), path, 0, QStringLiteral("Export the model again")};
    const auto fetch = [&path](const QByteArray &uri) { return loadBeside(path, uri); };
    return parse({std::move(bytes).value(), {}}, path, fetch, stop);
}

} // namespace autocuts
