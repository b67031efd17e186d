// The container format of project files: named blocks, each compressed and with its own checksum.
#pragma once

#include "model/document/result.h"

#include <QByteArray>
#include <QStringList>

#include <functional>
#include <map>
#include <vector>

namespace autocuts {

//! A block as stored in the file.
struct PackedBlock
{
    QByteArray name;
    qint64 size = 0; //!< bytes of the uncompressed content
    QByteArray checksum;
    QByteArray data; //!< a zlib stream, or the content itself when its size is the same
};

//! Makes a block. \param compress false when the content is already compressed
PackedBlock packBlock(const QByteArray &name, const QByteArray &content, bool compress = true);

//! Makes a container: one CBOR map with "format" and "version", then each block as name -> [size, checksum,
//! data].
QByteArray containerBytes(int version, const std::vector<PackedBlock> &blocks);

//! The undamaged contents of a project file.
struct ProjectParts
{
    int version = 0;
    std::map<QByteArray, QByteArray> parts; //!< content by name of the block
    std::vector<QByteArray> damaged;        //!< names of blocks whose checksum is wrong
    std::vector<QByteArray> skipped;        //!< names of blocks that were not wanted, or came before
    bool brokenOff = false;                 //!< the file could not be read after the last block

    //! The content of a block; null when it is missing.
    const QByteArray *part(const char *name) const;
};

//! Reads all undamaged blocks. Error when this is not a project file, its version is above `newest`, or the
//! contents together are far larger than those of a session in a file of this size. \param path used in
//! messages \param wanted true for the names of the blocks to read; the others are skipped without
//! decompressing them
Result<ProjectParts> readContainer(
    const QByteArray &bytes, int newest, const QString &path,
    const std::function<bool(const QByteArray &)> &wanted = [](const QByteArray &) { return true; });

} // namespace autocuts
