// Shader programs from the files in resources/shaders.
#pragma once

#include <QOpenGLShaderProgram>
#include <QString>

#include <memory>

namespace autocuts {

//! The program of resources/shaders/NAME.vert and NAME.frag. A context must be current.
//! \throws std::runtime_error with the compiler's messages
std::unique_ptr<QOpenGLShaderProgram> makeShaderProgram(const QString &vertexName,
                                                        const QString &fragmentName);

} // namespace autocuts
