// What a canvas draws of the document, kept up to date by what the events name.
#pragma once

#include "views/control/studiocontext.h"
#include "views/gl/soupbuffers.h"
#include "views/state/viewstate.h"

#include <Eigen/Geometry>
#include <QObject>

#include <memory>
#include <optional>

namespace autocuts {

struct ChangeEvent;

//! The arrays of gl/soupbuffers.h for the open document. Events only mark what is out of date; refresh()
//! brings that up to date when it is going to be drawn.
class SceneContent final : public QObject
{
    Q_OBJECT

public:
    enum Part { Vertices = 1, Uvs = 2, Faces = 4, Sides = 8, Points = 16, AllParts = 31 };

    //! \param asMap for the UV view
    SceneContent(const StudioContext &context, bool asMap, QObject *parent = nullptr);
    ~SceneContent() override;

    //! Null when nothing is open. This and what follows fit the document at any time.
    const MeshData *mesh() const;
    //! \pre mesh()
    std::shared_ptr<const MeshData> sharedMesh() const;
    const MeshFrame &frame() const;
    const SoupTopology &topology() const;
    const UvMatrix &uv() const;
    //! Box of the map as of the last refresh(); empty when there are no UVs.
    const Eigen::AlignedBox2d &uvBox() const { return mUvBox; }

    //! Brings the arrays up to date. \returns mask of the parts that changed since the last call
    int refresh();
    //! Makes the next refresh() report everything: the graphics card lost what it had.
    void markAll();

    const std::vector<SoupVertex> &vertices() const { return mVertices; }
    const std::vector<float> &uvs() const { return mUvs; }
    //! Empty unless a live map is shown in the UV view.
    const std::vector<float> &ghostUvs() const { return mGhostUvs; }
    const std::vector<FaceTexel> &faces() const { return mFaces; }
    //! Per triangle the number of its island, from 1; 0 where there is none or it was not looked for.
    const std::vector<quint32> &triangleIslands() const { return mTriangleIslands; }
    const std::vector<SideTexel> &sides() const { return mSides; }
    const std::vector<PointVertex> &points() const { return mPoints; }
    const ViewColors &colors() const { return mColors; }

Q_SIGNALS:
    //! The picture is out of date.
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
    void rebuildFaces();
    void rebuildPoints();
    const Selection &shownSelection() const;

    const StudioContext mContext;
    const bool mAsMap;
    int mStale = AllParts;
    mutable std::unique_ptr<const MeshParts> mMeshParts; //!< of the open document, once needed
    ViewColors mColors;
    ViewOptions mOptions; //!< that the arrays were marked for
    Selection mSelection; //!< that the arrays were marked for
    Eigen::AlignedBox2d mUvBox;
    std::vector<SoupVertex> mVertices;
    std::vector<float> mUvs, mGhostUvs;
    std::vector<FaceTexel> mFaces;
    std::vector<quint32> mTriangleIslands;
    std::vector<SideTexel> mSides;
    std::vector<PointVertex> mPoints;
};

} // namespace autocuts
