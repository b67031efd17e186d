// Takes the charts of a map to the places where pins and rectangles want them.
#pragma once

#include "solver/search/seamtrial.h"

#include <memory>

namespace autocuts::search {

//! Moves every chart with anchors to them, unless it lies there: rigidly by its pins, else into its
//! rectangle, turned and scaled down when it does not fit otherwise. From then on the anchors have an effect.
void placeAtAnchors(CutState &state);

//! Pulls the corners of hard pins to these with ever stiffer springs and holds the corners that reach them.
//! Hard pins that cannot be reached without a flip or an overlap go on pulling.
void reachPins(SeamTrial &trial, bool guarded);

//! Relaxes a map that lies at its anchors and puts it onto its hard pins.
//! \param steps Newton steps \param guarded no charts may come to overlap
//! \returns CutState::anchorFaults()
int settleAtAnchors(const std::shared_ptr<const SeamGraph> &graph, SeamedMap &map, int steps, bool guarded);

} // namespace autocuts::search
