#include "model/io/fbx/fbxeditor.h"

#include "model/io/fbx/fbxbytes.h"

#include <algorithm>

namespace autocuts {

namespace {

// The footer of a binary file: an id, zeros, four bytes, then the version, which is aligned, and the rest.
constexpr qint64 footerId = 16;
constexpr qint64 footerExtra = 4;
constexpr qint64 footerAlignment = 16;

FbxStyle styleOf(const FbxTree &tree)
{
    const qsizetype line = tree.bytes.indexOf('\n');
    const bool isDos = line > 0 && tree.bytes[line - 1] == '\r';
    return {tree.binary, tree.bigEndian, tree.wide, tree.version, isDos ? "\r\n" : "\n"};
}

//! The end offset in the head of a node. Some files say 0 for nodes without a list.
std::uint64_t statedEnd(const FbxTree &tree, const FbxNode &node)
{
    const char *head = tree.bytes.constData() + node.begin;
    return tree.wide ? fbxNumber<std::uint64_t>(head, tree.bigEndian)
                     : fbxNumber<std::uint32_t>(head, tree.bigEndian);
}

bool isSpace(char c)
{
    return c == ' ' || c == '\t';
}

} // namespace

FbxEditor::FbxEditor(const FbxTree &tree) : mTree(tree), mStyle(styleOf(tree)) {}

//! The white space between the start of a line and the position.
QByteArray FbxEditor::indentOf(qint64 position) const
{
    if (mStyle.binary)
        return {};
    const qint64 lineBegin = position > 0 ? mTree.bytes.lastIndexOf('\n', position - 1) + 1 : 0;
    qint64 end = lineBegin;
    while (end < position && isSpace(mTree.bytes[end]))
        ++end;
    return mTree.bytes.sliced(lineBegin, end - lineBegin);
}

void FbxEditor::replace(int node, FbxNewNode by)
{
    const FbxNode &n = mTree.nodes[static_cast<std::size_t>(node)];
    mEdits.push_back({n.begin, n.end, std::move(by), {}, indentOf(n.begin), {}});
}

//! In text the whole line goes, when nothing else is in it.
void FbxEditor::remove(int node)
{
    const FbxNode &n = mTree.nodes[static_cast<std::size_t>(node)];
    Edit edit{n.begin, n.end, {}, {}, {}, {}};
    if (!mStyle.binary) {
        const QByteArray &bytes = mTree.bytes;
        const qint64 indent = indentOf(n.begin).size();
        const bool startsLine = n.begin == indent || bytes[n.begin - indent - 1] == '\n';
        qint64 end = n.end;
        while (end < bytes.size() && (isSpace(bytes[end]) || bytes[end] == '\r'))
            ++end;
        if (startsLine && end < bytes.size() && bytes[end] == '\n') {
            edit.begin -= indent;
            edit.end = end + 1;
        }
    }
    mEdits.push_back(std::move(edit));
}

//! Inserts behind a node.
FbxEditor::Edit FbxEditor::behind(int sibling) const
{
    const FbxNode &n = mTree.nodes[static_cast<std::size_t>(sibling)];
    const QByteArray indent = indentOf(n.begin);
    // Spaces at the end of a line stay there.
    qint64 end = n.end;
    while (!mStyle.binary && end < mTree.bytes.size() && isSpace(mTree.bytes[end]))
        ++end;
    const bool endsLine = end < mTree.bytes.size() && (mTree.bytes[end] == '\r' || mTree.bytes[end] == '\n');
    const qint64 position = !mStyle.binary && endsLine ? end : n.end;
    return {position, position, {}, mStyle.lineEnd + indent, indent, {}};
}

void FbxEditor::insertAfter(int sibling, FbxNewNode node)
{
    Edit edit = behind(sibling);
    edit.node = std::move(node);
    mEdits.push_back(std::move(edit));
}

void FbxEditor::addCopy(int node, std::int64_t number)
{
    Edit edit = behind(node);
    edit.copied = node;
    edit.number = number;
    mEdits.push_back(std::move(edit));
}

void FbxEditor::append(int parent, FbxNewNode node)
{
    const FbxNode &n = mTree.nodes[static_cast<std::size_t>(parent)];
    if (n.lastChild >= 0) {
        insertAfter(n.lastChild, std::move(node));
        return;
    }
    const QByteArray outer = indentOf(n.begin);
    mEdits.push_back({n.listEnd, n.listEnd, std::move(node), mStyle.lineEnd + outer + '\t', outer + '\t',
                      mStyle.lineEnd + outer});
}

//! The bytes of an integer, with another value.
QByteArray FbxEditor::withInteger(const FbxValue &old, std::int64_t value) const
{
    if (!mStyle.binary)
        return QByteArray::number(static_cast<qlonglong>(value));
    QByteArray bytes = mTree.bytes.sliced(old.begin, old.end - old.begin);
    char *data = bytes.data() + 1;
    if (old.type == 'I')
        putFbxNumber(data, static_cast<std::int32_t>(value), mStyle.bigEndian);
    else if (old.type == 'L')
        putFbxNumber(data, value, mStyle.bigEndian);
    return bytes;
}

void FbxEditor::setInteger(int node, std::int64_t value, std::size_t index)
{
    const std::vector<FbxValue> values = mTree.values(node, index + 1);
    if (values.size() <= index || values[index].kind != FbxValue::Kind::Integer)
        return;
    mEdits.push_back({values[index].begin, values[index].end, {}, withInteger(values[index], value), {}, {}});
}

QByteArray FbxEditor::copyOf(const Edit &edit, qint64 position) const
{
    const FbxNode &node = mTree.nodes[static_cast<std::size_t>(edit.copied)];
    QByteArray bytes = mTree.bytes.sliced(node.begin, node.end - node.begin);
    const FbxValue number = mTree.values(edit.copied, 1).at(0);
    bytes.replace(number.begin - node.begin, number.end - number.begin, withInteger(number, edit.number));
    if (!mStyle.binary)
        return edit.before + bytes;
    // The nodes inside follow their parent, and end before the next one that is not inside.
    for (auto i = static_cast<std::size_t>(edit.copied);
         i < mTree.nodes.size() && mTree.nodes[i].begin < node.end; ++i) {
        if (statedEnd(mTree, mTree.nodes[i]) == 0)
            continue;
        char *head = bytes.data() + (mTree.nodes[i].begin - node.begin);
        const qint64 end = position + mTree.nodes[i].end - node.begin;
        if (mStyle.wide)
            putFbxNumber(head, static_cast<std::uint64_t>(end), mStyle.bigEndian);
        else
            putFbxNumber(head, static_cast<std::uint32_t>(end), mStyle.bigEndian);
    }
    return bytes;
}

QByteArray FbxEditor::bytesOf(const Edit &edit, qint64 position) const
{
    if (edit.copied >= 0)
        return copyOf(edit, position);
    if (!edit.node)
        return edit.before;
    const QByteArray node = fbxNodeBytes(*edit.node, mStyle, position, edit.indent);
    return mStyle.binary ? node : edit.before + node + edit.after;
}

//! \param shifts by how much the bytes behind each edit move
QByteArray FbxEditor::spliced(std::vector<Edit> &edits, std::vector<qint64> &shifts) const
{
    std::stable_sort(edits.begin(), edits.end(),
                     [](const Edit &a, const Edit &b) { return a.begin < b.begin; });
    QByteArray out;
    out.reserve(mTree.bytes.size());
    qint64 copied = 0;
    for (const Edit &edit : edits) {
        const qint64 begin = std::max(edit.begin, copied);
        out.append(QByteArrayView(mTree.bytes).sliced(copied, begin - copied));
        out.append(bytesOf(edit, out.size()));
        copied = std::max(edit.end, begin);
        shifts.push_back(out.size() - copied);
    }
    return out.append(QByteArrayView(mTree.bytes).sliced(copied));
}

//! Sets the end offsets of all nodes that were not replaced.
void FbxEditor::moveEnds(QByteArray &out, const std::vector<Edit> &edits,
                         const std::vector<qint64> &shifts) const
{
    for (std::size_t i = 1; i < mTree.nodes.size(); ++i) {
        const FbxNode &node = mTree.nodes[i];
        // Edits before `after` begin before the end of the node, those before `here` at its begin or before.
        const auto after =
            std::lower_bound(edits.begin(), edits.end(), node.end,
                             [](const Edit &edit, qint64 position) { return edit.begin < position; });
        if (after == edits.begin())
            continue;
        const auto here =
            std::upper_bound(edits.begin(), edits.end(), node.begin,
                             [](qint64 position, const Edit &edit) { return position < edit.begin; });
        if (statedEnd(mTree, node) == 0 || (here != edits.begin() && std::prev(here)->end > node.begin))
            continue;
        const qint64 begin =
            here == edits.begin() ? node.begin : node.begin + shifts[here - edits.begin() - 1];
        const qint64 end = node.end + shifts[after - edits.begin() - 1];
        if (mStyle.wide)
            putFbxNumber(out.data() + begin, static_cast<std::uint64_t>(end), mStyle.bigEndian);
        else
            putFbxNumber(out.data() + begin, static_cast<std::uint32_t>(end), mStyle.bigEndian);
    }
}

//! Keeps the version in the footer aligned, where the footer has the usual form.
void FbxEditor::alignFooter(QByteArray &out, qint64 footer) const
{
    const auto versionAt = [&](qint64 position) {
        return position + 4 <= mTree.bytes.size() &&
               fbxNumber<std::uint32_t>(mTree.bytes.constData() + position, mStyle.bigEndian) ==
                   static_cast<std::uint32_t>(mTree.version);
    };
    const qint64 begin = mTree.footer + footerId;
    qint64 zeros = 1;
    while (zeros <= footerAlignment && !versionAt(begin + zeros + footerExtra))
        ++zeros;
    if (zeros > footerAlignment ||
        mTree.bytes.sliced(begin, zeros + footerExtra) != QByteArray(zeros + footerExtra, '\0'))
        return;
    const qint64 shift = (footer - mTree.footer) % footerAlignment;
    qint64 wanted = (zeros - shift + 2 * footerAlignment) % footerAlignment;
    if (wanted == 0)
        wanted = footerAlignment;
    out.replace(footer + footerId, zeros, QByteArray(wanted, '\0'));
}

QByteArray FbxEditor::result() const
{
    if (mEdits.empty())
        return mTree.bytes;
    std::vector<Edit> edits = mEdits;
    std::vector<qint64> shifts;
    QByteArray out = spliced(edits, shifts);
    if (mStyle.binary) {
        moveEnds(out, edits, shifts);
        alignFooter(out, mTree.footer + shifts.back());
    }
    return out;
}

} // namespace autocuts
