// Minimises the distortion of an island some of whose points have to lie on lines.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/search/blockcholesky.h"
#include "solver/search/segments.h"
#include "solver/straight/island.h"

#include <optional>

namespace autocuts::straight {

//! Points that have one coordinate in common: their product with the normal.
struct Line
{
    std::vector<int> points;
    Vec2 normal = Vec2::UnitY(); //!< of unit length
};

//! How an island is symmetric about the line u = 0. Points on the axis are their own images.
using MirrorPoints = std::vector<int>; //!< per point: its image; empty: not symmetric

//! Newton's method where the lines are part of the parametrisation, so that they hold exactly: a point is a
//! linear function of the offsets of its lines and of what they leave free. A map whose points are not on
//! their lines is taken there by steps that flip no triangle (Boyd and Vandenberghe, Convex Optimization,
//! section 10.3).
class LineNewton
{
public:
    //! A point on more than two lines stays on the first two, and on the first one of two with nearly the
    //! same direction. Lines of one direction with a point in common are one. With a mirror the lines of one
    //! half count, and points that are each other's images stay so.
    LineNewton(const Island &island, const std::vector<Line> &lines, const MirrorPoints &mirror = {});

    //! Takes the points to their lines, then minimises. \param position no triangle is flipped
    //! \returns the energy; nothing when the lines cannot be reached, or when stopped. Then position is of no
    //! use
    std::optional<double> minimize(Positions &position, int steps, const JobContext &job = {});

    //! Per line: energy that it costs against the map `free` without lines, to second order.
    //! \param position of a minimum
    std::vector<double> costs(const Positions &position, const Positions &free) const;

private:
    using Matrix = Eigen::Matrix2d;
    using Corners = Eigen::Matrix<double, 6, 1>; //!< of a triangle: u and v of each
    using CornerMatrix = Eigen::Matrix<double, 6, 6>;
    //! A point is a sum of matrices times nodes, each of two unknowns.
    struct Source
    {
        int node;
        Matrix matrix;
    };
    struct Place
    {
        std::array<Source, 2> source;
        int count = 0;
        void add(int node, const Matrix &matrix) { source[count++] = {node, matrix}; }
    };

    void placeOnLines(const std::vector<Line> &lines, const std::vector<int> &image,
                      const std::vector<bool> &onAxis);
    void analyze();
    std::vector<Vec2> nodesOf(const Positions &position) const;
    Vec2 pointOf(const std::vector<Vec2> &nodes, int point) const;
    void addTriangle(const std::array<int, 3> &points, const Corners &gradient, const CornerMatrix &hessian,
                     std::vector<double> &right);
    bool assemble(const Positions &position, const Positions &shift, std::vector<double> &right,
                  const JobContext &job);
    bool step(Positions &position, double &energy, const JobContext &job);
    std::optional<double> findDirection(const Positions &position, const JobContext &job);
    bool takeStep(Positions &position, double slope, double &energy);
    bool borderCrosses(std::vector<int> *touched = nullptr);
    double flipFreeStep(const Positions &position, const Positions &direction) const;

    const Island &mIsland;
    std::vector<Line> mLines;
    std::vector<Place> mPlace; //!< per point
    int mNodes = 0;
    std::vector<int> mRank;  //!< per node: its place in the order of elimination
    std::vector<bool> mUses; //!< per unknown: it has an effect
    search::BlockCholesky mSystem;
    search::Segments mBorder;

    // The state of a minimisation.
    std::vector<Vec2> mNode, mChange; //!< per node
    std::vector<char> mFrozen;        //!< per node: held during this step, because of a crossing
    Positions mAway;                  //!< per point: from its lines at first
    double mLeft = 0;                 //!< share of mAway that is left
    Positions mDirection, mTrial;
};

} // namespace autocuts::straight
