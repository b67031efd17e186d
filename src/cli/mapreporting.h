// Describes a map: the report, a table for people, a picture.
#pragma once

#include "cli/clioptions.h"
#include "cli/stopsource.h"
#include "model/document/result.h"
#include "model/document/scene.h"
#include "model/layouts/report.h"
#include "model/plain/islandflags.h"
#include "model/plain/packingsettings.h"
#include "solver/metrics/uvmetrics.h"

#include <QString>
#include <QStringList>

namespace autocuts {

//! Measures the active UV set and describes the mesh. Without a UV set, the figures of the map stay unknown.
//! \param faceFlags per face: which islands are stacked; empty: none
//! \param packing the texture, for figures in texels
//! \param faces per face: it is measured, as if there were no others; empty: all are
MapReport reportOn(const Scene &scene, const std::vector<IslandFlags> &faceFlags,
                   const PackingSettings &packing, const std::vector<bool> &faces = {});

//! The problems of a map, one sentence each; empty when it can be used. \param report from reportOn()
QStringList mapProblems(const MapReport &report);

//! The problems that make the command check fail, one sentence each. \param report from reportOn()
QStringList failures(const MapReport &report, const CliOptions::FailOn &failOn);

//! What a new map lacks, such as an area for some faces; one sentence each. \param report from reportOn()
QStringList mapWarnings(const MapReport &report);

//! The most important figures, one per line: the key in the report, the value and its meaning.
QString reportTable(const MapReport &report);

//! The triangles that overlap in the active UV set, ascending. \param faceFlags see reportOn() \param stop
//! ends it with those found so far; null: nothing does
std::vector<int> overlappingTriangles(const Scene &scene, const std::vector<IslandFlags> &faceFlags,
                                      const StopSource *stop);

//! Draws the active UV set as the options say: a picture of each UDIM tile in use.
//! \param hatched triangles, ascending \param faces per face: it is drawn; empty: all are \param stop an
//! interrupt, but no time limit, ends it with an Error and leaves all files as they were; null: nothing does
Result<Done> writeLayout(const CliOptions &cli, const Scene &scene, const std::vector<int> &hatched,
                         const std::vector<bool> &faces, const StopSource *stop);

} // namespace autocuts
