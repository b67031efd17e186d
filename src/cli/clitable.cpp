#include "cli/clitable.h"

#include "cli/bakeoptions.h"
#include "cli/clivalues.h"
#include "cli/lightoptions.h"
#include "cli/optionmakers.h"

#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

namespace autocuts {

namespace {

using Command = CliOptions::Command;
using Output = CliCommand::Output;
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
        choice(group, u"--seams"_s, fieldOf(&SolveSettings::seams),
               {{u"free"_s, SeamMode::Free}, {u"keep"_s, SeamMode::Keep}, {u"only"_s, SeamMode::Only}},
               u"whose seams: those of the search; the given ones and what the bound needs besides; exactly "
               "the given ones"_s),
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
               {{u"rigid"_s, StartMode::Rigid},
                {u"tutte"_s, StartMode::Tutte},
                {u"random"_s, StartMode::Random},
                {u"uv"_s, StartMode::ExistingUv}},
               u"start from every triangle flat on its own, a Tutte embedding, random places, or the UVs of "
               "the file"_s),
        choice(group, u"--weights"_s, fieldOf(&SolveSettings::weighting),
               {{u"length"_s, SeamWeighting::Length}, {u"count"_s, SeamWeighting::Count}},
               u"what a seam costs: its length, or 1 per edge"_s),
        choice(group, u"--energy"_s, fieldOf(&SolveSettings::energy),
               {{u"symmetric-dirichlet"_s, DistortionEnergy::SymmetricDirichlet},
                {u"amips"_s, DistortionEnergy::Amips}},
               u"how distortion is measured while solving: isometric, or conformal (AMIPS)"_s),
        choice(group, u"--solver"_s, fieldOf(&SolveSettings::solver),
               {{u"fast"_s, SolverKind::Fast}, {u"exact"_s, SolverKind::Exact}},
               u"preconditioned conjugate gradients, or a full factorisation in every step"_s),
        choice(group, u"--quality"_s, fieldOf(&unwrap::UnwrapOptions::quality),
               {{u"draft"_s, unwrap::UnwrapQuality::Draft},
                {u"standard"_s, unwrap::UnwrapQuality::Standard},
                {u"best"_s, unwrap::UnwrapQuality::Best}},
               u"how long to search for shorter seams"_s),
        choice(
            group, u"--for"_s, fieldOf(&SolveSettings::surface),
            {{u"auto"_s, SurfaceKind::Auto},
             {u"organic"_s, SurfaceKind::Organic},
             {u"hard-surface"_s, SurfaceKind::HardSurface}},
            u"what the model is like: flat faces with sharp edges, which keep their shape and get the seams; "
            "curved, so that stretch may go anywhere; auto recognises each connected part, and the report "
            "says what was found"_s),
        choice(
            group, u"--flat"_s, fieldOf(&SolveSettings::flat),
            {{u"rigid"_s, FlatMode::Rigid}, {u"free"_s, FlatMode::Free}},
            u"flat faces, and what unrolls without stretch, keep their shape, and the stretch that "
            "--max-distortion allows goes to the curved rest; or it may go anywhere. No matter with --lambda"_s),
        choice(
            group, u"--alike"_s, fieldOf(&SolveSettings::alike),
            {{u"off"_s, AlikeMode::Off},
             {u"same-cuts"_s, AlikeMode::SameCuts},
             {u"stack"_s, AlikeMode::Stack}},
            u"connected parts that are copies of each other, also mirrored ones, get the same seams, which "
            "is faster, too; stack also lays islands that are copies on each other, mirrored ones turned "
            "over; off: each is cut on its own"_s),
        choice(
            group, u"--creases"_s, fieldOf(&SolveSettings::creases),
            {{u"off"_s, CreaseMode::Off}, {u"auto"_s, CreaseMode::Auto}, {u"on"_s, CreaseMode::On}},
            u"put seams along sharp edges; auto does so on parts where clear creases make up the sharp edges"_s),
        number(group, u"--crease-strength"_s, u"X"_s, fieldOf(&SolveSettings::creaseStrength), 0, 1,
               u"part of its cost that a seam on a sharp edge saves, 0 to 1"_s),
        number(group, u"--visibility"_s, u"X"_s, fieldOf(&SolveSettings::visibility), 0, 1,
               u"how much seams prefer hidden places, 0 (not at all) to 1"_s),
        flag(group, u"--symmetry"_s, fieldOf(&SolveSettings::symmetry), true,
             u"make symmetric cuts on symmetric meshes"_s),
        choice(
            group, u"--align"_s, fieldOf(&SolveSettings::align),
            {{u"off"_s, CreaseMode::Off}, {u"auto"_s, CreaseMode::Auto}, {u"on"_s, CreaseMode::On}},
            u"turn islands to the axes, and make straight in the map what is straight on the model, as far "
            "as the bound allows; auto does so on parts that are hard surfaces"_s),
        flag(group, u"--mirror"_s, fieldOf(&SolveSettings::mirrorMaps), true,
             u"make the maps of symmetric islands symmetric, and those of islands on both sides of a "
             u"symmetric "
             "mesh mirror images of each other; --symmetry makes cuts that allow it"_s),
        choice(group, u"--world-up"_s, fieldOf(&SolveSettings::worldUp),
               {{u"-"_s, WorldUp::Off}, {u"y"_s, WorldUp::Y}, {u"z"_s, WorldUp::Z}},
               u"turn islands so that this direction of the model is up in the map; they are packed as they "
               "stand"_s),
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
               {{u"free"_s, PackRotation::Free},
                {u"180"_s, PackRotation::Half},
                {u"90"_s, PackRotation::Quarter},
                {u"45"_s, PackRotation::Eighth},
                {u"30"_s, PackRotation::Twelfth},
                {u"15"_s, PackRotation::TwentyFourth},
                {u"none"_s, PackRotation::None}},
               u"how islands may be turned: freely, though those whose border is mostly right-angled stand "
               u"upright; by "
               "multiples of so many degrees; or not at all"_s),
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
        "UDIM tiles as that needs, from --tile on; an island that is larger than a tile gets one of its own, "
        "in which it is smaller"_s);
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
        text(Group::Reporting, {u"--report"_s}, fieldOf(&CliOptions::report),
             u"write the figures of the result as JSON, also those of each object and material"_s),
        defaultingTo(integer(Group::Limiting, u"--threads"_s, fieldOf(&CliOptions::threads), 1, 1024,
                             u"threads to use; the result does not depend on it"_s),
                     u"all cores"_s),
        number(Group::Limiting, u"--time-limit"_s, u"SECONDS"_s, fieldOf(&CliOptions::timeLimit), 0.001, 1e9,
               u"stop then and write the best map so far"_s),
        integer(group, u"--seed"_s, fieldOf(&SolveSettings::seed), 0, 2'000'000'000,
                u"seed of everything random: the same command gives the same bytes"_s),
    };
}

//! Sets a field of the options of a batch.
template <class T>
Field<T> fieldOf(T ManyChoice::*member)
{
    return [member](CliOptions &options) -> T & {
        if (!options.many)
            options.many.emplace();
        return *options.many.*member;
    };
}

//! An option for a suffix of files.
CliOption suffixOption(Group group, const QString &name, const Field<QString> &field, const QString &meaning)
{
    return {group,
            {name},
            u"SUFFIX"_s,
            meaning,
            {},
            [field](CliOptions &options, const QString &value) -> Problem {
                static const QRegularExpression suffix(u"^\\.?([a-z0-9]+)$"_s);
                const auto match = suffix.match(value.toLower());
                if (!match.hasMatch())
                    return u"a suffix such as glb"_s;
                field(options) = match.captured(1);
                return std::nullopt;
            }};
}

std::vector<CliOption> batchOptions()
{
    constexpr Group group = Group::Batching;
    CliOption journal = text(group, {u"--journal"_s}, fieldOf(&ManyChoice::journal),
                             u"folder for the journal, in place of that of the outputs"_s);
    journal.value = u"DIR"_s;
    return {
        {group,
         {u"--report"_s},
         u"FILE"_s,
         u"write what came of all files: .csv, .json, or .html, a page with pictures and figures that sort "
         u"and "
         "filter, and with the difference to the run before"_s,
         {},
         [](CliOptions &options, const QString &value) -> Problem {
             static const QStringList known{u"csv"_s, u"json"_s, u"html"_s};
             if (!known.contains(QFileInfo(value).suffix()))
                 return u"a .csv, .json or .html file"_s;
             options.many->report = value;
             return std::nullopt;
         }},
        defaultingTo(integer(group, u"--jobs"_s, fieldOf(&ManyChoice::jobs), 1, 256,
                             u"files to work on at once; the threads are shared among them"_s),
                     u"one for each core"_s),
        number(group, u"--memory"_s, u"GIGABYTES"_s, fieldOf(&ManyChoice::memory), 0.1, 1e6,
               u"memory for all of them together: large files wait until they fit, one that never does is "
               u"worked on "
               "alone; 100 MB and 150 times the size of a file are expected. Three quarters of what is free "
               "when not given"_s),
        number(group, u"--file-limit"_s, u"SECONDS"_s, fieldOf(&ManyChoice::fileLimit), 0.001, 1e9,
               u"give a file up after this time; --time-limit takes the best map so far"_s),
        flag(group, u"--resume"_s, fieldOf(&ManyChoice::resume), true,
             u"go on with a batch that was ended: what its journal in the folder knows, and has not changed, "
             u"is "
             "not done again"_s),
        {group,
         {u"--retry"_s},
         {},
         u"the same, but do again what failed"_s,
         {},
         [](CliOptions &options, const QString &) -> Problem {
             options.many->resume = options.many->retry = true;
             return std::nullopt;
         }},
        suffixOption(
            group, u"--format"_s, fieldOf(&ManyChoice::format),
            u"format of the outputs, for example glb; when not given, that of each input, or obj or fbx "
            "where that cannot be written"_s),
        flag(group, u"--dry-run"_s, fieldOf(&ManyChoice::dryRun), true,
             u"only say which file would be written of which"_s),
        {group,
         {u"--part"_s},
         u"K/N"_s,
         u"do only the K-th of N parts of the files, for arrays of jobs; each part has a journal of its own "
         "in the folder, and --resume without --part takes them all over"_s,
         {},
         [](CliOptions &options, const QString &value) -> Problem {
             static const QRegularExpression form(u"^(\\d{1,6})/(\\d{1,6})$"_s);
             const auto match = form.match(value);
             const int part = match.captured(1).toInt(), parts = match.captured(2).toInt();
             if (part < 1 || part > parts)
                 return u"K/N with K from 1 to N"_s;
             options.many->part = part;
             options.many->parts = parts;
             return std::nullopt;
         }},
        journal,
        flag(group, u"--elsewhere"_s, fieldOf(&ManyChoice::elsewhere), true,
             u"leave the work to the program that has started this one, such as autocuts.farm: say on "
             "standard output what is to be done, and read from standard input what came of it"_s),
    };
}

std::vector<CliOption> tilingOptions()
{
    return {tilingOption(), tilesOption(), densityOption()};
}

} // namespace

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
        {Command::Convert, u"convert"_s, u"IN"_s, Output::Needed, UvSets | Sharing | Converting,
         u"write another file format; OBJ to OBJ, FBX to FBX and glTF to glTF change nothing"_s},
        {Command::Thumbnail, u"thumbnail"_s, u"IN"_s, Output::Needed, Picturing,
         u"draw a small PNG picture of a model; of a session, the one that it holds, as file managers show it"_s},
        {Command::Batch, u"batch"_s, u"COMMAND IN..."_s, Output::Needed, Batching,
         u"do one of the commands above with many files, each in a process of its own: files, folders with "
         u"all "
         "that is below them, patterns such as models/**/*.fbx; -o is the folder for the outputs, which keep "
         "the places and names of the inputs; the command's options follow"_s},
        {Command::Replay,
         u"replay"_s,
         u"SESSION"_s,
         Output::Optional,
         {},
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

const std::vector<CliOption> &cliOptions()
{
    static const std::vector<CliOption> options = [] {
        std::vector<CliOption> all{
            text(Group::Output, {u"-o"_s, u"--output"_s}, fieldOf(&CliOptions::output), u"file to write"_s)};
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
                           u"print the figures as JSON"_s));
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
        all.push_back(
            {Group::Everything,
             {u"--preset"_s},
             u"NAME|FILE"_s,
             u"take options from a preset: game-prop, film-udim, lightmap, scan, an own one (NAME.preset in "
             "the folder autocuts/presets of the user's settings), or a file with lines such as margin = 8; "
             "options of the command line replace it, and those of other commands in it do not count"_s,
             {},
             [](CliOptions &own, const QString &value) -> std::optional<QString> {
                 own.preset = value;
                 return std::nullopt;
             }});
        all.push_back(flag(Group::Everything, u"--show-settings"_s, fieldOf(&CliOptions::showSettings), true,
                           u"print the settings that the command would have, in the form of a preset, and do "
                           "nothing"_s));
        all.push_back(flag(Group::Everything, u"--quiet"_s, fieldOf(&CliOptions::quiet), true,
                           u"no progress and no figures, only warnings and errors"_s));
        all.push_back(
            suffixOption(Group::Everything, u"--input-format"_s, fieldOf(&CliOptions::inputFormat),
                         u"format of a model that comes by standard input, where - is given for the "
                         "input; obj when not given. Files beside it are not found"_s));
        all.push_back(suffixOption(Group::Everything, u"--output-format"_s,
                                   fieldOf(&CliOptions::outputFormat),
                                   u"format of what goes to standard output, where -o - is given: one file, "
                                   "while the figures go to stderr; that of the input when not given"_s));
        all.push_back(choice(
            Group::Everything, u"--progress"_s, fieldOf(&CliOptions::jsonProgress),
            {{u"text"_s, false}, {u"json"_s, true}},
            u"how progress is said on stderr: for people, which is a line every ten seconds where that is no "
            "terminal, and one for each file of a batch; or as lines of JSON"_s));
        return all;
    }();
    return options;
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
        {4, u"check found what --fail-on names"_s},
        {130,
         u"interrupted by Ctrl-C; the best valid map so far has been written, if the model had been read"_s},
    };
    return codes;
}

} // namespace autocuts
