#include "cli/generaloptions.h"

#include "cli/optionmakers.h"

namespace autocuts {

std::vector<CliOption> generalOptions()
{
    constexpr OptionGroup group = OptionGroup::Everything;
    return {
        {group,
         {u"--preset"_s},
         u"NAME|FILE"_s,
         u"take options from a preset: game-prop, film-udim, lightmap, scan, an own one (NAME.preset in "
         "the folder autocuts/presets of the user's settings), or a file with lines such as margin = 8; "
         "options of the command line replace it, and those of other commands in it do not count"_s,
         {},
         [](CliOptions &own, const QString &value) -> std::optional<QString> {
             own.preset = value;
             return std::nullopt;
         }},
        flag(group, u"--show-settings"_s, fieldOf(&CliOptions::showSettings), true,
             u"print the settings that the command would have, in the form of a preset, and do nothing"_s),
        flag(group, u"--dry-run"_s, fieldOf(&CliOptions::dryRun), true,
             u"read and check the input, say what -o, --layout and --report would write, and write nothing; "
             u"of "
             "several files, only say which would be written of which"_s),
        flag(group, u"--quiet"_s, fieldOf(&CliOptions::quiet), true,
             u"no progress for people and no figures, only warnings and errors; --progress json and --json "
             "are for programs, and are as without it"_s),
        suffixOption(group, u"--input-format"_s, fieldOf(&CliOptions::inputFormat),
                     u"format of a model that comes by standard input, where - is given for the input; when "
                     "not given, obj, and acproj for replay. Files beside it are not found"_s),
        suffixOption(group, u"--output-format"_s, fieldOf(&CliOptions::outputFormat),
                     u"format of what is written where -o names no file: - for standard output, which then "
                     "takes one file, while the figures go to stderr, or the folder of several files; when "
                     "not given, that of each input, or obj or fbx where that cannot be written"_s),
        choice(group, u"--progress"_s, fieldOf(&CliOptions::jsonProgress),
               {{u"text"_s, false}, {u"json"_s, true}},
               u"how progress is said on stderr: for people, which is a line every ten seconds where that is "
               "no terminal, and one for each of several files; or as lines of JSON"_s),
    };
}

} // namespace autocuts
