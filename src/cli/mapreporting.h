// What the command line says about a map: its report, a table for people, a picture.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"
#include "model/io/report.h"
#include "solver/metrics/uvmetrics.h"

#include <QString>
#include <QStringList>

namespace autocuts {

//! Measures the active UV set (figures of a map stay unknown without one) and describes the mesh.
//! \param textureSize for figures in texels
MapReport reportOn(const Scene &scene, int textureSize);

//! What is wrong with the active UV set, one sentence each; empty when it is fit for use. \pre the scene's
//! report
QStringList mapProblems(const Scene &scene, const MapReport &report);

//! The figures that matter, one per line: the report's key, the value, what it means.
QString reportTable(const MapReport &report);

//! Draws the active UV set, overlaps hatched. \param path .png or .svg
Result<Done> writeLayout(const QString &path, const Scene &scene, int textureSize, bool overlaps);

} // namespace autocuts
