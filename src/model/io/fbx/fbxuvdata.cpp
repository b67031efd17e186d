#include "model/io/fbx/fbxuvdata.h"

#include "model/io/formats/uvcorners.h"

namespace autocuts {

FbxUvData fbxUvData(const std::vector<int> &point, int pointCount, const UvMatrix &uv)
{
    const std::vector<int> shared = sharedUvCorners(point, pointCount, uv);
    FbxUvData data;
    data.index.assign(shared.size(), -1);
    for (std::size_t c = 0; c < shared.size(); ++c) {
        const int first = shared[c];
        if (first == static_cast<int>(c)) {
            data.index[c] = static_cast<int>(data.uv.size() / 2);
            data.uv.insert(data.uv.end(), {uv(first, 0), uv(first, 1)});
        } else if (first >= 0) {
            data.index[c] = data.index[static_cast<std::size_t>(first)];
        }
    }
    return data;
}

} // namespace autocuts
