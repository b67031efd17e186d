// The map that both views show.
#pragma once

#include "model/plain/types.h"

#include <QObject>

#include <vector>

namespace autocuts {

class Workspace;

//! The UVs per soup corner as they are shown: the document's, or while a solve runs the solver's newest ones,
//! with its triangles still apart. Also how far every corner pair is apart. Views and tools read the map here
//! and nowhere else.
class ShownMap final : public QObject
{
    Q_OBJECT

public:
    explicit ShownMap(Workspace &workspace, QObject *parent = nullptr);

    //! True while the solver's map is shown.
    bool isLive() const { return mLive; }
    //! One row per soup corner, texture space; not finite where a corner has no UV. Empty without a document.
    const UvMatrix &uv() const;
    //! Per corner pair: 0 joined to 1 cut. Live: s_delta of the separation energy, else whether the UVs
    //! agree. Diagonals are 0 unless live.
    const std::vector<float> &separation() const;
    //! Per edge pair: cut in the map shown, that is at least one of its ends is nearer to cut than to joined.
    bool isSeam(int edgePair) const;

    //! The solver's map takes the place of the document's. \pre sizes fit the document's mesh
    void showLive(UvMatrix soupUv, std::vector<float> separation);
    //! Back to the document's map.
    void showDocument();

Q_SIGNALS:
    //! UVs or separation changed. Not sent when the document is replaced: Workspace says so.
    void changed();

private:
    void refresh() const;

    Workspace &mWorkspace;
    bool mLive = false;
    mutable bool mStale = true;
    mutable UvMatrix mUv;
    mutable std::vector<float> mSeparation;
};

} // namespace autocuts
