// A whole session of an artist on one model.
#pragma once

#include "support/artist.h"

namespace autocuts::test {

//! Opens the file, steers, solves, mends overlaps, moves and boxes islands, packs, saves, exports, opens the
//! session again, and takes everything back and does it again; with the mouse and the keys. Checks the
//! document after each step. Returns the first problem; empty: none.
QString runArtistSession(Artist &artist, const QString &file);

} // namespace autocuts::test
