// Works on the files of a batch, each in a process of its own.
#pragma once

#include "cli/manyfiles/runjournal.h"
#include "cli/stopsource.h"

#include <QProcess>
#include <QTemporaryDir>

#include <functional>
#include <memory>

namespace autocuts::manyfiles {

//! The memory that a file is expected to take, in bytes: that of the program itself and a multiple of the
//! file's size. The factor was measured with OBJ files: of the formats that are not compressed, they take the
//! most for their size.
qint64 expectedMemory(const FileTask &task);

//! Limits on the files at work at once: their number, and the memory that they are expected to take. A file
//! that is expected to take more runs alone.
struct RunLimits
{
    int jobs = 1;
    int threads = 1;           //!< for each file
    qint64 memory = 0;         //!< bytes
    double secondsPerFile = 0; //!< 0: none
};

//! True when a file may be begun. \param running how many are at work \param taken memory that they are
//! expected to take, in bytes
bool mayBegin(const FileTask &task, const RunLimits &limits, int running, qint64 taken);

//! Starts a process for each file, in the order of the files. That a process fails, crashes or takes too long
//! concerns its file only.
class FileRunner final
{
public:
    //! \param folder of the outputs; it is there; empty: nothing is written
    //! \param pictures folder for a picture of each output, named as pictureName() says; empty: none
    FileRunner(const ManyChoice &choice, const QString &folder, const QString &pictures,
               const RunLimits &limits);
    ~FileRunner();
    FileRunner(const FileRunner &) = delete;
    FileRunner &operator=(const FileRunner &) = delete;

    //! Works on all files, or until it is told to stop: what is at work then is ended and has no result.
    //! \param finished called with each result as soon as there is one; false ends the run
    void run(const std::vector<FileTask> &tasks, const std::atomic<bool> &stop,
             const std::function<bool(const FileResult &)> &finished);

    //! The arguments of the program for a file.
    QStringList argumentsFor(const FileTask &task, const QString &report) const;
    //! The name of a picture, in the folder of pictures.
    static QString pictureName(const FileTask &task);

private:
    struct Running;
    void start(const FileTask &task);
    void look(Running &running);
    FileResult resultOf(Running &running) const;
    void startPicture(Running &running);

    const ManyChoice &mChoice;
    QString mFolder, mPictures;
    RunLimits mLimits;
    QTemporaryDir mReports;
    std::vector<std::unique_ptr<Running>> mRunning;
};

} // namespace autocuts::manyfiles
