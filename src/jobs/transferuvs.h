// Brings UVs from another model, another UV set or another object onto a model.
#pragma once

#include "jobs/remark.h"
#include "jobs/transferchoice.h"
#include "jobs/transferring.h"
#include "solver/base/jobcontext.h"

namespace autocuts::jobs {

//! The model that gets UVs.
struct TransferInput
{
    std::shared_ptr<const MeshData> mesh;
    UvMatrix uv;                        //!< the map before
    std::vector<UvSet> uvSets;          //!< of the model
    std::vector<bool> faces;            //!< which get UVs; empty: all
    std::vector<IslandFlags> faceFlags; //!< per face: locked ones stay; empty: none is locked
    QStringList written;                //!< outputs: none of the source's files may be among them
    double tileHeight = 1;
};

//! The new map.
struct TransferOutcome
{
    TransferredUvs made;
    Remarks warnings;
};

//! The number of the object of this name. \param path for messages
Result<int> findObject(const std::vector<QString> &names, const QString &name, const QString &path);

Result<TransferOutcome> transferUvs(const TransferInput &input, const TransferChoice &choice,
                                    const JobContext &context);

} // namespace autocuts::jobs
