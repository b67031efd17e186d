// The map shown in both views.
#pragma once

#include "views/control/session/islandglide.h"
#include "views/gl/stretch.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace autocuts {

class Workspace;

//! The shown UVs per soup corner and the separation of every corner pair. They are those of the document, or,
//! while a solve runs, those of its definite map or of its soup, in which the triangles are still separate.
//! A definite map is shown at once, so that what is shown is a valid map at every moment. The one before
//! shines through while it fades, and its islands whose seams stayed glide to their new places, so that the
//! eye can follow. Views and tools read the shown map only from here.
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
    //! How strong that is, from 0 to 1.
    double ghostStrength() const { return mGhostStrength; }
    //! One row per soup corner, texture space; not finite for corners without a UV. Empty without a document.
    const UvMatrix &uv() const;
    //! Per corner pair, from 0 (closed) to 1 (cut): s_delta of the separation energy (paper, Eq. 6) while a
    //! solve runs, otherwise 0 or 1 by whether the UVs are equal. For diagonals it is 0 unless a solve runs.
    const std::vector<float> &separation() const;
    //! Per edge pair: true when it is cut in the shown map, that is, at least one of its ends has a
    //! separation of 0.5 or more.
    bool isSeam(int edgePair) const;
    //! The stretch of the triangles; measured when it is first asked for, for all views. \pre a document
    const TriangleStretch &stretch() const;

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
    //! What shines through changed, nothing else.
    void ghostChanged();

private:
    void mapChanged();
    void setLive(bool soup, std::vector<float> separation, UvMatrix ghost);
    void fade();
    void stopFading();

    Workspace &mWorkspace;
    bool mLive = false, mSoup = false;
    UvMatrix mGhost;
    double mGhostStrength = 1;
    UvMatrix mNextGhost;               //!< what shines through after the map before
    std::optional<IslandGlide> mGlide; //!< of the map before, while it shines through
    QTimer mFading;
    QElapsedTimer mFadingSince;
    UvMatrix mUv;               //!< while a map of the solve is shown
    mutable bool mStale = true; //!< the next is of an older map
    mutable std::vector<float> mSeparation;
    mutable std::shared_ptr<const MeshData> mMeasured; //!< the mesh that the meter is for
    mutable std::optional<StretchMeter> mMeter;
    mutable std::optional<TriangleStretch> mStretch; //!< of the shown map; nothing until it is asked for
};

} // namespace autocuts
