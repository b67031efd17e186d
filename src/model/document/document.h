// The document: everything that is edited, its undo history, and the events that say what changed.
#pragma once

#include "model/document/changeevent.h"
#include "model/document/documentstate.h"
#include "model/document/result.h"
#include "model/plain/statetoken.h"
#include "model/document/undostack.h"
#include "model/plain/meshadjacency.h"

#include <QObject>

#include <memory>
#include <optional>
#include <span>

namespace autocuts {

class DocumentCommand;

//! Keeps a session's state. Whatever belongs to the work is changed by commands on the undo stack only: the
//! setters are private and reached through the commands' base class. A setter emits changed() when, and only
//! when, something changed, and says precisely what. Selection and view state are no edits and set directly.
class Document final : public QObject
{
    Q_OBJECT

public:
    //! A document for a model just loaded. \pre scene.mesh is not null
    explicit Document(Scene scene);
    //! A document that continues from a complete state, with an empty history. \pre
    //! state.validate().isEmpty()
    explicit Document(DocumentState state);
    //! The same for a state that may break an invariant: an error then.
    static Result<std::unique_ptr<Document>> create(DocumentState state);
    ~Document() override;

    //! Everything, for saving and comparing.
    const DocumentState &state() const { return mState; }
    const MeshData &mesh() const { return *mState.scene.mesh; }
    const std::vector<UvSet> &uvSets() const { return mState.scene.uvSets; }
    int activeUvSet() const { return mState.activeUvSet; }
    //! UVs of the active set, one row per corner, in texture space.
    const UvMatrix &uv() const { return uvSets()[activeUvSet()].uv; }
    //! Length in texture space of one unit of the solver, for the active set.
    double uvScale() const { return mState.uvScales[activeUvSet()]; }
    const Seams &seams() const { return mState.seams; }
    const Constraints &constraints() const { return mState.constraints; }
    const IslandMarks &marks() const { return mState.marks; }
    const SolveSettings &solveSettings() const { return mState.solveSettings; }
    const PackingSettings &packingSettings() const { return mState.packingSettings; }

    //! Islands of the active set; kept until the UVs change.
    const Islands &islands() const;
    //! Neighbours on the mesh; built on first use.
    const MeshAdjacency &adjacency() const;

    //! Of the present state. Every change gives it another one, undo too.
    const StateToken &token() const { return mToken; }

    UndoStack &undoStack() { return mUndoStack; }
    const UndoStack &undoStack() const { return mUndoStack; }

    const Selection &selection() const { return mState.selection; }
    //! Sorts the selection and drops what does not exist.
    void setSelection(Selection selection);
    const QByteArray &viewState() const { return mState.viewState; }
    void setViewState(QByteArray viewState) { mState.viewState = std::move(viewState); }

    //! Empty when all invariants hold, else the first broken one.
    QString validate() const;

Q_SIGNALS:
    void changed(const autocuts::ChangeEvent &event);
    void selectionChanged();

private:
    friend class DocumentCommand;

    // All indices must be in range and all values valid; values are given in the order of the indices.
    void setUvs(int uvSet, const IndexRanges &corners, const UvMatrix &values);
    void setUvScale(int uvSet, double scale);
    void setSeamStates(const IndexRanges &cornerPairs, std::span<const PairState> values);
    void setSeamWeights(const IndexRanges &cornerPairs, std::span<const double> values);
    void setPin(int corner, const std::optional<UvPin> &pin);
    void setRectangle(int id, const std::optional<LayoutRectangle> &rectangle);
    void setFaceFlags(const IndexRanges &faces, std::span<const IslandFlags> values);
    //! No faces: the tag is removed.
    void setTag(const QString &name, const QList<int> &faces);
    void setSolveSettings(const SolveSettings &settings);
    void setPackingSettings(const PackingSettings &settings);
    void insertUvSet(int index, UvSet set, double scale);
    //! \pre there are at least two UV sets. The active one stays active; when it is the one removed, the one
    //! that takes its place, or else the last one, becomes active.
    void removeUvSet(int index);
    void renameUvSet(int index, const QString &name);
    void setActiveUvSet(int index);
    //! Renews the token and emits changed().
    void announce(const ChangeEvent &event);

    DocumentState mState;
    UndoStack mUndoStack;
    StateToken mToken;
    mutable std::unique_ptr<const Islands> mIslands;
    mutable std::unique_ptr<const MeshAdjacency> mAdjacency;
};

} // namespace autocuts
