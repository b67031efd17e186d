#include "model/io/projects/projectblocks.h"

#include "model/io/files/deflate.h"

#include <QCborStreamReader>
#include <QCborStreamWriter>
#include <QCryptographicHash>
#include <QtEndian>

#include <algorithm>
#include <optional>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr auto formatName = "autocuts-project"_L1;

// The contents of all blocks together may have so many bytes, so many for each byte of the file, and no more
// than the last. A million quads take 50 MB. Chosen by hand.
constexpr qint64 contentBase = qint64(512) << 20;
constexpr qint64 contentPerByte = 64;
constexpr qint64 largestContent = qint64(8) << 30;

//! Checksum over the name, the size and the data of a block, so that none of them can be changed unnoticed.
QByteArray checksumOf(const QByteArray &name, qint64 size, QByteArrayView data)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(name);
    const qint64 littleEndian = qToLittleEndian(size);
    hash.addData(QByteArrayView(reinterpret_cast<const char *>(&littleEndian), sizeof littleEndian));
    hash.addData(data);
    return hash.result();
}

bool isWhole(const PackedBlock &block)
{
    return checksumOf(block.name, block.size, block.data) == block.checksum;
}

//! The content of a whole block.
std::optional<QByteArray> unpackBlock(const PackedBlock &block)
{
    if (block.size == block.data.size())
        return block.data;
    return inflated(block.data, block.size);
}

//! Reads the container. It fails at the first value that is not as expected.
class ContainerReader
{
public:
    explicit ContainerReader(const QByteArray &bytes) : mReader(bytes) {}

    bool failed() const { return mFailed; }
    bool atEnd() { return mFailed || !mReader.hasNext(); }
    bool enterMap() { return enter(mReader.isMap()); }

    QString text()
    {
        QString result;
        if (!check(mReader.isString()))
            return result;
        auto chunk = mReader.readString();
        for (; chunk.status == QCborStreamReader::Ok; chunk = mReader.readString())
            result += chunk.data;
        check(chunk.status == QCborStreamReader::EndOfString);
        return result;
    }

    QByteArray bytes()
    {
        QByteArray result;
        if (!check(mReader.isByteArray()))
            return result;
        auto chunk = mReader.readByteArray();
        for (; chunk.status == QCborStreamReader::Ok; chunk = mReader.readByteArray()) {
            if (result.isEmpty())
                result = std::move(chunk.data);
            else
                result += chunk.data;
        }
        check(chunk.status == QCborStreamReader::EndOfString);
        return result;
    }

    qint64 integer()
    {
        if (!check(mReader.isUnsignedInteger()))
            return 0;
        const quint64 value = mReader.toUnsignedInteger();
        check(mReader.next() && value <= quint64(std::numeric_limits<qint64>::max()));
        return mFailed ? 0 : static_cast<qint64>(value);
    }

    PackedBlock block()
    {
        PackedBlock block;
        block.name = text().toUtf8();
        if (!enter(mReader.isArray()))
            return block;
        block.size = integer();
        block.checksum = bytes();
        block.data = bytes();
        check(!mFailed && !mReader.hasNext() && mReader.leaveContainer());
        return block;
    }

private:
    bool enter(bool isContainer) { return check(isContainer) && check(mReader.enterContainer()); }
    bool check(bool fine)
    {
        mFailed = mFailed || !fine || mReader.lastError() != QCborError::NoError;
        return !mFailed;
    }

    QCborStreamReader mReader;
    bool mFailed = false;
};

} // namespace

const QByteArray *ProjectParts::part(const char *name) const
{
    const auto found = parts.find(name);
    return found == parts.end() ? nullptr : &found->second;
}

PackedBlock packBlock(const QByteArray &name, const QByteArray &content, bool compress)
{
    PackedBlock block{name, content.size(), {}, content};
    if (compress) {
        QByteArray packed = deflated(content);
        if (packed.size() < content.size())
            block.data = std::move(packed);
    }
    block.checksum = checksumOf(name, block.size, block.data);
    return block;
}

QByteArray containerBytes(int version, const std::vector<PackedBlock> &blocks)
{
    QByteArray bytes;
    QCborStreamWriter writer(&bytes);
    writer.startMap(blocks.size() + 2);
    writer.append("format"_L1);
    writer.append(formatName);
    writer.append("version"_L1);
    writer.append(version);
    for (const PackedBlock &block : blocks) {
        writer.appendTextString(block.name.constData(), block.name.size());
        writer.startArray(3);
        writer.append(block.size);
        writer.append(block.checksum);
        writer.append(block.data);
        writer.endArray();
    }
    writer.endMap();
    return bytes;
}

Result<ProjectParts> readContainer(const QByteArray &bytes, int newest, const QString &path,
                                   const std::function<bool(const QByteArray &)> &wanted)
{
    ContainerReader reader(bytes);
    if (!reader.enterMap() || reader.text() != "format"_L1 || reader.text() != formatName ||
        reader.text() != "version"_L1)
        return Error{u"this is not a session of Autocuts, or its beginning is damaged"_s, path, 0,
                     u"Open a backup of it: the same name with .1 or .2 behind it"_s};
    const qint64 version = reader.integer();
    if (reader.failed() || version < 1)
        return Error{u"the beginning of the session is damaged"_s, path, 0,
                     u"Open a backup of it: the same name with .1 or .2 behind it"_s};
    if (version > newest)
        return Error{
            u"the session was saved by a newer Autocuts (its format is %1, this one reads up to %2)"_s
                .arg(version)
                .arg(newest),
            path, 0, u"Install a newer Autocuts"_s};
    ProjectParts result;
    result.version = static_cast<int>(version);
    qint64 room = std::min(contentBase + contentPerByte * bytes.size(), largestContent);
    while (!reader.atEnd()) {
        const PackedBlock block = reader.block();
        if (reader.failed())
            break;
        if (!wanted(block.name) || result.parts.contains(block.name)) {
            result.skipped.push_back(block.name);
            continue;
        }
        const bool whole = isWhole(block);
        if (whole && block.size > room)
            return Error{
                u"the contents of the session are far larger than those of any session of its size"_s, path,
                0,
                u"The file is forged or damaged: open a backup of it, the same name with .1 or .2 behind it"_s};
        std::optional<QByteArray> content = whole ? unpackBlock(block) : std::nullopt;
        if (content) {
            room -= block.size;
            result.parts.emplace(block.name, std::move(*content));
        } else {
            result.damaged.push_back(block.name);
        }
    }
    result.brokenOff = reader.failed();
    return result;
}

} // namespace autocuts
