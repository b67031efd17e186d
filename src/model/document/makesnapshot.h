// What the solver sees of a document.
#pragma once

#include "model/plain/snapshot.h"

#include <optional>

namespace autocuts {

class Document;

//! The steering of a document for its active UV set.
//!
//! Units: the document's UVs are in texture space, the solver's such that the mesh has area pi. Both have the
//! same origin and axes, texture = scale * solver with the scale stored per UV set (DocumentState::uvScales);
//! a solver's result goes back by documentUvs(). Commands that fit a finished map to the texture store the
//! new scale together with the UVs, so that pins, rectangles and a restart from existing UVs keep their
//! meaning. Moving, turning or scaling single islands does not touch it.
//!
//! Pins act on every soup corner of their corner, rectangles on all soup corners of their faces. startUv is
//! filled for StartMode::ExistingUv only, and only when at least one corner has a UV; corners without one are
//! not finite.
//! \param start in place of the start mode of the document's settings
Snapshot makeSnapshot(const Document &document, std::optional<StartMode> start = std::nullopt);

//! True when at least one corner of the active UV set has a UV.
bool hasUvs(const Document &document);

//! UVs per corner in texture space from UVs per soup corner in solver units. Where the soup corners of one
//! corner differ (the diagonals of a polygon while a solve runs), the first one counts. \pre soupUv has a row
//! per soup corner
UvMatrix documentUvs(const Document &document, const UvMatrix &soupUv);

} // namespace autocuts
