#include "views/panels/mapoutcome.h"

#include "views/panels/numbertext.h"

#include <QCoreApplication>

namespace autocuts {

namespace {

//! In texels. Islands closer than this bleed into each other when the texture is filtered.
constexpr double fewestGutterTexels = 1;
//! How far a map may reach below 0 and still count as inside of the tiles.
constexpr double tolerance = 1e-6;

struct OutcomeTexts
{
    Q_DECLARE_TR_FUNCTIONS(MapOutcome)
};

} // namespace

MapOutcome outcomeOf(const MapFigures &figures, double bound)
{
    const metrics::UvMetrics &m = figures.metrics;
    if (m.charts == 0)
        return {OutcomeTexts::tr("No map yet"), "uv.unwrap"};
    const QString what =
        OutcomeTexts::tr("D %1, seams %2, islands: %3")
            .arg(fixedText(m.symDirichlet, 3), fixedText(m.seamNorm, 2), countText(m.charts));
    const auto outcome = [&](const char *verdict, const char *next) {
        return MapOutcome{what + QStringLiteral(". ") + OutcomeTexts::tr(verdict), next};
    };
    if (m.flipped > 0)
        return outcome(QT_TRANSLATE_NOOP("MapOutcome", "Triangles are flipped."), "uv.unwrap");
    if (m.overlapPairs > 0)
        return outcome(QT_TRANSLATE_NOOP("MapOutcome", "Faces overlap."), "uv.separate");
    if (m.symDirichlet > bound)
        return outcome(QT_TRANSLATE_NOOP("MapOutcome", "More stretch than allowed."), "uv.unwrap");
    if (m.minGutterTexels < fewestGutterTexels || m.uvMin.minCoeff() < -tolerance)
        return outcome(QT_TRANSLATE_NOOP("MapOutcome", "Not packed."), "uv.pack");
    return outcome(QT_TRANSLATE_NOOP("MapOutcome", "Ready."), "file.exportMesh");
}

} // namespace autocuts
