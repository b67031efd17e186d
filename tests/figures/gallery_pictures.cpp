// Draws the gallery: maps made by the command line, in the studio's views.
//
//   gallery_pictures TABLE MAPS FOLDER
//
// TABLE: scripts/gallery.csv. MAPS: for each line NAME.SUFFIX with UVs, NAME.json (its report) and
// NAME.seconds. FOLDER: gets gallery.md and gallery/NAME.png. Lines without a map are left out.
// scripts/gallery runs it.
#include "figures/picturesheet.h"
#include "figures/studiopictures.h"
#include "model/io/meshes/meshfile.h"
#include "views/ui/theme.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QPainter>
#include <QSurfaceFormat>
#include <QTextStream>

#include <cmath>
#include <stdexcept>

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr QSize half(441, 400); // of a picture of 900 pixels: model and map

//! A line of the table.
struct Entry
{
    QString name, file, kind;
    figures::Look look;
    figures::UpAxis up;
};

//! What the report says of a map.
struct Numbers
{
    int triangles, islands;
    double distortion, seamLength, efficiency, seconds;
};

std::runtime_error failure(const QString &text)
{
    return std::runtime_error(text.toStdString());
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        throw failure(u"cannot read "_s + path);
    return file.readAll();
}

figures::UpAxis upAxisOf(const QString &text)
{
    using enum figures::UpAxis;
    return text == u"x"_s ? X : text == u"z"_s ? Z : text == u"-y"_s ? MinusY : Y;
}

std::vector<Entry> readTable(const QString &path)
{
    std::vector<Entry> entries;
    const QStringList lines = QString::fromUtf8(contentOf(path)).split(u'\n', Qt::SkipEmptyParts);
    for (const QString &line : lines.mid(1)) {
        const QStringList values = line.split(u',');
        if (values.size() != 6)
            throw failure(u"not 6 values: "_s + line);
        entries.push_back({values[0],
                           values[1],
                           values[2],
                           {values[3].toDouble(), values[4].toDouble()},
                           upAxisOf(values[5])});
    }
    return entries;
}

Numbers numbersOf(const QDir &maps, const QString &name)
{
    const QJsonObject report = QJsonDocument::fromJson(contentOf(maps.filePath(name + u".json"_s))).object();
    return {report[u"triangles"_s].toInt(),
            report[u"charts"_s].toInt(),
            report[u"sym_dirichlet"_s].toDouble(),
            report[u"seam_norm"_s].toDouble(),
            report[u"packing_efficiency"_s].toDouble(),
            contentOf(maps.filePath(name + u".seconds"_s)).trimmed().toDouble()};
}

QString sentence(const QString &text)
{
    return text.left(1).toUpper() + text.mid(1);
}

class Gallery
{
public:
    Gallery(const QDir &maps, const QDir &folder) : mMaps(maps), mFolder(folder) {}

    void add(const Entry &entry)
    {
        const QStringList files = mMaps.entryList({entry.name + u".obj"_s, entry.name + u".glb"_s});
        if (files.isEmpty() || !mMaps.exists(entry.name + u".json"_s))
            return;
        Result<Scene> scene = readMesh(mMaps.filePath(files.first()));
        if (!scene)
            throw failure(scene.error().toString());
        const Numbers numbers = numbersOf(mMaps, entry.name);
        draw(entry, std::move(scene.value()), numbers);
        const QLocale c = QLocale(QLocale::English);
        mRows << u"| [%1](#%1) | %2 | %3 | %4 | %5 | %6 | %7 | %8 |"_s.arg(entry.name, entry.kind)
                     .arg(c.toString(numbers.triangles), c.toString(numbers.distortion, 'f', 3),
                          c.toString(numbers.seamLength, 'f', 2))
                     .arg(numbers.islands)
                     .arg(c.toString(numbers.efficiency, 'f', 3), c.toString(numbers.seconds, 'f', 1));
        mPictures << u"## %1\n\n![%2, %3: the model with a checkerboard, and its map](gallery/%1.png)\n"_s
                         .arg(entry.name, sentence(entry.name), entry.kind);
    }

    void writePage()
    {
        QFile page(mFolder.filePath(u"gallery.md"_s));
        if (!page.open(QIODevice::WriteOnly))
            throw failure(u"cannot write "_s + page.fileName());
        QTextStream(&page)
            << "# Gallery\n\n"
               "`scripts/gallery` makes this page: maps by `autocuts-cli unwrap` with no option, so of "
               "standard\n"
               "quality with a mean distortion D of at most 4.1 (4 is none), drawn by the studio's views. "
               "Red\n"
               "lines are seams; each island has the same colour on the model and in the map. The seam "
               "length is\n"
               "for a surface of area pi, the efficiency the covered part of the texture. Seconds are CPU "
               "time of\n"
               "all threads, files included; on a machine that others use at the same time they are more.\n\n"
               "| model | kind | triangles | D | seam length | islands | efficiency | CPU s |\n"
               "|---|---|---|---|---|---|---|---|\n"
            << mRows.join(u'\n') << "\n\n"
            << mPictures.join(u'\n');
    }

private:
    void draw(const Entry &entry, Scene scene, const Numbers &numbers)
    {
        mStudio.open(std::move(scene), entry.up);
        ViewOptions &options = mStudio.options();
        options.coloring = Coloring::Islands;
        options.pattern = Pattern::Checker;
        options.checkerSize = figures::fittingCheckerSize(mStudio.document().mesh(), mStudio.document().uv());
        const QImage model = mStudio.model(half, entry.look);
        options.pattern = Pattern::None;
        const QImage map = mStudio.map(half);
        const QLocale c = QLocale(QLocale::English);
        const QString text = u"%1 triangles · D %2 · seam length %3 · %4 %5 · efficiency %6 % · %7 s of CPU"_s
                                 .arg(c.toString(numbers.triangles), c.toString(numbers.distortion, 'f', 3),
                                      c.toString(numbers.seamLength, 'f', 2))
                                 .arg(numbers.islands)
                                 .arg(numbers.islands == 1 ? u"island"_s : u"islands"_s)
                                 .arg(std::lround(100 * numbers.efficiency))
                                 .arg(c.toString(numbers.seconds, 'f', 1));
        QImage both(2 * half.width() + 6, half.height(), QImage::Format_RGB32);
        both.fill(0xff1e2023);
        QPainter painter(&both);
        painter.drawImage(0, 0, model);
        painter.drawImage(half.width() + 6, 0, map);
        painter.end();
        const QString path = mFolder.filePath(u"gallery/"_s + entry.name + u".png"_s);
        if (!figures::saveSmall(
                figures::sheetOf({{{both}, sentence(entry.name) + u", "_s + entry.kind, {text}}}), path))
            throw failure(u"cannot write "_s + path);
    }

    QDir mMaps, mFolder;
    figures::StudioPictures mStudio;
    QStringList mRows, mPictures;
};

} // namespace

int main(int argc, char *argv[])
{
    figures::prepareViews();
    QApplication application(argc, argv);
    applyTheme(application, Theme::Dark);
    const QStringList arguments = QApplication::arguments();
    QTextStream err(stderr);
    if (arguments.size() != 4) {
        err << "usage: gallery_pictures TABLE MAPS FOLDER\n";
        return 2;
    }
    try {
        const QDir folder(arguments[3]);
        if (!folder.mkpath(u"gallery"_s))
            throw failure(u"cannot make "_s + folder.filePath(u"gallery"_s));
        Gallery gallery{QDir(arguments[2]), folder};
        for (const Entry &entry : readTable(arguments[1]))
            gallery.add(entry);
        gallery.writePage();
        return 0;
    } catch (const std::exception &e) {
        err << "gallery_pictures: " << e.what() << '\n';
        return 1;
    }
}
