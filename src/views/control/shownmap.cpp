#include "views/control/shownmap.h"

#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "views/control/workspace.h"

#include <algorithm>

namespace autocuts {

ShownMap::ShownMap(Workspace &workspace, QObject *parent) : QObject(parent), mWorkspace(workspace)
{
    connect(&workspace, &Workspace::documentReplaced, this, [this] {
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

void ShownMap::showLive(UvMatrix soupUv, std::vector<float> separation)
{
    mUv = std::move(soupUv);
    mSeparation = std::move(separation);
    mLive = true;
    mStale = false;
    Q_EMIT changed();
}

void ShownMap::showDocument()
{
    if (!mLive)
        return;
    mLive = false;
    mStale = true;
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
