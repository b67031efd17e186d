#include "model/io/fbx/fbxlinks.h"

#include "model/io/fbx/fbxobjects.h"

#include <set>
#include <string>

namespace autocuts {

FbxLinks::FbxLinks(const FbxTree &tree) : mTree(tree)
{
    const auto firstOf = [&tree](std::string_view list) {
        const int node = tree.child(0, list);
        return node < 0 ? -1 : tree.nodes[static_cast<std::size_t>(node)].firstChild;
    };
    const auto nextOf = [&tree](int node) { return tree.nodes[static_cast<std::size_t>(node)].next; };
    for (int object = firstOf("Objects"); object >= 0; object = nextOf(object)) {
        const auto id = tree.integer(object);
        if (id && mNodes.try_emplace(*id, object).second)
            mOrder.push_back(*id);
    }
    for (int connection = firstOf("Connections"); connection >= 0; connection = nextOf(connection)) {
        const std::vector<FbxValue> values = tree.values(connection, 4);
        if (values.size() < 3 || values[1].kind != FbxValue::Kind::Integer ||
            values[2].kind != FbxValue::Kind::Integer)
            continue;
        mLinks[values[2].integer].push_back(
            {values[1].integer, values.size() > 3 ? values[3].text : std::string_view()});
    }
}

int FbxLinks::node(std::int64_t id) const
{
    const auto found = mNodes.find(id);
    return found == mNodes.end() ? -1 : found->second;
}

const std::vector<FbxLink> &FbxLinks::to(std::int64_t parent) const
{
    static const std::vector<FbxLink> none;
    const auto found = mLinks.find(parent);
    return found == mLinks.end() ? none : found->second;
}

std::vector<std::int64_t> FbxLinks::objects(std::string_view name) const
{
    std::vector<std::int64_t> ids;
    for (const std::int64_t id : mOrder) {
        if (mTree.name(mNodes.at(id)) == name)
            ids.push_back(id);
    }
    return ids;
}

std::string_view FbxLinks::kind(std::int64_t id) const
{
    const int object = node(id);
    const std::vector<FbxValue> values = object < 0 ? std::vector<FbxValue>() : mTree.values(object, 3);
    return values.size() < 3 ? std::string_view() : values[2].text;
}

std::map<std::string, std::int64_t> FbxLinks::modelsByName() const
{
    std::map<std::string, std::int64_t> models;
    std::set<std::string> several;
    for (const std::int64_t id : objects("Model")) {
        const std::vector<FbxValue> values = mTree.values(node(id), 2);
        const std::string name =
            fbxObjectName(mTree, values.size() < 2 ? std::string_view() : values[1].text).toStdString();
        if (!models.emplace(name, id).second)
            several.insert(name);
    }
    for (const std::string &name : several)
        models.erase(name);
    return models;
}

} // namespace autocuts
