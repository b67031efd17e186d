// Brings the UVs of one mesh to another, by equal polygons or by position. Plain: no Qt.
#pragma once

#include "model/transfer/placement.h"
#include "model/transfer/positiontransfer.h"

namespace autocuts::transfer {

//! How faces find their counterparts.
enum class UvMatch {
    Auto,     //!< as Topology where the polygons are the same, otherwise as Position
    Topology, //!< the same polygons in the same order, or at the same positions
    Position  //!< faces at the same positions, and for all others the nearest points
};

//! Surfaces that are on average farther apart than this share of the source's size hardly have the same
//! shape. Chosen by hand.
inline constexpr double farShare = 0.01;

//! How many faces got UVs, and how closely the models match.
struct TransferFigures
{
    int faces = 0;  //!< that were to get UVs
    int copied = 0; //!< that have those of an equal face
    int placed = 0; //!< that have theirs by position
    int unmatched() const { return faces - copied - placed; }
    //! Of the faces that were placed, in the units of the source.
    double meanDistance = 0, maxDistance = 0;
    //! The largest mean over all faces that had no equal, also those too far away, as a share of the source's
    //! size.
    double meanShare = 0;
    int turnedOver = 0, collapsed = 0;           //!< see PositionUvs
    double seamLength = 0, sourceSeamLength = 0; //!< in the units of the models
    bool moved = false;                          //!< the source was moved onto the mesh to match it

    void add(const TransferFigures &other);
};

//! The result of transferUvs().
struct UvTransfer
{
    enum class Status {
        Done,
        Stopped,
        NoUvs,         //!< no triangle of the source has UVs
        OtherPolygons, //!< they are not the same, but UvMatch::Topology asks for it
        Apart          //!< the surfaces are too far from each other; the figures say how far
    };
    Status status = Status::Done;
    UvMatrix uv; //!< one row per corner; rows of unmatched faces are not finite
    TransferFigures figures;
};

//! The source of the UVs, and the mesh that gets them.
struct UvTransferInput
{
    const MeshData &source;
    const UvMatrix &sourceUv; //!< one row per corner of the source
    const MeshData &mesh;
    UvMatch match = UvMatch::Auto;
    bool mayMove = false; //!< where the meshes are apart, try with their boxes around one centre
};

UvTransfer transferUvs(const UvTransferInput &input, const TransferControl &control);

//! The same, and where the source lies apart, tries it in other units or with another axis up.
//! \param placement becomes that of the source, if it needed another one
UvTransfer transferAnywhere(const UvTransferInput &input, const TransferControl &control,
                            Placement &placement);

//! The total length of the seams of a map between faces that have UVs.
double seamLength(const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts::transfer
