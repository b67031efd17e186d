// The container of a project file: named blocks, each compressed and with a checksum of its own.
#pragma once

#include "model/document/result.h"

#include <QByteArray>
#include <QStringList>

#include <map>
#include <vector>

namespace autocuts {

//! A block as it stands in the file.
struct PackedBlock
{
    QByteArray name;
    qint64 size = 0; //!< of the content
    QByteArray checksum;
    QByteArray data; //!< a zlib stream, or the content itself when that has the same size
};

//! \param compress false for what is compressed already
PackedBlock packBlock(const QByteArray &name, const QByteArray &content, bool compress = true);

//! One CBOR map: "format", "version", then every block as name -> [size, checksum, data].
QByteArray containerBytes(int version, const std::vector<PackedBlock> &blocks);

//! The contents of a project file, as far as they are whole.
struct ProjectParts
{
    int version = 0;
    std::map<QByteArray, QByteArray> parts; //!< content by name
    std::vector<QByteArray> damaged;        //!< names of blocks whose checksum does not fit
    bool brokenOff = false;                 //!< something after the last block cannot be read at all

    //! Null when it is not there.
    const QByteArray *part(const char *name) const;
};

//! Reads what is whole. An Error when it is no project file, or one of a version above `newest`.
//! \param path for messages
//! \param only names of the blocks wanted; empty: all
Result<ProjectParts> readContainer(const QByteArray &bytes, int newest, const QString &path,
                                   const std::vector<QByteArray> &only = {});

} // namespace autocuts
