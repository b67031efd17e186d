// The figures of the document's map.
#pragma once

#include "model/document/scene.h"
#include "model/plain/islandflags.h"
#include "model/plain/packingsettings.h"
#include "model/plain/statetoken.h"
#include "solver/metrics/uvmetrics.h"

#include <array>
#include <map>
#include <memory>
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

//! What the figures of a document depend on.
struct MeasuredModel
{
    Scene scene; //!< its first UV set is the one that is measured
    std::vector<IslandFlags> faceFlags;
    PackingSettings packing;
    std::shared_ptr<const MeshData> mesh; //!< with the painted texel weights
};

//! Measures the map of the file that a model will be: objects that share a mesh have one map there, and lie
//! on each other on purpose. Takes long.
MapFigures measuredMap(const MeasuredModel &model, JobControl &control);

} // namespace autocuts
