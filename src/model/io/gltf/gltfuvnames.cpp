#include "model/io/gltf/gltfuvnames.h"

#include "model/io/gltf/gltfsource.h"

#include <set>

namespace autocuts {

namespace {

constexpr const char *key = "uvSetNames";

} // namespace

std::map<int, QString> gltfUvNames(const Json &root, const std::vector<int> &texcoords)
{
    std::map<int, QString> names;
    std::set<QString> taken;
    for (const int n : texcoords) {
        QString name;
        for (const Json &mesh : member(root, "meshes")) {
            const Json &list = member(member(mesh, "extras"), key);
            const auto place = static_cast<std::size_t>(n);
            if (name.isEmpty() && list.is_array() && place < list.size() && list[place].is_string())
                name = QString::fromStdString(list[place].get<std::string>()).trimmed();
        }
        if (name.isEmpty() || taken.contains(name))
            name = gltfUvSetName(n);
        for (int number = 2; !taken.insert(name).second; ++number)
            name = QStringLiteral("%1.%2").arg(gltfUvSetName(n)).arg(number);
        names[n] = name;
    }
    return names;
}

void setGltfUvNames(Json &root, const std::map<int, QString> &names)
{
    bool plain = true;
    Json list = Json::array();
    for (const auto &[n, name] : names) {
        while (static_cast<int>(list.size()) < n)
            list.push_back(gltfUvSetName(static_cast<int>(list.size())).toStdString());
        list.push_back(name.toStdString());
        plain = plain && name == gltfUvSetName(n);
    }
    if (!root.contains("meshes"))
        return;
    for (Json &mesh : root["meshes"]) {
        const bool named = member(member(mesh, "extras"), key).is_array();
        if (!plain && (member(mesh, "extras").is_null() || mesh["extras"].is_object()))
            mesh["extras"][key] = list;
        else if (plain && named)
            mesh["extras"].erase(key);
    }
}

} // namespace autocuts
