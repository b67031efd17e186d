// The figures of the document's map.
#pragma once

#include "model/document/documentstate.h"
#include "model/plain/statetoken.h"
#include "solver/metrics/uvmetrics.h"

#include <array>
#include <map>
#include <vector>

namespace autocuts {

class JobControl;

//! The figures of the document's map.
struct MapFigures
{
    StateToken token; //!< token of the measured state
    int textureSize = 0, textureHeight = 0;
    int figureChanges = 0; //!< how often stacks and texel weights had changed before
    metrics::UvMetrics metrics;
    //! The tiles in use whose islands have one material, with its number; empty where there is one tile only.
    std::map<int, int> tileMaterial;
    //! Of each island of the document, which are not those of the file where objects share a mesh: its mean
    //! distortion.
    std::vector<double> islandDistortion;
    std::vector<std::pair<int, int>> islandsOffTile; //!< of the document, see UvMetrics::chartsOffTile
    std::vector<int> overlapping;                    //!< triangles that overlap another one, ascending
    std::vector<std::array<int, 2>> overlapPairs;    //!< pairs of triangles, the largest overlap first
};

//! Measures the map of the file that a model will be: objects that share a mesh have one map there, and lie
//! on each other on purpose. Takes long. \param model its active UV set is the first one \param mesh with the
//! painted texel weights
MapFigures measuredMap(const DocumentState &model, const MeshData &mesh, JobControl &control);

} // namespace autocuts
