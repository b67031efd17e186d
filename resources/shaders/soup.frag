#version 330 core
// A triangle with its half of the lines along its sides: what a line covers follows from the distance to the
// side in pixels, so that lines are smooth, equally wide everywhere and need no geometry of their own.

noperspective in vec3 barycentric;
flat in int triangle;
in vec3 eyePosition, eyeNormal;
in vec2 texturePlace;
out vec4 color;

uniform usamplerBuffer faceTexels; // per triangle: red, green, blue, marks
uniform usamplerBuffer sideTexels; // per side: base style, opacity at both ends, top style
uniform usamplerBuffer islandTexels; // per triangle: number of its island, lowest byte first
uniform usamplerBuffer setTexels; // per triangle: its set of pictures, counted from 1, lowest byte first
uniform int onlySet; // all triangles have this set, counted from 1; 0: see setTexels
uniform bool smoothShading;
uniform mat4 projectionMatrix;
uniform float tint; // share of the face colour over a picture
uniform float pictureHeight; // of the picture in texture space, where it is 1 wide
uniform float pixelRatio, checkerSize, fillOpacity, lineOpacity;
uniform bool onPicture; // in the map, a picture lies behind
uniform bool unlit;  // colours are shown as they are
uniform ivec2 hoverTriangles, hoverSides;
uniform uint hoverIsland;
uniform vec4 sideColors[9];
uniform float sideHalfWidths[8];
uniform float selectionShare; // of its colour over that of a face
uniform vec4 selectionColor, hoverColor, overlapColor, flippedColor;

#include "picture.glsl"
#include "physical.glsl"

// Known when the shader is compiled: light and pictures are most of it, and few views need them.
#ifdef IN_MAP
const bool asMap = true;
#else
const bool asMap = false;
#endif
const int pattern = PATTERN; // 0 none, 1 checker, 2 picture, 3 texture sets under light, not in the map
const bool inLight = pattern == 3;

const uint selectedMark = 1u, overlapMark = 2u, flippedMark = 4u, withoutUvMark = 8u;
const uint wireStyle = 1u, seamStyle = 3u, givenStyle = 7u;

// Smoothed checker: the share of the second colour, grey where squares are smaller than pixels.
float checker(vec2 place)
{
    vec2 p = place * checkerSize;
    vec2 width = max(fwidth(p), vec2(1e-6));
    vec2 wave = 2.0 * abs(fract(p * 0.5) - 0.5) - 0.5;
    vec2 share = clamp(wave / width + 0.5, 0.0, 1.0);
    float sharp = share.x * (1.0 - share.y) + share.y * (1.0 - share.x);
    return mix(sharp, 0.5, smoothstep(0.5, 1.2, max(width.x, width.y)));
}

int setOfTriangle()
{
    return onlySet > 0 ? onlySet : numberOf(texelFetch(setTexels, triangle));
}

// What the texture set says, or the colour of the face where there is none.
Material materialAt(vec3 face, uint marks)
{
    Material m = Material(linearColor(face), 0.6, 0.0, 1.0, vec3(0), vec3(0, 0, 1));
    vec2 place = texturePlace / vec2(1.0, pictureHeight);
    vec2 dx = dFdx(place), dy = dFdy(place);
    int set = setOfTriangle();
    int layer = set > 0 && (marks & withoutUvMark) == 0u ? layerAt(set - 1, place) : -1;
    vec3 mapped = vec3(0, 0, 1);
    if (layer >= 0) {
        vec3 base = textureGrad(pictures, vec3(fract(place), layer), dx, dy).rgb;
        vec4 shape = textureGrad(pictures, vec3(fract(place), layer + 1), dx, dy);
        vec4 glow = textureGrad(pictures, vec3(fract(place), layer + 2), dx, dy);
        m.base = linearColor(mix(base, face, tint));
        m.roughness = max(shape.b, 0.03);
        m.metalness = shape.a;
        m.emission = linearColor(glow.rgb);
        m.occlusion = glow.a;
        mapped = normalOf(shape.rg);
    }
    m.normal = mappedNormal(eyeNormal, mapped, texturePlace);
    return m;
}

vec3 physical(vec3 face, uint marks)
{
    Material m = materialAt(face, marks);
    bool perspective = projectionMatrix[3][3] == 0.0;
    vec3 toEye = perspective ? -normalize(eyePosition) : vec3(0, 0, 1);
    vec3 n = normalize(eyeNormal);
    if (!gl_FrontFacing) {
        n = -n;
        m.normal = -m.normal;
    }
    vec3 result = onScreen(shaded(m, n, toEye));
    return gl_FrontFacing ? result : mix(result, vec3(0.20, 0.17, 0.19), 0.62);
}

vec3 surface(vec3 face, uint marks)
{
    if (pattern == 0 || (marks & withoutUvMark) != 0u)
        return face;
    if (pattern == 2) {
        int set = setOfTriangle();
        vec4 picture = set > 0 ? pictureAt(set - 1, texturePlace / vec2(1.0, pictureHeight)) : vec4(0);
        return mix(face, mix(picture.rgb, face, tint), picture.a);
    }
    return face * mix(1.12, 0.48, checker(texturePlace));
}

// A light beside the eye, and one from above that leaves no side black.
vec3 lit(vec3 surfaceColor)
{
    vec3 flatNormal = cross(dFdx(eyePosition), dFdy(eyePosition));
    flatNormal *= inversesqrt(max(dot(flatNormal, flatNormal), 1e-30));
    bool perspective = projectionMatrix[3][3] == 0.0;
    vec3 toEye = perspective ? -normalize(eyePosition) : vec3(0, 0, 1);
    if (dot(flatNormal, toEye) < 0.0)
        flatNormal = -flatNormal;
    vec3 n = smoothShading ? normalize(eyeNormal) : flatNormal;
    if (smoothShading && !gl_FrontFacing)
        n = -n;
    float head = max(dot(n, normalize(vec3(-0.25, 0.35, 1.0))), 0.0);
    float sky = 0.5 + 0.5 * n.y;
    float rim = pow(1.0 - max(dot(n, toEye), 0.0), 3.0);
    vec3 light = vec3(0.16) + 0.62 * head + mix(vec3(0.10, 0.09, 0.08), vec3(0.24, 0.26, 0.29), sky);
    vec3 result = surfaceColor * light + 0.10 * rim * vec3(0.6, 0.7, 0.8);
    return gl_FrontFacing ? result : mix(result, vec3(0.20, 0.17, 0.19), 0.62);
}

float stripes(vec2 direction, float period)
{
    float place = dot(gl_FragCoord.xy / pixelRatio, direction) / period;
    float wave = abs(fract(place) - 0.5) * period * pixelRatio;
    return clamp(period * pixelRatio * 0.12 - wave + 0.5, 0.0, 1.0);
}

vec4 marked(vec4 face, uint marks)
{
    bool hovered = triangle >= hoverTriangles.x && triangle < hoverTriangles.y;
    if (hoverIsland != 0u) {
        uvec4 bytes = texelFetch(islandTexels, triangle);
        hovered = (bytes.r | (bytes.g << 8) | (bytes.b << 16) | (bytes.a << 24)) == hoverIsland;
    }
    if ((marks & selectedMark) != 0u)
        face = vec4(mix(face.rgb, selectionColor.rgb, selectionShare), max(face.a, 0.5));
    // In light they would hide the textures, which often lie mirrored and one over another; the map shows them.
    bool problems = !inLight;
    if (problems && (marks & flippedMark) != 0u) {
        face = vec4(mix(face.rgb, flippedColor.rgb, 0.55), max(face.a, 0.6));
        face = mix(face, vec4(flippedColor.rgb, 1), stripes(vec2(0.7071, -0.7071), 7.0));
    }
    if (problems && (marks & overlapMark) != 0u)
        face = mix(face, vec4(overlapColor.rgb, 1), 0.75 * stripes(vec2(0.7071, 0.7071), 9.0));
    if (hovered)
        face = vec4(mix(face.rgb, hoverColor.rgb, 0.32), max(face.a, 0.42));
    return face;
}

// Lays a line over what is there. inside: distance to the side in pixels
vec4 over(vec4 below, vec4 line, float halfWidth, float inside)
{
    // Lines thinner than a pixel are drawn a pixel wide and fainter.
    float alpha = line.a * lineOpacity * clamp(halfWidth - inside + 0.5, 0.0, 1.0);
    float total = alpha + below.a * (1.0 - alpha);
    return total <= 0.0 ? below : vec4((line.rgb * alpha + below.rgb * below.a * (1.0 - alpha)) / total, total);
}

// Behind islands on a picture any colour may lie: a dark rim makes lines visible on all of them.
vec4 withRim(vec4 below, vec4 line, float halfWidth, float inside)
{
    return onPicture ? over(below, vec4(0, 0, 0, 0.55 * line.a), halfWidth + pixelRatio, inside) : below;
}

void main()
{
    uvec4 face = texelFetch(faceTexels, triangle);
    vec3 faceColor = vec3(face.rgb) / 255.0;
    vec4 result = vec4(0, 0, 0, fillOpacity);
    if (inLight) {
        result.rgb = physical(faceColor, face.a);
    } else {
        vec3 base = surface(faceColor, face.a);
        result.rgb = asMap || unlit ? base : lit(base);
    }
    result = marked(result, face.a);

    // Height of the triangle over each side, and distance to it, in pixels. Side k is opposite corner k + 2.
    vec3 dx = dFdx(barycentric), dy = dFdy(barycentric);
    vec3 heights = inversesqrt(max(dx * dx + dy * dy, vec3(1e-20)));
    vec3 distances = max(barycentric, vec3(0)) * heights;
    for (int k = 0; k < 3; ++k) {
        int opposite = k == 0 ? 2 : k - 1;
        int side = 3 * triangle + k;
        uvec4 texel = texelFetch(sideTexels, side);
        float inside = distances[opposite];
        if (texel.r != 0u) {
            vec4 line = sideColors[texel.r];
            if (texel.r == wireStyle) // where triangles are a few pixels high, lines would cover all
                line.a *= smoothstep(1.5 * pixelRatio, 9.0 * pixelRatio, heights[opposite]);
            if (texel.r == wireStyle && inLight) // textures in light are to be seen
                line.a *= 0.3;
            if (texel.r == wireStyle && asMap && dot(result.rgb, vec3(0.3, 0.6, 0.1)) * result.a > 0.45)
                line.rgb = vec3(0.1); // a pale line would not be seen on a bright face
            result = withRim(result, line, sideHalfWidths[texel.r], inside);
            result = over(result, line, sideHalfWidths[texel.r], inside);
        }
        if (texel.a != 0u) {
            float first = barycentric[k], second = barycentric[k == 2 ? 0 : k + 1];
            float along = clamp(second / max(first + second, 1e-6), 0.0, 1.0);
            vec4 line = sideColors[texel.a];
            line.a *= mix(float(texel.g), float(texel.b), along) / 255.0;
            // In the map both sides of a seam are apart: each shows the whole line.
            float width = sideHalfWidths[texel.a] * (asMap && (texel.a == seamStyle || texel.a == givenStyle) ? 1.4 : 1.0);
            result = withRim(result, line, width, inside);
            result = over(result, line, width, inside);
        }
        if (side == hoverSides.x || side == hoverSides.y)
            result = over(result, vec4(hoverColor.rgb, 1), 2.2 * pixelRatio, inside);
    }
    if (result.a <= 0.0)
        discard;
    color = vec4(result.rgb * result.a, result.a); // premultiplied
}
