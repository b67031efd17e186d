// A random walk over jobs and hand tools on layouts of 1 to 12 UDIM tiles: no island leaves its tile, changes
// its scale, direction or place unless the job was asked to. $AUTOCUTS_WALKS asks for more walks.
#include "model/plain/udimtiles.h"
#include "model/plain/uvlayout.h"
#include "solver/base/random.h"
#include "solver/base/rigidfit.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/unwrap/aligning.h"
#include "solver/unwrap/packjob.h"
#include "support/pieces.h"
#include "support/steeredjobs.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tst_tilewalk {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int parts = 14;
constexpr double leastGap = 4;       //!< texels
constexpr double leastChange = 0.03; //!< of a scale, see densityGroups()
//! Share of their scale that islands keep where they have to be made smaller, in full tiles.
constexpr double leastSaid = 0.5;

//! How a part lies in the map.
struct Place
{
    int tile = 0;
    double scale = 0; //!< length in the map of a unit of the model
    double angle = 0; //!< radians
    Vec2 middle = Vec2::Zero();
};

//! A layout of L-shaped parts, each one island.
class Walk
{
public:
    explicit Walk(unsigned seed)
        : mRandom(seed), mDocument(test::partsDocument(std::vector<test::PartPlace>(parts)))
    {
        mSnapshot.mesh = mDocument->weightedMesh();
        mSnapshot.keepTiles = true;
        mSnapshot.settings.seed = seed;
        mSnapshot.editSteering().faceFlags.resize(mSnapshot.mesh->faceCount());
        mOptions.effort = 0.02;
        UvMatrix uv = mDocument->uv();
        unwrap::PackJob pack;
        pack.options = mOptions;
        const int tiles = 1 + mRandom.below(12);
        for (int part = 0; part < parts; ++part) {
            const int tile = part < tiles ? part : mRandom.below(tiles);
            const int number = PackingSettings::firstTile + tile % 4 + 10 * (tile / 4);
            pack.tiles.insert(pack.tiles.end(), test::partFaces, number);
        }
        mOk = unwrap::packCharts(*mSnapshot.mesh, charts(uv), pack, uv);
        setUv(uv);
    }

    bool isOk() const { return mOk; }

    //! A hand tool or a job. Returns what is wrong; empty: nothing.
    QString step()
    {
        const int what = mRandom.below(10);
        if (qEnvironmentVariableIsSet("AUTOCUTS_WALK_SHOW"))
            qInfo("%d", what);
        const int part = mRandom.below(parts);
        switch (what) {
        case 0: { // not far over the border
            const double way = 0.15 * (2 * mRandom.uniform() - 1);
            const std::vector<Place> before = places();
            transform(part, Eigen::Matrix2d::Identity(), mRandom.below(2) ? Vec2(way, 0) : Vec2(0, way));
            return places()[part].tile == before[part].tile || isMostlyOutside(part, before[part].tile)
                       ? QString()
                       : u"a move over the border changed the tile"_s;
        }
        case 1:
            transform(part, (0.6 + 0.3 * mRandom.uniform()) * Eigen::Matrix2d::Identity(), Vec2::Zero());
            return {};
        case 2:
            transform(part, Eigen::Rotation2Dd(2 * std::numbers::pi * mRandom.uniform()).toRotationMatrix(),
                      Vec2::Zero());
            setAligned(part, false);
            return {};
        case 3:
            for (int face = part * test::partFaces; face < (part + 1) * test::partFaces; ++face)
                mSnapshot.editSteering().faceFlags[face].locked ^= 1;
            return {};
        case 4:
            return align(part);
        case 5:
            return packOne(part);
        default:
            return run(test::steeredJobs()[std::size_t(what - 5) % test::steeredJobs().size()]);
        }
    }

private:
    static ChartMap charts(const UvMatrix &uv)
    {
        ChartMap charts;
        for (Eigen::Index face = 0; face < uv.rows() / test::partCorners * test::partFaces; ++face)
            charts.faceChart.push_back(int(face) / test::partFaces);
        charts.count = parts;
        return charts;
    }
    auto rowsOf(const UvMatrix &uv, int part) const
    {
        return uv.middleRows(part * test::partCorners, test::partCorners);
    }
    const UvMatrix &uv() const { return *mSnapshot.uv; }
    void setUv(const UvMatrix &uv)
    {
        mSnapshot.uv = std::make_shared<const UvMatrix>(uv);
        mSnapshot.uvScale = layoutScale(*mSnapshot.mesh, uv);
    }
    bool isLocked(int part) const
    {
        return mSnapshot.steering->faceFlags[part * test::partFaces].locked != 0;
    }
    void setAligned(int part, bool aligned)
    {
        for (int face = part * test::partFaces; face < (part + 1) * test::partFaces; ++face)
            mSnapshot.editSteering().faceFlags[face].aligned = aligned;
    }
    bool isMostlyOutside(int part, int tile) const
    {
        const Eigen::AlignedBox2d box = udimTile(tile, 1);
        int outside = 0;
        for (int c = 0; c < test::partCorners; ++c)
            outside += !box.contains(Vec2(uv().row(part * test::partCorners + c)));
        return 3 * outside >= test::partCorners;
    }
    void transform(int part, const Eigen::Matrix2d &linear, const Vec2 &move)
    {
        if (isLocked(part))
            return;
        UvMatrix changed = uv();
        const Vec2 middle = rowsOf(changed, part).colwise().mean().transpose();
        for (int c = part * test::partCorners; c < (part + 1) * test::partCorners; ++c)
            changed.row(c) = middle + move + linear * (Vec2(changed.row(c)) - middle);
        setUv(changed);
    }

    std::vector<Place> places() const { return placesIn(uv()); }
    std::vector<Place> placesIn(const UvMatrix &uv) const
    {
        const std::vector<int> tiles = islandTiles(*mSnapshot.mesh, findCharts(*mSnapshot.mesh, uv), uv, 1);
        std::vector<Place> result;
        for (int part = 0; part < parts; ++part) {
            const Vec2 along = Vec2(uv.row(part * test::partCorners + 1) - uv.row(part * test::partCorners));
            const double length = (mSnapshot.mesh->cornerPosition(part * test::partCorners + 1) -
                                   mSnapshot.mesh->cornerPosition(part * test::partCorners))
                                      .norm();
            result.push_back({tiles[part * test::partFaces], along.norm() / length,
                              std::atan2(along.y(), along.x()),
                              rowsOf(uv, part).colwise().mean().transpose()});
        }
        return result;
    }

    bool overlaps(const UvMatrix &uv) const
    {
        metrics::UvMetricsOptions options;
        options.gutter = false;
        return metrics::measureUv(*mSnapshot.mesh, uv, options).overlapPairs > 0;
    }

    //! What a job has done that it should not do to any island. \param leastScale of what an island had;
    //! 0: the job may change sizes as it likes
    QString changed(const UvMatrix &after, double leastScale, bool turns) const
    {
        const std::vector<Place> before = places(), now = placesIn(after);
        for (int part = 0; part < parts; ++part) {
            const QString which = u"island %1 of %2"_s.arg(part + 1).arg(before[part].tile);
            if (now[part].tile != before[part].tile)
                return which + u" went to tile %1"_s.arg(now[part].tile);
            if (isLocked(part) && rowsOf(after, part) != rowsOf(uv(), part))
                return which + u" is locked and moved"_s;
            const double scale = now[part].scale / before[part].scale;
            if (leastScale > 0 && (scale < leastScale || scale > 1 + leastChange))
                return which + u" changed its scale by %1"_s.arg(scale);
            if (!turns &&
                std::abs(std::remainder(now[part].angle - before[part].angle, 2 * std::numbers::pi)) > 1e-3)
                return which + u" was turned by %1"_s.arg(now[part].angle - before[part].angle);
            const bool aligned = mSnapshot.steering->faceFlags[part * test::partFaces].aligned != 0;
            const double quarter = std::numbers::pi / 2;
            if (aligned && std::abs(std::remainder(now[part].angle - before[part].angle, quarter)) > 1e-3)
                return which + u" is aligned and was turned"_s;
        }
        return {};
    }

    QString run(const test::SteeredJob &job)
    {
        const QString name = QString::fromLatin1(job.name);
        // Islands that touch others may have to move and, where there is no other room, to turn. So may those
        // that get the same scale as others of their tile, because it was nearly the same.
        const bool crowded =
            metrics::measureUv(*mSnapshot.mesh, uv()).minGutterTexels < leastGap || hasNearlyTheSameScales();
        const test::Outcome made = job.run(mSnapshot);
        if (made.saysItFailed || made.uv.rows() == 0)
            return {};
        const bool keeps = name == u"live"_s || name == u"finish"_s;
        // A live solve makes the islands of a tile smaller where there is no room for them, as when one comes
        // back in that reached over the border, until there is.
        const bool mayShrink = made.saysSmaller || (name == u"live"_s && (crowded || sticksOut(uv())));
        const double leastScale = !keeps ? 0 : mayShrink ? leastSaid : 1 - leastChange;
        QString wrong = changed(made.uv, leastScale, !(name == u"live"_s && !crowded && !sticksOut(uv())));
        if (wrong.isEmpty() && name == u"pack"_s && sticksOut(made.uv))
            wrong = u"an island reaches over the border"_s;
        setUv(made.uv);
        return wrong.isEmpty() ? QString() : name + u": "_s + wrong;
    }

    //! Two islands of a tile differ so little that they count as of one scale, see densityGroups().
    bool hasNearlyTheSameScales() const
    {
        const std::vector<Place> all = places();
        return std::ranges::any_of(all, [&](const Place &a) {
            return std::ranges::any_of(all, [&](const Place &b) {
                const double differ = std::abs(a.scale / b.scale - 1);
                return a.tile == b.tile && differ > 1e-4 && differ < 2 * leastChange;
            });
        });
    }

    //! An island that may move does.
    bool sticksOut(const UvMatrix &uv) const
    {
        const ChartMap charts = findCharts(*mSnapshot.mesh, uv);
        const TileLayout layout = findTiles(*mSnapshot.mesh, charts, uv, 1);
        for (int part = 0; part < parts; ++part) {
            if (!isLocked(part) && layout.sticksOut[charts.faceChart[part * test::partFaces]])
                return true;
        }
        return false;
    }

    QString packOne(int part)
    {
        if (isLocked(part))
            return {};
        unwrap::PackJob pack = unwrap::steeredPackJob(mSnapshot, mOptions);
        pack.movable.assign(mSnapshot.mesh->faceCount(), false);
        std::fill_n(pack.movable.begin() + part * test::partFaces, test::partFaces, true);
        UvMatrix after = uv();
        if (!unwrap::packCharts(*mSnapshot.mesh, findCharts(*mSnapshot.mesh, after), pack, after))
            return {};
        QString wrong = changed(after, 0, true);
        for (int other = 0; other < parts && wrong.isEmpty(); ++other) {
            if (other != part && rowsOf(after, other) != rowsOf(uv(), other))
                wrong = u"island %1 moved"_s.arg(other + 1);
        }
        setUv(after);
        return wrong.isEmpty() ? QString() : u"pack of one: "_s + wrong;
    }

    //! The islands of a part's tile.
    QString align(int part)
    {
        const std::vector<Place> before = places();
        unwrap::AlignInput input;
        input.snapshot = mSnapshot;
        input.packing = mOptions;
        JobScope scope{std::vector<bool>(mSnapshot.mesh->faceCount(), false)};
        for (int other = 0; other < parts; ++other) {
            if (before[other].tile == before[part].tile && !isLocked(other))
                std::fill_n(scope.faces.begin() + other * test::partFaces, test::partFaces, true);
        }
        input.snapshot.scope = std::make_shared<const JobScope>(scope);
        const unwrap::AlignResult made = unwrap::alignIslands(input);
        if (made.uv.rows() == 0)
            return {};
        QString wrong;
        for (int other = 0; other < parts; ++other) {
            if (scope.faces[other * test::partFaces])
                setAligned(other, false);
        }
        wrong = changed(made.uv, made.madeSmaller ? leastSaid : 1 - leastChange, true);
        for (int other = 0; other < parts && wrong.isEmpty(); ++other) {
            if (before[other].tile != before[part].tile && rowsOf(made.uv, other) != rowsOf(uv(), other))
                wrong = u"island %1 of another tile moved"_s.arg(other + 1);
        }
        if (wrong.isEmpty() && !made.noRoom && overlaps(made.uv) && !overlaps(uv()))
            wrong = u"islands overlap"_s;
        setUv(made.uv);
        for (int other = 0; other < parts; ++other) {
            if (scope.faces[other * test::partFaces])
                setAligned(other, true);
        }
        return wrong.isEmpty() ? QString() : u"align: "_s + wrong;
    }

    Random mRandom;
    std::unique_ptr<Document> mDocument;
    Snapshot mSnapshot;
    packing::PackOptions mOptions;
    bool mOk = false;
};

} // namespace

class TestTileWalk : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void walk_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("count");
        const int asked = qEnvironmentVariableIntValue("AUTOCUTS_WALKS");
        const int first = qEnvironmentVariableIntValue("AUTOCUTS_WALK_SEED");
        QTest::newRow("walks") << first << (asked > 0 ? asked : 6);
        // Islands of two scales counted as stretched, and one was cut for that.
        QTest::newRow("an island of another scale") << 4000188 << 1;
        // An island over the border was aligned, and lay on others.
        QTest::newRow("an island over the border") << 7100216 << 1;
    }

    void walk()
    {
        QFETCH(const int, first);
        QFETCH(const int, count);
        constexpr int steps = 12;
        for (int seed = first; seed < first + count; ++seed) {
            Walk walk(static_cast<unsigned>(seed));
            QVERIFY(walk.isOk());
            for (int step = 0; step < steps; ++step) {
                const QString wrong = walk.step();
                QVERIFY2(wrong.isEmpty(),
                         qPrintable(u"seed %1, step %2: %3"_s.arg(seed).arg(step).arg(wrong)));
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestTileWalk)

} // namespace tst_tilewalk

#include "tst_tilewalk.moc"
