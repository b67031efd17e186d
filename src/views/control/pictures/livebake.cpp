#include "views/control/pictures/livebake.h"

#include "jobs/bakepictures.h"
#include "model/plain/udimtiles.h"
#include "model/plain/uvlayout.h"
#include "solver/bake/surfacesamples.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include <QImage>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

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

constexpr std::size_t litLayerCount = 3;

//! Tangent space normals as a texture set of a plain grey material. \param greenDown the picture has them so
std::vector<QImage> litLayers(const QImage &normals, bool greenDown)
{
    constexpr int grey = 200, roughness = 128; // chosen by hand
    std::vector<QImage> layers(litLayerCount, QImage(normals.size(), QImage::Format_RGBA8888));
    layers[0].fill(qRgba(grey, grey, grey, 255));
    layers[2].fill(qRgba(0, 0, 0, 255)); // no emission, no occlusion
    for (int y = 0; y < normals.height(); ++y) {
        const auto *from = reinterpret_cast<const QRgb *>(normals.constScanLine(y));
        uchar *to = layers[1].scanLine(y);
        for (int x = 0; x < normals.width(); ++x, to += 4) {
            const int green = qGreen(from[x]);
            to[0] = static_cast<uchar>(qRed(from[x]));
            to[1] = static_cast<uchar>(greenDown ? std::min(255, 256 - green) : green);
            to[2] = roughness;
            to[3] = 0; // no metal
        }
    }
    return layers;
}

//! A texture has no more pictures on many graphics cards.
constexpr std::size_t mostTiles = 256;

//! The tiles that triangles lie in, with their numbers; those that have none are left out.
std::set<int> touchedTiles(const MeshData &mesh, const UvMatrix &soupUv, double tileHeight)
{
    // Sides of neighbouring tiles belong to the inner one.
    constexpr double within = 1e-6;
    std::set<int> tiles;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const auto rows = soupUv.middleRows<3>(3 * Eigen::Index(t));
        const Vec2 low = rows.colwise().minCoeff().transpose(), high = rows.colwise().maxCoeff().transpose();
        if (!rows.allFinite() || low.minCoeff() < -1e3 || high.maxCoeff() > 1e4)
            continue;
        const auto first = [](double from) {
            return std::max(0, static_cast<int>(std::floor(from + within)));
        };
        const auto last = [](double to) { return static_cast<int>(std::ceil(to - within)) - 1; };
        for (int row = first(low.y() / tileHeight); row <= last(high.y() / tileHeight); ++row) {
            for (int column = first(low.x()); column <= std::min(9, last(high.x())); ++column)
                tiles.insert(PackingSettings::firstTile + column + Pictures::tilesPerRow * row);
        }
        while (tiles.size() > mostTiles)
            tiles.erase(std::prev(tiles.end()));
    }
    return tiles;
}

//! Lays the samples into a map, tile by tile.
std::map<int, std::vector<QImage>> laidImages(const LiveBakeModel &model, const UvMatrix &soupUv,
                                              double tileHeight, const std::atomic<bool> &stop)
{
    ShadedSurface low = model.job->low;
    const std::set<int> tiles = touchedTiles(*low.mesh, soupUv, tileHeight);
    low.uv = cornerUvs(*low.mesh, soupUv);
    if (model.samples->kind() == bake::MapKind::Normal)
        low.tangents = mikkTangents(*low.mesh, low.uv, low.normals);
    const int side = LiveBake::sizeFor(tiles.size());
    bake::TexelGrid grid;
    grid.width = static_cast<int>(std::ceil(side / std::max(1.0, tileHeight)));
    grid.height = static_cast<int>(std::ceil(side * std::min(1.0, tileHeight)));
    const bool lit =
        model.samples->kind() == bake::MapKind::Normal && tiles.size() * litLayerCount <= mostTiles;
    std::map<int, std::vector<QImage>> images;
    for (const int tile : tiles) {
        grid.tile = udimTile(tile, tileHeight);
        const QImage image = imageOf(model.samples->lay(low, grid, JobContext(&stop)));
        images[tile] = lit ? litLayers(image, model.job->greenDown)
                           : std::vector<QImage>{image.convertToFormat(QImage::Format_RGBA8888)};
        if (stop)
            break;
    }
    return images;
}

} // namespace

int LiveBake::sizeFor(std::size_t tiles)
{
    int side = size;
    while (side > 64 && tiles * std::size_t(side) * std::size_t(side) > mostTexels)
        side /= 2;
    return side;
}

LiveBake::LiveBake(const Workspace &workspace, const ShownMap &shownMap, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mShownMap(shownMap)
{
    connect(&workspace, &Workspace::documentReplaced, this, &LiveBake::stop);
    connect(&shownMap, &ShownMap::changed, this, &LiveBake::followMap);
}

void LiveBake::start(const jobs::BakeChoice &choice, const QString &map)
{
    stop();
    const Document *document = mWorkspace.document();
    if (!document)
        return;
    mOn = true;
    mChoice = choice;
    mMap = map;
    mRefining = true;
    mTold = false;
    mUpdates = 0;
    DocumentState model = document->state();
    // The map comes later, again and again; only the model's own textures need that of the beginning.
    if (map != QLatin1StringView(bake::nameOf(bake::MapKind::Color)))
        model.scene.uvSets.clear();
    jobs::BakeChoice one = choice;
    one.maps = {map};
    struct Made
    {
        std::shared_ptr<const LiveBakeModel> model;
        QString problem;
    };
    mTracing.start(
        [model, one, packing = document->packingSettings()](const std::atomic<bool> &stop) {
            Result<jobs::PreparedBake> bake = jobs::prepareBake(model, packing, one, JobContext(&stop));
            if (!bake)
                return Made{nullptr, bake.error().toString()};
            LiveBakeModel live;
            live.job = std::make_shared<const bake::BakeJob>(std::move(bake->job));
            return Made{std::make_shared<const LiveBakeModel>(std::move(live)), {}};
        },
        [this](const Made &made) {
            if (made.model)
                takeOver(made.model, 0);
            else
                fail(made.problem);
        },
        [this](const QString &message) { fail(message); });
    Q_EMIT changed();
}

void LiveBake::choose(const QString &map)
{
    if (!mOn || isReceiving() || map == mMap)
        return;
    const std::shared_ptr<const LiveBakeModel> model = mModel;
    const auto found = std::ranges::find_if(
        bake::mapNames(), [&map](const auto &known) { return map == QLatin1StringView(known.first); });
    // Colours need textures, which are read only for them.
    if (!model || found == bake::mapNames().end() || found->second == bake::MapKind::Color) {
        start(jobs::BakeChoice(mChoice), map);
        return;
    }
    stop();
    auto other = std::make_shared<bake::BakeJob>(*model->job);
    other->settings.maps = {{found->second, 0}};
    auto next = std::make_shared<LiveBakeModel>();
    next->job = std::move(other);
    mOn = true;
    mMap = map;
    mUpdates = 0;
    takeOver(next, 0);
    Q_EMIT changed();
}

LiveBake::Receiver LiveBake::receive()
{
    stop();
    mOn = true;
    mMap.clear();
    mUpdates = 0;
    using Tile = std::pair<int, QImage>;
    const auto put = mReceived.open<Tile>([this](const std::map<int, QImage> &tiles) { showReceived(tiles); },
                                          [](std::optional<std::map<int, QImage>> &tiles, const Tile &tile) {
                                              if (!tiles)
                                                  tiles.emplace();
                                              (*tiles)[tile.first] = tile.second;
                                          });
    Q_EMIT changed();
    return [put](int tile, const QImage &picture) { put({tile, picture}); };
}

const Pictures &LiveBake::pictures() const
{
    static const Pictures none;
    return mPicturesMatchMap ? mPictures : none;
}

void LiveBake::followMap()
{
    layAgain();
    if (!isReceiving() || mPictures.images.empty())
        return;
    const Document *document = mWorkspace.document();
    const bool fits = document && !mShownMap.isLive() && sameBits(document->uv(), mReceivedFor);
    if (std::exchange(mPicturesMatchMap, fits) != fits)
        Q_EMIT changed();
}

void LiveBake::showReceived(const std::map<int, QImage> &received)
{
    if (!mWorkspace.document())
        return;
    TilePictures tiles;
    for (const auto &[tile, picture] : received)
        tiles[tile] = {picture};
    if (mPictures.images.empty())
        mReceivedFor = mWorkspace.document()->uv();
    // The others stay.
    for (const auto &[place, index] : mPictures.sets.empty() ? std::map<int, int>() : mPictures.sets[0].tiles)
        tiles.try_emplace(PackingSettings::firstTile + place, 1, mPictures.images[std::size_t(index)]);
    show(tiles);
}

void LiveBake::stop()
{
    if (!mOn)
        return;
    mOn = false;
    mTracing.drop();
    mLaying.drop();
    mReceived.close();
    mModel.reset();
    mPictures = {};
    mPicturesMatchMap = true;
    mRefining = mStale = false;
    Q_EMIT changed();
}

void LiveBake::refine(std::shared_ptr<const LiveBakeModel> model, int pass)
{
    mTracing.start(
        [model = std::move(model), pass](const std::atomic<bool> &stop) {
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
                passes[pass].points, JobContext(&stop));
            return std::shared_ptr<const LiveBakeModel>(std::move(next));
        },
        [this, pass](const std::shared_ptr<const LiveBakeModel> &next) { takeOver(next, pass + 1); },
        [this](const QString &message) { fail(message); });
}

void LiveBake::takeOver(const std::shared_ptr<const LiveBakeModel> &model, int pass)
{
    if (model->samples) {
        mModel = model;
        tellMissed(*model);
    }
    mRefining = pass < std::ssize(passes);
    if (mRefining)
        refine(model, pass);
    layAgain();
}

//! The picture has no values there.
void LiveBake::tellMissed(const LiveBakeModel &model)
{
    // Single points at borders are not worth a word.
    constexpr double fewestPercent = 0.1;
    const double percent =
        100 * double(model.samples->missed()) / double(std::max(1LL, model.samples->points()));
    if (std::exchange(mTold, true) || percent < fewestPercent)
        return;
    Q_EMIT noticed(tr("%1 % of the surface found nothing of the detailed model: a larger cage "
                      "reaches farther")
                       .arg(percent, 0, 'f', 1));
}

void LiveBake::layAgain()
{
    const Document *document = mWorkspace.document();
    if (!mModel || !document || mModel->job->low.mesh != document->state().scene.mesh)
        return;
    mStale = mLaying.isRunning();
    if (mStale)
        return;
    const double tileHeight = document->packingSettings().tileHeight();
    mLaying.start([model = mModel, uv = mShownMap.uv(), tileHeight](
                      const std::atomic<bool> &stop) { return laidImages(*model, uv, tileHeight, stop); },
                  [this](const TilePictures &tiles) { show(tiles); },
                  [this](const QString &message) { fail(message); });
}

void LiveBake::show(const TilePictures &tiles)
{
    ++mUpdates;
    mPictures = {};
    if (!tiles.empty())
        mPictures.sets = {{}};
    for (const auto &[tile, layers] : tiles) {
        mPictures.layers = static_cast<int>(layers.size());
        mPictures.sets.front().tiles[tile - PackingSettings::firstTile] =
            static_cast<int>(mPictures.images.size());
        mPictures.images.insert(mPictures.images.end(), layers.begin(), layers.end());
    }
    Q_EMIT changed();
    if (mStale)
        layAgain();
}

void LiveBake::fail(const QString &message)
{
    stop();
    Q_EMIT failed(message);
}

} // namespace autocuts
