// Colours and line widths of the pictures of UV layouts.
#pragma once

#include "model/io/layoutoptions.h"
#include "model/io/layoutpaths.h"

#include <QColor>

namespace autocuts {

//! Looks of one picture; widths in pixels.
struct LayoutStyle
{
    QColor background, frame, edge, seam, overlap, overlapTint;
    double edgeWidth = 1, seamWidth = 2, frameWidth = 1;
    double hatchSpacing = 10, hatchWidth = 2;

    //! Chosen so that the edges of a dense mesh do not drown the islands.
    LayoutStyle(const LayoutPaths &paths, const LayoutOptions &options);

    //! Neighbouring numbers get clearly different hues.
    QColor islandColor(int chart) const;

private:
    LayoutBackground mBackground;
    std::optional<QColor> mIslandColor;
};

//! Null when the options are fine.
QString layoutOptionsProblem(const LayoutOptions &options);

} // namespace autocuts
