// Presets: options of the command line in files.
//
// A file has one option in each line, "margin = 8" or "symmetry" for one without a value, with the names of
// the command line. Empty lines and those that begin with # do not count.
#pragma once

#include "model/document/result.h"

#include <QStringList>

#include <vector>

namespace autocuts {

struct PresetOption
{
    QString name, value; //!< "--margin", "8"; the value is empty where there is none
    int line = 0;
};

struct Preset
{
    QString path; //!< for messages
    std::vector<PresetOption> options;
};

//! The folder of the user's own presets, NAME.preset.
QString presetFolder();
//! The names of the presets that come with the program, and of the user's.
QStringList presetNames();

//! \param preset a name, or the path of a file: what has a slash or ends with .preset
Result<Preset> readPreset(const QString &preset);

} // namespace autocuts
