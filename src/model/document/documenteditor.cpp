#include "model/document/documenteditor.h"

#include "model/document/weightedmesh.h"
#include "model/plain/texelweights.h"

#include <algorithm>
#include <cstring>

namespace autocuts {

namespace {

//! Writes values to the given elements of an array; returns the elements whose values changed.
template <typename T>
IndexRanges assign(std::vector<T> &array, const IndexRanges &indices, std::span<const T> values)
{
    IndexRanges changedIndices;
    std::size_t next = 0;
    indices.forEach([&](int index) {
        const T &value = values[next++];
        if (array[index] == value)
            return;
        array[index] = value;
        changedIndices.append(index);
    });
    return changedIndices;
}

int differences(const LayoutRectangle &a, const LayoutRectangle &b)
{
    return (a.lower != b.lower || a.upper != b.upper ? RectangleEvent::Bounds : 0) |
           (a.faces != b.faces ? RectangleEvent::Faces : 0) | (a.name != b.name ? RectangleEvent::Name : 0) |
           (a.color != b.color ? RectangleEvent::Color : 0) |
           (a.hard != b.hard || a.weight != b.weight ? RectangleEvent::Strength : 0);
}

} // namespace

void DocumentEditor::setSeamStates(const IndexRanges &cornerPairs, std::span<const PairState> values)
{
    IndexRanges changedPairs = assign(mState.seams.states, cornerPairs, values);
    if (changedPairs.isEmpty())
        return;
    mDocument.announce(SeamEvent(SeamEvent::State, std::move(changedPairs)));
}

void DocumentEditor::setSeamWeights(const IndexRanges &cornerPairs, std::span<const double> values)
{
    IndexRanges changedPairs = assign(mState.seams.weights, cornerPairs, values);
    if (changedPairs.isEmpty())
        return;
    mDocument.announce(SeamEvent(SeamEvent::Weight, std::move(changedPairs)));
}

void DocumentEditor::setSeamStraight(const IndexRanges &cornerPairs, std::span<const std::uint8_t> values)
{
    IndexRanges changedPairs = assign(mState.seams.straight, cornerPairs, values);
    if (changedPairs.isEmpty())
        return;
    mDocument.announce(SeamEvent(SeamEvent::Straight, std::move(changedPairs)));
}

void DocumentEditor::setPin(int corner, const std::optional<UvPin> &pin)
{
    std::vector<UvPin> &pins = mState.constraints.pins;
    const auto it = std::lower_bound(pins.begin(), pins.end(), corner,
                                     [](const UvPin &p, int c) { return p.corner < c; });
    const bool exists = it != pins.end() && it->corner == corner;
    if (pin && exists) {
        if (*it == *pin)
            return;
        *it = *pin;
    } else if (pin) {
        pins.insert(it, *pin);
    } else if (exists) {
        pins.erase(it);
    } else {
        return;
    }
    IndexRanges corners;
    corners.append(corner);
    mDocument.announce(PinEvent(std::move(corners)));
}

void DocumentEditor::setRectangle(int id, const std::optional<LayoutRectangle> &rectangle)
{
    std::vector<LayoutRectangle> &rectangles = mState.constraints.rectangles;
    const auto it = std::lower_bound(rectangles.begin(), rectangles.end(), id,
                                     [](const LayoutRectangle &r, int i) { return r.id < i; });
    const bool exists = it != rectangles.end() && it->id == id;
    int properties = 0;
    if (rectangle && exists) {
        properties = differences(*it, *rectangle);
        *it = *rectangle;
    } else if (rectangle) {
        properties = RectangleEvent::Added;
        rectangles.insert(it, *rectangle);
    } else if (exists) {
        properties = RectangleEvent::Removed;
        rectangles.erase(it);
    }
    if (properties == 0)
        return;
    mDocument.announce(RectangleEvent(id, properties));
}

void DocumentEditor::setFaceFlags(const IndexRanges &faces, std::span<const IslandFlags> values)
{
    int properties = 0;
    std::size_t next = 0;
    faces.forEach([&](int face) {
        const IslandFlags &before = mState.marks.faceFlags[face];
        const IslandFlags &after = values[next++];
        properties |= (before.locked != after.locked ? IslandFlagEvent::Locked : 0) |
                      (before.stack != after.stack ? IslandFlagEvent::Stack : 0) |
                      (before.group != after.group ? IslandFlagEvent::Group : 0) |
                      (before.upright != after.upright ? IslandFlagEvent::Upright : 0) |
                      (before.aligned != after.aligned ? IslandFlagEvent::Aligned : 0);
    });
    IndexRanges changedFaces = assign(mState.marks.faceFlags, faces, values);
    if (!changedFaces.isEmpty())
        mDocument.announce(IslandFlagEvent(properties, std::move(changedFaces)));
}

void DocumentEditor::setTexelWeights(const IndexRanges &faces, std::span<const double> values)
{
    std::vector<double> weights = mDocument.texelWeights();
    IndexRanges changedFaces = assign(weights, faces, values);
    if (changedFaces.isEmpty())
        return;
    mState.texelWeights = storedTexelWeights(std::move(weights));
    std::shared_ptr<const MeshData> &weighted = mDocument.mWeightedMesh;
    if (weighted && weighted != mState.scene.mesh && !mState.texelWeights.empty())
        weighted = reweighted(std::move(weighted), mState.scene.mesh, mState.texelWeights);
    else
        weighted.reset();
    mDocument.announce(TexelWeightEvent(std::move(changedFaces)));
}

void DocumentEditor::setTag(const QString &name, const QList<int> &faces)
{
    std::vector<IslandTag> &tags = mState.marks.tags;
    const auto it = std::lower_bound(tags.begin(), tags.end(), name,
                                     [](const IslandTag &t, const QString &n) { return t.name < n; });
    const bool exists = it != tags.end() && it->name == name;
    if (exists ? it->faces == faces : faces.isEmpty())
        return;
    if (!exists)
        tags.insert(it, IslandTag{name, faces});
    else if (faces.isEmpty())
        tags.erase(it);
    else
        it->faces = faces;
    mDocument.announce(TagEvent(name));
}

void DocumentEditor::setSolveSettings(const SolveSettings &settings)
{
    const int properties = differences(mState.solveSettings, settings);
    if (properties == 0)
        return;
    mState.solveSettings = settings;
    mDocument.announce(SolveSettingsEvent(properties));
}

void DocumentEditor::setPackingSettings(const PackingSettings &settings)
{
    const int properties = differences(mState.packingSettings, settings);
    if (properties == 0)
        return;
    mState.packingSettings = settings;
    mDocument.announce(PackingSettingsEvent(properties));
}

void DocumentEditor::setHiddenFaces(const QList<int> &faces)
{
    if (faces == mState.hiddenFaces)
        return;
    mState.hiddenFaces = faces;
    mDocument.findHidden();
    mDocument.announce(HiddenEvent());
    mDocument.setSelection(mState.selection);
}

void DocumentEditor::setTextureSets(const std::vector<TextureSet> &sets)
{
    if (sets == mState.textureSets)
        return;
    mState.textureSets = sets;
    mDocument.announce(TexturesEvent());
}

void DocumentEditor::setUniqueMeshes(bool unique)
{
    if (unique == mState.scene.uniqueMeshes)
        return;
    mState.scene.uniqueMeshes = unique;
    mDocument.announce(SharedMeshesEvent());
}

void DocumentEditor::setUvs(int uvSet, const IndexRanges &corners, const UvMatrix &values)
{
    UvMatrix &uv = mState.scene.uvSets[uvSet].uv;
    IndexRanges changedCorners;
    Eigen::Index row = 0;
    corners.forEach([&](int corner) {
        const double *value = values.data() + 2 * row++;
        double *target = uv.data() + 2 * Eigen::Index(corner);
        if (std::memcmp(target, value, 2 * sizeof(double)) == 0)
            return;
        std::memcpy(target, value, 2 * sizeof(double));
        changedCorners.append(corner);
    });
    if (changedCorners.isEmpty())
        return;
    if (uvSet == mState.activeUvSet)
        mDocument.forgetMap();
    mDocument.announce(UvEvent(uvSet, UvEvent::Values, std::move(changedCorners)));
}

void DocumentEditor::setUvScale(int uvSet, double scale)
{
    if (mState.uvScales[uvSet] == scale)
        return;
    mState.uvScales[uvSet] = scale;
    mDocument.announce(UvEvent(uvSet, UvEvent::Scale, {}));
}

void DocumentEditor::insertUvSet(int index, UvSet set, double scale)
{
    mState.scene.uvSets.insert(mState.scene.uvSets.begin() + index, std::move(set));
    mState.uvScales.insert(mState.uvScales.begin() + index, scale);
    if (index <= mState.activeUvSet)
        ++mState.activeUvSet;
    mDocument.announce(UvSetEvent(UvSetEvent::Change::Added, index));
}

void DocumentEditor::removeUvSet(int index)
{
    mState.scene.uvSets.erase(mState.scene.uvSets.begin() + index);
    mState.uvScales.erase(mState.uvScales.begin() + index);
    const bool wasActive = index == mState.activeUvSet;
    if (index < mState.activeUvSet || mState.activeUvSet == static_cast<int>(mDocument.uvSets().size()))
        --mState.activeUvSet;
    if (wasActive)
        mDocument.forgetMap();
    mDocument.announce(UvSetEvent(UvSetEvent::Change::Removed, index));
    if (wasActive)
        mDocument.announce(UvSetEvent(UvSetEvent::Change::Activated, mState.activeUvSet));
}

void DocumentEditor::renameUvSet(int index, const QString &name)
{
    if (mDocument.uvSets()[index].name == name)
        return;
    mState.scene.uvSets[index].name = name;
    mDocument.announce(UvSetEvent(UvSetEvent::Change::Renamed, index));
}

void DocumentEditor::setActiveUvSet(int index)
{
    if (index == mState.activeUvSet)
        return;
    mState.activeUvSet = index;
    mDocument.forgetMap();
    mDocument.announce(UvSetEvent(UvSetEvent::Change::Activated, index));
}

void DocumentEditor::exchangeModel(OtherModel &other)
{
    std::swap(mState, other.state);
    std::swap(mState.viewState, other.state.viewState);
    std::swap(mDocument.mAdjacency, other.adjacency);
    mDocument.forgetMap();
    mDocument.mWeightedMesh.reset();
    mDocument.findHidden();
    mDocument.announce(ModelEvent());
}

} // namespace autocuts
