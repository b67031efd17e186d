// Bit masks that name single settings, to say which of them differ. Plain: no Qt.
#pragma once

#include "model/plain/packingsettings.h"
#include "model/plain/solvesettings.h"

namespace autocuts {

//! The fields of SolveSettings.
enum SolveProperty {
    LambdaProperty = 1 << 0,
    DeltaProperty = 1 << 1,
    BoxWeightProperty = 1 << 2,
    EnergyProperty = 1 << 3,
    WeightingProperty = 1 << 4,
    StartProperty = 1 << 5,
    SolverProperty = 1 << 6,
    SeedProperty = 1 << 7,
    CreasesProperty = 1 << 8,
    CreaseStrengthProperty = 1 << 9,
    VisibilityProperty = 1 << 10,
    SymmetryProperty = 1 << 11,
    SeamModeProperty = 1 << 12,
    SeamSourcesProperty = 1 << 13, //!< all of SolveSettings::givenSeams but the angle
    SharpAngleProperty = 1 << 14,
    MaxDistortionProperty = 1 << 15,
    AlignProperty = 1 << 16,
    MirrorMapsProperty = 1 << 17,
    WorldUpProperty = 1 << 18,
    FlatProperty = 1 << 19,
    AlikeProperty = 1 << 20,
    SurfaceProperty = 1 << 21
};

//! The fields of PackingSettings.
enum PackingProperty {
    TextureSizeProperty = 1 << 0,
    MarginProperty = 1 << 1,
    UdimTileProperty = 1 << 2,
    RotationProperty = 1 << 3,
    KeepScaleProperty = 1 << 4,
    BorderProperty = 1 << 5,
    EffortProperty = 1 << 6
};

//! The mask of SolveProperty values in which a and b differ.
int differences(const SolveSettings &a, const SolveSettings &b);
//! The mask of PackingProperty values in which a and b differ.
int differences(const PackingSettings &a, const PackingSettings &b);
//! True when every field is in the range that solvesettings.h gives for it.
bool isValid(const SolveSettings &settings);

} // namespace autocuts
