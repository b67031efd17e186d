// The surroundings of the model in graphics memory.
#pragma once

#include "model/pictures/environment.h"
#include "views/gl/glfunctions.h"

#include <QMatrix4x4>
#include <QOpenGLShaderProgram>
#include <QOpenGLTexture>
#include <QVector3D>

#include <memory>

namespace autocuts {

//! A cube map with a level for each roughness, which shaders read by light.glsl. The context must be current
//! in all functions.
class EnvironmentTexture final
{
public:
    explicit EnvironmentTexture(GlFunctions &gl) : mGl(gl) {}

    void set(const Environment &environment);
    bool isEmpty() const { return !mTexture; }
    //! Binds the cube map to a unit, and gives a program its uniforms. \param toEnvironment turns directions
    //! of the program \param exposure in stops
    void use(QOpenGLShaderProgram &program, int unit, const QMatrix4x4 &toEnvironment, double exposure);

private:
    GlFunctions &mGl;
    std::unique_ptr<QOpenGLTexture> mTexture;
    std::array<QVector3D, 9> mIrradiance;
};

} // namespace autocuts
