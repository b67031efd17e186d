#include "jobs/bakechoice.h"

#include "jobs/choicevalues.h"

#include <QCborArray>

#include <algorithm>

namespace autocuts::jobs {

namespace {

//! Visits every choice with its name in files, so that reading and writing use the same names.
constexpr auto visitChoices = [](auto &choice, const auto &visit) {
    visit("high", choice.high);
    visit("width", choice.width);
    visit("samplesPerSide", choice.samplesPerSide);
    visit("rays", choice.rays);
    visit("cage", choice.cage);
    visit("ownCage", choice.ownCage);
    visit("cageFile", choice.cageFile);
    visit("reach", choice.reach);
    visit("curvatureRadius", choice.curvatureRadius);
    visit("thicknessLimit", choice.thicknessLimit);
    visit("byName", choice.byName);
    visit("greenDown", choice.greenDown);
    visit("dilation", choice.dilation);
    visit("suffix", choice.suffix);
    visit("bits", choice.bits);
    visit("folder", choice.folder);
    visit("putOn", choice.putOn);
};

} // namespace

QCborMap BakeChoice::toCbor() const
{
    QCborMap map = valuesOf(*this, visitChoices);
    map[QLatin1StringView("direction")] = static_cast<int>(direction);
    map[QLatin1StringView("colors")] = static_cast<int>(colors);
    map[QLatin1StringView("maps")] = QCborArray::fromStringList(maps);
    return map;
}

BakeChoice BakeChoice::fromCbor(const QCborMap &map)
{
    BakeChoice choice;
    takeValues(map, choice, visitChoices);
    if (!map.contains(QLatin1StringView("ownCage"))) // written before cages were proposed
        choice.ownCage = choice.cage != BakeChoice().cage;
    takeEnumerator(map, QLatin1StringView("direction"), bake::CageDirection::Corrected, choice.direction);
    takeEnumerator(map, QLatin1StringView("colors"), ColorSource::Materials, choice.colors);
    if (const QCborValue maps = map.value(QLatin1StringView("maps")); maps.isArray())
        choice.maps = maps.toVariant().toStringList();
    return choice;
}

bool BakeChoice::isPutOn() const
{
    return putOn && std::ranges::any_of(maps, isTextureOfMaterials);
}

QStringList bakeMapNames()
{
    QStringList names;
    for (const auto &[name, kind] : bake::mapNames())
        names << QString::fromLatin1(name.data(), std::ssize(name));
    return names;
}

bool isTextureOfMaterials(const QString &name)
{
    return name == QLatin1StringView("normal") || name == QLatin1StringView("ao") ||
           name == QLatin1StringView("color");
}

} // namespace autocuts::jobs
