// Transfers UVs to a model: from another model, another UV set or another object.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"
#include "model/plain/islandflags.h"
#include "model/transfer/placement.h"
#include "model/transfer/uvtransfer.h"

#include <QStringList>

namespace autocuts::jobs {

//! Where UVs come from, and where they go.
struct TransferJob
{
    std::shared_ptr<const MeshData> source;
    UvMatrix sourceUv;     //!< one row per corner of the source
    int sourceObject = -1; //!< only this object of it; -1: all
    QString sourceName;    //!< for messages: a path or a name

    std::shared_ptr<const MeshData> mesh;
    UvMatrix uv;             //!< the map before
    std::vector<bool> faces; //!< which faces get UVs; empty: all
    transfer::UvMatch match = transfer::UvMatch::Auto;
};

//! Leaves out the faces of locked islands. \param faceFlags per face; empty: none is locked
void keepLocked(TransferJob &job, const std::vector<IslandFlags> &faceFlags);

//! The result of runTransfer().
struct TransferredUvs
{
    bool stopped = false; //!< then there is nothing else
    UvMatrix uv;          //!< one row per corner; faces that were not matched are as before
    transfer::TransferFigures figures;
    QList<int> unmatched;          //!< these faces, ascending
    transfer::Placement placement; //!< of the source, where it has other units or axes than the model

    QString summary() const;      //!< what was matched, on one line
    QStringList warnings() const; //!< what is not as it should be, one line each
};

//! From an object, each object with some of the faces gets UVs by itself: the source is moved onto it when
//! they lie apart. Faces of the source itself and objects of another shape stay as they are. Any other source
//! is matched as a whole, where it lies; when that is far away, in other units or with another axis up.
Result<TransferredUvs> runTransfer(const TransferJob &input, const transfer::TransferControl &control);

} // namespace autocuts::jobs
