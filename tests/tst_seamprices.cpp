// What seams are worth: the prices are those of really dropping or adding them.
#include "model/plain/edgeangles.h"
#include "model/plain/uvlayout.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/search/cutstate.h"
#include "solver/search/resteering.h"
#include "solver/search/seamtrial.h"
#include "solver/unwrap/mapbefore.h"
#include "solver/unwrap/seamprices.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

namespace tst_seamprices {

using namespace autocuts;
using namespace autocuts::unwrap;

namespace {

Snapshot unwrapped(const test::MeshPtr &mesh, double bound)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    UnwrapOptions options;
    options.maxDistortion = bound;
    options.quality = UnwrapQuality::Draft;
    const UvMatrix uv = unwrapMesh(snapshot, options).uv;
    snapshot.uv = std::make_shared<const UvMatrix>(uv);
    snapshot.uvScale = layoutScale(*mesh, uv);
    return snapshot;
}

void setState(Snapshot &snapshot, const std::vector<int> &edges, PairState state)
{
    std::vector<PairState> &states = snapshot.editSteering().pairState;
    states.resize(snapshot.mesh->cornerPairCount(), PairState::Free);
    for (const int e : edges)
        states[2 * e] = states[2 * e + 1] = state;
}

//! The distortion of a map with only these seams changed: what an artist would get by doing it.
double distortionWith(const Snapshot &before, const Snapshot &after)
{
    const std::shared_ptr<const Soup> soup = Soup::build(before.mesh);
    const auto graph = search::SeamGraph::build(soup, before);
    const auto state = search::resteered(search::CutState::from(graph, *mapBefore(*soup, before), true),
                                         graph->steeredBy(after));
    if (!state)
        return 0;
    search::CutState relaxed = *state;
    search::SeamTrial trial(relaxed);
    trial.relaxAll(200, true);
    return relaxed.distortion;
}

} // namespace

class TestSeamPrices : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pricesAreTrue_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"sphere", "torus", "bumpycube"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void pricesAreTrue()
    {
        QFETCH(QString, name);
        const Snapshot snapshot =
            unwrapped(name == QLatin1String("sphere") ? test::sphere(16, 20) : test::meshNamed(name), 4.03);
        const SeamPrices prices = priceSeams(snapshot);
        QVERIFY(prices.hasMap);
        QVERIFY(!prices.seams.empty());
        double last = -1e300;
        int checked = 0;
        for (const SeamPrice &price : prices.seams) {
            QVERIFY(!price.edges.empty());
            if (!price.distortion)
                continue;
            const double perLength = (*price.distortion - prices.distortion) / price.length;
            QVERIFY(perLength >= last);
            last = perLength;
            if (++checked > 3)
                continue;
            Snapshot dropped = snapshot;
            setState(dropped, price.edges, PairState::Joined);
            const double really = distortionWith(snapshot, dropped);
            QVERIFY2(std::abs(really - *price.distortion) < 0.02 * (really - 3.9),
                     qPrintable(QStringLiteral("%1 instead of %2").arg(really).arg(*price.distortion)));
        }
        if (prices.proposal) {
            QVERIFY(*prices.proposal->distortion < prices.distortion);
            Snapshot added = snapshot;
            setState(added, prices.proposal->edges, PairState::Cut);
            QVERIFY(std::abs(distortionWith(snapshot, added) - *prices.proposal->distortion) < 0.01);
        }
    }

    //! With given seams only these have a price.
    void onlyGivenSeamsArePriced()
    {
        const test::MeshPtr mesh = test::cube();
        Snapshot snapshot;
        snapshot.mesh = mesh;
        snapshot.settings.seams = SeamMode::Only;
        std::vector<bool> &given = snapshot.editSteering().givenSeams;
        given.assign(mesh->edgePairs.size(), false);
        int count = 0;
        for (std::size_t e = 0; e < given.size(); ++e) {
            // Seven of the cube's twelve edges open it to a cross; more make islands.
            if (std::abs(edgeAngles(*mesh)[e]) > 0.5 && count < 12) {
                given[e] = true;
                ++count;
            }
        }
        const UnwrapResult made = unwrapMesh(snapshot, {});
        snapshot.uv = std::make_shared<const UvMatrix>(made.uv);
        snapshot.uvScale = layoutScale(*mesh, made.uv);
        const SeamPrices prices = priceSeams(snapshot);
        QVERIFY(prices.hasMap);
        QVERIFY(!prices.seams.empty());
        for (const SeamPrice &price : prices.seams) {
            for (const int e : price.edges)
                QVERIFY(given[e]);
        }
        // Closing one edge between two squares costs nothing.
        QVERIFY(prices.seams.front().distortion);
        QVERIFY(*prices.seams.front().distortion < 4.0001);
        QVERIFY(prices.seams.front().length > 0);
    }

    void aMapWithFlipsHasNoPrices()
    {
        Snapshot snapshot = unwrapped(test::sphere(8, 10), 4.1);
        UvMatrix uv = *snapshot.uv;
        uv.row(0).swap(uv.row(1));
        snapshot.uv = std::make_shared<const UvMatrix>(uv);
        QVERIFY(!priceSeams(snapshot).hasMap);
    }

    void stoppedItGivesWhatItHas()
    {
        const std::atomic<bool> stop = true;
        const SeamPrices prices = priceSeams(unwrapped(test::sphere(16, 20), 4.03), {&stop});
        QVERIFY(prices.hasMap);
        QVERIFY(prices.seams.empty());
    }
};

QTEST_GUILESS_MAIN(TestSeamPrices)

} // namespace tst_seamprices

#include "tst_seamprices.moc"
