// The options of the command line program.
#pragma once

#include "model/plain/solvesettings.h"
#include "solver/unwrap/unwrap.h"

#include <QString>
#include <QStringList>

namespace autocuts {

//! What `autocuts-cli` was asked to do. clitable.h says which command takes which option.
struct CliOptions
{
    enum class Command {
        Help,
        Version,
        ManPage,  //!< the manual page on stdout
        Markdown, //!< the tables of the README on stdout
        Unwrap,
        Pack,
        Separate,
        Finish,
        Check,
        Convert,
        Sample,
        Replay
    };

    bool hasRectangle() const { return given.contains(QStringLiteral("--into")); }
    //! Takes the UDIM tile of the packing settings for the bin.
    void packIntoTile();

    Command command = Command::Help;
    QString input;     //!< file; for Sample its name
    QStringList given; //!< the options as written; -o for --output
    QString output;    //!< -o
    SolveSettings settings;
    unwrap::UnwrapOptions unwrap; //!< of the packing: the bin is that of --tile or --into
    int threads = 1;              //!< the result does not depend on it
    QString intoRectangle;        //!< pack: name of a rectangle of the session
    QString layout;               //!< .png or .svg, empty for none
    QString report;               //!< .json, empty for none
    bool json = false;            //!< check: figures as JSON
    double timeLimit = 0;         //!< wall seconds, 0 for none
    bool quiet = false;
};

} // namespace autocuts
