// Colours and line widths of pictures of UV layouts.
#pragma once

#include "model/layouts/layoutoptions.h"
#include "model/layouts/layoutpaths.h"

#include <QColor>

namespace autocuts {

//! The style of one picture; widths in pixels.
struct LayoutStyle
{
    QColor background, frame, edge, seam, overlap, overlapTint;
    double edgeWidth = 1, seamWidth = 2, frameWidth = 1;
    double hatchSpacing = 10, hatchWidth = 2;

    //! Chooses line widths so that the edges of a dense mesh do not hide the islands.
    LayoutStyle(const LayoutPaths &paths, const LayoutOptions &options);

    //! The colour that the island has in the studio, or the one that was asked for.
    QColor islandColor(int chart) const;

private:
    LayoutBackground mBackground;
    std::optional<QColor> mIslandColor;
};

//! Why the options are invalid; a null string when they are valid.
QString layoutOptionsProblem(const LayoutOptions &options);

} // namespace autocuts
