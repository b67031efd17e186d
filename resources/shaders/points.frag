#version 330 core
// A round mark with a dark rim.

in vec4 fill;
out vec4 color;

uniform float size;

void main()
{
    float fromCentre = length(gl_PointCoord - 0.5) * size;
    float alpha = clamp(0.5 * size - fromCentre, 0.0, 1.0);
    if (alpha <= 0.0)
        discard;
    float rim = clamp(fromCentre - 0.5 * size + 2.0, 0.0, 1.0);
    color = vec4(mix(fill.rgb, vec3(0.06), 0.8 * rim) * alpha, alpha);
}
