#include "figures/bakefigures.h"

#include "figures/picturesheet.h"
#include "figures/studiopictures.h"
#include "model/io/meshfile.h"

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

Column columnOf(StudioPictures &studio, const QString &title, const QString &line)
{
    Column column;
    column.pictures = {studio.model(upright, look)};
    column.title = title;
    column.lines << line;
    return column;
}

} // namespace

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
    const auto triangles = [](const Document &document) {
        return QLocale(QLocale::English).toString(document.mesh().triangleCount()) + u" triangles"_s;
    };
    StudioPictures studio;
    studio.options().seams = false;
    std::vector<Column> columns;
    const QString ofFine = triangles(studio.open(read(fine)));
    columns.push_back(columnOf(studio, u"fine"_s, ofFine));
    const QString ofCoarse = triangles(studio.open(read(mapped)));
    columns.push_back(columnOf(studio, u"coarse"_s, ofCoarse));
    studio.options().pattern = Pattern::Texture;
    studio.options().texturePath = maps + u"/lucy_ao.png"_s;
    columns.push_back(columnOf(studio, u"with occlusion"_s, u"of the fine one"_s));
    Column normals;
    normals.pictures = {QImage(maps + u"/lucy_normal.png"_s)
                            .scaled(square, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                            .convertToFormat(QImage::Format_RGB32)};
    normals.title = u"its normal map"_s;
    normals.lines << u"tangent space, 1024 x 1024"_s;
    columns.push_back(normals);
    if (!saveSmall(sheetOf(columns), page.pathOf(figure)))
        throw std::runtime_error("cannot write " + page.pathOf(figure).toStdString());
    page.add(figure, u"lucy"_s, {QString(), u"triangles"_s},
             {{u"fine"_s, ofFine.section(u' ', 0, 0)}, {u"coarse"_s, ofCoarse.section(u' ', 0, 0)}});
}

} // namespace autocuts::figures
