// Makes of a scene what its look depends on, for bakes.
#pragma once

#include "model/document/scene.h"
#include "model/plain/shadedsurface.h"

#include <QStringList>

namespace autocuts {

//! Normals, UVs of the first set and the tangents they give, and colours of vertices and materials; no
//! textures. Takes long for large models. \param tileHeight of the texture that the UVs are for, see
//! tilescaling.h
ShadedSurface shadedSurface(const Scene &scene, double tileHeight = 1);

//! Lets objects of both models see each other that have the same name, without regard to case and to endings
//! such as _low, _lp, _high and _hp and to what follows them: "Lid_low" sees "lid_high" and "lid_high_02".
//! \returns the names of objects of the first model that have no partner
QStringList pairObjects(ShadedSurface &low, const std::vector<QString> &lowNames, ShadedSurface &high,
                        const std::vector<QString> &highNames);

//! Moves a detailed model onto the simple one where it has other units or another axis up, and says so; an
//! empty text when it stays.
QString placeLike(ShadedSurface &high, const ShadedSurface &low);

} // namespace autocuts
