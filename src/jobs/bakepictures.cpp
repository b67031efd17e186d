#include "jobs/bakepictures.h"

#include "jobs/jobtexts.h"
#include "jobs/othermodel.h"
#include "jobs/shadedscene.h"
#include "model/io/outputs/fileclashes.h"
#include "model/pictures/picturesize.h"
#include "model/plain/udimtiles.h"
#include "model/transfer/surfacedistance.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <set>

namespace autocuts::jobs {

using namespace Qt::Literals::StringLiterals;

namespace {

QString nameOf(const bake::MapRequest &map)
{
    return QLatin1StringView(bake::nameOf(map.kind));
}

Result<Done> checkSize(const bake::TexelGrid &grid)
{
    if (grid.width <= maxPictureSide && grid.height <= maxPictureSide &&
        qint64(grid.width) * grid.height <= maxPicturePixels)
        return Done{};
    return Error{JobTexts::tr("pictures of %1 x %2 texels are too large").arg(grid.width).arg(grid.height),
                 {},
                 0,
                 JobTexts::tr("Bake at most %1 x %1, and use UDIM tiles for more").arg(maxPictureSide)};
}

bake::BakeJob jobOf(const BakeChoice &choice, const PackingSettings &packing)
{
    bake::BakeJob job;
    for (const auto &[name, kind] : bake::mapNames()) {
        if (choice.maps.contains(QLatin1StringView(name)))
            job.settings.maps.push_back({kind, 0});
    }
    job.settings.grid.width = choice.width > 0 ? choice.width : packing.textureSize;
    job.settings.grid.height =
        choice.width > 0 ? std::max(1, static_cast<int>(std::lround(choice.width * packing.tileHeight())))
                         : packing.height();
    job.settings.grid.perSide = choice.samplesPerSide;
    job.settings.rays.rays = choice.rays;
    job.settings.rays.reach = choice.reach;
    job.settings.rays.curvatureRadius = choice.curvatureRadius;
    job.settings.rays.thicknessLimit = choice.thicknessLimit;
    job.settings.cage.distance = choice.cage;
    job.settings.cage.direction = choice.direction;
    job.margin = choice.dilation;
    job.greenDown = choice.greenDown;
    job.floats = choice.suffix == u"exr";
    return job;
}

//! The tiles of the map that get pictures.
void chooseTiles(const MeshData &mesh, double tileHeight, PreparedBake &bake)
{
    const BakedTiles tiles = tilesToBake(mesh, bake.job.low.uv, tileHeight);
    bake.job.tiles = tiles.numbers;
    if (tiles.facesOutside > 0)
        bake.warnings.push_back({Remark::Kind::FacesNotBaked, double(tiles.facesOutside)});
}

//! Gives a surface the colours that a map of colours needs.
void takeColors(const DocumentState &model, const BakeChoice &choice, ShadedSurface &surface,
                Remarks &warnings)
{
    if (!choice.maps.contains(QLatin1StringView(bake::nameOf(bake::MapKind::Color))))
        return;
    QStringList missing;
    if (!addColors(model, choice.colors, surface, missing))
        warnings.push_back({Remark::Kind::NoSuchColors});
    if (!missing.isEmpty())
        warnings.push_back({Remark::Kind::UnreadableTextures, 0, missing});
}

//! Takes the positions of a cage from its file.
Result<Done> readCage(const QString &path, const MeshData &low, const JobContext &context, PreparedBake &bake)
{
    const Result<OtherModel> read = readOtherModel(path, 1, context);
    if (!read)
        return read.error();
    bake.read << read->files;
    bake.warnings.insert(bake.warnings.end(), read->warnings.begin(), read->warnings.end());
    const MeshData &mesh = *read->state.scene.mesh;
    if (mesh.faceStart != low.faceStart || mesh.cornerVertex != low.cornerVertex)
        return Error{JobTexts::tr("the cage has other faces than the model"), path, 0,
                     JobTexts::tr("Make it by moving the vertices of the model")};
    bake.job.settings.cage.positions = mesh.positions;
    return Done{};
}

//! \pre the detailed model is there
Result<Done> takeCage(const MeshData &low, const BakeChoice &choice, const JobContext &context,
                      PreparedBake &bake)
{
    if (!choice.cageFile.isEmpty())
        return readCage(choice.cageFile, low, context, bake);
    double &distance = bake.job.settings.cage.distance;
    if (!choice.ownCage) {
        const std::optional<double> measured =
            transfer::proposedCage(*bake.job.low.mesh, *bake.job.high->mesh, context.stopFlag());
        distance = measured.value_or(bake::CageSettings().distance);
        if (!measured && !context.stopped())
            bake.warnings.push_back({Remark::Kind::NoCage, distance});
    }
    bake.cage = distance;
    return Done{};
}

//! The texture sets of the model with the pictures that were baked.
std::vector<TextureSet> setsWith(const DocumentState &model, const std::map<QString, QString> &pictures,
                                 bool greenDown)
{
    std::vector<TextureSet> sets = model.textureSets;
    std::set<int> materials(model.scene.faceMaterial.begin(), model.scene.faceMaterial.end());
    if (materials.empty())
        materials.insert(-1);
    constexpr std::pair<const char *, TextureChannel> channels[]{{"normal", TextureChannel::Normal},
                                                                 {"ao", TextureChannel::Occlusion},
                                                                 {"color", TextureChannel::BaseColor}};
    for (const int material : materials) {
        const auto place = static_cast<std::size_t>(material) + 1; // -1, without a material, is the first one
        sets.resize(std::max(sets.size(), place + 1));
        for (const auto &[name, channel] : channels) {
            const auto picture = pictures.find(QLatin1StringView(name));
            if (picture == pictures.end())
                continue;
            ChannelPicture fresh;
            fresh.picture.file = picture->second;
            fresh.flipped = greenDown && channel == TextureChannel::Normal;
            sets[place][channel] = fresh;
        }
    }
    return sets;
}

//! The files that a bake must not replace. Colours that an earlier bake put on this model are made anew from
//! the detailed one.
QStringList filesToKeep(const PictureInput &input, const BakeChoice &choice, const QStringList &pictures)
{
    QStringList kept = input.kept;
    for (const TextureSet &set : input.model.textureSets) {
        const auto color = set.find(TextureChannel::BaseColor);
        if (!choice.high.isEmpty() && color != set.end() && pictures.contains(color->second.picture.file))
            kept.removeAll(color->second.picture.file);
    }
    return kept;
}

} // namespace

Result<PreparedBake> prepareBake(const DocumentState &model, const PackingSettings &packing,
                                 const BakeChoice &choice, const JobContext &context)
{
    const Scene &scene = model.scene;
    PreparedBake bake;
    bake.job = jobOf(choice, packing);
    if (const Result<Done> fine = checkSize(bake.job.settings.grid); !fine)
        return fine.error();
    bake.job.low = shadedSurface(scene, packing.tileHeight());
    if (bake.job.low.uv.rows() > 0)
        chooseTiles(*scene.mesh, packing.tileHeight(), bake);
    if (choice.high.isEmpty()) {
        takeColors(model, choice, bake.job.low, bake.warnings);
        return bake;
    }
    const Result<OtherModel> high = readOtherModel(choice.high, 1, context);
    if (!high)
        return high.error();
    bake.read << high->files;
    bake.warnings.insert(bake.warnings.end(), high->warnings.begin(), high->warnings.end());
    bake.job.kind = bake::SourceKind::Detailed;
    bake.job.high = shadedSurface(high->state.scene);
    if (const QString moved = placeLike(*bake.job.high, bake.job.low); !moved.isEmpty())
        addSaid(bake.warnings, {moved});
    takeColors(high->state, choice, *bake.job.high, bake.warnings);
    if (const Result<Done> cage = takeCage(*scene.mesh, choice, context, bake); !cage)
        return cage.error();
    if (choice.byName) {
        const QStringList alone =
            pairObjects(bake.job.low, scene.objectNames, *bake.job.high, high->state.scene.objectNames);
        if (!alone.isEmpty())
            bake.warnings.push_back({Remark::Kind::UnpairedObjects, 0, alone});
    }
    return bake;
}

QStringList bakedFiles(const Scene &scene, const UvMatrix &uv, double tileHeight, const BakeChoice &choice)
{
    const std::vector<int> tiles = tilesToBake(*scene.mesh, uv, tileHeight).numbers;
    QStringList files;
    for (const QString &map : choice.maps) {
        for (const int tile : tiles)
            files << bakedPath(choice.folder, scene.path, map, tile, tiles.size() > 1, choice.suffix);
    }
    return files;
}

Result<MadePictures> bakePictures(const PictureInput &input, const BakeChoice &choice,
                                  const JobContext &context)
{
    const Scene &scene = input.model.scene;
    if (!scene.hasUv())
        return Error{JobTexts::tr("the model has no UV map to bake into"), scene.path, 0,
                     JobTexts::tr("Unwrap it first")};
    const Result<PictureDepth> depth = pictureDepth(choice.suffix, choice.bits);
    if (!depth)
        return depth.error();
    context.enter(JobStage::Preparing);
    Result<PreparedBake> bake = prepareBake(input.model, input.packing, choice, context);
    if (!bake)
        return bake.error();
    const bake::BakeJob &job = bake->job;
    const std::vector<bake::MapRequest> &maps = job.settings.maps;
    const auto pathOf = [&](const bake::MapRequest &map, int tile) {
        return bakedPath(choice.folder, scene.path, nameOf(map), tile, job.tiles.size() > 1, choice.suffix);
    };
    const QStringList pictures =
        bakedFiles(scene, scene.uvSets.front().uv, input.packing.tileHeight(), choice);
    if (const Result<Done> fine =
            checkOutputs(pictures + input.alsoWritten, bake->read + filesToKeep(input, choice, pictures));
        !fine)
        return fine.error();
    if (const Result<Done> made = makePictureFolder(choice.folder); !made)
        return made.error();
    context.enter(JobStage::Working);
    MadePictures made;
    FileSet files;
    Result<Done> added = Done{};
    const auto sink = [&](std::size_t map, int tile, const Picture &picture) {
        const QString path = pathOf(maps[map], tile);
        added = addPicture(picture, path, depth.value(), files);
        made.fileOfMap.try_emplace(nameOf(maps[map]), path);
        return added.ok();
    };
    const bake::BakeFigures figures = bake::runBake(job, sink, context);
    if (!added)
        return added.error();
    if (const Result<Done> placed = files.putInPlace(); !placed)
        return placed.error();
    made.stopped = figures.stopped;
    made.files = files.paths();
    made.texels = figures.texels;
    made.missed = figures.missed;
    made.overlapped = figures.overlapped;
    for (std::size_t map = 0; map < maps.size(); ++map) {
        if (const std::optional<double> mean = figures.seams[map].mean())
            made.seamDifferences[nameOf(maps[map])] = 255 * *mean;
    }
    made.cage = bake->cage;
    made.warnings = std::move(bake->warnings);
    addTexels(made.warnings, Remark::Kind::TexelsMissed, figures.missed, figures.texels);
    addTexels(made.warnings, Remark::Kind::TexelsShared, figures.overlapped, figures.texels);
    if (std::ranges::any_of(choice.maps, isTextureOfMaterials))
        made.textureSets = setsWith(input.model, made.fileOfMap, choice.greenDown);
    return made;
}

Result<double> proposedCage(const DocumentState &model, const QString &high, const JobContext &context)
{
    const Result<OtherModel> read = readOtherModel(high, 1, context);
    if (!read)
        return read.error();
    const ShadedSurface low = shadedSurface(model.scene);
    ShadedSurface detailed = shadedSurface(read->state.scene);
    placeLike(detailed, low);
    const std::optional<double> cage = transfer::proposedCage(*low.mesh, *detailed.mesh, context.stopFlag());
    if (!cage)
        return Error{JobTexts::tr("the detailed model is nowhere near this one"), high, 0,
                     JobTexts::tr("Choose the model that belongs to this one")};
    return *cage;
}

} // namespace autocuts::jobs
