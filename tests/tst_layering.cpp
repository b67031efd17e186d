// Every #include under src/ against the layers of the program: a shared include root lets any header through.
#include <QTest>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace fs = std::filesystem;
using Names = std::set<std::string>;

namespace {

const fs::path sourceRoot = fs::path(AUTOCUTS_SOURCE_DIR) / "src";

//! Headers of model/ that hold data only: the solver may include them, and they include nothing of Qt.
const Names plainHeaders{"chart.h",           "indexranges.h", "meshadjacency.h",      "meshdata.h",
                         "packingsettings.h", "polygon.h",     "settingsproperties.h", "snapshot.h",
                         "solvesettings.h",   "types.h",       "unionfind.h",          "uvlayout.h"};

//! Layers that a layer may include besides itself. The empty name stands for src/ itself: the programs.
const std::map<std::string, Names> allowedLayers{
    {"model", {}},
    {"commands", {"model"}},
    {"solver", {"model"}},
    {"views", {"model", "commands", "solver"}},
    {"", {"model", "commands", "solver", "views"}},
};

struct Include
{
    fs::path file; //!< relative to src/
    std::string header;
    bool own = false; //!< in quotes
    std::string layer() const { return file.has_parent_path() ? file.begin()->string() : std::string(); }
    std::string stem() const { return file.stem().string(); }
};

std::vector<Include> allIncludes()
{
    static const std::regex line(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    std::vector<Include> result;
    for (const auto &entry : fs::recursive_directory_iterator(sourceRoot)) {
        const auto suffix = entry.path().extension();
        if (suffix != ".h" && suffix != ".cpp")
            continue;
        std::ifstream file(entry.path());
        std::smatch match;
        for (std::string text; std::getline(file, text);) {
            if (std::regex_match(text, match, line))
                result.push_back({entry.path().lexically_relative(sourceRoot), match[2], match[1] == "\""});
        }
    }
    return result;
}

bool startsWith(const std::string &text, const char *prefix)
{
    return text.rfind(prefix, 0) == 0;
}

bool isPlain(const Include &i)
{
    return i.layer() == "model" && plainHeaders.contains(i.file.filename().string());
}

//! What is wrong with a header of the project, or nothing.
std::string problemWithOwn(const Include &i)
{
    const fs::path header(i.header);
    if (!fs::exists(sourceRoot / header))
        return "not a path from src/";
    const std::string target = header.has_parent_path() ? header.begin()->string() : std::string();
    const auto allowed = allowedLayers.find(i.layer());
    if (allowed == allowedLayers.end())
        return "a folder that is no layer";
    if (target != i.layer() && !allowed->second.contains(target))
        return "not allowed in this layer";
    const bool plainTarget = target == "model" && plainHeaders.contains(header.filename().string());
    if ((i.layer() == "solver" && target == "model" && !plainTarget) || (isPlain(i) && !plainTarget))
        return "only the plain headers of model/ may be included here";
    if (i.layer() == "views" && target == "solver" && !startsWith(i.file.generic_string(), "views/control/"))
        return "views/ reaches the solver from views/control/ only";
    if (i.file.filename() == "climain.cpp" && target == "views")
        return "the command line has no views";
    return {};
}

//! What is wrong with a header of a library, or nothing.
std::string problemWithForeign(const Include &i)
{
    static const std::regex qt("(Qt?[A-Z]\\w*(/.*)?|qt\\w*/.*|q[a-z0-9]+\\.h)");
    static const std::regex widgets(
        "Q\\w*(Widget|Window|Dialog|Button|OpenGL|Label|Layout|Menu|Dock)\\w*(/.*)?");
    const std::string path = i.file.generic_string();
    if (std::regex_match(i.header, qt)) {
        if ((i.layer() == "solver" && i.stem() != "worker") || isPlain(i))
            return "no Qt here";
        if (i.layer() != "views" && !i.layer().empty() && std::regex_match(i.header, widgets))
            return "widgets and OpenGL belong to views/";
    }
    if (startsWith(i.header, "assimp/") && !startsWith(path, "model/io/assimp"))
        return "Assimp belongs to model/io/assimp*";
    if (startsWith(i.header, "OpenMesh/") && path != "solver/multires/edgecollapses.cpp")
        return "OpenMesh belongs to solver/multires/edgecollapses.cpp";
    if ((startsWith(i.header, "cholmod") || startsWith(i.header, "suitesparse/")) &&
        !startsWith(path, "solver/linear/"))
        return "CHOLMOD belongs to solver/linear/";
    return {};
}

std::string problemWith(const Include &i)
{
    return i.own ? problemWithOwn(i) : problemWithForeign(i);
}

} // namespace

class TestLayering : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyIncludeRespectsTheLayers()
    {
        const auto includes = allIncludes();
        QVERIFY(includes.size() > 50);
        std::string problems;
        for (const Include &i : includes) {
            if (const std::string problem = problemWith(i); !problem.empty())
                problems.append("\n")
                    .append(i.file.generic_string())
                    .append(" includes ")
                    .append(i.header)
                    .append(": ")
                    .append(problem);
        }
        QVERIFY2(problems.empty(), problems.c_str());
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
        row("model/scene.cpp", "solver/linear/linearsolver.h", true);
        row("commands/setseams.cpp", "solver/linear/linearsolver.h", true);
        row("solver/newton.cpp", "model/scene.h", true);
        row("model/meshdata.h", "model/scene.h", true);
        row("views/panels/seampanel.cpp", "solver/linear/linearsolver.h", true);
        row("model/scene.h", "scene.h", true);
        row("solver/newton.h", "QString", false);
        row("solver/newton.h", "QtCore/QString", false);
        row("model/types.h", "QVector", false);
        row("model/scene.h", "QWidget", false);
        row("model/scene.cpp", "assimp/scene.h", false);
        row("model/scene.cpp", "OpenMesh/Core/IO/MeshIO.hh", false);
        row("solver/multires/progressivemesh.cpp", "OpenMesh/Core/Mesh/Traits.hh", false);
        row("solver/newton.cpp", "cholmod.h", false);
    }

    void breachesAreFound()
    {
        QFETCH(QString, file);
        QFETCH(QString, header);
        QFETCH(bool, own);
        QVERIFY(!problemWith({file.toStdString(), header.toStdString(), own}).empty());
    }
};

QTEST_APPLESS_MAIN(TestLayering)
#include "tst_layering.moc"
