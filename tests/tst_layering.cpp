// Every #include under src/ against one table: which folder may include which, and that no files include each
// other in a circle. A shared include root lets any header through.
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

namespace {

const fs::path sourceRoot = fs::path(AUTOCUTS_SOURCE_DIR) / "src";

//! A layer of the program. Its folders stand in an order: each may include itself and those before it.
struct Layer
{
    std::string name;
    Names folders; //!< "" for a layer without folders
    Names below;   //!< layers and folders of other layers that any of its files may include
};

const std::vector<Layer> layers{
    {"model",
     {"plain", "transfer", "document", "editing", "samples", "io/files", "pictures", "io/formats", "io/obj",
      "io/assimp", "io/gltf", "io/collada", "io/fbx", "io/meshes", "io/projects", "io/outputs", "layouts"},
     {}},
    {"reader", {""}, {"model"}},
    {"commands", {""}, {"model"}},
    {"solver",
     {"base", "energy", "linear", "newton", "overlap", "rigid", "metrics", "preference", "packing", "search",
      "homotopy", "definite", "straight", "multires", "unwrap", "bake", "live"},
     {"model/plain"}},
    {"api", {""}, {"model/plain", "model/transfer", "solver"}}, // but solver/live: see mayInclude()
    {"jobs", {""}, {"model", "solver"}},                        // but solver/live: see mayInclude()
    {"link", {""}, {"model"}},
    {"cli", {"", "manyfiles", "program"}, {"model", "commands", "solver", "jobs"}},
    // Only views/control may include solver/: see mayInclude().
    {"views",
     {"ui", "state", "gl", "control/session", "control/figures", "control/mapjobs", "control/live",
      "control/files", "control/jobs", "control/pictures", "control/editing", "selecting", "canvas", "tools",
      "dialogs", "actions", "link", "panels", "shell"},
     {"model", "commands", "jobs", "link"}},
    {"", {""}, {"model", "commands", "link", "views"}}, // main.cpp
};

//! The files that call the operating system, one for each need. docs/building.md names them.
const std::set<std::string> systemCallers{"cli/manyfiles/machine.cpp",    "cli/program/startup.cpp",
                                          "model/io/files/filecalls.cpp", "model/io/files/readerprocess.cpp",
                                          "reader/process.cpp",           "solver/linear/loadedfunction.cpp"};

//! A library that one file alone includes, so that it could be replaced there.
struct ForeignLibrary
{
    std::regex headers;
    std::string file;
    std::string rule;
};

const std::vector<ForeignLibrary> libraries{
    {std::regex(R"(embree\d*/.*)"), "solver/bake/rayscene.cpp", "Embree belongs to solver/bake/rayscene.cpp"},
    {std::regex("draco/.*"), "model/io/gltf/gltfdraco.cpp", "Draco belongs to model/io/gltf/gltfdraco.cpp"},
    {std::regex("meshoptimizer.*"), "model/io/gltf/gltfmeshopt.cpp",
     "meshoptimizer belongs to model/io/gltf/gltfmeshopt.cpp"},
    {std::regex("nlohmann/.*"), "model/io/gltf/gltfjson.h",
     "nlohmann_json belongs to model/io/gltf/gltfjson.h"},
    {std::regex(R"((OpenEXR|Imath)/.*|(Imf|Iex|Imath)\w+\.h)"), "model/pictures/exrpictures.cpp",
     "OpenEXR belongs to model/pictures/exrpictures.cpp"},
    {std::regex("OpenMesh/.*"), "solver/multires/edgecollapses.cpp",
     "OpenMesh belongs to solver/multires/edgecollapses.cpp"},
};

struct Include
{
    std::string file;   //!< path below src/
    std::string header; //!< as it is written
    bool own = false;   //!< in quotes
};

std::string folderOf(const std::string &path)
{
    return fs::path(path).parent_path().generic_string();
}

bool isInside(const std::string &path, const std::string &folder)
{
    return path == folder || path.starts_with(folder + "/");
}

std::vector<Include> includesOf(const fs::path &root)
{
    static const std::regex line(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    std::vector<Include> result;
    for (const auto &entry : fs::recursive_directory_iterator(root)) {
        const auto suffix = entry.path().extension();
        if (suffix != ".h" && suffix != ".cpp")
            continue;
        std::ifstream file(entry.path());
        std::smatch match;
        for (std::string text; std::getline(file, text);) {
            if (std::regex_match(text, match, line))
                result.push_back(
                    {entry.path().lexically_relative(root).generic_string(), match[2], match[1] == "\""});
        }
    }
    return result;
}

//! The folders below one that have no README.md, or an empty one; ascending.
Names foldersWithoutReadme(const fs::path &root)
{
    Names result;
    for (const auto &entry : fs::recursive_directory_iterator(root)) {
        if (!entry.is_directory())
            continue;
        std::error_code missing;
        const auto size = fs::file_size(entry.path() / "README.md", missing);
        if (missing || size == 0)
            result.push_back(entry.path().lexically_relative(root).generic_string());
    }
    std::sort(result.begin(), result.end());
    return result;
}

const Layer *layerOf(const std::string &folder)
{
    const std::string name = folder.substr(0, folder.find('/'));
    const auto found =
        std::find_if(layers.begin(), layers.end(), [&](const Layer &layer) { return layer.name == name; });
    return found == layers.end() ? nullptr : &*found;
}

//! Place of a folder in the order of its layer; -1 when the table does not name it. A folder inside one of
//! the table belongs to it.
int rank(const Layer &layer, const std::string &folder)
{
    const std::string name = folder == layer.name ? "" : folder.substr(layer.name.size() + 1);
    const auto found = std::find_if(layer.folders.begin(), layer.folders.end(),
                                    [&](const std::string &known) { return isInside(name, known); });
    return found == layer.folders.end() ? -1 : static_cast<int>(found - layer.folders.begin());
}

bool mayInclude(const std::string &folder, const std::string &target)
{
    const Layer *layer = layerOf(folder);
    if (!layer)
        return false;
    if (layerOf(target) == layer)
        return rank(*layer, target) >= 0 && rank(*layer, target) <= rank(*layer, folder);
    if (isInside(folder, "views/control") && isInside(target, "solver"))
        return true;
    if ((folder == "jobs" || folder == "api") && isInside(target, "solver/live"))
        return false;
    return std::any_of(layer->below.begin(), layer->below.end(),
                       [&](const std::string &allowed) { return isInside(target, allowed); });
}

//! What is wrong with a header of the project, or nothing.
std::string problemWithOwn(const Include &i)
{
    const std::string folder = folderOf(i.file);
    const Layer *layer = layerOf(folder);
    if (!layer || rank(*layer, folder) < 0)
        return "the table does not name its folder";
    if (!fs::exists(sourceRoot / i.header))
        return "not a path from src/";
    if (!mayInclude(folder, folderOf(i.header)))
        return "against the order of the folders";
    return {};
}

//! What is wrong with a header of a library, or nothing.
std::string problemWithForeign(const Include &i)
{
    static const std::regex qt("(Qt?[A-Z]\\w*(/.*)?|qt\\w*/.*|q[a-z0-9]+\\.h)");
    static const std::regex widgets(
        "Q\\w*(Widget|Window|Dialog|Button|OpenGL|Label|Layout|Menu|Dock)\\w*(/.*)?");
    const std::string folder = folderOf(i.file);
    if (std::regex_match(i.header, qt)) {
        if ((isInside(folder, "solver") && folder != "solver/live") || folder == "model/plain" ||
            folder == "model/transfer" || folder == "reader")
            return "no Qt here";
        if (!isInside(folder, "views") && !folder.empty() && std::regex_match(i.header, widgets))
            return "widgets and OpenGL belong to views/";
    }
    static const std::regex system("(unistd|dlfcn|fcntl|poll|spawn|langinfo|windows|io)\\.h|sys/.*");
    if (std::regex_match(i.header, system) && !systemCallers.contains(i.file))
        return "the operating system is called in a few files only";
    static const std::regex threads("thread|future|QThreadPool|QtConcurrent.*|pthread\\.h|tbb/.*");
    if (std::regex_match(i.header, threads) && i.file != "model/plain/parallel.h")
        return "threads are started in model/plain/parallel.h";
    static const std::regex assimp(R"(model/io/(assimp|collada|fbx|gltf)/assimp\w+\.(h|cpp))");
    if (i.header.starts_with("assimp/") && !std::regex_match(i.file, assimp))
        return "Assimp belongs to files assimp* in four folders of model/io";
    if ((i.header.starts_with("cholmod") || i.header.starts_with("suitesparse/")) &&
        folder != "solver/linear")
        return "CHOLMOD belongs to solver/linear/";
    for (const ForeignLibrary &library : libraries) {
        if (std::regex_match(i.header, library.headers) && i.file != library.file)
            return library.rule;
    }
    return {};
}

std::string problemWith(const Include &i)
{
    return i.own ? problemWithOwn(i) : problemWithForeign(i);
}

//! Files that include each other in a circle, one line per circle. A header and its source count as one file.
std::string circles(const std::vector<Include> &includes)
{
    const auto unit = [](const std::string &path) {
        return fs::path(path).replace_extension().generic_string();
    };
    std::map<std::string, std::set<std::string>> graph;
    for (const Include &i : includes) {
        if (i.own && unit(i.file) != unit(i.header))
            graph[unit(i.file)].insert(unit(i.header));
    }
    // What has nothing left to include, or is included by nothing that is left, is in no circle.
    for (bool changed = true; changed;) {
        changed = false;
        std::set<std::string> targets;
        for (const auto &[file, included] : graph)
            targets.insert(included.begin(), included.end());
        for (auto node = graph.begin(); node != graph.end();) {
            std::erase_if(node->second, [&](const std::string &target) { return !graph.contains(target); });
            if (node->second.empty() || !targets.contains(node->first)) {
                node = graph.erase(node);
                changed = true;
            } else {
                ++node;
            }
        }
    }
    std::string result;
    for (const auto &[file, included] : graph) {
        for (const std::string &target : included)
            result.append("\n").append(file).append(" includes ").append(target).append(": in a circle");
    }
    return result;
}

} // namespace

class TestLayering : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyIncludeIsAllowed()
    {
        const auto includes = includesOf(sourceRoot);
        QVERIFY(includes.size() > 1000);
        std::string problems;
        for (const Include &i : includes) {
            if (const std::string problem = problemWith(i); !problem.empty())
                problems.append("\n")
                    .append(i.file)
                    .append(" includes ")
                    .append(i.header)
                    .append(": ")
                    .append(problem);
        }
        QVERIFY2(problems.empty(), problems.c_str());
    }

    void everyFolderExists()
    {
        for (const Layer &layer : layers) {
            for (const std::string &folder : layer.folders)
                QVERIFY2(fs::is_directory(sourceRoot / layer.name / folder),
                         (layer.name + "/" + folder).c_str());
        }
    }

    void everyFolderHasAReadme()
    {
        const std::vector<std::string> without = foldersWithoutReadme(sourceRoot);
        QVERIFY2(without.empty(), without.empty() ? "" : without.front().c_str());
    }

    void foldersWithoutReadmeAreFound()
    {
        const QTemporaryDir folder;
        QVERIFY(folder.isValid());
        const fs::path root = folder.path().toStdString();
        fs::create_directories(root / "a/inner");
        fs::create_directories(root / "b");
        std::ofstream(root / "a/README.md") << "# a\n\nWhat lies here.\n";
        std::ofstream(root / "b/README.md") << "";
        QCOMPARE(foldersWithoutReadme(root), (Names{"a/inner", "b"}));
    }

    void noCircles()
    {
        const std::string found = circles(includesOf(sourceRoot));
        QVERIFY2(found.empty(), found.c_str());
    }

    void breachesAreFound_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("header");
        QTest::addColumn<bool>("own");
        const auto row = [](const char *file, const char *header, bool own) {
            QTest::addRow("%s -> %s", file, header)
                << QString::fromLatin1(file) << QString::fromLatin1(header) << own;
        };
        // Between layers.
        row("model/document/scene.cpp", "solver/linear/linearsolver.h", true);
        row("commands/setuvs.cpp", "solver/linear/linearsolver.h", true);
        row("solver/newton/minimizer.cpp", "model/document/scene.h", true);
        row("views/panels/seampanel.cpp", "solver/linear/linearsolver.h", true);
        row("cli/batch.cpp", "views/ui/theme.h", true);
        row("main.cpp", "solver/base/soup.h", true);
        row("elsewhere/file.cpp", "model/plain/types.h", true);
        // Between the folders of a layer.
        row("model/plain/meshdata.h", "model/document/scene.h", true);
        row("model/document/scene.h", "model/io/meshes/meshfile.h", true);
        row("model/io/assimp/assimpscene.h", "model/io/gltf/gltfsource.h", true);
        row("model/io/formats/modelunits.h", "model/io/meshes/meshfile.h", true);
        row("model/io/file.h", "model/io/files/savefile.h", true);
        row("solver/base/soup.h", "solver/energy/energyterm.h", true);
        row("solver/search/cutstate.h", "solver/definite/stitching.h", true);
        row("solver/soup.cpp", "solver/base/soup.h", true);
        row("views/canvas/canvas.cpp", "views/tools/dragtool.h", true);
        row("views/ui/theme.h", "views/control/session/workspace.h", true);
        row("views/tools/seamtool.cpp", "views/actions/actionregistry.h", true);
        row("views/control/live/livepacker.cpp", "views/control/jobs/mapcontroller.h", true);
        row("views/control/files/opening.cpp", "views/control/pictures/livebake.h", true);
        // Not from src/.
        row("model/document/scene.h", "scene.h", true);
        // Libraries.
        row("solver/newton/minimizer.h", "QString", false);
        row("solver/newton/minimizer.h", "QtCore/QString", false);
        row("model/plain/types.h", "QVector", false);
        row("model/document/scene.h", "QWidget", false);
        row("cli/batch.h", "QWidget", false);
        row("model/document/scene.cpp", "assimp/scene.h", false);
        row("model/io/assimp/blendnames.cpp", "assimp/scene.h", false);
        row("model/io/obj/assimpobj.cpp", "assimp/scene.h", false);
        row("model/document/scene.cpp", "OpenMesh/Core/IO/MeshIO.hh", false);
        row("solver/multires/progressivemesh.cpp", "OpenMesh/Core/Mesh/Traits.hh", false);
        row("solver/newton/minimizer.cpp", "cholmod.h", false);
        row("solver/bake/pathtracer.cpp", "embree3/rtcore.h", false);
        row("solver/preference/raytree.cpp", "embree4/rtcore.h", false);
        row("model/io/gltf/gltfprimitive.cpp", "draco/compression/decode.h", false);
        row("model/io/gltf/gltfdata.cpp", "meshoptimizer.h", false);
        row("model/pictures/picturefiles.cpp", "OpenEXR/ImfInputPart.h", false);
        row("model/pictures/hdrpictures.cpp", "ImfRgbaFile.h", false);
        row("model/io/outputs/bakefiles.cpp", "Imath/half.h", false);
        row("model/io/gltf/gltfnodes.cpp", "nlohmann/json.hpp", false);
        row("link/handedmodel.cpp", "nlohmann/json_fwd.hpp", false);
        row("reader/main.cpp", "QString", false);
        row("reader/process.cpp", "QtCore/QString", false);
        row("solver/unwrap/readyresult.h", "thread", false);
        row("views/ui/task.h", "QThreadPool", false);
        // The operating system.
        row("model/io/files/savefile.cpp", "unistd.h", false);
        row("cli/batch.cpp", "sys/stat.h", false);
    }

    void breachesAreFound()
    {
        QFETCH(QString, file);
        QFETCH(QString, header);
        QFETCH(bool, own);
        QVERIFY(!problemWith({file.toStdString(), header.toStdString(), own}).empty());
    }

    void circlesAreFound()
    {
        const auto own = [](const char *file, const char *header) { return Include{file, header, true}; };
        QVERIFY(
            circles({own("a.h", "b.h"), own("b.cpp", "b.h"), own("b.h", "c.h"), own("d.h", "a.h")}).empty());
        QVERIFY(!circles({own("a.h", "b.h"), own("b.h", "a.h")}).empty());
        // Through a source file, and over three files.
        QVERIFY(!circles({own("a.cpp", "b.h"), own("b.h", "a.h")}).empty());
        QVERIFY(!circles({own("a.h", "b.h"), own("b.h", "c.h"), own("c.cpp", "a.h")}).empty());
    }
};

QTEST_APPLESS_MAIN(TestLayering)
#include "tst_layering.moc"
