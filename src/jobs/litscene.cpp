#include "jobs/litscene.h"

#include "jobs/othermodel.h"
#include "model/document/shadedscene.h"
#include "model/io/outputs/bakefiles.h"

#include <QFileInfo>

#include <algorithm>
#include <memory>

namespace autocuts::jobs {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr float standardAlbedo = 0.8F;

using Albedo = std::function<Vec3f(const SurfacePoint &)>;

bool isExr(const QString &path)
{
    return path.endsWith(u".exr"_s, Qt::CaseInsensitive);
}

//! A picture of the base colours of all faces.
Result<SurfaceTexture> readAlbedo(const QString &path)
{
    Result<DecodedPicture> decoded = readDecodedPicture(path);
    if (!decoded)
        return decoded.error();
    SurfaceTexture texture;
    texture.kind = decoded->depth == PictureDepth::Float ? TextureKind::Linear : TextureKind::Srgb;
    texture.ofMaterial.emplace_back().repeated = std::make_shared<const Picture>(std::move(decoded->picture));
    return texture;
}

//! What reflects how much. \param shaded the model without UVs
Result<Albedo> albedoOf(const LitSceneOptions &options, const DocumentState &model,
                        const ShadedSurface &shaded, int textureSet, double tileHeight, QStringList &missing)
{
    if (options.albedo && options.albedoFile.isEmpty()) {
        return Albedo([color = *options.albedo](const SurfacePoint &) { return color; });
    }
    auto colored = std::make_shared<ShadedSurface>(shaded);
    colored->tileHeight = tileHeight;
    if (options.albedoFile.isEmpty()) {
        addColors(model, ColorSource::Auto, *colored, missing);
    } else {
        Result<SurfaceTexture> texture = readAlbedo(options.albedoFile);
        if (!texture)
            return texture.error();
        const Result<int> set = options.albedoUvSet.isEmpty()
                                    ? Result<int>(0)
                                    : findUvSet(model.scene.uvSets, options.albedoUvSet, model.scene.path);
        if (!set)
            return set.error();
        textureSet = set.value();
        colored->textures = {std::move(texture).value()};
        colored->cornerColors = nullptr;
        colored->materialColors.clear();
    }
    colored->uv = model.scene.uvSets[std::size_t(textureSet)].uv;
    return Albedo(
        [colored = std::shared_ptr<const ShadedSurface>(std::move(colored))](const SurfacePoint &point) {
            const Vec3f color = colored->baseColor(point).value_or(Vec3f::Constant(standardAlbedo));
            return Vec3f(color.cwiseMax(0.0F).cwiseMin(1.0F));
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
                u"there is no material \"%1\" that could be emissive"_s.arg(name), scene.path, 0,
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

Result<LitSurface> litSurface(const DocumentState &model, const LitSceneOptions &options, int textureSet,
                              double tileHeight, QStringList &missing)
{
    const Scene &scene = model.scene;
    if (!scene.hasUv())
        return Error{u"the model has no UV map to bake into"_s, scene.path, 0, u"Unwrap it first"_s};
    Scene bare = scene;
    bare.uvSets.clear(); // tangents are not needed
    ShadedSurface shaded = shadedSurface(bare);
    Result<Albedo> albedo = albedoOf(options, model, shaded, textureSet, tileHeight, missing);
    if (!albedo)
        return albedo.error();
    Result<std::vector<Vec3f>> emission = emissionOf(options, scene);
    if (!emission)
        return emission.error();
    return LitSurface{scene.mesh, scene.uvSets.front().uv, std::move(shaded.normals),
                      std::move(albedo).value(), std::move(emission).value()};
}

Result<PictureDepth> lightMapDepth(const QString &path, int bits)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    const bool floats = isExr(path);
    if (!floats && suffix != u"png" && suffix != u"tif" && suffix != u"tiff" && suffix != u"tga")
        return Error{u"light is baked into exr, png, tif and tga files"_s, path, 0, {}};
    const QFileInfo folder(QFileInfo(path).absolutePath());
    if (!folder.isDir() || !folder.isWritable())
        return Error{u"the folder for the picture does not exist or cannot be written"_s, path, 0,
                     u"Check its permissions or choose another one"_s};
    return pictureDepth(suffix, bits);
}

QString lightMapPath(const QString &path, int tile, bool several)
{
    const QFileInfo file(path);
    return several ? path.chopped(file.suffix().size()) + QString::number(tile) + u'.' + file.suffix() : path;
}

Result<Done> addLightMap(Picture picture, const QString &path, PictureDepth depth, FileSet &files)
{
    if (!isExr(path)) {
        for (float &value : picture.values)
            value = value == 0 ? 0 : srgbFromLinear(value); // most texels of an unfinished one are black
    }
    return addPicture(picture, path, depth, files);
}

} // namespace autocuts::jobs
