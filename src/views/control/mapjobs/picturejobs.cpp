#include "views/control/mapjobs/picturejobs.h"

#include "commands/replay.h"
#include "jobs/bakelight.h"
#include "jobs/bakepictures.h"
#include "jobs/carrytextures.h"
#include "jobs/jobtexts.h"
#include "jobs/othermodel.h"
#include "model/io/files/setjournal.h"
#include "model/io/outputs/fileclashes.h"

#include <QDir>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! The longer side of the pictures that views get; a finer one would make the views wait.
constexpr int largestShown = 2048;

//! As in a file of 8 bits. Black texels are mostly those without a value.
QImage shownImage(const Picture &picture)
{
    const int step = (std::max(picture.width, picture.height) + largestShown - 1) / largestShown;
    QImage image(picture.width / step, picture.height / step, QImage::Format_RGB32);
    const auto part = [](float value) {
        return value > 0 ? static_cast<int>(std::lround(255 * std::min(1.0F, srgbFromLinear(value)))) : 0;
    };
    for (int y = 0; y < image.height(); ++y) {
        auto *line = reinterpret_cast<QRgb *>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x) {
            const std::span<const float> texel = picture.at(x * step, y * step);
            line[x] = qRgb(part(texel[0]), part(texel[1]), part(texel[2]));
        }
    }
    return image;
}

jobs::PictureInput inputOf(const DocumentState &model, const PackingSettings &packing,
                           const QString &sessionPath)
{
    return {model, packing, filesOfSession(model, sessionPath, true), {}};
}

MapJobResult failed(const QString &problem)
{
    MapJobResult result;
    result.problem = problem;
    return result;
}

//! \param message what was made \param ended lines on sets of files that were completed before
MapJobResult resultOf(const QString &message, const QStringList &ended, const jobs::MadePictures &made)
{
    MapJobResult result;
    result.message = message;
    const QStringList warnings = ended + jobs::textsOf(made.warnings);
    if (!warnings.isEmpty())
        result.problem = message + QStringLiteral(". ") + warnings.join(QStringLiteral(". "));
    return result;
}

} // namespace

MapJobResult bakeJob(const DocumentState &model, const MapInput &input, const jobs::BakeChoice &choice,
                     JobControl &control)
{
    const QStringList ended = endBrokenSets({choice.folder, choice.high});
    const Result<jobs::MadePictures> made =
        jobs::bakePictures(inputOf(model, input.packing, input.sessionPath), choice, contextOf(control));
    if (!made)
        return failed(control.stop() ? JobTexts::tr("Cancelled: nothing was baked")
                                     : made.error().toString());
    const auto count = static_cast<int>(made->files.size());
    const QString folder = QDir::toNativeSeparators(choice.folder);
    if (made->stopped && count == 0)
        return failed(JobTexts::tr("Cancelled: nothing was baked"));
    if (made->stopped)
        return failed(JobTexts::tr("Cancelled: %n pictures were finished in %1", nullptr, count).arg(folder));
    MapJobResult result =
        resultOf(JobTexts::tr("Baked %n pictures into %1", nullptr, count).arg(folder), ended, made.value());
    if (choice.isPutOn())
        result.textures = MadeTextures{model.textureSets, made->textureSets, true};
    return result;
}

MapJobResult lightBakeJob(const DocumentState &model, int textureSet, const MapInput &input,
                          const jobs::LightChoice &choice, const LightReceiver &shown, JobControl &control)
{
    const QStringList ended = endBrokenSets({choice.path});
    bake::LightTilePreview preview;
    if (shown)
        preview = [&shown](int tile, const Picture &picture) { shown(tile, shownImage(picture)); };
    const Result<jobs::MadePictures> made = jobs::bakeLight(inputOf(model, input.packing, input.sessionPath),
                                                            textureSet, choice, preview, contextOf(control));
    if (!made)
        return failed(made.error().toString());
    const QString files = QDir::toNativeSeparators(made->files.join(QStringLiteral(", ")));
    if (made->stopped)
        return failed(files.isEmpty() ? JobTexts::tr("Cancelled: no light was baked")
                                      : JobTexts::tr("Cancelled: %1 has what was found so far").arg(files));
    return resultOf(JobTexts::tr("Baked light into %1").arg(files), ended, made.value());
}

MapJobResult carryJob(const CarryInput &input, const QString &sessionPath, const jobs::CarryChoice &choice,
                      JobControl &control)
{
    const QString cancelled = JobTexts::tr("Cancelled: no picture was written");
    const QStringList ended = endBrokenSets({choice.folder, choice.file});
    std::optional<UvMatrix> mapOfTextures;
    if (choice.from == jobs::CarryChoice::From::Textures)
        mapOfTextures = autocuts::mapOfTextures(input.journal.finished());
    jobs::PictureInput model = inputOf(input.state, input.state.packingSettings, sessionPath);
    model.model.scene = jobs::withFirstSet(std::move(model.model.scene), input.state.activeUvSet);
    jobs::CarryChoice own = choice; // with sets in that order
    if (choice.uvSet == 0)
        own.uvSet = input.state.activeUvSet;
    else if (choice.uvSet == input.state.activeUvSet)
        own.uvSet = 0;
    const Result<jobs::MadePictures> made =
        jobs::carryTextures(model, mapOfTextures, own, contextOf(control));
    if (control.stop() || (made && made->stopped))
        return failed(cancelled);
    if (!made)
        return failed(made.error().toString());
    MapJobResult result = resultOf(
        JobTexts::tr("Carried %n pictures over into %1", nullptr, static_cast<int>(made->files.size()))
            .arg(QDir::toNativeSeparators(choice.folder)),
        ended, made.value());
    result.textures = MadeTextures{input.state.textureSets, made->textureSets};
    return result;
}

} // namespace autocuts
