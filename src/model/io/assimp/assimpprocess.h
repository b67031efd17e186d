// Reads a scene by the program autocuts-reader: Assimp's importers crash, hang or take all memory on some
// damaged files, and take only that program with them.
#pragma once

#include "model/document/result.h"

#include <atomic>
#include <memory>

struct aiScene;

namespace autocuts {

//! What reading one file may take.
struct ReaderLimits
{
    qint64 memory = 0;      //!< bytes of address space
    qint64 cpuSeconds = 0;  //!< processor time
    qint64 wallSeconds = 0; //!< time that passes; the program may sleep, for example on a network disk
};

//! Limits for a file of this size, in bytes: several times what a whole file takes.
ReaderLimits readerLimits(qint64 size);

//! Reads a file. It has a root node on success. Waits; not for the GUI thread.
//! \param stop ends the reading within 0.1 s with an Error when it becomes true; null: never
Result<std::shared_ptr<aiScene>> readInProcess(const QString &path, const ReaderLimits &limits,
                                               const std::atomic<bool> *stop);

} // namespace autocuts
