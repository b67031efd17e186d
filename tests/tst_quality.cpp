// Keeps the quality of the maps: figures of the sample models, pinned.
#include "model/plain/chart.h"
#include "model/samples/samples.h"
#include "solver/homotopy/liveschedule.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/preference/seampreference.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/separatejob.h"
#include "solver/unwrap/unwrap.h"

#include <Eigen/Geometry>

#include <QTest>
#include <QThread>

#include <cmath>
#include <map>

namespace tst_quality {

using namespace autocuts;
using namespace autocuts::homotopy;
using namespace autocuts::metrics;
using namespace autocuts::preference;
using namespace autocuts::unwrap;

namespace {

enum class Job { Draft, Standard, Finish, Separate, Pack };

//! Figures of a map as they were measured when they were pinned. A change that makes a map better does not
//! fail: its message says by how much, and the figures pinned here should be tightened then.
struct Figures
{
    double seamNorm = 0;
    double distortion = 0; //!< mean symmetric Dirichlet energy; what it has above 4 is pinned
    double packing = 0;    //!< part of the unit square that is covered
    int charts = 0;
};

constexpr double tolerance = 0.03;
constexpr double maxDistortion = 4.1;

JobContext onAllCores()
{
    return {nullptr, QThread::idealThreadCount()};
}

//! Packs the charts of a map. \returns no rows when there is no room
UvMatrix packed(const MeshData &mesh, const ChartMap &charts, UvMatrix uv)
{
    return packCharts(mesh, charts, {}, uv, onAllCores()) ? uv : UvMatrix(0, 2);
}

//! What a live solve for the bound and then Finish make of a model, packed.
UvMatrix finished(const std::shared_ptr<const MeshData> &mesh)
{
    Snapshot snapshot;
    snapshot.settings.flat = FlatMode::Free; // tst_rigid judges the rigid ones
    snapshot.mesh = mesh;
    snapshot.settings.lambda = 0.05; // where LiveSchedule begins
    Solver solver;
    solver.load(SeamPreference().applied(snapshot));
    runToTheEnd(solver, maxDistortion);
    const SolveSettings &reached = solver.snapshot().settings;
    FinishInput finish{.snapshot = snapshot, .maxDistortion = maxDistortion};
    finish.live = {solver.coordinates(), reached.lambda, reached.delta};
    const UvMatrix uv = finishMap(finish, onAllCores()).uv;
    return packed(*mesh, findCharts(*mesh, uv), uv);
}

//! A map that covers itself many times: every corner seen along the axis that its face looks along most.
UvMatrix boxProjection(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        Vec3 normal = Vec3::Zero();
        const int first = mesh.faceStart[f], end = mesh.faceStart[f + 1];
        for (int c = first; c < end; ++c)
            normal += mesh.cornerPosition(c).cross(mesh.cornerPosition(c + 1 < end ? c + 1 : first));
        int axis = 0;
        normal.cwiseAbs().maxCoeff(&axis);
        const double sign = normal[axis] < 0 ? -1 : 1;
        for (int c = first; c < end; ++c) {
            const Vec3 p = mesh.cornerPosition(c);
            uv.row(c) << sign * p[(axis + 1) % 3], p[(axis + 2) % 3];
        }
    }
    return uv;
}

enum class Better { Less, More };

//! \returns what is wrong with a figure, or nothing
QString compared(const char *figure, double value, double pinned, Better better)
{
    const double gain = (better == Better::Less ? pinned - value : value - pinned) / pinned;
    const QString text = QStringLiteral("%1 is %2, pinned at %3: %4 % %5")
                             .arg(QLatin1String(figure))
                             .arg(value, 0, 'g', 6)
                             .arg(pinned, 0, 'g', 6)
                             .arg(100 * std::abs(gain), 0, 'f', 2)
                             .arg(gain < 0 ? QLatin1String("worse") : QLatin1String("better"));
    if (!(gain >= -tolerance))
        return text;
    if (gain > 0.001)
        qInfo("%s. Tighten the pin", qPrintable(text));
    return {};
}

} // namespace

class TestQuality : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyWhatIsWorseIsWrong()
    {
        QVERIFY(compared("length", 1.029, 1, Better::Less).isEmpty());
        QVERIFY(!compared("length", 1.031, 1, Better::Less).isEmpty());
        QVERIFY(!compared("length", std::nan(""), 1, Better::Less).isEmpty());
        QVERIFY(compared("use", 0.971, 1, Better::More).isEmpty());
        QVERIFY(!compared("use", 0.969, 1, Better::More).isEmpty());
        QTest::ignoreMessage(QtInfoMsg, "length is 0.5, pinned at 1: 50.00 % better. Tighten the pin");
        QVERIFY(compared("length", 0.5, 1, Better::Less).isEmpty());
    }

    void mapsKeepTheirQuality_data()
    {
        QTest::addColumn<Job>("job");
        QTest::addColumn<QString>("sample");
        QTest::addColumn<Figures>("pinned");
        const auto pin = [](const char *title, Job job, const char *sample, const Figures &pinned) {
            QTest::addRow("%s %s", title, sample) << job << QString::fromLatin1(sample) << pinned;
        };
        pin("draft", Job::Draft, "bumpycube", {4.39115, 4.037036, 0.43628, 1});
        pin("draft", Job::Draft, "character", {10.48089, 4.094375, 0.46953, 1});
        pin("draft", Job::Draft, "torus", {6.91458, 4.057297, 0.46492, 1});
        pin("draft", Job::Draft, "machine", {18.73848, 4.096687, 0.78496, 46});
        pin("standard", Job::Standard, "bumpycube", {3.66362, 4.098390, 0.44370, 1});
        pin("standard", Job::Standard, "character", {7.25195, 4.098486, 0.555472, 2});
        pin("standard", Job::Standard, "torus", {5.81452, 4.098397, 0.47821, 1});
        // Not the machine: that takes long and shows little more than its draft.
        pin("finish", Job::Finish, "bumpycube", {3.40379, 4.097472, 0.53249, 1});
        pin("finish", Job::Finish, "character", {10.47352, 4.098997, 0.66344, 9});
        pin("finish", Job::Finish, "torus", {9.06237, 4.032888, 0.54859, 7});
        pin("finish", Job::Finish, "machine", {20.90177, 4.099148, 0.81766, 53});
        pin("separate", Job::Separate, "bumpycube", {8.41853, 4.019709, 0.65081, 6});
        pin("separate", Job::Separate, "character", {30.50326, 4.062418, 0.55380, 51});
        pin("separate", Job::Separate, "torus", {23.82475, 4.129902, 0.70890, 28});
        pin("separate", Job::Separate, "machine", {58.21553, 4.047310, 0.74588, 385});
        pin("pack", Job::Pack, "machine", {18.73848, 4.096687, 0.82785, 46});
    }
    void mapsKeepTheirQuality()
    {
        QFETCH(Job, job);
        QFETCH(QString, sample);
        QFETCH(Figures, pinned);
        const std::shared_ptr<const MeshData> mesh = makeSample(sample)->mesh;
        const UvMatrix uv = mapOf(job, sample, mesh);
        QCOMPARE(uv.rows(), mesh->cornerCount());
        const UvMetrics found = measureUv(*mesh, uv);
        QCOMPARE(found.flipped, 0);
        QCOMPARE(found.overlapPairs, 0);
        QVERIFY(found.inUnitSquare);
        if (job <= Job::Finish)
            QVERIFY2(found.symDirichlet <= maxDistortion,
                     qPrintable(QString::number(found.symDirichlet, 'g', 8)));
#ifdef __clang__
        // Its rounding differs, and so the search finds other maps than those that were pinned.
        QSKIP("The figures are pinned for GCC");
#endif
        QVERIFY2(std::abs(found.charts - pinned.charts) <= tolerance * pinned.charts,
                 qPrintable(QStringLiteral("charts: %1, pinned at %2").arg(found.charts).arg(pinned.charts)));
        QStringList worse;
        worse << compared("seam_norm", found.seamNorm, pinned.seamNorm, Better::Less)
              << compared("distortion above 4", found.symDirichlet - 4, pinned.distortion - 4, Better::Less)
              << compared("packing_efficiency", found.packingUnit, pinned.packing, Better::More);
        worse.removeAll(QString());
        QVERIFY2(worse.isEmpty(), qPrintable(worse.join(QLatin1String("; "))));
    }

private:
    UvMatrix mapOf(Job job, const QString &sample, const std::shared_ptr<const MeshData> &mesh)
    {
        switch (job) {
        case Job::Draft:
            return draft(sample, mesh);
        case Job::Standard:
            return unwrapped(mesh, UnwrapQuality::Standard);
        case Job::Finish:
            return finished(mesh);
        case Job::Separate: {
            Snapshot snapshot;
            snapshot.settings.flat = FlatMode::Free; // tst_rigid judges the rigid ones
            snapshot.mesh = mesh;
            snapshot.uv = std::make_shared<const UvMatrix>(boxProjection(*mesh));
            return separateMap(snapshot, {}, onAllCores()).uv;
        }
        case Job::Pack: {
            const UvMatrix &uv = draft(sample, mesh);
            return packed(*mesh, findCharts(*mesh, uv), uv);
        }
        }
        return {};
    }

    static UvMatrix unwrapped(const std::shared_ptr<const MeshData> &mesh, UnwrapQuality quality)
    {
        Snapshot snapshot;
        snapshot.settings.flat = FlatMode::Free;  // tst_rigid judges the rigid ones
        snapshot.settings.worldUp = WorldUp::Off; // tst_upright those that stand
        snapshot.mesh = mesh;
        UnwrapOptions options;
        options.maxDistortion = maxDistortion;
        options.quality = quality;
        return unwrapMesh(snapshot, options, onAllCores()).uv;
    }

    //! Made once: it is packed again, too.
    const UvMatrix &draft(const QString &sample, const std::shared_ptr<const MeshData> &mesh)
    {
        UvMatrix &uv = mDrafts[sample];
        if (uv.size() == 0)
            uv = unwrapped(mesh, UnwrapQuality::Draft);
        return uv;
    }

    std::map<QString, UvMatrix> mDrafts;
};

QTEST_GUILESS_MAIN(TestQuality)

} // namespace tst_quality

#include "tst_quality.moc"
