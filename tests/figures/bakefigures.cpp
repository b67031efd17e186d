#include "figures/bakefigures.h"

#include "figures/paintedmodel.h"
#include "figures/picturesheet.h"
#include "figures/studiopictures.h"
#include "model/io/files/savefile.h"
#include "model/io/meshes/meshfile.h"

#include <QLocale>
#include <QProcess>
#include <QTemporaryDir>

#include <stdexcept>

namespace autocuts::figures {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr QSize upright(196, 340), square(340, 340);
constexpr Look look{20, 8};

//! Runs the command line. \throws std::runtime_error with what it said
void run(const QStringList &arguments)
{
    QProcess program;
    program.start(QStringLiteral(AUTOCUTS_CLI), QStringList(arguments) << u"--quiet"_s);
    if (!program.waitForFinished(-1) || program.exitStatus() != QProcess::NormalExit ||
        program.exitCode() != 0)
        throw std::runtime_error(program.readAllStandardError().toStdString());
}

Scene read(const QString &path)
{
    Result<Scene> scene = readMesh(path);
    if (!scene)
        throw std::runtime_error(scene.error().toString().toStdString());
    return std::move(scene.value());
}

Column columnOf(const QImage &picture, const QString &title, const QString &line)
{
    Column column;
    column.pictures = {picture};
    column.title = title;
    column.lines << line;
    return column;
}

//! A picture file, in the size of a column.
QImage textureOf(const QString &path, const QSize &size)
{
    return QImage(path)
        .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_RGB32);
}

void save(const FigurePage &page, const Figure &figure, const std::vector<Column> &columns)
{
    if (!saveSmall(sheetOf(columns), page.pathOf(figure)))
        throw std::runtime_error("cannot write " + page.pathOf(figure).toStdString());
}

QString trianglesOf(const Document &document)
{
    return QLocale(QLocale::English).toString(document.mesh().triangleCount());
}

} // namespace

void paintedSet(FigurePage &page, const Figure &figure)
{
    constexpr QSize texture(280, 280), view(480, 280);
    const QString plain = page.meshPath(u"organic/triceratops_param_closed.obj"_s);
    if (plain.isEmpty())
        return;
    const QTemporaryDir folder;
    const QString painted = folder.filePath(u"painted.obj"_s), mapped = folder.filePath(u"model.obj"_s);
    const QString maps = folder.filePath(u"maps"_s);
    const Scene fine = paintedModel(*read(plain).mesh, Vec3::UnitY());
    if (!saveAtomically(painted, coloredObj(fine)))
        throw std::runtime_error("cannot write the painted model");
    run({u"unwrap"_s, plain, u"-o"_s, mapped});
    run({u"bake"_s, mapped, u"--high"_s, painted, u"-o"_s, maps, u"--texture-size"_s, u"1024"_s, u"--maps"_s,
         u"normal,color"_s, u"--samples"_s, u"9"_s, u"--cage"_s, u"0.03"_s});
    Scene scene = read(mapped);
    scene.materialNames = {u"skin"_s};
    scene.faceMaterial.assign(std::size_t(scene.mesh->faceCount()), 0);
    scene.materialTextures = {{maps + u"/model_color.png"_s, {}}};
    TextureSet set;
    set[TextureChannel::Normal].picture.file = maps + u"/model_normal.png"_s;
    set[TextureChannel::Roughness].factor = 0.55;
    scene.materialSets = {set};
    StudioPictures studio;
    studio.options().seams = false;
    studio.options().pattern = Pattern::Physical;
    studio.options().exposure = 0.8;
    const QString triangles = trianglesOf(studio.open(std::move(scene)));
    Column left = columnOf(textureOf(maps + u"/model_normal.png"_s, texture), u"the texture set"_s,
                           u"normals, colours"_s);
    left.pictures.push_back(textureOf(maps + u"/model_color.png"_s, texture));
    Column right = columnOf(studio.model(view, {-125, 15}), u"the model with it"_s,
                            triangles + u" triangles, in light"_s);
    right.pictures.push_back(studio.model(view, {35, 25}));
    save(page, figure, {left, right});
    page.add(figure, u"triceratops"_s, {QString(), u"triangles"_s},
             {{u"unwrapped"_s, triangles},
              {u"painted"_s, QLocale(QLocale::English).toString(fine.mesh->triangleCount())}});
}

void detailBake(FigurePage &page, const Figure &figure)
{
    const QString fine = page.meshPath(u"large/lucy_o_f48275.obj"_s);
    const QString coarse = page.meshPath(u"large/lucy_o_f6032.obj"_s);
    if (fine.isEmpty() || coarse.isEmpty())
        return;
    const QTemporaryDir folder;
    const QString mapped = folder.filePath(u"lucy.obj"_s), maps = folder.filePath(u"maps"_s);
    run({u"unwrap"_s, coarse, u"-o"_s, mapped});
    run({u"bake"_s, mapped, u"--high"_s, fine, u"-o"_s, maps, u"--texture-size"_s, u"1024"_s, u"--maps"_s,
         u"normal,ao"_s});
    StudioPictures studio;
    studio.options().seams = false;
    std::vector<Column> columns;
    const QString ofFine = trianglesOf(studio.open(read(fine)));
    columns.push_back(columnOf(studio.model(upright, look), u"fine"_s, ofFine + u" triangles"_s));
    const QString ofCoarse = trianglesOf(studio.open(read(mapped)));
    columns.push_back(columnOf(studio.model(upright, look), u"coarse"_s, ofCoarse + u" triangles"_s));
    studio.options().pattern = Pattern::Texture;
    studio.options().texturePath = maps + u"/lucy_ao.png"_s;
    columns.push_back(columnOf(studio.model(upright, look), u"with occlusion"_s, u"of the fine one"_s));
    columns.push_back(columnOf(textureOf(maps + u"/lucy_normal.png"_s, square), u"its normal map"_s,
                               u"tangent space, 1024 x 1024"_s));
    save(page, figure, columns);
    page.add(figure, u"lucy, in two resolutions"_s, {QString(), u"triangles"_s},
             {{u"fine"_s, ofFine}, {u"coarse"_s, ofCoarse}});
}

void lightBake(FigurePage &page, const Figure &figure)
{
    constexpr QSize size(300, 300);
    constexpr Look fromAbove{30, 25};
    const QTemporaryDir folder;
    const QString plain = folder.filePath(u"plain.obj"_s), mapped = folder.filePath(u"machine.obj"_s);
    const QString light = folder.filePath(u"light.png"_s);
    run({u"sample"_s, u"machine"_s, u"-o"_s, plain});
    run({u"unwrap"_s, plain, u"-o"_s, mapped});
    run({u"lightbake"_s,      mapped,    u"-o"_s,          light,         u"--sun"_s,    u"150,35"_s,
         u"--sun-strength"_s, u"2.6"_s,  u"--sun-color"_s, u"1,.92,.8"_s, u"--sky"_s,    u"day"_s,
         u"--sky-strength"_s, u"0.14"_s, u"--albedo"_s,    u"0.7"_s,      u"--values"_s, u"lit"_s,
         u"--texture-size"_s, u"768"_s,  u"--samples"_s,   u"64"_s});
    StudioPictures studio;
    studio.options().seams = false;
    const QString triangles = trianglesOf(studio.open(read(mapped)));
    std::vector<Column> columns{
        columnOf(studio.model(size, fromAbove), u"without"_s, triangles + u" triangles"_s)};
    studio.options().pattern = Pattern::Texture;
    studio.options().texturePath = light;
    columns.push_back(columnOf(studio.model(size, fromAbove), u"with its light texture"_s, u"sun and sky"_s));
    columns.push_back(columnOf(textureOf(light, size), u"the texture"_s, u"768 x 768"_s));
    save(page, figure, columns);
    page.add(figure, u"the sample machine"_s, {QString(), u"triangles"_s}, {{u"machine"_s, triangles}});
}

} // namespace autocuts::figures
