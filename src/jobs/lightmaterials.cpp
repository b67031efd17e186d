#include "jobs/lightmaterials.h"

#include "jobs/jobtexts.h"
#include "jobs/othermodel.h"
#include "jobs/shadedscene.h"
#include "model/io/outputs/bakefiles.h"
#include "model/pictures/picturefiles.h"

#include <algorithm>
#include <memory>

namespace autocuts::jobs {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr float standardAlbedo = 0.8F;

using Albedo = std::function<Vec3f(const SurfacePoint &)>;

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
Result<Albedo> albedoOf(const LightMaterials &materials, const DocumentState &model,
                        const ShadedSurface &shaded, int textureSet, double tileHeight, QStringList &missing)
{
    if (materials.albedo && materials.albedoFile.isEmpty()) {
        return Albedo([color = *materials.albedo](const SurfacePoint &) { return color; });
    }
    auto colored = std::make_shared<ShadedSurface>(shaded);
    colored->tileHeight = tileHeight;
    if (materials.albedoFile.isEmpty()) {
        addColors(model, ColorSource::Auto, *colored, missing);
    } else {
        Result<SurfaceTexture> texture = readAlbedo(materials.albedoFile);
        if (!texture)
            return texture.error();
        const Result<int> set = materials.albedoUvSet.isEmpty()
                                    ? Result<int>(0)
                                    : findUvSet(model.scene.uvSets, materials.albedoUvSet, model.scene.path);
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
Result<std::vector<Vec3f>> emissionOf(const LightMaterials &materials, const Scene &scene)
{
    std::vector<Vec3f> emission;
    for (const auto &[name, radiance] : materials.emission) {
        const auto found = std::ranges::find(scene.materialNames, name);
        if (found == scene.materialNames.end())
            return Error{JobTexts::tr("there is no material \"%1\" that could be emissive").arg(name),
                         scene.path, 0,
                         scene.materialNames.empty()
                             ? JobTexts::tr("The model has no materials")
                             : JobTexts::tr("It has: %1")
                                   .arg(QStringList(scene.materialNames.begin(), scene.materialNames.end())
                                            .join(u", "_s))};
        emission.resize(scene.mesh->faceCount(), Vec3f::Zero());
        for (std::size_t f = 0; f < scene.faceMaterial.size(); ++f) {
            if (scene.faceMaterial[f] == found - scene.materialNames.begin())
                emission[f] = radiance;
        }
    }
    return emission;
}

} // namespace

Result<LitSurface> litSurface(const DocumentState &model, const LightMaterials &materials, int textureSet,
                              double tileHeight, QStringList &missing)
{
    const Scene &scene = model.scene;
    if (!scene.hasUv())
        return Error{JobTexts::tr("the model has no UV map to bake into"), scene.path, 0,
                     JobTexts::tr("Unwrap it first")};
    Scene bare = scene;
    bare.uvSets.clear(); // tangents are not needed
    ShadedSurface shaded = shadedSurface(bare);
    Result<Albedo> albedo = albedoOf(materials, model, shaded, textureSet, tileHeight, missing);
    if (!albedo)
        return albedo.error();
    Result<std::vector<Vec3f>> emission = emissionOf(materials, scene);
    if (!emission)
        return emission.error();
    return LitSurface{scene.mesh, scene.uvSets.front().uv, std::move(shaded.normals),
                      std::move(albedo).value(), std::move(emission).value()};
}

} // namespace autocuts::jobs
