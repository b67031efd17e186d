#include "jobs/othermodel.h"

#include "model/io/files/savefile.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/outputs/fileclashes.h"
#include "model/io/projects/projectfile.h"

#include <QFileInfo>

#include <algorithm>

namespace autocuts::jobs {

using namespace Qt::Literals::StringLiterals;

namespace {

//! What a session has lost, one line each with its file name.
QStringList lossesOf(const QString &path, const QStringList &warnings)
{
    QStringList losses;
    for (const QString &warning : warnings)
        losses << QFileInfo(path).fileName() + u": "_s + warning;
    return losses;
}

Result<OtherModel> read(const QString &path, double tileHeight, const std::atomic<bool> &stop)
{
    OtherModel model;
    if (isProjectPath(path)) {
        Result<LoadedProject> project = loadProject(path, &stop);
        if (!project)
            return project.error();
        model.state = std::move(project->state);
        addSaid(model.warnings, lossesOf(path, project->warnings));
    } else {
        Result<Scene> scene = readMesh(path, &stop, tileHeight);
        if (!scene)
            return scene.error();
        model.state.scene = std::move(scene).value();
    }
    model.files = filesOfSession(model.state, path, true);
    return model;
}

QString setsInWords(const std::vector<UvSet> &sets)
{
    QStringList names;
    for (const UvSet &set : sets)
        names << u"\"%1\""_s.arg(set.name);
    return names.isEmpty() ? u"The file has no UV sets: use --new-uv-set"_s
                           : u"The file has %1"_s.arg(names.join(u", "_s));
}

} // namespace

Result<OtherModel> readOtherModel(const QString &path, double tileHeight, const JobContext &context)
{
    return read(path, tileHeight, context.stopFlag());
}

Error withLosses(Error error, const OtherModel &model)
{
    if (!model.warnings.empty())
        error.message += u" ("_s + textsOf(model.warnings).join(u"; "_s) + u')';
    return error;
}

Scene withFirstSet(Scene scene, int set)
{
    if (set > 0 && set < std::ssize(scene.uvSets))
        std::swap(scene.uvSets.front(), scene.uvSets[std::size_t(set)]);
    return scene;
}

Result<int> findUvSet(const std::vector<UvSet> &sets, const QString &word, const QString &path)
{
    const auto named = std::ranges::find_if(sets, [&](const UvSet &set) { return set.name == word; });
    if (named != sets.end())
        return static_cast<int>(named - sets.begin());
    bool isNumber = false;
    const int number = word.toInt(&isNumber);
    if (isNumber && number >= 1 && number <= std::ssize(sets))
        return number - 1;
    return Error{u"there is no UV set \"%1\""_s.arg(word), path, 0, setsInWords(sets)};
}

} // namespace autocuts::jobs
