// Formats numbers for panels, the status bar and messages.
#pragma once

#include <QString>

namespace autocuts {

//! A dash, for a figure that does not exist.
QString missingText();
//! A number with a fixed number of decimals; a dash when it is not finite.
QString fixedText(double value, int decimals);
//! A number with so many significant digits; a dash when it is not finite.
QString significantText(double value, int digits);
//! A count; a dash when it is negative.
QString countText(qint64 count);
//! A share in [0, 1] as a percentage with one decimal; a dash when it is not finite.
QString percentText(double share);
//! Figures with captions, such as "seams 18.7, islands: 46", that lines break after commas only.
QString figureLine(QString text);

} // namespace autocuts
