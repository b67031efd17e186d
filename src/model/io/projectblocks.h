// The container format of project files: named blocks, each compressed and with its own checksum.
#pragma once

#include "model/document/result.h"

#include <QByteArray>
#include <QStringList>

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
    bool brokenOff = false;                 //!< the file could not be read after the last block

    //! The content of a block; null when it is missing.
    const QByteArray *part(const char *name) const;
};

//! Reads all undamaged blocks. Error when this is not a project file, or its version is above `newest`.
//! \param path used in messages
//! \param only names of the blocks to read; empty: all
Result<ProjectParts> readContainer(const QByteArray &bytes, int newest, const QString &path,
                                   const std::vector<QByteArray> &only = {});

} // namespace autocuts
