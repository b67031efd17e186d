#include "views/control/shownmap.h"

#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "views/control/workspace.h"

#include <algorithm>

namespace autocuts {

namespace {

// Chosen by hand.
constexpr int frameTime = 33; // milliseconds between two frames of a movement
constexpr int moveFrames = 5;
constexpr Eigen::Index mostMovedCorners = 300'000; // larger maps jump, which takes less time

} // namespace

ShownMap::ShownMap(Workspace &workspace, QObject *parent) : QObject(parent), mWorkspace(workspace)
{
    mFrames.setInterval(frameTime);
    connect(&mFrames, &QTimer::timeout, this, &ShownMap::moveOn);
    connect(&workspace, &Workspace::documentReplaced, this, [this] {
        mFrames.stop();
        mGhost = {};
        mLive = false;
        mStale = true;
    });
    connect(&workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (mLive || (event.type != ChangeEvent::Type::Uv && event.type != ChangeEvent::Type::UvSet))
            return;
        mStale = true;
        Q_EMIT changed();
    });
}

const UvMatrix &ShownMap::uv() const
{
    refresh();
    return mUv;
}

const std::vector<float> &ShownMap::separation() const
{
    refresh();
    return mSeparation;
}

bool ShownMap::isSeam(int edgePair) const
{
    const std::vector<float> &apart = separation();
    return std::max(apart[2 * edgePair], apart[2 * edgePair + 1]) >= 0.5f;
}

void ShownMap::showMap(UvMatrix soupUv, std::vector<float> separation, UvMatrix ghost)
{
    const UvMatrix &now = uv();
    const bool moves = !isSoup() && now.rows() == soupUv.rows() && soupUv.rows() <= mostMovedCorners &&
                       now.allFinite() && now != soupUv;
    setLive(false, std::move(separation), std::move(ghost));
    if (!moves) {
        mUv = std::move(soupUv);
        Q_EMIT changed();
        return;
    }
    mFrom = mUv;
    mTo = std::move(soupUv);
    mFrame = 0;
    mFrames.start();
    moveOn();
}

void ShownMap::showSoup(UvMatrix soupUv, std::vector<float> separation, UvMatrix ghost)
{
    setLive(true, std::move(separation), std::move(ghost));
    mUv = std::move(soupUv);
    Q_EMIT changed();
}

void ShownMap::setLive(bool soup, std::vector<float> separation, UvMatrix ghost)
{
    mFrames.stop();
    mLive = true;
    mSoup = soup;
    mStale = false;
    mSeparation = std::move(separation);
    mGhost = std::move(ghost);
}

//! Shows the next frame on the way from one definite map to the next.
void ShownMap::moveOn()
{
    ++mFrame;
    if (mFrame >= moveFrames) {
        mFrames.stop();
        mUv = std::move(mTo);
    } else {
        const double t = double(mFrame) / moveFrames, share = t * t * (3 - 2 * t);
        mUv = (1 - share) * mFrom + share * mTo;
    }
    Q_EMIT changed();
}

void ShownMap::showDocument()
{
    if (!mLive)
        return;
    mFrames.stop();
    mLive = false;
    mStale = true;
    mGhost = {};
    Q_EMIT changed();
}

void ShownMap::refresh() const
{
    if (!mStale)
        return;
    mStale = false;
    const Document *document = mWorkspace.document();
    mUv.resize(document ? document->mesh().soupCornerCount() : 0, 2);
    mSeparation.assign(document ? document->mesh().cornerPairCount() : 0, 0);
    if (!document)
        return;
    const MeshData &mesh = document->mesh();
    mUv = soupUv(mesh, document->uv());
    const std::vector<bool> open = openCornerPairs(mesh, document->uv());
    std::transform(open.begin(), open.end(), mSeparation.begin(),
                   [](bool apart) { return apart ? 1.f : 0.f; });
}

} // namespace autocuts
