// Names of channels for users.
#pragma once

#include "model/document/texturesets.h"

namespace autocuts {

//! The translated name of a channel.
QString channelName(TextureChannel channel);

} // namespace autocuts
