// The setters of a document that steer the solve: seams, pins, rectangles, marks and settings.
#include "model/document/document.h"

#include "model/plain/texelweights.h"

#include <algorithm>

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

void Document::setSeamStates(const IndexRanges &cornerPairs, std::span<const PairState> values)
{
    IndexRanges changedPairs = assign(mState.seams.states, cornerPairs, values);
    if (changedPairs.isEmpty())
        return;
    announce(SeamEvent(SeamEvent::State, std::move(changedPairs)));
}

void Document::setSeamWeights(const IndexRanges &cornerPairs, std::span<const double> values)
{
    IndexRanges changedPairs = assign(mState.seams.weights, cornerPairs, values);
    if (changedPairs.isEmpty())
        return;
    announce(SeamEvent(SeamEvent::Weight, std::move(changedPairs)));
}

void Document::setSeamStraight(const IndexRanges &cornerPairs, std::span<const std::uint8_t> values)
{
    IndexRanges changedPairs = assign(mState.seams.straight, cornerPairs, values);
    if (changedPairs.isEmpty())
        return;
    announce(SeamEvent(SeamEvent::Straight, std::move(changedPairs)));
}

void Document::setPin(int corner, const std::optional<UvPin> &pin)
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
    announce(PinEvent(std::move(corners)));
}

void Document::setRectangle(int id, const std::optional<LayoutRectangle> &rectangle)
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
    announce(RectangleEvent(id, properties));
}

void Document::setFaceFlags(const IndexRanges &faces, std::span<const IslandFlags> values)
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
        announce(IslandFlagEvent(properties, std::move(changedFaces)));
}

void Document::setTexelWeights(const IndexRanges &faces, std::span<const double> values)
{
    std::vector<double> weights = texelWeights();
    IndexRanges changedFaces = assign(weights, faces, values);
    if (changedFaces.isEmpty())
        return;
    mState.texelWeights = storedTexelWeights(std::move(weights));
    mWeightedMesh.reset();
    announce(TexelWeightEvent(std::move(changedFaces)));
}

void Document::setTag(const QString &name, const QList<int> &faces)
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
    announce(TagEvent(name));
}

void Document::setSolveSettings(const SolveSettings &settings)
{
    const int properties = autocuts::differences(mState.solveSettings, settings);
    if (properties == 0)
        return;
    mState.solveSettings = settings;
    announce(SolveSettingsEvent(properties));
}

void Document::setPackingSettings(const PackingSettings &settings)
{
    const int properties = autocuts::differences(mState.packingSettings, settings);
    if (properties == 0)
        return;
    mState.packingSettings = settings;
    announce(PackingSettingsEvent(properties));
}

} // namespace autocuts
