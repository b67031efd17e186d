#include "views/control/bakechoice.h"

#include "solver/bake/bakemaps.h"

#include <QCborArray>
#include <QCoreApplication>
#include <QVariant>

#include <algorithm>

namespace autocuts {

namespace {

struct MapTitle
{
    const char *name, *title, *tip;
};
constexpr MapTitle titles[]{
    {"normal", QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Normals (tangent space)"),
     QT_TRANSLATE_NOOP("autocuts::BakeDialog", "MikkTSpace, as Blender and game engines use it")},
    {"object-normal", QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Normals (object space)"), ""},
    {"ao", QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Ambient occlusion"), ""},
    {"bent-normal", QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Bent normals"),
     QT_TRANSLATE_NOOP("autocuts::BakeDialog", "The mean direction from which light arrives")},
    {"curvature", QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Curvature"),
     QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Bright on edges, dark in grooves")},
    {"thickness", QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Thickness"), ""},
    {"position", QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Position"), ""},
    {"color", QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Colour"),
     QT_TRANSLATE_NOOP(
         "autocuts::BakeDialog",
         "From textures where there are any, else vertex colours, else the colours of materials")},
    {"material-id", QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Material ID"),
     QT_TRANSLATE_NOOP("autocuts::BakeDialog", "A colour for each material")},
    {"height", QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Height"),
     QT_TRANSLATE_NOOP("autocuts::BakeDialog", "Of the detailed model above this one")},
};

//! Visits every choice with its name in files, so that reading and writing use the same names.
template <typename Choice, typename Visit>
void visitChoices(Choice &choice, Visit visit)
{
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
}

const MapTitle *titleOf(const QString &name)
{
    const auto *found = std::ranges::find_if(
        titles, [&name](const MapTitle &map) { return name == QLatin1StringView(map.name); });
    return found == std::end(titles) ? nullptr : found;
}

QString translated(const char *text)
{
    return *text ? QCoreApplication::translate("autocuts::BakeDialog", text) : QString();
}

} // namespace

QCborMap BakeChoice::toCbor() const
{
    QCborMap map;
    visitChoices(*this, [&map](const char *key, const auto &value) { map[QLatin1StringView(key)] = value; });
    map[QLatin1StringView("direction")] = static_cast<int>(direction);
    map[QLatin1StringView("colors")] = static_cast<int>(colors);
    map[QLatin1StringView("maps")] = QCborArray::fromStringList(maps);
    return map;
}

BakeChoice BakeChoice::fromCbor(const QCborMap &map)
{
    BakeChoice choice;
    visitChoices(choice, [&map]<typename Value>(const char *key, Value &value) {
        const QVariant read = map.value(QLatin1StringView(key)).toVariant();
        if (read.canConvert<Value>())
            value = read.value<Value>();
    });
    if (!map.contains(QLatin1StringView("ownCage"))) // written before cages were proposed
        choice.ownCage = choice.cage != BakeChoice().cage;
    choice.direction = static_cast<Direction>(map.value(QLatin1StringView("direction")).toInteger());
    choice.colors = static_cast<Colors>(map.value(QLatin1StringView("colors")).toInteger());
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

QString bakeMapTitle(const QString &name)
{
    const MapTitle *map = titleOf(name);
    return map ? translated(map->title) : name;
}

QString bakeMapTip(const QString &name)
{
    const MapTitle *map = titleOf(name);
    return map ? translated(map->tip) : QString();
}

bool isTextureOfMaterials(const QString &name)
{
    return name == QLatin1StringView("normal") || name == QLatin1StringView("ao") ||
           name == QLatin1StringView("color");
}

} // namespace autocuts
