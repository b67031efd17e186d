// Finds the seams that the user gives to a job.
#pragma once

#include "model/document/changeevent.h"
#include "model/document/scene.h"
#include "model/plain/snapshot.h"

#include <span>

namespace autocuts {

//! givenSeams() of model/plain/givenseams.h for a scene. \param uv the map that is there; null for none
std::vector<bool> givenSeams(const Scene &scene, const UvMatrix *uv, std::span<const PairState> states,
                             const GivenSeamOptions &options);

//! True when the given seams of a document may be others after this event.
bool changesGivenSeams(const ChangeEvent &event);

} // namespace autocuts
