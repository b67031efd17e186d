// Everything a session consists of, as one plain value: what a project file holds and what a test compares.
#pragma once

#include "model/document/constraints.h"
#include "model/document/islands.h"
#include "model/document/scene.h"
#include "model/document/seams.h"
#include "model/document/selection.h"
#include "model/plain/packingsettings.h"
#include "model/plain/solvesettings.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace autocuts {

//! Complete state of a Document. The steering (seams, constraints, marks) is one for all UV sets.
struct DocumentState
{
    //! The model. Its UV sets stand in the order of the file; unlike in a scene without a document the active
    //! one is named by activeUvSet and need not be the first.
    Scene scene;
    int activeUvSet = 0;
    //! Per UV set: the length in texture space of one unit of the solver, in which the mesh has area pi. So
    //! texture = scale * solver, without an offset; see makeSnapshot().
    std::vector<double> uvScales;
    Seams seams;
    Constraints constraints;
    IslandMarks marks;
    SolveSettings solveSettings;
    PackingSettings packingSettings;
    Selection selection;  //!< restored by undo, but not an edit
    QByteArray viewState; //!< opaque, written by the views; not an edit

    //! A document's state right after loading: no steering, default settings, at least one UV set.
    //! \pre scene.mesh is not null
    static DocumentState initial(Scene scene);

    //! Empty when all invariants hold, else the first broken one. Does not repeat MeshData::validate().
    QString validate() const;
};

//! True when all fields are equal, UVs and the mesh bit for bit. Scene::source is not compared: it is opaque,
//! and belongs to the format that wrote it.
bool operator==(const DocumentState &a, const DocumentState &b);

//! The name itself, or with a number behind it when another UV set has it already; shortened when it is
//! longer than names may be.
QString uniqueUvSetName(const std::vector<UvSet> &sets, const QString &wanted);

} // namespace autocuts
