// The setters of a document.
#pragma once

#include "model/document/document.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace autocuts {

//! Writes to a document. Only DocumentCommand, the base class of the commands, makes one. A setter emits
//! Document::changed() exactly when something changed. All indices must be in range and all values valid.
//! Values are given in the order of their indices.
class DocumentEditor final
{
public:
    void setUvs(int uvSet, const IndexRanges &corners, const UvMatrix &values);
    void setUvScale(int uvSet, double scale);
    void setSeamStates(const IndexRanges &cornerPairs, std::span<const PairState> values);
    void setSeamWeights(const IndexRanges &cornerPairs, std::span<const double> values);
    void setSeamStraight(const IndexRanges &cornerPairs, std::span<const std::uint8_t> values);
    void setPin(int corner, const std::optional<UvPin> &pin);
    void setRectangle(int id, const std::optional<LayoutRectangle> &rectangle);
    void setFaceFlags(const IndexRanges &faces, std::span<const IslandFlags> values);
    void setTexelWeights(const IndexRanges &faces, std::span<const double> values);
    //! Sets the faces of a tag; an empty list removes the tag.
    void setTag(const QString &name, const QList<int> &faces);
    //! Also takes the hidden elements out of the selection.
    void setHiddenFaces(const QList<int> &faces);
    void setTextureSets(const std::vector<TextureSet> &sets);
    void setUniqueMeshes(bool unique);
    void setSolveSettings(const SolveSettings &settings);
    void setPackingSettings(const PackingSettings &settings);
    void insertUvSet(int index, UvSet set, double scale);
    //! Removes a UV set; the active set stays active. When the active set is removed, the next one becomes
    //! active, or the last one when there is no next. \pre there are at least two UV sets
    void removeUvSet(int index);
    void renameUvSet(int index, const QString &name);
    void setActiveUvSet(int index);
    //! Another model with everything that belongs to it.
    struct OtherModel
    {
        DocumentState state; //!< valid
        //! Of its mesh; may be null. The contents of commands refer to it.
        std::unique_ptr<const MeshAdjacency> adjacency;
    };
    //! Exchanges everything but the view state.
    void exchangeModel(OtherModel &other);

private:
    friend class DocumentCommand;

    explicit DocumentEditor(Document &document) : mDocument(document), mState(document.mState) {}

    Document &mDocument;
    DocumentState &mState;
};

} // namespace autocuts
