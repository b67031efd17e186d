#include "model/io/fbx/fbxuniquemeshes.h"

#include "model/io/fbx/fbxeditor.h"
#include "model/io/fbx/fbxparsing.h"

#include <map>
#include <set>

namespace autocuts {

namespace {

//! Bytes; offsets in most binary files have 32 bits, and readers stop at half of that.
constexpr qint64 maxSize = qint64(2) << 30;

//! The numbers of a connection: what is connected, and to what. Nothing for other connections.
struct Link
{
    std::int64_t child = 0, parent = 0;
};

std::optional<Link> linkOf(const std::vector<FbxValue> &values)
{
    const auto isNumber = [](const FbxValue &value) { return value.kind == FbxValue::Kind::Integer; };
    if (values.size() < 3 || values[0].text != "OO" || !isNumber(values[1]) || !isNumber(values[2]))
        return {};
    return Link{values[1].integer, values[2].integer};
}

class GeometryCopier
{
public:
    GeometryCopier(const FbxTree &tree, const FbxSource &source);

    Result<QByteArray> run(const QString &path);

private:
    std::vector<int> childrenOf(int parent) const;
    void copyFor(int connection, std::int64_t geometry);
    void shareDeformers();
    void count();

    const FbxTree &mTree;
    FbxEditor mEditor;
    std::map<std::int64_t, int> mShared; //!< nodes of geometries by their numbers
    std::set<std::int64_t> mNumbers, mModels, mUsed;
    std::int64_t mNext = 1000000000;
    std::map<std::int64_t, std::vector<std::int64_t>> mCopies; //!< their numbers
    qint64 mSize;
    int mCount = 0;
};

GeometryCopier::GeometryCopier(const FbxTree &tree, const FbxSource &source)
    : mTree(tree), mEditor(tree), mSize(tree.bytes.size())
{
    for (const int object : childrenOf(mTree.child(0, "Objects"))) {
        const std::int64_t number = mTree.integer(object).value_or(0);
        mNumbers.insert(number);
        if (mTree.name(object) == "Model")
            mModels.insert(number);
    }
    for (const FbxUse &use : source.uses) {
        if (use.instances.size() > 1)
            mShared.emplace(mTree.integer(use.node).value_or(0), use.node);
    }
}

std::vector<int> GeometryCopier::childrenOf(int parent) const
{
    std::vector<int> children;
    for (int c = parent < 0 ? -1 : mTree.nodes[static_cast<std::size_t>(parent)].firstChild; c >= 0;
         c = mTree.nodes[static_cast<std::size_t>(c)].next)
        children.push_back(c);
    return children;
}

void GeometryCopier::copyFor(int connection, std::int64_t geometry)
{
    while (!mNumbers.insert(mNext).second)
        ++mNext;
    const int node = mShared.at(geometry);
    mEditor.addCopy(node, mNext);
    mEditor.setInteger(connection, mNext, 1);
    mCopies[geometry].push_back(mNext);
    mSize +=
        mTree.nodes[static_cast<std::size_t>(node)].end - mTree.nodes[static_cast<std::size_t>(node)].begin;
    ++mCount;
}

//! Connects skins and shape keys of a geometry to its copies as well.
void GeometryCopier::shareDeformers()
{
    const int connections = mTree.child(0, "Connections");
    for (const int connection : childrenOf(connections)) {
        const std::optional<Link> link = linkOf(mTree.values(connection, 4));
        const auto copies = link ? mCopies.find(link->parent) : mCopies.end();
        if (copies == mCopies.end())
            continue;
        for (const std::int64_t copy : copies->second)
            mEditor.append(connections, {"C", {QByteArray("OO"), link->child, copy}, {}, false});
    }
}

//! The file says how many objects it has.
void GeometryCopier::count()
{
    const int definitions = mTree.child(0, "Definitions");
    const auto add = [this](int parent) {
        const int count = parent < 0 ? -1 : mTree.child(parent, "Count");
        if (const auto old = count < 0 ? std::nullopt : mTree.integer(count))
            mEditor.setInteger(count, *old + mCount);
    };
    add(definitions);
    for (const int type : childrenOf(definitions)) {
        if (mTree.name(type) == "ObjectType" && mTree.text(type) == "Geometry")
            add(type);
    }
}

Result<QByteArray> GeometryCopier::run(const QString &path)
{
    for (const int connection : childrenOf(mTree.child(0, "Connections"))) {
        const std::optional<Link> link = linkOf(mTree.values(connection, 4));
        if (link && mShared.contains(link->child) && mModels.contains(link->parent) &&
            !mUsed.insert(link->child).second)
            copyFor(connection, link->child);
    }
    if (mSize > maxSize)
        return Error{QStringLiteral("with a mesh for each object the file would have more than 2 GB"), path,
                     0, QStringLiteral("Undo \"Make meshes unique\", or split the model into several files")};
    shareDeformers();
    count();
    return mEditor.result();
}

} // namespace

bool hasCopyableGeometries(const FbxSource &source)
{
    constexpr int firstWithNumbers = 7000;
    return source.version >= firstWithNumbers;
}

Result<QByteArray> withUniqueGeometries(const FbxSource &source, const QString &path)
{
    const Result<FbxTree> tree = parseFbxTree(source.bytes, path);
    if (!tree)
        return tree.error();
    return GeometryCopier(tree.value(), source).run(path);
}

} // namespace autocuts
