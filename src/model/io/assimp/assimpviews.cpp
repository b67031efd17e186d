#include "model/io/assimp/assimpviews.h"

#include "model/io/files/xmlspans.h"

#include <QByteArray>

#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace autocuts {

namespace {

std::string element(const char *name, double value)
{
    const std::string tag = name;
    return '<' + tag + '>' + QByteArray::number(value, 'g', 9).toStdString() + "</" + tag + '>';
}

//! The elements of a library, such as the cameras.
std::vector<const XmlElement *> elementsOf(const XmlElement &root, const char *library, const char *name)
{
    std::vector<const XmlElement *> elements;
    const XmlElement *list = root.child(library);
    for (std::size_t c = 0; list && c < list->children.size(); ++c) {
        if (list->children[c].name == name)
            elements.push_back(&list->children[c]);
    }
    return elements;
}

const XmlElement *perspectiveOf(const XmlElement &camera)
{
    const XmlElement *optics = camera.child("optics");
    const XmlElement *common = optics ? optics->child("technique_common") : nullptr;
    return common ? common->child("perspective") : nullptr;
}

std::string orthographic(const aiCamera &camera)
{
    const double aspect = camera.mAspect > 0 ? camera.mAspect : 16.0 / 9;
    const double near = camera.mClipPlaneNear > 0 ? camera.mClipPlaneNear : 0.1;
    return "<orthographic>" + element("xmag", camera.mOrthographicWidth) + element("aspect_ratio", aspect) +
           element("znear", near) + element("zfar", std::max<double>(camera.mClipPlaneFar, 2 * near)) +
           "</orthographic>";
}

//! As Blender writes it, too. Other programs take the strength from the colour.
std::string strengthOf(const aiLight &light, bool fromGltf)
{
    const double red = light.mColorDiffuse.r, green = light.mColorDiffuse.g, blue = light.mColorDiffuse.b;
    const double strength = std::max({red, green, blue});
    const bool sun = light.mType == aiLightSource_DIRECTIONAL, spot = light.mType == aiLightSource_SPOT;
    const bool area = light.mType == aiLightSource_AREA;
    if (!(strength > 0) || !(sun || spot || area || light.mType == aiLightSource_POINT))
        return {};
    const double sphere = sun ? 1 : 4 * std::numbers::pi;
    std::string text = "<extra><technique profile=\"blender\">" +
                       element("type", sun    ? 1
                                       : spot ? 2
                                       : area ? 4
                                              : 0) +
                       element("red", red / strength) + element("green", green / strength) +
                       element("blue", blue / strength) +
                       element("energy", fromGltf ? strength * sphere / lumensPerWatt : strength);
    if (spot) {
        const double outer = std::clamp<double>(light.mAngleOuterCone, 0.02, std::numbers::pi);
        text += element("spotsize", outer * 180 / std::numbers::pi) +
                element("spotblend", std::clamp(1 - light.mAngleInnerCone / outer, 0.0, 1.0));
    }
    return text + "</technique></extra>";
}

} // namespace

std::string withViews(std::string_view text, const aiScene &scene, bool fromGltf)
{
    const std::optional<XmlElement> root = xmlSpans(text);
    if (!root)
        return std::string(text);
    std::vector<TextEdit> edits;
    // In the order of the scene.
    const auto cameras = elementsOf(*root, "library_cameras", "camera");
    for (std::size_t c = 0; cameras.size() == scene.mNumCameras && c < cameras.size(); ++c) {
        const XmlElement *perspective = perspectiveOf(*cameras[c]);
        if (perspective && scene.mCameras[c]->mOrthographicWidth > 0)
            edits.push_back({perspective->whole.data(), perspective->whole.data() + perspective->whole.size(),
                             orthographic(*scene.mCameras[c])});
    }
    const auto lights = elementsOf(*root, "library_lights", "light");
    for (std::size_t l = 0; lights.size() == scene.mNumLights && l < lights.size(); ++l) {
        const char *end = lights[l]->content.data() + lights[l]->content.size();
        if (!lights[l]->content.empty())
            edits.push_back({end, end, strengthOf(*scene.mLights[l], fromGltf)});
    }
    return edited(text, std::move(edits));
}

} // namespace autocuts
