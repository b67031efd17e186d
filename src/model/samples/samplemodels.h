// The models behind makeSample(), one function each.
#pragma once

#include "model/samples/polygonmodel.h"

namespace autocuts::samples {

PolygonModel makeBumpyCube();
PolygonModel makeCharacter();
PolygonModel makeHandleTorus();
PolygonModel makeMachine();

} // namespace autocuts::samples
