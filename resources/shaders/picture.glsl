uniform sampler2DArray pictures;
uniform usamplerBuffer pictureTable; // of sets: first entry, rows; then entries: picture, whether there is one

int numberOf(uvec4 texel)
{
    return int(texel.r | texel.g << 8 | texel.b << 16);
}

// The colour of a set of pictures, counted from 0, where a tile is 1 wide and high; transparent where it has none.
vec4 pictureAt(int set, vec2 place)
{
    vec2 dx = dFdx(place), dy = dFdy(place);
    uvec4 head = texelFetch(pictureTable, set);
    int entry = numberOf(head), rows = int(head.a);
    if (rows > 0) {
        vec2 tile = floor(place);
        if (any(lessThan(tile, vec2(0))) || tile.x >= 10.0 || tile.y >= float(rows))
            return vec4(0);
        entry += int(tile.x) + 10 * int(tile.y);
    }
    uvec4 picture = texelFetch(pictureTable, entry);
    if (picture.a == 0u)
        return vec4(0);
    return vec4(textureGrad(pictures, vec3(fract(place), numberOf(picture)), dx, dy).rgb, 1);
}
