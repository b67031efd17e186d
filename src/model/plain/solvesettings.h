// What the user can choose about a solve. Plain: no Qt.
#pragma once

namespace autocuts {

enum class DistortionEnergy { SymmetricDirichlet, Amips };
enum class StartMode { Rigid, Tutte, Random, ExistingUv };
enum class SeamWeighting { Length, Count };
enum class SolverKind { Fast, Exact };
enum class CreaseMode { Off, Auto, On };

//! Parameters of the energy (1 - lambda) D + lambda S (paper, Eq. 1) and of how it is minimised.
struct SolveSettings
{
    double lambda = 0;       //!< balance in [0, 1]; 0 is distortion alone
    double delta = 1;        //!< smoothing of the seamless L0 penalty (paper, Eq. 6), mesh area pi
    double boxWeight = 100;  //!< beta, weight of the rectangles (paper, section 4)
    DistortionEnergy energy = DistortionEnergy::SymmetricDirichlet;
    SeamWeighting weighting = SeamWeighting::Length;
    StartMode start = StartMode::Rigid;
    SolverKind solver = SolverKind::Fast;
    unsigned seed = 1;
    // Where seams should rather run. These count for every way of cutting.
    CreaseMode creases = CreaseMode::Auto; //!< seams along sharp edges; Auto: on meshes that have creases
    double creaseStrength = 0.8;           //!< part of the cost that a seam on a sharp edge saves, in [0, 1]
    double visibility = 0;                 //!< how much rather seams lie where they are hidden, in [0, 1]
    bool symmetry = false;                 //!< symmetric cuts on symmetric meshes (automatic map only)

    bool operator==(const SolveSettings &) const = default;
};

//! Weight of the pairs along the diagonals that triangulate a polygon (paper, section 4).
inline constexpr double diagonalWeight = 100;
//! Weight of the pairs that the user joined; a cut pair has weight 0.
inline constexpr double joinedWeight = 100;

} // namespace autocuts
