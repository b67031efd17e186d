#include "model/io/objsource.h"

#include "model/io/objscanner.h"

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

PositionMatrix objCornerNormals(const ObjSource &source)
{
    std::vector<double> normals;
    std::vector<std::int64_t> cornerNormal;
    std::string_view word;
    int face = 0;
    auto skipped = source.skippedFaces.begin();
    ObjScanner scanner({source.bytes.constData(), static_cast<std::size_t>(source.bytes.size())});
    while (scanner.next()) {
        std::string_view rest = scanner.arguments();
        if (scanner.statement() == ObjStatement::Normal) {
            for (int k = 0; k < 3; ++k) {
                double value = 0;
                if (!nextWord(rest, word) || !parseNumber(word, value))
                    value = std::numeric_limits<double>::quiet_NaN();
                normals.push_back(value);
            }
        } else if (scanner.statement() == ObjStatement::Face) {
            if (skipped != source.skippedFaces.end() && *skipped == face++) {
                ++skipped;
                continue;
            }
            while (nextWord(rest, word)) {
                std::int64_t index = -1;
                const auto known = static_cast<std::int64_t>(normals.size() / 3);
                cornerNormal.push_back(parseIndex(ObjCornerWord(word).normal, known, index) ? index : -1);
            }
        }
    }
    PositionMatrix result(static_cast<Eigen::Index>(cornerNormal.size()), 3);
    result.fill(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t c = 0; c < cornerNormal.size(); ++c) {
        const std::int64_t n = cornerNormal[c];
        if (n >= 0 && 3 * n + 2 < static_cast<std::int64_t>(normals.size()))
            result.row(static_cast<Eigen::Index>(c)) << normals[3 * n], normals[3 * n + 1],
                normals[3 * n + 2];
    }
    return result;
}

} // namespace autocuts
