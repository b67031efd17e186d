// Textures that are carried over to another map: how well, which files, which sets, and what goes wrong.
#include "commands/edittextures.h"
#include "commands/journalrecorder.h"
#include "commands/replay.h"
#include "commands/setuvs.h"
#include "jobs/carriedsurface.h"
#include "jobs/carrytextures.h"
#include "jobs/shadedscene.h"
#include "model/io/meshes/meshfile.h"
#include "model/pictures/texturefiles.h"
#include "solver/bake/carrying.h"
#include "support/cliruns.h"
#include "support/mappedmodels.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

namespace tst_carry {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::MappedModel;

namespace {

using Channel = TextureChannel;

//! A box whose sides are islands, the whole map turned about the middle of its tile and scaled.
MappedModel mappedBox(double degrees = 0, double scale = 1, bool triangles = false)
{
    const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180);
    return test::mapped(test::box(4, Vec3(2, 2, 2), triangles), [=](const Vec3 &p, const Vec3 &centre) {
        const Vec2 middle(0.5, 0.5);
        return Vec2(middle + scale * (turn * (test::boxMap()(p, centre) - middle)));
    });
}

Scene sceneOf(const MappedModel &model, int materials = 1)
{
    Scene scene;
    scene.mesh = model.mesh;
    scene.objectNames = {u"box"_s};
    for (int m = 0; m < materials; ++m)
        scene.materialNames.push_back(u"m%1"_s.arg(m));
    for (int f = 0; f < model.mesh->faceCount(); ++f)
        scene.faceMaterial.push_back(f * materials / model.mesh->faceCount());
    scene.uvSets = {{u"UVMap"_s, model.uv}};
    return scene;
}

//! Details up to a fifth of a wave per texel, and discs with sharp borders, smoothed over a texel.
Picture detailed(int size)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(0, 1);
    struct Wave
    {
        double x, y, phase;
    };
    std::vector<Wave> waves;
    for (int i = 0; i < 60; ++i) {
        const double angle = 2 * std::numbers::pi * any(random), frequency = 0.2 * std::sqrt(any(random));
        waves.push_back({2 * std::numbers::pi * frequency * std::cos(angle),
                         2 * std::numbers::pi * frequency * std::sin(angle), 7 * any(random)});
    }
    std::vector<Vec3> discs;
    for (int i = 0; i < 60; ++i)
        discs.emplace_back(size * any(random), size * any(random), size * (0.01 + 0.04 * any(random)));
    Picture picture(size, size, 3);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            double value = 0.5;
            for (const Wave &wave : waves)
                value += 0.03 * std::sin(wave.x * x + wave.y * y + wave.phase);
            for (const Vec3 &disc : discs) {
                const double inside = disc.z() - std::hypot(x - disc.x(), y - disc.y());
                value += 0.1 * std::clamp(inside / 2 + 0.5, 0.0, 1.0);
            }
            for (int k = 0; k < 3; ++k)
                picture.at(x, y)[k] = std::round(255 * std::clamp(float(value) - 0.1F * k, 0.0F, 1.0F)) / 255;
        }
    }
    return picture;
}

Picture carriedOnce(const Scene &from, const Scene &to, const Picture &picture, TextureKind kind, int size)
{
    CarriedSurface source = carriedSurface(from, to, 1);
    const bake::CarryModel model{shadedSurface(to), std::move(source.surface), source.sameTriangles};
    const bake::CarryTexture texture{{{}, std::make_shared<const Picture>(picture)}, kind, {}, size, size};
    Picture result;
    carryTexture(
        model, texture,
        [&](int, const Picture &made) {
            result = made;
            return true;
        },
        JobContext());
    for (float &value : result.values)
        value = std::round(255 * value) / 255; // as a file of 8 bits has it
    return result;
}

//! Peak signal to noise in decibels, over the texels inside of islands.
double quality(const Scene &scene, const Picture &a, const Picture &b)
{
    bake::TexelGrid grid;
    grid.width = a.width;
    grid.height = a.height;
    const bake::TexelSurface texels(*scene.mesh, scene.uvSets.front().uv, grid);
    double sum = 0;
    long long count = 0;
    for (int band = 0; band < texels.bandCount(); ++band) {
        bake::TexelRows rows;
        texels.makeBand(band, rows);
        for (int i = 0; i < rows.count * a.width; ++i) {
            if (!rows.inside[i])
                continue;
            for (int k = 0; k < a.channels; ++k) {
                const std::size_t place = std::size_t(k);
                const double difference = a.at(i % a.width, rows.first + i / a.width)[place] -
                                          b.at(i % a.width, rows.first + i / a.width)[place];
                sum += difference * difference;
                ++count;
            }
        }
    }
    return -10 * std::log10(sum / double(count));
}

//! A document with two materials; the files of its pictures lie in a folder.
DocumentState texturedState(const QString &folder)
{
    DocumentState state = DocumentState::initial(sceneOf(mappedBox(), 2));
    state.scene.path = folder + u"/box.obj"_s;
    const auto file = [&](const char *name) {
        return ChannelPicture{{folder + u'/' + QLatin1StringView(name), {}}, -1, false, 1, false};
    };
    const auto component = [&](const char *name, int number) {
        ChannelPicture picture = file(name);
        picture.component = number;
        return picture;
    };
    TextureSet first{{Channel::BaseColor, file("a_BaseColor.png")},
                     {Channel::Roughness, component("a_ORM.png", 1)},
                     {Channel::Metalness, component("a_ORM.png", 2)},
                     {Channel::Normal, file("shared_Normal.tif")}};
    TextureSet second{{Channel::BaseColor, file("b_BaseColor.png")},
                      {Channel::Normal, file("shared_Normal.tif")},
                      {Channel::Height, ChannelPicture{{}, -1, false, 0.5, false}}};
    state.textureSets = {{}, first, second};
    return state;
}

} // namespace

class TestCarry : public QObject, private test::OwnFolder
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void detailsSurvive_data();
    void detailsSurvive();
    void largerTexelsAreMeans();
    void gapsStayOutside();
    void normalsTurnWithTheirIslands();
    void trianglesInAnotherOrder();
    void plans();
    void tiledNames();
    void tilesAreFilled();
    void freeNames();
    void setsAreKept();
    void materialsKeepApart();
    void nothingHalfIsWritten();
    void theMapOfTextures();
    void commandLineCarriesAll();
    void commandLineKeepsSources();

private:
    void writePictures(const QString &folder, int size = 32) const;
};

void TestCarry::initTestCase()
{
    writePictures(mFolder.path());
}

void TestCarry::writePictures(const QString &folder, int size) const
{
    QVERIFY(QDir().mkpath(folder));
    const auto write = [&](const char *name, PictureDepth depth, std::array<float, 3> color) {
        Picture picture(size, size, 3);
        for (int i = 0; i < size * size; ++i)
            std::ranges::copy(color, picture.at(i % size, i / size).begin());
        QVERIFY(writePicture(picture, folder + u'/' + QLatin1StringView(name), depth).ok());
    };
    write("a_BaseColor.png", PictureDepth::Eight, {1, 0, 0});
    write("b_BaseColor.png", PictureDepth::Eight, {0, 0, 1});
    write("a_ORM.png", PictureDepth::Eight, {1, 0.5F, 0.25F});
    write("shared_Normal.tif", PictureDepth::Sixteen, {0.5F, 0.5F, 1});
}

void TestCarry::detailsSurvive_data()
{
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("scale");
    QTest::addColumn<int>("size");
    QTest::addColumn<double>("decibels");
    QTest::newRow("turned by 30 degrees, as many texels") << 30.0 << 0.7 << 768 << 46.0;
    QTest::newRow("turned by 17 degrees, larger texels") << 17.0 << 0.7 << 640 << 44.0;
    QTest::newRow("twice the texels") << 41.0 << 0.7 << 1462 << 47.0;
}

void TestCarry::detailsSurvive()
{
    QFETCH(double, degrees);
    QFETCH(double, scale);
    QFETCH(int, size);
    QFETCH(double, decibels);
    const Scene before = sceneOf(mappedBox()), after = sceneOf(mappedBox(degrees, scale));
    const Picture picture = detailed(512);
    const Picture there = carriedOnce(before, after, picture, TextureKind::Linear, size);
    const Picture back = carriedOnce(after, before, there, TextureKind::Linear, 512);
    const double reached = quality(before, picture, back);
    qInfo("%.2f dB", reached);
    QVERIFY(reached > decibels);
}

//! A texel that covers many old ones is their mean, not one of them.
void TestCarry::largerTexelsAreMeans()
{
    Picture checks(512, 512, 1);
    for (int i = 0; i < 512 * 512; ++i)
        checks.at(i % 512, i / 512)[0] = float((i % 512 + i / 512) % 2);
    const Scene before = sceneOf(mappedBox()), after = sceneOf(mappedBox(0, 0.5));
    const Picture there = carriedOnce(before, after, checks, TextureKind::Linear, 256);
    QCOMPARE(there.channels, 1);
    double most = 0;
    for (int i = 0; i < 256 * 256; ++i)
        most = std::max(most, std::abs(there.at(i % 256, i / 256)[0] - 0.5) * (there.values[i] > 0));
    QVERIFY2(most < 0.1, qPrintable(QString::number(most)));
}

//! A picture without margins: nothing of the black between islands gets into them.
void TestCarry::gapsStayOutside()
{
    const Scene before = sceneOf(mappedBox()), after = sceneOf(mappedBox(30, 0.9));
    const auto insideOf = [](const Scene &scene, int size) {
        Picture inside(size, size, 1);
        bake::TexelGrid grid;
        grid.width = grid.height = size;
        const bake::TexelSurface texels(*scene.mesh, scene.uvSets.front().uv, grid);
        for (int band = 0; band < texels.bandCount(); ++band) {
            bake::TexelRows rows;
            texels.makeBand(band, rows);
            for (int i = 0; i < rows.count * size; ++i)
                inside.at(i % size, rows.first + i / size)[0] = rows.inside[i];
        }
        return inside;
    };
    Picture picture = insideOf(before, 256);
    for (float &value : picture.values)
        value *= 0.8F;
    const Picture there = carriedOnce(before, after, picture, TextureKind::Linear, 256);
    const Picture inside = insideOf(after, 256);
    for (std::size_t i = 0; i < inside.values.size(); ++i) {
        if (inside.values[i] > 0)
            QVERIFY2(std::abs(there.values[i] - 0.8F) < 0.01F, qPrintable(QString::number(there.values[i])));
    }
}

void TestCarry::normalsTurnWithTheirIslands()
{
    Picture leaning(64, 64, 3);
    const Vec3 normal = Vec3(0.6, 0, 0.8);
    for (int i = 0; i < 64 * 64; ++i) {
        for (int k = 0; k < 3; ++k)
            leaning.at(i % 64, i / 64)[k] = float(0.5 + 0.5 * normal[k]);
    }
    const Scene before = sceneOf(mappedBox()), after = sceneOf(mappedBox(90));
    for (const TextureKind kind : {TextureKind::Normal, TextureKind::NormalDirectX}) {
        const Picture turned = carriedOnce(before, after, leaning, kind, 64);
        const float up = kind == TextureKind::Normal ? 1.0F : -1.0F;
        // The middle of an island: what leant to the right leans up.
        const auto texel = turned.at(50, 63 - 12);
        QVERIFY(std::abs(texel[0] - 0.5F) < 0.01F);
        QVERIFY(std::abs(up * (texel[1] - 0.5F) - 0.3F) < 0.01F);
    }
}

void TestCarry::trianglesInAnotherOrder()
{
    const MappedModel model = mappedBox(0, 1, true), turned = mappedBox(30, 0.7, true);
    const MeshData &mesh = *model.mesh;
    QByteArray obj;
    for (int v = mesh.vertexCount() - 1; v >= 0; --v)
        obj += "v " + QByteArray::number(mesh.positions(v, 0)) + ' ' +
               QByteArray::number(mesh.positions(v, 1)) + ' ' + QByteArray::number(mesh.positions(v, 2)) +
               '\n';
    for (int c = 0; c < mesh.cornerCount(); ++c)
        obj += "vt " + QByteArray::number(model.uv(c, 0), 'g', 12) + ' ' +
               QByteArray::number(model.uv(c, 1), 'g', 12) + '\n';
    for (int f = mesh.faceCount() - 1; f >= 0; --f) {
        obj += 'f';
        for (int k = 1; k <= 3; ++k) {
            const int corner = mesh.faceStart[f] + k % 3;
            obj += ' ' + QByteArray::number(mesh.vertexCount() - mesh.cornerVertex[corner]) + '/' +
                   QByteArray::number(corner + 1);
        }
        obj += '\n';
    }
    const Result<Scene> reordered = readMesh(file("reordered.obj", obj), nullptr);
    QVERIFY(reordered.ok());
    const Scene after = sceneOf(turned);
    const CarriedSurface source = carriedSurface(reordered.value(), after, 1);
    QVERIFY(source.sameTriangles);
    QCOMPARE(source.surface.mesh.get(), after.mesh.get());
    QVERIFY((source.surface.uv - model.uv).cwiseAbs().maxCoeff() < 1e-9);
    // Another shape is found by rays.
    QVERIFY(!carriedSurface(sceneOf(mappedBox(0, 1, false)), after, 1).sameTriangles);
}

void TestCarry::plans()
{
    const DocumentState state = texturedState(mFolder.path());
    const jobs::CarryPlan plan = jobs::planCarrying(state, {mFolder.path(), u"_uv2"_s, false, {}});
    QVERIFY(plan.missing.isEmpty());
    QStringList names;
    for (const jobs::CarriedPicture &picture : plan.pictures)
        names << QFileInfo(picture.newFile).fileName();
    QCOMPARE(names, (QStringList{u"a_BaseColor_uv2.png"_s, u"a_ORM_uv2.png"_s, u"shared_Normal_uv2.tif"_s,
                                 u"b_BaseColor_uv2.png"_s}));
    QCOMPARE(plan.pictures[1].channels, (std::vector{Channel::Roughness, Channel::Metalness}));
    QCOMPARE(plan.pictures[2].materials, (std::vector{0, 1}));
    QVERIFY(plan.pictures[2].kind == TextureKind::Normal);
    QVERIFY(plan.overwrittenSource().isEmpty());
    QVERIFY(!jobs::planCarrying(state, {mFolder.path(), {}, false, {}}).overwrittenSource().isEmpty());
    // Names that end so already get the new number.
    DocumentState again = state;
    again.textureSets = jobs::carriedSets(state, plan);
    writePictures(mFolder.filePath(u"uv2"_s));
    for (TextureSet &set : again.textureSets) {
        for (auto &[channel, entry] : set) {
            if (channel == Channel::BaseColor)
                QVERIFY(QFile::copy(at("a_BaseColor.png"), entry.picture.file));
        }
    }
    const jobs::CarryPlan second = jobs::planCarrying(again, {mFolder.path(), u"_uv3"_s, false, {}});
    QVERIFY(second.pictures.front().newFile.endsWith(u"/a_BaseColor_uv3.png"_s));
    QCOMPARE(second.missing, (QStringList{u"a_ORM_uv2.png"_s, u"shared_Normal_uv2.tif"_s}));
    for (const char *name : {"a_BaseColor_uv2.png", "b_BaseColor_uv2.png"})
        QVERIFY(QFile::remove(at(name)));
}

void TestCarry::tiledNames()
{
    const QString folder = mFolder.filePath(u"tiled"_s);
    QVERIFY(QDir().mkpath(folder));
    for (const char *name : {"c_BaseColor.1001.png", "c_BaseColor.1002.png"})
        QVERIFY(QFile::copy(at("a_BaseColor.png"), folder + u'/' + QLatin1StringView(name)));
    DocumentState state = DocumentState::initial(sceneOf(mappedBox()));
    const ChannelPicture picture{{folder + u"/c_BaseColor.<UDIM>.png"_s, {}}, -1, false, 1, false};
    state.textureSets = {{}, {{Channel::BaseColor, picture}}};
    const jobs::CarryPlan plan = jobs::planCarrying(state, {folder, u"_uv2"_s, false, {}});
    QCOMPARE(QFileInfo(plan.pictures.at(0).newFile).fileName(), u"c_BaseColor_uv2.<UDIM>.png"_s);
    QVERIFY(plan.existingFiles().isEmpty());
    // A single picture that becomes several.
    const jobs::CarryPlan several =
        jobs::planCarrying(texturedState(mFolder.path()), {folder, u"_x"_s, true, u"tga"_s});
    QCOMPARE(QFileInfo(several.pictures.at(0).newFile).fileName(), u"a_BaseColor_x.<UDIM>.tga"_s);
}

//! A map in one tile becomes one in two: each has the picture of its own islands.
void TestCarry::tilesAreFilled()
{
    DocumentState state = texturedState(mFolder.path());
    const QString folder = mFolder.filePath(u"two"_s);
    QVERIFY(QDir().mkpath(folder));
    Scene after = sceneOf(mappedBox(), 2);
    UvMatrix &uv = after.uvSets.front().uv;
    for (int c = after.mesh->cornerCount() / 2; c < after.mesh->cornerCount(); ++c)
        uv(c, 0) += 1; // the second material
    const bake::CarryModel model{shadedSurface(after), shadedSurface(state.scene), true, {}, 2};
    const Result<jobs::CarriedFiles> files = jobs::carryPictures(
        jobs::planCarrying(state, {folder, {}, true, {}}), after.faceMaterial, model, {}, {});
    QVERIFY(files.ok());
    QStringList names;
    for (const QString &file : files->files)
        names << QFileInfo(file).fileName();
    QCOMPARE(names, (QStringList{u"a_BaseColor.1001.png"_s, u"a_ORM.1001.png"_s, u"shared_Normal.1001.tif"_s,
                                 u"shared_Normal.1002.tif"_s, u"b_BaseColor.1002.png"_s}));
    QCOMPARE(textureTiles(jobs::carriedSets(state, files->plan)[1].at(Channel::Normal).picture.file).size(),
             std::size_t(2));
}

void TestCarry::freeNames()
{
    const DocumentState state = texturedState(mFolder.path());
    const QString folder = mFolder.filePath(u"free"_s);
    QVERIFY(QDir().mkpath(folder));
    const jobs::CarryTarget target{folder, {}, false, {}};
    QCOMPARE(jobs::freeSuffix(state, target), u"_uv2"_s);
    QVERIFY(QFile::copy(at("a_ORM.png"), folder + u"/a_ORM_uv2.png"_s));
    QCOMPARE(jobs::freeSuffix(state, target), u"_uv3"_s);
}

void TestCarry::setsAreKept()
{
    const DocumentState state = texturedState(mFolder.path());
    const jobs::CarryPlan plan = jobs::planCarrying(state, {mFolder.path(), u"_uv2"_s, false, {}});
    const std::vector<TextureSet> sets = jobs::carriedSets(state, plan);
    QCOMPARE(sets.size(), state.textureSets.size());
    QCOMPARE(sets[1].at(Channel::Metalness).component, 2);
    QVERIFY(sets[1].at(Channel::Metalness).picture.file.endsWith(u"/a_ORM_uv2.png"_s));
    QCOMPARE(sets[2].at(Channel::Normal).picture.file, sets[1].at(Channel::Normal).picture.file);
    QVERIFY(sets[2].at(Channel::Height) == state.textureSets[2].at(Channel::Height)); // has no picture
}

//! A picture shows its own materials only, although all faces lie in one tile.
void TestCarry::materialsKeepApart()
{
    const DocumentState state = texturedState(mFolder.path());
    const QString folder = mFolder.filePath(u"apart"_s);
    QVERIFY(QDir().mkpath(folder));
    const Scene after = sceneOf(mappedBox(90), 2);
    const bake::CarryModel model{shadedSurface(after), shadedSurface(state.scene), true, {}, 2};
    const Result<jobs::CarriedFiles> files = jobs::carryPictures(
        jobs::planCarrying(state, {folder, {}, false, {}}), after.faceMaterial, model, {}, {});
    QVERIFY(files.ok());
    QCOMPARE(files->files.size(), 4);
    const Result<Picture> a = readPicture(folder + u"/a_BaseColor.png"_s),
                          b = readPicture(folder + u"/b_BaseColor.png"_s);
    QVERIFY(a.ok() && b.ok());
    int red = 0, blue = 0;
    for (int i = 0; i < 32 * 32; ++i) {
        const bool isRed = a->at(i % 32, i / 32)[0] > 0.9F, isBlue = b->at(i % 32, i / 32)[2] > 0.9F;
        red += isRed;
        blue += isBlue;
    }
    QVERIFY(red > 100 && blue > 100 && red + blue < 32 * 32);
    const QString normal = folder + u"/shared_Normal.tif"_s;
    QCOMPARE(decodePicture(test::readBytes(normal), normal)->depth, PictureDepth::Sixteen);
}

void TestCarry::nothingHalfIsWritten()
{
    const DocumentState state = texturedState(mFolder.path());
    const QString folder = mFolder.filePath(u"half"_s);
    QVERIFY(QDir().mkpath(folder));
    const jobs::CarryPlan plan = jobs::planCarrying(state, {folder, {}, false, {}});
    const Scene after = sceneOf(mappedBox(), 2);
    const bake::CarryModel model{shadedSurface(after), shadedSurface(state.scene), true, {}, 2};
    const auto names = [&] {
        return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    };
    std::atomic<bool> stop = false;
    const JobContext untilHalf(&stop, 1,
                               [&stop](const JobProgress &progress) { stop = progress.fraction >= .5; });
    const Result<jobs::CarriedFiles> stopped =
        jobs::carryPictures(plan, after.faceMaterial, model, {}, untilHalf);
    QVERIFY(stopped.ok() && stopped->stopped);
    QCOMPARE(stopped->plan.pictures.size(), std::size_t(2));
    QVERIFY2(names().isEmpty(), qPrintable(names().join(u',')));
    // A picture that cannot be read is left out, the others are made.
    const QString broken = mFolder.filePath(u"broken"_s);
    writePictures(broken);
    QVERIFY(test::writeBytes(broken + u"/a_ORM.png"_s, "no picture"));
    const DocumentState other = texturedState(broken);
    const Result<jobs::CarriedFiles> partly = jobs::carryPictures(
        jobs::planCarrying(other, {folder, {}, false, {}}), after.faceMaterial, model, {}, {});
    QVERIFY(partly.ok());
    QCOMPARE(partly->files.size(), 3);
    QCOMPARE(partly->problems.size(), 1);
    QVERIFY(partly->problems.front().contains(u"a_ORM.png"_s));
    QVERIFY(jobs::carriedSets(other, partly->plan)[1].at(Channel::Roughness) ==
            other.textureSets[1].at(Channel::Roughness));
    QCOMPARE(names().size(), 3);
    QVERIFY(!jobs::carryPictures({}, {}, model, {}, {}).ok());
    // Where all are needed, none is made.
    const QString all = mFolder.filePath(u"all"_s);
    QVERIFY(QDir().mkpath(all));
    const Result<jobs::CarriedFiles> refused = jobs::carryPictures(
        jobs::planCarrying(other, {all, {}, false, {}}), after.faceMaterial, model, {.needsAll = true}, {});
    QVERIFY(!refused);
    QVERIFY(QDir(all).isEmpty());
}

void TestCarry::theMapOfTextures()
{
    Document document(texturedState(mFolder.path()));
    JournalRecorder recorder(document);
    const UvMatrix first = document.uv();
    const auto move = [&](double by) {
        UvMatrix moved = document.uv();
        moved.array() += by;
        pushCommand(std::make_unique<SetUvs>(document, UvEdit::Transfer, moved));
    };
    move(0.01);
    QVERIFY(*mapOfTextures(recorder.journal()) == first);
    const UvMatrix second = document.uv();
    std::vector<TextureSet> sets = document.state().textureSets;
    sets[1][Channel::BaseColor].picture.file = at("b_BaseColor.png");
    pushCommand(std::make_unique<EditTextures>(document, sets, EditTextures::Origin::Carried));
    move(0.01);
    QVERIFY(*mapOfTextures(recorder.journal()) == second);
    // Another picture is for the same map as the others.
    sets[1][Channel::BaseColor].factor = 0.5;
    pushCommand(std::make_unique<EditTextures>(document, sets));
    QVERIFY(*mapOfTextures(recorder.journal()) == second);
    document.undoStack().undo();
    document.undoStack().undo();
    document.undoStack().undo();
    QVERIFY(*mapOfTextures(recorder.journal()) == first);
    // The first pictures of all are for the map that is there.
    pushCommand(std::make_unique<EditTextures>(document, std::vector<TextureSet>()));
    pushCommand(std::make_unique<EditTextures>(document, sets));
    QVERIFY(*mapOfTextures(recorder.journal()) == document.uv());
}

void TestCarry::commandLineCarriesAll()
{
    const QString folder = mFolder.filePath(u"cli"_s);
    writePictures(folder, 64);
    Scene before = sceneOf(mappedBox(), 2), after = sceneOf(mappedBox(90), 2);
    before.materialTextures = {{u"a_BaseColor.png"_s, {}}, {u"b_BaseColor.png"_s, {}}};
    QVERIFY(writeMesh(before, folder + u"/before.obj"_s).ok());
    QVERIFY(test::writeBytes(folder + u"/before.mtl"_s,
                             "newmtl m0\nmap_Kd a_BaseColor.png\nmap_Pr a_ORM.png\nnewmtl m1\n"
                             "map_Kd b_BaseColor.png\nnorm shared_Normal.tif\nmap_Ke gone.png\n"));
    QByteArray obj = test::readBytes(folder + u"/before.obj"_s);
    if (!obj.contains("mtllib"))
        QVERIFY(test::writeBytes(folder + u"/before.obj"_s, "mtllib before.mtl\n" + obj));
    QVERIFY(writeMesh(after, folder + u"/after.obj"_s).ok());
    const test::CliRun run = test::runInProcess(
        {u"transfer"_s, folder + u"/after.obj"_s, u"--from"_s, folder + u"/before.obj"_s, u"--textures"_s,
         u"all"_s, u"-o"_s, folder + u"/new"_s, u"--report"_s, folder + u"/report.json"_s});
    QVERIFY2(run.code == 0, qPrintable(run.err));
    QVERIFY2(run.err.contains(u"gone.png"_s), qPrintable(run.err));
    const QJsonObject report = QJsonDocument::fromJson(test::readBytes(folder + u"/report.json"_s)).object();
    QCOMPARE(report.value(u"files"_s).toArray().size(), 4);
    for (const char *name : {"a_BaseColor.png", "b_BaseColor.png", "a_ORM.png", "shared_Normal.tif"})
        QVERIFY2(readPicture(folder + u"/new/"_s + QLatin1StringView(name)).ok(), name);
}

//! The new pictures have the names of the old ones, which they must not replace.
void TestCarry::commandLineKeepsSources()
{
    const QString folder = mFolder.filePath(u"same"_s);
    writePictures(folder);
    QVERIFY(writeMesh(sceneOf(mappedBox()), folder + u"/before.obj"_s).ok());
    QVERIFY(writeMesh(sceneOf(mappedBox(90)), folder + u"/after.obj"_s).ok());
    const QByteArray source = test::readBytes(folder + u"/a_ORM.png"_s);
    const test::CliRun run =
        test::runInProcess({u"transfer"_s, folder + u"/after.obj"_s, u"--from"_s, folder + u"/before.obj"_s,
                            u"--textures"_s, folder + u"/a_ORM.png"_s, u"-o"_s, folder});
    QCOMPARE(run.code, 1);
    QVERIFY2(run.err.contains(u"overwrite"_s), qPrintable(run.err));
    QCOMPARE(test::readBytes(folder + u"/a_ORM.png"_s), source);
    // A model without textures.
    const test::CliRun none =
        test::runInProcess({u"transfer"_s, folder + u"/after.obj"_s, u"--from"_s, folder + u"/before.obj"_s,
                            u"--textures"_s, u"all"_s, u"-o"_s, folder + u"/none"_s});
    QCOMPARE(none.code, 1);
    QVERIFY2(none.err.contains(u"no pictures"_s), qPrintable(none.err));
}

QTEST_GUILESS_MAIN(TestCarry)

} // namespace tst_carry

#include "tst_carry.moc"
