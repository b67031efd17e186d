#include "views/control/livebake.h"

#include "model/plain/udimtiles.h"
#include "solver/bake/surfacesamples.h"
#include "views/control/bakejobs.h"
#include "views/control/shownmap.h"
#include "views/control/workspace.h"

#include <QCoreApplication>
#include <QImage>
#include <QPointer>

#include <array>
#include <cmath>

namespace autocuts {

//! What is traced, and the newest samples. Immutable once it is shared.
struct LiveBakeModel
{
    std::shared_ptr<const bake::BakeJob> job;
    std::shared_ptr<const bake::SurfaceSamples> samples; //!< null before the first pass
};

namespace {

//! Points on the surface in each pass, and rays from each: first something to see, at last about a point for
//! each texel.
struct Pass
{
    int points, rays;
};
constexpr std::array<Pass, 3> passes{{{20'000, 8}, {120'000, 16}, {600'000, 32}}};

UvMatrix cornerUvs(const MeshData &mesh, const UvMatrix &soupUv)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int soup = mesh.soupCornerCount() - 1; soup >= 0; --soup)
        uv.row(mesh.cornerOfSoup(soup)) = soupUv.row(soup);
    return uv;
}

QImage imageOf(const Picture &picture)
{
    QImage image(picture.width, picture.height, QImage::Format_RGB32);
    for (int y = 0; y < picture.height; ++y) {
        auto *line = reinterpret_cast<QRgb *>(image.scanLine(y));
        for (int x = 0; x < picture.width; ++x) {
            const std::span<const float> texel = picture.at(x, y);
            const auto part = [&](std::size_t k) {
                return static_cast<int>(255 * texel[std::min(k, texel.size() - 1)] + 0.5F);
            };
            line[x] = qRgb(part(0), part(1), part(2));
        }
    }
    return image;
}

//! Lays the samples into a map.
QImage laidImage(const LiveBakeModel &model, const UvMatrix &soupUv, const Eigen::AlignedBox2d &tile,
                 const std::atomic<bool> &stop)
{
    ShadedSurface low = model.job->low;
    low.uv = cornerUvs(*low.mesh, soupUv);
    if (model.samples->kind() == bake::MapKind::Normal)
        low.tangents = mikkTangents(*low.mesh, low.uv, low.normals);
    bake::TexelGrid grid;
    const Vec2 sizes = tile.sizes();
    grid.width = sizes.x() >= sizes.y() ? LiveBake::size
                                        : static_cast<int>(std::ceil(LiveBake::size * sizes.x() / sizes.y()));
    grid.height = sizes.y() >= sizes.x()
                      ? LiveBake::size
                      : static_cast<int>(std::ceil(LiveBake::size * sizes.y() / sizes.x()));
    grid.tile = tile;
    return imageOf(model.samples->lay(low, grid, JobContext(&stop)));
}

} // namespace

LiveBake::LiveBake(const Workspace &workspace, const ShownMap &shownMap, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mShownMap(shownMap)
{
    mThreads.setMaxThreadCount(2);
    connect(&workspace, &Workspace::documentReplaced, this, &LiveBake::stop);
    connect(&shownMap, &ShownMap::changed, this, &LiveBake::layAgain);
}

LiveBake::~LiveBake()
{
    if (mStop)
        *mStop = true;
    mThreads.waitForDone();
}

void LiveBake::start(const BakeChoice &choice, const QString &map)
{
    stop();
    const Document *document = mWorkspace.document();
    if (!document)
        return;
    mStop = std::make_shared<std::atomic<bool>>(false);
    mMap = map;
    mRefining = true;
    mUpdates = 0;
    Scene scene = document->state().scene;
    scene.uvSets.clear(); // the map comes later, again and again
    BakeChoice one = choice;
    one.maps = {map};
    mThreads.start([this, scene, one, flag = mStop, packing = document->packingSettings()] {
        QStringList warnings;
        Result<bake::BakeJob> job = makeBakeJob(scene, packing, one, *flag, warnings);
        if (*flag)
            return;
        if (!job) {
            const QString message = job.error().toString();
            QMetaObject::invokeMethod(this, [this, flag, message] { fail(flag, message); });
            return;
        }
        LiveBakeModel model;
        model.job = std::make_shared<const bake::BakeJob>(std::move(job).value());
        auto shared = std::make_shared<const LiveBakeModel>(std::move(model));
        QMetaObject::invokeMethod(this, [this, flag, shared] { takeOver(flag, shared, 0); });
    });
    Q_EMIT changed();
}

void LiveBake::stop()
{
    if (!mStop)
        return;
    *mStop = true;
    mStop.reset();
    mModel.reset();
    mPictures = {};
    mRefining = mLaying = mStale = false;
    Q_EMIT changed();
}

void LiveBake::refine(std::shared_ptr<const LiveBakeModel> model, int pass)
{
    mThreads.start([this, model = std::move(model), pass, flag = mStop] {
        const bake::BakeJob &job = *model->job;
        const bake::Frame frame = bake::Frame::of(*job.low.mesh);
        const bake::Projection projection =
            job.kind == bake::SourceKind::Detailed
                ? bake::Projection(job.low, *job.high, frame, job.settings.cage)
                : bake::Projection(job.low, job.low, frame);
        bake::RaySettings rays = job.settings.rays;
        rays.rays = passes[pass].rays;
        auto next = std::make_shared<LiveBakeModel>(*model);
        next->samples = std::make_shared<const bake::SurfaceSamples>(
            job.low, projection, frame, job.settings.maps.front(), rays, bake::encodingOf(job, frame),
            passes[pass].points, JobContext(flag.get()));
        if (!*flag)
            QMetaObject::invokeMethod(this, [this, flag, next, pass] { takeOver(flag, next, pass + 1); });
    });
}

void LiveBake::takeOver(const StopFlag &flag, const std::shared_ptr<const LiveBakeModel> &model, int pass)
{
    if (flag != mStop)
        return;
    if (model->samples)
        mModel = model;
    mRefining = pass < std::ssize(passes);
    if (mRefining)
        refine(model, pass);
    layAgain();
}

void LiveBake::layAgain()
{
    const Document *document = mWorkspace.document();
    if (!mModel || !document || mModel->job->low.mesh != document->state().scene.mesh)
        return;
    mStale = mLaying;
    if (mLaying)
        return;
    mLaying = true;
    const PackingSettings packing = document->packingSettings();
    mThreads.start([this, model = mModel, flag = mStop, uv = mShownMap.uv(), packing] {
        const QImage picture = laidImage(*model, uv, udimTile(packing.udimTile, packing.tileHeight()), *flag);
        if (!*flag)
            QMetaObject::invokeMethod(
                this, [this, flag, picture, packing] { show(flag, picture, packing.udimTile); });
    });
}

void LiveBake::show(const StopFlag &flag, const QImage &picture, int tile)
{
    if (flag != mStop)
        return;
    ++mUpdates;
    mPictures.images = {picture};
    mPictures.sets = {{}};
    mPictures.sets.front().tiles[tile - PackingSettings::firstTile] = 0;
    mLaying = false;
    Q_EMIT changed();
    if (mStale)
        layAgain();
}

void LiveBake::fail(const StopFlag &flag, const QString &message)
{
    if (flag != mStop)
        return;
    stop();
    Q_EMIT failed(message);
}

} // namespace autocuts
