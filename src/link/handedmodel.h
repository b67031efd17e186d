// A model as another program hands it over.
#pragma once

#include "link/linkmarks.h"
#include "model/document/scene.h"

namespace autocuts::link {

//! The contents of a "mesh" message, checked. UVs and pins are those of a texture of 1 x 1.
struct HandedModel
{
    int serial = 0;     //!< number that the program gave this state of its model
    bool opens = false; //!< the user asked for this model: it may replace another one
    Scene scene;
    std::shared_ptr<const VertexPairs> edges; //!< of the scene's mesh
    MarkChanges marks;                        //!< those that the mesh has, as changes of one without marks
};

//! Makes a model of a "mesh" message. Takes as long as reading a file: not for the GUI thread.
//! \returns an Error when something is out of range
Result<HandedModel> readHandedModel(const Message &message);

//! The number of a "mesh" message or of what belongs to one; 0 when it has none.
int serialOf(const Message &message);

} // namespace autocuts::link
