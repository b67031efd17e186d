#include "link/linkmarks.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace autocuts::link {

using namespace Qt::Literals::StringLiterals;

namespace {

const QString cutsName = u"cuts"_s, uncutsName = u"uncuts"_s, pinsName = u"pins"_s, pinUvsName = u"pinUvs"_s,
              unpinsName = u"unpins"_s, facesName = u"selection"_s;

template <class T>
void sortUnique(T &values)
{
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

template <class T>
std::vector<T> without(const std::vector<T> &values, const std::vector<T> &others)
{
    std::vector<T> result;
    std::ranges::set_difference(values, others, std::back_inserter(result));
    return result;
}

std::vector<int> cornersOf(const std::vector<LinkPin> &pins)
{
    std::vector<int> corners;
    std::ranges::transform(pins, std::back_inserter(corners), &LinkPin::corner);
    return corners;
}

Result<std::vector<int>> readIndices(const Message &message, const QString &name, int columns, int count)
{
    Result<std::vector<int>> read = message.integers(name, columns);
    if (!read)
        return read;
    const std::vector<int> &values = read.value();
    const auto bad = std::ranges::find_if(values, [count](int i) { return i < 0 || i >= count; });
    if (bad != values.end())
        return linkError(u"the array \"%1\" has %2, which the mesh does not have"_s.arg(name).arg(*bad));
    return read;
}

Result<std::vector<int>> readIndexSet(const Message &message, const QString &name, int count)
{
    Result<std::vector<int>> read = readIndices(message, name, 1, count);
    if (read)
        sortUnique(read.value());
    return read;
}

Result<std::vector<VertexPair>> readEdges(const Message &message, const QString &name, int vertices)
{
    const Result<std::vector<int>> ends = readIndices(message, name, 2, vertices);
    if (!ends)
        return ends.error();
    std::vector<VertexPair> edges;
    for (std::size_t i = 0; i < ends->size(); i += 2) {
        const auto [low, high] = std::minmax(ends.value()[i], ends.value()[i + 1]);
        edges.push_back({low, high});
    }
    sortUnique(edges);
    return edges;
}

Result<std::vector<LinkPin>> readPins(const Message &message, int corners)
{
    const Result<std::vector<int>> at = readIndices(message, pinsName, 1, corners);
    if (!at)
        return at.error();
    const Result<std::vector<double>> uvs = message.numbers(pinUvsName, 2);
    if (!uvs)
        return uvs.error();
    if (uvs->size() != 2 * at->size())
        return linkError(u"the arrays \"pins\" and \"pinUvs\" do not fit each other"_s);
    std::vector<LinkPin> pins;
    for (std::size_t i = 0; i < at->size(); ++i)
        pins.push_back({at.value()[i], float(uvs.value()[2 * i]), float(uvs.value()[2 * i + 1])});
    if (!std::ranges::all_of(pins, [](const LinkPin &p) { return std::isfinite(p.u) && std::isfinite(p.v); }))
        return linkError(u"a pin has no place"_s);
    std::ranges::sort(pins);
    const auto same = std::ranges::unique(pins, {}, &LinkPin::corner);
    pins.erase(same.begin(), same.end());
    return pins;
}

void writeEdges(Message &message, const QString &name, const std::vector<VertexPair> &edges)
{
    std::vector<int> ends;
    for (const VertexPair &edge : edges)
        ends.insert(ends.end(), edge.begin(), edge.end());
    if (!ends.empty())
        message.add(name, std::span<const int>(ends), 2);
}

void writePins(Message &message, const std::vector<LinkPin> &pins)
{
    std::vector<double> uvs;
    for (const LinkPin &pin : pins)
        uvs.insert(uvs.end(), {pin.u, pin.v});
    message.add(pinsName, std::span<const int>(cornersOf(pins)));
    message.add(pinUvsName, std::span<const double>(uvs), 2);
}

} // namespace

void MarkChanges::writeTo(Message &message) const
{
    writeEdges(message, cutsName, cuts);
    writeEdges(message, uncutsName, uncuts);
    if (!pins.empty())
        writePins(message, pins);
    if (!unpins.empty())
        message.add(unpinsName, std::span<const int>(unpins));
    if (faces)
        message.add(facesName, std::span(faces->constData(), std::size_t(faces->size())));
}

Result<MarkChanges> MarkChanges::read(const Message &message, int vertices, int corners, int faces)
{
    Result<std::vector<VertexPair>> cuts = readEdges(message, cutsName, vertices);
    if (!cuts)
        return cuts.error();
    Result<std::vector<VertexPair>> uncuts = readEdges(message, uncutsName, vertices);
    if (!uncuts)
        return uncuts.error();
    Result<std::vector<LinkPin>> pins = readPins(message, corners);
    if (!pins)
        return pins.error();
    Result<std::vector<int>> unpins = readIndexSet(message, unpinsName, corners);
    if (!unpins)
        return unpins.error();
    const Result<std::vector<int>> chosen = readIndexSet(message, facesName, faces);
    if (!chosen)
        return chosen.error();
    MarkChanges changes{std::move(cuts).value(), std::move(uncuts).value(), std::move(pins).value(),
                        std::move(unpins).value(), std::nullopt};
    if (message.has(facesName))
        changes.faces = QList<int>(chosen->begin(), chosen->end());
    return changes;
}

void Marks::apply(const MarkChanges &changes)
{
    std::vector<VertexPair> edges = without(cuts, changes.uncuts);
    edges.insert(edges.end(), changes.cuts.begin(), changes.cuts.end());
    sortUnique(edges);
    cuts = std::move(edges);
    std::vector<int> gone = cornersOf(changes.pins);
    gone.insert(gone.end(), changes.unpins.begin(), changes.unpins.end());
    std::ranges::sort(gone);
    std::erase_if(pins, [&](const LinkPin &pin) { return std::ranges::binary_search(gone, pin.corner); });
    pins.insert(pins.end(), changes.pins.begin(), changes.pins.end());
    std::ranges::sort(pins);
    faces = changes.faces.value_or(faces);
}

MarkChanges Marks::changesTo(const Marks &other) const
{
    MarkChanges changes{without(other.cuts, cuts), without(cuts, other.cuts), without(other.pins, pins),
                        without(cornersOf(pins), cornersOf(other.pins)), std::nullopt};
    if (faces != other.faces)
        changes.faces = other.faces;
    return changes;
}

} // namespace autocuts::link
