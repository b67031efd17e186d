// Text FBX: "Name: value, value { nodes }".
#include "model/io/fbx/fbxparsing.h"
#include "model/io/files/savefile.h"

#include <algorithm>
#include <limits>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

class TextParser
{
public:
    TextParser(FbxTree &tree, const QString &path, const std::atomic<bool> *stop)
        : mTree(tree), mPath(path), mStop(stop), mData(tree.bytes.constData()), mEnd(tree.bytes.size())
    {}

    std::optional<Error> parse();

private:
    FbxNode &node(int index) const { return mTree.nodes[static_cast<std::size_t>(index)]; }
    bool skipBlank();
    qint64 wordEnd(qint64 position) const;
    bool isKey(qint64 position) const;
    bool closeList();
    bool readKey();
    bool readValues(int added);
    bool readString();
    bool cancelled() const { return mStop && *mStop; }
    bool fail(const QString &message)
    {
        mError = Error{message, mPath, mLine, u"It is damaged or cut off: copy or export it again"_s};
        return false;
    }

    FbxTree &mTree;
    const QString &mPath;
    const std::atomic<bool> *mStop;
    const char *mData;
    qint64 mEnd, mPosition = 0;
    int mLine = 1;
    int mOpen = 0, mDepth = 0;
    std::optional<Error> mError;
};

//! Skips white space and comments. False at the end of the file.
bool TextParser::skipBlank()
{
    while (mPosition < mEnd) {
        const char c = mData[mPosition];
        if (c == ';') {
            while (mPosition < mEnd && mData[mPosition] != '\n')
                ++mPosition;
            continue;
        }
        if (c != ' ' && c != '\t' && c != '\r' && c != '\n')
            return true;
        mLine += c == '\n';
        ++mPosition;
    }
    return false;
}

qint64 TextParser::wordEnd(qint64 position) const
{
    constexpr std::string_view separators(" \t\r\n,:;{}\"");
    while (position < mEnd && separators.find(mData[position]) == std::string_view::npos)
        ++position;
    return position;
}

//! True when the word at the position is the name of a node.
bool TextParser::isKey(qint64 position) const
{
    qint64 end = wordEnd(position);
    while (end < mEnd && (mData[end] == ' ' || mData[end] == '\t'))
        ++end;
    return end > position && end < mEnd && mData[end] == ':';
}

bool TextParser::closeList()
{
    if (mOpen == 0)
        return fail(u"there is a closing brace too many"_s);
    node(mOpen).listEnd = mPosition;
    node(mOpen).end = ++mPosition;
    mOpen = node(mOpen).parent;
    --mDepth;
    return true;
}

bool TextParser::readString()
{
    const qint64 close = mTree.bytes.indexOf('"', mPosition + 1);
    if (close < 0)
        return fail(u"a quotation mark has no partner"_s);
    mLine += static_cast<int>(std::count(mData + mPosition, mData + close, '\n'));
    mPosition = close + 1;
    return true;
}

//! Reads the values behind a name, and the brace that opens a list. Values are separated by commas, at which
//! a line may end.
bool TextParser::readValues(int added)
{
    bool wantsValue = true; // at the start and after a comma
    bool first = true;
    node(added).valuesBegin = node(added).valuesEnd = mPosition;
    for (unsigned turn = 1; skipBlank(); ++turn) {
        if (turn % 65536 == 0 && cancelled())
            return fail({});
        const char c = mData[mPosition];
        if (c == '{') {
            ++mPosition;
            mOpen = added;
            return ++mDepth < maxFbxDepth || fail(u"nodes are nested too deeply"_s);
        }
        if (c == ',') {
            ++mPosition;
            wantsValue = true;
            first = false;
            continue;
        }
        const bool ends = c == '}' || (first && c != '"' && isKey(mPosition));
        if (ends && !first && wantsValue)
            return fail(u"a comma has no value behind it"_s);
        if (ends || !wantsValue)
            break;
        if (c == '"') {
            if (!readString())
                return false;
        } else {
            const qint64 end = wordEnd(mPosition);
            if (end == mPosition)
                return fail(u"a value is expected"_s);
            mPosition = end;
        }
        node(added).valuesEnd = node(added).end = mPosition;
        wantsValue = first = false;
    }
    return true;
}

bool TextParser::readKey()
{
    if (!isKey(mPosition))
        return fail(u"a name with a colon is expected"_s);
    const qint64 end = wordEnd(mPosition);
    const std::optional<int> added = addFbxNode(mTree, mOpen);
    if (!added || end - mPosition > std::numeric_limits<std::uint8_t>::max())
        return fail(added ? u"a name is too long"_s : u"the file has too many nodes"_s);
    FbxNode &n = node(*added);
    n.begin = mPosition;
    n.nameLength = static_cast<int>(end - mPosition);
    n.line = mLine;
    mPosition = end;
    while (mData[mPosition] != ':')
        ++mPosition;
    n.end = ++mPosition;
    return readValues(*added);
}

std::optional<Error> TextParser::parse()
{
    if (mTree.bytes.startsWith("\xEF\xBB\xBF"))
        mPosition = 3;
    if (mTree.bytes.contains('\0'))
        return Error{u"the file is neither a binary nor a text FBX file"_s, mPath, 0,
                     u"It is damaged, or of another format: export the model again"_s};
    for (unsigned turn = 0; skipBlank(); ++turn) {
        const bool good = mData[mPosition] == '}' ? closeList() : readKey();
        if ((turn % 1024 == 0 || !good) && cancelled())
            return readingCancelled(mPath);
        if (!good)
            return mError;
    }
    if (mOpen != 0) {
        fail(u"the file ends within the braces of \"%1\""_s.arg(
            QString::fromUtf8(mTree.name(mOpen).data(), std::ssize(mTree.name(mOpen)))));
        return mError;
    }
    node(0).listEnd = mTree.footer = mEnd;
    return {};
}

} // namespace

std::optional<Error> parseTextFbx(FbxTree &tree, const QString &path, const std::atomic<bool> *stop)
{
    return TextParser(tree, path, stop).parse();
}

} // namespace autocuts
