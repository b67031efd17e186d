#include "views/gl/environmenttexture.h"

#include <cmath>

namespace autocuts {

void EnvironmentTexture::set(const Environment &environment)
{
    mTexture.reset();
    if (environment.isEmpty())
        return;
    mTexture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::TargetCubeMap);
    mTexture->setFormat(QOpenGLTexture::RGB16F);
    mTexture->setSize(Environment::sideOf(0), Environment::sideOf(0));
    mTexture->setMipLevels(Environment::levelCount);
    mTexture->allocateStorage(QOpenGLTexture::RGB, QOpenGLTexture::Float32);
    for (int level = 0; level < Environment::levelCount; ++level) {
        const std::vector<float> &values = environment.levels[static_cast<std::size_t>(level)];
        const std::size_t face = values.size() / 6;
        for (int k = 0; k < 6; ++k)
            mTexture->setData(level, 0, QOpenGLTexture::CubeMapFace(QOpenGLTexture::CubeMapPositiveX + k),
                              QOpenGLTexture::RGB, QOpenGLTexture::Float32,
                              values.data() + static_cast<std::size_t>(k) * face);
    }
    mTexture->setMinMagFilters(QOpenGLTexture::LinearMipMapLinear, QOpenGLTexture::Linear);
    mTexture->setWrapMode(QOpenGLTexture::ClampToEdge);
    for (std::size_t k = 0; k < mIrradiance.size(); ++k)
        mIrradiance[k] = {environment.irradiance[k][0], environment.irradiance[k][1],
                          environment.irradiance[k][2]};
}

void EnvironmentTexture::use(QOpenGLShaderProgram &program, int unit, const QMatrix4x4 &toEnvironment,
                             double exposure)
{
    program.setUniformValue("environment", unit);
    if (!mTexture)
        return;
    mGl.glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    program.setUniformValueArray("irradiance", mIrradiance.data(), static_cast<int>(mIrradiance.size()));
    program.setUniformValue("toEnvironment", toEnvironment.toGenericMatrix<3, 3>());
    program.setUniformValue("exposure", static_cast<float>(std::exp2(exposure)));
    mTexture->bind(static_cast<uint>(unit));
}

} // namespace autocuts
