#include "model/io/projectfile.h"

#include "model/io/projectmigration.h"
#include "model/io/projectscene.h"
#include "model/io/savefile.h"
#include "model/plain/polygonsides.h"

#include <QCborArray>
#include <QCborMap>
#include <QFileInfo>

#include <algorithm>
#include <filesystem>
#include <new>
#include <set>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qint64 maxFileSize = qint64(4) << 30;

//! Blocks whose content is already compressed.
bool isCompressed(const QByteArray &name)
{
    return name == "thumbnail" || name == "journal";
}

bool isModel(const QByteArray &name)
{
    return name == "obj" || name == "fbx" || name == "gltf" || name == "polygons";
}

//! True for the names of the blocks that are read.
bool isKnown(const QByteArray &name)
{
    static const std::set<QByteArray> names{
        "scene",        "obj",         "fbx",       "gltf",        "polygons",     "uvSets",
        "seams",        "constraints", "marks",     "settings",    "selection",    "view",
        "journalStart", "journal",     "thumbnail", "sessionPath", "texelWeights", "textures"};
    return names.contains(name) || isUvPart(name);
}

//! Position of a block in the file: the most important ones come first, in case the file is truncated.
int rank(const QByteArray &name)
{
    if (isModel(name))
        return 0;
    return name.startsWith("journal") ? 2 : 1;
}

QByteArray journalStart(const Journal &journal)
{
    QCborMap map;
    for (const auto &[name, content] : statePartsOf(journal.initial, StateScope::Journal))
        map[QString::fromLatin1(name)] = content;
    return map.toCborValue().toCbor();
}

QByteArray journalCommands(const Journal &journal)
{
    QCborArray commands;
    for (const QByteArray &command : journal.commands)
        commands.append(command);
    return QCborMap{{"commands"_L1, commands}}.toCborValue().toCbor();
}

//! Reads both blocks of the journal; false when they are damaged.
bool readJournal(const PartMap &parts, const Scene &scene, Journal &journal)
{
    const auto start = parts.find("journalStart");
    const auto commands = parts.find("journal");
    if (start == parts.end() || commands == parts.end())
        return false;
    const std::optional<QCborMap> startMap = parsedMap(start->second);
    const std::optional<QCborMap> commandsMap = parsedMap(commands->second);
    if (!startMap || !commandsMap || !commandsMap->value("commands"_L1).isArray())
        return false;
    PartMap startParts;
    for (const auto &entry : *startMap)
        startParts[entry.first.toString().toLatin1()] = entry.second.toByteArray();
    journal.initial.scene = scene;
    if (const LostParts lost = readStateParts(startParts, StateScope::Journal, journal.initial);
        !lost.names.isEmpty() || lost.seams > 0 || !journal.initial.validate().isEmpty())
        return false;
    for (const QCborValue &command : commandsMap->value("commands"_L1).toArray()) {
        if (!command.isByteArray())
            return false;
        journal.commands.push_back(command.toByteArray());
    }
    return true;
}

void readExtras(const PartMap &parts, bool hadJournal, LoadedProject &project)
{
    if (hadJournal) {
        Journal journal;
        if (readJournal(parts, project.state.scene, journal))
            project.extras.journal = std::move(journal);
        else
            project.lost << u"the journal"_s;
    }
    if (const auto thumbnail = parts.find("thumbnail"); thumbnail != parts.end())
        project.extras.thumbnail = thumbnail->second;
    else
        project.lost << u"the thumbnail"_s;
    if (const auto path = parts.find("sessionPath"); path != parts.end())
        project.extras.sessionPath = QString::fromUtf8(path->second);
    else
        project.lost << u"the session's own path"_s;
}

void addNotes(const ProjectParts &container, int lostSeams, LoadedProject &project)
{
    if (container.brokenOff)
        project.notes << u"the session is cut off or damaged in the middle"_s;
    for (const QString &what : project.lost)
        project.notes << u"%1: damaged in the session, left out"_s.arg(what);
    if (lostSeams > 0)
        project.notes << u"%1 seams do not fit the model and were left out"_s.arg(lostSeams);
    const Scene &scene = project.state.scene;
    if (!scene.source && scene.format != "obj"_L1 && !scene.format.isEmpty())
        project.notes
            << u"the session holds the polygons, names and UV sets of the %1 file, not its normals, "
               "textures, bones and animations"_s.arg(scene.format);
}

Result<LoadedProject> parse(const QByteArray &bytes, const QString &path, const std::atomic<bool> *stop)
{
    const auto isStopped = [stop] { return stop && *stop; };
    Result<ProjectParts> container = readContainer(bytes, projectVersion, path, isKnown);
    if (!container)
        return container.error();
    PartMap &parts = container->parts;
    const auto &damaged = container->damaged;
    if (!migrateParts(parts, container->version, projectMigrations()))
        return Error{u"the session is of an old version and cannot be brought up to date"_s, path, 0,
                     u"Open a backup of it: the same name with .1 or .2 behind it"_s};
    if (isStopped())
        return readingCancelled(path);
    LoadedProject project;
    Result<Scene> scene = readSceneParts(parts, path, project.lost);
    if (!scene)
        return scene.error();
    if (isStopped())
        return readingCancelled(path);
    project.state.scene = std::move(scene).value();
    const LostParts lost = readStateParts(parts, StateScope::Session, project.state);
    project.lost += lost.names;
    if (std::find(damaged.begin(), damaged.end(), "texelWeights") != damaged.end())
        project.lost << u"the painted texel density"_s; // not every session has it
    if (std::find(damaged.begin(), damaged.end(), "textures") != damaged.end())
        project.lost << u"the texture sets"_s;
    if (container->version == 1 && !hasNumbersOfVersion1(*project.state.scene.mesh) &&
        parts.erase("journal") > 0) {
        parts.erase("journalStart");
        project.notes
            << u"the journal was left out and begins anew: it cannot be replayed, because it numbers the "
               "edges of this model in a way that changed since"_s;
    }
    const bool hadJournal = parts.contains("journal") || parts.contains("journalStart") ||
                            container->brokenOff ||
                            std::any_of(damaged.begin(), damaged.end(),
                                        [](const QByteArray &name) { return name.startsWith("journal"); });
    readExtras(parts, hadJournal, project);
    addNotes(container.value(), lost.seams, project);
    if (const QString problem = project.state.validate(); !problem.isEmpty())
        return Error{u"the session contradicts itself (%1)"_s.arg(problem), path, 0,
                     u"Open a backup of it: the same name with .1 or .2 behind it"_s};
    return project;
}

//! Makes PATH.1 the current file, and PATH.2 the previous PATH.1. PATH stays in place. A failure to make a
//! backup does not prevent saving.
void rotateBackups(const QString &path)
{
    namespace fs = std::filesystem;
    const fs::path file = QFileInfo(path).filesystemAbsoluteFilePath();
    const auto beside = [&](const char *suffix) { return fs::path(file) += suffix; };
    std::error_code error;
    if (!fs::exists(file, error))
        return;
    // Created under another name first, so that neither backup is ever incomplete.
    const fs::path fresh = beside(".new");
    fs::remove(fresh, error);
    fs::create_hard_link(fs::canonical(file, error), fresh, error);
    if (error && !fs::copy_file(file, fresh, fs::copy_options::overwrite_existing, error))
        return;
    fs::rename(beside(".1"), beside(".2"), error);
    fs::rename(fresh, beside(".1"), error);
}

} // namespace

bool isProjectPath(const QString &path)
{
    return QFileInfo(path).suffix().compare(QLatin1StringView(projectSuffix), Qt::CaseInsensitive) == 0;
}

QByteArray ProjectWriter::bytes(const DocumentState &state, const ProjectExtras &extras)
{
    PartMap parts = statePartsOf(state, StateScope::Session);
    parts.merge(scenePartsOf(state.scene));
    parts["thumbnail"] = extras.thumbnail;
    parts["sessionPath"] = extras.sessionPath.toUtf8();
    if (extras.journal) {
        parts["journalStart"] = journalStart(*extras.journal);
        parts["journal"] = journalCommands(*extras.journal);
    }
    std::vector<PackedBlock> blocks;
    if (mMesh != state.scene.mesh)
        mModel.clear();
    mMesh = state.scene.mesh;
    for (const auto &[name, content] : parts) {
        if (isModel(name) && !mModel.contains(name))
            mModel[name] = packBlock(name, content);
        blocks.push_back(isModel(name) ? mModel[name] : packBlock(name, content, !isCompressed(name)));
    }
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const PackedBlock &a, const PackedBlock &b) { return rank(a.name) < rank(b.name); });
    return containerBytes(projectVersion, blocks);
}

Result<Done> saveProjectBytes(const QByteArray &bytes, const QString &path)
{
    return saveAtomically(path, bytes, [&] { rotateBackups(path); });
}

Result<Done> saveProject(const DocumentState &state, const ProjectExtras &extras, const QString &path)
{
    return saveProjectBytes(ProjectWriter().bytes(state, extras), path);
}

Result<LoadedProject> parseProject(const QByteArray &bytes, const QString &path,
                                   const std::atomic<bool> *stop)
{
    try {
        return parse(bytes, path, stop);
    } catch (const std::bad_alloc &) {
        return Error{u"there is not enough memory to open the session"_s, path, 0, u"Close other programs"_s};
    }
}

Result<LoadedProject> loadProject(const QString &path, const std::atomic<bool> *stop)
{
    const Result<QByteArray> bytes = loadFile(path, maxFileSize);
    if (!bytes)
        return bytes.error();
    return parseProject(bytes.value(), path, stop);
}

Result<ProjectSummary> loadProjectSummary(const QString &path)
{
    const Result<QByteArray> bytes = loadFile(path, maxFileSize);
    if (!bytes)
        return bytes.error();
    const Result<ProjectParts> container =
        readContainer(bytes.value(), projectVersion, path, [](const QByteArray &name) {
            return name == "thumbnail" || name == "sessionPath" || name == "scene";
        });
    if (!container)
        return container.error();
    ProjectSummary summary;
    if (const QByteArray *thumbnail = container->part("thumbnail"))
        summary.thumbnail = *thumbnail;
    if (const QByteArray *sessionPath = container->part("sessionPath"))
        summary.sessionPath = QString::fromUtf8(*sessionPath);
    if (const QByteArray *scene = container->part("scene"))
        summary.modelPath = modelPathIn(*scene);
    return summary;
}

} // namespace autocuts
