// Arrays of numbers as byte strings that compress well.
#pragma once

#include "model/plain/types.h"

#include <QByteArray>

#include <optional>
#include <span>
#include <vector>

namespace autocuts {

//! Little-endian, all first bytes before all second bytes and so on: neighbouring numbers share their high
//! bytes, which then stand together.
QByteArray packedArray(std::span<const int> values);
QByteArray packedArray(std::span<const double> values);

//! Nothing when the bytes are not exactly `count` numbers.
std::optional<std::vector<int>> unpackedIntegers(const QByteArray &bytes, qsizetype count);
std::optional<std::vector<double>> unpackedDoubles(const QByteArray &bytes, qsizetype count);

//! How many integers or doubles the bytes hold; -1 when they end within one.
qsizetype packedIntegerCount(const QByteArray &bytes);
qsizetype packedDoubleCount(const QByteArray &bytes);

} // namespace autocuts
