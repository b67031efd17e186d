#include "cli/batchlight.h"

#include "model/document/shadedscene.h"
#include "model/io/picturefiles.h"
#include "model/plain/chart.h"
#include "model/plain/udimtiles.h"

#include <QFileInfo>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr float standardAlbedo = 0.8F;
//! A bake keeps about 60 bytes per texel.
constexpr int maxLightmapSide = 8192;

//! A picture of colours, and where the corners lie in it.
struct AlbedoPicture
{
    Picture picture; //!< linear
    UvMatrix uv;
};

Result<AlbedoPicture> readAlbedo(const CliOptions &options, const Scene &scene)
{
    const QString &path = options.light.albedoFile, &word = options.light.albedoUvSet;
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
        return Error{u"there is no UV set \"%1\" for the picture"_s.arg(word), options.input, 0, {}};
    albedo.uv = found->uv;
    return albedo;
}

bake::Vec3f sampleAlbedo(const AlbedoPicture &albedo, const MeshData &mesh, const SurfacePoint &point)
{
    const auto &corners = mesh.triangles[point.triangle];
    const auto uv = [&](int k) -> Vec2 { return albedo.uv.row(corners[k]).transpose(); };
    const Vec2 at = point.between<Vec2>(uv(0), uv(1), uv(2));
    if (!at.allFinite())
        return bake::Vec3f::Constant(standardAlbedo);
    std::array<float, 4> color{};
    const int channels = albedo.picture.channels;
    sampleRepeated(albedo.picture, at, std::span(color).first(std::size_t(channels)));
    return channels < 3 ? bake::Vec3f(bake::Vec3f::Constant(color[0]))
                        : bake::Vec3f(color[0], color[1], color[2]);
}

//! What reflects how much.
Result<std::function<bake::Vec3f(const SurfacePoint &)>>
albedoOf(const CliOptions &options, const Scene &scene, const ShadedSurface &shaded)
{
    using Function = std::function<bake::Vec3f(const SurfacePoint &)>;
    if (!options.light.albedoFile.isEmpty()) {
        Result<AlbedoPicture> read = readAlbedo(options, scene);
        if (!read)
            return read.error();
        const auto albedo = std::make_shared<const AlbedoPicture>(std::move(read).value());
        return Function([albedo, mesh = scene.mesh](const SurfacePoint &point) {
            return sampleAlbedo(*albedo, *mesh, point);
        });
    }
    if (options.light.albedo) {
        return Function([color = *options.light.albedo](const SurfacePoint &) { return color; });
    }
    std::vector<bake::Vec3f> ofFace(scene.mesh->faceCount(), bake::Vec3f::Constant(standardAlbedo));
    for (std::size_t f = 0; f < shaded.faceMaterial.size(); ++f) {
        const int material = shaded.faceMaterial[f];
        if (material >= 0 && material < std::ssize(shaded.materialColors))
            ofFace[f] = shaded.materialColors[material];
    }
    return Function([ofFace = std::move(ofFace), mesh = scene.mesh](const SurfacePoint &point) {
        return ofFace[mesh->triangleFace[point.triangle]];
    });
}

//! The radiance of each face.
Result<std::vector<bake::Vec3f>> emissionOf(const CliOptions &options, const Scene &scene)
{
    std::vector<bake::Vec3f> emission;
    for (const auto &[name, radiance] : options.light.emission) {
        const auto found = std::ranges::find(scene.materialNames, name);
        if (found == scene.materialNames.end())
            return Error{
                u"there is no material \"%1\" that could shine"_s.arg(name), options.input, 0,
                scene.materialNames.empty()
                    ? u"The model has no materials"_s
                    : u"It has: %1"_s.arg(
                          QStringList(scene.materialNames.begin(), scene.materialNames.end()).join(u", "_s))};
        emission.resize(scene.mesh->faceCount(), bake::Vec3f::Zero());
        for (std::size_t f = 0; f < scene.faceMaterial.size(); ++f) {
            if (scene.faceMaterial[f] == found - scene.materialNames.begin())
                emission[f] = radiance;
        }
    }
    return emission;
}

Result<PictureDepth> depthOf(const CliOptions &options)
{
    const QString suffix = QFileInfo(options.output).suffix().toLower();
    const bool floats = suffix == u"exr";
    if (!floats && suffix != u"png" && suffix != u"tif" && suffix != u"tiff" && suffix != u"tga")
        return Error{u"light is baked into exr, png, tif and tga files"_s, options.output, 0, {}};
    const QFileInfo folder(QFileInfo(options.output).absolutePath());
    if (!folder.isDir() || !folder.isWritable())
        return Error{u"the folder for the picture does not exist or cannot be written"_s, options.output, 0,
                     u"Check its permissions or choose another one"_s};
    const int bits = options.light.bits.value_or(floats ? 32 : 8);
    if (floats ? bits < 16 : bits > 16)
        return Error{u"%1 files have no numbers of %2 bits"_s.arg(suffix).arg(bits), options.output, 0,
                     u"Choose other --bits or another format"_s};
    return bits == 8 ? PictureDepth::Eight : bits == 16 ? PictureDepth::Sixteen : PictureDepth::Float;
}

QString pathOf(const QString &output, int tile, bool several)
{
    const QFileInfo file(output);
    return several ? output.chopped(file.suffix().size()) + QString::number(tile) + u'.' + file.suffix()
                   : output;
}

} // namespace

Result<BakeOutcome> bakeLights(const CliOptions &options, const Scene &scene, const std::atomic<bool> &,
                               const JobContext &job)
{
    const PackingSettings &texture = options.unwrap.packing;
    if (!scene.hasUv())
        return Error{u"the model has no UV map to bake into"_s, options.input, 0, u"Unwrap it first"_s};
    if (texture.textureSize > maxLightmapSide || texture.height() > maxLightmapSide)
        return Error{u"light maps have at most %1 x %1 texels"_s.arg(maxLightmapSide), {}, 0, {}};
    const Result<PictureDepth> depth = depthOf(options);
    if (!depth)
        return depth.error();
    const ShadedSurface shaded = shadedSurface(scene, texture.tileHeight());
    auto albedo = albedoOf(options, scene, shaded);
    if (!albedo)
        return albedo.error();
    Result<std::vector<bake::Vec3f>> emission = emissionOf(options, scene);
    if (!emission)
        return emission.error();
    const bake::LitSurface surface{scene.mesh, shaded.uv, shaded.normals, albedo.value(), emission.value()};
    bake::LightBakeSettings settings = options.light.settings;
    settings.width = texture.textureSize;
    settings.height = texture.height();
    std::vector<int> tiles = usedTiles(
        islandTiles(*scene.mesh, findCharts(*scene.mesh, shaded.uv), shaded.uv, texture.tileHeight()));
    if (tiles.empty())
        tiles.push_back(PackingSettings::firstTile);
    BakeOutcome outcome;
    for (std::size_t i = 0; i < tiles.size() && !outcome.figures.stopped; ++i) {
        settings.tile = udimTile(tiles[i], texture.tileHeight());
        const double share = 1.0 / double(tiles.size()), done = double(i);
        bake::LightBakeResult baked = bakeLight(surface, options.light.lighting(), settings,
                                                job.part(done * share, (done + 1) * share));
        outcome.figures.stopped = baked.stopped;
        outcome.figures.texels += baked.texels;
        if (depth.value() != PictureDepth::Float && !options.output.endsWith(u".exr", Qt::CaseInsensitive))
            std::ranges::transform(baked.picture.values, baked.picture.values.begin(), srgbFromLinear);
        const QString path = pathOf(options.output, tiles[i], tiles.size() > 1);
        if (const Result<Done> written = writePicture(baked.picture, path, depth.value()); !written)
            return written.error();
        outcome.files << path;
    }
    return outcome;
}

} // namespace autocuts
