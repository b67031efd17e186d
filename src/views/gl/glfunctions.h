// The OpenGL that both views are drawn with.
#pragma once

#include <QOpenGLFunctions_3_3_Core>

namespace autocuts {

using GlFunctions = QOpenGLFunctions_3_3_Core;

} // namespace autocuts
