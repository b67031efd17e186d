#include "model/io/fbx/assimpfbxviews.h"

#include "model/io/fbx/fbxlinks.h"
#include "model/io/fbx/fbxproperties.h"

#include <algorithm>
#include <assimp/scene.h>

#include <cmath>
#include <numbers>
#include <string>

namespace autocuts {

namespace {

//! The values of the property ApertureMode.
enum ApertureMode { BothAngles = 0, HorizontalAngle = 1, VerticalAngle = 2, FocalLength = 3 };

//! The properties of a camera, with what the FBX SDK takes where they are missing.
class Camera
{
public:
    Camera(const FbxTree &tree, int node) : mProperties(tree, node) {}

    bool has(const char *name) const { return !mProperties.numbers(name).empty(); }
    int integer(const char *name, int otherwise) const { return mProperties.integer(name, otherwise); }
    double positive(const char *name, double otherwise) const
    {
        const std::vector<double> values = mProperties.numbers(name);
        return !values.empty() && values[0] > 0 && std::isfinite(values[0]) ? values[0] : otherwise;
    }

private:
    FbxProperties mProperties;
};

//! Of the horizontal angle. \param aspect width by height
double halfTangent(const Camera &camera, double aspect)
{
    constexpr double millimetres = 25.4; // in an inch
    const auto ofAngle = [&camera](const char *name, double otherwise) {
        return std::tan(std::min(camera.positive(name, otherwise), 179.0) * std::numbers::pi / 360);
    };
    const double film = camera.positive("FilmWidth", 0.816) * millimetres / 2 /
                        camera.positive("FocalLength", 34.89327621672628);
    switch (camera.integer("ApertureMode", VerticalAngle)) {
    case BothAngles:
        return ofAngle("FieldOfViewX", 40);
    case HorizontalAngle:
        return camera.has("FieldOfView") ? ofAngle("FieldOfView", 40) : film;
    case VerticalAngle:
        return camera.has("FieldOfView") || !camera.has("FocalLength")
                   ? ofAngle("FieldOfView", 25.115) * aspect
                   : film;
    default:
        return film;
    }
}

void setView(aiCamera &view, const Camera &camera, double metres)
{
    const double aspect = camera.positive("AspectWidth", 320) / camera.positive("AspectHeight", 200);
    view.mAspect = static_cast<float>(aspect);
    view.mHorizontalFOV = static_cast<float>(2 * std::atan(halfTangent(camera, aspect)));
    constexpr int orthographic = 1;
    // Half of the width. Programs take it for metres, whatever the unit is.
    if (camera.integer("CameraProjectionType", 0) == orthographic)
        view.mOrthographicWidth = static_cast<float>(camera.positive("OrthoZoom", 1) / 2 / metres);
}

} // namespace

void completeFbxCameras(aiScene &scene, const FbxTree &tree, const FbxLinks &links, double metres)
{
    const std::map<std::string, std::int64_t> models = links.modelsByName();
    for (unsigned c = 0; c < scene.mNumCameras; ++c) {
        const auto model = models.find(scene.mCameras[c]->mName.C_Str());
        if (model == models.end())
            continue;
        for (const FbxLink &link : links.to(model->second)) {
            if (links.kind(link.child) == "Camera")
                setView(*scene.mCameras[c], Camera(tree, links.node(link.child)), metres);
        }
    }
}

} // namespace autocuts
