#include "cli/batchpictures.h"

#include "cli/outputcheck.h"
#include "jobs/bakelight.h"
#include "jobs/bakepictures.h"
#include "jobs/carrytextures.h"
#include "jobs/othermodel.h"
#include "model/layouts/modelpicture.h"
#include "model/layouts/uvexport.h"

#include <QJsonArray>
#include <QPainter>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

jobs::PictureInput inputOf(const CliOptions &options, const BatchFiles &files, const Scene &scene)
{
    const DocumentState model = files.modelOf(scene);
    return {model, options.unwrap.packing, keptFiles(options, model), {options.report}};
}

} // namespace

Result<jobs::MadePictures> bakeMaps(const CliOptions &options, const BatchFiles &files, const Scene &scene,
                                    const JobContext &context)
{
    jobs::BakeChoice choice = options.bake;
    choice.folder = options.output;
    return jobs::bakePictures(inputOf(options, files, scene), choice, context);
}

Result<jobs::MadePictures> bakeLights(const CliOptions &options, const BatchFiles &files, const Scene &scene,
                                      const JobContext &context)
{
    jobs::LightChoice choice = options.light;
    choice.path = options.output;
    QString &set = choice.surface.albedoUvSet;
    if (!set.isEmpty()) {
        // In the order of the file, which is not that of the scene.
        const Result<int> found = jobs::findUvSet(files.uvSets(), set, options.input);
        if (!found)
            return found.error();
        set = files.uvSets()[std::size_t(found.value())].name;
    }
    // The textures of materials are for the first UV set of the file.
    const int textureSet = files.activeUvSet() == 0 ? 0 : 1;
    return jobs::bakeLight(inputOf(options, files, scene), textureSet, choice, {}, context);
}

Result<jobs::MadePictures> carryTextures(const CliOptions &options, const BatchFiles &files,
                                         const Scene &scene, const JobContext &context)
{
    jobs::CarryChoice choice;
    choice.from = jobs::CarryChoice::From::File;
    choice.file = options.from.isEmpty() ? options.input : options.from;
    choice.fileUvSet = options.fromUvSet;
    if (options.textures != QStringList{u"all"_s})
        choice.textures = options.textures;
    choice.folder = options.output;
    if (options.given.contains(u"--texture-size"_s))
        choice.size = options.unwrap.packing.textureSize;
    return jobs::carryTextures(inputOf(options, files, scene), {}, choice, context);
}

QImage thumbnailOf(const CliOptions &options, const Scene &scene)
{
    const int side = options.pictureSide;
    LayoutOptions layout;
    layout.size = side;
    QImage map;
    if (options.show != CliOptions::Show::Model && scene.hasUv()) {
        if (const Result<QByteArray> png = layoutPng(*scene.mesh, scene.uvSets.front().uv, layout))
            map = QImage::fromData(png.value());
    }
    if (options.show == CliOptions::Show::Map && !map.isNull())
        return map;
    const QImage model = modelPicture(*scene.mesh, side);
    if (options.show != CliOptions::Show::Both)
        return model;
    QImage both(2 * side, side, QImage::Format_ARGB32_Premultiplied);
    both.fill(Qt::transparent);
    QPainter painter(&both);
    painter.drawImage(0, 0, model);
    painter.drawImage(side, 0, map);
    return both;
}

QJsonObject pictureReport(const jobs::MadePictures &made)
{
    QJsonObject seams;
    for (const auto &[map, difference] : made.seamDifferences)
        seams.insert(map, difference);
    QJsonObject report{{u"files"_s, QJsonArray::fromStringList(made.files)},
                       {u"texels"_s, made.texels},
                       {u"texels_missed"_s, made.missed},
                       {u"texels_overlapping"_s, made.overlapped},
                       {u"seam_differences"_s, seams}};
    if (made.cage)
        report.insert(u"cage"_s, *made.cage);
    return report;
}

} // namespace autocuts
