#include "model/io/obj/objsource.h"

#include "model/io/obj/objscanner.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace autocuts {

UvMatrix ObjSource::originalUv() const
{
    UvMatrix uv(static_cast<Eigen::Index>(cornerTextureVertex.size()), 2);
    uv.fill(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t c = 0; c < cornerTextureVertex.size(); ++c) {
        const int vt = cornerTextureVertex[c];
        if (vt >= 0)
            uv.row(static_cast<Eigen::Index>(c)) << textureVertices[2 * vt], textureVertices[2 * vt + 1];
    }
    return uv;
}

namespace {

//! The group that an s statement begins.
std::int64_t smoothingGroup(std::string_view arguments)
{
    std::string_view word;
    if (!nextWord(arguments, word) || word == "off")
        return 0;
    std::int64_t group = 0;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), group);
    return parsed.ec == std::errc() ? std::max<std::int64_t>(group, 0) : 1; // some programs write "s on"
}

//! Reads what the lines of a file say about shading, in their order.
class ShadingReader
{
public:
    explicit ShadingReader(const ObjSource &source) : mSkipped(source.skippedFaces) {}

    void readLine(const ObjScanner &scanner)
    {
        if (scanner.statement() == ObjStatement::Normal)
            readNormal(scanner.arguments());
        else if (scanner.statement() == ObjStatement::Smoothing)
            mGroup = smoothingGroup(scanner.arguments());
        else if (scanner.statement() == ObjStatement::Face)
            readFace(scanner.arguments());
    }

    FileShading result() &&
    {
        FileShading shading;
        shading.smoothing = std::move(mSmoothing);
        shading.normals.resize(static_cast<Eigen::Index>(mCornerNormal.size()), 3);
        shading.normals.fill(std::numeric_limits<double>::quiet_NaN());
        for (std::size_t c = 0; c < mCornerNormal.size(); ++c) {
            const std::int64_t n = mCornerNormal[c];
            if (n >= 0 && 3 * n + 2 < static_cast<std::int64_t>(mNormals.size()))
                shading.normals.row(static_cast<Eigen::Index>(c)) << mNormals[3 * n], mNormals[3 * n + 1],
                    mNormals[3 * n + 2];
        }
        return shading;
    }

private:
    void readNormal(std::string_view rest)
    {
        std::string_view word;
        for (int k = 0; k < 3; ++k) {
            double value = 0;
            if (!nextWord(rest, word) || !parseNumber(word, value))
                value = std::numeric_limits<double>::quiet_NaN();
            mNormals.push_back(value);
        }
    }

    void readFace(std::string_view rest)
    {
        if (mNextSkipped < mSkipped.size() && mSkipped[mNextSkipped] == mFace++) {
            ++mNextSkipped;
            return;
        }
        mSmoothing.push_back(mGroup);
        std::string_view word;
        while (nextWord(rest, word)) {
            std::int64_t index = -1;
            const auto known = static_cast<std::int64_t>(mNormals.size() / 3);
            mCornerNormal.push_back(parseIndex(ObjCornerWord(word).normal, known, index) ? index : -1);
        }
    }

    const std::vector<int> &mSkipped;
    std::size_t mNextSkipped = 0;
    int mFace = 0;
    std::int64_t mGroup = FileShading::unsaid;
    std::vector<double> mNormals;
    std::vector<std::int64_t> mCornerNormal, mSmoothing;
};

} // namespace

FileShading ObjSource::shading() const
{
    ShadingReader reader(*this);
    ObjScanner scanner({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    while (scanner.next())
        reader.readLine(scanner);
    return std::move(reader).result();
}

} // namespace autocuts
