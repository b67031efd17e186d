#include "views/control/session/shownmap.h"

#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "views/control/session/workspace.h"

#include <algorithm>
#include <utility>

namespace autocuts {

namespace {

constexpr int fadingTime = 240, fadingStep = 30; // milliseconds; chosen by hand

//! 1 where a map is open, 0 where it is closed, as at a cut inside an island that opens nothing.
std::vector<float> separationOf(const std::vector<bool> &open)
{
    std::vector<float> separation(open.size());
    std::transform(open.begin(), open.end(), separation.begin(),
                   [](bool apart) { return apart ? 1.f : 0.f; });
    return separation;
}

} // namespace

ShownMap::ShownMap(Workspace &workspace, QObject *parent) : QObject(parent), mWorkspace(workspace)
{
    mFading.setInterval(fadingStep);
    connect(&mFading, &QTimer::timeout, this, &ShownMap::fade);
    connect(&workspace, &Workspace::documentReplaced, this, [this] {
        stopFading();
        mGhost = {};
        mLive = false;
        mUv.resize(0, 2);
        mStale = true;
        mMeasured.reset();
        mMeter.reset();
        mStretch.reset();
    });
    connect(&workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (mLive || (event.type != ChangeEvent::Type::Uv && event.type != ChangeEvent::Type::UvSet))
            return;
        mStale = true;
        mapChanged();
    });
}

void ShownMap::mapChanged()
{
    mStretch.reset();
    Q_EMIT changed();
}

const UvMatrix &ShownMap::uv() const
{
    static const UvMatrix none(0, 2);
    if (mLive)
        return mUv;
    const Document *document = mWorkspace.document();
    return document ? document->soupMap().uv : none;
}

const std::vector<float> &ShownMap::separation() const
{
    if (std::exchange(mStale, false)) {
        const Document *document = mWorkspace.document();
        mSeparation = document ? separationOf(document->soupMap().open) : std::vector<float>();
    }
    return mSeparation;
}

bool ShownMap::isSeam(int edgePair) const
{
    const std::vector<float> &apart = separation();
    return std::max(apart[2 * edgePair], apart[2 * edgePair + 1]) >= 0.5f;
}

const TriangleStretch &ShownMap::stretch() const
{
    if (const std::shared_ptr<const MeshData> &mesh = mWorkspace.document()->weightedMesh();
        mMeasured != mesh) {
        mMeasured = mesh;
        mMeter.emplace(*mesh);
        mStretch.reset();
    }
    if (!mStretch)
        mStretch = mMeter->measure(uv());
    return *mStretch;
}

void ShownMap::showMap(const UvMatrix &map, UvMatrix ghost)
{
    const MeshData &mesh = mWorkspace.document()->mesh();
    UvMatrix shown = soupUv(mesh, map);
    const UvMatrix before = uv();
    const std::vector<float> separationBefore = separation();
    const bool fades = !isSoup() && before.rows() == shown.rows() && before.allFinite() &&
                       shown.allFinite() && before != shown;
    setLive(false, separationOf(openCornerPairs(mesh, map)), fades ? before : ghost);
    mUv = std::move(shown);
    if (fades) {
        mNextGhost = std::move(ghost);
        if (mesh.triangleCount() <= IslandGlide::mostTriangles)
            mGlide.emplace(mesh, OpenedMap{before, separationBefore}, OpenedMap{mUv, mSeparation});
        mFadingSince.start();
        mFading.start();
    }
    mapChanged();
}

void ShownMap::showSoup(UvMatrix soupUv, std::vector<float> separation, UvMatrix ghost)
{
    setLive(true, std::move(separation), std::move(ghost));
    mUv = std::move(soupUv);
    mapChanged();
}

void ShownMap::setLive(bool soup, std::vector<float> separation, UvMatrix ghost)
{
    stopFading();
    mLive = true;
    mSoup = soup;
    mStale = false;
    mSeparation = std::move(separation);
    mGhost = std::move(ghost);
}

void ShownMap::fade()
{
    const double share = double(mFadingSince.elapsed()) / fadingTime;
    if (share >= 1) {
        mGhost = std::exchange(mNextGhost, {});
        stopFading();
    } else if (mGlide) {
        mGhost = mGlide->at(share);
        mGhostStrength = 1 - share;
    } else {
        return; // a large map: it stays as it is until the end
    }
    Q_EMIT ghostChanged();
}

void ShownMap::stopFading()
{
    mFading.stop();
    mGlide.reset();
    mGhostStrength = 1;
}

void ShownMap::showDocument()
{
    if (!mLive)
        return;
    stopFading();
    mLive = false;
    mStale = true;
    mGhost = {};
    mUv.resize(0, 2);
    mapChanged();
}

} // namespace autocuts
