#version 330 core
// Marks of vertices, in space or in the map.

layout(location = 0) in vec3 position; // or u, v
layout(location = 1) in vec4 markColor;

uniform bool asMap;
uniform mat4 clipMatrix;
uniform vec2 mapScale, mapOffset;
uniform float size;

out vec4 fill;

void main()
{
    fill = markColor;
    gl_PointSize = size;
    if (asMap) {
        gl_Position = vec4(position.xy * mapScale + mapOffset, 0, 1);
    } else {
        gl_Position = clipMatrix * vec4(position, 1);
        gl_Position.z -= 0.0015 * gl_Position.w; // before the faces around it
    }
}
