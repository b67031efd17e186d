// Figures of the paper with textures that are baked for a map, by the command line and the studio's views.
#pragma once

#include "figures/figurepage.h"

namespace autocuts::figures {

//! Figure 14. Left out without the meshes.
void paintedSet(FigurePage &page, const Figure &figure);
//! Figure 15. Left out without the meshes.
void detailBake(FigurePage &page, const Figure &figure);
//! Figure 16.
void lightBake(FigurePage &page, const Figure &figure);

} // namespace autocuts::figures
