// Compiles the shaders in resources/shaders.
#pragma once

#include <QOpenGLShaderProgram>
#include <QString>

#include <memory>

namespace autocuts {

//! The program made of NAME.vert and NAME.frag in resources/shaders. A context must be current.
//! \param define a name that is defined in both; empty: none
//! \throws std::runtime_error with the messages of the compiler
std::unique_ptr<QOpenGLShaderProgram>
makeShaderProgram(const QString &vertexName, const QString &fragmentName, const QByteArray &define = {});

} // namespace autocuts
