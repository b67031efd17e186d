#include "model/document/cborvalues.h"

#include "model/plain/polygonsides.h"
#include "model/plain/settingsproperties.h"

#include <QCborArray>
#include <QtEndian>

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double largest = std::numeric_limits<double>::max();

std::vector<int> unpackedIntegers(const QByteArray &bytes)
{
    std::vector<int> values(bytes.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = qFromLittleEndian<qint32>(bytes.constData() + 4 * i);
    return values;
}

} // namespace

QCborValue CborReader::value(QLatin1StringView key, QCborValue::Type type)
{
    const QCborValue found = mMap.value(key);
    if (found.type() != type)
        mFailed = true;
    return mFailed ? QCborValue() : found;
}

qint64 CborReader::integer(QLatin1StringView key, qint64 low, qint64 high)
{
    const qint64 result = value(key, QCborValue::Integer).toInteger();
    if (!mFailed && (result < low || result > high))
        mFailed = true;
    return mFailed ? low : result;
}

bool CborReader::boolean(QLatin1StringView key)
{
    const QCborValue found = mMap.value(key);
    if (!found.isBool())
        mFailed = true;
    return !mFailed && found.toBool();
}

double CborReader::number(QLatin1StringView key, double low, double high)
{
    const double result = value(key, QCborValue::Double).toDouble();
    if (!mFailed && !(std::isfinite(result) && result >= low && result <= high))
        mFailed = true;
    return mFailed ? low : result;
}

Vec2 CborReader::point(QLatin1StringView key)
{
    const QCborArray array = value(key, QCborValue::Array).toArray();
    if (!mFailed && (array.size() != 2 || !array.at(0).isDouble() || !array.at(1).isDouble()))
        mFailed = true;
    const Vec2 result = mFailed ? Vec2(0, 0) : Vec2(array.at(0).toDouble(), array.at(1).toDouble());
    if (!result.allFinite())
        mFailed = true;
    return result;
}

QString CborReader::text(QLatin1StringView key)
{
    const QString result = value(key, QCborValue::String).toString();
    if (result.size() > maxNameLength)
        mFailed = true;
    return mFailed ? QString() : result;
}

QByteArray CborReader::bytes(QLatin1StringView key)
{
    return value(key, QCborValue::ByteArray).toByteArray();
}

QList<int> CborReader::indexSet(QLatin1StringView key, int count)
{
    const std::vector<int> values = unpackedIntegers(bytes(key));
    const QList<int> result(values.begin(), values.end());
    if (!isIndexSet(result, count))
        mFailed = true;
    return mFailed ? QList<int>() : result;
}

IndexRanges CborReader::ranges(QLatin1StringView key, int count)
{
    const std::vector<int> values = unpackedIntegers(bytes(key));
    IndexRanges result;
    int last = 0;
    for (std::size_t i = 0; i + 1 < values.size() && !mFailed; i += 2) {
        if (values[i] < last || values[i + 1] <= values[i] || values[i + 1] > count)
            mFailed = true;
        else
            result.append(IndexRange{values[i], values[i + 1]});
        last = values[i + 1];
    }
    return mFailed ? IndexRanges() : result;
}

std::vector<QCborMap> CborReader::maps(QLatin1StringView key)
{
    std::vector<QCborMap> result;
    const QCborArray array = value(key, QCborValue::Array).toArray();
    for (const QCborValue &item : array) {
        if (!item.isMap())
            mFailed = true;
        else
            result.push_back(item.toMap());
    }
    return mFailed ? std::vector<QCborMap>() : result;
}

QCborMap CborReader::map(QLatin1StringView key)
{
    return value(key, QCborValue::Map).toMap();
}

QCborArray CborReader::array(QLatin1StringView key)
{
    return value(key, QCborValue::Array).toArray();
}

QByteArray packedIntegers(std::span<const int> values)
{
    QByteArray bytes(static_cast<qsizetype>(4 * values.size()), Qt::Uninitialized);
    for (std::size_t i = 0; i < values.size(); ++i)
        qToLittleEndian<qint32>(values[i], bytes.data() + 4 * i);
    return bytes;
}

QByteArray packedRanges(const IndexRanges &ranges)
{
    std::vector<int> values;
    for (const IndexRange &range : ranges.ranges()) {
        values.push_back(range.first);
        values.push_back(range.end);
    }
    return packedIntegers(values);
}

QCborValue cborPoint(const Vec2 &point)
{
    return QCborArray{point.x(), point.y()};
}

QCborMap toCbor(const UvPin &pin)
{
    return {{"corner"_L1, pin.corner},
            {"position"_L1, cborPoint(pin.position)},
            {"hard"_L1, pin.hard},
            {"weight"_L1, pin.weight}};
}

UvPin readPin(CborReader &reader, const MeshData &mesh)
{
    UvPin pin;
    pin.corner = static_cast<int>(reader.integer("corner"_L1, 0, mesh.cornerCount() - 1));
    pin.position = reader.point("position"_L1);
    pin.hard = reader.boolean("hard"_L1);
    pin.weight = reader.number("weight"_L1, 0, largest);
    return pin;
}

QCborMap toCbor(const LayoutRectangle &rectangle)
{
    return {{"id"_L1, rectangle.id},
            {"name"_L1, rectangle.name},
            {"color"_L1, qint64(rectangle.color)},
            {"lower"_L1, cborPoint(rectangle.lower)},
            {"upper"_L1, cborPoint(rectangle.upper)},
            {"hard"_L1, rectangle.hard},
            {"weight"_L1, rectangle.weight},
            {"faces"_L1, packedIntegers(rectangle.faces)}};
}

LayoutRectangle readRectangle(CborReader &reader, const MeshData &mesh)
{
    LayoutRectangle rectangle;
    rectangle.id = static_cast<int>(reader.integer("id"_L1, 1, maxRectangleId));
    rectangle.name = reader.text("name"_L1);
    rectangle.color = static_cast<QRgb>(reader.integer("color"_L1, 0, 0xffffffff));
    rectangle.lower = reader.point("lower"_L1);
    rectangle.upper = reader.point("upper"_L1);
    rectangle.hard = reader.boolean("hard"_L1);
    rectangle.weight = reader.number("weight"_L1, 0, largest);
    rectangle.faces = reader.indexSet("faces"_L1, mesh.faceCount());
    if (!isValid(rectangle, mesh))
        reader.fail();
    return rectangle;
}

namespace {

QCborMap toCbor(const GivenSeamOptions &options)
{
    return {{"cuts"_L1, options.cuts},           {"map"_L1, options.map},
            {"sharp"_L1, options.sharp},         {"hard"_L1, options.hard},
            {"materials"_L1, options.materials}, {"sharpAngle"_L1, options.sharpAngle}};
}

GivenSeamOptions readGivenSeamOptions(CborReader &reader)
{
    GivenSeamOptions options;
    options.cuts = reader.boolean("cuts"_L1);
    options.map = reader.boolean("map"_L1);
    options.sharp = reader.boolean("sharp"_L1);
    options.hard = reader.boolean("hard"_L1);
    options.materials = reader.boolean("materials"_L1);
    options.sharpAngle = reader.number("sharpAngle"_L1, 0, 180);
    return options;
}

} // namespace

QCborMap toCbor(const SolveSettings &settings)
{
    return {{"lambda"_L1, settings.lambda},
            {"delta"_L1, settings.delta},
            {"boxWeight"_L1, settings.boxWeight},
            {"energy"_L1, static_cast<int>(settings.energy)},
            {"weighting"_L1, static_cast<int>(settings.weighting)},
            {"start"_L1, static_cast<int>(settings.start)},
            {"solver"_L1, static_cast<int>(settings.solver)},
            {"seed"_L1, qint64(settings.seed)},
            {"maxDistortion"_L1, settings.maxDistortion},
            {"surface"_L1, static_cast<int>(settings.surface)},
            {"flat"_L1, static_cast<int>(settings.flat)},
            {"alike"_L1, static_cast<int>(settings.alike)},
            {"creases"_L1, static_cast<int>(settings.creases)},
            {"creaseStrength"_L1, settings.creaseStrength},
            {"visibility"_L1, settings.visibility},
            {"symmetricSeams"_L1, static_cast<int>(settings.symmetry)},
            {"align"_L1, static_cast<int>(settings.align)},
            {"mirrorMaps"_L1, settings.mirrorMaps},
            {"worldUp"_L1, static_cast<int>(settings.worldUp)},
            {"seams"_L1, static_cast<int>(settings.seams)},
            {"givenSeams"_L1, toCbor(settings.givenSeams)}};
}

SolveSettings readSolveSettings(CborReader &reader)
{
    SolveSettings settings;
    const auto read = [&](QLatin1StringView key, auto &field, auto readField) {
        if (reader.contains(key))
            field = readField();
    };
    read("lambda"_L1, settings.lambda, [&] { return reader.number("lambda"_L1, 0, 1); });
    read("delta"_L1, settings.delta, [&] { return reader.number("delta"_L1, 0, largest); });
    read("boxWeight"_L1, settings.boxWeight, [&] { return reader.number("boxWeight"_L1, 0, largest); });
    read("energy"_L1, settings.energy,
         [&] { return reader.enumerator("energy"_L1, DistortionEnergy::Amips); });
    read("weighting"_L1, settings.weighting,
         [&] { return reader.enumerator("weighting"_L1, SeamWeighting::Count); });
    read("start"_L1, settings.start, [&] { return reader.enumerator("start"_L1, StartMode::ExistingUv); });
    read("solver"_L1, settings.solver, [&] { return reader.enumerator("solver"_L1, SolverKind::Exact); });
    read("seed"_L1, settings.seed, [&] {
        return static_cast<unsigned>(reader.integer("seed"_L1, 0, std::numeric_limits<unsigned>::max()));
    });
    read("maxDistortion"_L1, settings.maxDistortion,
         [&] { return reader.number("maxDistortion"_L1, 4, SolveSettings::maxBound); });
    read("surface"_L1, settings.surface,
         [&] { return reader.enumerator("surface"_L1, SurfaceKind::HardSurface); });
    read("flat"_L1, settings.flat, [&] { return reader.enumerator("flat"_L1, FlatMode::Free); });
    read("alike"_L1, settings.alike, [&] { return reader.enumerator("alike"_L1, AlikeMode::Stack); });
    read("creases"_L1, settings.creases, [&] { return reader.enumerator("creases"_L1, CreaseMode::On); });
    read("creaseStrength"_L1, settings.creaseStrength,
         [&] { return reader.number("creaseStrength"_L1, 0, 1); });
    read("visibility"_L1, settings.visibility, [&] { return reader.number("visibility"_L1, 0, 1); });
    // Former versions had a switch; where it was off, the default has changed since.
    read("symmetry"_L1, settings.symmetry,
         [&] { return reader.boolean("symmetry"_L1) ? SymmetryMode::On : SymmetryMode::Auto; });
    read("symmetricSeams"_L1, settings.symmetry,
         [&] { return reader.enumerator("symmetricSeams"_L1, SymmetryMode::On); });
    read("align"_L1, settings.align, [&] { return reader.enumerator("align"_L1, CreaseMode::On); });
    read("mirrorMaps"_L1, settings.mirrorMaps, [&] { return reader.boolean("mirrorMaps"_L1); });
    read("worldUp"_L1, settings.worldUp, [&] { return reader.enumerator("worldUp"_L1, WorldUp::AutoZ); });
    read("seams"_L1, settings.seams, [&] { return reader.enumerator("seams"_L1, SeamMode::Only); });
    if (reader.contains("givenSeams"_L1)) {
        CborReader given(reader.map("givenSeams"_L1));
        settings.givenSeams = readGivenSeamOptions(given);
        if (given.failed())
            reader.fail();
    }
    if (!isValid(settings))
        reader.fail();
    return settings;
}

QCborMap toCbor(const PackingSettings &settings)
{
    return {{"textureSize"_L1, settings.textureSize}, {"margin"_L1, static_cast<int>(settings.margin)},
            {"udimTile"_L1, settings.udimTile},       {"rotation"_L1, static_cast<int>(settings.rotation)},
            {"keepScale"_L1, settings.keepScale},     {"border"_L1, settings.border},
            {"effort"_L1, settings.effort},           {"textureHeight"_L1, settings.textureHeight}};
}

PackingSettings readPackingSettings(CborReader &reader)
{
    PackingSettings settings;
    const auto integer = [&](QLatin1StringView key, auto &field) {
        if (reader.contains(key))
            field = static_cast<int>(reader.integer(key, 0, PackingSettings::maxTextureSize));
    };
    integer("textureSize"_L1, settings.textureSize);
    integer("textureHeight"_L1, settings.textureHeight);
    integer("margin"_L1, settings.margin);
    integer("udimTile"_L1, settings.udimTile);
    if (reader.contains("rotation"_L1))
        settings.rotation = reader.enumerator("rotation"_L1, PackRotation::TwentyFourth);
    if (reader.contains("keepScale"_L1))
        settings.keepScale = reader.boolean("keepScale"_L1);
    if (reader.contains("border"_L1))
        settings.border = reader.number("border"_L1, -1, PackingSettings::maxTextureSize);
    if (reader.contains("effort"_L1))
        settings.effort = reader.number("effort"_L1, 0, PackingSettings::maxEffort);
    if (!settings.isValid())
        reader.fail();
    return settings;
}

QCborMap toCbor(const Selection &selection, const MeshData &mesh)
{
    std::vector<int> sides;
    for (int edge : selection.edges)
        sides.push_back(sideOfEdge(mesh, edge));
    std::sort(sides.begin(), sides.end());
    return {{"mode"_L1, static_cast<int>(selection.mode)},
            {"faces"_L1, packedIntegers(selection.faces)},
            {"sides"_L1, packedIntegers(sides)},
            {"corners"_L1, packedIntegers(selection.corners)}};
}

namespace {

QList<int> readSelectedEdges(CborReader &reader, const MeshData &mesh)
{
    if (!reader.contains("sides"_L1)) {
        const int edgeCount = static_cast<int>(mesh.edgePairs.size() + mesh.boundarySides.size());
        const QList<int> edges = reader.indexSet("edges"_L1, edgeCount);
        return hasNumbersOfVersion1(mesh) ? edges : QList<int>();
    }
    QList<int> edges = reader.indexSet("sides"_L1, mesh.cornerCount());
    if (edges.isEmpty())
        return edges;
    const std::vector<int> edgeOfSide = edgesBySide(mesh);
    for (int &edge : edges) {
        edge = edgeOfSide[static_cast<std::size_t>(edge)];
        if (edge < 0)
            reader.fail();
    }
    return edges;
}

} // namespace

Selection readSelection(CborReader &reader, const MeshData &mesh)
{
    Selection selection;
    selection.mode = reader.enumerator("mode"_L1, SelectionMode::Islands);
    selection.faces = reader.indexSet("faces"_L1, mesh.faceCount());
    selection.edges = readSelectedEdges(reader, mesh);
    selection.corners = reader.indexSet("corners"_L1, mesh.cornerCount());
    selection.normalize(mesh);
    return selection;
}

} // namespace autocuts
