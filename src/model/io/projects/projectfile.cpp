#include "model/io/projects/projectfile.h"

#include "model/io/files/savefile.h"
#include "model/io/projects/projectmigration.h"
#include "model/io/projects/projectscene.h"
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

constexpr qint64 maxProjectSize = qint64(4) << 30;
constexpr qsizetype longestName = 40; // of a part that is left out, in a message
constexpr int mostNamed = 5;          // of these parts; more are counted

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

//! Parts that were not read: of unknown names, and those whose names are there already.
void warnOfSkipped(const std::vector<QByteArray> &skipped, QStringList &warnings)
{
    const qsizetype count = std::ssize(skipped);
    for (qsizetype i = 0; i < std::min<qsizetype>(count, mostNamed); ++i) {
        const QByteArray &name = skipped[static_cast<std::size_t>(i)];
        warnings << (isKnown(name) ? u"the part \"%1\" is there twice, and the second one was left out"_s
                                   : u"the part \"%1\" is unknown and was left out: its name is damaged, or "
                                     "another version made it"_s)
                        .arg(QString::fromUtf8(name.left(longestName)));
    }
    if (count > mostNamed)
        warnings << u"%1 more parts are unknown or there twice, and were left out"_s.arg(count - mostNamed);
}

void addNotes(const ProjectParts &container, int lostSeams, LoadedProject &project)
{
    if (container.brokenOff)
        project.warnings << u"the session is cut off or damaged in the middle"_s;
    for (const QString &what : project.lost)
        project.warnings << u"%1: damaged in the session, left out"_s.arg(what);
    warnOfSkipped(container.skipped, project.warnings);
    if (lostSeams > 0)
        project.warnings << u"%1 seams do not fit the model and were left out"_s.arg(lostSeams);
    project.notes = project.warnings + project.notes;
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
    // Not every session has these.
    const std::pair<const char *, QString> optional[] = {
        {"texelWeights", u"the painted texel density"_s},
        {"textures", u"the texture sets"_s},
        {"gltf", u"the glTF file"_s},
        {"polygons", u"the polygons beside the glTF file"_s}, // without one the model is lost
    };
    for (const auto &[name, word] : optional) {
        if (std::find(damaged.begin(), damaged.end(), name) != damaged.end())
            project.lost << word;
    }
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

namespace fs = std::filesystem;

//! The backups of a session: PATH.1 and PATH.2, and PATH.new while it is being replaced.
class Backups
{
public:
    explicit Backups(const QString &path) : mFile(QFileInfo(path).filesystemAbsoluteFilePath()) {}

    //! Gives the current file a second name, so that replacing it does not destroy it.
    void keepCurrent()
    {
        mKept = true;
        std::error_code error;
        if (!fs::exists(mFile, error))
            return;
        const fs::path kept = beside(".new");
        // Left behind by a program that was killed, or a backup that could not be made.
        if (fs::exists(kept, error) && !fs::equivalent(kept, mFile, error))
            rotate();
        fs::remove(kept, error);
        fs::create_hard_link(fs::canonical(mFile, error), kept, error);
        if (error)
            fs::copy_file(mFile, kept, fs::copy_options::overwrite_existing, error);
        if (error)
            mProblem = error;
    }

    //! Makes the file that keepCurrent() kept PATH.1, and the previous PATH.1 PATH.2.
    void rotate()
    {
        std::error_code error;
        if (!fs::exists(beside(".new"), error))
            return;
        if (fs::exists(beside(".1"), error))
            fs::rename(beside(".1"), beside(".2"), error);
        if (!error)
            fs::rename(beside(".new"), beside(".1"), error);
        if (error)
            mProblem = error;
    }

    //! For a save that failed: takes back what keepCurrent() did.
    void forget()
    {
        std::error_code error;
        if (mKept)
            fs::remove(beside(".new"), error);
    }

    //! Why a backup could not be made; no error when all were.
    const std::error_code &problem() const { return mProblem; }

private:
    fs::path beside(const char *suffix) const { return fs::path(mFile) += suffix; }

    fs::path mFile;
    bool mKept = false; //!< keepCurrent() was called
    std::error_code mProblem;
};

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

Result<SavedProject> saveProjectBytes(const QByteArray &bytes, const QString &path)
{
    Backups backups(path);
    const Result<Done> saved = saveAtomically(path, bytes, [&] { backups.keepCurrent(); });
    if (!saved) {
        backups.forget();
        return saved.error();
    }
    backups.rotate();
    if (!backups.problem())
        return SavedProject();
    return SavedProject{u"the session is saved, but there is no backup of the one before (%1)"_s.arg(
        QString::fromLocal8Bit(backups.problem().message()))};
}

Result<SavedProject> saveProject(const DocumentState &state, const ProjectExtras &extras, const QString &path)
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
    const Result<QByteArray> bytes = loadFile(path, maxProjectSize);
    if (!bytes)
        return bytes.error();
    return parseProject(bytes.value(), path, stop);
}

Result<ProjectSummary> loadProjectSummary(const QString &path)
{
    const Result<QByteArray> bytes = loadFile(path, maxProjectSize);
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
