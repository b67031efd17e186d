// The options of the command line program.
#pragma once

#include "cli/manychoice.h"
#include "jobs/bakechoice.h"
#include "jobs/lightchoice.h"
#include "model/document/scenegroups.h"
#include "model/plain/solvesettings.h"
#include "model/transfer/uvtransfer.h"
#include "solver/overlap/overlapseparation.h"
#include "solver/packing/packmap.h"
#include "solver/unwrap/unwrap.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace autocuts {

//! The parsed command line of `autocuts-cli`. clitable.h defines which command has which option.
struct CliOptions
{
    //! Unlike the studio, no cage is measured unless it is asked for, and the format chooses the bits.
    CliOptions()
    {
        bake.ownCage = true;
        bake.bits = light.bits = 0;
    }

    enum class Command {
        Help,
        Version,
        ManPage,    //!< print the manual page to stdout
        Markdown,   //!< print the tables of docs/commandline.md to stdout
        Completion, //!< print what makes a shell complete the program's options
        Settings,   //!< print the settings that a command would have
        Unwrap,
        Pack,
        Separate,
        Lightmap,
        Finish,
        Check,
        Convert,
        Sample,
        Replay,
        Transfer,
        Bake,
        LightBake,
        Thumbnail,
        Batch
    };

    //! What --only names: the part of the model that the command may change. Empty: all of it.
    struct Only
    {
        std::vector<int> islands; //!< from 1, as the studio's island panel numbers them
        QStringList objects, materials;

        bool isEmpty() const { return islands.empty() && objects.isEmpty() && materials.isEmpty(); }
    };

    bool hasRectangle() const { return given.contains(QStringLiteral("--into")); }
    //! Sets the target of packing to the UDIM tile of the packing settings.
    void packIntoTile()
    {
        const packing::PackOptions tile = packing::tileOptions(unwrap.packing);
        unwrap.packing.lower = tile.lower;
        unwrap.packing.upper = tile.upper;
    }

    //! What makes check fail.
    struct FailOn
    {
        bool overlaps = false, flips = false, missing = false, tiles = false;
        std::optional<double> distortion; //!< above this
        std::optional<double> gutter;     //!< texels, below this
    };

    //! What a thumbnail shows.
    enum class Show { Model, Map, Both };

    Command command = Command::Help;
    //! In a batch: the command for each file. In "COMMAND --help": that command.
    Command each = Command::Help;
    std::optional<ManyChoice> many; //!< of several files
    QString input;                  //!< a file, - or the name of a sample or a shell
    QStringList given;              //!< the names of the given options, -o for --output
    QString preset;                 //!< its name or path; read before the other options
    bool showSettings = false;      //!< print the settings instead of running the command
    bool dryRun = false;            //!< only say what would be written
    QString settingsText;           //!< these settings, in the form of a preset
    QString output;                 //!< -o
    QString inputFormat;  //!< suffix of a model that comes by standard input; empty: that of the command
    QString outputFormat; //!< of one that goes to standard output; empty: that of the input
    SolveSettings settings;
    unwrap::UnwrapOptions unwrap; //!< its packing target is that of --tile or --into
    Only only;
    std::optional<SceneKind> per; //!< what gets a tile each
    bool oneTile = false;         //!< pack the islands of several tiles into one
    double density = 0;           //!< texels per unit, in as many tiles as that needs; 0: not given
    bool fillTiles = false;       //!< pack into the free room of the tiles in use
    overlap::SeparationMethod separation = overlap::SeparationMethod::MinCut;
    bool borderAttached = true; //!< JobScope::attached
    int threads = 1;            //!< does not influence the result
    QString uvSet;              //!< name, or number from 1, of a UV set of the input; empty: the active one
    QString newUvSet;           //!< name of the set that gets the map; empty: that of uvSet
    QString intoRectangle;      //!< pack: name of a rectangle of the session
    QString layout;             //!< path of a .png or .svg file; empty for none
    QString report;             //!< path of a .json file; empty for none
    bool json = false;          //!< check: print the figures as JSON
    bool force = false;         //!< convert: write a session although the one that is read is damaged
    bool makeUnique = false;    //!< objects that share a mesh in the file get one each
    double timeLimit = 0;       //!< seconds of wall time; 0 for none
    std::optional<FailOn> failOn;
    Show show = Show::Model;
    int pictureSide = 256; //!< thumbnail: pixels along each side
    bool quiet = false;
    bool jsonProgress = false;
    QString from;       //!< transfer: a mesh file or session; empty: the input
    QString fromUvSet;  //!< name, or number from 1, of a UV set of it; empty: the active one
    QString fromObject; //!< an object of it; empty: all
    transfer::UvMatch match = transfer::UvMatch::Auto;
    QStringList textures; //!< transfer: files of pictures to carry over, or "all" of the materials
    jobs::BakeChoice bake;
    jobs::LightChoice light;
};

} // namespace autocuts
