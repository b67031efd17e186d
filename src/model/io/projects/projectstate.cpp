#include "model/io/projects/projectstate.h"

#include "model/document/bitmap.h"
#include "model/document/cborvalues.h"
#include "model/document/uvsetnames.h"
#include "model/io/projects/packedarrays.h"
#include "model/io/projects/projectseams.h"
#include "model/plain/texelweights.h"
#include "model/plain/uvlayout.h"

#include <QCborArray>

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! A block of a UV set is named by this prefix and the number of the set.
constexpr auto uvPrefix = "uv."_L1;
constexpr int largestUvSet = 9999;

QByteArray uvPartName(int index)
{
    return QByteArray(uvPrefix.data()) + QByteArray::number(index);
}

//! All corners, grouped by vertex, so that corners of one UV vertex follow each other.
std::vector<int> cornersByVertex(const MeshData &mesh)
{
    std::vector<int> next(static_cast<std::size_t>(mesh.vertexCount()) + 1, 0);
    for (int vertex : mesh.cornerVertex)
        ++next[static_cast<std::size_t>(vertex) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<int> order(static_cast<std::size_t>(mesh.cornerCount()));
    for (int c = 0; c < mesh.cornerCount(); ++c)
        order[static_cast<std::size_t>(next[static_cast<std::size_t>(mesh.cornerVertex[c])]++)] = c;
    return order;
}

//! Stores a UV set. "repeats" has one bit per corner in the order of cornersByVertex(): the UV equals that of
//! the previous corner. "u" and "v" hold all other UVs.
QCborMap uvSetMap(const MeshData &mesh, const UvSet &set, double scale)
{
    QByteArray repeats(bitmapSize(mesh.cornerCount()), '\0');
    std::vector<double> u, v;
    const double *before = nullptr;
    int position = 0;
    for (int corner : cornersByVertex(mesh)) {
        const double *row = set.uv.data() + 2 * Eigen::Index(corner);
        if (before && std::memcmp(before, row, 2 * sizeof(double)) == 0) {
            setBit(repeats, position);
        } else {
            u.push_back(row[0]);
            v.push_back(row[1]);
        }
        before = row;
        ++position;
    }
    return {{"name"_L1, set.name},
            {"scale"_L1, scale},
            {"repeats"_L1, repeats},
            {"u"_L1, packedArray(u)},
            {"v"_L1, packedArray(v)}};
}

bool readUvs(CborReader &reader, const MeshData &mesh, UvMatrix &uv)
{
    const QByteArray repeats = reader.bytes("repeats"_L1);
    const QByteArray packedU = reader.bytes("u"_L1);
    const auto u = unpackedDoubles(packedU, packedDoubleCount(packedU));
    const auto v = unpackedDoubles(reader.bytes("v"_L1), packedDoubleCount(packedU));
    if (reader.failed() || !u || !v || repeats.size() != bitmapSize(mesh.cornerCount()))
        return false;
    uv.resize(mesh.cornerCount(), 2);
    std::size_t next = 0;
    int position = 0;
    for (int corner : cornersByVertex(mesh)) {
        const bool repeated = bitAt(repeats, position);
        ++position;
        next += !repeated;
        if (next == 0 || next > u->size())
            return false;
        // Copied as bytes, because some processors change the bits of a NaN when they move it.
        std::memcpy(uv.data() + 2 * Eigen::Index(corner), &(*u)[next - 1], sizeof(double));
        std::memcpy(uv.data() + 2 * Eigen::Index(corner) + 1, &(*v)[next - 1], sizeof(double));
    }
    return next == u->size();
}

QByteArray cborBytes(const QCborMap &map)
{
    return map.toCborValue().toCbor();
}

QCborMap constraintsMap(const Constraints &constraints)
{
    QCborArray pins, rectangles;
    for (const UvPin &pin : constraints.pins)
        pins.append(toCbor(pin));
    for (const LayoutRectangle &rectangle : constraints.rectangles)
        rectangles.append(toCbor(rectangle));
    return {{"pins"_L1, pins}, {"rectangles"_L1, rectangles}};
}

bool readConstraints(CborReader &reader, DocumentState &state)
{
    const MeshData &mesh = *state.scene.mesh;
    Constraints constraints;
    for (const QCborMap &map : reader.maps("pins"_L1)) {
        CborReader pin(map);
        constraints.pins.push_back(readPin(pin, mesh));
        if (pin.failed())
            return false;
    }
    for (const QCborMap &map : reader.maps("rectangles"_L1)) {
        CborReader rectangle(map);
        constraints.rectangles.push_back(readRectangle(rectangle, mesh));
        if (rectangle.failed())
            return false;
    }
    if (reader.failed() || !constraints.validate(mesh).isEmpty())
        return false;
    state.constraints = std::move(constraints);
    return true;
}

//! Stores the faces with flags in "faces", three numbers for each in "flags", those that keep their
//! orientation in "upright", those that were aligned to the axes in "aligned", and the hidden faces in
//! "hidden" when there are any.
QCborMap marksMap(const DocumentState &state)
{
    const IslandMarks &marks = state.marks;
    std::vector<int> faces, flags;
    QList<int> upright, aligned;
    for (std::size_t f = 0; f < marks.faceFlags.size(); ++f) {
        const IslandFlags &face = marks.faceFlags[f];
        if (face == IslandFlags())
            continue;
        faces.push_back(static_cast<int>(f));
        flags.insert(flags.end(), {face.locked, face.stack, face.group});
        if (face.upright != 0)
            upright.append(static_cast<int>(f));
        if (face.aligned != 0)
            aligned.append(static_cast<int>(f));
    }
    QCborArray tags;
    for (const IslandTag &tag : marks.tags)
        tags.append(QCborMap{{"name"_L1, tag.name}, {"faces"_L1, packedIntegers(tag.faces)}});
    QCborMap map{{"faces"_L1, packedArray(faces)},
                 {"flags"_L1, packedArray(flags)},
                 {"upright"_L1, packedIntegers(upright)},
                 {"tags"_L1, tags}};
    if (!aligned.isEmpty())
        map["aligned"_L1] = packedIntegers(aligned);
    if (!state.hiddenFaces.isEmpty())
        map["hidden"_L1] = packedIntegers(state.hiddenFaces);
    return map;
}

bool readMarks(CborReader &reader, DocumentState &state)
{
    const MeshData &mesh = *state.scene.mesh;
    IslandMarks marks = IslandMarks::none(mesh);
    const QByteArray packedFaces = reader.bytes("faces"_L1);
    const qsizetype count = packedIntegerCount(packedFaces);
    const auto faces = unpackedIntegers(packedFaces, count);
    const auto flags = unpackedIntegers(reader.bytes("flags"_L1), 3 * count);
    if (reader.failed() || !faces || !flags)
        return false;
    for (std::size_t i = 0; i < faces->size(); ++i) {
        if ((*faces)[i] < 0 || (*faces)[i] >= mesh.faceCount())
            return false;
        const int locked = (*flags)[3 * i];
        if (locked < 0 || locked > 1)
            return false;
        marks.faceFlags[static_cast<std::size_t>((*faces)[i])] = {.locked = static_cast<std::int16_t>(locked),
                                                                  .stack = (*flags)[3 * i + 1],
                                                                  .group = (*flags)[3 * i + 2]};
    }
    if (reader.contains("upright"_L1)) {
        for (const int face : reader.indexSet("upright"_L1, mesh.faceCount()))
            marks.faceFlags[static_cast<std::size_t>(face)].upright = 1;
    }
    if (reader.contains("aligned"_L1)) {
        for (const int face : reader.indexSet("aligned"_L1, mesh.faceCount()))
            marks.faceFlags[static_cast<std::size_t>(face)].aligned = 1;
    }
    for (const QCborMap &map : reader.maps("tags"_L1)) {
        CborReader tag(map);
        marks.tags.push_back({tag.text("name"_L1), tag.indexSet("faces"_L1, mesh.faceCount())});
        if (tag.failed())
            return false;
    }
    QList<int> hidden;
    if (reader.contains("hidden"_L1))
        hidden = reader.indexSet("hidden"_L1, mesh.faceCount());
    if (reader.failed() || !marks.validate(mesh).isEmpty())
        return false;
    state.marks = std::move(marks);
    state.hiddenFaces = hidden;
    return true;
}

//! Stores the faces with a texel weight other than 1 in "faces", and their weights in "weights".
QCborMap texelWeightsMap(const std::vector<double> &texelWeights)
{
    std::vector<int> faces;
    std::vector<double> weights;
    for (std::size_t f = 0; f < texelWeights.size(); ++f) {
        if (texelWeights[f] == 1)
            continue;
        faces.push_back(static_cast<int>(f));
        weights.push_back(texelWeights[f]);
    }
    return {{"faces"_L1, packedArray(faces)}, {"weights"_L1, packedArray(weights)}};
}

bool readTexelWeights(CborReader &reader, DocumentState &state)
{
    const int faceCount = state.scene.mesh->faceCount();
    const QByteArray packedFaces = reader.bytes("faces"_L1);
    const qsizetype count = packedIntegerCount(packedFaces);
    const auto faces = unpackedIntegers(packedFaces, count);
    const auto weights = unpackedDoubles(reader.bytes("weights"_L1), count);
    if (reader.failed() || !faces || !weights)
        return false;
    std::vector<double> texelWeights(static_cast<std::size_t>(faceCount), 1.0);
    for (std::size_t i = 0; i < faces->size(); ++i) {
        if ((*faces)[i] < 0 || (*faces)[i] >= faceCount)
            return false;
        texelWeights[static_cast<std::size_t>((*faces)[i])] = (*weights)[i];
    }
    texelWeights = storedTexelWeights(std::move(texelWeights));
    if (!areTexelWeights(texelWeights, faceCount))
        return false;
    state.texelWeights = std::move(texelWeights);
    return true;
}

bool readTexturePart(CborReader &reader, DocumentState &state)
{
    const auto sets = readTextureSets(reader.array("sets"_L1), state.scene.materialNames.size() + 1);
    if (reader.failed() || !sets)
        return false;
    state.textureSets = withoutEmptyEnd(*sets);
    return true;
}

bool readSettings(CborReader &reader, DocumentState &state)
{
    CborReader solve(reader.map("solve"_L1));
    CborReader packing(reader.map("packing"_L1));
    const SolveSettings solveSettings = readSolveSettings(solve);
    const PackingSettings packingSettings = readPackingSettings(packing);
    if (reader.failed() || solve.failed() || packing.failed())
        return false;
    state.solveSettings = solveSettings;
    state.packingSettings = packingSettings;
    return true;
}

bool readSelectionPart(CborReader &reader, DocumentState &state)
{
    Selection selection = readSelection(reader, *state.scene.mesh);
    if (reader.failed())
        return false;
    state.selection = std::move(selection);
    return true;
}

//! Adds the UV set of a block; false when it is damaged.
bool readUvSet(const QByteArray &part, DocumentState &state, UvSetNames &names)
{
    const std::optional<QCborMap> map = parsedMap(part);
    if (!map)
        return false;
    CborReader reader(*map);
    UvSet set;
    set.name = reader.text("name"_L1);
    const double scale =
        reader.number("scale"_L1, std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
    if (!readUvs(reader, *state.scene.mesh, set.uv) || set.name.isEmpty())
        return false;
    set.name = names.take(set.name);
    state.scene.uvSets.push_back(std::move(set));
    state.uvScales.push_back(scale);
    return true;
}

//! The numbers of the UV sets that have a block, ascending.
std::vector<int> uvSetsIn(const PartMap &parts, LostParts &lost)
{
    std::vector<int> result;
    for (const auto &[name, content] : parts) {
        if (!isUvPart(name))
            continue;
        bool ok = false;
        const int index = name.mid(uvPrefix.size()).toInt(&ok);
        if (ok && index >= 0 && index <= largestUvSet && name == uvPartName(index))
            result.push_back(index);
        else
            lost.names << u"a UV set with an impossible number"_s;
    }
    std::sort(result.begin(), result.end());
    return result;
}

void readUvSets(const PartMap &parts, DocumentState &state, LostParts &lost)
{
    int count = -1;
    int active = 0;
    if (const auto index = parts.find("uvSets"); index != parts.end()) {
        CborReader reader(parsedMap(index->second).value_or(QCborMap()));
        count = static_cast<int>(reader.integer("count"_L1, 1, std::numeric_limits<int>::max()));
        active = static_cast<int>(reader.integer("active"_L1, 0, count - 1));
        if (reader.failed())
            count = -1;
    }
    if (count < 0)
        lost.names << u"the list of UV sets"_s;
    state.scene.uvSets.clear();
    state.uvScales.clear();
    state.activeUvSet = 0;
    int next = 0;
    UvSetNames names;
    for (int index : uvSetsIn(parts, lost)) {
        if (!readUvSet(parts.at(uvPartName(index)), state, names))
            continue;
        if (index > next)
            lost.names << u"the UV sets before \"%1\""_s.arg(state.scene.uvSets.back().name);
        next = index + 1;
        if (index == active)
            state.activeUvSet = static_cast<int>(state.scene.uvSets.size()) - 1;
    }
    if (next < count || next == 0)
        lost.names << (next == 0 ? u"the UV sets"_s : u"the last UV sets"_s);
    if (state.scene.uvSets.empty()) {
        state.scene.uvSets.push_back({u"UVMap"_s, emptyLayout(*state.scene.mesh)});
        state.uvScales.push_back(defaultUvScale);
    }
}

} // namespace

bool isUvPart(const QByteArray &name)
{
    return name.startsWith(uvPrefix.data());
}

std::optional<QCborMap> parsedMap(const QByteArray &bytes)
{
    QCborParserError error;
    const QCborValue value = QCborValue::fromCbor(bytes, &error);
    if (error.error != QCborError::NoError || !value.isMap())
        return std::nullopt;
    return value.toMap();
}

PartMap statePartsOf(const DocumentState &state, StateScope scope)
{
    const MeshData &mesh = *state.scene.mesh;
    PartMap parts;
    const int count = static_cast<int>(state.scene.uvSets.size());
    parts["uvSets"] = cborBytes({{"count"_L1, count}, {"active"_L1, state.activeUvSet}});
    for (int i = 0; i < count; ++i)
        parts[uvPartName(i)] = cborBytes(uvSetMap(mesh, state.scene.uvSets[i], state.uvScales[i]));
    parts["seams"] = cborBytes(seamsToCbor(state.seams, mesh));
    parts["constraints"] = cborBytes(constraintsMap(state.constraints));
    parts["marks"] = cborBytes(marksMap(state));
    if (!state.texelWeights.empty())
        parts["texelWeights"] = cborBytes(texelWeightsMap(state.texelWeights));
    if (!state.textureSets.empty())
        parts["textures"] = cborBytes({{"sets"_L1, toCbor(state.textureSets)}});
    parts["settings"] =
        cborBytes({{"solve"_L1, toCbor(state.solveSettings)}, {"packing"_L1, toCbor(state.packingSettings)}});
    if (scope == StateScope::Session) {
        parts["selection"] = cborBytes(toCbor(state.selection, mesh));
        parts["view"] = state.viewState;
    }
    return parts;
}

LostParts readStateParts(const PartMap &parts, StateScope scope, DocumentState &state)
{
    LostParts lost;
    const auto read = [&](const char *name, const QString &word, auto readPart) {
        const auto part = parts.find(name);
        const std::optional<QCborMap> map = part == parts.end() ? std::nullopt : parsedMap(part->second);
        CborReader reader(map.value_or(QCborMap()));
        if (!map || !readPart(reader, state))
            lost.names << word;
    };
    state.seams = Seams::allFree(*state.scene.mesh);
    state.marks = IslandMarks::none(*state.scene.mesh);
    readUvSets(parts, state, lost);
    read("seams", u"the seams"_s, [&](CborReader &reader, DocumentState &s) {
        return readSeams(reader, *s.scene.mesh, s.seams, lost.seams);
    });
    read("constraints", u"the pins and rectangles"_s, readConstraints);
    read("marks", u"the marks of the islands"_s, readMarks);
    if (parts.contains("texelWeights")) // only where faces have one
        read("texelWeights", u"the painted texel density"_s, readTexelWeights);
    if (parts.contains("textures")) // only where the user chose some
        read("textures", u"the texture sets"_s, readTexturePart);
    read("settings", u"the settings"_s, readSettings);
    if (scope == StateScope::Journal)
        return lost;
    read("selection", u"the selection"_s, readSelectionPart);
    if (const auto view = parts.find("view"); view != parts.end())
        state.viewState = view->second;
    else
        lost.names << u"the view"_s;
    return lost;
}

} // namespace autocuts
