#include "model/document/scenegroups.h"

#include "model/plain/packingsettings.h"

#include <algorithm>
#include <map>

namespace autocuts {

std::vector<SceneGroup> sceneGroups(const Scene &scene, SceneKind kind)
{
    const bool objects = kind == SceneKind::Objects;
    const std::vector<QString> &names = objects ? scene.objectNames : scene.materialNames;
    const std::vector<int> &numbers = objects ? scene.mesh->faceObject : scene.faceMaterial;
    const auto numberOf = [&](std::size_t face) { return face < numbers.size() ? numbers[face] : -1; };
    std::vector<SceneGroup> groups(names.size() + 1);
    for (int face = 0; face < scene.mesh->faceCount(); ++face) {
        const int number = numberOf(static_cast<std::size_t>(face));
        const bool named = number >= 0 && static_cast<std::size_t>(number) < names.size();
        groups[named ? static_cast<std::size_t>(number) : names.size()].faces.append(face);
    }
    for (std::size_t i = 0; i < groups.size(); ++i) {
        groups[i].kind = kind;
        groups[i].number = i < names.size() ? static_cast<int>(i) : -1;
        groups[i].name = i < names.size() ? names[i] : QString();
    }
    std::erase_if(groups, [](const SceneGroup &group) { return group.faces.isEmpty(); });
    return groups;
}

std::vector<SceneGroup> tagGroups(const IslandMarks &marks, int faceCount)
{
    std::vector<int> groupOf(static_cast<std::size_t>(faceCount), static_cast<int>(marks.tags.size()));
    for (std::size_t tag = marks.tags.size(); tag-- > 0;) {
        for (const int face : marks.tags[tag].faces)
            groupOf[static_cast<std::size_t>(face)] = static_cast<int>(tag);
    }
    std::vector<SceneGroup> groups;
    for (const IslandTag &tag : marks.tags)
        groups.push_back({SceneKind::Tags, static_cast<int>(groups.size()), tag.name, {}});
    groups.push_back({SceneKind::Tags, -1, {}, {}});
    for (int face = 0; face < faceCount; ++face)
        groups[static_cast<std::size_t>(groupOf[static_cast<std::size_t>(face)])].faces.append(face);
    std::erase_if(groups, [](const SceneGroup &group) { return group.faces.isEmpty(); });
    return groups;
}

std::vector<int> groupOfFaces(const std::vector<SceneGroup> &groups, int faceCount)
{
    std::vector<int> groupOf(static_cast<std::size_t>(faceCount), 0);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        for (int face : groups[g].faces)
            groupOf[static_cast<std::size_t>(face)] = static_cast<int>(g);
    }
    return groupOf;
}

ChartMap dividedByObjects(ChartMap charts, const std::vector<SceneGroup> &groups)
{
    if (groups.empty() || groups.front().kind != SceneKind::Objects)
        return charts;
    const std::vector<int> groupOf = groupOfFaces(groups, static_cast<int>(charts.faceChart.size()));
    std::map<std::pair<int, int>, int> parts; // chart and object
    for (std::size_t f = 0; f < groupOf.size(); ++f) {
        int &chart = charts.faceChart[f];
        if (chart >= 0)
            chart = parts.try_emplace({chart, groupOf[f]}, static_cast<int>(parts.size())).first->second;
    }
    charts.count = static_cast<int>(parts.size());
    return charts;
}

std::vector<int> tilesOfGroups(const std::vector<SceneGroup> &groups, const ChartMap &charts, int first)
{
    if (groups.size() > static_cast<std::size_t>(PackingSettings::lastTile - first + 1))
        return {};
    std::vector<int> groupOf = groupOfFaces(groups, static_cast<int>(charts.faceChart.size()));
    std::vector<std::map<int, int>> votes(static_cast<std::size_t>(charts.count));
    for (std::size_t f = 0; f < groupOf.size(); ++f) {
        if (charts.faceChart[f] >= 0)
            ++votes[static_cast<std::size_t>(charts.faceChart[f])][groupOf[f]];
    }
    std::vector<int> winners;
    for (const std::map<int, int> &chart : votes) {
        const auto most = std::max_element(chart.begin(), chart.end(),
                                           [](const auto &a, const auto &b) { return a.second < b.second; });
        winners.push_back(most == chart.end() ? 0 : most->first);
    }
    for (std::size_t f = 0; f < groupOf.size(); ++f) {
        const int chart = charts.faceChart[f];
        groupOf[f] = first + (chart >= 0 ? winners[static_cast<std::size_t>(chart)] : groupOf[f]);
    }
    return groupOf;
}

} // namespace autocuts
