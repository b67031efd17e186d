// The OpenGL version of both views.
#pragma once

#include <QOpenGLFunctions_3_3_Core>

namespace autocuts {

using GlFunctions = QOpenGLFunctions_3_3_Core;

} // namespace autocuts
