#include "model/io/obj/objrewriter.h"

#include "model/io/formats/uvcorners.h"
#include "model/io/obj/objscanner.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <numeric>
#include <tuple>

namespace autocuts {

namespace {

std::string_view view(const QByteArray &bytes)
{
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

void append(QByteArray &out, std::string_view text)
{
    out.append(text.data(), static_cast<qsizetype>(text.size()));
}

template <typename Number>
void appendNumber(QByteArray &out, Number value)
{
    char text[40];
    const auto result = std::to_chars(text, text + sizeof text, value);
    out.append(text, result.ptr - text);
}

//! The old vt lines that have to stay, because statements other than faces refer to them.
struct KeptLines
{
    std::int64_t count = 0;    //!< so many vt lines stay, counted from the first
    const char *end = nullptr; //!< new vt lines may only be added after this place in the source
};

KeptLines findKeptLines(std::string_view bytes, std::int64_t total)
{
    KeptLines kept;
    std::int64_t seen = 0;
    const char *lastRelative = nullptr;
    std::vector<const char *> lineEnds;
    ObjScanner scanner(bytes);
    while (scanner.next()) {
        const char *end = scanner.line().data() + scanner.line().size();
        if (scanner.statement() == ObjStatement::TextureVertex) {
            ++seen;
            lineEnds.push_back(end);
        }
        if (scanner.statement() != ObjStatement::Element)
            continue;
        std::string_view rest = scanner.arguments();
        std::string_view word;
        while (nextWord(rest, word)) {
            const std::string_view reference = ObjCornerWord(word).textureVertex;
            std::int64_t index = 0;
            if (reference.empty() || !parseIndex(reference, seen, index))
                continue;
            // A relative index counts back from this line, so all vt lines before it have to stay.
            const bool relative = reference.front() == '-';
            kept.count = std::max(kept.count, std::min(total, relative ? seen : index + 1));
            if (relative)
                lastRelative = end;
        }
    }
    if (kept.count > 0)
        kept.end = lineEnds[static_cast<std::size_t>(kept.count - 1)];
    if (lastRelative && std::less<>()(kept.end, lastRelative))
        kept.end = lastRelative;
    return kept;
}

class ObjRewriter
{
public:
    ObjRewriter(const ObjSource &source, const MeshData &mesh, const UvMatrix &uv)
        : mSource(source), mMesh(mesh), mUv(uv), mShared(sharedUvCorners(mesh, uv)), mIndex(mShared.size(), 0)
    {}

    QByteArray run();

private:
    //! A place in the file where new vt lines may be added.
    struct Slot
    {
        qsizetype body = 0; //!< offset in mBody
        qsizetype text = 0; //!< offset in mText of its first line
    };

    //! The first slot also takes the vt lines of faces before it, which then refer to later lines.
    void openSlot() { mSlots.push_back({mBody.size(), mSlots.empty() ? 0 : mText.size()}); }
    void face(const ObjScanner &scanner);
    std::int64_t indexOf(int corner, std::string_view lineEnd);
    QByteArray splice(std::string_view lineEnd) const;

    const ObjSource &mSource;
    const MeshData &mMesh;
    const UvMatrix &mUv;
    std::vector<int> mShared;
    std::vector<int> mIndex; //!< 1-based vt number by first corner; 0: not written yet
    KeptLines mKept;
    std::int64_t mNext = 1;  //!< number of the next new vt line
    QByteArray mBody, mText; //!< the file without new vt lines, and the new vt lines
    std::vector<Slot> mSlots;
    bool mInSlot = false; //!< only vt lines were seen since the last slot was opened
    int mFaceLine = 0, mFace = 0;
    std::size_t mSkipped = 0;
};

std::int64_t ObjRewriter::indexOf(int corner, std::string_view lineEnd)
{
    const int first = mShared[corner];
    if (first < 0)
        return 0;
    if (mIndex[first] == 0) {
        mIndex[first] = static_cast<int>(mNext++);
        appendTextureVertex(mText, mUv(first, 0), mUv(first, 1));
        append(mText, lineEnd);
    }
    return mIndex[first];
}

void ObjRewriter::face(const ObjScanner &scanner)
{
    const bool skipped =
        mSkipped < mSource.skippedFaces.size() && mSource.skippedFaces[mSkipped] == mFaceLine;
    ++mFaceLine;
    mSkipped += skipped;
    int corner = skipped ? -1 : mMesh.faceStart[mFace++];
    const char *copied = scanner.line().data();
    std::string_view rest = scanner.arguments();
    std::string_view word;
    while (nextWord(rest, word)) {
        append(mBody, {copied, static_cast<std::size_t>(word.data() - copied)});
        copied = word.data() + word.size();
        const ObjCornerWord parts(word);
        const std::int64_t index = skipped ? 0 : indexOf(corner++, scanner.lineEnd());
        append(mBody, parts.vertex);
        if (index > 0) {
            mBody.append('/');
            appendNumber(mBody, index);
        }
        if (!parts.normal.empty()) {
            append(mBody, index > 0 ? "/" : "//");
            append(mBody, parts.normal);
        }
    }
    const char *end = scanner.line().data() + scanner.line().size();
    append(mBody, {copied, static_cast<std::size_t>(end - copied)});
}

QByteArray ObjRewriter::splice(std::string_view lineEnd) const
{
    QByteArray out;
    out.reserve(mBody.size() + mText.size() + 2);
    qsizetype body = 0;
    for (std::size_t s = 0; s < mSlots.size(); ++s) {
        const qsizetype textEnd = s + 1 < mSlots.size() ? mSlots[s + 1].text : mText.size();
        append(out, view(mBody).substr(body, mSlots[s].body - body));
        body = mSlots[s].body;
        if (textEnd > mSlots[s].text && !out.isEmpty() && out.back() != '\n' && out.back() != '\r' &&
            body > 3) // not after a byte order mark
            append(out, lineEnd);
        append(out, view(mText).substr(mSlots[s].text, textEnd - mSlots[s].text));
    }
    append(out, view(mBody).substr(body));
    return out;
}

QByteArray ObjRewriter::run()
{
    const std::string_view bytes = view(mSource.bytes);
    mKept = findKeptLines(bytes, static_cast<std::int64_t>(mSource.textureVertices.size() / 2));
    mNext = mKept.count + 1;
    mBody.reserve(mSource.bytes.size() + mSource.bytes.size() / 4);
    ObjScanner scanner(bytes);
    bool first = true;
    while (scanner.next()) {
        const std::string_view line = scanner.line();
        if (first)
            append(mBody, bytes.substr(0, line.data() - bytes.data())); // a byte order mark
        first = false;
        // True after all vt lines that must keep their numbers.
        const bool open = !std::less<>()(line.data(), mKept.end);
        if (scanner.statement() == ObjStatement::TextureVertex && open) {
            if (!mInSlot)
                openSlot();
            mInSlot = true;
            continue;
        }
        if (scanner.statement() == ObjStatement::Face) {
            if (open && mSlots.empty())
                openSlot();
            face(scanner);
        } else {
            append(mBody, line);
        }
        mInSlot = false;
        if (mKept.end == line.data() + line.size())
            openSlot();
    }
    return splice(scanner.lineEnd());
}

} // namespace

void appendTextureVertex(QByteArray &out, double u, double v)
{
    out.append("vt ");
    appendNumber(out, u);
    out.append(' ');
    appendNumber(out, v);
}

QByteArray rewriteObj(const ObjSource &source, const MeshData &mesh, const UvMatrix &uv)
{
    return ObjRewriter(source, mesh, uv).run();
}

} // namespace autocuts
