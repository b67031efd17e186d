// A panel beside a small document, for the tests of panels.
#pragma once

#include "support/editsupport.h"
#include "support/panelbench.h"

#include <QLabel>

namespace autocuts::test {

//! A panel on a grid of 4 x 4 quads in two islands.
template <class PanelType>
struct Bench : PanelBench
{
    PanelType panel{context};

    explicit Bench(bool open = true)
    {
        if (open)
            openGrid();
        const bool shown = showPanel(panel);
        Q_ASSERT(shown);
        Q_UNUSED(shown);
    }
    void openGrid() { workspace.open(layoutDocument(grid(4)), {}); }
    void select(QList<int> faces, QList<int> edges)
    {
        document().setSelection({SelectionMode::Faces, std::move(faces), std::move(edges), {}});
    }
    bool followed() { return isUpToDate(panel); }
    QString text(const char *label) { return child<QLabel>(panel, label)->text(); }
};

} // namespace autocuts::test
