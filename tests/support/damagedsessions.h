// Sessions of which a part is damaged.
#pragma once

#include "model/io/files/savefile.h"
#include "model/io/projects/projectfile.h"

#include <cstring>

namespace autocuts::test {

//! Saves a model with painted texel densities as a session in which one bit of a part is flipped.
inline bool writeDamaged(const Scene &scene, const QString &path, const char *part)
{
    DocumentState state = DocumentState::initial(scene);
    state.texelWeights.assign(static_cast<std::size_t>(scene.mesh->faceCount()), 0.5);
    QByteArray bytes = ProjectWriter().bytes(state, {});
    const qsizetype name = bytes.indexOf(part);
    if (name < 0)
        return false;
    constexpr int content = 12; // behind size and checksum
    bytes[name + qsizetype(std::strlen(part)) + content] ^= 1;
    return saveAtomically(path, bytes).ok();
}

} // namespace autocuts::test
