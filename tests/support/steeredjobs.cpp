#include "support/steeredjobs.h"

#include "model/plain/uvlayout.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/livemap.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/separatejob.h"
#include "solver/unwrap/unwrap.h"

namespace autocuts::test {

using namespace unwrap;

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

Outcome unwrapped(const Snapshot &snapshot)
{
    const UnwrapResult result = unwrapMesh(snapshot, draft());
    return {result.uv,         result.cut, result.unmet, true, !result.packed && !result.nothingFree,
            result.madeSmaller};
}

Outcome finished(const Snapshot &snapshot)
{
    FinishInput input;
    input.snapshot = snapshot;
    input.packing = hurried();
    const FinishResult result = finishMap(input);
    return {result.uv, {}, result.unmet, true, result.noRoom || result.heldTogether, result.madeSmaller};
}

Outcome separated(const Snapshot &snapshot)
{
    const SeparateResult result = separateMap(snapshot, steeredPackJob(snapshot, hurried()));
    return {result.uv, {}, {}, false, result.outcome == SeparateResult::Outcome::NoRoom};
}

Outcome packed(const Snapshot &snapshot)
{
    UvMatrix uv = *snapshot.uv;
    const bool done =
        packCharts(*snapshot.mesh, findCharts(*snapshot.mesh, uv), steeredPackJob(snapshot, hurried()), uv);
    return {uv, {}, {}, false, !done};
}

//! The second map of a live solve. \param before where it begins, before it is steered; null: it begins
//! steered
Outcome lived(const Snapshot *before, const Snapshot &snapshot)
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

Outcome livedFromStart(const Snapshot &snapshot)
{
    return lived(nullptr, snapshot);
}

} // namespace

const std::vector<SteeredJob> &steeredJobs()
{
    static const std::vector<SteeredJob> jobs{{"unwrap", unwrapped},
                                              {"finish", finished},
                                              {"separate", separated},
                                              {"pack", packed},
                                              {"live", livedFromStart}};
    return jobs;
}

Outcome livedSince(const Snapshot &before, const Snapshot &snapshot)
{
    return lived(&before, snapshot);
}

const std::vector<const char *> &contractMeshes()
{
    static const std::vector<const char *> names{"grid", "sphere", "torus", "quad cube", "two"};
    return names;
}

MeshPtr contractMesh(const QString &name)
{
    if (name == QLatin1String("sphere"))
        return sphere(10, 12);
    if (name != QLatin1String("two"))
        return meshNamed(name);
    return polygonMesh(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}},
        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {4, 7, 6}});
}

UvMatrix contractMap(const MeshPtr &mesh)
{
    Snapshot plain;
    plain.mesh = mesh;
    UnwrapOptions many = draft();
    many.maxDistortion = 4.02;
    return unwrapMesh(plain, many).uv;
}

int steeringCount()
{
    const int asked = qEnvironmentVariableIntValue("AUTOCUTS_STEERINGS");
    return asked > 0 ? asked : 8;
}

} // namespace autocuts::test
