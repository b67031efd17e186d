// What a canvas has on the graphics card.
#pragma once

#include "views/gl/backdrop.h"
#include "views/gl/patterntexture.h"
#include "views/gl/pointrenderer.h"
#include "views/gl/souprenderer.h"

namespace autocuts {

//! Lives as long as the OpenGL context; made and destroyed while that is current.
struct GlResources
{
    explicit GlResources(GlFunctions &functions)
        : gl(functions), backdrop(functions), soup(functions), points(functions)
    {}

    GlFunctions &gl;
    Backdrop backdrop;
    SoupRenderer soup;
    PointRenderer points;
    PatternTexture texture;
};

} // namespace autocuts
