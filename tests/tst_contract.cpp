// The steering contract (docs/steering.md): whatever the user steers, every job obeys it.
#include "model/plain/uvlayout.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/livemap.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/separatejob.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"
#include "support/steerings.h"

#include <QTest>

using namespace autocuts;
using namespace autocuts::unwrap;

namespace {

packing::PackOptions hurried()
{
    packing::PackOptions options;
    options.effort = 0.02;
    options.margin = 4;
    return options;
}

UnwrapOptions draft()
{
    UnwrapOptions options;
    options.quality = UnwrapQuality::Draft;
    options.packing = hurried();
    return options;
}

test::Outcome unwrapped(const Snapshot &snapshot)
{
    const UnwrapResult result = unwrapMesh(snapshot, draft());
    return {result.uv, result.cut, result.unmet, true, !result.packed && !result.nothingFree};
}

test::Outcome finished(const Snapshot &snapshot)
{
    FinishInput input;
    input.snapshot = snapshot;
    input.packing = hurried();
    const FinishResult result = finishMap(input);
    return {result.uv, {}, result.unmet, true, result.noRoom || result.heldTogether};
}

test::Outcome separated(const Snapshot &snapshot)
{
    const SeparateResult result = separateMap(snapshot, steeredPackJob(snapshot, hurried()));
    return {result.uv, {}, {}, false, result.outcome == SeparateResult::Outcome::NoRoom};
}

test::Outcome packed(const Snapshot &snapshot)
{
    UvMatrix uv = *snapshot.uv;
    const bool done =
        packCharts(*snapshot.mesh, findCharts(*snapshot.mesh, uv), steeredPackJob(snapshot, hurried()), uv);
    return {uv, {}, {}, false, !done};
}

//! The second map of a live solve. \param before where it begins, before it is steered; null: it begins
//! steered
test::Outcome lived(const Snapshot *before, const Snapshot &snapshot)
{
    std::shared_ptr<const LiveMapResult> last;
    std::atomic<bool> stop = false;
    int maps = 0, wanted = 1;
    LiveMap live([&](std::shared_ptr<const LiveMapResult> map) {
        last = std::move(map);
        stop = ++maps >= wanted;
    });
    LiveMapOptions options;
    options.packing = hurried();
    const auto work = [&](int count) {
        maps = 0;
        wanted = count;
        stop = false;
        static_cast<void>(live.work({&stop}));
    };
    try {
        auto steered = std::make_shared<Snapshot>(snapshot);
        steered->settings.start = StartMode::ExistingUv;
        if (before) {
            auto first = std::make_shared<Snapshot>(*before);
            first->settings.start = StartMode::ExistingUv;
            live.begin(first, options);
            work(1);
            live.steer(steered, options);
        } else {
            live.begin(steered, options);
        }
        last.reset();
        work(2);
    } catch (const std::runtime_error &) {
        return {*snapshot.uv}; // nothing may change
    }
    if (!last)
        return {UvMatrix()};
    return {last->uv, last->cut, unmetSteering(snapshot, last->uv), true, !last->hasRoom};
}

//! Random steerings per mesh. $AUTOCUTS_STEERINGS asks for more of them.
int steerings()
{
    const int asked = qEnvironmentVariableIntValue("AUTOCUTS_STEERINGS");
    return asked > 0 ? asked : 8;
}

} // namespace

class TestContract : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyJobObeys_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"grid", "sphere", "torus", "quad cube", "two"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void everyJobObeys()
    {
        QFETCH(QString, name);
        const test::MeshPtr mesh = name == QLatin1String("two")      ? test::polygonMesh({{0, 0, 0},
                                                                                          {1, 0, 0},
                                                                                          {0, 1, 0},
                                                                                          {0, 0, 1},
                                                                                          {5, 0, 0},
                                                                                          {6, 0, 0},
                                                                                          {5, 1, 0},
                                                                                          {5, 0, 1}},
                                                                                         {{0, 2, 1},
                                                                                          {0, 1, 3},
                                                                                          {1, 2, 3},
                                                                                          {0, 3, 2},
                                                                                          {4, 6, 5},
                                                                                          {4, 5, 7},
                                                                                          {5, 6, 7},
                                                                                          {4, 7, 6}})
                                   : name == QLatin1String("sphere") ? test::sphere(10, 12)
                                                                     : test::meshNamed(name);
        Snapshot plain;
        plain.mesh = mesh;
        UnwrapOptions many = draft();
        many.maxDistortion = 4.02; // several islands
        const UvMatrix uv = unwrapMesh(plain, many).uv;
        Snapshot mapped = plain;
        mapped.uv = std::make_shared<const UvMatrix>(uv);
        mapped.uvScale = layoutScale(*mesh, uv);
        QStringList all;
        for (int seed = 1; seed <= steerings(); ++seed) {
            const Snapshot snapshot = test::steered(mesh, uv, seed);
            const struct
            {
                const char *job;
                test::Outcome outcome;
            } outcomes[] = {{"unwrap", unwrapped(snapshot)},    {"finish", finished(snapshot)},
                            {"separate", separated(snapshot)},  {"pack", packed(snapshot)},
                            {"live", lived(nullptr, snapshot)}, {"live, steered", lived(&mapped, snapshot)}};
            for (const auto &[job, outcome] : outcomes) {
                for (const QString &clause : test::broken(snapshot, outcome))
                    all << QStringLiteral("%1 with seed %2: %3")
                               .arg(QLatin1String(job))
                               .arg(seed)
                               .arg(clause);
            }
        }
        QVERIFY2(all.isEmpty(), qPrintable(all.join(u'\n')));
    }
};

QTEST_GUILESS_MAIN(TestContract)

#include "tst_contract.moc"
