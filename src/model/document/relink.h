// Carrying a session over to a changed version of its model.
#pragma once

#include "model/document/documentstate.h"

#include <QStringList>

namespace autocuts {

//! How many things were carried over, and how many were not.
struct Carried
{
    int kept = 0;
    int lost = 0;

    bool operator==(const Carried &) const = default;
};

//! What became of a session when its model was exchanged.
struct RelinkReport
{
    //! Both models have the same polygons in the same order; positions may differ.
    bool sameTopology = false;
    Carried faces;    //!< of the old model: found in the new one, or not
    int newFaces = 0; //!< of the new model that the old one did not have
    Carried seams;    //!< edges that are cut, joined or painted
    Carried pins, rectangleFaces, markedFaces;
    QStringList lostTags;

    //! One line per kind of loss; empty when nothing was lost.
    QStringList lines() const;
};

struct Relinked
{
    DocumentState state;
    RelinkReport report;
};

//! The session on the new model. Settings, view, all UV sets and the steering are kept wherever a face has
//! its counterpart; new faces have no UVs. The UV sets of the new file are not used. Selected edges are
//! dropped.
//!
//! Faces are counterparts when both models have the same polygons of the same vertices in the same order, so
//! that a model that was only deformed keeps everything. Else those that have the same corners in the same
//! winding, at the same positions but for the rounding of text files; of several such faces the first
//! one of the same object, or else the first one.
//! \pre both have a mesh, and the state is valid
Relinked relinkDocument(const DocumentState &state, Scene newScene);

} // namespace autocuts
