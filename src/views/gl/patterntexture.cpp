#include "views/gl/patterntexture.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <algorithm>

namespace autocuts {

void PatternTexture::setImage(const QImage &image)
{
    mTexture.reset();
    if (image.isNull())
        return;
    GLint largest = 1024;
    QOpenGLContext::currentContext()->functions()->glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    QImage fitting = image;
    if (std::max(image.width(), image.height()) > largest)
        fitting = image.scaled(largest, largest, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    mTexture = std::make_unique<QOpenGLTexture>(fitting.mirrored().convertToFormat(QImage::Format_RGBA8888));
    mTexture->setMinMagFilters(QOpenGLTexture::LinearMipMapLinear, QOpenGLTexture::Linear);
    mTexture->setWrapMode(QOpenGLTexture::Repeat);
    mTexture->setMaximumAnisotropy(8);
}

} // namespace autocuts
