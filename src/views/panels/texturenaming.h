// Names of channels for users.
#pragma once

#include "model/document/texturesets.h"

namespace autocuts {

//! Translated.
QString channelName(TextureChannel channel);

} // namespace autocuts
