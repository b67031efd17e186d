#include "views/control/pictures/bakemaptexts.h"

#include <QCoreApplication>

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

} // namespace autocuts
