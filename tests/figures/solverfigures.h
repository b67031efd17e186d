// Figures 2, 4, 5, 7 and 13 of the paper, by the live solver alone.
#pragma once

#include "figures/figurepage.h"

namespace autocuts::figures {

void lambdaBalance(FigurePage &page, const Figure &figure);
void deltaSweep(FigurePage &page, const Figure &figure);
void fourStarts(FigurePage &page, const Figure &figure);
void propagatedCut(FigurePage &page, const Figure &figure);
void lengthOrCount(FigurePage &page, const Figure &figure);

} // namespace autocuts::figures
