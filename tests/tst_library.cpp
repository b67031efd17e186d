// The installed library, as other programs use it: found by CMake and by pkg-config, from C++ and from C,
// with the maps of the command line. The mesh checks of its interface.
#include <autocuts/autocuts.hpp>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <cmath>
#include <limits>
#include <set>
#include <thread>
#include <vector>

using namespace Qt::Literals::StringLiterals;

namespace {

//! Runs a program. \returns what it wrote, or nothing when it failed
std::optional<QString> run(const QString &program, const QStringList &arguments, const QString &folder = {})
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.setWorkingDirectory(folder);
    process.start(program, arguments);
    if (!process.waitForFinished(300'000) || process.exitStatus() != QProcess::NormalExit ||
        process.exitCode() != 0) {
        qWarning("%s", process.readAll().constData());
        return std::nullopt;
    }
    return QString::fromUtf8(process.readAll());
}

//! The UVs of all corners of an OBJ, face by face.
std::vector<double> uvsOf(const QString &path)
{
    QFile file(path);
    std::vector<double> vt, uvs;
    if (!file.open(QIODevice::ReadOnly))
        return uvs;
    while (!file.atEnd()) {
        const QList<QByteArray> words = file.readLine().simplified().split(' ');
        if (words.front() == "vt")
            vt.insert(vt.end(), {words[1].toDouble(), words[2].toDouble()});
        for (qsizetype k = 1; words.front() == "f" && k < words.size(); ++k) {
            const auto index = std::size_t(words[k].split('/')[1].toInt() - 1);
            uvs.insert(uvs.end(), {vt.at(2 * index), vt.at(2 * index + 1)});
        }
    }
    return uvs;
}

//! A cube of quads.
struct Cube
{
    std::vector<double> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
    std::vector<std::uint32_t> sizes = std::vector<std::uint32_t>(6, 4);
    std::vector<std::uint32_t> indices{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                       2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};

    autocuts::Mesh view() const { return {positions, indices, sizes}; }
};

autocuts::Options draft()
{
    autocuts::Options options;
    options.quality = AUTOCUTS_DRAFT;
    return options;
}

} // namespace

class TestLibrary : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! Installs the library and builds the examples with it.
    void initTestCase()
    {
        QVERIFY(mFolder.isValid());
        const QString prefix = mFolder.filePath(u"prefix"_s), build = mFolder.filePath(u"build"_s);
        for (const QString &component : {u"runtime"_s, u"development"_s})
            QVERIFY(run(u"cmake"_s, {u"--install"_s, QStringLiteral(AUTOCUTS_BUILD), u"--prefix"_s, prefix,
                                     u"--component"_s, component}));
        QVERIFY(run(u"cmake"_s, {u"-S"_s, QStringLiteral(AUTOCUTS_SOURCE_DIR "/examples"), u"-B"_s, build,
                                 u"-DCMAKE_PREFIX_PATH="_s + prefix, u"-DCMAKE_BUILD_TYPE=Release"_s}));
        QVERIFY(run(u"cmake"_s, {u"--build"_s, build}));
    }

    void fromCpp()
    {
        const auto said = run(mFolder.filePath(u"build/wavytorus"_s), {u"torus.obj"_s}, mFolder.path());
        QVERIFY(said && said->contains(u"islands "_s));
        QCOMPARE(uvsOf(mFolder.filePath(u"torus.obj"_s)).size(), std::size_t(2 * 4 * 48 * 24));
    }

    void fromC()
    {
        const auto said = run(mFolder.filePath(u"build/measurecube"_s), {});
        QVERIFY2(said && *said == u"islands 1, distortion 4, flipped 0\n"_s,
                 qPrintable(said.value_or(QString())));
    }

    void pkgConfigFindsIt()
    {
        const QString file =
            run(u"find"_s, {mFolder.path(), u"-name"_s, u"autocuts.pc"_s}).value_or(QString()).trimmed();
        QVERIFY(QFile::exists(file));
        QFile text(file);
        QVERIFY(text.open(QIODevice::ReadOnly));
        const QByteArray content = text.readAll();
        QVERIFY(content.contains("-lautocuts") && !content.contains(mFolder.path().toUtf8())); // relocatable
    }

    //! The same bits as the command line.
    void mapsOfTheCommandLine_data()
    {
        QTest::addColumn<QString>("sample");
        QTest::addColumn<QString>("quality");
        QTest::newRow("bumpy cube, draft") << u"bumpycube"_s << u"draft"_s;
        QTest::newRow("torus, standard") << u"torus"_s << u"standard"_s;
    }

    void mapsOfTheCommandLine()
    {
        QFETCH(QString, sample);
        QFETCH(QString, quality);
        const QString cli = QStringLiteral(AUTOCUTS_CLI), folder = mFolder.path();
        QVERIFY(run(cli, {u"sample"_s, sample, u"-o"_s, u"sample.obj"_s}, folder));
        QVERIFY(
            run(cli, {u"unwrap"_s, u"sample.obj"_s, u"-o"_s, u"cli.obj"_s, u"--quality"_s, quality}, folder));
        QVERIFY(run(mFolder.filePath(u"build/unwrapobj"_s), {u"sample.obj"_s, u"own.obj"_s, quality, u"2"_s},
                    folder));
        const std::vector<double> ofCli = uvsOf(mFolder.filePath(u"cli.obj"_s)),
                                  own = uvsOf(mFolder.filePath(u"own.obj"_s));
        QVERIFY(!own.empty());
        QCOMPARE(own, ofCli);
    }

    void onlyItsFunctionsAreSeen()
    {
        const auto symbols = run(u"nm"_s, {u"-D"_s, u"--defined-only"_s, QStringLiteral(AUTOCUTS_LIBRARY)});
        QVERIFY(symbols);
        int count = 0;
        for (const QString &line : symbols->split(u'\n', Qt::SkipEmptyParts)) {
            QVERIFY2(line.section(u' ', -1).startsWith(u"autocuts_"_s), qPrintable(line));
            ++count;
        }
        QCOMPARE(count, 15);
    }

    void islandsAndSeams()
    {
        const Cube cube;
        const autocuts::Map map = autocuts::unwrap(cube.view(), draft());
        QCOMPARE(map.islandCount(), std::size_t(1));
        QCOMPARE(map.islands().size(), std::size_t(6));
        QCOMPARE(std::ranges::count(map.islands(), 0), 6);
        // A net of a cube: 5 of its 12 edges are whole, each of them a side of two faces.
        QCOMPARE(std::ranges::count(map.seams(), 0), 10);
    }

    //! Edges that must be seams are, those that must not are not.
    void obeysEdges()
    {
        const Cube cube;
        autocuts::Mesh mesh = cube.view();
        const autocuts::Map free = autocuts::unwrap(mesh, draft());
        // The five edges that had been whole are cut.
        std::vector<std::uint8_t> edges;
        for (const std::uint8_t seam : free.seams())
            edges.push_back(seam ? AUTOCUTS_EDGE_FREE : AUTOCUTS_EDGE_SEAM);
        mesh.edges = edges;
        const autocuts::Map cut = autocuts::unwrap(mesh, draft());
        for (std::size_t c = 0; c < edges.size(); ++c)
            QVERIFY(edges[c] == AUTOCUTS_EDGE_FREE || cut.seams()[c] == 1);
        // One edge that had been a seam is not.
        const auto seam = std::size_t(std::ranges::find(free.seams(), 1) - free.seams().begin());
        edges.assign(24, AUTOCUTS_EDGE_FREE);
        edges[seam] = AUTOCUTS_EDGE_JOINED;
        mesh.edges = edges;
        QCOMPARE(int(autocuts::unwrap(mesh, draft()).seams()[seam]), 0);
    }

    //! Islands get the density that is asked for, in as many tiles as that needs.
    void density()
    {
        const Cube cube;
        autocuts::Options options = draft();
        options.texture_width = options.texture_height = 256;
        options.density = 200;
        const std::vector<std::uint8_t> edges(24, AUTOCUTS_EDGE_SEAM);
        autocuts::Mesh mesh = cube.view();
        mesh.edges = edges;
        const autocuts::Map map = autocuts::unwrap(mesh, options);
        QCOMPARE(map.islandCount(), std::size_t(6));
        std::set<std::pair<int, int>> tiles;
        for (std::size_t face = 0; face < 6; ++face) {
            const double *first = map.uvs().data() + 8 * face;
            QVERIFY(std::abs(std::hypot(first[2] - first[0], first[3] - first[1]) * 256 - 200) < 0.1);
            tiles.emplace(int(first[0]), int(first[1]));
        }
        QCOMPARE(tiles.size(), std::size_t(6)); // a face of 200 texels fills one
    }

    void packsAndMeasures()
    {
        const Cube cube;
        std::vector<double> uvs;
        for (int face = 0; face < 6; ++face)
            uvs.insert(uvs.end(), {0, 0, 1, 0, 1, 1, 0, 1});
        autocuts::Mesh mesh = cube.view();
        mesh.uvs = uvs;
        const autocuts::Figures before = autocuts::take(mesh).measure();
        QVERIFY(before.overlapping_pairs > 0);
        const autocuts::Map packed = autocuts::pack(mesh);
        const autocuts::Figures after = packed.measure();
        QCOMPARE(after.overlapping_pairs, std::int64_t(0));
        QCOMPARE(after.islands, std::int64_t(6));
        QVERIFY(after.gutter_texels > 7.9);
        const std::vector<double> given(packed.uvs().begin(), packed.uvs().end());
        const auto [low, high] = std::ranges::minmax(given);
        QVERIFY(low >= 0 && high <= 1);
        // Locked islands stay.
        const std::vector<std::uint8_t> locked{0, 0, 0, 0, 0, 1};
        std::vector<double> own = given;
        mesh.uvs = own;
        mesh.lockedFaces = locked;
        autocuts::Options options;
        options.margin = 16;
        const autocuts::Map again = autocuts::pack(mesh, options);
        QVERIFY(std::equal(own.end() - 8, own.end(), again.uvs().end() - 8));
    }

    void separates()
    {
        const Cube cube;
        // A strip of four faces laid onto two places.
        std::vector<double> uvs(48, std::numeric_limits<double>::quiet_NaN());
        const std::vector<double> positions{0, 0, 0, 1, 0, 0, 2, 0, 1, 3, 0, 0,
                                            0, 1, 0, 1, 1, 0, 2, 1, 1, 3, 1, 0};
        const std::vector<std::uint32_t> indices{0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6}, sizes(3, 4);
        const std::vector<double> strip{0, 0, 1, 0, 1, 1, 0,  1,  1,  0,  2, 0,
                                        2, 1, 1, 1, 2, 0, .5, .2, .5, .8, 2, 1};
        const autocuts::Map map = autocuts::separate({positions, indices, sizes, {}, strip});
        QCOMPARE(map.measure().overlapping_pairs, std::int64_t(0));
    }

    void badInput_data()
    {
        QTest::addColumn<QString>("fault");
        QTest::addColumn<QString>("message");
        QTest::newRow("NaN") << u"nan"_s << u"vertex 3"_s;
        QTest::newRow("index") << u"index"_s << u"index 5 is 99, out of range"_s;
        QTest::newRow("no faces") << u"empty"_s << u"no faces"_s;
        QTest::newRow("two corners") << u"two"_s << u"fewer than three corners"_s;
        QTest::newRow("no area") << u"flat"_s << u"without area"_s;
        QTest::newRow("bound") << u"bound"_s << u"above 4"_s;
        QTest::newRow("no map") << u"map"_s << u"no UVs"_s;
        QTest::newRow("margin") << u"margin"_s << u"no room"_s;
        QTest::newRow("threads") << u"threads"_s << u"threads"_s;
    }

    void badInput()
    {
        QFETCH(QString, fault);
        QFETCH(QString, message);
        Cube cube;
        autocuts::Options options = draft();
        if (fault == u"nan")
            cube.positions[10] = std::numeric_limits<double>::quiet_NaN();
        if (fault == u"index")
            cube.indices[5] = 99;
        if (fault == u"empty")
            cube.sizes.clear(), cube.indices.clear();
        if (fault == u"two")
            cube.sizes[1] = 2, cube.indices.resize(22);
        if (fault == u"flat")
            std::ranges::fill(cube.positions, 1.0);
        if (fault == u"bound")
            options.max_distortion = 4;
        if (fault == u"margin")
            options.margin = 5000;
        if (fault == u"threads")
            options.threads = 0;
        try {
            if (fault == u"map")
                static_cast<void>(autocuts::pack(cube.view(), options));
            else
                static_cast<void>(autocuts::unwrap(cube.view(), options));
            QFAIL("nothing was refused");
        } catch (const autocuts::Error &error) {
            QVERIFY2(QString::fromUtf8(error.what()).contains(message), error.what());
        }
    }

    void jobsAtOnce()
    {
        const Cube cube;
        const autocuts::Map alone = autocuts::unwrap(cube.view(), draft());
        std::atomic<int> same = 0;
        std::vector<std::jthread> threads;
        for (int i = 0; i < 8; ++i)
            threads.emplace_back([&] {
                const autocuts::Map map = autocuts::unwrap(cube.view(), draft());
                same += std::ranges::equal(map.uvs(), alone.uvs());
            });
        threads.clear();
        QCOMPARE(same.load(), 8);
    }

    void stops()
    {
        const QString path = mFolder.filePath(u"torus.obj"_s);
        Cube cube;
        int reports = 0;
        const autocuts::Map map = autocuts::unwrap(cube.view(), {}, [&](double) { return ++reports < 1; });
        QVERIFY(map.stopped());
        QCOMPARE(map.measure().flipped_triangles, std::int64_t(0));
    }

private:
    QTemporaryDir mFolder;
};

QTEST_GUILESS_MAIN(TestLibrary)
#include "tst_library.moc"
