#include "cli/outputcheck.h"

#include "model/io/files/savefile.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/outputs/fileclashes.h"
#include "model/io/projects/projectfile.h"
#include "model/pictures/texturefiles.h"

#include <QFileInfo>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

using Command = CliOptions::Command;

bool carriesTextures(const CliOptions &options)
{
    return options.command == Command::Transfer && !options.textures.isEmpty();
}

//! True when -o names a mesh or session, not pictures.
bool writesModel(const CliOptions &options)
{
    return options.command != Command::Bake && options.command != Command::LightBake &&
           options.command != Command::Thumbnail && !carriesTextures(options);
}

//! The files that the options name to be read, without the input.
QStringList otherInputs(const CliOptions &options)
{
    QStringList files{options.from, options.bake.high, options.bake.cageFile,
                      options.light.surface.albedoFile};
    for (const QString &texture : options.textures) {
        for (const TextureTile &tile : textureTiles(texture))
            files << tile.path;
    }
    return files;
}

bool isRewritten(const CliOptions &options)
{
    return fileKey(options.input) == fileKey(options.output) &&
           QFileInfo(options.input)
                   .suffix()
                   .compare(QFileInfo(options.output).suffix(), Qt::CaseInsensitive) == 0;
}

} // namespace

Result<Done> checkOutputFile(const QString &path)
{
    const QFileInfo folder(QFileInfo(path).absolutePath());
    if (!folder.isDir())
        return Error{u"the output folder does not exist"_s, folder.filePath(), 0, u"Create it first"_s};
    if (QFileInfo(path).isDir())
        return Error{u"this is a folder, not a file"_s, path, 0, u"Add a file name to the path"_s};
    if (!folder.isWritable())
        return Error{u"the output folder is read-only"_s, folder.filePath(), 0,
                     u"Check its permissions or choose another one"_s};
    return checkTarget(path);
}

QStringList namedFiles(const CliOptions &options)
{
    const QString input = options.command == Command::Sample ? QString() : options.input;
    return QStringList{input, options.output, options.layout, options.report} + otherInputs(options);
}

Result<Done> checkTargets(const CliOptions &options)
{
    const bool picturesInFolder = options.command == Command::Bake || carriesTextures(options);
    for (const QString &target :
         {picturesInFolder ? QString() : options.output, options.layout, options.report}) {
        if (target.isEmpty())
            continue;
        if (Result<Done> fine = checkOutputFile(target); !fine)
            return fine;
    }
    if (Result<Done> fine = checkClashes(options, DocumentState()); !fine)
        return fine;
    if (!writesModel(options) || options.output.isEmpty() || isProjectPath(options.output))
        return Done{};
    return checkWriteFormat(options.output);
}

QStringList keptFiles(const CliOptions &options, const DocumentState &model)
{
    return QStringList{options.input, model.scene.path} + otherInputs(options) + filesBeside(model, true);
}

Result<Done> checkClashes(const CliOptions &options, const DocumentState &model)
{
    const QString input = options.command == Command::Sample ? QString() : options.input;
    const QStringList inputs = otherInputs(options);
    const QStringList own{input, model.scene.path};
    QStringList kept = own + inputs + filesBeside(model);
    if (writesModel(options)) {
        const bool again = !options.output.isEmpty() && isRewritten(options);
        const QStringList other = inputs + filesBeside(model) + QStringList{again ? QString() : input};
        if (Result<Done> fine = checkOutputs({options.output}, other); !fine)
            return fine;
        kept += QStringList{options.output} + filesWrittenBeside(options.output, model.scene);
    } else if (options.command == Command::LightBake) {
        const QStringList written = withTiles(options.output);
        if (Result<Done> fine = checkOutputs(written, own + inputs + filesBeside(model, true)); !fine)
            return fine;
        kept += written;
    } else if (options.command == Command::Bake) {
        kept += options.output; // the folder of the pictures
    } else if (options.command == Command::Thumbnail) {
        kept += options.output;
        if (Result<Done> fine = checkOutputs({options.output}, own); !fine)
            return fine;
    }
    return checkOutputs(withTiles(options.layout) + QStringList{options.report}, kept);
}

} // namespace autocuts
