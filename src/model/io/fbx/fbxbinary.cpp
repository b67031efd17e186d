// Binary FBX: nodes with absolute end offsets.
#include "model/io/fbx/fbxbytes.h"
#include "model/io/fbx/fbxparsing.h"
#include "model/io/files/savefile.h"

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Magic, a byte 0x1A, the byte order, and the version.
constexpr std::string_view magic("Kaydara FBX Binary  \0", 21);
constexpr qint64 headerSize = 27;

//! The numbers at the head of a node.
struct NodeHead
{
    std::uint64_t end = 0, valueCount = 0, valueBytes = 0;
    std::uint8_t nameLength = 0;

    bool isNull() const { return end == 0 && valueCount == 0 && valueBytes == 0 && nameLength == 0; }
};

class BinaryParser
{
public:
    BinaryParser(FbxTree &tree, const QString &path, const std::atomic<bool> *stop)
        : mTree(tree), mPath(path), mStop(stop), mHeadSize(tree.wide ? 25 : 13)
    {}

    std::optional<Error> parse();

private:
    NodeHead headAt(qint64 position) const;
    qint64 limit() const { return mOpen == 0 ? mTree.bytes.size() : node(mOpen).end; }
    FbxNode &node(int index) const { return mTree.nodes[static_cast<std::size_t>(index)]; }
    bool readNode();
    bool closeList();
    bool open(const NodeHead &head);
    bool checkValues(const FbxNode &added, std::uint64_t count);
    bool fail(const QString &message)
    {
        mError = Error{message, mPath, 0, u"It is damaged or cut off: copy or export it again"_s};
        return false;
    }

    FbxTree &mTree;
    const QString &mPath;
    const std::atomic<bool> *mStop;
    qint64 mHeadSize;
    qint64 mPosition = headerSize;
    int mOpen = 0; //!< the node whose list is being read
    int mDepth = 0;
    bool mDone = false;
    std::optional<Error> mError;
};

NodeHead BinaryParser::headAt(qint64 position) const
{
    const char *data = mTree.bytes.constData() + position;
    const bool big = mTree.bigEndian;
    NodeHead head;
    if (mTree.wide)
        head = {fbxNumber<std::uint64_t>(data, big), fbxNumber<std::uint64_t>(data + 8, big),
                fbxNumber<std::uint64_t>(data + 16, big), 0};
    else
        head = {fbxNumber<std::uint32_t>(data, big), fbxNumber<std::uint32_t>(data + 4, big),
                fbxNumber<std::uint32_t>(data + 8, big), 0};
    head.nameLength = static_cast<std::uint8_t>(data[mHeadSize - 1]);
    return head;
}

//! At a null record.
bool BinaryParser::closeList()
{
    node(mOpen).listEnd = mPosition;
    mPosition += mHeadSize;
    if (mOpen == 0) {
        mTree.footer = mPosition;
        mDone = true;
        return true;
    }
    if (mPosition != node(mOpen).end)
        return fail(u"the list of a node ends in the wrong place"_s);
    mOpen = node(mOpen).parent;
    --mDepth;
    return true;
}

bool BinaryParser::checkValues(const FbxNode &added, std::uint64_t count)
{
    qint64 position = added.valuesBegin;
    for (std::uint64_t i = 0; i < count; ++i) {
        if (mStop && i % 65536 == 65535 && *mStop)
            return fail({});
        const qint64 size = fbxValueSize(mTree, position, added.valuesEnd);
        if (size <= 0)
            return fail(u"a value of a node is damaged"_s);
        position += size;
    }
    return position == added.valuesEnd || fail(u"the values of a node have the wrong size"_s);
}

bool BinaryParser::open(const NodeHead &head)
{
    const qint64 begin = mPosition;
    const qint64 nameEnd = begin + mHeadSize + head.nameLength;
    const auto most = static_cast<std::uint64_t>(limit());
    // Some files state no end for nodes without a list.
    const std::uint64_t end = head.end > 0 ? head.end : most;
    if (end > most || end < static_cast<std::uint64_t>(nameEnd) ||
        head.valueBytes > end - static_cast<std::uint64_t>(nameEnd))
        return fail(u"a node reaches beyond its place"_s);
    const std::optional<int> added = addFbxNode(mTree, mOpen);
    if (!added)
        return fail(u"the file has too many nodes"_s);
    FbxNode &n = node(*added);
    n.begin = begin;
    n.nameBegin = static_cast<int>(mHeadSize);
    n.nameLength = head.nameLength;
    n.valuesBegin = nameEnd;
    n.valuesEnd = nameEnd + static_cast<qint64>(head.valueBytes);
    n.end = head.end > 0 ? static_cast<qint64>(head.end) : n.valuesEnd;
    if (!checkValues(n, head.valueCount))
        return false;
    mPosition = n.valuesEnd;
    if (n.valuesEnd == n.end)
        return true;
    mOpen = *added;
    return ++mDepth < maxFbxDepth || fail(u"nodes are nested too deeply"_s);
}

bool BinaryParser::readNode()
{
    if (limit() - mPosition < mHeadSize) {
        // Some programs leave out the null record and the footer.
        if (mOpen == 0 && mPosition == mTree.bytes.size()) {
            node(0).listEnd = mTree.footer = mPosition;
            mDone = true;
            return true;
        }
        return fail(mOpen == 0 ? u"the file ends within a node"_s : u"a node ends within its list"_s);
    }
    const NodeHead head = headAt(mPosition);
    return head.isNull() ? closeList() : open(head);
}

std::optional<Error> BinaryParser::parse()
{
    for (unsigned turn = 0; !mDone; ++turn) {
        if (!readNode() && !(mStop && *mStop))
            return mError;
        if (mStop && (turn % 1024 == 0 || mError) && *mStop)
            return readingCancelled(mPath);
    }
    return {};
}

} // namespace

bool hasFbxMagic(const QByteArray &bytes)
{
    return bytes.startsWith(QByteArrayView(magic.data(), std::ssize(magic)));
}

bool readFbxHeader(FbxTree &tree)
{
    if (tree.bytes.size() < headerSize)
        return false;
    tree.bigEndian = tree.bytes[22] == 1;
    const auto version = fbxNumber<std::uint32_t>(tree.bytes.constData() + 23, tree.bigEndian);
    tree.version = static_cast<int>(std::min<std::uint32_t>(version, 1'000'000));
    tree.wide = tree.version >= 7500;
    return true;
}

std::optional<Error> parseBinaryFbx(FbxTree &tree, const QString &path, const std::atomic<bool> *stop)
{
    return BinaryParser(tree, path, stop).parse();
}

} // namespace autocuts
