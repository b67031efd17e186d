// The steering contract (docs/steering.md): whatever the user steers, every job obeys it.
#include "model/plain/uvlayout.h"
#include "support/steeredjobs.h"

#include <QTest>

namespace tst_contract {

using namespace autocuts;

class TestContract : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyJobObeys_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : test::contractMeshes())
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void everyJobObeys()
    {
        QFETCH(QString, name);
        const test::MeshPtr mesh = test::contractMesh(name);
        const UvMatrix uv = test::contractMap(mesh);
        Snapshot mapped;
        mapped.mesh = mesh;
        mapped.uv = std::make_shared<const UvMatrix>(uv);
        mapped.uvScale = layoutScale(*mesh, uv);
        QStringList all;
        for (int seed = 1; seed <= test::steeringCount(); ++seed) {
            const Snapshot snapshot = test::steered(mesh, uv, seed);
            const auto check = [&](const char *job, const test::Outcome &outcome) {
                for (const QString &clause : test::broken(snapshot, outcome))
                    all << QStringLiteral("%1 with seed %2: %3")
                               .arg(QLatin1String(job))
                               .arg(seed)
                               .arg(clause);
            };
            for (const test::SteeredJob &job : test::steeredJobs())
                check(job.name, job.run(snapshot));
            check("live, steered", test::livedSince(mapped, snapshot));
        }
        QVERIFY2(all.isEmpty(), qPrintable(all.join(u'\n')));
    }
};

QTEST_GUILESS_MAIN(TestContract)

} // namespace tst_contract

#include "tst_contract.moc"
