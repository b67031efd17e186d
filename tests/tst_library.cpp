// The installed library, as other programs use it: found by CMake and by pkg-config, from C++ and from C,
// with the maps of the command line. The mesh checks of its interface.
#include <autocuts/autocuts.hpp>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
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

//! A torus of quads, with waves.
struct Torus
{
    std::vector<double> positions;
    std::vector<std::uint32_t> sizes, indices;

    explicit Torus(std::uint32_t count)
    {
        const double step = 2 * std::numbers::pi / count;
        for (std::uint32_t i = 0; i < count; ++i) {
            for (std::uint32_t j = 0; j < count; ++j) {
                const double around = i * step, across = j * step;
                const double radius = 2 + (0.7 + 0.1 * std::sin(5 * around + 3 * across)) * std::cos(across);
                for (const double x :
                     {radius * std::cos(around), radius * std::sin(around), std::sin(across)})
                    positions.push_back(x);
                const std::uint32_t below = (i + 1) % count, right = (j + 1) % count;
                for (const std::uint32_t v :
                     {i * count + j, below * count + j, below * count + right, i * count + right})
                    indices.push_back(v);
                sizes.push_back(4);
            }
        }
    }
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

    //! A program is built with what pkg-config says, also for the address sanitizer.
    void pkgConfigFindsIt()
    {
        const QString file =
            run(u"find"_s, {mFolder.path(), u"-name"_s, u"autocuts.pc"_s}).value_or(QString()).trimmed();
        QVERIFY(QFile::exists(file));
        QFile text(file);
        QVERIFY(text.open(QIODevice::ReadOnly));
        const QByteArray content = text.readAll();
        QVERIFY(content.contains("-lautocuts") && !content.contains(mFolder.path().toUtf8())); // relocatable
        const QString folder = QFileInfo(file).path(), program = mFolder.filePath(u"byPkgConfig"_s);
        const auto flags = run(u"env"_s, {u"PKG_CONFIG_PATH="_s + folder, u"pkg-config"_s, u"--cflags"_s,
                                          u"--libs"_s, u"autocuts"_s});
        QVERIFY(flags);
        const QStringList words = flags->simplified().split(u' ');
        for (const QString &checks : {u"-O1"_s, u"-fsanitize=address"_s}) {
            QVERIFY(run(u"cc"_s,
                        QStringList{checks, QStringLiteral(AUTOCUTS_SOURCE_DIR "/examples/measurecube.c"),
                                    u"-o"_s, program} +
                            words));
            const QString library = u"LD_LIBRARY_PATH="_s + QDir::cleanPath(folder + u"/.."_s);
            QCOMPARE(run(u"env"_s, {library, program}), u"islands 1, distortion 4, flipped 0\n"_s);
        }
    }

    void snippetOfTheDocumentation()
    {
        QFile page(QStringLiteral(AUTOCUTS_SOURCE_DIR "/docs/library.md"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QByteArray text = page.readAll();
        const qsizetype begin = text.indexOf("```cpp\n") + 7;
        QVERIFY(begin > 7);
        QFile program(mFolder.filePath(u"snippet.cpp"_s));
        QVERIFY(program.open(QIODevice::WriteOnly));
        program.write("#include <autocuts/autocuts.hpp>\n"
                      "void snippet(std::vector<double> positions, std::vector<std::uint32_t> indices, "
                      "std::vector<std::uint32_t> faceSizes)\n{\n" +
                      text.mid(begin, text.indexOf("```", begin) - begin) + "}\n");
        program.close();
        QVERIFY(run(u"c++"_s, {u"-std=c++20"_s, u"-fsyntax-only"_s,
                               QStringLiteral("-I" AUTOCUTS_SOURCE_DIR "/include"), program.fileName()}));
    }

    //! Another project has the source tree as a part of it, without the studio.
    void canBeASubdirectory()
    {
        const QString folder = mFolder.filePath(u"outer"_s);
        QVERIFY(QDir().mkpath(folder));
        QFile file(folder + u"/CMakeLists.txt"_s);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("cmake_minimum_required(VERSION 3.25)\nproject(Outer LANGUAGES C CXX)\n"
                   "add_subdirectory(" AUTOCUTS_SOURCE_DIR " autocuts)\n"
                   "add_executable(measurecube " AUTOCUTS_SOURCE_DIR "/examples/measurecube.c)\n"
                   "target_link_libraries(measurecube PRIVATE Autocuts::Autocuts)\n");
        file.close();
        QVERIFY(run(u"cmake"_s, {u"-S"_s, folder, u"-B"_s, folder + u"/build"_s, u"-G"_s, u"Ninja"_s,
                                 u"-DAUTOCUTS_STUDIO=OFF"_s, u"-DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON"_s}));
        QVERIFY(run(u"ninja"_s, {u"-C"_s, folder + u"/build"_s, u"-n"_s, u"measurecube"_s}));
    }

    //! Programs that were built with this version go on working: no field moves. A field that is added at the
    //! end of a struct that begins with its size is a new minor version, anything else a new SONAME.
    void layoutOfStructs()
    {
        const auto offsets = [](auto... values) { return std::vector<std::size_t>{std::size_t(values)...}; };
#define AT(field) offsetof(Struct, field)
        {
            using Struct = autocuts_mesh;
            QCOMPARE(offsets(AT(positions), AT(vertex_count), AT(face_sizes), AT(face_count), AT(indices),
                             AT(face_objects), AT(face_materials), AT(normals), AT(colors), AT(uvs),
                             AT(locked_faces), AT(edges), AT(edge_weights), AT(texel_weights), AT(pins),
                             AT(pin_count), sizeof(Struct)),
                     offsets(0, 8, 16, 24, 32, 40, 48, 56, 64, 72, 80, 88, 96, 104, 112, 120, 128));
        }
        {
            using Struct = autocuts_options;
            QCOMPARE(offsets(AT(size), AT(quality), AT(max_distortion), AT(seams), AT(seams_from),
                             AT(sharp_angle), AT(surface), AT(flat_rigid), AT(alike), AT(creases),
                             AT(crease_strength), AT(visibility), AT(symmetry), AT(mirror), AT(align),
                             AT(world_up), AT(texture_width), AT(texture_height), AT(margin), AT(tile_border),
                             AT(rotation), AT(keep_scale), AT(pack_time), AT(density), AT(threads),
                             AT(progress), AT(user), AT(better), AT(better_user), sizeof(Struct)),
                     offsets(0, 8, 16, 24, 28, 32, 40, 44, 48, 52, 56, 64, 72, 76, 80, 84, 88, 92, 96, 104,
                             112, 116, 120, 128, 136, 144, 152, 160, 168, 176));
        }
        {
            using Struct = autocuts_bake_options;
            QCOMPARE(offsets(AT(size), AT(width), AT(height), AT(tile), AT(samples), AT(rays), AT(cage),
                             AT(cage_positions), AT(cage_direction), AT(ray_reach), AT(curvature_radius),
                             AT(thickness_limit), AT(dilation), AT(directx), AT(floats), AT(threads),
                             AT(progress), AT(user), sizeof(Struct)),
                     offsets(0, 8, 12, 16, 20, 24, 32, 40, 48, 56, 64, 72, 80, 84, 88, 92, 96, 104, 112));
        }
#undef AT
        QCOMPARE(offsets(sizeof(autocuts_error), sizeof(autocuts_pin), sizeof(autocuts_transferred),
                         sizeof(autocuts_outcome), sizeof(autocuts_figures), sizeof(autocuts_baked)),
                 offsets(384, 32, 40, 40, 56, 16));
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
        QCOMPARE(count, 28);
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

    //! Weights, pins, given seams, and what the map could not obey.
    void obeysOtherWishes()
    {
        const Cube cube;
        autocuts::Mesh mesh = cube.view();
        const autocuts::Map free = autocuts::unwrap(mesh, draft());
        std::vector<double> weights;
        for (const std::uint8_t seam : free.seams())
            weights.push_back(seam ? 10 : 0.01);
        mesh.edgeWeights = weights;
        QVERIFY(!std::ranges::equal(autocuts::unwrap(mesh, draft()).seams(), free.seams()));
        mesh = cube.view();
        const std::vector<double> uvs(free.uvs().begin(), free.uvs().end());
        const std::vector<autocuts::Pin> pins{{0, uvs[0], uvs[1], 0}, {2, uvs[4] + 0.01, uvs[5], 0}};
        mesh.uvs = uvs;
        mesh.pins = pins;
        const autocuts::Map pinned = autocuts::unwrap(mesh, draft());
        QVERIFY(std::abs(pinned.uvs()[4] - pins[1].u) < 1e-9 && std::abs(pinned.uvs()[5] - pins[1].v) < 1e-9);
        QCOMPARE(pinned.outcome().unmet_pins, std::int64_t(0));
        mesh = cube.view();
        autocuts::Options options = draft();
        options.seams = AUTOCUTS_SEAMS_ONLY;
        options.seams_from = AUTOCUTS_SEAMS_FROM_SHARP;
        QCOMPARE(autocuts::unwrap(mesh, options).islandCount(), std::size_t(6));
        const std::vector<std::uint8_t> joined(24, AUTOCUTS_EDGE_JOINED);
        mesh.edges = joined;
        QVERIFY(autocuts::unwrap(mesh, draft()).outcome().unmet_joins > 0);
    }

    void otherJobs()
    {
        const Cube cube;
        autocuts::Mesh mesh = cube.view();
        const autocuts::Map made = autocuts::unwrap(mesh, draft());
        const std::vector<double> uvs(made.uvs().begin(), made.uvs().end());
        mesh.uvs = uvs;
        for (const auto job : {autocuts::finish, autocuts::align, autocuts::lightmap}) {
            const autocuts::Figures figures = job(mesh, draft(), {}).measure();
            QCOMPARE(figures.flipped_triangles + figures.overlapping_pairs, std::int64_t(0));
        }
        autocuts::Transferred figures{};
        const autocuts::Map same = autocuts::transfer(mesh, cube.view(), AUTOCUTS_MATCH_AUTO, {}, &figures);
        QVERIFY(std::ranges::equal(same.uvs(), uvs));
        QCOMPARE(figures.copied, std::int64_t(6));
        const std::vector<std::uint8_t> picture = made.draw(64, 32);
        QCOMPARE(picture.size(), std::size_t(4 * 64 * 32));
        QVERIFY(std::ranges::count(picture, 255) > 64); // opaque texels
    }

    void bakes()
    {
        Cube cube;
        const autocuts::Map made = autocuts::unwrap(cube.view(), draft());
        const std::vector<double> uvs(made.uvs().begin(), made.uvs().end());
        autocuts::Mesh mesh = cube.view();
        mesh.uvs = uvs;
        Cube grown;
        for (double &x : grown.positions)
            x = 1.02 * x - 0.01;
        const autocuts::Mesh high = grown.view();
        autocuts::BakeOptions options;
        options.width = options.height = 64;
        options.floats = 1;
        const std::vector<int> maps{AUTOCUTS_BAKE_OBJECT_NORMAL, AUTOCUTS_BAKE_HEIGHT};
        const autocuts::Bake baked = autocuts::bake(mesh, &high, maps, options);
        QVERIFY(baked.figures.texels > 500 && baked.figures.missed == 0);
        QCOMPARE(baked.pictures[0].size(), std::size_t(64 * 64 * 3));
        // Along rays that leave the corners of the cube diagonally.
        QVERIFY(std::abs(std::ranges::max(baked.pictures[1]) - 0.01 * std::sqrt(3)) < 1e-4);
        int calls = 0;
        QVERIFY_THROWS_EXCEPTION(
            autocuts::Error, autocuts::bake(mesh, &high, maps, options, [&](double) { return ++calls < 0; }));
    }

    //! Better maps come while an unwrap goes on, and change nothing of its result.
    void givesBetterMaps()
    {
        const Torus torus(40);
        std::vector<autocuts::Map> maps;
        autocuts::Options options;
        const autocuts::Map watched = autocuts::unwrap(
            torus.view(), options, {}, [&](autocuts::Map map) { maps.push_back(std::move(map)); });
        QVERIFY(!maps.empty());
        for (const autocuts::Map &map : maps) {
            const autocuts::Figures figures = map.measure();
            QCOMPARE(figures.flipped_triangles, 0);
            QCOMPARE(figures.overlapping_pairs, 0);
        }
        const autocuts::Map alone = autocuts::unwrap(torus.view(), options);
        QVERIFY(std::ranges::equal(watched.uvs(), alone.uvs()));
    }

    //! A live solve gives ever better maps, follows its steering, and ends when it is told to.
    void solvesLive()
    {
        const Cube cube;
        autocuts::LiveSolve live(cube.view(), draft());
        const std::optional<autocuts::Map> first = live.wait(60);
        QVERIFY(first && first->measure().flipped_triangles == 0);
        const std::vector<autocuts::Pin> pins{{5, 3, 4, 0}};
        autocuts::Mesh mesh = cube.view();
        mesh.pins = pins;
        live.steer(mesh, draft());
        const std::optional<autocuts::Map> pinned = live.wait(60);
        QVERIFY(pinned && std::abs(pinned->uvs()[10] - 3) < 1e-9 && std::abs(pinned->uvs()[11] - 4) < 1e-9);
        while (live.wait(60)) {
        }
        QVERIFY(live.rests());
        Cube other;
        other.indices[0] = 4;
        QVERIFY_THROWS_EXCEPTION(autocuts::Error, live.steer(other.view(), draft()));
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
