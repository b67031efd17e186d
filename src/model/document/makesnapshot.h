// Converts a document to the input of the solver, and the solver's UVs to those of the document.
#pragma once

#include "model/plain/snapshot.h"

#include <optional>

namespace autocuts {

class Document;

//! Makes the solver's input from a document and its active UV set.
//!
//! Units: the UVs of the document are in texture space; in solver units the mesh has area pi. Both have the
//! same origin and axes: texture = scale * solver, with one scale per UV set (DocumentState::uvScales).
//! documentUvs() converts a result back. Commands that fit a finished map to the texture store the new scale
//! together with the UVs, so that pins, rectangles and a restart from existing UVs stay correct. Moving,
//! turning or scaling single islands does not change the scale.
//!
//! The mesh of the snapshot has the painted texel weights.
//!
//! A pin acts on every soup corner of its corner, a rectangle on all soup corners of its faces. startUv is
//! set only for StartMode::ExistingUv, and only when at least one corner has a UV; rows of corners without a
//! UV are not finite.
//! \param start used instead of the start mode in the document's settings
Snapshot makeSnapshot(const Document &document, std::optional<StartMode> start = std::nullopt);

//! True when at least one corner of the active UV set has a UV.
bool hasUvs(const Document &document);

//! Converts UVs per soup corner in solver units to UVs per corner in texture space. When the soup corners of
//! one corner differ (at the diagonals of a polygon while a solve runs), the first one is used.
//! \pre soupUv has one row per soup corner
UvMatrix documentUvs(const Document &document, const UvMatrix &soupUv);

} // namespace autocuts
