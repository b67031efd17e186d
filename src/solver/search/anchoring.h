// Takes the charts of a map to the places where pins and rectangles want them.
#pragma once

#include "solver/search/seamtrial.h"

#include <memory>
#include <optional>

namespace autocuts::search {

//! Moves every chart with pins rigidly to them, unless it lies there. From then on the pins have an effect.
//! \pre all anchors are pins
void placeAtAnchors(CutState &state);

//! Pulls the corners of hard pins to these with ever stiffer springs and holds the corners that reach them.
//! Hard pins that cannot be reached without a flip or an overlap, or before the job is stopped, go on
//! pulling.
void reachPins(SeamTrial &trial, bool guarded, const JobContext &job = {});

//! Relaxes a map that lies at its pins and puts it onto the hard ones.
//! \param steps Newton steps \param guarded no charts may come to overlap
//! \returns CutState::anchorFaults()
int settleAtAnchors(const std::shared_ptr<const SeamGraph> &graph, SeamedMap &map, int steps, bool guarded,
                    const JobContext &job = {});

//! True when the corners of a chart fit into a box, turned as it may be.
//! \param x per soup corner, see Soup
bool fitsInto(const std::vector<double> &x, const std::vector<int> &soupCorners, const Vec2 &lower,
              const Vec2 &upper);

//! The map after every chart with a box was put into it, scaled down as far as necessary, and relaxed there:
//! it grows and is deformed. Charts may come to lie on others.
//! \param steps Newton steps \pre all anchors are boxes, one for each chart at most
//! \returns nothing when stopped
std::optional<SeamedMap> fittedToBoxes(const std::shared_ptr<const SeamGraph> &graph, const SeamedMap &map,
                                       int steps, const JobContext &job = {});

} // namespace autocuts::search
