// Stores arrays of numbers as byte strings that compress well.
#pragma once

#include "model/plain/types.h"

#include <QByteArray>

#include <optional>
#include <span>
#include <vector>

namespace autocuts {

//! Little-endian, with all first bytes before all second bytes and so on. Numbers next to each other often
//! have equal high bytes, which come to stand together in this order.
QByteArray packedArray(std::span<const int> values);
QByteArray packedArray(std::span<const double> values);

//! Nothing when the byte string does not hold exactly `count` numbers.
std::optional<std::vector<int>> unpackedIntegers(const QByteArray &bytes, qsizetype count);
std::optional<std::vector<double>> unpackedDoubles(const QByteArray &bytes, qsizetype count);

//! The number of integers or doubles in the byte string; -1 when it ends within one.
qsizetype packedIntegerCount(const QByteArray &bytes);
qsizetype packedDoubleCount(const QByteArray &bytes);

} // namespace autocuts
