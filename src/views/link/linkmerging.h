// Changes of marks and maps by other programs as commands of the document.
#pragma once

#include "link/linkmap.h"
#include "model/document/documentstate.h"

namespace autocuts {

class Document;

//! Pushes the commands for changes of marks, and selects.
//! \pre the mesh of the edges is the document's
void applyMarks(Document &document, const link::VertexPairs &edges, const link::MarkChanges &changes);
//! Gives materials the pictures of another program, where they are others than those that they have.
//! Materials that are not there and channels without a picture do not count.
void applyTextures(Document &document, const link::NamedTextures &materials);
//! Puts the map of another program into the document, where it differs by more than rounding. Corners without
//! a UV keep theirs. \param uv one row per corner, in a texture of 1 x 1
void applyUvs(Document &document, const UvMatrix &uv);
//! The same changes in a state that no document has yet.
void prepareMarks(DocumentState &state, const link::VertexPairs &edges, const link::MarkChanges &changes);
//! What programs get of a document, but its map.
link::MapToSend toSend(const Document &document);

} // namespace autocuts
