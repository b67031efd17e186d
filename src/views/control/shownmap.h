// The map shown in both views.
#pragma once

#include "model/plain/types.h"

#include <QObject>
#include <QTimer>

#include <vector>

namespace autocuts {

class Workspace;

//! The shown UVs per soup corner and the separation of every corner pair. They are those of the document, or,
//! while a solve runs, those of its definite map or of its soup, in which the triangles are still separate.
//! A definite map is shown at once, and the one before shines through for a moment, so that the eye can
//! follow and what is shown is a valid map at every moment. Views and tools read the shown map only from
//! here.
class ShownMap final : public QObject
{
    Q_OBJECT

public:
    explicit ShownMap(Workspace &workspace, QObject *parent = nullptr);

    //! True when a map of the running solve is shown.
    bool isLive() const { return mLive; }
    //! True when the soup is shown.
    bool isSoup() const { return mLive && mSoup; }
    //! What shines through the shown map: one row per soup corner, texture space; empty: nothing.
    const UvMatrix &ghost() const { return mGhost; }
    //! One row per soup corner, texture space; not finite for corners without a UV. Empty without a document.
    const UvMatrix &uv() const;
    //! Per corner pair, from 0 (closed) to 1 (cut): s_delta of the separation energy (paper, Eq. 6) while a
    //! solve runs, otherwise 0 or 1 by whether the UVs are equal. For diagonals it is 0 unless a solve runs.
    const std::vector<float> &separation() const;
    //! Per edge pair: true when it is cut in the shown map, that is, at least one of its ends has a
    //! separation of 0.5 or more.
    bool isSeam(int edgePair) const;

    //! Shows a definite map instead of the document's. \pre the sizes are those of the document's mesh
    //! \param map one row per corner; its seams are where it is open
    void showMap(const UvMatrix &map, UvMatrix ghost = {});
    //! Shows the soup instead of the document's map. \pre the sizes are those of the document's mesh
    void showSoup(UvMatrix soupUv, std::vector<float> separation, UvMatrix ghost = {});
    //! Shows the document's map again.
    void showDocument();

Q_SIGNALS:
    //! UVs or separation changed. Not emitted when the document is replaced; Workspace reports that.
    void changed();

private:
    void refresh() const;
    void setLive(bool soup, std::vector<float> separation, UvMatrix ghost);
    void endFading();

    Workspace &mWorkspace;
    bool mLive = false, mSoup = false;
    UvMatrix mGhost;
    UvMatrix mNextGhost; //!< what shines through after the map before
    QTimer mFading;      //!< runs while the map before shines through
    mutable bool mStale = true;
    mutable UvMatrix mUv;
    mutable std::vector<float> mSeparation;
};

} // namespace autocuts
