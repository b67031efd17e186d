// Measures the definite map of a live solve: how soon there is a valid map, how soon it is as good as that of
// an unwrap, and how soon it obeys an edit. Checks every map that is given out. Usage: bench_live MESH...
// [--threads N] [--seconds N] [--no-unwrap] [--no-edits] [--json] [--maps FOLDER: the last map before the
// edits, as OBJ]
#include "edgewalk.h"

#include "model/io/meshes/meshfile.h"
#include "model/plain/uvlayout.h"
#include "solver/live/mapkeeper.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/packing/packmap.h"
#include "solver/unwrap/unwrap.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

using Clock = std::chrono::steady_clock;
using MapPtr = std::shared_ptr<const unwrap::LiveMapResult>;

constexpr double goodEnough = 1.05; // times the seam length of the unwrap
constexpr int editedEdges = 10;

double since(Clock::time_point begun)
{
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

//! Runs a keeper and looks at all its maps.
class Live
{
public:
    Live(std::shared_ptr<const MeshData> mesh, int threads) : mMesh(std::move(mesh)), mKeeper(threads)
    {
        mKeeper.moveToThread(&mThread);
        mThread.start();
        mOptions.packing = packing::tileOptions({});
    }
    ~Live()
    {
        mKeeper.pause();
        mThread.quit();
        mThread.wait();
    }

    void start(const Snapshot &snapshot)
    {
        mSnapshot = snapshot;
        mKeeper.start(std::make_shared<const Snapshot>(snapshot), mOptions);
        mKeeper.run();
    }

    //! \returns seconds until a map obeys the edit, negative when none does in time
    double edit(const std::function<void(Steering &)> &change,
                const std::function<bool(const MapPtr &)> &obeys)
    {
        change(mSnapshot.editSteering());
        ++mSnapshot.token.steering;
        const Clock::time_point begun = Clock::now();
        mKeeper.update(std::make_shared<const Snapshot>(mSnapshot), mOptions);
        return waitFor(begun, 20, [&](const MapPtr &map) {
            return map->token.steering == mSnapshot.token.steering && obeys(map);
        });
    }

    double waitFor(Clock::time_point begun, double seconds, const std::function<bool(const MapPtr &)> &what)
    {
        while (since(begun) < seconds) {
            if (const MapPtr map = mKeeper.takeMap()) {
                const double now = since(begun);
                mMap = map;
                mUnchecked.push_back(map);
                if (what(map))
                    return now;
            } else if (mKeeper.takeRest()) {
                return -1;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return -1;
    }

    const MapPtr &map() const { return mMap; }
    const Snapshot &snapshot() const { return mSnapshot; }

    //! Checks all maps that were taken. At the end, because it would take time from what is measured.
    //! \returns how many are not valid
    int countInvalid()
    {
        mKeeper.pause();
        metrics::UvMetricsOptions options;
        options.gutter = false;
        int invalid = 0;
        for (const MapPtr &map : mUnchecked) {
            const metrics::UvMetrics found = metrics::measureUv(*mMesh, map->uv, options);
            if (found.flipped == 0 && found.overlapPairs == 0)
                continue;
            std::fprintf(stderr, "invalid map: %lld flips, %lld overlaps\n",
                         static_cast<long long>(found.flipped), static_cast<long long>(found.overlapPairs));
            ++invalid;
        }
        return invalid;
    }
    qsizetype maps() const { return std::ssize(mUnchecked); }

private:
    std::shared_ptr<const MeshData> mMesh;
    QThread mThread;
    live::MapKeeper mKeeper;
    unwrap::LiveMapOptions mOptions;
    Snapshot mSnapshot;
    MapPtr mMap;
    std::vector<MapPtr> mUnchecked;
};

//! Writes a mesh with a map into a folder, as OBJ.
void write(Scene scene, const UvMatrix &uv, const QString &folder, const std::string &file)
{
    scene.uvSets = {UvSet{u"UVMap"_s, uv}};
    const auto name = QString::fromStdString(std::filesystem::path(file).stem().string());
    if (const Result<Done> written = writeMesh(scene, folder + u'/' + name + u".obj"_s); !written)
        std::fprintf(stderr, "%s\n", qPrintable(written.error().message));
}

QJsonObject measured(const std::string &file, int threads, double seconds, bool withUnwrap, bool withEdits,
                     const QString &maps)
{
    Result<Scene> scene = readMesh(QString::fromStdString(file));
    QJsonObject report;
    report["mesh"_L1] = QString::fromStdString(std::filesystem::path(file).filename().string());
    if (!scene) {
        report["error"_L1] = scene.error().message;
        return report;
    }
    const std::shared_ptr<const MeshData> mesh = scene.value().mesh;
    report["triangles"_L1] = mesh->triangleCount();
    Snapshot snapshot;
    snapshot.mesh = mesh;
    snapshot.settings = {};
    snapshot.token = {1, 1, 1, 1};

    double unwrapTime = 0, goodLength = 0;
    if (withUnwrap) {
        unwrap::UnwrapOptions options;
        options.packing = packing::tileOptions({});
        const Clock::time_point begun = Clock::now();
        const unwrap::UnwrapResult reference = unwrap::unwrapMesh(snapshot, options, {nullptr, threads});
        unwrapTime = since(begun);
        goodLength = goodEnough * reference.seamLength;
        report["unwrap"_L1] = QJsonObject{{"seconds"_L1, unwrapTime},
                                          {"seamLength"_L1, reference.seamLength},
                                          {"distortion"_L1, reference.distortion}};
    }

    Live live(mesh, threads);
    const Clock::time_point begun = Clock::now();
    live.start(snapshot);
    double first = -1, within = -1, good = -1;
    QJsonArray course;
    live.waitFor(begun, std::max(seconds, 1.5 * unwrapTime), [&](const MapPtr &map) {
        const double now = since(begun);
        if (first < 0)
            first = now;
        if (within < 0 && map->withinBound)
            within = now;
        if (good < 0 && map->withinBound && map->seamLength <= goodLength)
            good = now;
        course.append(QJsonArray{now, map->distortion, map->seamLength, map->islands});
        return false;
    });
    report["first"_L1] = first;
    report["withinBound"_L1] = within;
    report["asGoodAsUnwrap"_L1] = good;
    report["course"_L1] = course;
    if (live.map() && !maps.isEmpty())
        write(scene.value(), live.map()->uv, maps, file);
    if (live.map()) {
        report["seamLength"_L1] = live.map()->seamLength;
        report["distortion"_L1] = live.map()->distortion;
    }
    if (live.map() && withEdits) {
        QJsonObject edits;
        const auto all = [&](const std::vector<int> &edges, bool cut) {
            return [edges, cut](const MapPtr &map) {
                return std::all_of(edges.begin(), edges.end(), [&](int e) { return map->cut[e] == cut; });
            };
        };
        const auto setStates = [&](const std::vector<int> &edges, PairState state) {
            return [&, edges, state](Steering &steering) {
                steering.pairState.resize(mesh->cornerPairCount(), PairState::Free);
                for (const int e : edges)
                    steering.pairState[2 * e] = steering.pairState[2 * e + 1] = state;
            };
        };
        const CutFlags cut = live.map()->cut;
        const auto isFree = [&](int e) { return !cut[e] && !mesh->edgePairs[e].diagonal; };
        int middle = static_cast<int>(cut.size() / 3);
        while (!isFree(middle))
            ++middle;
        const std::vector<int> path = bench::walkEdges(*mesh, middle, editedEdges, isFree);
        edits["cut"_L1] = live.edit(setStates(path, PairState::Cut), all(path, true));
        const CutFlags now = live.map()->cut;
        const std::vector<PairState> states = live.snapshot().steering->pairState;
        const auto isSeam = [&](int e) { return now[e] && states[2 * e] == PairState::Free; };
        int seam = static_cast<int>(cut.size() / 2);
        while (!isSeam(seam))
            seam = (seam + 1) % static_cast<int>(cut.size());
        const std::vector<int> joined = bench::walkEdges(*mesh, seam, editedEdges, isSeam);
        edits["join"_L1] = live.edit(setStates(joined, PairState::Joined), all(joined, false));
        edits["stroke"_L1] = live.edit(
            [&](Steering &steering) {
                steering.pairWeight.resize(mesh->cornerPairCount(), 1);
                for (std::size_t p = 0; p < steering.pairWeight.size() / 20; ++p)
                    steering.pairWeight[p] = 10;
            },
            [](const MapPtr &) { return true; });
        std::vector<int> corners;
        const int faceOfPart = mesh->triangleFace[0];
        const ChartMap charts = findCharts(*mesh, live.map()->uv);
        for (int c = 0; c < mesh->soupCornerCount(); ++c) {
            if (charts.faceChart[mesh->triangleFace[c / 3]] == charts.faceChart[faceOfPart])
                corners.push_back(c);
        }
        const double side = std::sqrt(std::acos(-1.0));
        edits["rectangle"_L1] = live.edit(
            [&](Steering &steering) {
                steering.rectangles.push_back({Vec2(2 * side, 0), Vec2(3.6 * side, 1.6 * side), corners});
            },
            [](const MapPtr &) { return true; });
        edits["movedRectangle"_L1] = live.edit(
            [&](Steering &steering) {
                steering.rectangles.back().lower.y() += side;
                steering.rectangles.back().upper.y() += side;
            },
            [](const MapPtr &) { return true; });
        report["edits"_L1] = edits;
    }
    report["maps"_L1] = live.maps();
    report["invalid"_L1] = live.countInvalid();
    return report;
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    int threads = 2;
    double seconds = 10;
    bool json = false, withUnwrap = true, withEdits = true;
    QString maps;
    QJsonArray reports;
    for (int i = 1; i < argc; ++i) {
        const QString argument = QString::fromLocal8Bit(argv[i]);
        if (argument == "--threads"_L1 && i + 1 < argc)
            threads = std::atoi(argv[++i]);
        else if (argument == "--seconds"_L1 && i + 1 < argc)
            seconds = std::atof(argv[++i]);
        else if (argument == "--maps"_L1 && i + 1 < argc)
            maps = QString::fromLocal8Bit(argv[++i]);
        else if (argument == "--json"_L1)
            json = true;
        else if (argument == "--no-unwrap"_L1)
            withUnwrap = false;
        else if (argument == "--no-edits"_L1)
            withEdits = false;
    }
    for (int i = 1; i < argc; ++i) {
        const QByteArray argument = argv[i];
        if (argument == "--threads" || argument == "--seconds" || argument == "--maps")
            ++i;
        else if (argument != "--json" && argument != "--no-unwrap" && argument != "--no-edits") {
            const QJsonObject report = measured(argv[i], threads, seconds, withUnwrap, withEdits, maps);
            reports.append(report);
            if (!json) {
                QJsonObject brief = report;
                brief.remove("course"_L1);
                std::printf("%s\n", QJsonDocument(brief).toJson(QJsonDocument::Compact).constData());
                std::fflush(stdout);
            }
        }
    }
    if (json)
        std::printf("%s", QJsonDocument(reports).toJson().constData());
    return 0;
}
