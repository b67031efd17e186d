// Presets: options of the command line in files, for the command line and the window.
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
//! The names of the presets that the user has saved.
QStringList ownPresetNames();

//! \param preset a name, or the path of a file: what has a slash or ends with .preset
Result<Preset> readPreset(const QString &preset);

//! Writes a preset of the user, also over one that there is. An Error when the name is no name of a file, or
//! that of a preset of the program.
Result<Done> savePreset(const QString &name, const QString &text);
//! Removes a preset of the user.
Result<Done> removePreset(const QString &name);

} // namespace autocuts
