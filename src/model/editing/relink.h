// Transfers a session to a changed version of its model.
#pragma once

#include "model/document/documentstate.h"
#include "model/transfer/placement.h"

#include <QStringList>

#include <functional>

namespace autocuts {

//! How many items were transferred, and how many were not.
struct Carried
{
    int kept = 0;
    int lost = 0;

    bool operator==(const Carried &) const = default;
};

//! Says what was kept of a session when its model was replaced.
struct RelinkReport
{
    //! Both models have the same polygons in the same order. Positions may differ.
    bool sameTopology = false;
    Carried faces;       //!< faces of the old model that were found in the new one, and that were not
    QList<int> newFaces; //!< faces of the new model that the old one does not have
    transfer::Placement placement; //!< of the new model, where it has other units or axes than the old one
    int placedFaces = 0; //!< new faces that took UVs of the active set from the old model by position
    int besideFaces = 0; //!< new faces that were laid beside the map, flat
    Carried seams;       //!< edges that are cut, joined, painted or kept straight
    Carried pins, rectangleFaces, markedFaces;
    Carried weightedFaces; //!< faces with a texel weight other than 1
    QStringList lostTags;

    //! One line per kind of loss; empty when nothing was lost.
    QStringList lines() const;
};

struct Relinked
{
    DocumentState state;
    RelinkReport report;
};

//! Transfers a session to a new model. Settings, view, hidden faces, all UV sets and the steering are kept
//! wherever a face has a counterpart. New faces take the UVs of the nearest points of the old model
//! (model/transfer) where that has faces that are gone; those that would lie on others, or are far from them,
//! are laid flat beside the map. When more than half of the faces are far from the old model, no new face has
//! UVs. The UV sets of the new file are ignored. Selected edges are dropped.
//!
//! When both models have the same polygons with the same vertices in the same order, faces of equal number
//! are counterparts; a model that was only deformed keeps everything. Otherwise counterparts have the same
//! corners in the same winding at the same positions, up to the rounding of text files. Among several such
//! faces, the first one of the same object is taken, or the first one if there is none. Where most faces have
//! none and the models have as many vertices, faces with the same vertices are counterparts: the model was
//! moved or deformed, and some faces are gone. Where hardly any are found and the new model is as large as
//! the old one in other units, or turned between y up and z up, it is compared so. A part that has no
//! counterparts then is looked for by itself (transfer/partmatch.h): each may have been moved, scaled, turned
//! or deformed by itself, beside parts that are gone or new. \pre both have a mesh, and
//! the state is valid \param stopped asked at least every 50 ms: after a stop the result is of no use; may be
//! empty
Relinked relinkDocument(const DocumentState &state, Scene newScene,
                        const std::function<bool()> &stopped = {});

//! A scene that another program handed over, with the colours of the own one, which it does not know, where
//! both have the same polygons and materials.
Scene completedHanded(Scene handed, const Scene &own);

} // namespace autocuts
