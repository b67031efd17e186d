// The objects and materials of a document with their figures.
#pragma once

#include "model/document/document.h"
#include "model/document/scenegroups.h"

namespace autocuts {

//! One object or material.
struct SceneFigures
{
    SceneGroup group;
    QRgb color = 0; //!< of a material; of an object 0
    int islands = 0;
    int hiddenFaces = 0;
    double distortion = 0;   //!< mean of those of its islands, by area; NaN when unknown
    double texelDensity = 0; //!< texels per unit of the model; NaN without UVs
    double share = 0;        //!< the part of a tile that its islands take

    bool isHidden() const { return hiddenFaces == group.faces.size(); }
};

//! \param distortion UvMetrics::chartSymDirichlet of the map; empty when it is not known
std::vector<SceneFigures> sceneFigures(const Document &document, SceneKind kind,
                                       const std::vector<double> &distortion);

//! Counts the hidden faces again.
void countHidden(const Document &document, std::vector<SceneFigures> &figures);

} // namespace autocuts
