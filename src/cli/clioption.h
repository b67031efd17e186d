// An option of the command line program, a row of the table in clitable.h.
#pragma once

#include "cli/clioptions.h"

#include <QFlags>

#include <functional>
#include <optional>

namespace autocuts {

//! Groups of options. A command has all options of its groups.
enum class OptionGroup {
    Output = 1,             //!< the file to write
    Bound = 256,            //!< bounds of the distortion
    Solving = 2,            //!< how seams and distortion are optimised
    Texture = 4,            //!< the texture for figures in texels
    Packing = 8,            //!< how islands are arranged
    Placing = 16,           //!< where islands are packed, and whether they are scaled
    Separating = 2048,      //!< how overlaps are cut apart
    Making = 32,            //!< limits and reports, for all commands that make a map
    Measuring = 64,         //!< how figures are printed
    Seaming = 512,          //!< which seams a map gets: given ones, found ones or both
    Scope = 1024,           //!< the part of the model that may change, or is measured
    Bordering = 32768,      //!< whether islands are cut along the border of that part
    UvSets = 4096,          //!< which of the file's UV sets
    NewUvSets = 8192,       //!< whether the map goes into a new UV set
    Tiling = 16384,         //!< what gets a tile of its own
    Transferring = 65536,   //!< where UVs come from
    Baking = 131072,        //!< pictures that are made
    Limiting = 262144,      //!< time, threads and the report
    Lighting = 524288,      //!< light that is baked
    Converting = 1048576,   //!< whether a damaged session is converted all the same
    KeepingTiles = 2097152, //!< whether the islands of several tiles stay in them
    Sharing = 4194304,      //!< whether objects share meshes in the written file
    Picturing = 8388608,    //!< how large a picture is
    Batching = 16777216,    //!< how many files are worked on
    Reporting = 33554432,   //!< the figures as a file
    Everything = 128        //!< for all commands
};
Q_DECLARE_FLAGS(OptionGroups, OptionGroup)
Q_DECLARE_OPERATORS_FOR_FLAGS(OptionGroups)

//! An option, with its description and how it is read.
struct CliOption
{
    //! Sets the options from a value. Returns a description of valid values ("a number from 0 to 1") when the
    //! value is invalid, and then leaves the options unchanged. The value is empty for options without one.
    using Reader = std::function<std::optional<QString>(CliOptions &, const QString &value)>;

    OptionGroup group;
    QStringList names;
    QString value; //!< placeholder for the value in texts; empty when the option has none
    QString meaning;
    QString standard; //!< the default value in texts; empty where `meaning` gives it
    Reader read;
};

} // namespace autocuts
