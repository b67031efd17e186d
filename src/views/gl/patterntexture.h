// The pictures of a pattern in graphics memory.
#pragma once

#include "views/gl/glbuffer.h"
#include "views/gl/pictures.h"

#include <QOpenGLTexture>

#include <memory>

namespace autocuts {

//! An array of repeating textures with v pointing up, and a table of which set has which picture in which
//! tile; shaders read both by picture.glsl. The context must be current in all functions.
class PatternTexture final
{
public:
    explicit PatternTexture(GlFunctions &gl) : mGl(gl), mTable(gl) {}

    //! Pictures of different sizes are scaled to one size, and too large ones to what there is room for.
    void setPictures(const Pictures &pictures);
    bool isEmpty() const { return !mTexture; }
    //! As in Pictures.
    int layers() const { return mLayers; }
    //! Binds the pictures and the table to two texture units.
    void bind(int pictureUnit, int tableUnit);

private:
    GlFunctions &mGl;
    GlTexelBuffer mTable;
    std::unique_ptr<QOpenGLTexture> mTexture;
    int mLayers = 1;
};

} // namespace autocuts
