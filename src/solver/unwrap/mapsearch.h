// Searches the map of one problem as it is, from few cuts, nets and the soup.
#pragma once

#include "solver/preference/meshsymmetry.h"
#include "solver/search/seamoptimizer.h"
#include "solver/unwrap/candidates.h"

namespace autocuts::unwrap {

//! Effort on a mesh of this size. On small meshes fewer moves suffice and more starts help more. A draft has
//! one start; below 2,000 triangles that left the result to chance, so that it gets several there. The least
//! share of 0.4 was chosen by hand.
[[nodiscard]] search::OptimizeEffort effortFor(UnwrapQuality quality, int triangles);

//! Energy that one unit of seam cost is worth. \param lambda in [0, 1]
[[nodiscard]] double muOf(double lambda);

//! A symmetry that cuts must have, or that they get where it hardly costs more.
struct WishedSymmetry
{
    const preference::MeshSymmetry *plane = nullptr; //!< null: none
    bool required = false;
};

//! Finds the best map by the seam search and by the soup. \param snapshot with the preferences in its weights
//! \param iterations the Newton steps are added to it
//! \returns nothing when there is no map
[[nodiscard]] std::optional<Candidate> searchMap(std::shared_ptr<const Soup> soup, const Snapshot &snapshot,
                                                 const UnwrapOptions &options, Ranking &ranking,
                                                 const JobContext &job, const WishedSymmetry &symmetry,
                                                 int &iterations);

//! Shares of the progress at which the free map is found, where a symmetric one is tried then. A guess that
//! only the progress depends on.
constexpr double freeShare = 0.7;

//! A map with symmetric seams, where these hardly cost more than those of the free map; otherwise nothing.
//! The rest as for searchMap().
[[nodiscard]] std::optional<Candidate> searchSymmetric(std::shared_ptr<const Soup> soup,
                                                       const Snapshot &snapshot, const UnwrapOptions &options,
                                                       Ranking &ranking, const JobContext &job,
                                                       const preference::MeshSymmetry &symmetry,
                                                       const Candidate &free, int &iterations);

//! True when a draft starts from clusters and rigid regions joined to nets, and the other qualities also from
//! the map of that draft. \param snapshot with the preferences in its weights
[[nodiscard]] bool startsFromClusterNets(const Snapshot &snapshot);

//! A map of the soup, where the surface is such that an unwrap in standard quality starts from one; otherwise
//! nothing. \param snapshot with the preferences in its weights
[[nodiscard]] std::optional<SeamedMap> soupStart(const Snapshot &snapshot, const UnwrapOptions &options,
                                                 const JobContext &job);

} // namespace autocuts::unwrap
