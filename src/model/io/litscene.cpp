#include "model/io/litscene.h"

#include "model/document/shadedscene.h"

#include <QFileInfo>

#include <algorithm>
#include <memory>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr float standardAlbedo = 0.8F;

using Albedo = std::function<Vec3f(const SurfacePoint &)>;

//! A picture of colours, and where the corners lie in it.
struct AlbedoPicture
{
    Picture picture; //!< linear
    UvMatrix uv;
};

bool isExr(const QString &path)
{
    return path.endsWith(u".exr"_s, Qt::CaseInsensitive);
}

Result<AlbedoPicture> readAlbedo(const LitSceneOptions &options, const Scene &scene)
{
    const QString &path = options.albedoFile, &word = options.albedoUvSet;
    const Result<QByteArray> bytes = loadPictureFile(path);
    if (!bytes)
        return bytes.error();
    Result<DecodedPicture> decoded = decodePicture(bytes.value(), path);
    if (!decoded)
        return decoded.error();
    AlbedoPicture albedo{std::move(decoded->picture), scene.uvSets.front().uv};
    if (decoded->depth != PictureDepth::Float)
        std::ranges::transform(albedo.picture.values, albedo.picture.values.begin(), linearFromSrgb);
    if (word.isEmpty())
        return albedo;
    const auto found = std::ranges::find_if(scene.uvSets, [&](const UvSet &set) { return set.name == word; });
    if (found == scene.uvSets.end())
        return Error{u"there is no UV set \"%1\" for the picture"_s.arg(word), scene.path, 0, {}};
    albedo.uv = found->uv;
    return albedo;
}

Vec3f sampleAlbedo(const AlbedoPicture &albedo, const MeshData &mesh, const SurfacePoint &point)
{
    const auto &corners = mesh.triangles[point.triangle];
    const auto uv = [&](int k) -> Vec2 { return albedo.uv.row(corners[k]).transpose(); };
    const Vec2 at = point.between<Vec2>(uv(0), uv(1), uv(2));
    if (!at.allFinite())
        return Vec3f::Constant(standardAlbedo);
    std::array<float, 4> color{};
    const int channels = albedo.picture.channels;
    sampleRepeated(albedo.picture, at, std::span(color).first(std::size_t(channels)));
    return channels < 3 ? Vec3f(Vec3f::Constant(color[0])) : Vec3f(color[0], color[1], color[2]);
}

//! What reflects how much.
Result<Albedo> albedoOf(const LitSceneOptions &options, const Scene &scene, const ShadedSurface &shaded)
{
    if (!options.albedoFile.isEmpty()) {
        Result<AlbedoPicture> read = readAlbedo(options, scene);
        if (!read)
            return read.error();
        const auto albedo = std::make_shared<const AlbedoPicture>(std::move(read).value());
        return Albedo([albedo, mesh = scene.mesh](const SurfacePoint &point) {
            return sampleAlbedo(*albedo, *mesh, point);
        });
    }
    if (options.albedo) {
        return Albedo([color = *options.albedo](const SurfacePoint &) { return color; });
    }
    std::vector<Vec3f> ofFace(scene.mesh->faceCount(), Vec3f::Constant(standardAlbedo));
    for (std::size_t f = 0; f < shaded.faceMaterial.size(); ++f) {
        const int material = shaded.faceMaterial[f];
        if (material >= 0 && material < std::ssize(shaded.materialColors))
            ofFace[f] = shaded.materialColors[material];
    }
    return Albedo([ofFace = std::move(ofFace), mesh = scene.mesh](const SurfacePoint &point) {
        return ofFace[mesh->triangleFace[point.triangle]];
    });
}

//! The radiance of each face.
Result<std::vector<Vec3f>> emissionOf(const LitSceneOptions &options, const Scene &scene)
{
    std::vector<Vec3f> emission;
    for (const auto &[name, radiance] : options.emission) {
        const auto found = std::ranges::find(scene.materialNames, name);
        if (found == scene.materialNames.end())
            return Error{
                u"there is no material \"%1\" that could shine"_s.arg(name), scene.path, 0,
                scene.materialNames.empty()
                    ? u"The model has no materials"_s
                    : u"It has: %1"_s.arg(
                          QStringList(scene.materialNames.begin(), scene.materialNames.end()).join(u", "_s))};
        emission.resize(scene.mesh->faceCount(), Vec3f::Zero());
        for (std::size_t f = 0; f < scene.faceMaterial.size(); ++f) {
            if (scene.faceMaterial[f] == found - scene.materialNames.begin())
                emission[f] = radiance;
        }
    }
    return emission;
}

} // namespace

Result<LitSurface> litSurface(const Scene &scene, const LitSceneOptions &options)
{
    if (!scene.hasUv())
        return Error{u"the model has no UV map to bake into"_s, scene.path, 0, u"Unwrap it first"_s};
    Scene bare = scene;
    bare.uvSets.clear(); // tangents are not needed
    ShadedSurface shaded = shadedSurface(bare);
    Result<Albedo> albedo = albedoOf(options, scene, shaded);
    if (!albedo)
        return albedo.error();
    Result<std::vector<Vec3f>> emission = emissionOf(options, scene);
    if (!emission)
        return emission.error();
    return LitSurface{scene.mesh, scene.uvSets.front().uv, std::move(shaded.normals),
                      std::move(albedo).value(), std::move(emission).value()};
}

Result<PictureDepth> lightMapDepth(const QString &path, std::optional<int> wanted)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    const bool floats = isExr(path);
    if (!floats && suffix != u"png" && suffix != u"tif" && suffix != u"tiff" && suffix != u"tga")
        return Error{u"light is baked into exr, png, tif and tga files"_s, path, 0, {}};
    const QFileInfo folder(QFileInfo(path).absolutePath());
    if (!folder.isDir() || !folder.isWritable())
        return Error{u"the folder for the picture does not exist or cannot be written"_s, path, 0,
                     u"Check its permissions or choose another one"_s};
    const int bits = wanted.value_or(floats ? 32 : 8);
    if (floats ? bits < 16 : bits > 16)
        return Error{u"%1 files have no numbers of %2 bits"_s.arg(suffix).arg(bits), path, 0,
                     u"Choose other --bits or another format"_s};
    return bits == 8 ? PictureDepth::Eight : bits == 16 ? PictureDepth::Sixteen : PictureDepth::Float;
}

QString lightMapPath(const QString &path, int tile, bool several)
{
    const QFileInfo file(path);
    return several ? path.chopped(file.suffix().size()) + QString::number(tile) + u'.' + file.suffix() : path;
}

Result<Done> writeLightMap(Picture picture, const QString &path, PictureDepth depth)
{
    if (!isExr(path)) {
        for (float &value : picture.values)
            value = value == 0 ? 0 : srgbFromLinear(value); // most texels of an unfinished one are black
    }
    return writePicture(picture, path, depth);
}

} // namespace autocuts
