// Pictures of chapters of the guide. Each step begins in a new window.
#pragma once

#include "guide/guidewindow.h"

namespace autocuts::guide {

void selecting(GuideWindow &guide);
void straightening(GuideWindow &guide);
void layingOut(GuideWindow &guide);
void seeing(GuideWindow &guide);
void handingOn(GuideWindow &guide);
void lighting(GuideWindow &guide);

} // namespace autocuts::guide
