#version 330 core
// What is behind the model: a soft gradient and a grid on the ground.

in vec2 place;
out vec4 color;

uniform vec4 topColor, bottomColor, gridColor;
uniform vec4 axisX, axisZ;
uniform mat4 toFrame; // from the clip space to the frame of the mesh
uniform float groundHeight, gridStep;
uniform float pixelRatio;
uniform bool grid;

const bool surroundings = SURROUNDINGS; // are shown

#include "light.glsl"

float line(float place, float width)
{
    return clamp(0.5 * pixelRatio + 0.6 - abs(place) / max(width, 1e-7), 0.0, 1.0);
}

void main()
{
    float t = smoothstep(-1.1, 1.1, place.y + 0.15 * place.x * place.x);
    color = mix(bottomColor, topColor, t);
    vec4 nearPoint = toFrame * vec4(place, -1, 1), farPoint = toFrame * vec4(place, 1, 1);
    vec3 from = nearPoint.xyz / nearPoint.w, to = farPoint.xyz / farPoint.w;
    if (surroundings) // a little out of focus, so that the model stands out
        color = vec4(onScreen(reflectedLight(normalize(to - from), 0.22)), 1);
    if (!grid)
        return;
    float slope = to.y - from.y;
    float s = (groundHeight - from.y) / (abs(slope) < 1e-9 ? 1e-9 : slope);
    vec2 ground = (from + s * (to - from)).xz;
    vec2 width = max(fwidth(ground), vec2(1e-7));
    if (s <= 0.0)
        return;
    float distance = length(ground);
    vec2 minor = abs(fract(ground / gridStep + 0.5) - 0.5) * gridStep;
    float lines = max(line(minor.x, width.x), line(minor.y, width.y));
    float dense = max(width.x, width.y) / gridStep;
    float fade = (1.0 - smoothstep(1.6, 4.5, distance)) * (1.0 - smoothstep(0.15, 0.5, dense));
    color = mix(color, vec4(gridColor.rgb, 1), gridColor.a * lines * fade);
    float axisFade = (1.0 - smoothstep(2.0, 4.5, distance)) * 0.75;
    color = mix(color, axisX, axisFade * line(ground.y, width.y));
    color = mix(color, axisZ, axisFade * line(ground.x, width.x));
}
