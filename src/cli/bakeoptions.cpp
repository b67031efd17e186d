#include "cli/bakeoptions.h"

#include "cli/optionmakers.h"

namespace autocuts {

namespace {

constexpr auto group = OptionGroup::Baking;

template <class T>
Field<T> ofBake(T jobs::BakeChoice::*member)
{
    return [member](CliOptions &options) -> T & { return options.bake.*member; };
}

std::optional<QString> readMaps(CliOptions &options, const QString &value)
{
    const QStringList known = jobs::bakeMapNames();
    QStringList maps = value.split(u',');
    maps.removeDuplicates();
    for (const QString &map : maps) {
        if (!known.contains(map))
            return u"some of %1, with commas"_s.arg(known.join(u", "_s));
    }
    options.bake.maps = maps;
    return std::nullopt;
}

std::optional<QString> readSamples(CliOptions &options, const QString &value)
{
    for (const int perSide : {1, 2, 3, 4, 6, 8}) {
        if (value == QString::number(perSide * perSide)) {
            options.bake.samplesPerSide = perSide;
            return std::nullopt;
        }
    }
    return u"1, 4, 9, 16, 36 or 64"_s;
}

//! Also takes the word that stands for a measured distance.
CliOption cageOption()
{
    CliOption option = number(
        group, u"--cage"_s, u"X|auto"_s, ofBake(&jobs::BakeChoice::cage), 1e-6, 1,
        u"how far the detailed model is looked for, outside and inside of the surface, as a share of the "
        "diagonal of the input's bounding box; auto: measured from the distance of both models, as the "
        "studio proposes it, and named in the report"_s);
    option.read = [ofNumber = option.read](CliOptions &options, const QString &value) {
        const bool proposed = value == u"auto";
        std::optional<QString> problem = proposed ? std::nullopt : ofNumber(options, value);
        if (problem)
            *problem += u", or auto"_s;
        else
            options.bake.ownCage = !proposed;
        return problem;
    };
    return option;
}

CliOption ofValue(CliOption option, const QString &value)
{
    option.value = value;
    return option;
}

} // namespace

std::vector<CliOption> bakeOptions()
{
    return {
        text(group, {u"--high"_s}, ofBake(&jobs::BakeChoice::high),
             u"the detailed model, whose surface is baked; otherwise that of the input itself"_s),
        {group,
         {u"--maps"_s},
         u"LIST"_s,
         u"what to bake, with commas: normal (tangent space, MikkTSpace), object-normal, ao (occlusion), "
         "bent-normal, curvature, thickness, position, color, material-id, "
         "height"_s,
         u"normal,ao"_s,
         readMaps},
        {group,
         {u"--samples"_s},
         u"N"_s,
         u"places in each texel that are baked, and averaged: 1, 4, 9, 16, 36 or 64"_s,
         u"4"_s,
         readSamples},
        integer(group, u"--rays"_s, ofBake(&jobs::BakeChoice::rays), 1, 65536,
                u"rays per texel for ao, bent-normal, curvature and thickness"_s),
        cageOption(),
        text(group, {u"--cage-file"_s}, ofBake(&jobs::BakeChoice::cageFile),
             u"in place of --cage: the input with its vertices moved outwards; rays run from there through "
             "the surface, and as far behind it"_s),
        choice(group, u"--cage-direction"_s, ofBake(&jobs::BakeChoice::direction),
               {{u"smooth"_s, bake::CageDirection::Smoothed},
                {u"shading"_s, bake::CageDirection::Shading},
                {u"corrected"_s, bake::CageDirection::Corrected}},
               u"how rays leave the surface: along normals that are smooth over all edges (no gaps), along "
               "the shading normals (gaps at hard edges), or smooth beside edges and straight elsewhere, so "
               "that details are not skewed"_s),
        flag(group, u"--by-name"_s, ofBake(&jobs::BakeChoice::byName), true,
             u"objects see those of the same name only; endings such as _low and _high do not count"_s),
        number(group, u"--ray-reach"_s, u"X"_s, ofBake(&jobs::BakeChoice::reach), 0, 1e6,
               u"occluders that are farther away do not count, as a share of the diagonal; 0: all do"_s),
        number(group, u"--curvature-radius"_s, u"X"_s, ofBake(&jobs::BakeChoice::curvatureRadius), 1e-6, 1,
               u"size of what shows as curvature, as a share of the diagonal"_s),
        number(group, u"--thickness-limit"_s, u"X"_s, ofBake(&jobs::BakeChoice::thicknessLimit), 1e-6, 10,
               u"thickness that is white, as a share of the diagonal"_s),
        ofValue(integer(group, u"--dilation"_s, ofBake(&jobs::BakeChoice::dilation), 0, 1024,
                        u"texels around islands that are filled with the nearest value"_s),
                u"TEXELS"_s),
        choice(group, u"--format"_s, ofBake(&jobs::BakeChoice::suffix),
               {{u"png"_s, u"png"_s}, {u"tif"_s, u"tif"_s}, {u"tga"_s, u"tga"_s}, {u"exr"_s, u"exr"_s}},
               u"format of the pictures; in exr, colours are linear, and positions and heights have the "
               "units of the model"_s),
        choice(
            group, u"--bits"_s, ofBake(&jobs::BakeChoice::bits), {{u"8"_s, 8}, {u"16"_s, 16}, {u"32"_s, 32}},
            u"bits of each number: 8 and 16 for png and tif, 8 for tga, 16 and 32 for exr; when not given, "
            "8, and 32 for exr"_s),
        flag(group, u"--directx"_s, ofBake(&jobs::BakeChoice::greenDown), true,
             u"tangent space normals with green down, as DirectX programs want them"_s),
        choice(group, u"--color-from"_s, ofBake(&jobs::BakeChoice::colors),
               {{u"auto"_s, ColorSource::Auto},
                {u"textures"_s, ColorSource::Textures},
                {u"vertices"_s, ColorSource::Vertices},
                {u"materials"_s, ColorSource::Materials}},
               u"what color shows: textures of base colours, vertex colours, or colours of materials; auto "
               "takes, at each place, the first of them that the model has"_s),
    };
}

} // namespace autocuts
