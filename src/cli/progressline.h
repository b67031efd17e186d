// Shows progress on a terminal.
#pragma once

#include "solver/base/jobcontext.h"

#include <QElapsedTimer>
#include <QString>
#include <QTextStream>

namespace autocuts {

//! One line on a terminal that is overwritten with the current progress, at most ten times a second.
class ProgressLine final
{
public:
    //! \param show false: nothing is written
    ProgressLine(bool show, QTextStream &err) : mShow(show), mErr(err) { mSince.start(); }
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine &) = delete;
    ProgressLine &operator=(const ProgressLine &) = delete;

    void show(const QString &text);
    void show(const JobProgress &progress);
    //! Erases the line, so that other text can be written.
    void clear();

private:
    bool mShow;
    QTextStream &mErr;
    QElapsedTimer mSince;
    bool mWritten = false;
};

} // namespace autocuts
