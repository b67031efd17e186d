// The OpenGL objects of a canvas.
#pragma once

#include "views/gl/backdrop.h"
#include "views/gl/patterntexture.h"
#include "views/gl/pointrenderer.h"
#include "views/gl/souprenderer.h"

namespace autocuts {

//! Lives as long as the OpenGL context, which must be current during construction and destruction.
struct GlResources
{
    explicit GlResources(GlFunctions &functions)
        : gl(functions), backdrop(functions), soup(functions), points(functions), pictures(functions),
          environment(functions)
    {}

    GlFunctions &gl;
    Backdrop backdrop;
    SoupRenderer soup;
    PointRenderer points;
    PatternTexture pictures;
    EnvironmentTexture environment;
};

} // namespace autocuts
