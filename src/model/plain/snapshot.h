// The input of a solve: the mesh, the steering and the settings at one moment. Plain: no Qt.
#pragma once

#include "model/plain/islandflags.h"
#include "model/plain/meshdata.h"
#include "model/plain/solvesettings.h"
#include "model/plain/statetoken.h"
#include "model/plain/types.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace autocuts {

//! The user's decision about a corner pair.
enum class PairState : std::uint8_t { Free, Cut, Joined };

//! A soup corner held at a position in UV space.
struct Pin
{
    int soupCorner = 0;
    Vec2 target = Vec2::Zero(); //!< solver units (mesh area pi)
    bool hard = false;          //!< true: held exactly; false: pulled by a spring
    double weight = 1;          //!< spring constant of a soft pin

    bool operator==(const Pin &) const = default;
};

//! A rectangle that the given soup corners should stay inside (paper, Eq. 10 and 11).
struct UvRectangle
{
    Vec2 lower = Vec2::Zero(), upper = Vec2::Ones(); //!< solver units (mesh area pi)
    std::vector<int> soupCorners;
    bool hard = false; //!< true: no corner may leave it
    double weight = 1; //!< the factor beta of this rectangle is SolveSettings::boxWeight * weight
    bool operator==(const UvRectangle &) const = default;
};

//! The user's steering: decisions about edges, pins, rectangles and islands. Units as in Snapshot.
struct Steering
{
    std::vector<PairState> pairState; //!< per corner pair; empty when all are free
    std::vector<double> pairWeight;   //!< per corner pair, painted factor >= 0; empty when all are 1
    std::vector<Pin> pins;
    std::vector<UvRectangle> rectangles;
    //! Per edge pair: the seams given by the user, for SeamMode::Keep and SeamMode::Only; empty: none.
    std::vector<bool> givenSeams;
    //! Edge loops that the user wants on one line of the map: edge pairs, one after the other along the loop.
    std::vector<std::vector<int>> straightLoops;
    std::vector<IslandFlags> faceFlags; //!< per face: locks, stacks and groups; empty: none
};

//! The part of a mesh that a job may change. Everything else stays bit-identical.
struct JobScope
{
    std::vector<bool> faces; //!< per face: true when the job may change it
    //! Where the border of the scope runs through an island. True: the map stays continuous across it; false:
    //! the scope is cut free.
    bool attached = true;
    //! True: the faces were chosen to be mapped anew. False: all others are only to be left alone.
    bool chosen = true;
};

//! A triangle that stays where it is and that nothing may come to overlap.
struct Obstacle
{
    std::array<Vec2, 3> corner;   //!< solver units, counter-clockwise
    std::array<bool, 3> isOpen{}; //!< side k, from corner k to the next, is on the border of what stays
};

//! Regions of the surface that are to keep their shape in the map, see solver/rigid.
struct RigidRegions
{
    std::vector<int> region; //!< per triangle: its region, -1: it may be stretched
    int count = 0;
    double share = 0;         //!< of the area that is in regions
    std::vector<bool> curved; //!< per region: slightly curved, it keeps as much of its shape as that allows
    //! Per triangle: factor on its energy above that of an isometry. Scaled so that the same bound holds:
    //! what the regions do not need is not spent elsewhere.
    std::vector<double> stiffness;
    //! Per edge pair: always a seam, because the regions at its sides would hang together by too little.
    //! Empty: none.
    std::vector<bool> apart;
};

//! The complete input of a solve. Const once built. Units: the solver scales the mesh to area pi; pins,
//! rectangles and start UVs are in those units. Copies share everything but the settings.
struct Snapshot
{
    std::shared_ptr<const MeshData> mesh;
    SolveSettings settings;
    std::shared_ptr<const Steering> steering = std::make_shared<const Steering>(); //!< never null
    //! Per soup corner, for StartMode::ExistingUv; null otherwise.
    std::shared_ptr<const UvMatrix> startUv;
    //! The map before the job, one row per corner in texture space; null when there is none. Faces that a job
    //! may not change keep it.
    std::shared_ptr<const UvMatrix> uv;
    double uvScale = 1;                    //!< length in texture space of one solver unit
    double tileHeight = 1;                 //!< of the texture, see PackingSettings::tileHeight()
    bool keepTiles = false;                //!< islands stay in their UDIM tiles, see udimTiles()
    std::shared_ptr<const JobScope> scope; //!< null: the job may change all faces
    std::shared_ptr<const std::vector<Obstacle>> obstacles; //!< null: none
    std::shared_ptr<const RigidRegions> rigid;              //!< null: every triangle may be stretched
    //! Per connected component: its islands are to run along the axes. Null: none of them.
    std::shared_ptr<const std::vector<bool>> aligned;
    //! The document's state that this was made from; default when there is no document.
    StateToken token;

    //! Replaces the shared steering by a copy that only this snapshot uses, and returns it for changes.
    Steering &editSteering()
    {
        const auto own = std::make_shared<Steering>(*steering);
        steering = own;
        return *own;
    }
    //! Factors on the energy of triangles, see RigidRegions::stiffness; empty: all are 1.
    const std::vector<double> &stiffness() const
    {
        static const std::vector<double> none;
        return rigid ? rigid->stiffness : none;
    }
    //! True when pins or rectangles determine the places and sizes of charts.
    bool placesIslands() const { return !steering->pins.empty() || !steering->rectangles.empty(); }
    //! True when the user joined at least one corner pair of the edge.
    bool isJoined(std::size_t edge) const
    {
        const std::vector<PairState> &state = steering->pairState;
        return !state.empty() &&
               (state[2 * edge] == PairState::Joined || state[2 * edge + 1] == PairState::Joined);
    }
    //! Factor on the cost of a seam along the edge: the mean of the weights of its two corner pairs.
    double edgeWeight(std::size_t edge) const
    {
        const std::vector<double> &weight = steering->pairWeight;
        return weight.empty() ? 1 : 0.5 * (weight[2 * edge] + weight[2 * edge + 1]);
    }
};

//! Makes the start UVs for StartMode::ExistingUv: the given UVs, scaled so that their total area is that of
//! the mesh, pi; with texel weights, that of the triangles at their target areas.
//! \param uv one row per corner, in any scale; non-finite rows stay non-finite
//! \returns one row per soup corner
UvMatrix startUvFromCorners(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
