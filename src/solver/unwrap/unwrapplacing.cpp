#include "solver/unwrap/unwrapplacing.h"

#include "model/plain/uvlayout.h"
#include "solver/definite/seamopening.h"
#include "solver/straight/upright.h"
#include "solver/unwrap/alikestacks.h"
#include "solver/unwrap/keptorientation.h"
#include "solver/unwrap/keptscale.h"

#include <algorithm>

namespace autocuts::unwrap {

namespace {

//! Share of the texel density that upright islands may cost by default. Measured in draft on 25 models: 18 of
//! them stand upright then, among them four of five people; the others would lose 7 to 16 %.
constexpr double priceOfUpright = 0.05;

//! Moves and scales the map into the first tile of the texture.
void fitFirstTile(UvMatrix &uv, double tileHeight)
{
    const Eigen::RowVector2d low = uv.colwise().minCoeff();
    const Eigen::RowVector2d high = uv.colwise().maxCoeff();
    const Eigen::RowVector2d size = high - low;
    const double side = std::max(size.x(), size.y() / tileHeight);
    uv.rowwise() -= low;
    if (side > 0)
        uv /= side;
}

} // namespace

void UnwrapPlacing::place(const Soup &soup, const SeamedMap &map, PackHurry hurry, const JobContext &job,
                          UnwrapResult &result) const
{
    if (mOptions.pack)
        pack(soup, map, MayTurn::AsSet, hurry, job, result);
    else
        result.uv = mPart.wholeUv(partUv(soup, map));
    if (!result.packed && !staysInPlace())
        fitFirstTile(result.uv, mOptions.packing.tileHeight());
    if (result.packed && hurry != PackHurry::Always && !job.stopped() && mayTurn())
        turnUpright(soup, map, job, result);
}

//! True when some islands are where they belong. Otherwise packing finds the scale.
bool UnwrapPlacing::staysInPlace() const
{
    return !mPart.isWhole() || mSnapshot.placesIslands();
}

bool UnwrapPlacing::keepsScale() const
{
    return mOptions.packing.keepScale && mSnapshot.uv;
}

//! True when nobody has said how the islands lie.
bool UnwrapPlacing::mayTurn() const
{
    const WorldUp up = mSnapshot.settings.worldUp;
    const auto isFlagged = [](const IslandFlags &flags) { return flags != IslandFlags(); };
    return (up == WorldUp::AutoY || up == WorldUp::AutoZ) && mPlan.isEmpty() &&
           mSnapshot.settings.alike != AlikeMode::Stack && mOptions.packing.rotation == PackRotation::Free &&
           !staysInPlace() && !keepsScale() && std::ranges::none_of(mSnapshot.steering->faceFlags, isFlagged);
}

UvMatrix UnwrapPlacing::partUv(const Soup &soup, const SeamedMap &map) const
{
    const Snapshot &own = mPart.snapshot();
    UvMatrix uv = (staysInPlace() ? own.uvScale : 1) * cornerUv(soup, map);
    definite::openCuts(own, uv);
    return uv;
}

void UnwrapPlacing::pack(const Soup &soup, const SeamedMap &map, MayTurn turning, PackHurry hurry,
                         const JobContext &job, UnwrapResult &result) const
{
    const MeshData &mesh = *mSnapshot.mesh, &own = *mPart.snapshot().mesh;
    const UvMatrix uv = partUv(soup, map);
    result.uv = mPart.wholeUv(uv);
    const ChartMap charts = mPart.wholeCharts(chartsOf(own, CutMesh(own, map.cut)));
    packing::PackOptions settings = mOptions.packing;
    if (mOptions.quality == UnwrapQuality::Draft)
        settings.effort = std::min(settings.effort, packing::hurriedEffort);
    PackJob pack = steeredPackJob(mSnapshot, settings);
    pack.keepScaleIfPossible = staysInPlace();
    pack.fillRectangles = onlyRectangles(pack);
    pack.hurry = hurry;
    pack.options.keepScale = false; // where there is no room, all islands become smaller
    if (turning == MayTurn::No)
        pack.options.rotation = PackRotation::None;
    if (keepsScale()) {
        keepScales(mSnapshot, charts, pack, mPart.unit() * layoutScale(own, uv), result.uv);
        pack.keepScaleIfPossible = true;
        pack.density = packing::DensityBasis::Given;
    }
    if (mSnapshot.uv && mPlan.isEmpty())
        keepOrientations(mesh, charts, pack, *mSnapshot.uv, result.uv);
    if (mSnapshot.settings.alike == AlikeMode::Stack) {
        stackAlike(mesh, charts, pack, result.uv);
        result.flags = pack.faceFlags;
    }
    const double size = layoutScale(mesh, result.uv);
    result.packed = packCharts(mesh, charts, pack, result.uv, job);
    result.madeSmaller = keepsScale() && isSmaller(mesh, result.uv, size);
}

void UnwrapPlacing::turnUpright(const Soup &soup, const SeamedMap &map, const JobContext &job,
                                UnwrapResult &result) const
{
    const WorldUp up = mSnapshot.settings.worldUp == WorldUp::AutoZ ? WorldUp::Z : WorldUp::Y;
    UnwrapResult upright = result;
    upright.upright = true;
    pack(soup, straight::turnedUpright(soup, map, up), MayTurn::No, PackHurry::WhenStopped, job.quiet(),
         upright);
    const MeshData &mesh = *mSnapshot.mesh;
    if (!job.stopped() && upright.packed &&
        layoutScale(mesh, upright.uv) >= (1 - priceOfUpright) * layoutScale(mesh, result.uv))
        result = std::move(upright);
}

} // namespace autocuts::unwrap
