// Steering values to and from CBOR, for project files and the journal of commands.
#pragma once

#include "model/document/constraints.h"
#include "model/document/selection.h"
#include "model/plain/indexranges.h"
#include "model/plain/packingsettings.h"
#include "model/plain/solvesettings.h"

#include <QCborMap>

#include <span>

namespace autocuts {

//! Reads a CBOR map that may hold anything. The first value that is missing or out of range makes it fail;
//! from then on every call gives an empty value. Numbers are checked as they are read, so nothing out of
//! range comes out, and no more memory is taken than the map itself has.
class CborReader
{
public:
    //! \pre the map was decoded without a QCborParserError: Qt 6.4 crashes on a map that broke off after a
    //! key
    explicit CborReader(const QCborMap &map) : mMap(map) {}

    bool failed() const { return mFailed; }
    void fail() { mFailed = true; }
    bool contains(QLatin1StringView key) const { return mMap.contains(key); }

    //! An integer in [low, high].
    qint64 integer(QLatin1StringView key, qint64 low, qint64 high);
    //! An integer in [0, last] as an enumerator.
    template <typename Enum>
    Enum enumerator(QLatin1StringView key, Enum last)
    {
        return static_cast<Enum>(integer(key, 0, static_cast<qint64>(last)));
    }
    bool boolean(QLatin1StringView key);
    //! A finite number in [low, high].
    double number(QLatin1StringView key, double low, double high);
    //! A point with finite coordinates.
    Vec2 point(QLatin1StringView key);
    //! At most maxNameLength characters.
    QString text(QLatin1StringView key);
    QByteArray bytes(QLatin1StringView key);
    //! Strictly rising indices in [0, count).
    QList<int> indexSet(QLatin1StringView key, int count);
    //! Ranges with indices in [0, count).
    IndexRanges ranges(QLatin1StringView key, int count);
    //! The maps of an array.
    std::vector<QCborMap> maps(QLatin1StringView key);
    QCborMap map(QLatin1StringView key);

private:
    QCborValue value(QLatin1StringView key, QCborValue::Type type);

    QCborMap mMap;
    bool mFailed = false;
};

//! Integers as a byte string of little-endian 32-bit numbers.
QByteArray packedIntegers(std::span<const int> values);
//! Ranges as packedIntegers: first, end, first, end, ...
QByteArray packedRanges(const IndexRanges &ranges);
QCborValue cborPoint(const Vec2 &point);

QCborMap toCbor(const UvPin &pin);
QCborMap toCbor(const LayoutRectangle &rectangle);
QCborMap toCbor(const SolveSettings &settings);
QCborMap toCbor(const PackingSettings &settings);
//! Edges are named by the corner at which one of their sides starts.
//! \pre the selection is valid for the mesh
QCborMap toCbor(const Selection &selection, const MeshData &mesh);

// What these return is valid unless the reader failed. A setting that is not there keeps its default.
UvPin readPin(CborReader &reader, const MeshData &mesh);
LayoutRectangle readRectangle(CborReader &reader, const MeshData &mesh);
SolveSettings readSolveSettings(CborReader &reader);
PackingSettings readPackingSettings(CborReader &reader);
//! Edges that version 1 of the project files named by number are left out where the mesh has other numbers
//! now.
Selection readSelection(CborReader &reader, const MeshData &mesh);

} // namespace autocuts
