// Replaces the UVs in a glTF file.
#pragma once

#include "model/io/gltf/gltfsource.h"

#include <map>
#include <optional>

namespace autocuts {

//! The UV sets of the scene by the number of the texture coordinate set that they are written to. Sets keep
//! the numbers that they have in the file, by their names; renamed and new ones get those that are left, then
//! the next free ones. Sets for which eight are too few are missing.
std::map<int, const UvSet *> texcoordsToWrite(const GltfSource &source, const Scene &scene);

//! The file with the UVs of the scene; nothing when they are those of the file. Where corners of one vertex
//! have other UVs, the vertex is split with all its attributes and morph targets; vertices that only differed
//! by their old UVs become one. New data are added at the end of a buffer; the old data stay, but for what
//! stands last. Sets of the file that the scene has no more stay, since materials name sets by their numbers.
//! Tangents of changed UVs are left out: readers then compute them, as the specification says. Corners
//! without UV keep that of the file, or get 0 0. Pictures that are other ones than those of the file's
//! materials are added for the active UV set, and the names of new UV sets are noted. \param path of the new
//! file \pre sourceOf<GltfSource>(scene) == &source; it outlives the result \throws GltfError
std::optional<GltfDocument> rewriteGltf(const GltfSource &source, const Scene &scene,
                                        const QString &path = {});

} // namespace autocuts
