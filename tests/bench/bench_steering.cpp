// How much worse a map gets when it is steered: unwraps each mesh freely, then with three rectangles, with
// twenty hard pins, and with ten strokes of cuts and ten of joins, and finishes the free map under the same
// steering. Usage: bench_steering MESH... [--quality draft|standard] [--save FOLDER]
// With --save it writes each steered session, with the free map, for other programs.
#include "edgewalk.h"

#include "commands/editpins.h"
#include "commands/editrectangles.h"
#include "commands/newmap.h"
#include "commands/setseamstate.h"
#include "model/document/makesnapshot.h"
#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"
#include "solver/base/random.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/packing/packmap.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/unwrap.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int rectangles = 3, pins = 20, strokes = 10, strokeLength = 5;
constexpr double regionShare = 0.12; // of the mesh's area, for one rectangle
constexpr double roomShare = 2;      // area of a rectangle over that of its region in the map
constexpr double pinShift = 0.01;    // of the texture

//! A map of the document's mesh, steered in one way.
class SteeredMap
{
public:
    explicit SteeredMap(const Scene &scene, const UvMatrix &uv) : mDocument(Scene(scene)), mMesh(*scene.mesh)
    {
        pushCommand(newMapCommand(mDocument, UvEdit::Solve, uv));
        mUv = mDocument.uv();
    }

    //! Regions of faces far from each other, each with a rectangle beside the texture tile.
    void addRectangles()
    {
        std::vector<std::vector<int>> neighbours(mMesh.faceCount());
        for (const EdgePair &pair : mMesh.edgePairs) {
            const int a = mMesh.triangleFace[pair.triangle[0]], b = mMesh.triangleFace[pair.triangle[1]];
            neighbours[a].push_back(b);
            neighbours[b].push_back(a);
        }
        std::vector<double> faceArea(mMesh.faceCount(), 0);
        for (int t = 0; t < mMesh.triangleCount(); ++t)
            faceArea[mMesh.triangleFace[t]] += mMesh.triangleArea[t];
        std::vector<bool> taken(mMesh.faceCount(), false);
        std::vector<int> rectangleOf(mMesh.faceCount(), -1);
        for (int r = 0; r < rectangles; ++r) {
            std::vector<int> region{farthestFace(taken)};
            mRegions.push_back(region[0]);
            std::vector<bool> reached = taken;
            reached[region[0]] = true;
            double area = 0;
            for (std::size_t i = 0; i < region.size() && area < regionShare * mMesh.area; ++i) {
                area += faceArea[region[i]];
                taken[region[i]] = true;
                for (const int next : neighbours[region[i]]) {
                    if (!reached[next])
                        region.push_back(next);
                    reached[next] = true;
                }
            }
            std::erase_if(region, [&](int face) { return !taken[face]; });
            for (const int face : region)
                rectangleOf[face] = r;
            std::sort(region.begin(), region.end());
            const double side =
                mDocument.uvScale() * std::sqrt(roomShare * area / mMesh.area * std::acos(-1.0));
            LayoutRectangle rectangle;
            rectangle.lower = Vec2(1.1 + 1.1 * r, 0);
            rectangle.upper = rectangle.lower + Vec2(side, side);
            rectangle.hard = true;
            rectangle.faces = QList<int>(region.begin(), region.end());
            pushCommand(EditRectangles::add(mDocument, rectangle));
        }
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e) {
            const auto [a, b] = mMesh.edgePairs[e].triangle;
            if (rectangleOf[mMesh.triangleFace[a]] != rectangleOf[mMesh.triangleFace[b]])
                mForced += lengthOf(static_cast<int>(e));
        }
    }

    //! Hard pins spread over the map, each a little beside its corner.
    void addPins()
    {
        Random random(1);
        std::vector<UvPin> all;
        int corner = 0;
        while (static_cast<int>(all.size()) < pins) {
            const Vec2 shift(random.uniform(-1, 1), random.uniform(-1, 1));
            all.push_back({corner, Vec2(mUv.row(corner)) + pinShift * shift, true, 1});
            double farthest = 0;
            for (int c = 0; c < mMesh.cornerCount(); ++c) {
                double nearest = std::numeric_limits<double>::infinity();
                for (const UvPin &pin : all)
                    nearest = std::min(nearest, (mUv.row(c) - mUv.row(pin.corner)).norm());
                if (nearest > farthest) {
                    farthest = nearest;
                    corner = c;
                }
            }
        }
        pushCommand(std::make_unique<EditPins>(mDocument, EditPins::Edit::Pin, all));
    }

    //! Strokes of cuts over faces that the map joins, and of joins over its seams.
    void addStrokes(const CutFlags &cut)
    {
        Random random(1);
        std::vector<int> cuts, joins;
        std::vector<bool> used(cut.size(), false);
        for (int i = 0; i < 2 * strokes; ++i) {
            const bool isCut = i < strokes;
            const auto isWanted = [&](int e) {
                return cut[e] != isCut && !mMesh.edgePairs[e].diagonal && !used[e];
            };
            int first = random.below(static_cast<int>(cut.size()));
            while (!isWanted(first))
                first = (first + 1) % static_cast<int>(cut.size());
            for (const int e : bench::walkEdges(mMesh, first, strokeLength, isWanted)) {
                used[e] = true;
                (isCut ? cuts : joins).push_back(e);
                mForced += isCut ? lengthOf(e) : 0;
            }
        }
        for (auto [edit, edges] :
             {std::pair(SetSeamState::Edit::Cut, &cuts), {SetSeamState::Edit::Join, &joins}}) {
            std::sort(edges->begin(), edges->end());
            pushCommand(std::make_unique<SetSeamState>(mDocument, edit, cornerPairsOfEdges(mMesh, *edges)));
        }
    }

    const Document &document() const { return mDocument; }
    //! Length of the seams that the steering forces, solver units.
    double forced() const { return mForced; }

private:
    //! The face whose centre is farthest from those that are taken; at first, from the first vertex.
    int farthestFace(const std::vector<bool> &taken) const
    {
        const auto centre = [&](int face) { return Vec3(mMesh.positions.row(vertexOf(face))); };
        int best = -1;
        double farthest = -1;
        for (int face = 0; face < mMesh.faceCount(); ++face) {
            double nearest = mRegions.empty() ? (centre(face) - centre(0)).norm()
                                              : std::numeric_limits<double>::infinity();
            for (const int region : mRegions)
                nearest = std::min(nearest, (centre(face) - centre(region)).norm());
            if (!taken[face] && nearest > farthest) {
                farthest = nearest;
                best = face;
            }
        }
        return best;
    }
    int vertexOf(int face) const { return mMesh.cornerVertex[mMesh.faceStart[face]]; }
    double lengthOf(int edge) const
    {
        return mMesh.edgePairs[edge].length / std::sqrt(mMesh.area / std::acos(-1.0));
    }

    Document mDocument;
    const MeshData &mMesh;
    UvMatrix mUv;
    std::vector<int> mRegions; //!< the first face of each
    double mForced = 0;
};

void print(const char *what, const SteeredMap *steered, const MeshData &mesh, const UvMatrix &uv,
           const unwrap::UnmetSteering &unmet, double freeLength, double seconds)
{
    const metrics::UvMetrics found = metrics::measureUv(mesh, uv);
    const double forced = steered ? steered->forced() : 0;
    std::printf("  %-24s D %.4f seams %.3f, forced %.3f, ratio %.3f, islands %d, flips %lld, overlaps %lld, "
                "unmet: %zu pins %zu joins %zu rectangles, %.1f s\n",
                what, found.symDirichlet, found.seamNorm, forced,
                freeLength > 0 ? found.seamNorm / (freeLength + forced) : 1, found.charts,
                static_cast<long long>(found.flipped), static_cast<long long>(found.overlapPairs),
                unmet.pins.size(), unmet.joins.size(), unmet.rectangles.size(), seconds);
    std::fflush(stdout);
}

void measure(const std::string &file, const unwrap::UnwrapOptions &options, const QString &folder)
{
    const Result<Scene> scene = readMesh(QString::fromStdString(file));
    if (!scene) {
        std::printf("%s\n", qPrintable(scene.error().toString()));
        return;
    }
    const QString name = QFileInfo(QString::fromStdString(file)).completeBaseName();
    const MeshData &mesh = *scene->mesh;
    Snapshot plain;
    plain.mesh = scene->mesh;
    std::printf("%s, %d triangles\n", qPrintable(name), mesh.triangleCount());
    const auto timed = [](auto &&job) {
        const std::clock_t begun = std::clock();
        auto result = job();
        return std::pair(std::move(result), static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
    };
    const auto [free, freeTime] = timed([&] { return unwrap::unwrapMesh(plain, options); });
    const double freeLength = metrics::measureUv(mesh, free.uv).seamNorm;
    print("free", nullptr, mesh, free.uv, free.unmet, 0, freeTime);
    for (const char *kind : {"rectangles", "pins", "strokes"}) {
        SteeredMap steered(scene.value(), free.uv);
        if (QLatin1String(kind) == "rectangles"_L1)
            steered.addRectangles();
        else if (QLatin1String(kind) == "pins"_L1)
            steered.addPins();
        else
            steered.addStrokes(free.cut);
        if (!folder.isEmpty()) {
            const QString path = u"%1/%2_%3.acproj"_s.arg(folder, name, QLatin1String(kind));
            if (const Result<SavedProject> saved = saveProject(steered.document().state(), {}, path); !saved)
                std::printf("%s\n", qPrintable(saved.error().toString()));
        }
        const Snapshot snapshot = makeSnapshot(steered.document());
        const auto [unwrapped, unwrapTime] = timed([&] { return unwrap::unwrapMesh(snapshot, options); });
        print((std::string(kind) + ", unwrap").c_str(), &steered, mesh, unwrapped.uv, unwrapped.unmet,
              freeLength, unwrapTime);
        unwrap::FinishInput input;
        input.snapshot = snapshot;
        input.packing = options.packing;
        const auto [finished, finishTime] = timed([&] { return unwrap::finishMap(input); });
        print((std::string(kind) + ", finish").c_str(), &steered, mesh, finished.uv, finished.unmet,
              freeLength, finishTime);
    }
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    unwrap::UnwrapOptions options;
    options.packing = packing::tileOptions({});
    QString folder;
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
        const QString argument = QString::fromLocal8Bit(argv[i]);
        if (argument == "--quality"_L1 && i + 1 < argc)
            options.quality = QLatin1String(argv[++i]) == "draft"_L1 ? unwrap::UnwrapQuality::Draft
                                                                     : unwrap::UnwrapQuality::Standard;
        else if (argument == "--save"_L1 && i + 1 < argc)
            folder = QString::fromLocal8Bit(argv[++i]);
        else
            files.emplace_back(argv[i]);
    }
    for (const std::string &file : files)
        measure(file, options, folder);
    return 0;
}
