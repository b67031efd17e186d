// Conversion of steering values to and from CBOR, for project files and the command journal.
#pragma once

#include "model/document/constraints.h"
#include "model/document/selection.h"
#include "model/plain/indexranges.h"
#include "model/plain/packingsettings.h"
#include "model/plain/solvesettings.h"

#include <QCborArray>
#include <QCborMap>

#include <span>

namespace autocuts {

//! Reads values from an untrusted CBOR map. The reader fails at the first value that is missing or out of
//! range; every later call returns an empty value. Every number is checked, so no value out of range is
//! returned, and the reader allocates no more memory than the map takes.
class CborReader
{
public:
    //! \pre the map was decoded without a QCborParserError: Qt 6.4 crashes on a map that ends after a key
    explicit CborReader(const QCborMap &map) : mMap(map) {}

    bool failed() const { return mFailed; }
    void fail() { mFailed = true; }
    bool contains(QLatin1StringView key) const { return mMap.contains(key); }

    //! An integer in [low, high].
    qint64 integer(QLatin1StringView key, qint64 low, qint64 high);
    //! An integer in [0, last], converted to an enumerator.
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
    //! A string of at most maxNameLength characters.
    QString text(QLatin1StringView key);
    QByteArray bytes(QLatin1StringView key);
    //! Strictly ascending indices in [0, count).
    QList<int> indexSet(QLatin1StringView key, int count);
    //! Index ranges whose indices are in [0, count).
    IndexRanges ranges(QLatin1StringView key, int count);
    //! An array of maps.
    std::vector<QCborMap> maps(QLatin1StringView key);
    QCborMap map(QLatin1StringView key);
    QCborArray array(QLatin1StringView key);

private:
    QCborValue value(QLatin1StringView key, QCborValue::Type type);

    QCborMap mMap;
    bool mFailed = false;
};

//! The integers as a byte string of 32-bit little-endian numbers.
QByteArray packedIntegers(std::span<const int> values);
//! The ranges in the form of packedIntegers(): first, end, first, end, ...
QByteArray packedRanges(const IndexRanges &ranges);
QCborValue cborPoint(const Vec2 &point);

QCborMap toCbor(const UvPin &pin);
QCborMap toCbor(const LayoutRectangle &rectangle);
QCborMap toCbor(const SolveSettings &settings);
QCborMap toCbor(const PackingSettings &settings);
//! Edges are stored as the corner at which one of their sides starts.
//! \pre the selection is valid for the mesh
QCborMap toCbor(const Selection &selection, const MeshData &mesh);

// The results are valid unless the reader failed. Settings that are missing keep their defaults.
UvPin readPin(CborReader &reader, const MeshData &mesh);
LayoutRectangle readRectangle(CborReader &reader, const MeshData &mesh);
SolveSettings readSolveSettings(CborReader &reader);
PackingSettings readPackingSettings(CborReader &reader);
//! Version 1 of the project files stored edges by number. Such edges are left out when this mesh numbers its
//! edges differently today.
Selection readSelection(CborReader &reader, const MeshData &mesh);

} // namespace autocuts
