#version 330 core
// What is behind the map: tiles with their pattern, and a grid that follows the zoom.

out vec4 color;

uniform vec4 outsideColor, insideColor, minorColor, majorColor, axisX, axisY;
uniform vec2 tileOrigin;   // pixels from the lower left: a corner of a tile near the view
uniform vec2 originTile;   // that tile
uniform vec2 usedTiles;    // tiles from 0 that are shown as texture
uniform vec2 tilePixels;   // size of a tile
uniform float tileHeight, pictureHeight; // of a tile and of the picture, where both are 1 wide
uniform vec2 gridOrigin;   // pixels: a line of the grid near the view
uniform float gridPixels;  // between lines
uniform float minorStrength; // 0 to 1: finer lines appear smoothly
uniform float minorDivisions;
uniform bool grid;
uniform float checkerSize, lineWidth;
uniform float patternStrength; // below 1 where islands show the pattern, so that they stand out
uniform int pictureSet; // counted from 0

const int pattern = PATTERN; // 0 none, 1 checker, 2 picture

#include "picture.glsl"

float lineAt(vec2 offset)
{
    vec2 share = clamp(0.5 * lineWidth + 0.5 - offset, 0.0, 1.0);
    return max(share.x, share.y);
}

// Distance in pixels to the next line of a grid.
vec2 toGrid(vec2 fromLine, vec2 spacing)
{
    return abs(fract(fromLine / spacing + 0.5) - 0.5) * spacing;
}

vec3 patterned(vec3 below, vec2 uv)
{
    if (pattern == 1) {
        vec2 p = uv * checkerSize;
        float width = checkerSize / tilePixels.x;
        vec2 wave = 2.0 * abs(fract(p * 0.5) - 0.5) - 0.5;
        vec2 share = clamp(wave / width + 0.5, 0.0, 1.0);
        float dark = share.x * (1.0 - share.y) + share.y * (1.0 - share.x);
        dark = mix(dark, 0.5, smoothstep(0.5, 1.2, width));
        return mix(below, mix(vec3(0.42), vec3(0.24), dark), 0.55);
    }
    if (pattern == 2) {
        vec4 picture = pictureAt(pictureSet, uv / vec2(1.0, pictureHeight));
        return mix(below, picture.rgb, picture.a);
    }
    return below;
}

void main()
{
    vec2 inTiles = (gl_FragCoord.xy - tileOrigin) / tilePixels;
    vec2 uv = inTiles + originTile;
    bool inside = all(greaterThanEqual(uv, vec2(0))) && all(lessThan(uv, usedTiles));
    vec3 textured = mix(insideColor.rgb, patterned(insideColor.rgb, uv * vec2(1.0, tileHeight)), patternStrength);
    vec3 result = inside ? textured : outsideColor.rgb;
    if (grid) {
        vec2 fromLine = gl_FragCoord.xy - gridOrigin;
        float minor = lineAt(toGrid(fromLine, vec2(gridPixels / minorDivisions)));
        result = mix(result, minorColor.rgb, minorColor.a * minor * minorStrength);
        result = mix(result, majorColor.rgb, 0.6 * majorColor.a * lineAt(toGrid(fromLine, vec2(gridPixels))));
    }
    // Borders of tiles; in the first quadrant stronger, and the axes in their colours.
    vec2 toTile = toGrid(gl_FragCoord.xy - tileOrigin, tilePixels);
    vec2 nearest = floor(uv + 0.5);
    bool counted = all(greaterThanEqual(uv, -0.5 / tilePixels)) && uv.x <= 10.0 + 0.5 / tilePixels.x;
    if (grid && counted)
        result = mix(result, majorColor.rgb, majorColor.a * lineAt(toTile));
    vec2 half_ = 1.0 / tilePixels;
    bool square = all(greaterThanEqual(uv, -half_)) && all(lessThanEqual(uv, usedTiles + half_));
    if (square)
        result = mix(result, majorColor.rgb, min(1.0, 2.4 * majorColor.a) * lineAt(toTile - 0.25));
    if (grid && nearest.y == 0.0 && uv.x >= 0.0)
        result = mix(result, axisX.rgb, 0.8 * clamp(0.5 * lineWidth + 0.5 - toTile.y, 0.0, 1.0));
    if (grid && nearest.x == 0.0 && uv.y >= 0.0)
        result = mix(result, axisY.rgb, 0.8 * clamp(0.5 * lineWidth + 0.5 - toTile.x, 0.0, 1.0));
    color = vec4(result, 1);
}
