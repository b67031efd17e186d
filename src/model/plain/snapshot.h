// What the solver gets to see: a const copy of the steering beside the shared mesh. Plain: no Qt.
#pragma once

#include "model/plain/statetoken.h"
#include "model/plain/meshdata.h"
#include "model/plain/solvesettings.h"
#include "model/plain/types.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace autocuts {

//! What the user decided about a corner pair.
enum class PairState : std::uint8_t { Free, Cut, Joined };

//! A soup corner held at a place in UV space.
struct Pin
{
    int soupCorner = 0;
    Vec2 target = Vec2::Zero(); //!< solver units (mesh area pi)
    bool hard = false;          //!< hard: exactly there; soft: a spring of the given weight
    double weight = 1;          //!< spring constant of a soft pin

    bool operator==(const Pin &) const = default;
};

//! A rectangle that the given soup corners should stay inside (paper, Eq. 10 and 11).
struct UvRectangle
{
    Vec2 lower = Vec2::Zero(), upper = Vec2::Ones(); //!< solver units (mesh area pi)
    std::vector<int> soupCorners;
    bool hard = false; //!< hard: no corner may leave it
    double weight = 1; //!< beta of this rectangle = SolveSettings::boxWeight * weight
    bool operator==(const UvRectangle &) const = default;
};

//! What the user asked of single edges, corners and islands. Units as Snapshot.
struct Steering
{
    std::vector<PairState> pairState; //!< per corner pair; empty: all free
    std::vector<double> pairWeight;   //!< per corner pair, painted factor >= 0; empty: all 1
    std::vector<Pin> pins;
    std::vector<UvRectangle> rectangles;
};

//! Everything a solve depends on. Const once built. Units: the solver scales the mesh so that its area is pi;
//! pins, rectangles and start UVs are in those units. Copies share everything but the settings.
struct Snapshot
{
    std::shared_ptr<const MeshData> mesh;
    SolveSettings settings;
    std::shared_ptr<const Steering> steering = std::make_shared<const Steering>(); //!< never null
    std::shared_ptr<const UvMatrix> startUv; //!< per soup corner, for StartMode::ExistingUv; else null
    StateToken token; //!< of the document's state; the default when there is no document

    //! Gives this snapshot a steering of its own to be changed, a copy of the one that it had.
    Steering &editSteering()
    {
        const auto own = std::make_shared<Steering>(*steering);
        steering = own;
        return *own;
    }
    //! True when pins or rectangles say where islands lie and how large they are.
    bool placesIslands() const { return !steering->pins.empty() || !steering->rectangles.empty(); }
    //! True when the user joined a side of the edge.
    bool isJoined(std::size_t edge) const
    {
        const std::vector<PairState> &state = steering->pairState;
        return !state.empty() &&
               (state[2 * edge] == PairState::Joined || state[2 * edge + 1] == PairState::Joined);
    }
    //! Factor on the cost of a seam along an edge: the mean of its corner pairs' weights.
    double edgeWeight(std::size_t edge) const
    {
        const std::vector<double> &weight = steering->pairWeight;
        return weight.empty() ? 1 : 0.5 * (weight[2 * edge] + weight[2 * edge + 1]);
    }
};

//! Start UVs for StartMode::ExistingUv: the corners' UVs, scaled so that their area is pi like the mesh's.
//! \param uv one row per corner, any scale; rows that are not finite stay so
//! \returns one row per soup corner
UvMatrix startUvFromCorners(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
