#include "cli/clitable.h"

#include "cli/bakeoptions.h"
#include "cli/clivalues.h"
#include "cli/generaloptions.h"
#include "cli/lightoptions.h"
#include "cli/manyoptions.h"
#include "cli/optionmakers.h"

#include <QFileInfo>

#include <limits>

namespace autocuts {

namespace {

using Group = OptionGroup;
using namespace Qt::Literals::StringLiterals;
using Problem = std::optional<QString>;

Problem readLayout(CliOptions &options, const QString &value)
{
    const QString suffix = QFileInfo(value).suffix().toLower();
    if (suffix != u"png" && suffix != u"svg")
        return u"a .png or .svg file"_s;
    options.layout = value;
    return std::nullopt;
}

std::vector<CliOption> boundOptions()
{
    return {
        number(Group::Bound, u"--max-distortion"_s, u"X"_s, fieldOf(&unwrap::UnwrapOptions::maxDistortion),
               4.0001, 1e6,
               u"find the shortest seams with which the mean symmetric Dirichlet energy stays at or below "
               "this; 4 is no distortion"_s)};
}

std::vector<CliOption> seamingOptions()
{
    constexpr Group group = Group::Seaming;
    return {
        choice(
            group, u"--seams"_s, fieldOf(&SolveSettings::seams),
            u"which seams the map gets: those that the search finds; the given ones and what the bound needs "
            "besides; exactly the given ones"_s),
        {group,
         {u"--seams-from"_s},
         u"LIST"_s,
         u"what the given seams of --seams keep and only are, with commas: cuts (edges cut in the session), "
         "uv (the seams of the map that is there), sharp or sharp:DEGREES (edges bent by more than that, 30 "
         "by default), hard (hard edges of the file: between smoothing groups, or where normals differ), "
         "materials (edges between them), objects (always seams)"_s,
         u"cuts,uv"_s,
         readSeamSources},
    };
}

std::vector<CliOption> scopeOptions()
{
    constexpr Group group = Group::Scope;
    return {
        {group,
         {u"--only"_s},
         u"PART"_s,
         u"change only a part of the model, the rest keeps its UVs, and check measures only that: "
         u"islands:3,5 (numbered as in the studio's "
         "island panel: from 1, in the order of their first faces), objects:NAME,.. or materials:NAME,.. "
         "(NAME#2: the second of that name; wheel_*: all that begin so, ? is one letter); "
         "given several times, the parts add up"_s,
         {},
         readOnly},
        {group, {u"--objects"_s}, u"NAMES"_s, u"the same as --only objects:NAMES"_s, {}, readObjects},
        {group, {u"--materials"_s}, u"NAMES"_s, u"the same as --only materials:NAMES"_s, {}, readMaterials},
        choice(
            Group::Bordering, u"--border"_s, fieldOf(&CliOptions::borderAttached),
            {{u"attached"_s, true}, {u"free"_s, false}},
            u"where the border of --only runs through an island: the map stays whole across it, or is cut "
            "there; attached, pack leaves such islands where they are, and separate does so in any case"_s),
    };
}

std::vector<CliOption> uvSetOptions()
{
    CliOption which =
        text(Group::UvSets, {u"--uv-set"_s}, fieldOf(&CliOptions::uvSet),
             u"the UV set to work on: its name in the file, or its number from 1; otherwise the first "
             "one, of a session the active one"_s);
    which.value = u"NAME|N"_s;
    CliOption added =
        text(Group::NewUvSets, {u"--new-uv-set"_s}, fieldOf(&CliOptions::newUvSet),
             u"leave the UV sets of the file as they are, and put the map into a new one of this "
             "name, for example for lightmaps; it begins as a copy"_s);
    added.value = u"NAME"_s;
    return {which, added};
}

std::vector<CliOption> solvingOptions()
{
    constexpr Group group = Group::Solving;
    return {
        number(group, u"--lambda"_s, u"X"_s, fieldOf(&unwrap::UnwrapOptions::lambda), 0, 1,
               u"in place of a bound: a fixed balance between distortion and seams, from 0 (cut freely) to 1 "
               "(hardly cut)"_s),
        choice(group, u"--init"_s, fieldOf(&SolveSettings::start),
               u"start from every triangle flat on its own, a Tutte embedding, random places, or the UVs of "
               "the file"_s),
        choice(group, u"--weights"_s, fieldOf(&SolveSettings::weighting),
               u"what a seam costs: its length, or 1 per edge"_s),
        choice(group, u"--energy"_s, fieldOf(&SolveSettings::energy),
               u"how distortion is measured while solving: isometric, or conformal (AMIPS)"_s),
        choice(group, u"--solver"_s, fieldOf(&SolveSettings::solver),
               u"preconditioned conjugate gradients, or a full factorisation in every step"_s),
        choice(group, u"--quality"_s, fieldOf(&unwrap::UnwrapOptions::quality),
               u"how long to search for shorter seams"_s),
        choice(
            group, u"--for"_s, fieldOf(&SolveSettings::surface),
            u"what the model is like: flat faces with sharp edges, which keep their shape and get the seams; "
            "curved, so that stretch may go anywhere; auto recognises each connected part, and the report "
            "says what was found"_s),
        choice(
            group, u"--flat"_s, fieldOf(&SolveSettings::flat),
            u"flat faces, and what unrolls without stretch, keep their shape, and the stretch that "
            "--max-distortion allows goes to the curved rest; or it may go anywhere. No matter with --lambda"_s),
        choice(
            group, u"--alike"_s, fieldOf(&SolveSettings::alike),
            u"connected parts that are copies of each other, also mirrored ones, get the same seams, which "
            "is faster, too; stack also lays islands that are copies on each other, mirrored ones turned "
            "over; off: each is cut on its own"_s),
        choice(
            group, u"--creases"_s, fieldOf(&SolveSettings::creases),
            u"put seams along sharp edges; auto does so on parts where clear creases make up the sharp edges"_s),
        number(group, u"--crease-strength"_s, u"X"_s, fieldOf(&SolveSettings::creaseStrength), 0, 1,
               u"part of its cost that a seam on a sharp edge saves, 0 to 1"_s),
        number(group, u"--visibility"_s, u"X"_s, fieldOf(&SolveSettings::visibility), 0, 1,
               u"how much seams prefer hidden places, 0 (not at all) to 1"_s),
        flag(group, u"--symmetry"_s, fieldOf(&SolveSettings::symmetry), SymmetryMode::On,
             u"make symmetric cuts on symmetric meshes; without it, unwrap makes them on curved models where "
             "they hardly cost more seams"_s),
        flag(group, u"--no-symmetry"_s, fieldOf(&SolveSettings::symmetry), SymmetryMode::Off,
             u"make the shortest seams, symmetric or not"_s),
        choice(
            group, u"--align"_s, fieldOf(&SolveSettings::align),
            u"turn islands to the axes, and make straight in the map what is straight on the model, as far "
            "as the bound allows; auto does so on parts that are hard surfaces"_s),
        flag(group, u"--mirror"_s, fieldOf(&SolveSettings::mirrorMaps), true,
             u"make the maps of symmetric islands symmetric, and those of islands on both sides of a "
             u"symmetric "
             "mesh mirror images of each other; --symmetry makes cuts that allow it"_s),
        choice(group, u"--world-up"_s, fieldOf(&SolveSettings::worldUp),
               u"turn islands so that this direction of the model is up in the map; they are packed as they "
               "stand; auto-y and auto-z do so where it costs at most 5 % of the texel density"_s),
        flag(group, u"--allow-overlaps"_s, fieldOf(&unwrap::UnwrapOptions::allowOverlaps), true,
             u"do not cut islands that overlap themselves"_s),
        flag(group, u"--no-pack"_s, fieldOf(&unwrap::UnwrapOptions::pack), false,
             u"leave the islands where the solver put them, scaled to the first tile"_s),
    };
}

std::vector<CliOption> packingOptions()
{
    return {
        {Group::Texture,
         {u"--texture-size"_s, u"--size"_s},
         u"N|WxH"_s,
         u"texels along each side of the texture, or its width and height; figures in texels refer to it, "
         "and distortion is that on it"_s,
         QString::number(PackingSettings().textureSize),
         readTextureSize},
        number(Group::Packing, u"--margin"_s, u"X"_s, fieldOf(&PackingSettings::margin), 0, 4096,
               u"texels between islands, and half of it to the border"_s),
        defaultingTo(
            number(
                Group::Packing, u"--tile-border"_s, u"X"_s, fieldOf(&PackingSettings::border), 0, 4096,
                u"texels between the islands and the border of the tile; half the margin when not given"_s),
            {}),
        choice(Group::Packing, u"--rotation"_s, fieldOf(&PackingSettings::rotation),
               u"how islands may be turned: freely, though those whose border is mostly right-angled stand "
               u"upright, and straight ones that pack finds on the axes stay there; by multiples of so many "
               "degrees; or not at all"_s),
        integer(Group::Packing, u"--tile"_s, fieldOf(&PackingSettings::udimTile), PackingSettings::firstTile,
                PackingSettings::lastTile,
                u"UDIM tile to pack into: 1001 is the first, there are ten tiles in a row"_s),
        number(
            Group::Packing, u"--pack-time"_s, u"SECONDS"_s, fieldOf(&PackingSettings::effort), 0,
            PackingSettings::maxEffort,
            u"effort that goes into packing, in CPU seconds of a usual machine; it is counted in steps, so "
            "that the result does not depend on the clock"_s),
    };
}

CliOption tilingOption()
{
    return {
        Group::Tiling,
        {u"--per"_s},
        u"object|material"_s,
        u"pack every object, or every material, into a UDIM tile of its own, from --tile on in the order of "
        "the file; with material, unwrap cuts between materials. --layout then draws one picture for each "
        "tile and puts its number before the suffix"_s,
        {},
        readPer};
}

CliOption tilesOption()
{
    return choice(
        Group::KeepingTiles, u"--tiles"_s, fieldOf(&CliOptions::oneTile),
        {{u"keep"_s, false}, {u"one"_s, true}},
        u"islands of a layout of several UDIM tiles stay in their tiles, each in the one that holds most of "
        "it; or all go into the tile of --tile, as they do when --tile names another one than 1001. A "
        "texture that repeats over a wall is no layout of tiles"_s);
}

CliOption densityOption()
{
    return number(
        Group::Tiling, u"--density"_s, u"X"_s, fieldOf(&CliOptions::density), 1e-9, 1e12,
        u"give all islands this texel density, in texels per unit of the model, and pack them into as many "
        "UDIM tiles as that needs, from --tile on; an island that is larger than a tile is made smaller to "
        "fit"_s);
}

CliOption separatingOption()
{
    return choice(
        Group::Separating, u"--separate-by"_s, fieldOf(&CliOptions::separation),
        {{u"short-seams"_s, overlap::SeparationMethod::MinCut},
         {u"growing"_s, overlap::SeparationMethod::Greedy}},
        u"cut between overlapping layers along the shortest seam, or into regions that grow breadth "
        "first for as long as they do not cover themselves"_s);
}

std::vector<CliOption> transferringOptions()
{
    constexpr Group group = Group::Transferring;
    CliOption file = text(group, {u"--from"_s}, fieldOf(&CliOptions::from),
                          u"the model or session that has the UVs; otherwise the input itself"_s);
    CliOption set =
        text(group, {u"--from-uv-set"_s}, fieldOf(&CliOptions::fromUvSet),
             u"the UV set that is transferred: its name, or its number from 1; otherwise the first one, of a "
             "session the active one"_s);
    set.value = u"NAME|N"_s;
    CliOption object =
        text(group, {u"--from-object"_s}, fieldOf(&CliOptions::fromObject),
             u"only the UVs of this object, to every object that --only names, or to all; they may lie "
             "elsewhere"_s);
    object.value = u"NAME"_s;
    CliOption textures{
        group,
        {u"--textures"_s},
        u"FILES|all"_s,
        u"leave the UVs of the input as they are, and make these pictures, which fit the UVs of "
        "--from, new for them; with commas, and with <UDIM> in a name for pictures of tiles; all: the "
        "textures of all materials, or those of --from where the input has none. -o is then the folder for "
        "them; --texture-size is that of the pictures when not given, JPEG pictures become PNG"_s,
        {},
        readTextures};
    return {file, set, object, textures,
            choice(group, u"--match"_s, fieldOf(&CliOptions::match),
                   {{u"auto"_s, transfer::UvMatch::Auto},
                    {u"topology"_s, transfer::UvMatch::Topology},
                    {u"position"_s, transfer::UvMatch::Position}},
                   u"how faces find their UVs: where the polygons are the same they are copied, otherwise "
                   "they come from the nearest points of the surface; or by one of these only"_s)};
}

std::vector<CliOption> placingOptions()
{
    return {
        {Group::Placing,
         {u"--into"_s},
         u"RECTANGLE"_s,
         u"in place of a tile: left,bottom,right,top in UV units, or the name of a rectangle of the session, "
         "whose islands are packed while the others stay"_s,
         {},
         readRectangle},
        flag(Group::Placing, u"--fill-tiles"_s, fieldOf(&CliOptions::fillTiles), true,
             u"with --only: pack into the free room of the tiles that the other islands lie in, at their "
             "texel density, and what does not fit into further tiles"_s),
        flag(Group::Placing, u"--keep-scale"_s, fieldOf(&PackingSettings::keepScale), true,
             u"keep the size of the islands; otherwise all get the same texel density"_s),
    };
}

std::vector<CliOption> makingOptions()
{
    constexpr Group group = Group::Making;
    return {
        {group,
         {u"--layout"_s},
         u"FILE"_s,
         u"draw a picture of the layout, .png or .svg: islands, seams, overlaps hatched; with --only, of "
         u"that "
         "part"_s,
         {},
         readLayout},
        text(
            Group::Reporting, {u"--report"_s}, fieldOf(&CliOptions::report),
            u"write the figures of the result as JSON, also those of each object and material; - is standard "
            u"output. Of several inputs: .csv, .json or .html, as by batch"_s),
        defaultingTo(integer(Group::Limiting, u"--threads"_s, fieldOf(&CliOptions::threads), 1, 1024,
                             u"threads to use; the result does not depend on it"_s),
                     u"all cores"_s),
        number(Group::Limiting, u"--time-limit"_s, u"SECONDS"_s, fieldOf(&CliOptions::timeLimit), 0.001, 1e9,
               u"stop then and write the best map so far"_s),
        integer(group, u"--seed"_s, fieldOf(&SolveSettings::seed), 0, std::numeric_limits<int>::max(),
                u"seed of everything random: the same command gives the same bytes"_s),
    };
}

std::vector<CliOption> tilingOptions()
{
    return {tilingOption(), tilesOption(), densityOption()};
}

} // namespace

const std::vector<CliOption> &cliOptions()
{
    static const std::vector<CliOption> options = [] {
        std::vector<CliOption> all{
            text(Group::Output, {u"-o"_s, u"--output"_s}, fieldOf(&CliOptions::output),
                 u"file to write; - is standard output. Of several inputs, the folder for the outputs"_s)};
        for (const CliOption &option : batchOptions()) // before the command's, which may have the same name
            all.push_back(option);
        for (const auto &some :
             {boundOptions(), seamingOptions(), solvingOptions(), packingOptions(), scopeOptions(),
              tilingOptions(), uvSetOptions(), makingOptions(), placingOptions()})
            all.insert(all.end(), some.begin(), some.end());
        for (const auto &some : {transferringOptions(), bakeOptions(), lightOptions()})
            all.insert(all.end(), some.begin(), some.end());
        all.push_back(separatingOption());
        all.push_back(flag(Group::Measuring, u"--json"_s, fieldOf(&CliOptions::json), true,
                           u"print the figures as JSON; of several files, what came of all of them"_s));
        all.push_back(flag(Group::Sharing, u"--make-unique"_s, fieldOf(&CliOptions::makeUnique), true,
                           u"objects that share a mesh in the file get one each, with a map of its own; "
                           "otherwise FBX, glTF and Collada files have one map for all of them"_s));
        all.push_back(flag(Group::Converting, u"--force"_s, fieldOf(&CliOptions::force), true,
                           u"make a session also of a damaged one, without what that has lost"_s));
        all.push_back(
            {Group::Measuring,
             {u"--fail-on"_s},
             u"LIST"_s,
             u"end with exit code 4 when the map has one of these, with commas: overlaps, flips, "
             "missing (faces without UVs), tiles (islands over the border of their tile), distortion:X "
             "(above X), gutter:X (islands closer than X texels)"_s,
             {},
             readFailOn});
        all.push_back(choice(Group::Picturing, u"--show"_s, fieldOf(&CliOptions::show),
                             {{u"model"_s, CliOptions::Show::Model},
                              {u"map"_s, CliOptions::Show::Map},
                              {u"both"_s, CliOptions::Show::Both}},
                             u"what the picture shows; both: the map beside the model"_s));
        all.push_back(integer(Group::Picturing, u"--size"_s, fieldOf(&CliOptions::pictureSide), 16, 4096,
                              u"pixels along the longer side of the picture"_s));
        for (const CliOption &option : generalOptions())
            all.push_back(option);
        return all;
    }();
    return options;
}

} // namespace autocuts
