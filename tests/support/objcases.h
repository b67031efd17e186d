// OBJ texts and what tests of reading and writing them need.
#pragma once

#include "model/document/scene.h"

namespace autocuts::test {

//! One triangle.
extern const QByteArray triangleObj;
//! Everything that the format allows and that few files have.
extern const QByteArray nastyObj;

//! The scene that the text holds; ends the test program when it holds none.
Scene parsed(const QByteArray &bytes);
//! Replaces the active UV set by numbers that need all their digits; a UV per vertex, so that corners share.
void setNewUvs(Scene &scene);
//! All bytes of a file.
QByteArray contentOf(const QString &path);

} // namespace autocuts::test
