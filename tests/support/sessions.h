// Sessions with something in every field, for tests of project files.
#pragma once

#include "model/io/projects/projectfile.h"
#include "model/io/projects/projectmigration.h"

#include <functional>

namespace autocuts::test {

//! A session to save.
struct Session
{
    DocumentState state;
    ProjectExtras extras;
};

//! The cube of 12 triangles, from an OBJ file with a comment, with every kind of steering, two UV sets and a
//! journal. This is what tests/data/session-v1.acproj holds.
Session cubeSession();
//! A bulged grid of n x n quads from no OBJ file, in two islands, with random steering and a journal of
//! random edits. \param seed of the edits
Session gridSession(int n, int edits, int seed);

//! The file of a session.
QByteArray bytesOf(const Session &session);
//! The bytes of a session after a change of its parts, with checksums that fit again.
QByteArray repacked(const QByteArray &bytes, const std::function<void(PartMap &)> &change,
                    int version = projectVersion);

} // namespace autocuts::test
