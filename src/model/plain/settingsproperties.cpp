#include "model/plain/settingsproperties.h"

#include <cmath>

namespace autocuts {

namespace {

bool sameSources(const GivenSeamOptions &a, GivenSeamOptions b)
{
    b.sharpAngle = a.sharpAngle;
    return a == b;
}

} // namespace

int differences(const SolveSettings &a, const SolveSettings &b)
{
    return (a.lambda != b.lambda ? LambdaProperty : 0) | (a.delta != b.delta ? DeltaProperty : 0) |
           (a.boxWeight != b.boxWeight ? BoxWeightProperty : 0) |
           (a.energy != b.energy ? EnergyProperty : 0) |
           (a.weighting != b.weighting ? WeightingProperty : 0) | (a.start != b.start ? StartProperty : 0) |
           (a.solver != b.solver ? SolverProperty : 0) | (a.seed != b.seed ? SeedProperty : 0) |
           (a.creases != b.creases ? CreasesProperty : 0) |
           (a.creaseStrength != b.creaseStrength ? CreaseStrengthProperty : 0) |
           (a.visibility != b.visibility ? VisibilityProperty : 0) |
           (a.symmetry != b.symmetry ? SymmetryProperty : 0) | (a.seams != b.seams ? SeamModeProperty : 0) |
           (sameSources(a.givenSeams, b.givenSeams) ? 0 : SeamSourcesProperty) |
           (a.givenSeams.sharpAngle != b.givenSeams.sharpAngle ? SharpAngleProperty : 0) |
           (a.maxDistortion != b.maxDistortion ? MaxDistortionProperty : 0) |
           (a.align != b.align ? AlignProperty : 0) |
           (a.mirrorMaps != b.mirrorMaps ? MirrorMapsProperty : 0) |
           (a.worldUp != b.worldUp ? WorldUpProperty : 0) | (a.flat != b.flat ? FlatProperty : 0) |
           (a.alike != b.alike ? AlikeProperty : 0) | (a.surface != b.surface ? SurfaceProperty : 0);
}

int differences(const PackingSettings &a, const PackingSettings &b)
{
    return (a.textureSize != b.textureSize || a.height() != b.height() ? TextureSizeProperty : 0) |
           (a.margin != b.margin ? MarginProperty : 0) | (a.udimTile != b.udimTile ? UdimTileProperty : 0) |
           (a.rotation != b.rotation ? RotationProperty : 0) |
           (a.keepScale != b.keepScale ? KeepScaleProperty : 0) |
           (a.border != b.border ? BorderProperty : 0) | (a.effort != b.effort ? EffortProperty : 0);
}

bool isValid(const SolveSettings &settings)
{
    const auto inRange = [](auto value, auto last) { return value >= decltype(last){} && value <= last; };
    return settings.lambda >= 0 && settings.lambda <= 1 && std::isfinite(settings.delta) &&
           settings.delta > 0 && std::isfinite(settings.boxWeight) && settings.boxWeight >= 0 &&
           settings.maxDistortion > 4 && settings.maxDistortion <= SolveSettings::maxBound &&
           inRange(settings.energy, DistortionEnergy::Amips) &&
           inRange(settings.weighting, SeamWeighting::Count) &&
           inRange(settings.start, StartMode::ExistingUv) && inRange(settings.solver, SolverKind::Exact) &&
           inRange(settings.creases, CreaseMode::On) && inRange(settings.creaseStrength, 1.0) &&
           inRange(settings.visibility, 1.0) && inRange(settings.align, CreaseMode::On) &&
           inRange(settings.worldUp, WorldUp::AutoZ) && inRange(settings.flat, FlatMode::Free) &&
           inRange(settings.surface, SurfaceKind::HardSurface) && inRange(settings.alike, AlikeMode::Stack) &&
           inRange(settings.seams, SeamMode::Only) && inRange(settings.givenSeams.sharpAngle, 180.0);
}

} // namespace autocuts
