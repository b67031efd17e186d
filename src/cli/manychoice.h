// What `autocuts-cli batch` is to do.
#pragma once

#include <QString>
#include <QStringList>

namespace autocuts {

//! The options of a batch, besides those of its command.
struct ManyChoice
{
    QString command;      //!< the name of what is done with each file
    QStringList inputs;   //!< files, folders, patterns
    QStringList passed;   //!< the options of the command, as they were given
    QString format;       //!< suffix of the outputs; empty: that of each input
    QString report;       //!< .csv, .json or .html; empty for none
    int jobs = 0;         //!< files at once; 0: one for each core
    double memory = 0;    //!< gigabytes for all of them; 0: three quarters of what is free
    double fileLimit = 0; //!< seconds for each file; 0: none
    bool resume = false;  //!< go on where the journal in the folder ends
    bool retry = false;   //!< the same, and do again what failed
    QString journal;      //!< folder of the journal; empty: that of the outputs
    int part = 0;         //!< from 1, of so many parts; 0: all files
    int parts = 0;
    bool elsewhere = false; //!< another program does the work
};

} // namespace autocuts
