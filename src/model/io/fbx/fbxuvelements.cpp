#include "model/io/fbx/fbxuvelements.h"

#include <algorithm>

namespace autocuts {

namespace {

constexpr std::string_view elementName = "LayerElementUV";
constexpr std::string_view perCorner = "ByPolygonVertex";
constexpr std::string_view indexed = "IndexToDirect";

QByteArray bytesOf(std::string_view text)
{
    return {text.data(), std::ssize(text)};
}

FbxNewNode leaf(std::string_view name, FbxNewValue value)
{
    return {bytesOf(name), {std::move(value)}, {}, false};
}

//! The entry of a layer that names a LayerElementUV.
FbxNewNode layerEntry(int index)
{
    return {"LayerElement",
            {},
            {leaf("Type", bytesOf(elementName)), leaf("TypedIndex", std::int32_t(index))},
            true};
}

} // namespace

FbxNewNode newUvElement(int index, const QString &name, FbxUvData data)
{
    FbxNewNode node{bytesOf(elementName), {std::int32_t(index)}, {}, true};
    node.children.push_back(leaf("Version", std::int32_t(101)));
    node.children.push_back(leaf("Name", name.toUtf8()));
    node.children.push_back(leaf("MappingInformationType", bytesOf(perCorner)));
    node.children.push_back(leaf("ReferenceInformationType", bytesOf(indexed)));
    node.children.push_back(leaf("UV", std::move(data.uv)));
    node.children.push_back(leaf("UVIndex", std::move(data.index)));
    return node;
}

FbxNewNode newUvLayer(int layer, int index)
{
    return {"Layer", {std::int32_t(layer)}, {leaf("Version", std::int32_t(100)), layerEntry(index)}, true};
}

FbxUvElements::FbxUvElements(const FbxTree &tree, int geometry, FbxEditor &editor)
    : mTree(tree), mGeometry(geometry), mEditor(editor)
{}

//! Replaces a child, or adds it at the end.
void FbxUvElements::setChild(int element, std::string_view name, FbxNewValue value)
{
    const int old = mTree.child(element, name);
    if (old >= 0)
        mEditor.replace(old, leaf(name, std::move(value)));
    else
        mEditor.append(element, leaf(name, std::move(value)));
}

void FbxUvElements::change(int element, Change change)
{
    if (mTree.nodes[static_cast<std::size_t>(element)].listEnd < 0) {
        if (change.data) {
            mEditor.replace(element, newUvElement(static_cast<int>(numberAfterGaps(element).value_or(0)),
                                                  change.name.value_or(QString()), std::move(*change.data)));
            mReplaced.push_back(element);
        }
        return;
    }
    if (change.name)
        setChild(element, "Name", change.name->toUtf8());
    if (!change.data)
        return;
    const auto setText = [&](std::string_view name, std::string_view text) {
        if (mTree.text(mTree.child(element, name)) != text)
            setChild(element, name, bytesOf(text));
    };
    setText("MappingInformationType", perCorner);
    setText("ReferenceInformationType", indexed);
    setChild(element, "UV", std::move(change.data->uv));
    setChild(element, "UVIndex", std::move(change.data->index));
}

bool FbxUvElements::isRemoved(std::int64_t number) const
{
    return std::any_of(mRemoved.begin(), mRemoved.end(),
                       [&](int removed) { return mTree.integer(removed).value_or(-1) == number; });
}

//! The number in a node, less one for each removed element of a lower number.
std::optional<std::int64_t> FbxUvElements::numberAfterGaps(int node) const
{
    const std::optional<std::int64_t> number = mTree.integer(node);
    if (!number)
        return {};
    return *number - std::count_if(mRemoved.begin(), mRemoved.end(), [&](int removed) {
        return mTree.integer(removed).value_or(-1) < *number;
    });
}

//! Takes out the removed elements and their entries in layers, and closes the gaps in the numbers of the
//! others.
void FbxUvElements::takeOut()
{
    if (mRemoved.empty())
        return;
    for (const int element : mRemoved)
        mEditor.remove(element);
    const auto renumber = [&](int node) {
        const std::optional<std::int64_t> number = numberAfterGaps(node);
        if (number && number != mTree.integer(node))
            mEditor.setInteger(node, static_cast<int>(*number));
    };
    const auto contains = [](const std::vector<int> &nodes, int node) {
        return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
    };
    for (int e = mTree.child(mGeometry, elementName); e >= 0; e = mTree.nextNamed(e)) {
        if (!contains(mRemoved, e) && !contains(mReplaced, e))
            renumber(e);
    }
    for (int layer = mTree.child(mGeometry, "Layer"); layer >= 0; layer = mTree.nextNamed(layer)) {
        for (int entry = mTree.child(layer, "LayerElement"); entry >= 0; entry = mTree.nextNamed(entry)) {
            const int index = mTree.child(entry, "TypedIndex");
            if (mTree.text(mTree.child(entry, "Type")) != elementName)
                continue;
            if (isRemoved(mTree.integer(index).value_or(-2)))
                mEditor.remove(entry);
            else if (index >= 0)
                renumber(index);
        }
    }
}

bool FbxUvElements::layerHasUv(int layer) const
{
    for (int entry = mTree.child(layer, "LayerElement"); entry >= 0; entry = mTree.nextNamed(entry)) {
        if (mTree.text(mTree.child(entry, "Type")) == elementName)
            return true;
    }
    return false;
}

//! The child of the geometry behind which new elements come.
int FbxUvElements::lastElement() const
{
    int last = mTree.child(mGeometry, "PolygonVertexIndex");
    for (int c = mTree.nodes[static_cast<std::size_t>(mGeometry)].firstChild; c >= 0;
         c = mTree.nodes[static_cast<std::size_t>(c)].next) {
        if (mTree.name(c).starts_with("LayerElement"))
            last = c;
    }
    return last;
}

//! One more than the highest number of the geometry's children of a name.
std::int64_t FbxUvElements::nextIndex(std::string_view name) const
{
    std::int64_t next = 0;
    for (int c = mTree.child(mGeometry, name); c >= 0; c = mTree.nextNamed(c))
        next = std::max(next, std::clamp<std::int64_t>(mTree.integer(c).value_or(0) + 1, 0, 1 << 30));
    return next;
}

//! Adds elements behind the others. The first one goes into the layer behind the last one that has UVs.
void FbxUvElements::insert(std::size_t first)
{
    const int after = lastElement();
    std::vector<int> layers;
    std::size_t layer = 0;
    for (int l = mTree.child(mGeometry, "Layer"); l >= 0; l = mTree.nextNamed(l)) {
        layers.push_back(l);
        if (layerHasUv(l))
            layer = layers.size();
    }
    int index = static_cast<int>(nextIndex(elementName));
    int layerIndex = static_cast<int>(nextIndex("Layer"));
    for (std::size_t a = first; a < mAdded.size(); ++a, ++index) {
        mEditor.insertAfter(after, newUvElement(index, *mAdded[a].name, std::move(*mAdded[a].data)));
        while (layer < layers.size() && mTree.nodes[static_cast<std::size_t>(layers[layer])].listEnd < 0)
            ++layer;
        if (layer < layers.size())
            mEditor.append(layers[layer++], layerEntry(index));
        else if (!layers.empty())
            mEditor.insertAfter(layers.back(), newUvLayer(layerIndex++, index));
        else
            mEditor.append(mGeometry, newUvLayer(layerIndex++, index));
    }
}

void FbxUvElements::finish()
{
    std::size_t placed = 0;
    while (placed < mAdded.size() && !mRemoved.empty()) {
        mChanges[mRemoved.front()] = std::move(mAdded[placed++]);
        mRemoved.erase(mRemoved.begin());
    }
    for (auto &[element, change] : mChanges)
        this->change(element, std::move(change));
    takeOut();
    if (placed < mAdded.size())
        insert(placed);
}

} // namespace autocuts
