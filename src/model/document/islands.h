// UV islands of the active layout, and what the user marked on them.
//
// Islands are derived from the UVs and have no identity of their own: an edit can split one or join two.
// Marks are therefore kept per face, and an island has
// - the lock when any of its faces has it (what was locked is never moved, whatever was joined to it),
// - the stack or group that most of its faces have; "none" competes like any other value but loses a tie, and
//   of other equally frequent ones the smallest number wins,
// - a tag when at least half of its faces have it.
// So the pieces of a cut island keep its marks, and joining keeps the marks of the larger part.
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
    QList<int> faces; //!< strictly rising, not empty

    bool operator==(const IslandTag &) const = default;
};

//! All marks of a document.
struct IslandMarks
{
    std::vector<IslandFlags> faceFlags; //!< one per face
    std::vector<IslandTag> tags;        //!< rising by name

    static IslandMarks none(const MeshData &mesh);

    //! The flags of the island that consists of these faces, by the rule above.
    IslandFlags flagsOf(const std::vector<int> &faces) const;
    //! The names of the tags of the island that consists of these faces, by the rule above.
    std::vector<QString> tagsOf(const std::vector<int> &faces) const;
    //! Null when there is none.
    const IslandTag *tag(const QString &name) const;

    //! Empty when all invariants hold, else the first broken one.
    QString validate(const MeshData &mesh) const;

    bool operator==(const IslandMarks &) const = default;
};

//! The islands of one layout, numbered by their lowest faces; faces without UVs are in none.
class Islands
{
public:
    Islands(const MeshData &mesh, const UvMatrix &uv);

    int count() const { return mCharts.count; }
    int faceCount() const { return static_cast<int>(mCharts.faceChart.size()); }
    //! -1 when the face has no UVs.
    int islandOfFace(int face) const { return mCharts.faceChart[face]; }
    //! Faces in rising order.
    const std::vector<int> &faces(int island) const { return mFaces[island]; }
    //! Box of the island in texture space.
    const Eigen::AlignedBox2d &box(int island) const { return mBoxes[island]; }
    //! Corners of the given islands in rising order.
    std::vector<int> corners(const MeshData &mesh, const std::vector<int> &islands) const;
    //! The islands that have one of these faces, in rising order.
    std::vector<int> islandsOf(const QList<int> &faces) const;

private:
    ChartMap mCharts;
    std::vector<std::vector<int>> mFaces;
    std::vector<Eigen::AlignedBox2d> mBoxes;
};

} // namespace autocuts
