#include "views/selecting/islandkinds.h"

#include "model/document/document.h"
#include "views/control/figures/islandfigures.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

template <typename Accept>
QList<int> facesOfIslandsIf(const Islands &islands, Accept accept)
{
    QList<int> faces;
    for (int island = 0; island < islands.count(); ++island) {
        if (accept(island))
            faces.append(QList<int>(islands.faces(island).begin(), islands.faces(island).end()));
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

} // namespace

QList<int> facesOfStretchedIslands(const Document &document, double bound)
{
    const std::vector<double> distortion = islandDistortions(document);
    return facesOfIslandsIf(document.islands(), [&](int island) {
        return distortion[static_cast<std::size_t>(island)] > bound; // false when it is not known
    });
}

QList<int> facesOfSmallIslands(const Document &document, double texels)
{
    const int textureSize = document.packingSettings().textureSize;
    return facesOfIslandsIf(document.islands(), [&](int island) {
        return document.islands().box(island).sizes().maxCoeff() * textureSize < texels;
    });
}

QList<int> facesOffDensity(const Document &document, double share)
{
    const std::vector<IslandFigures> figures = islandFigures(document, {});
    const double median = medianTexelDensity(figures);
    return facesOfIslandsIf(document.islands(), [&](int island) {
        return std::abs(figures[static_cast<std::size_t>(island)].texelDensity - median) > share * median;
    });
}

} // namespace autocuts
