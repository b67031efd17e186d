// Reads the models that a job needs besides the one whose map it works on.
#pragma once

#include "jobs/remark.h"
#include "model/document/documentstate.h"
#include "model/document/result.h"
#include "solver/base/jobcontext.h"

namespace autocuts::jobs {

struct OtherModel
{
    DocumentState state;
    QStringList files; //!< that it was read from: no output may replace them
    Remarks warnings;  //!< what a session has lost
};

//! Reads a mesh file or a session; ends soon after a stop. \param tileHeight as in readMesh()
Result<OtherModel> readOtherModel(const QString &path, double tileHeight, const JobContext &context);

//! An error about such a model, with what a session has lost, which may be the reason.
Error withLosses(Error error, const OtherModel &model);

//! The scene with one of its UV sets as the first one. \param set out of range: nothing changes
Scene withFirstSet(Scene scene, int set);

//! The set of this name, or else of this number from 1. \param path for messages
Result<int> findUvSet(const std::vector<UvSet> &sets, const QString &word, const QString &path);

} // namespace autocuts::jobs
