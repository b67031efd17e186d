#include "cli/lightoptions.h"

#include "cli/optionmakers.h"

namespace autocuts {

namespace {

constexpr auto group = OptionGroup::Lighting;
using Color = Vec3f;
using Problem = std::optional<QString>;

template <class T>
Field<T> ofLights(T LightPlan::*member)
{
    return [member](CliOptions &options) -> T & { return options.light.lights.*member; };
}

template <class T>
Field<T> ofLight(T jobs::LightChoice::*member)
{
    return [member](CliOptions &options) -> T & { return options.light.*member; };
}

//! The finite numbers of a list; empty when there is anything else, or another number of them.
std::vector<double> numbersOf(const QString &value, QChar separator, qsizetype count)
{
    std::vector<double> numbers;
    for (const QString &part : value.split(separator)) {
        bool ok = false;
        numbers.push_back(part.toDouble(&ok));
        if (!ok || !(std::abs(numbers.back()) <= 1e9))
            return {};
    }
    return std::ssize(numbers) == count ? numbers : std::vector<double>();
}

//! "R,G,B", or one number for a grey.
std::optional<Color> colorOf(const QString &value)
{
    std::vector<double> numbers = numbersOf(value, u',', 3);
    if (numbers.empty())
        numbers = numbersOf(value, u',', 1);
    if (numbers.empty() || *std::min_element(numbers.begin(), numbers.end()) < 0)
        return std::nullopt;
    numbers.resize(3, numbers.front());
    return Vec3(numbers[0], numbers[1], numbers[2]).cast<float>();
}

Problem readSun(CliOptions &options, const QString &value)
{
    const std::vector<double> angles = numbersOf(value, u',', 2);
    if (angles.empty() || std::abs(angles[1]) > 90)
        return u"an azimuth and an elevation in degrees, as in 135,40"_s;
    options.light.lights.sun = Vec2(angles[0], angles[1]);
    return std::nullopt;
}

Problem readSunColor(CliOptions &options, const QString &value)
{
    const std::optional<Color> color = colorOf(value);
    if (!color)
        return u"a colour such as 1,.9,.8"_s;
    options.light.lights.sunColor = *color;
    return std::nullopt;
}

Problem readSky(CliOptions &options, const QString &value)
{
    std::vector<Color> colors;
    const bool isWord = value == u"day" || value == u"none";
    for (const QString &part : isWord ? QStringList() : value.split(u'/')) {
        const std::optional<Color> color = colorOf(part);
        if (!color || colors.size() == 3)
            return u"one to three colours such as .3,.5,.9/1, or day, or none"_s;
        colors.push_back(*color);
    }
    options.light.lights.day = value == u"day";
    options.light.lights.sky = colors;
    return std::nullopt;
}

Problem readArea(CliOptions &options, const QString &value)
{
    const QStringList parts = value.split(u':');
    const auto numbers = [&](int part, QChar separator, qsizetype count) {
        return parts.size() == 4 ? numbersOf(parts[part], separator, count) : std::vector<double>();
    };
    const std::vector<double> centre = numbers(0, u',', 3), target = numbers(1, u',', 3);
    const std::vector<double> size = numbers(2, u'x', 2);
    const std::optional<Color> color = parts.size() == 4 ? colorOf(parts[3]) : std::nullopt;
    if (centre.empty() || target.empty() || centre == target || size.empty() || !(size[0] > 0) ||
        !(size[1] > 0) || !color)
        return u"its centre, a point that it is aimed at, its size and its colour, as in "
               "0,3,0:0,0,0:2x1:10,9,8"_s;
    options.light.lights.areas.push_back(
        {Vec3(centre.data()), Vec3(target.data()), {size[0], size[1]}, *color});
    return std::nullopt;
}

Problem readEmission(CliOptions &options, const QString &value)
{
    const qsizetype colon = value.lastIndexOf(u':');
    const std::optional<Color> color = colon > 0 ? colorOf(value.mid(colon + 1)) : std::nullopt;
    if (!color)
        return u"the name of a material and a colour, as in Lamp:10,9,8"_s;
    options.light.surface.emission.emplace_back(value.left(colon), *color);
    return std::nullopt;
}

Problem readAlbedo(CliOptions &options, const QString &value)
{
    const std::optional<Color> color = colorOf(value);
    if (color && color->maxCoeff() > 1)
        return u"a colour from 0 to 1, or a picture"_s;
    options.light.surface.albedo = color;
    options.light.surface.albedoFile = color ? QString() : value;
    return std::nullopt;
}

CliOption row(const QString &name, const QString &value, const QString &meaning, const QString &standard,
              const CliOption::Reader &read)
{
    return {group, {name}, value, meaning, standard, read};
}

std::vector<CliOption> lampOptions()
{
    return {
        row(u"--sun"_s, u"AZIMUTH,ELEVATION"_s,
            u"a sun; degrees, the azimuth clockwise from north, which is -z, or y where z is up"_s, {},
            readSun),
        number(group, u"--sun-strength"_s, u"X"_s, ofLights(&LightPlan::sunStrength), 0, 1e9,
               u"light of the sun on a surface that faces it (irradiance)"_s),
        number(group, u"--sun-angle"_s, u"DEGREES"_s, ofLights(&LightPlan::sunAngle), 0, 90,
               u"diameter of the sun; a larger one makes softer shadows"_s),
        row(u"--sun-color"_s, u"R,G,B"_s, u"linear, as all colours here; one number is a grey"_s, u"1"_s,
            readSunColor),
        row(u"--sky"_s, u"COLOR[/COLOR[/COLOR]]|day|none"_s,
            u"light from all around (radiance): one colour, or those of zenith, horizon and ground; day: a "
            "clear sky with the place of --sun; when not given, 1 without other lights and none with them"_s,
            {}, readSky),
        number(group, u"--sky-strength"_s, u"X"_s, ofLights(&LightPlan::skyStrength), 0, 1e9,
               u"factor on the colours of the sky; for day, the luminance of the zenith"_s),
        number(group, u"--turbidity"_s, u"X"_s, ofLights(&LightPlan::turbidity), 2, 10,
               u"haze of --sky day: 2 is clear, 10 hazy"_s),
        row(u"--area-light"_s, u"X,Y,Z:X,Y,Z:WxH:R,G,B"_s,
            u"an area light: its centre, a point that it is aimed at, width and height, and radiance; "
            "may be given several times"_s,
            {}, readArea),
        row(u"--emit"_s, u"MATERIAL:R,G,B"_s,
            u"this material is emissive (radiance); may be given several times"_s, {}, readEmission),
        choice(group, u"--up"_s, ofLights(&LightPlan::zUp), {{u"y"_s, false}, {u"z"_s, true}},
               u"the axis that points to the zenith"_s),
    };
}

std::vector<CliOption> surfaceOptions()
{
    CliOption set = text(group, {u"--albedo-uv-set"_s}, Field<QString>([](CliOptions &options) -> QString & {
                             return options.light.surface.albedoUvSet;
                         }),
                         u"UV set of the picture of --albedo, by name or number; when not given, that of "
                         "the light map"_s);
    set.value = u"SET"_s;
    return {row(u"--albedo"_s, u"COLOR|FILE"_s,
                u"what the surface reflects: a colour, or a picture; when not given, its textures of base "
                "colours, else the colours of its vertices or materials, or else .8"_s,
                {}, readAlbedo),
            set};
}

} // namespace

std::vector<CliOption> lightOptions()
{
    using bake::LightValue;
    using jobs::LightChoice;
    std::vector<CliOption> options = lampOptions();
    for (const CliOption &option : surfaceOptions())
        options.push_back(option);
    const std::vector<CliOption> more{
        integer(group, u"--bounces"_s, ofLight(&LightChoice::bounces), 0, 1000,
                u"how often light is reflected before it arrives"_s),
        integer(group, u"--samples"_s, ofLight(&LightChoice::samples), 1, 1'000'000,
                u"paths of light per texel"_s),
        flag(group, u"--no-direct"_s, ofLight(&LightChoice::direct), false, u"leave out direct light"_s),
        flag(group, u"--no-indirect"_s, ofLight(&LightChoice::indirect), false,
             u"leave out light that was reflected"_s),
        choice(group, u"--values"_s, ofLight(&LightChoice::values),
               {{u"light"_s, LightValue::Light},
                {u"irradiance"_s, LightValue::Irradiance},
                {u"lit"_s, LightValue::Lit}},
               u"what is written: light that is multiplied by the colour of the surface (irradiance / pi), "
               "irradiance, or what is seen, with the colour of the surface"_s),
        flag(group, u"--no-denoise"_s, ofLight(&LightChoice::denoise), false, u"keep the noise"_s),
        integer(group, u"--dilation"_s, ofLight(&LightChoice::dilation), 0, 1024,
                u"texels around islands that are filled with the nearest value"_s),
        choice(group, u"--bits"_s, ofLight(&LightChoice::bits), {{u"8"_s, 8}, {u"16"_s, 16}, {u"32"_s, 32}},
               u"bits of each number: 16 and 32 for exr, whose numbers are linear and of any size; 8 and 16 "
               "for png and tif, 8 for tga, in sRGB and up to 1; when not given, 32 for exr and 8"_s),
    };
    options.insert(options.end(), more.begin(), more.end());
    return options;
}

} // namespace autocuts
