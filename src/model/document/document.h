// The document: the state that users edit, its undo history, and the events that report changes.
#pragma once

#include "model/document/changeevent.h"
#include "model/document/documentstate.h"
#include "model/document/result.h"
#include "model/document/undostack.h"
#include "model/plain/meshadjacency.h"
#include "model/plain/statetoken.h"
#include "model/plain/uvseams.h"

#include <QObject>

#include <memory>
#include <optional>

namespace autocuts {

class DocumentEditor;

//! Holds the state of a session. Only commands on the undo stack change it, through DocumentEditor. Selection
//! and view state do not count as edits and can be set directly.
class Document final : public QObject
{
    Q_OBJECT

public:
    //! A document for a newly loaded model. \pre scene.mesh is not null
    explicit Document(Scene scene);
    //! A document with a complete state and an empty history. \pre state.validate().isEmpty()
    explicit Document(DocumentState state);
    //! The same for a state that may violate an invariant: then an error.
    static Result<std::unique_ptr<Document>> create(DocumentState state);
    ~Document() override;

    //! The complete state, for saving and comparing.
    const DocumentState &state() const { return mState; }
    const MeshData &mesh() const { return *mState.scene.mesh; }
    const std::vector<UvSet> &uvSets() const { return mState.scene.uvSets; }
    int activeUvSet() const { return mState.activeUvSet; }
    //! The UVs of the active set, one row per corner, in texture space.
    const UvMatrix &uv() const { return uvSets()[activeUvSet()].uv; }
    //! Length in texture space of one solver unit, for the active set.
    double uvScale() const { return mState.uvScales[activeUvSet()]; }
    const Seams &seams() const { return mState.seams; }
    const Constraints &constraints() const { return mState.constraints; }
    const IslandMarks &marks() const { return mState.marks; }
    //! The painted texel weights, one per face.
    std::vector<double> texelWeights() const;
    //! The mesh with the painted texel weights, for all that makes or judges maps; state().scene.mesh when
    //! none are painted. Cached until they change.
    const std::shared_ptr<const MeshData> &weightedMesh() const;
    //! Per face: it is neither shown nor selected; empty when none is hidden.
    const std::vector<bool> &hidden() const { return mHidden; }
    const SolveSettings &solveSettings() const { return mState.solveSettings; }
    const PackingSettings &packingSettings() const { return mState.packingSettings; }

    //! The islands of the active set, cached until the UVs change.
    const Islands &islands() const;
    //! The map of the active set triangle by triangle, cached until the UVs change.
    const SoupMap &soupMap() const;
    //! The given seams of the active set, per edge pair, cached until they may change; empty for
    //! SeamMode::Free.
    const std::vector<bool> &givenSeams() const;
    //! The adjacency of the mesh, built on first use.
    const MeshAdjacency &adjacency() const;

    //! The token of the current state. Every change gives it a new value, including undo.
    const StateToken &token() const { return mToken; }

    UndoStack &undoStack() { return mUndoStack; }
    const UndoStack &undoStack() const { return mUndoStack; }

    const Selection &selection() const { return mState.selection; }
    //! Sorts the selection and removes elements that do not exist or are hidden.
    void setSelection(Selection selection);
    const QByteArray &viewState() const { return mState.viewState; }
    void setViewState(QByteArray viewState) { mState.viewState = std::move(viewState); }

    //! Returns an empty string, or the first invariant that does not hold.
    QString validate() const;

Q_SIGNALS:
    void changed(const autocuts::ChangeEvent &event);
    void selectionChanged();

private:
    friend class DocumentEditor;

    //! Renews the token and emits changed().
    void announce(const ChangeEvent &event);

    void findHidden();
    void forgetMap();

    DocumentState mState;
    std::vector<bool> mHidden; //!< DocumentState::hiddenFaces
    UndoStack mUndoStack;
    StateToken mToken;
    mutable std::unique_ptr<const Islands> mIslands;
    mutable std::unique_ptr<const SoupMap> mSoupMap;
    mutable std::shared_ptr<const MeshData> mWeightedMesh;
    mutable std::optional<std::vector<bool>> mGivenSeams;
    mutable std::unique_ptr<const MeshAdjacency> mAdjacency;
};

} // namespace autocuts
