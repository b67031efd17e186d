#include "views/control/shownmap.h"

#include "model/plain/uvlayout.h"
#include "views/control/workspace.h"

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
    // The same tolerance as findCharts().
    const Eigen::AlignedBox2d box = layoutBox(document->uv());
    const double tolerance = box.isEmpty() ? 0 : 1e-6 * box.diagonal().norm();
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &edge = mesh.edgePairs[e];
        if (edge.diagonal)
            continue;
        for (int end = 0; end < 2; ++end) {
            const auto distance =
                (mUv.row(edge.corner[end][0]) - mUv.row(edge.corner[end][1])).cwiseAbs().maxCoeff();
            mSeparation[2 * e + end] = distance <= tolerance ? 0 : 1; // also 1 where there is no UV
        }
    }
}

} // namespace autocuts
