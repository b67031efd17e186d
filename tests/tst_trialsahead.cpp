// Trials made ahead of their turn: they leave no trace, and the search finds the same map with them.
#include "solver/base/random.h"
#include "solver/search/seamoptimizer.h"
#include "solver/search/seamsearch.h"
#include "solver/search/trialsahead.h"
#include "support/meshbuilders.h"
#include "support/props.h"

#include <QTest>

#include <set>
#include <tuple>

namespace tst_trialsahead {

using namespace autocuts;
using namespace autocuts::search;

namespace {

test::MeshPtr meshNamed(const QString &name)
{
    return name == u"torus"  ? test::torus(12, 8)
           : name == u"cube" ? test::quadCube()
           : name == u"grid" ? test::meshNamed(name)
                             : test::sphere(10, 14);
}

CutState firstStateOf(const test::MeshPtr &mesh, bool aligned = false)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    if (aligned)
        snapshot.aligned = std::make_shared<std::vector<bool>>(1, true);
    const auto graph = SeamGraph::build(Soup::build(mesh), snapshot);
    OptimizeOptions options;
    std::optional<CutState> state = firstMap(graph, options, 0);
    Q_ASSERT(state);
    SeamTrial(*state).relaxAll(20, true);
    return std::move(*state);
}

//! Everything in a state, to the last bit.
auto allOf(const CutState &s)
{
    return std::tie(s.cut, s.x, s.triangleEnergy, s.energy, s.distortion, s.cost, s.crooked, s.length,
                    s.boundary, s.chart, s.chartArea, s.smallParts, s.cutsAt, s.chartsAreApart);
}

//! Opens and closes edges along a random walk.
SeamChange someChange(const CutState &state, Random &random)
{
    const SeamGraph &graph = *state.graph;
    SeamChange change;
    int at = random.below(graph.vertexCount);
    std::set<int> seen;
    for (int i = random.below(8); i >= 0 && !graph.edgesAt(at).empty(); --i) {
        const auto edges = graph.edgesAt(at);
        const int e = edges[random.below(static_cast<int>(edges.size()))];
        at = graph.farEnd(e, at);
        if (seen.insert(e).second)
            (state.cut[e] ? change.close : change.open).push_back(e);
    }
    return change;
}

} // namespace

class TestTrialsAhead : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aTrialOnACopyLeavesNoTrace_data()
    {
        QTest::addColumn<QString>("mesh");
        for (const char *name : {"sphere", "torus", "cube", "grid"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    //! ... and its change, adopted, is what a trial on the map itself does.
    void aTrialOnACopyLeavesNoTrace()
    {
        QFETCH(QString, mesh);
        CutState map = firstStateOf(meshNamed(mesh)), copy = map;
        SeamTrial onMap(map), onCopy(copy);
        Random random(3);
        int kept = 0, split = 0;
        for (int i = 0; i < 300; ++i) {
            SeamChange change = someChange(map, random);
            TrialTerms terms;
            // Most random changes cost something.
            terms.minGain = i % 3 == 0 ? 1e-6 : -0.3;
            terms.guarded = i % 2 == 0;
            const CutState before = copy;
            KeptChange foreseen;
            const bool would = onCopy.wouldKeep(change, terms, foreseen);
            QVERIFY2(allOf(copy) == allOf(before), qPrintable(QString::number(i)));
            const int charts = map.chartCount();
            QCOMPARE(onMap.attempt(change, terms), would);
            QCOMPARE(onCopy.lastGain(), onMap.lastGain());
            if (!would)
                continue;
            onCopy.adopt(foreseen);
            QVERIFY2(allOf(copy) == allOf(map), qPrintable(QString::number(i)));
            ++kept;
            split += map.chartCount() > charts;
        }
        QVERIFY(kept > 5);
        if (mesh == u"cube")
            QVERIFY(split > 0);
    }

    void threadsChangeNothing_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<bool>("aligned");
        for (const char *name : {"sphere", "torus", "cube"}) {
            QTest::addRow("%s", name) << QString::fromLatin1(name) << false;
            QTest::addRow("%s, aligned", name) << QString::fromLatin1(name) << true;
        }
    }
    void threadsChangeNothing()
    {
        QFETCH(QString, mesh);
        QFETCH(bool, aligned);
        const CutState first = firstStateOf(meshNamed(mesh), aligned);
        std::optional<CutState> alone;
        std::vector<int> countsAlone;
        for (const int threads : {1, 2, 5}) {
            CutState state = first;
            SeamSearch search(state, 7, {0.05, true, {}});
            search.useThreads(threads);
            search.polish(2);
            search.setHeat(1, 80);
            for (int i = 0; i < 80; ++i) {
                search.tryLargeMove(std::min(79 - i, 19 - i % 20));
                if (i % 20 == 19) {
                    search.setMu(search.mu() * 0.9);
                    search.relaxAll(1);
                }
            }
            search.setCeiling(state.energy + 0.01);
            search.absorbSmallCharts();
            search.joinCharts();
            search.polish(1);
            std::vector<int> counts{search.steps(), static_cast<int>(search.work())};
            for (const SeamSearch::Counts &count : search.counts)
                counts.insert(counts.end(), {count.tried, count.kept});
            if (!alone) {
                QVERIFY(state.objective(0.05) < first.objective(0.05));
                alone = state;
                countsAlone = counts;
            }
            QVERIFY2(allOf(state) == allOf(*alone), qPrintable(QString::number(threads)));
            QCOMPARE(counts, countsAlone);
        }
    }

    //! What comes after the first task that is kept is forgotten, whoever is quicker.
    void theFirstThatIsKeptCounts()
    {
        const CutState map = firstStateOf(test::sphere(10, 14));
        TrialsAhead ahead(map, 4);
        for (const int kept : {0, 3, 9, 100}) {
            std::vector<TrialsAhead::Task> tasks;
            for (int i = 0; i < 10; ++i)
                tasks.push_back([i, kept](SeamTrial &, TrialOutcome &outcome) {
                    outcome.tried = i;
                    outcome.kept = i >= kept;
                });
            const std::vector<TrialOutcome> outcomes = ahead.run(tasks);
            QCOMPARE(static_cast<int>(outcomes.size()), std::min(kept + 1, 10));
            for (std::size_t i = 0; i < outcomes.size(); ++i) {
                QCOMPARE(outcomes[i].tried, static_cast<int>(i));
                QCOMPARE(outcomes[i].kept, static_cast<int>(i) == kept);
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestTrialsAhead)

} // namespace tst_trialsahead

#include "tst_trialsahead.moc"
