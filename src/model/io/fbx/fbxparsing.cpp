#include "model/io/fbx/fbxparsing.h"

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The file may have at most this many nodes. Chosen by hand: far more than models have.
constexpr std::size_t maxNodes = 8'000'000;

// Versions, as in the header of the file.
constexpr int oldestVersion = 6100;
constexpr int newestVersion = 7999;

//! The version that a text file states; 0 when it states none.
int textVersion(const FbxTree &tree)
{
    constexpr std::string_view path[] = {"FBXHeaderExtension", "FBXVersion"};
    const std::int64_t version = tree.integer(tree.find(path)).value_or(0);
    return version > 0 && version < 1'000'000 ? static_cast<int>(version) : 0;
}

std::optional<Error> versionProblem(int version, const QString &path)
{
    const QString number = u"%1.%2"_s.arg(version / 1000).arg(version / 100 % 10);
    if (version < oldestVersion)
        return Error{version > 0 ? u"FBX files of version %1 are too old, 6.1 is the oldest"_s.arg(number)
                                 : u"the file does not say its FBX version"_s,
                     path, 0, u"Export the model again as FBX 2011 or later, or as OBJ"_s};
    if (version > newestVersion)
        return Error{u"FBX files of version %1 are newer than what can be read"_s.arg(number), path, 0,
                     u"Export the model again as FBX 2020, or as OBJ"_s};
    return {};
}

} // namespace

Result<FbxTree> parseFbxTree(QByteArray bytes, const QString &path, const std::atomic<bool> *stop)
{
    if (bytes.isEmpty())
        return Error{u"the file is empty"_s, path, 0, u"Export the model again"_s};
    FbxTree tree;
    tree.bytes = std::move(bytes);
    tree.fillRoom();
    tree.nodes.emplace_back();
    tree.binary = hasFbxMagic(tree.bytes);
    if (tree.binary) {
        if (!readFbxHeader(tree))
            return Error{u"the file ends in its header"_s, path, 0, u"Copy or export it again"_s};
        if (const std::optional<Error> problem = versionProblem(tree.version, path))
            return *problem;
    }
    if (const std::optional<Error> error =
            tree.binary ? parseBinaryFbx(tree, path, stop) : parseTextFbx(tree, path, stop))
        return *error;
    if (!tree.binary) {
        tree.version = textVersion(tree);
        if (const std::optional<Error> problem = versionProblem(tree.version, path))
            return *problem;
    }
    return tree;
}

std::optional<int> addFbxNode(FbxTree &tree, int parent)
{
    if (tree.nodes.size() >= maxNodes)
        return {};
    const int added = static_cast<int>(tree.nodes.size());
    FbxNode &node = tree.nodes.emplace_back();
    node.parent = parent;
    FbxNode &above = tree.nodes[static_cast<std::size_t>(parent)];
    if (above.lastChild >= 0)
        tree.nodes[static_cast<std::size_t>(above.lastChild)].next = added;
    else
        above.firstChild = added;
    above.lastChild = added;
    return added;
}

} // namespace autocuts
