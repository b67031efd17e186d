#version 330 core
// Corners of the triangle soup, at their place in space or, with IN_MAP, in the map.

layout(location = 0) in vec3 position; // in the frame of the mesh
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 tangent;

uniform bool hasTangents;

uniform usamplerBuffer faceTexels; // per triangle: red, green, blue, marks
uniform mat4 viewMatrix, projectionMatrix;
uniform vec2 mapScale, mapOffset;
uniform ivec2 hoverTriangles;

noperspective out vec3 barycentric; // linear on the screen: its gradient gives distances in pixels
flat out int triangle;
out vec3 eyePosition, eyeNormal;
out vec2 texturePlace;
out vec4 eyeTangent;

#ifdef IN_MAP
const bool asMap = true;
#else
const bool asMap = false;
#endif
const float noUv = 1e29; // corners without UV have more
const uint hiddenMark = 16u, buriedMark = 32u;

uint marksOfFace()
{
    return texelFetch(faceTexels, triangle).a;
}

// In the map what is marked lies above what is not, so that it is seen where the map covers itself.
float height()
{
    return -0.1 * float(marksOfFace() & 7u);
}

void main()
{
    triangle = gl_VertexID / 3;
    int corner = gl_VertexID % 3;
    barycentric = vec3(corner == 0, corner == 1, corner == 2);
    texturePlace = uv.x < noUv ? uv : vec2(0);
    vec4 eye = viewMatrix * vec4(position, 1);
    eyePosition = eye.xyz;
    eyeNormal = mat3(viewMatrix) * normal;
    eyeTangent = vec4(mat3(viewMatrix) * tangent.xyz, hasTangents ? tangent.w : 0.0);
    bool hovered = triangle >= hoverTriangles.x && triangle < hoverTriangles.y;
    bool buried = asMap && !hovered && (marksOfFace() & buriedMark) != 0u;
    bool shown = (marksOfFace() & hiddenMark) == 0u && !buried;
    if (shown && !asMap)
        gl_Position = projectionMatrix * eye;
    else if (shown && uv.x < noUv)
        gl_Position = vec4(uv * mapScale + mapOffset, height(), 1);
    else
        gl_Position = vec4(2, 2, 2, 1); // all three corners in one place outside
}
