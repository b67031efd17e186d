// Reads the models that UVs are transferred from.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <atomic>

namespace autocuts {

//! A model with its UV sets in the order of the file.
struct TransferSource
{
    std::shared_ptr<const MeshData> mesh;
    std::vector<UvSet> uvSets;
    int activeSet = 0;
    std::vector<QString> objectNames;
    QString path;
    QStringList warnings = {}; //!< what a session has lost, see lossesOf()
    QStringList files = {};    //!< that it was read from

    //! The UVs of the active set; a layout without UVs when there is none.
    UvMatrix uv() const;
};

//! What a session that a job reads beside its own one has lost, one line each with its file name.
QStringList lossesOf(const QString &path, const QStringList &warnings);

//! An error of a job, with what such a session has lost, which may be the reason.
Error withLosses(Error error, const QStringList &losses);

//! Reads a mesh file or a session. \param stop, tileHeight as in readMesh()
Result<TransferSource> readTransferSource(const QString &path, const std::atomic<bool> *stop,
                                          double tileHeight);

} // namespace autocuts
