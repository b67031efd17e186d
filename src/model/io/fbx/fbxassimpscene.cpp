#include "model/io/fbx/fbxassimpscene.h"

#include "model/io/assimp/assimpmatch.h"
#include "model/io/assimp/assimpsource.h"
#include "model/io/fbx/assimpfbxmotions.h"
#include "model/io/fbx/assimpfbxviews.h"
#include "model/io/fbx/fbxlinks.h"
#include "model/io/fbx/fbxparsing.h"

#include <cmath>

namespace autocuts {

namespace {

//! Where the meshes of models were when they were bound to bones, in the coordinates of the file.
std::map<std::string, Eigen::Matrix4d> placesOfBinding(const FbxTree &tree, const FbxLinks &links)
{
    const auto matrixOf = [&](std::int64_t cluster, const char *name) {
        const auto numbers = tree.doubles(tree.child(links.node(cluster), name));
        return numbers && numbers->size() == 16 ? std::optional(Eigen::Matrix4d(numbers->data()))
                                                : std::nullopt;
    };
    std::map<std::string, Eigen::Matrix4d> places;
    for (const auto &[name, model] : links.modelsByName()) {
        std::vector<std::int64_t> open{model};
        // From the model to its geometry, to the skin, to its clusters.
        for (const std::string_view kind : {"Mesh", "Skin", "Cluster"}) {
            std::vector<std::int64_t> next;
            for (const std::int64_t id : open) {
                for (const FbxLink &link : links.to(id)) {
                    if (links.kind(link.child) == kind && tree.name(links.node(link.child)) != "Model")
                        next.push_back(link.child);
                }
            }
            open = std::move(next);
        }
        for (const std::int64_t cluster : open) {
            const auto bone = matrixOf(cluster, "TransformLink"), mesh = matrixOf(cluster, "Transform");
            const Eigen::Matrix4d place =
                bone && mesh ? Eigen::Matrix4d(*bone * *mesh) : Eigen::Matrix4d(Eigen::Matrix4d::Zero());
            if (place.allFinite() && std::abs(place.determinant()) > 1e-30)
                places.emplace(name, place);
        }
    }
    return places;
}

//! What Assimp leaves out. \param placement of the file in the world
void complete(aiScene &assimp, AssimpSource &made, const QString &path, const FbxSource &source,
              const Eigen::Matrix4d &placement)
{
    const Result<FbxTree> tree = parseFbxTree(source.bytes, path);
    if (!tree)
        return;
    const FbxLinks links(tree.value());
    completeFbxCameras(assimp, tree.value(), links, source.space.metres);
    completeFbxMotions(assimp, tree.value(), links);
    for (const auto &[name, place] : placesOfBinding(tree.value(), links))
        made.boundAt[name] = placement * place;
    for (const auto &[name, model] : links.modelsByName()) {
        if (const std::string_view kind = links.kind(model); kind == "LimbNode" || kind == "Limb")
            made.limbs.insert(name);
    }
}

} // namespace

std::optional<Scene> fbxAsAssimpReads(const Scene &scene, const FbxSource &source)
{
    Eigen::Matrix4d placement = Eigen::Matrix4d::Identity();
    placement.topLeftCorner<3, 3>() = source.space.metres * source.space.axes;
    return asAssimpReads(
        scene, source.bytes, QStringLiteral("fbx"), placement,
        [&](aiScene &assimp, AssimpSource &made) { complete(assimp, made, scene.path, source, placement); });
}

} // namespace autocuts
