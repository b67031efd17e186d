// Buffers in graphics memory.
#pragma once

#include "views/gl/glfunctions.h"

#include <span>

namespace autocuts {

//! A buffer that is always filled completely. Its context must be current in all functions, including the
//! destructor.
class GlBuffer final
{
public:
    explicit GlBuffer(GlFunctions &gl) : mGl(gl) { mGl.glGenBuffers(1, &mId); }
    ~GlBuffer() { mGl.glDeleteBuffers(1, &mId); }
    GlBuffer(const GlBuffer &) = delete;
    GlBuffer &operator=(const GlBuffer &) = delete;

    GLuint id() const { return mId; }
    void bind(GLenum target) { mGl.glBindBuffer(target, mId); }

    //! Replaces the content without waiting for drawing that still uses the old one.
    template <typename Item>
    void fill(std::span<const Item> items, GLenum usage)
    {
        bind(GL_ARRAY_BUFFER);
        mGl.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size_bytes()), items.data(), usage);
    }

private:
    GlFunctions &mGl;
    GLuint mId = 0;
};

//! A buffer that shaders read as a texture of GL_RGBA8UI texels.
class GlTexelBuffer final
{
public:
    explicit GlTexelBuffer(GlFunctions &gl) : mGl(gl), mBuffer(gl) { mGl.glGenTextures(1, &mTexture); }
    ~GlTexelBuffer() { mGl.glDeleteTextures(1, &mTexture); }
    GlTexelBuffer(const GlTexelBuffer &) = delete;
    GlTexelBuffer &operator=(const GlTexelBuffer &) = delete;

    template <typename Texel>
    void fill(std::span<const Texel> texels)
    {
        static_assert(sizeof(Texel) == 4);
        mBuffer.fill(texels, GL_DYNAMIC_DRAW);
        mGl.glBindTexture(GL_TEXTURE_BUFFER, mTexture);
        mGl.glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA8UI, mBuffer.id());
    }
    void bind(int unit)
    {
        mGl.glActiveTexture(GL_TEXTURE0 + unit);
        mGl.glBindTexture(GL_TEXTURE_BUFFER, mTexture);
    }

private:
    GlFunctions &mGl;
    GlBuffer mBuffer;
    GLuint mTexture = 0;
};

} // namespace autocuts
