#include "model/io/files/unzipping.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace autocuts {

namespace {

// What zlib calls the kinds of streams.
constexpr int zlibOrGzip = 15 + 32;
constexpr int bareStream = -15;

// Zip archives: marks and sizes of their records, without names.
constexpr std::string_view zipEntryMark("PK\x01\x02", 4), zipEndMark("PK\x05\x06", 4),
    zipFileMark("PK\x03\x04", 4);
constexpr std::size_t zipEntrySize = 46, zipEndSize = 22, zipFileSize = 30;
constexpr std::size_t storedMethod = 0;

struct Inflated
{
    std::string bytes;
    bool isWhole = false;
};

//! \param most after this many bytes no more are made
Inflated inflated(std::string_view packed, int kind, std::size_t most)
{
    z_stream stream{};
    if (inflateInit2(&stream, kind) != Z_OK)
        return {};
    Inflated result;
    std::string part(std::min(most, std::size_t(1) << 20), '\0');
    stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    int outcome = Z_OK;
    while (outcome == Z_OK && result.bytes.size() < most) {
        stream.next_out = reinterpret_cast<Bytef *>(part.data());
        stream.avail_out = static_cast<uInt>(part.size());
        outcome = inflate(&stream, Z_NO_FLUSH);
        result.bytes.append(part, 0, part.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    result.isWhole = outcome == Z_STREAM_END;
    return result;
}

//! A whole number with the low byte first; 0 beyond the end.
std::size_t zipNumber(std::string_view bytes, std::size_t at, std::size_t size)
{
    std::size_t value = 0;
    for (std::size_t k = size; k > 0; --k)
        value = value << 8 | (at + k <= bytes.size() ? static_cast<unsigned char>(bytes[at + k - 1]) : 0U);
    return value;
}

std::string_view slice(std::string_view bytes, std::size_t at, std::size_t size)
{
    return bytes.substr(std::min(at, bytes.size()), size);
}

} // namespace

std::string unzipped(std::string_view packed)
{
    Inflated result = inflated(packed, zlibOrGzip, std::numeric_limits<std::size_t>::max());
    return result.isWhole ? std::move(result.bytes) : std::string();
}

std::string beginInArchive(std::string_view archive, std::string_view ending, std::size_t most)
{
    const std::size_t end = archive.rfind(zipEndMark);
    if (end == std::string_view::npos || archive.size() < end + zipEndSize)
        return {};
    std::size_t at = zipNumber(archive, end + 16, 4);
    while (slice(archive, at, 4) == zipEntryMark) {
        const std::size_t name = zipNumber(archive, at + 28, 2);
        if (slice(archive, at + zipEntrySize, name).ends_with(ending)) {
            const std::size_t file = zipNumber(archive, at + 42, 4);
            if (slice(archive, file, 4) != zipFileMark)
                return {};
            const std::size_t content =
                file + zipFileSize + zipNumber(archive, file + 26, 2) + zipNumber(archive, file + 28, 2);
            const std::string_view packed = slice(archive, content, zipNumber(archive, at + 20, 4));
            const bool isStored = zipNumber(archive, at + 10, 2) == storedMethod;
            return isStored ? std::string(packed.substr(0, most)) : inflated(packed, bareStream, most).bytes;
        }
        at += zipEntrySize + name + zipNumber(archive, at + 30, 2) + zipNumber(archive, at + 32, 2);
    }
    return {};
}

} // namespace autocuts
