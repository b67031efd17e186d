// Physically based shading: GGX and Lambert under the light of the surroundings.
#include "light.glsl"
in vec4 eyeTangent; // along growing u; w: side of the bitangent, 0 where there are no tangents

struct Material
{
    vec3 base; // linear
    float roughness, metalness, occlusion;
    vec3 emission;
    vec3 normal; // in tangent space
};

// The frame of the normal map: MikkTSpace does not normalise what is interpolated. Without tangents it follows
// from the change of the UVs on the screen.
vec3 mappedNormal(vec3 smoothNormal, vec3 mapped, vec2 uv)
{
    vec3 n = smoothNormal, t = eyeTangent.xyz, b = eyeTangent.w * cross(n, t);
    if (abs(eyeTangent.w) < 0.5) {
        vec3 dx = dFdx(eyePosition), dy = dFdy(eyePosition);
        vec2 ux = dFdx(uv), uy = dFdy(uv);
        n = normalize(n);
        float facing = dot(cross(dx, dy), n) < 0.0 ? -1.0 : 1.0;
        vec3 acrossY = cross(dy, n), acrossX = cross(n, dx);
        t = facing * (acrossY * ux.x + acrossX * uy.x);
        b = facing * (acrossY * ux.y + acrossX * uy.y);
        float longest = max(dot(t, t), dot(b, b));
        float scale = longest > 1e-30 ? inversesqrt(longest) : 0.0;
        t *= scale;
        b *= scale;
    }
    vec3 result = mapped.x * t + mapped.y * b + mapped.z * n;
    return dot(result, result) > 1e-12 ? normalize(result) : normalize(smoothNormal);
}

// The share of reflected light that a surface gives back (B. Karis, "Physically Based Shading on Mobile", 2014).
vec3 reflectance(vec3 straight, float roughness, float cosine)
{
    vec4 r = roughness * vec4(-1, -0.0275, -0.572, 0.022) + vec4(1, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * cosine)) * r.x + r.y;
    vec2 ab = vec2(-1.04, 1.04) * a + r.zw;
    return straight * ab.x + ab.y;
}

vec3 shaded(Material m, vec3 smoothNormal, vec3 toEye)
{
    vec3 n = m.normal;
    float cosine = clamp(dot(n, toEye), 0.0, 1.0);
    vec3 mirrored = reflect(-toEye, n);
    vec3 straight = mix(vec3(0.04), m.base, m.metalness);
    vec3 share = reflectance(straight, m.roughness, cosine);
    // Occlusion of reflections (S. Lagarde, 2014), and none from below the surface.
    float open = clamp(pow(cosine + m.occlusion, exp2(-16.0 * m.roughness - 1.0)) - 1.0 + m.occlusion, 0.0, 1.0);
    float horizon = clamp(1.0 + dot(mirrored, smoothNormal), 0.0, 1.0);
    vec3 diffuse = m.base * (1.0 - m.metalness) * (1.0 - max(share.r, max(share.g, share.b)));
    return diffuse * diffuseLight(n) * m.occlusion +
           share * reflectedLight(mirrored, m.roughness) * open * horizon * horizon + m.emission;
}
