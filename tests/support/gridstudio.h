// The studio without its window, on a small document.
#pragma once

#include "support/editsupport.h"
#include "support/studioparts.h"

namespace autocuts::test {

using namespace homotopy;

//! The studio on a grid of 4 x 4 quads in two islands, in which nothing is selected.
struct GridStudio : StudioParts
{
    GridStudio()
    {
        workspace.open(layoutDocument(grid(4)), {});
        solver.setMode(SolveMode::Manual);
    }
    void selectFaces(const QList<int> &faces)
    {
        Selection selection;
        selection.faces = faces;
        document().setSelection(selection);
    }
    void selectEdges(const QList<int> &edges)
    {
        Selection selection;
        selection.mode = SelectionMode::Edges;
        selection.edges = edges;
        document().setSelection(selection);
    }
    const Selection &selection() { return document().selection(); }
    int entries() { return document().undoStack().count(); }
};

} // namespace autocuts::test
