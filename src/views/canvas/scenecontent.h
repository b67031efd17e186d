// The arrays that a canvas draws, updated after events of the document.
#pragma once

#include "views/control/session/studiocontext.h"
#include "views/gl/soupbuffers.h"
#include "views/state/viewstate.h"

#include <Eigen/Geometry>
#include <QObject>

#include <limits>
#include <memory>
#include <optional>

namespace autocuts {

struct ChangeEvent;

//! The arrays of gl/soupbuffers.h for the open document. Events only mark arrays as outdated; refresh()
//! updates them before they are drawn. All those of a large mesh take long, so a window that has to answer
//! updates one in each turn of its event loop: refreshOne().
class SceneContent final : public QObject
{
    Q_OBJECT

public:
    //! Arrays, in the order of their updates. Measures is none: it is what colours of faces are made from.
    enum Part {
        Measures = 1,
        Uvs = 2,
        Vertices = 4,
        Faces = 8,
        Sides = 16,
        Ghost = 32,
        Points = 64,
        AllParts = 127
    };
    //! The arrays of larger meshes are not all made in one turn of the event loop. Chosen by hand: each takes
    //! some 20 to 50 ms for 400,000 triangles.
    static constexpr int mostTrianglesAtOnce = 20'000;

    //! \param asMap true for the UV view
    SceneContent(const StudioContext &context, bool asMap, QObject *parent = nullptr);
    ~SceneContent() override;

    //! The open mesh; null when nothing is open. Valid at any time, like the functions below.
    const MeshData *mesh() const;
    //! \pre mesh()
    std::shared_ptr<const MeshData> sharedMesh() const;
    const MeshFrame &frame() const;
    const SoupTopology &topology() const;
    //! The map that is drawn, one row per soup corner; not finite where there is no UV or the face is hidden.
    const UvMatrix &uv() const;
    bool isHidden(int soupCorner) const;
    bool isLarge() const;
    //! Bounding box of what is shown of the map at the last refresh(); empty when there is nothing.
    const Eigen::AlignedBox2d &uvBox() const { return mUvBox; }

    //! Updates all arrays. \returns a mask of those that changed since they were last reported
    int refresh();
    //! Updates one of the arrays that were outdated when the first of them was updated. What changes
    //! meanwhile waits for the next round, or a map that changes all the time would never be drawn.
    //! \returns a mask of the arrays of the round when this was the last, otherwise 0 \pre !isUpToDate()
    int refreshOne();
    //! False while an array is outdated.
    bool isUpToDate() const { return mStale == 0; }
    //! True when all arrays have been updated since the document was replaced, so that they fit each other.
    bool canBeDrawn() const { return mCanBeDrawn; }
    //! Makes the next refresh() report all arrays as changed, after the OpenGL context was lost.
    void markAll();

    const std::vector<SoupVertex> &vertices() const;
    const std::vector<float> &uvs() const { return mUvs; }
    //! What shines through a live map in the UV view: the ghost of the shown map or, behind the soup, the map
    //! that closing its gaps would give. Empty otherwise.
    const std::vector<float> &ghostUvs() const { return mGhostUvs; }
    const std::vector<FaceTexel> &faces() const { return mFaces; }
    //! The island number of each triangle, from 1; 0 when it has none or islands were not needed.
    const std::vector<quint32> &triangleIslands() const { return mTriangleIslands; }
    const std::vector<SideTexel> &sides() const { return mSides; }
    const std::vector<PointVertex> &points() const { return mPoints; }
    const ViewColors &colors() const { return mColors; }
    //! The texels per unit that get the colour in the middle; NaN when they are not shown or not known.
    double rightDensity() const { return mRightDensity; }
    //! True when edges that are kept straight are shown.
    bool showsStraight() const { return mShowsStraight; }

Q_SIGNALS:
    //! Emitted when the view has to be painted again.
    void changed();

private:
    struct MeshParts;

    void connectAll();
    void mark(int parts);
    void documentChanged(const ChangeEvent &event);
    void selectionChanged();
    void optionsChanged();
    void preferencesChanged();
    const MeshParts &meshParts() const;
    void update(int parts);
    void rebuildGhost();
    void rebuildFaces();
    std::vector<float> measureDensity();
    bool showsStretch() const;
    bool showsTexelWeights() const;
    void rebuildPoints();
    const Selection &shownSelection() const;

    const StudioContext mContext;
    const bool mAsMap;
    int mStale = AllParts;
    int mRound = 0, mMade = 0; //!< of refreshOne(): what is to be updated, and what was
    bool mCanBeDrawn = false;
    mutable std::unique_ptr<const MeshParts> mMeshParts; //!< of the open document; made when needed
    mutable UvMatrix mShownUv; //!< uv() when faces are hidden; without rows when it is outdated
    ViewColors mColors;
    ViewOptions mOptions; //!< for which the arrays were last marked
    Selection mSelection; //!< for which the arrays were last marked
    Eigen::AlignedBox2d mUvBox;
    double mRightDensity = std::numeric_limits<double>::quiet_NaN();
    bool mShowsStraight = false;
    std::vector<SoupVertex> mVertices;
    std::vector<float> mUvs, mGhostUvs;
    std::vector<FaceTexel> mFaces;
    std::vector<quint32> mTriangleIslands;
    std::vector<SideTexel> mSides;
    std::vector<PointVertex> mPoints;
};

} // namespace autocuts
