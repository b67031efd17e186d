// Numbers as the panels and the status bar show them.
#pragma once

#include <QString>

namespace autocuts {

//! A dash in place of a figure that does not exist.
QString missingText();
//! With a fixed number of decimals; a dash when it is not finite.
QString fixedText(double value, int decimals);
//! With a number of significant digits; a dash when it is not finite.
QString significantText(double value, int digits);
//! A count; a dash when it is negative.
QString countText(qint64 count);
//! A share in [0, 1] as per cent with one decimal; a dash when it is not finite.
QString percentText(double share);

} // namespace autocuts
