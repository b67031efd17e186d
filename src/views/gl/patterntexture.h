// The picture of a pattern in graphics memory.
#pragma once

#include <QImage>
#include <QOpenGLTexture>

#include <memory>

namespace autocuts {

//! A repeating texture with v pointing up. The context must be current in all functions.
class PatternTexture final
{
public:
    //! Sets the image; a null image removes the texture. Images that are too large for the hardware are
    //! scaled down.
    void setImage(const QImage &image);
    //! The OpenGL id of the texture; 0 when there is none.
    unsigned id() const { return mTexture ? mTexture->textureId() : 0; }

private:
    std::unique_ptr<QOpenGLTexture> mTexture;
};

} // namespace autocuts
