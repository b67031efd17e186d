#include "jobs/jobtexts.h"
#include "model/plain/uvlayout.h"
#include "solver/definite/ripping.h"
#include "solver/definite/seamstitching.h"
#include "views/control/mapjobs/mapjobs.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <utility>

namespace autocuts {

namespace {

//! Least distance by which a part is moved aside, as a share of the diagonal of the map. Chosen by hand: a
//! cut is then seen when the whole map is.
constexpr double visibleGap = 0.005;

JobContext contextOnOneThread(JobControl &control)
{
    return {&control.stop(), 1, [&](const JobProgress &done) { control.setProgress(done.fraction); }};
}

MapJobResult failure(const QString &problem)
{
    MapJobResult result;
    result.problem = problem;
    return result;
}

QString ripMessage(const definite::RippedMap &made)
{
    QStringList parts{
        JobTexts::tr("Edges ripped: %1").arg(static_cast<int>(made.edges.size()) - made.wereOpen)};
    if (made.wereOpen > 0)
        parts << JobTexts::tr("seams already, forced now: %1").arg(made.wereOpen);
    if (made.newIslands > 0)
        parts << JobTexts::tr("new islands: %1").arg(made.newIslands);
    if (made.closed > 0)
        parts << JobTexts::tr("cut, but closed as long as they reach no border and no other cut: %1")
                     .arg(made.closed);
    if (made.locked > 0)
        parts << JobTexts::tr("left out in locked islands: %1").arg(made.locked);
    return parts.join(QStringLiteral(", "));
}

QString whyRefused(definite::SewOutcome outcome)
{
    switch (outcome) {
    case definite::SewOutcome::Held:
        return JobTexts::tr("both sides are locked or pinned");
    case definite::SewOutcome::Covers:
        return JobTexts::tr("the island would overlap itself");
    case definite::SewOutcome::Folds:
        return JobTexts::tr("faces would turn over");
    case definite::SewOutcome::Sewn:
    case definite::SewOutcome::Stopped:
        break;
    }
    return {};
}

} // namespace

MapJobResult ripJob(const MapInput &input, const QList<int> &edges, JobControl &control)
{
    if (!input.snapshot.uv)
        return failure(JobTexts::tr("There is no map to rip"));
    const double texel = 1.0 / input.packing.textureSize;
    const double gutter =
        std::max(input.packing.margin * texel, visibleGap * layoutBox(input.uv).diagonal().norm());
    const definite::RippedMap made =
        definite::ripEdges(input.snapshot, {edges.begin(), edges.end()}, gutter, contextOnOneThread(control));
    if (control.stop())
        return failure(JobTexts::tr("Cancelled: the map stays as it was"));
    if (made.edges.empty())
        return failure(made.locked > 0 ? JobTexts::tr("The island is locked: unlock it to rip it")
                                       : JobTexts::tr("Select edges between two faces to rip"));
    MapJobResult result;
    result.uv = made.uv;
    result.seams = {EditMapSeams::Edit::Rip, made.edges};
    result.message = ripMessage(made);
    return result;
}

MapJobResult stitchJob(const MapInput &input, const QList<int> &edges, JobControl &control)
{
    if (!input.snapshot.uv)
        return failure(JobTexts::tr("There is no map to stitch"));
    const definite::StitchedMap made =
        definite::stitchSeams(input.snapshot, {edges.begin(), edges.end()}, contextOnOneThread(control));
    if (control.stop())
        return failure(JobTexts::tr("Cancelled: the map stays as it was"));
    if (made.edges.empty() && made.refused.empty())
        return failure(JobTexts::tr("Select seams of the map to stitch"));
    MapJobResult result;
    if (!made.edges.empty()) {
        result.uv = made.uv;
        result.seams = {EditMapSeams::Edit::Stitch, made.edges};
    }
    QStringList parts{JobTexts::tr("Edges stitched: %1").arg(made.edges.size())};
    for (const auto &[outcome, count] : made.refused)
        parts << JobTexts::tr("not stitched, because %1: %2").arg(whyRefused(outcome)).arg(count);
    result.message = parts.join(QStringLiteral(", "));
    if (!made.edges.empty())
        tellNewOverlaps(input, control, result);
    if (result.problem.isEmpty() && !made.refused.empty())
        result.problem = std::exchange(result.message, {});
    return result;
}

} // namespace autocuts
