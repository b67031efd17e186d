// What light is to be baked, as the user chose it.
#pragma once

#include "jobs/lightmaterials.h"
#include "model/plain/lightplan.h"
#include "solver/bake/lightbake.h"

#include <QCborMap>
#include <QString>

namespace autocuts::jobs {

//! The settings of a light bake into a UV set.
struct LightChoice
{
    static constexpr int newSet = -1;

    int uvSet = 0;       //!< newSet: a copy of the active one, made for lightmaps
    int textureSize = 0; //!< texels along the width; 0: as many as in the Packing panel
    LightPlan lights;
    LightMaterials surface;
    int samples = bake::LightBakeSettings().samples; //!< paths of light per texel
    int bounces = 4;
    bool direct = true, indirect = true;
    bake::LightValue values = bake::LightValue::Light;
    bool denoise = true;
    int dilation = 8; //!< texels
    QString path;     //!< of the picture; its suffix is the format
    int bits = 8;     //!< of each number; 0: 8, and 32 in exr

    bool operator==(const LightChoice &) const = default;
    //! For the session. The dialog takes nothing from it that cannot be chosen there.
    QCborMap toCbor() const;
    static LightChoice fromCbor(const QCborMap &map);
};

} // namespace autocuts::jobs
