#include "views/control/live/livedisplay.h"

#include "model/document/makesnapshot.h"
#include "model/plain/uvlayout.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include <cmath>
#include <limits>

namespace autocuts {

namespace {

//! Largest number of points in the graph. When there are more, every other one is dropped. Chosen by hand.
constexpr std::size_t mostTracePoints = 4000;

double areaOf(const UvMatrix &soup)
{
    double area = 0;
    for (Eigen::Index c = 0; c + 2 < soup.rows(); c += 3)
        area += cross2(Vec2(soup.row(c)), Vec2(soup.row(c + 1)), Vec2(soup.row(c + 2)));
    return std::abs(area);
}

//! Moves and scales a ghost over the shown map.
void fitOver(const UvMatrix &shown, UvMatrix &ghost)
{
    const double area = areaOf(ghost);
    if (!(area > 0) || !shown.allFinite() || !ghost.allFinite())
        return;
    const double scale = std::sqrt(areaOf(shown) / area);
    const Eigen::RowVector2d from = ghost.colwise().mean(), to = shown.colwise().mean();
    ghost = (scale * (ghost.rowwise() - from)).rowwise() + to;
}

} // namespace

LiveDisplay::LiveDisplay(Workspace &workspace, ShownMap &shownMap, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mShownMap(shownMap)
{
    connect(&mPacker, &LivePacker::arranged, this, &LiveDisplay::arranged);
}

void LiveDisplay::clear()
{
    mSoup.reset();
    mMap.reset();
    mPacker.reset();
    mSoupStatus = {};
    mSoupTrace.clear();
    mMapTrace.clear();
    mTraceStride = 1;
    mSoupRan = false;
}

void LiveDisplay::take(std::shared_ptr<const live::SolveResult> soup)
{
    mSoup = std::move(soup);
    mSoupStatus = mSoup->status;
    addToTrace(mSoup->trace);
}

void LiveDisplay::take(std::shared_ptr<const unwrap::LiveMapResult> map)
{
    mMap = std::move(map);
    mMapTrace.push_back({static_cast<int>(mMapTrace.size()) + 1, static_cast<float>(mMap->distortion),
                         static_cast<float>(mMap->seamLength), std::numeric_limits<float>::quiet_NaN()});
}

void LiveDisplay::setPacks(bool packs)
{
    mPacks = packs;
    mPacker.reset();
}

live::SolveStatus LiveDisplay::status(bool mapRests) const
{
    if (mView == LiveView::Soup || !mMap)
        return mSoupStatus;
    live::SolveStatus status;
    const SolveSettings settings = mWorkspace.document()->solveSettings();
    status.iteration = static_cast<int>(mMapTrace.size());
    status.distortion = mMap->distortion;
    status.separation = status.seamLength = mMap->seamLength;
    status.islands = mMap->islands;
    status.lambda = mSoupRan ? mSoupStatus.lambda : settings.lambda;
    status.delta = mSoupRan ? mSoupStatus.delta : settings.delta;
    status.energy = (1 - status.lambda) * status.distortion + status.lambda * status.separation;
    status.converged = mapRests;
    return status;
}

const std::vector<live::TracePoint> &LiveDisplay::trace() const
{
    return mView == LiveView::Soup || !mMap ? mSoupTrace : mMapTrace;
}

void LiveDisplay::show()
{
    const Document &document = *mWorkspace.document();
    const MeshData &mesh = document.mesh();
    UvMatrix soup, map;
    if (mSoup && mSoupRan && seesSoup())
        soup = document.uvScale() * mSoup->soupUv;
    if (mMap && (mView == LiveView::Map || mGhost))
        map = soupUv(mesh, mMap->uv);
    // Without a map before, both begin where they like.
    if (!hasUvs(document) && map.rows() > 0 && soup.rows() > 0)
        mView == LiveView::Map ? fitOver(map, soup) : fitOver(soup, map);
    if (mView == LiveView::Map && map.rows() > 0) {
        mShownMap.showMap(mMap->uv, std::move(soup));
    } else if (mView == LiveView::Soup && soup.rows() > 0) {
        if (mPacks)
            mPacker.arrange(document, mSoup->separation, soup);
        mShownMap.showSoup(std::move(soup), mSoup->separation, std::move(map));
    }
}

void LiveDisplay::addToTrace(const std::vector<live::TracePoint> &points)
{
    for (const live::TracePoint &point : points) {
        if (point.iteration % mTraceStride == 0)
            mSoupTrace.push_back(point);
    }
    while (mSoupTrace.size() > mostTracePoints) {
        mTraceStride *= 2;
        std::erase_if(mSoupTrace,
                      [this](const live::TracePoint &p) { return p.iteration % mTraceStride != 0; });
    }
}

} // namespace autocuts
