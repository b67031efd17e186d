// Meshes that the program makes by itself: for trying it out, for the documentation and for tests.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <QStringList>

namespace autocuts {

//! Names that makeSample() knows, in the order in which they should be shown.
QStringList sampleNames();

//! Makes a sample: closed, consistently wound outwards, y up, about two units high, without UVs.
//! - "bumpycube": a cube with smooth bumps on its faces and clear edges (triangles; paper, figure 6)
//! - "character": a figure with head, arms and legs in one piece (quads, genus 0)
//! - "torus": a torus with three handles (quads, genus 4)
//! - "machine": a pump of many hard-surface parts in several objects (triangles, quads and n-gons, some of
//!   them concave)
//! The same name always gives the same bits. An unknown name is an error that lists the known ones.
Result<Scene> makeSample(const QString &name);

} // namespace autocuts
