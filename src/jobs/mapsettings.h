// The settings of maps by the names that they have on the command line, for presets.
#pragma once

#include "jobs/presets.h"
#include "model/plain/packingsettings.h"
#include "model/plain/solvesettings.h"
#include "solver/unwrap/unwrapquality.h"

namespace autocuts::jobs {

//! The settings that both sessions and presets hold, and how long an unwrap searches.
struct MapSettings
{
    SolveSettings solve;
    PackingSettings packing;
    unwrap::UnwrapQuality quality = unwrap::UnwrapQuality::Standard;

    bool operator==(const MapSettings &) const = default;
};

//! The settings of a preset, with defaults for those that it does not name. What no preset holds stays as it
//! was: lambda, delta and the weight of the rectangles.
struct PresetSettings
{
    MapSettings settings;
    QStringList others; //!< options in the preset that are not in MapSettings, such as "per"
};

//! An Error names the line of the preset that is wrong.
Result<PresetSettings> settingsOf(const Preset &preset, const MapSettings &before);
//! A preset with all settings. A texture with a height of its own is WxH.
QString presetText(const MapSettings &settings);
//! The names of the settings, as in presets.
QStringList settingNames();

} // namespace autocuts::jobs
