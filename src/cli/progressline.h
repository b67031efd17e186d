// Says on stderr how far a job is.
#pragma once

#include "solver/base/jobcontext.h"

#include <QElapsedTimer>
#include <QString>
#include <QTextStream>

namespace autocuts {

//! How progress is shown. Line: one line of a terminal, written over again and again. Lines: a new line now
//! and then, for a file. Json: lines of JSON, for programs.
enum class ProgressStyle { None, Line, Lines, Json };

//! Shows progress at most ten times a second, or every ten seconds for Lines.
class ProgressLine final
{
public:
    //! \param seldom milliseconds between lines of Lines, and before the first
    ProgressLine(ProgressStyle style, QTextStream &err, int seldom = 10'000)
        : mStyle(style), mErr(err), mSeldom(seldom)
    {
        mSince.start();
    }
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine &) = delete;
    ProgressLine &operator=(const ProgressLine &) = delete;

    //! \param word for JobStage::Working
    void setWorkingWord(const QString &word) { mWorking = word; }
    void show(const QString &text);
    void show(const JobProgress &progress);
    //! Erases the line of a terminal, so that other text can be written.
    void clear();

private:
    bool isDue();
    QString wordOf(JobStage stage) const;

    ProgressStyle mStyle;
    QTextStream &mErr;
    QString mWorking = QStringLiteral("optimising");
    int mSeldom;
    QElapsedTimer mSince;
    bool mWritten = false;
};

} // namespace autocuts
