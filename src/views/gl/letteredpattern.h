// A pattern whose cells can be told apart: by name, by hue and by which way they stand.
#pragma once

#include <QImage>
#include <QString>

namespace autocuts {

inline constexpr int leastLetteredCells = 2, mostLetteredCells = 26;

//! The name of a cell: a letter for its row, from A at the bottom, and a number for its column, from 1.
QString letteredCellName(int column, int row);
//! A square picture, as wide as a tile, with cells x cells cells, v pointing up. Every cell has its name, an
//! arrow up, a hue for its column that gets lighter towards the top, and a small checkerboard. Mirrored parts
//! show mirrored letters, turned ones turned arrows, stacked ones the same names. \param cells clamped to the
//! range above
QImage letteredPattern(int cells);

} // namespace autocuts
