// Compiles the shaders in resources/shaders.
#pragma once

#include <QOpenGLShaderProgram>
#include <QString>

#include <memory>

namespace autocuts {

//! The program made of NAME.vert and NAME.frag in resources/shaders. A context must be current.
//! \param defines macros of both, each a name with its value. What a shader knows when it is compiled costs
//! no time for each pixel; llvmpipe works out both sides of other branches. \throws std::runtime_error with
//! the messages of the compiler
std::unique_ptr<QOpenGLShaderProgram>
makeShaderProgram(const QString &vertexName, const QString &fragmentName, const QByteArrayList &defines = {});

} // namespace autocuts
