#include "cli/clitable.h"

namespace autocuts {

using Command = CliOptions::Command;
using Output = CliCommand::Output;
using namespace Qt::Literals::StringLiterals;

const std::vector<CliCommand> &cliCommands()
{
    using enum OptionGroup;
    static const std::vector<CliCommand> commands{
        {Command::Unwrap, u"unwrap"_s, u"IN"_s, Output::Needed,
         Bound | Seaming | Solving | Texture | Packing | Scope | Bordering | Tiling | UvSets | NewUvSets |
             Sharing | Making | Limiting | Reporting,
         u"make a UV map"_s},
        {Command::Pack, u"pack"_s, u"IN"_s, Output::Needed,
         Texture | Packing | Placing | Scope | Bordering | Tiling | KeepingTiles | UvSets | NewUvSets |
             Sharing | Making | Limiting | Reporting,
         u"arrange the islands of an existing map anew"_s},
        {Command::Separate, u"separate"_s, u"IN"_s, Output::Needed,
         Texture | Packing | Separating | Scope | Bordering | Tiling | KeepingTiles | UvSets | NewUvSets |
             Sharing | Making | Limiting | Reporting,
         u"cut islands that overlap themselves, then pack"_s},
        {Command::Lightmap, u"lightmap"_s, u"IN"_s, Output::Needed,
         Texture | Packing | KeepingTiles | UvSets | NewUvSets | Sharing | Making | Limiting | Reporting,
         u"add a UV set for lightmaps, called Lightmap: the islands of the map without overlaps, stacks "
         u"taken "
         "apart, at one texel density"_s},
        {Command::Finish, u"finish"_s, u"IN"_s, Output::Needed,
         Bound | Seaming | Texture | Packing | Scope | Bordering | Tiling | KeepingTiles | UvSets |
             NewUvSets | Sharing | Making | Limiting | Reporting,
         u"make a half-solved map usable: seams decided, no overlaps, within the bound"_s},
        {Command::Transfer, u"transfer"_s, u"IN"_s, Output::Needed,
         Transferring | Texture | Scope | Bordering | UvSets | NewUvSets | Sharing | Making | Limiting |
             Reporting,
         u"give the model the UVs of another file, UV set or object, also of another resolution"_s},
        {Command::Bake, u"bake"_s, u"IN"_s, Output::Needed, Baking | Texture | UvSets | Limiting | Reporting,
         u"bake normals, occlusion and more into pictures for the UV map; -o is their folder"_s},
        {Command::LightBake, u"lightbake"_s, u"IN"_s, Output::Needed,
         Lighting | Texture | UvSets | Limiting | Reporting,
         u"bake the light of suns, skies, area lights and emissive materials into a picture (exr, png, tif "
         u"or "
         u"tga) "
         "for the UV map"_s},
        {Command::Check, u"check"_s, u"IN"_s, Output::None, Texture | Scope | UvSets | Measuring | Reporting,
         u"measure a map and say what is wrong with it"_s},
        {Command::Convert, u"convert"_s, u"IN"_s, Output::Needed, UvSets | Sharing | Converting | Reporting,
         u"write another file format; OBJ to OBJ, FBX to FBX and glTF to glTF change nothing"_s},
        {Command::Thumbnail, u"thumbnail"_s, u"IN"_s, Output::Needed, Picturing,
         u"draw a small PNG picture of a model; of a session, the one that it holds, as file managers show it"_s},
        {Command::Batch, u"batch"_s, u"COMMAND IN..."_s, Output::Needed, Batching,
         u"do one of the commands above with many files, each in a process of its own: files, folders with "
         u"all "
         "that is below them, patterns such as models/**/*.fbx; -o is the folder for the outputs, which keep "
         "the places and names of the inputs; the command's options follow"_s},
        {Command::Replay, u"replay"_s, u"SESSION"_s, Output::Optional, Reporting,
         u"do again what was done in a session, and say whether it gives the same"_s},
        {Command::Sample,
         u"sample"_s,
         u"NAME"_s,
         Output::Needed,
         {},
         u"write a sample: bumpycube, character, torus or machine"_s},
    };
    return commands;
}

const std::vector<CliExitCode> &cliExitCodes()
{
    static const std::vector<CliExitCode> codes{
        {0, u"done; also after --time-limit, then with the status time_limit in the report"_s},
        {1,
         u"failed; one line on stderr says what, where and what to do, and an existing output file is left "
         "as it was"_s},
        {2, u"wrong usage"_s},
        {3, u"the distortion is above --max-distortion (status bound_missed in the report); the map has been "
            "written"_s},
        {4, u"check found what --fail-on names; of several files, and nothing else failed"_s},
        {130,
         u"interrupted by Ctrl-C; the best valid map so far has been written, if the model had been read"_s},
    };
    return codes;
}

} // namespace autocuts
