// The user's texture on the graphics card.
#pragma once

#include <QImage>
#include <QOpenGLTexture>

#include <memory>

namespace autocuts {

//! A picture that repeats, with v up. The context must be current in all functions.
class PatternTexture final
{
public:
    //! A null picture takes the texture away. Pictures that are larger than the graphics card allows are
    //! scaled down.
    void setImage(const QImage &image);
    //! 0 when there is none.
    unsigned id() const { return mTexture ? mTexture->textureId() : 0; }

private:
    std::unique_ptr<QOpenGLTexture> mTexture;
};

} // namespace autocuts
