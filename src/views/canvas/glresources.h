// The OpenGL objects of a canvas.
#pragma once

#include "views/canvas/gradualpicture.h"
#include "views/gl/backdrop.h"
#include "views/gl/patterntexture.h"
#include "views/gl/pointrenderer.h"
#include "views/gl/souprenderer.h"

namespace autocuts {

//! Lives as long as the OpenGL context, which must be current during construction and destruction.
struct GlResources
{
    //! \param ofMap for the UV view
    GlResources(GlFunctions &functions, bool ofMap)
        : gl(functions), backdrop(functions), soup(functions, ofMap), points(functions), pictures(functions),
          environment(functions)
    {}

    MapRenderers forMap() { return {gl, backdrop, soup, points}; }

    GlFunctions &gl;
    Backdrop backdrop;
    SoupRenderer soup;
    PointRenderer points;
    PatternTexture pictures;
    EnvironmentTexture environment;
    GradualPicture gradual;
};

} // namespace autocuts
