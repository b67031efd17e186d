// The user's settings for a solve. Plain: no Qt.
#pragma once

namespace autocuts {

enum class DistortionEnergy { SymmetricDirichlet, Amips };
enum class StartMode { Rigid, Tutte, Random, ExistingUv };
enum class SeamWeighting { Length, Count };
enum class SolverKind { Fast, Exact };
enum class CreaseMode { Off, Auto, On };
//! The kind of a model's surface. Auto: each of its connected parts is recognised, see
//! preference/surfacekind.h. HardSurface: flat faces and sharp edges; these keep their shape and get the
//! seams. Organic: curved, however its faces look; the stretch may go anywhere.
enum class SurfaceKind { Auto, Organic, HardSurface };
//! Whether flat faces, and what unrolls without stretch, keep their shape in automatic maps.
enum class FlatMode { Rigid, Free };
//! Whether connected parts that are copies of each other, also mirrored ones, get the same seams and the same
//! islands in automatic maps. Stack: in addition, an unwrap lays islands that are copies on each other.
enum class AlikeMode { Off, SameCuts, Stack };
//! Whether both sides of a symmetric model get the same seams in automatic maps. Auto: where they hardly cost
//! more, see unwrap/symmetricseams.h. On: wherever the model is symmetric.
enum class SymmetryMode { Off, Auto, On };
//! The direction of the model that is up in the map. Off: any. AutoY, AutoZ: an unwrap turns islands so where
//! that hardly costs texel density, see unwrap/unwrapplacing.h; other jobs leave them as they are.
enum class WorldUp { Off, Y, Z, AutoY, AutoZ };
//! Which edges may become seams. Free: any. Keep: the given seams stay, and the search adds those that the
//! bound needs. Only: the given seams and no others.
enum class SeamMode { Free, Keep, Only };

//! Which edges are given seams: the union of these sources. The borders of objects are seams in any case.
struct GivenSeamOptions
{
    bool cuts = true;       //!< edges that the user cut
    bool map = true;        //!< seams of the map that is there
    bool sharp = false;     //!< edges sharper than sharpAngle
    bool hard = false;      //!< hard edges of the file, see Scene::hardEdges
    bool materials = false; //!< edges between two materials
    double sharpAngle = 30; //!< degrees between the normals of the two polygons, in [0, 180]

    bool operator==(const GivenSeamOptions &) const = default;
};

//! Parameters of the energy (1 - lambda) D + lambda S (paper, Eq. 1) and of how it is minimised.
struct SolveSettings
{
    static constexpr double maxBound = 1e6;

    double lambda = 0;      //!< balance in [0, 1]; 0 minimises distortion alone
    double delta = 1;       //!< smoothing of the seamless L0 penalty (paper, Eq. 6), for a mesh of area pi
    double boxWeight = 100; //!< beta, the weight of the rectangles (paper, section 4, which uses 100)
    DistortionEnergy energy = DistortionEnergy::SymmetricDirichlet;
    SeamWeighting weighting = SeamWeighting::Length;
    StartMode start = StartMode::Rigid;
    SolverKind solver = SolverKind::Fast;
    unsigned seed = 1;
    //! Bound on the mean symmetric Dirichlet energy of a definite map, in (4, maxBound].
    double maxDistortion = 4.1;
    SurfaceKind surface = SurfaceKind::Auto;
    //! Rigid: the stretch that the bound allows goes to the curved parts of the surface only.
    FlatMode flat = FlatMode::Rigid;
    AlikeMode alike = AlikeMode::SameCuts;
    // Preferences for the places of seams. All ways of cutting use them.
    //! Prefer seams along sharp edges; Auto: on parts that are hard surfaces.
    CreaseMode creases = CreaseMode::Auto;
    //! Share of its cost that a seam saves on a sharp edge, in [0, 1]; the default was chosen by hand.
    double creaseStrength = 0.8;
    double visibility = 0; //!< how strongly hidden places are preferred for seams, in [0, 1]
    SymmetryMode symmetry = SymmetryMode::Auto;
    //! Islands run along the axes, and what is straight on the model is straight in the map. Auto: those of
    //! parts that are hard surfaces.
    CreaseMode align = CreaseMode::Off;
    bool mirrorMaps = false;          //!< symmetric islands get symmetric maps, mirrored ones mirrored maps
    WorldUp worldUp = WorldUp::AutoY; //!< islands are turned so that this direction of the model is up
    SeamMode seams = SeamMode::Free;  //!< the given seams are Steering::givenSeams
    GivenSeamOptions givenSeams = {}; //!< where they come from; no matter for SeamMode::Free

    bool operator==(const SolveSettings &) const = default;
};

//! Factor on the separation energy of pairs along diagonals, so that they stay together (paper, section 4).
inline constexpr double diagonalWeight = 100;
//! Factor on the separation energy of pairs that the user joined: the value of the diagonals, chosen by hand.
//! Pairs that the user cut have factor 0.
inline constexpr double joinedWeight = 100;

} // namespace autocuts
