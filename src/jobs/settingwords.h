// The words for the settings of maps, on the command line and in presets.
#pragma once

#include "model/plain/packingsettings.h"
#include "model/plain/solvesettings.h"
#include "solver/unwrap/unwrapquality.h"

#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace autocuts::jobs {

//! The values that a setting can have, each with its word.
template <class T>
using Words = std::vector<std::pair<QString, T>>;

//! Those of an enumeration of SolveSettings or PackingSettings, or of the quality of an unwrap.
template <class T>
const Words<T> &wordsOf();

// Each reads a value, and returns a description of valid ones when it is invalid.

//! One number of texels, or two with an x between them.
std::optional<QString> readTextureSize(PackingSettings &settings, const QString &value);
//! A list of the sources of given seams, with commas.
std::optional<QString> readSeamSources(GivenSeamOptions &sources, const QString &value);

QString textureSizeText(const PackingSettings &settings);
QString seamSourcesText(const GivenSeamOptions &sources);

} // namespace autocuts::jobs
