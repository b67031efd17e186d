// What a job may change, as a problem of its own.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/meshpart.h"
#include "model/plain/snapshot.h"

#include <limits>
#include <optional>
#include <vector>

namespace autocuts::unwrap {

//! The faces that a job may change, with the steering that acts on them. Every other face keeps its UVs bit
//! for bit: faces outside the scope, and islands that are locked, stacked or grouped (the last two are rigid:
//! packing may still move them), or whose corners are all held by hard pins. Faces without UVs may always
//! change, unless they are outside the scope.
//!
//! What the steering implies is a cut or a join in the part. Cuts: given seams, the border of the faces of a
//! rectangle, and the border between faces in different UDIM tiles. Joins: all edges without a given seam
//! when only these may be seams. Where the scope is attached, corners on its border are hard pins.
class FreePart
{
public:
    //! \param previous a part whose faces may be taken over when they are the same; null: none
    //! \returns nothing when no face may change
    static std::optional<FreePart> of(const Snapshot &snapshot, const FreePart *previous = nullptr);
    //! True when both parts have the same faces of the same mesh.
    bool sameFaces(const FreePart &other) const { return mSnapshot.mesh == other.mSnapshot.mesh; }
    //! True when the faces are the same but for their texel weights.
    bool hasOtherSizes(const FreePart &other) const;

    //! The problem of the part: settings and steering in the solver units of the part, no scope, no flags.
    const Snapshot &snapshot() const { return mSnapshot; }
    //! The same without rectangles, whose borders are cuts: these say where charts go, not how they are made.
    Snapshot withoutRectangles() const;
    bool isWhole() const { return mPart.mesh == nullptr; }
    //! True when some of its corners are UV vertices of faces outside as well.
    bool isAttached() const { return !mAttached.empty(); }

    //! Whole things from those of the part; what is not in the part comes from before the job.
    //! \param uv per corner of the part, texture space
    UvMatrix wholeUv(const UvMatrix &uv) const;
    //! The part's rows of a matrix with a row per corner of the whole mesh.
    UvMatrix partUv(const UvMatrix &whole) const;
    //! \param cut per edge pair of the part
    std::vector<bool> wholeCut(const std::vector<bool> &cut) const;
    //! The charts of a whole map: those of the part, those before the job elsewhere, united where they are
    //! attached. \param charts of the part
    ChartMap wholeCharts(const ChartMap &charts) const;
    int wholeSoupCorner(int soupCorner) const;
    int wholeEdge(int edgePair) const { return isWhole() ? edgePair : mPart.edgePair[edgePair]; }
    //! The part's rows of a matrix with a row per soup corner of the whole mesh.
    UvMatrix partRows(const UvMatrix &soupRows) const;
    //! The opposite: a row per soup corner of the whole mesh, in its solver units. \param rows of the part,
    //! in units of the part
    UvMatrix wholeRows(const UvMatrix &rows) const;
    //! Per corner pair of the whole mesh: values of the part, 0 or 1 elsewhere by whether it is open.
    std::vector<float> wholePairs(const std::vector<float> &pairs) const;
    //! Length in solver units of the part per length in those of the whole mesh.
    double unit() const { return mUnit; }
    //! Length of the seams of the map before that the job does not change, in solver units of the whole mesh.
    double seamLengthOfRest() const;
    //! The bound for what may change: lower than that of the user where what stays is stretched more, so that
    //! the mean of the whole map keeps to it as it did before.
    double boundBeside(double maxDistortion) const;
    //! The bound by which the part of the map before is compared with others. That of the user is for the
    //! mean of the whole map: where that keeps to it, its part does, however much it is stretched. \param
    //! before distortion that counts for the bound of the part in the map before
    double boundOf(double maxDistortion, double before) const;

private:
    void addBorders(const Snapshot &whole, const std::vector<bool> &faces);
    void addSteering(const Snapshot &whole);
    void addObstacles(const Snapshot &whole, const std::vector<bool> &faces);
    void measureBefore();
    void cutImpliedSeams();
    void decideGivenSeams();

    Snapshot mWhole, mSnapshot;
    std::vector<bool> mFaces;  //!< per face of the whole mesh: it is in the part
    std::vector<bool> mPinned; //!< the same: hard pins hold all its corners; empty when there is no map
    MeshPart mPart;            //!< null mesh: the whole mesh
    double mUnit = 1;
    //! Mean distortion of the whole map before; infinite where it has none, and of a part that is the whole.
    double mDistortionBefore = std::numeric_limits<double>::infinity();
    //! The same of what stays, at a scale of its own.
    double mDistortionOfRest = std::numeric_limits<double>::infinity();
    //! A corner of the part that is the same UV vertex as a corner of a face outside of it.
    struct Attachment
    {
        int corner;      //!< of the part
        int face;        //!< of the part: the face of the corner
        int outsideFace; //!< of the whole mesh
    };
    std::vector<Attachment> mAttached;
};

} // namespace autocuts::unwrap
