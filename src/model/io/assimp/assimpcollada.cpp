#include "model/io/assimp/assimpcollada.h"

#include "model/io/assimp/assimplimbs.h"
#include "model/io/files/xmlspans.h"
#include "model/io/formats/freenames.h"

#include <assimp/scene.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>

namespace autocuts {

namespace {

//! Calls use() with an element and all that are inside of it.
template <typename Use>
void eachElement(const XmlElement &element, const Use &use)
{
    use(element);
    for (const XmlElement &child : element.children)
        eachElement(child, use);
}

//! The number that an element of this name holds, 0 without one.
double numberIn(const XmlElement &parent, std::string_view name)
{
    const XmlElement *element = parent.child(name);
    if (!element)
        return 0;
    std::string_view word = element->content;
    word.remove_prefix(std::min(word.find_first_not_of(" \t\r\n"), word.size()));
    double value = 0;
    const bool read = std::from_chars(word.data(), word.data() + word.size(), value).ec == std::errc();
    return read ? value : 0;
}

void setClipping(aiCamera &camera, const XmlElement &optics)
{
    if (const double near = numberIn(optics, "znear"); near > 0)
        camera.mClipPlaneNear = static_cast<float>(near);
    if (const double far = numberIn(optics, "zfar"); far > 0)
        camera.mClipPlaneFar = static_cast<float>(far);
}

void setView(aiCamera &camera, const XmlElement &perspective)
{
    setClipping(camera, perspective);
    const auto halfTangent = [&](std::string_view name) {
        const double angle = numberIn(perspective, name);
        return angle > 0 && angle < 180 ? std::tan(angle * std::numbers::pi / 360) : 0;
    };
    const double wide = halfTangent("xfov"), high = halfTangent("yfov");
    double aspect = numberIn(perspective, "aspect_ratio");
    if (!(aspect > 0))
        aspect = wide > 0 && high > 0 ? wide / high : 16.0 / 9;
    const double tangent = wide > 0 ? wide : aspect * high;
    if (!(tangent > 0))
        return;
    camera.mAspect = static_cast<float>(aspect);
    camera.mHorizontalFOV = static_cast<float>(2 * std::atan(tangent));
}

void setWidth(aiCamera &camera, const XmlElement &orthographic)
{
    const double wide = numberIn(orthographic, "xmag"), high = numberIn(orthographic, "ymag");
    double aspect = numberIn(orthographic, "aspect_ratio");
    if (!(aspect > 0))
        aspect = wide > 0 && high > 0 ? wide / high : 16.0 / 9;
    camera.mAspect = static_cast<float>(aspect);
    camera.mOrthographicWidth = static_cast<float>(wide > 0 ? wide : aspect * high);
    setClipping(camera, orthographic);
}

//! Renames nodes and all that names them.
class NodeNames
{
public:
    NodeNames(aiScene &scene, const std::map<std::string, std::string> &names) : mNames(names)
    {
        collect(*scene.mRootNode);
        apply(*scene.mRootNode);
        for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
            for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b)
                apply(scene.mMeshes[m]->mBones[b]->mName);
        }
        for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
            for (unsigned c = 0; c < scene.mAnimations[a]->mNumChannels; ++c)
                apply(scene.mAnimations[a]->mChannels[c]->mNodeName);
        }
        for (unsigned c = 0; c < scene.mNumCameras; ++c)
            apply(scene.mCameras[c]->mName);
        for (unsigned l = 0; l < scene.mNumLights; ++l)
            apply(scene.mLights[l]->mName);
    }

private:
    void collect(const aiNode &node)
    {
        const std::string id = node.mName.C_Str();
        const auto name = mNames.find(id);
        std::string wanted = name == mNames.end() ? id : name->second;
        if (const auto [place, isNew] = mNew.try_emplace(id); isNew) {
            // Names of their own, since bones and animations find nodes by them.
            place->second = mTaken.takeFree(wanted);
        }
        for (unsigned c = 0; c < node.mNumChildren; ++c)
            collect(*node.mChildren[c]);
    }

    void apply(aiNode &node)
    {
        apply(node.mName);
        for (unsigned c = 0; c < node.mNumChildren; ++c)
            apply(*node.mChildren[c]);
    }

    void apply(aiString &name) const
    {
        if (const auto found = mNew.find(name.C_Str()); found != mNew.end())
            name = found->second;
    }

    const std::map<std::string, std::string> &mNames; //!< by id
    std::map<std::string, std::string> mNew;
    FreeNames mTaken;
};

//! The names of UV sets in their order: those of the first polygons that name one.
std::map<std::size_t, std::string> uvNames(const XmlElement &root)
{
    std::map<std::string, std::string> sources; // name by id
    eachElement(root, [&](const XmlElement &element) {
        const std::string id = resolved(element.attribute("id")), name = resolved(element.attribute("name"));
        if (element.name == "source" && !name.empty() && name != id)
            sources[id] = name;
    });
    std::map<std::size_t, std::string> names;
    eachElement(root, [&](const XmlElement &polygons) {
        std::map<int, std::string> sets; // id of the source by number
        for (const XmlElement &input : polygons.children) {
            const std::string_view number = input.attribute("set");
            int set = 0;
            std::from_chars(number.data(), number.data() + number.size(), set);
            if (input.name == "input" && input.attribute("semantic") == "TEXCOORD")
                sets.try_emplace(set, resolved(input.attribute("source")));
        }
        std::size_t rank = 0;
        for (const auto &[set, source] : sets) {
            const auto name = source.starts_with('#') ? sources.find(source.substr(1)) : sources.end();
            if (name != sources.end())
                names.try_emplace(rank, name->second);
            ++rank;
        }
    });
    return names;
}

void nameUvSets(aiScene &scene, const XmlElement &root)
{
    for (const auto &[set, name] : uvNames(root)) {
        for (unsigned m = 0; m < scene.mNumMeshes && set < AI_MAX_NUMBER_OF_TEXTURECOORDS; ++m)
            scene.mMeshes[m]->SetTextureCoordsName(static_cast<unsigned>(set), aiString(name));
    }
}

void markJoints(aiNode &node, const std::set<std::string> &joints)
{
    if (joints.contains(node.mName.C_Str()))
        markLimb(node);
    for (unsigned c = 0; c < node.mNumChildren; ++c)
        markJoints(*node.mChildren[c], joints);
}

} // namespace

void completeColladaNodes(aiScene &scene, std::string_view text)
{
    const std::optional<XmlElement> root = xmlSpans(text);
    if (!root || !scene.mRootNode)
        return;
    std::map<std::string, std::string> names;
    std::set<std::string> joints;
    std::map<std::string, const XmlElement *, std::less<>> optics; // by the id of a camera
    eachElement(*root, [&](const XmlElement &element) {
        if (element.name == "camera") {
            eachElement(element, [&](const XmlElement &inside) {
                if (inside.name == "perspective" || inside.name == "orthographic")
                    optics[resolved(element.attribute("id"))] = &inside;
            });
        } else if (element.name == "node") {
            for (const char *key : {"sid", "id"}) {
                const std::string id = resolved(element.attribute(key));
                if (!id.empty() && element.attribute("type") == "JOINT")
                    joints.insert(id);
                if (!id.empty() && !element.attribute("name").empty())
                    names[id] = resolved(element.attribute("name"));
            }
        }
    });
    eachElement(*root, [&](const XmlElement &element) {
        const XmlElement *use = element.name == "node" ? element.child("instance_camera") : nullptr;
        const std::string url = use ? resolved(use->attribute("url")) : std::string();
        const auto view = url.starts_with('#') ? optics.find(url.substr(1)) : optics.end();
        const std::string id = resolved(element.attribute("id"));
        for (unsigned c = 0; view != optics.end() && c < scene.mNumCameras; ++c) {
            if (scene.mCameras[c]->mName == aiString(id))
                (view->second->name == "perspective" ? setView : setWidth)(*scene.mCameras[c], *view->second);
        }
    });
    markJoints(*scene.mRootNode, joints);
    NodeNames(scene, names);
    nameUvSets(scene, *root);
}

} // namespace autocuts
