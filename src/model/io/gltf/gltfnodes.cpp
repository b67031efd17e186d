#include "model/io/gltf/gltfnodes.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace autocuts {

namespace {

std::vector<std::size_t> indicesIn(const Json &object, const char *key)
{
    std::vector<std::size_t> result;
    const Json &list = member(object, key);
    for (std::size_t i = 0; list.is_array() && i < list.size(); ++i) {
        if (!list[i].is_number_unsigned())
            throw GltfError(std::string("\"") + key + "\" holds something that is no index");
        result.push_back(list[i].get<std::size_t>());
    }
    return result;
}

//! The numbers of an array, or the default when it is missing or has another size.
template <int Size>
Eigen::Matrix<double, Size, 1> numbersIn(const Json &object, const char *key,
                                         const Eigen::Matrix<double, Size, 1> &otherwise)
{
    const Json &list = member(object, key);
    if (!list.is_array() || list.size() != Size)
        return otherwise;
    Eigen::Matrix<double, Size, 1> result;
    for (int i = 0; i < Size; ++i) {
        const Json &value = list[static_cast<std::size_t>(i)];
        if (!value.is_number())
            return otherwise;
        result[i] = value.get<double>();
    }
    return result;
}

Eigen::Matrix4d transformOf(const Json &node)
{
    if (!member(node, "matrix").is_null()) {
        const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
        const auto columns =
            numbersIn<16>(node, "matrix", Eigen::Map<const Eigen::Matrix<double, 16, 1>>(identity.data()));
        return Eigen::Map<const Eigen::Matrix4d>(columns.data());
    }
    const Eigen::Vector4d rotation = numbersIn<4>(node, "rotation", {0, 0, 0, 1});
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    transform.translate(numbersIn<3>(node, "translation", Eigen::Vector3d::Zero()));
    transform.rotate(Eigen::Quaterniond(rotation[3], rotation[0], rotation[1], rotation[2]));
    transform.scale(numbersIn<3>(node, "scale", Eigen::Vector3d::Ones()));
    return transform.matrix();
}

//! The nodes without parents.
std::vector<std::size_t> rootsOf(const Json &nodes)
{
    std::vector<bool> isChild(nodes.size(), false);
    for (const Json &node : nodes) {
        for (const std::size_t child : indicesIn(node, "children")) {
            if (child < nodes.size())
                isChild[child] = true;
        }
    }
    std::vector<std::size_t> roots;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (!isChild[n])
            roots.push_back(n);
    }
    return roots;
}

std::vector<std::size_t> firstNodes(const Json &root)
{
    const Json &scenes = member(root, "scenes");
    const Json &nodes = member(root, "nodes");
    if (scenes.is_array() && !scenes.empty())
        return indicesIn(element(root, "scenes", wholeNumber(root, "scene").value_or(0)), "nodes");
    return nodes.is_array() ? rootsOf(nodes) : std::vector<std::size_t>();
}

} // namespace

std::vector<GltfMeshNode> meshNodes(const Json &root)
{
    struct Visit
    {
        std::size_t node;
        Eigen::Matrix4d parent;
    };
    std::vector<Visit> stack;
    const auto push = [&](const std::vector<std::size_t> &nodes, const Eigen::Matrix4d &parent) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
            stack.push_back({*node, parent});
    };
    push(firstNodes(root), Eigen::Matrix4d::Identity());
    std::vector<bool> seen(member(root, "nodes").size(), false);
    std::vector<GltfMeshNode> result;
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        const Json &node = element(root, "nodes", visit.node);
        if (seen[visit.node])
            continue;
        seen[visit.node] = true;
        const Eigen::Matrix4d transform = visit.parent * transformOf(node);
        if (const auto mesh = wholeNumber(node, "mesh"))
            result.push_back({visit.node, *mesh, transform});
        push(indicesIn(node, "children"), transform);
    }
    return result;
}

std::set<std::string> jointNames(const Json &root)
{
    std::set<std::string> names;
    const Json &nodes = member(root, "nodes");
    for (const Json &skin : member(root, "skins")) {
        for (const Json &joint : member(skin, "joints")) {
            if (const auto node = joint.get<std::size_t>(); node < nodes.size())
                names.insert(nodes[node].value("name", std::string()));
        }
    }
    return names;
}

} // namespace autocuts
