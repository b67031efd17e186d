#include "views/panels/mapoutcome.h"

#include "model/document/document.h"
#include "views/control/figures/islandfigures.h"
#include "views/ui/numbertext.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! In texels. Islands closer than this bleed into each other when the texture is filtered. A smaller margin
//! is what the user wants.
constexpr double fewestGutterTexels = 1;
//! How far a map may reach below 0 and still count as inside of the tiles.
constexpr double tolerance = 1e-6;
constexpr double rounding = 1e-6; // share of a margin

struct OutcomeTexts
{
    Q_DECLARE_TR_FUNCTIONS(MapOutcome)
};

//! The distortion of the islands each at its own scale. It is what unwrapping can change: packing into tiles
//! by objects, and the user, give islands different sizes, which the distortion of the whole map counts.
double distortionOfShapes(const Document &document, const MapFigures &figures)
{
    double area = 0, sum = 0;
    for (const IslandFigures &island : islandFigures(document, figures.islandDistortion)) {
        if (!std::isfinite(island.distortion))
            continue;
        area += island.areaShare;
        sum += island.areaShare * island.distortion;
    }
    return area > 0 ? sum / area : figures.metrics.symDirichlet;
}

//! Whether pins or locks hold all of these islands, so that no packing moves them.
bool areHeld(const Document &document, const std::vector<std::pair<int, int>> &islands)
{
    const Islands &all = document.islands();
    std::vector<bool> pinned(static_cast<std::size_t>(all.count()), false);
    for (const UvPin &pin : document.state().constraints.pins) {
        if (const int island = all.islandOfFace(document.adjacency().faceOfCorner(pin.corner)); island >= 0)
            pinned[static_cast<std::size_t>(island)] = true;
    }
    return std::all_of(islands.begin(), islands.end(), [&](const std::pair<int, int> &island) {
        return pinned[static_cast<std::size_t>(island.first)] ||
               document.marks().flagsOf(all.faces(island.first)).locked != 0;
    });
}

//! Names islands, and the tiles to which they belong.
QString offTileText(const std::vector<std::pair<int, int>> &islands)
{
    constexpr std::size_t mostNamed = 4;
    QStringList names;
    for (std::size_t i = 0; i < std::min(mostNamed, islands.size()); ++i)
        names << OutcomeTexts::tr("island %1 (of %2)").arg(islands[i].first + 1).arg(islands[i].second);
    if (islands.size() > mostNamed)
        names << OutcomeTexts::tr("%1 more").arg(islands.size() - mostNamed);
    return names.join(QStringLiteral(", "));
}

} // namespace

MapOutcome outcomeOf(const Document &document, const MapFigures &figures, double bound)
{
    const metrics::UvMetrics &m = figures.metrics;
    if (m.charts == 0)
        return {OutcomeTexts::tr("No map yet"), "uv.unwrap"};
    const QString what =
        figureLine(OutcomeTexts::tr("D %1, seams %2, islands: %3")
                       .arg(fixedText(m.tileDirichlet, 3), fixedText(m.seamNorm, 2), countText(m.charts)));
    const auto outcome = [&](const char *verdict, const char *next) {
        return MapOutcome{what + QStringLiteral(". ") + OutcomeTexts::tr(verdict), next};
    };
    if (m.flipped > 0)
        return outcome(QT_TRANSLATE_NOOP("MapOutcome", "Triangles are flipped."), "uv.unwrap");
    if (m.overlapPairs > 0)
        return outcome(QT_TRANSLATE_NOOP("MapOutcome", "Faces overlap."), "uv.separate");
    if (m.symDirichlet > bound) {
        if (distortionOfShapes(document, figures) > bound)
            return outcome(QT_TRANSLATE_NOOP("MapOutcome", "More stretch than allowed."),
                           "uv.finish"); // keeps the work of the hand
        if (m.tiles.size() < 2 && !document.packingSettings().keepScale)
            return outcome(QT_TRANSLATE_NOOP("MapOutcome", "Texel densities differ."), "uv.density");
    }
    if (!m.chartsOffTile.empty() && !figures.islandsOffTile.empty())
        return {
            what + QStringLiteral(". ") +
                OutcomeTexts::tr("Not in one tile as a whole: %1.").arg(offTileText(figures.islandsOffTile)),
            areHeld(document, figures.islandsOffTile) ? "" : "uv.pack"};
    const double least = std::min(fewestGutterTexels, double(document.packingSettings().margin));
    if (m.minGutterTexels < least * (1 - rounding) || m.uvMin.minCoeff() < -tolerance)
        return outcome(QT_TRANSLATE_NOOP("MapOutcome", "Not packed."), "uv.pack");
    return outcome(QT_TRANSLATE_NOOP("MapOutcome", "Ready."), "file.exportMesh");
}

} // namespace autocuts
