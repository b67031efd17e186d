// Light from the surroundings, and how it gets onto the screen.
uniform samplerCube environment; // level k: what a surface of the roughness k / 5 reflects
uniform vec3 irradiance[9];      // of a diffuse surface: spherical harmonics
uniform mat3 toEnvironment;      // from the space of the directions that are given
uniform float exposure;

vec3 linearColor(vec3 srgb)
{
    return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, srgb));
}

// Colours below 0.8 stay as they are, brighter ones are compressed and lose colour towards white (Khronos PBR
// Neutral tone mapper); then sRGB.
vec3 onScreen(vec3 light)
{
    vec3 c = light * exposure;
    float least = min(c.r, min(c.g, c.b));
    c -= least < 0.08 ? least - 6.25 * least * least : 0.04;
    float peak = max(c.r, max(c.g, c.b));
    if (peak > 0.76) {
        float compressed = 1.0 - 0.0576 / (peak - 0.52);
        c *= compressed / peak;
        c = mix(c, vec3(compressed), 1.0 - 1.0 / (0.15 * (peak - compressed) + 1.0));
    }
    c = clamp(c, 0.0, 1.0);
    return mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

vec3 diffuseLight(vec3 direction)
{
    vec3 d = toEnvironment * direction;
    vec3 light = irradiance[0] + irradiance[1] * d.y + irradiance[2] * d.z + irradiance[3] * d.x +
                 irradiance[4] * d.x * d.y + irradiance[5] * d.y * d.z + irradiance[6] * (3.0 * d.z * d.z - 1.0) +
                 irradiance[7] * d.x * d.z + irradiance[8] * (d.x * d.x - d.y * d.y);
    return max(light, vec3(0));
}

vec3 reflectedLight(vec3 direction, float roughness)
{
    return textureLod(environment, toEnvironment * direction, 5.0 * roughness).rgb;
}
