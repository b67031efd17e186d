// Figures 6, 9, 10, 11, 12 and 17 of the paper, by the studio's views, tools and jobs.
#pragma once

#include "figures/figurepage.h"

namespace autocuts::figures {

void bumpyCube(FigurePage &page, const Figure &figure);
void overlapRegions(FigurePage &page, const Figure &figure);
void irregularMesh(FigurePage &page, const Figure &figure);
void octopusPatches(FigurePage &page, const Figure &figure);
void quadMesh(FigurePage &page, const Figure &figure);
void severalModels(FigurePage &page, const Figure &figure);

} // namespace autocuts::figures
