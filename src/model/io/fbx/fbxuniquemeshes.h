// Gives models that share a geometry one each, in the bytes of an FBX file.
#pragma once

#include "model/document/result.h"
#include "model/io/fbx/fbxsource.h"

#include <QString>

namespace autocuts {

//! True when the geometries of the file can be copied: its objects have numbers.
bool hasCopyableGeometries(const FbxSource &source);

//! The bytes of the source, in which each model has a geometry of its own: the first one of the file keeps
//! what they share, the others get copies of it, with what deforms it. \pre hasCopyableGeometries(source)
//! \param path for messages
Result<QByteArray> withUniqueGeometries(const FbxSource &source, const QString &path);

} // namespace autocuts
