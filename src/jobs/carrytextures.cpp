#include "jobs/carrytextures.h"

#include "jobs/carriedsurface.h"
#include "jobs/jobtexts.h"
#include "jobs/othermodel.h"
#include "jobs/shadedscene.h"
#include "model/io/outputs/bakefiles.h"
#include "model/io/outputs/fileclashes.h"
#include "model/pictures/texturefiles.h"
#include "model/plain/udimtiles.h"
#include "model/plain/uvlayout.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <map>

namespace autocuts::jobs {

using namespace Qt::Literals::StringLiterals;

namespace {

using From = CarryChoice::From;

//! A texture that was read.
struct Source
{
    bake::CarryTexture texture;
    PictureDepth depth = PictureDepth::Eight;
};

//! What a file of this kind can hold of a depth.
PictureDepth depthFor(const QString &path, PictureDepth depth)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == "exr"_L1)
        return depth == PictureDepth::Float ? depth : PictureDepth::Sixteen;
    if (suffix == "tga"_L1 || suffix == "jpg"_L1 || suffix == "jpeg"_L1)
        return PictureDepth::Eight;
    return std::min(depth, PictureDepth::Sixteen);
}

Result<Source> readSource(const CarriedPicture &picture, const std::vector<int> &faceMaterial,
                          const CarrySettings &settings)
{
    Result<ReadPictures> read = readPictures(picture.source);
    if (!read)
        return read.error();
    Source source;
    source.depth = read->depth;
    source.texture.picture = std::move(read->pictures);
    source.texture.width = settings.width > 0 ? settings.width : read->width;
    source.texture.height = settings.height > 0 ? settings.height : read->height;
    source.texture.floats = source.depth == PictureDepth::Float;
    source.texture.kind =
        picture.kind == TextureKind::Srgb && source.texture.floats ? TextureKind::Linear : picture.kind;
    if (!picture.materials.empty()) {
        for (const int material : faceMaterial)
            source.texture.faces.push_back(std::ranges::binary_search(picture.materials, material));
    }
    return source;
}

//! The model with the map that the textures are for, as its first UV set.
struct Before
{
    Scene scene;
    std::optional<OtherModel> file; //!< that it comes from
};

Result<Before> modelBefore(const PictureInput &input, const std::optional<UvMatrix> &mapOfTextures,
                           const CarryChoice &choice, const JobContext &context)
{
    const Scene &scene = input.model.scene;
    Before before;
    if (choice.from == From::UvSet) {
        before.scene = withFirstSet(scene, choice.uvSet);
    } else if (choice.from == From::File) {
        Result<OtherModel> file = readOtherModel(choice.file, input.packing.tileHeight(), context);
        if (!file)
            return file.error();
        const std::vector<UvSet> &sets = file->state.scene.uvSets;
        const Result<int> set = choice.fileUvSet.isEmpty() ? Result<int>(file->state.activeUvSet)
                                                           : findUvSet(sets, choice.fileUvSet, choice.file);
        if (!set)
            return set.error();
        before.scene = withFirstSet(file->state.scene, set.value());
        before.file = std::move(file).value();
        if (!before.scene.hasUv())
            return withLosses(
                {JobTexts::tr("the model has no UV map that its textures could be for"), choice.file, 0, {}},
                *before.file);
    } else {
        if (!mapOfTextures || mapOfTextures->rows() != scene.mesh->cornerCount())
            return Error{JobTexts::tr("cannot tell which UV map these textures were made for"),
                         {},
                         0,
                         JobTexts::tr("Choose the file or the UV set that has it")};
        before.scene = scene;
        before.scene.uvSets.front().uv = *mapOfTextures;
    }
    return before;
}

bool sameMap(const Scene &a, const Scene &b)
{
    return a.hasUv() && b.hasUv() && samePolygons(*a.mesh, *b.mesh) &&
           sameBits(a.uvSets.front().uv, b.uvSets.front().uv);
}

//! The materials of an old model on the faces of the new one.
std::vector<int> materialsOf(const Scene &old, const Scene &scene)
{
    if (samePolygons(*old.mesh, *scene.mesh))
        return old.faceMaterial;
    std::map<QString, int> places; // the first of each name
    for (std::size_t material = 0; material < old.materialNames.size(); ++material)
        places.try_emplace(old.materialNames[material], int(material));
    std::vector<int> materials;
    for (const int material : scene.faceMaterial) {
        const QString name = material < 0 ? QString() : scene.materialNames[std::size_t(material)];
        const auto found = places.find(name);
        const int only = old.materialNames.size() == 1 ? 0 : -1;
        materials.push_back(found == places.end() ? only : found->second);
    }
    return materials;
}

//! The model whose textures are carried over: the one with the new map, or that of the file where it has
//! none.
DocumentState texturedModel(const DocumentState &model, const Before &before)
{
    if (!before.file || hasTextures(model))
        return model;
    DocumentState textured = before.file->state;
    textured.scene.faceMaterial = materialsOf(before.scene, model.scene);
    return textured;
}

} // namespace

Result<CarriedFiles> carryPictures(const CarryPlan &plan, const std::vector<int> &faceMaterial,
                                   const bake::CarryModel &model, const CarrySettings &settings,
                                   const JobContext &context)
{
    CarriedFiles result;
    if (plan.pictures.empty())
        return Error{JobTexts::tr("there are no pictures that could be carried over"),
                     {},
                     0,
                     JobTexts::tr("Check the textures of the materials")};
    if (const QString source = plan.overwrittenSource(); !source.isEmpty())
        return Error{JobTexts::tr("the new picture would overwrite the one it is made from"), source, 0,
                     JobTexts::tr("Choose another folder or another ending of the names")};
    context.enter(JobStage::Working);
    FileSet files;
    std::optional<Error> firstProblem;
    const double count = double(plan.pictures.size());
    for (std::size_t i = 0; i < plan.pictures.size() && !context.stopped(); ++i) {
        CarriedPicture picture = plan.pictures[i];
        const Result<Source> source = readSource(picture, faceMaterial, settings);
        if (!source && settings.needsAll)
            return source.error();
        if (!source) {
            result.problems << source.error().toString();
            if (!firstProblem)
                firstProblem = source.error();
            continue;
        }
        const QFileInfo info(picture.newFile);
        if (source->depth == PictureDepth::Float && info.suffix() != "exr"_L1)
            picture.newFile = info.dir().filePath(info.completeBaseName() + u".exr"_s);
        const PictureDepth depth = depthFor(picture.newFile, source->depth);
        Result<Done> added = Done{};
        const auto sink = [&](int tile, const Picture &made) {
            added = addPicture(made, fileOfTile(picture.newFile, tile), depth, files);
            return added.ok();
        };
        result.figures.add(bake::carryTexture(model, source->texture, sink,
                                              context.part(double(i) / count, double(i + 1) / count)));
        if (!added)
            return added.error();
        result.plan.pictures.push_back(picture);
    }
    if ((result.stopped = context.stopped()))
        return result;
    if (result.plan.pictures.empty())
        return *firstProblem;
    if (const Result<Done> placed = files.putInPlace(); !placed)
        return placed.error();
    result.files = files.paths();
    return result;
}

Result<MadePictures> carryTextures(const PictureInput &input, const std::optional<UvMatrix> &mapOfTextures,
                                   const CarryChoice &choice, const JobContext &context)
{
    const Scene &scene = input.model.scene;
    if (!scene.hasUv())
        return Error{JobTexts::tr("the model has no UV map to bake into"), scene.path, 0,
                     JobTexts::tr("Unwrap it first")};
    const double tileHeight = input.packing.tileHeight();
    context.enter(JobStage::Preparing);
    const Result<Before> before = modelBefore(input, mapOfTextures, choice, context);
    if (!before)
        return before.error();
    MadePictures made;
    QStringList kept = input.kept;
    if (before->file) {
        made.warnings = before->file->warnings;
        kept << before->file->files;
    }
    CarriedSurface source = carriedSurface(before->scene, scene, tileHeight);
    const bake::CarryModel model{shadedSurface(scene, tileHeight), std::move(source.surface),
                                 source.sameTriangles, bake::CageSettings(), choice.margin};
    const BakedTiles tiles = tilesToBake(*scene.mesh, model.low.uv, tileHeight);
    if (tiles.facesOutside > 0)
        made.warnings.push_back({Remark::Kind::FacesWithoutPicture, double(tiles.facesOutside)});
    const DocumentState textured = texturedModel(input.model, before.value());
    const bool ofMaterials = choice.textures.isEmpty();
    const CarryTarget target{choice.folder, choice.suffix, tiles.numbers.size() > 1, choice.format};
    const CarryPlan plan =
        ofMaterials ? planCarrying(textured, target) : planCarrying(choice.textures, target);
    if (!plan.missing.isEmpty() && (plan.pictures.empty() || !ofMaterials))
        return Error{JobTexts::tr("there is no such picture"), plan.missing.front(), 0,
                     JobTexts::tr("Check its name")};
    if (!plan.missing.isEmpty())
        made.warnings.push_back({Remark::Kind::MissingPictures, 0, plan.missing});
    // Those that are not there yet overwrite nothing.
    if (const Result<Done> fine = checkOutputs(plan.existingFiles() + input.alsoWritten, kept); !fine)
        return fine.error();
    // Pictures of another size, or chosen ones, have a use on the same map, too.
    if (ofMaterials && choice.size == 0 && sameMap(before->scene, scene)) {
        const Error fits = choice.from == From::Textures
                               ? Error{JobTexts::tr("the textures seem to fit this UV map already"),
                                       {},
                                       0,
                                       JobTexts::tr("Choose the file or the UV set that they are for")}
                               : Error{JobTexts::tr("the textures fit this map already"), {}, 0, {}};
        return before->file ? withLosses(fits, *before->file) : fits;
    }
    if (const Result<Done> folder = makePictureFolder(choice.folder); !folder)
        return folder.error();
    CarrySettings settings;
    settings.width = choice.size;
    settings.height = choice.size > 0 ? std::max(1, int(std::lround(choice.size * tileHeight))) : 0;
    settings.needsAll = !ofMaterials;
    const Result<CarriedFiles> carried =
        carryPictures(plan, textured.scene.faceMaterial, model, settings, context);
    if (!carried)
        return carried.error();
    made.stopped = carried->stopped;
    made.files = carried->files;
    made.texels = carried->figures.texels;
    made.missed = carried->figures.missed;
    made.overlapped = carried->figures.overlapped;
    addSaid(made.warnings, carried->problems);
    addTexels(made.warnings, Remark::Kind::CarriedTexelsMissed, made.missed, made.texels);
    addTexels(made.warnings, Remark::Kind::TexelsShared, made.overlapped, made.texels);
    if (ofMaterials && !made.stopped && hasTextures(input.model))
        made.textureSets = carriedSets(input.model, carried->plan);
    return made;
}

} // namespace autocuts::jobs
