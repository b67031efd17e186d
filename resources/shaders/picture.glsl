uniform sampler2DArray pictures;
uniform usamplerBuffer pictureTable; // of sets: first entry, rows; then entries: picture, whether there is one
uniform int pictureLayers; // of a picture: 1 its colour; 3 the channels of a texture set, see Pictures::layers
uniform int shownChannel;  // of a texture set, as TextureChannel

int numberOf(uvec4 texel)
{
    return int(texel.r | texel.g << 8 | texel.b << 16);
}

// The first layer of a set of pictures, counted from 0, where a tile is 1 wide and high; -1 where it has none.
int layerAt(int set, vec2 place)
{
    uvec4 head = texelFetch(pictureTable, set);
    int entry = numberOf(head), rows = int(head.a);
    if (rows > 0) {
        vec2 tile = floor(place);
        if (any(lessThan(tile, vec2(0))) || tile.x >= 10.0 || tile.y >= float(rows))
            return -1;
        entry += int(tile.x) + 10 * int(tile.y);
    }
    uvec4 picture = texelFetch(pictureTable, entry);
    return picture.a == 0u ? -1 : numberOf(picture);
}

// The normal of a layer's first two numbers.
vec3 normalOf(vec2 numbers)
{
    vec2 xy = (numbers * 255.0 - 128.0) / 127.0;
    return vec3(xy, sqrt(max(1.0 - dot(xy, xy), 0.0)));
}

// The colour that is shown for a set; transparent where it has none.
vec4 pictureAt(int set, vec2 place)
{
    vec2 dx = dFdx(place), dy = dFdy(place);
    int layer = layerAt(set, place);
    if (layer < 0)
        return vec4(0);
    int channel = pictureLayers == 1 ? 0 : shownChannel;
    int offset = channel == 0 || channel == 6 ? 0 : channel < 4 ? 1 : 2;
    vec4 texel = textureGrad(pictures, vec3(fract(place), layer + offset), dx, dy);
    if (channel == 0 || channel == 5)
        return vec4(texel.rgb, 1);
    if (channel == 3)
        return vec4(normalOf(texel.rg) * 0.5 + 0.5, 1);
    return vec4(vec3(channel == 1 ? texel.b : texel.a), 1);
}
