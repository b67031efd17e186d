// The complete state of a session as one plain value, as project files store it and tests compare it.
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

//! The complete state of a Document. The steering (seams, constraints, marks, texel
//! weights) is shared by all UV sets.
struct DocumentState
{
    //! The model. Its UV sets are in the order of the file. In a scene without a document the first UV set is
    //! the active one; here activeUvSet says which one is.
    Scene scene;
    int activeUvSet = 0;
    //! For each UV set, the length in texture space of one solver unit (the mesh has area pi in solver
    //! units): texture = scale * solver, without an offset. See makeSnapshot().
    std::vector<double> uvScales;
    Seams seams;
    Constraints constraints;
    IslandMarks marks;
    //! The painted texel weights, see MeshData::texelWeight; empty when all are 1.
    std::vector<double> texelWeights;
    //! Faces that the views neither show nor select, strictly ascending. Jobs work on them as on all others.
    QList<int> hiddenFaces;
    //! The pictures that the user chose, in place of those of the model's file: first of the faces without a
    //! material, then of each material. May be shorter; the last one is not empty.
    std::vector<TextureSet> textureSets;
    SolveSettings solveSettings;
    PackingSettings packingSettings;
    Selection selection;  //!< restored by undo, but changing it is not an edit
    QByteArray viewState; //!< opaque data of the views; changing it is not an edit

    //! The state right after loading: no steering, default settings, at least one UV set.
    //! \pre scene.mesh is not null
    static DocumentState initial(Scene scene);

    //! The pictures of a material, those of the user in place of those of the file. \param material -1: of
    //! the faces without one
    TextureSet textureSet(int material) const;
    //! Returns an empty string, or the first invariant that does not hold. Does not repeat
    //! MeshData::validate().
    QString validate() const;
};

//! True when all fields are equal, UVs and the mesh bit for bit. Scene::source is not compared: it is opaque
//! data of the file format that wrote it.
bool operator==(const DocumentState &a, const DocumentState &b);

//! The name itself, or with a number appended when another UV set has it already. Shortened when it would be
//! longer than maxNameLength.
QString uniqueUvSetName(const std::vector<UvSet> &sets, const QString &wanted);

} // namespace autocuts
