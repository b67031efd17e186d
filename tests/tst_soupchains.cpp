// Drafts that start from the soup: how much is done for them.
#include "solver/unwrap/soupchains.h"
#include "support/meshbuilders.h"

#include <QTest>

namespace tst_soupchains {

using namespace autocuts;
using namespace autocuts::unwrap;

namespace {

//! All walls between the cells of a cube of n by n by n: most edges have four faces, as in loosely extracted
//! surfaces.
test::MeshPtr cells(int n)
{
    std::vector<Vec3> points;
    const auto point = [n](const std::array<int, 3> &at) {
        return at[0] + (n + 1) * (at[1] + (n + 1) * at[2]);
    };
    for (int z = 0; z <= n; ++z) {
        for (int y = 0; y <= n; ++y) {
            for (int x = 0; x <= n; ++x)
                points.emplace_back(x, y, z);
        }
    }
    std::vector<std::vector<int>> faces;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int level = 0; level <= n; ++level) {
            for (int a = 0; a < n; ++a) {
                for (int b = 0; b < n; ++b) {
                    const auto corner = [&](int da, int db) {
                        std::array<int, 3> at{};
                        at[axis] = level;
                        at[(axis + 1) % 3] = a + da;
                        at[(axis + 2) % 3] = b + db;
                        return point(at);
                    };
                    faces.push_back({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
                }
            }
        }
    }
    return test::polygonMesh(points, faces);
}

} // namespace

class TestSoupChains : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tangledMeshesAreRecognised()
    {
        QVERIFY(isTangled(*cells(3)));
        QVERIFY(!isTangled(*test::torus(12, 8)));
    }

    void draftsDoLess_data()
    {
        QTest::addColumn<bool>("tangled");
        QTest::newRow("torus") << false;
        QTest::newRow("cells") << true;
    }
    //! In hurry a map is found that is within the bound as well; on a tangled mesh the first run finds it.
    void draftsDoLess()
    {
        QFETCH(const bool, tangled);
        Snapshot snapshot;
        snapshot.mesh = tangled ? cells(6) : test::torus(40, 24);
        UnwrapOptions options;
        options.quality = UnwrapQuality::Draft;
        const JobContext job;
        std::array<int, 2> steps{};
        for (const bool hurried : {false, true}) {
            Ranking ranking(options, job);
            const std::optional<Candidate> found =
                bestOfSoupChains(snapshot, options, hurried, ranking, job, steps[hurried]);
            QVERIFY(found);
            QVERIFY(found->distortion <= options.maxDistortion);
            QCOMPARE(found->map.validate(*Soup::build(snapshot.mesh)), std::string());
        }
        QVERIFY(!tangled || steps[true] < steps[false]);
        QVERIFY(steps[true] > 0);
    }
};

QTEST_GUILESS_MAIN(TestSoupChains)

} // namespace tst_soupchains

#include "tst_soupchains.moc"
