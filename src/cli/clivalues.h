// Reads the values of options that are more than one word or number.
#pragma once

#include "cli/clioptions.h"

#include <optional>

namespace autocuts {

// Each is a CliOption::Reader.

//! --into: four numbers, or the name of a rectangle.
std::optional<QString> readRectangle(CliOptions &options, const QString &value);
//! --texture-size: one number, or two with an x between them.
std::optional<QString> readTextureSize(CliOptions &options, const QString &value);
//! --textures: paths with commas between them.
std::optional<QString> readTextures(CliOptions &options, const QString &value);
//! --seams-from: a list of sources, which takes the place of an earlier one.
std::optional<QString> readSeamSources(CliOptions &options, const QString &value);
//! --objects and --materials: names, added to those of earlier options.
std::optional<QString> readObjects(CliOptions &options, const QString &value);
std::optional<QString> readMaterials(CliOptions &options, const QString &value);
//! --per: object or material.
std::optional<QString> readPer(CliOptions &options, const QString &value);
//! --only: islands, objects or materials, added to those of earlier options.
std::optional<QString> readOnly(CliOptions &options, const QString &value);
//! --fail-on: what makes check fail.
std::optional<QString> readFailOn(CliOptions &options, const QString &value);

} // namespace autocuts
