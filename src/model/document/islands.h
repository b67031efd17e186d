// UV islands of the active layout, and the marks that users put on them.
//
// A UV island is a connected set of faces over uncut edges; the solver calls it a chart. Islands are derived
// from the UVs and have no identity: an edit can split one island or stitch two into one. Marks are therefore
// stored per face. An island has
// - the lock when any of its faces is locked, so that a locked face never moves,
// - its orientation kept when that of any of its faces is,
// - the stack or group that most of its faces have; "none" counts as a value as well but loses a tie, and
//   among other equally frequent values the smallest wins,
// - a tag when at least half of its faces have it.
// So both islands keep the marks after a cut, and an island stitched from two has the stack, group and tags
// of the larger one.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/islandflags.h"

#include <Eigen/Geometry>
#include <QList>
#include <QString>

#include <vector>

namespace autocuts {

//! A named set of faces.
struct IslandTag
{
    QString name;     //!< not empty, unique
    QList<int> faces; //!< strictly ascending, not empty

    bool operator==(const IslandTag &) const = default;
};

//! All marks of a document.
struct IslandMarks
{
    std::vector<IslandFlags> faceFlags; //!< one per face
    std::vector<IslandTag> tags;        //!< ascending by name

    static IslandMarks none(const MeshData &mesh);

    //! The flags of an island made of these faces, by the rule above.
    IslandFlags flagsOf(const std::vector<int> &faces) const;
    //! The names of the tags of an island made of these faces, by the rule above.
    std::vector<QString> tagsOf(const std::vector<int> &faces) const;
    //! The tag of a name, or null.
    const IslandTag *tag(const QString &name) const;

    //! Returns an empty string, or the first invariant that does not hold.
    QString validate(const MeshData &mesh) const;

    bool operator==(const IslandMarks &) const = default;
};

//! The islands of one layout, numbered by their lowest faces. Faces without UVs are in no island.
class Islands
{
public:
    Islands(const MeshData &mesh, const UvMatrix &uv);

    const ChartMap &charts() const { return mCharts; }
    int count() const { return mCharts.count; }
    int faceCount() const { return static_cast<int>(mCharts.faceChart.size()); }
    //! The island of a face; -1 when the face has no UVs.
    int islandOfFace(int face) const { return mCharts.faceChart[face]; }
    //! The faces of an island in ascending order.
    const std::vector<int> &faces(int island) const { return mFaces[island]; }
    //! The island of each face, and the faces of each island.
    const std::vector<int> &ofFaces() const { return mCharts.faceChart; }
    const std::vector<std::vector<int>> &allFaces() const { return mFaces; }
    //! Bounding box of an island in texture space.
    const Eigen::AlignedBox2d &box(int island) const { return mBoxes[island]; }
    //! Corners of the given islands in ascending order.
    std::vector<int> corners(const MeshData &mesh, const std::vector<int> &islands) const;
    //! The islands that contain at least one of these faces, in ascending order.
    std::vector<int> islandsOf(const QList<int> &faces) const;

private:
    ChartMap mCharts;
    std::vector<std::vector<int>> mFaces;
    std::vector<Eigen::AlignedBox2d> mBoxes;
};

} // namespace autocuts
