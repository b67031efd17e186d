#include "jobs/lightchoice.h"

#include "jobs/choicevalues.h"

#include <QCborArray>

#include <cmath>

namespace autocuts::jobs {

namespace {

//! Visits every number, switch and text with its name in files.
constexpr auto visitLight = [](auto &choice, const auto &visit) {
    visit("uvSet", choice.uvSet);
    visit("textureSize", choice.textureSize);
    visit("samples", choice.samples);
    visit("bounces", choice.bounces);
    visit("direct", choice.direct);
    visit("indirect", choice.indirect);
    visit("denoise", choice.denoise);
    visit("dilation", choice.dilation);
    visit("path", choice.path);
    visit("bits", choice.bits);
    visit("sunHidden", choice.lights.sunHidden);
    visit("sunStrength", choice.lights.sunStrength);
    visit("sunAngle", choice.lights.sunAngle);
    visit("day", choice.lights.day);
    visit("skyStrength", choice.lights.skyStrength);
    visit("turbidity", choice.lights.turbidity);
    visit("zUp", choice.lights.zUp);
    visit("albedoFile", choice.surface.albedoFile);
    visit("albedoUvSet", choice.surface.albedoUvSet);
};

template <typename... Vectors>
QCborArray numbersOf(const Vectors &...vectors)
{
    QCborArray numbers;
    const auto add = [&numbers](const auto &vector) {
        for (const auto value : vector)
            numbers << static_cast<double>(value);
    };
    (add(vectors), ...);
    return numbers;
}

//! Fills the vectors one after the other. False when there are not so many finite numbers.
template <typename... Vectors>
bool takeNumbers(const QCborValue &value, Vectors &...vectors)
{
    const QCborArray numbers = value.toArray();
    qsizetype next = 0;
    bool fine = numbers.size() == (vectors.size() + ...);
    const auto take = [&](auto &vector) {
        for (auto &number : vector) {
            const double read = numbers.at(next++).toDouble(std::nan(""));
            fine = fine && std::isfinite(read);
            number = static_cast<std::remove_reference_t<decltype(number)>>(read);
        }
    };
    if (fine)
        (take(vectors), ...);
    return fine;
}

QLatin1StringView key(const char *name)
{
    return QLatin1StringView(name);
}

} // namespace

QCborMap LightChoice::toCbor() const
{
    QCborMap map = valuesOf(*this, visitLight);
    map[key("values")] = static_cast<int>(values);
    if (lights.sun)
        map[key("sun")] = numbersOf(*lights.sun);
    map[key("sunColor")] = numbersOf(lights.sunColor);
    if (surface.albedo)
        map[key("albedo")] = numbersOf(*surface.albedo);
    if (lights.sky) {
        QCborArray colors;
        for (const Vec3f &color : *lights.sky)
            colors << numbersOf(color);
        map[key("sky")] = colors;
    }
    QCborArray areas, emission;
    for (const LightPlan::Area &area : lights.areas)
        areas << numbersOf(area.centre, area.target, area.size, area.radiance);
    map[key("areas")] = areas;
    for (const auto &[material, radiance] : surface.emission)
        emission << QCborArray{material, numbersOf(radiance)};
    map[key("emission")] = emission;
    return map;
}

LightChoice LightChoice::fromCbor(const QCborMap &map)
{
    LightChoice choice;
    takeValues(map, choice, visitLight);
    takeEnumerator(map, key("values"), bake::LightValue::Lit, choice.values);
    if (Vec2 sun; takeNumbers(map.value(key("sun")), sun))
        choice.lights.sun = sun;
    if (Vec3f color; takeNumbers(map.value(key("sunColor")), color))
        choice.lights.sunColor = color;
    if (Vec3f albedo; takeNumbers(map.value(key("albedo")), albedo))
        choice.surface.albedo = albedo;
    if (const QCborValue sky = map.value(key("sky")); sky.isArray()) {
        choice.lights.sky.emplace();
        for (const QCborValue value : sky.toArray()) {
            if (Vec3f color; choice.lights.sky->size() < 3 && takeNumbers(value, color))
                choice.lights.sky->push_back(color);
        }
    }
    for (const QCborValue value : map.value(key("areas")).toArray()) {
        if (LightPlan::Area area; takeNumbers(value, area.centre, area.target, area.size, area.radiance))
            choice.lights.areas.push_back(area);
    }
    for (const QCborValue value : map.value(key("emission")).toArray()) {
        const QCborArray entry = value.toArray();
        if (Vec3f radiance; takeNumbers(entry.at(1), radiance))
            choice.surface.emission.emplace_back(entry.at(0).toString(), radiance);
    }
    return choice;
}

} // namespace autocuts::jobs
