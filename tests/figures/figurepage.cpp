#include "figures/figurepage.h"

#include "model/io/meshes/meshfile.h"
#include "model/samples/samples.h"

#include <QFile>
#include <QFileInfo>
#include <QLocale>

#include <stdexcept>

namespace autocuts::figures {

FigurePage::FigurePage(const QString &folder, const QString &meshes)
    : mFolder(folder), mMeshes(meshes), mStream(&mText)
{
    mStream
        << "# Figures of the paper, made by this program\n\n"
           "`scripts/figures` makes these pictures. On white, by the live solver alone (the triangle soup "
           "and "
           "its homotopy,\nwithout the seam search): above the surface, parted edges red; below the map, "
           "white "
           "where nothing is distorted,\nblue where the symmetric Dirichlet energy is 6 or more. On dark, by "
           "the studio's own views and tools.\nD: mean energy, 4 is isometric. Length: of the seams, for a "
           "surface of area pi.\n";
}

QString FigurePage::meshPath(const QString &file) const
{
    const QString path = mMeshes + QLatin1Char('/') + file;
    return !mMeshes.isEmpty() && QFileInfo(path).isFile() ? path : QString();
}

Scene FigurePage::scene(const QString &file, const QString &sample) const
{
    const QString path = meshPath(file);
    Result<Scene> scene = path.isEmpty() ? makeSample(sample) : readMesh(path);
    if (!scene)
        throw std::runtime_error(scene.error().toString().toStdString());
    return std::move(scene.value());
}

Model FigurePage::model(const QString &file, const QString &sample) const
{
    const Scene scene = this->scene(file, sample);
    return {scene.path.isEmpty() ? sample : QFileInfo(file).completeBaseName(), scene.mesh};
}

QString FigurePage::pathOf(const Figure &figure) const
{
    return mFolder + QLatin1Char('/') + QString::fromUtf8(figure.file);
}

void FigurePage::add(const Figure &figure, const QString &mesh, const QStringList &head,
                     const std::vector<QStringList> &rows)
{
    const QString title =
        QStringLiteral("Figure %1: %2").arg(figure.number).arg(QString::fromUtf8(figure.title));
    const auto rowOf = [](const QStringList &cells) {
        return QStringLiteral("| ") + cells.join(QStringLiteral(" | ")) + QStringLiteral(" |\n");
    };
    mStream << "\n## " << title << "\n\n![" << title << "](" << figure.file << ")\n\n"
            << "The paper: " << figure.paper << "\n\nHere: " << figure.steps << "\nMesh: " << mesh << ".\n\n"
            << rowOf(head) << '|' << QStringLiteral("---|").repeated(head.size()) << '\n';
    for (const QStringList &row : rows)
        mStream << rowOf(row);
}

void FigurePage::write()
{
    mStream.flush();
    QFile file(mFolder + QStringLiteral("/README.md"));
    if (!file.open(QIODevice::WriteOnly) || file.write(mText.toUtf8()) <= 0)
        throw std::runtime_error("cannot write " + file.fileName().toStdString());
}

QString described(const Model &model)
{
    return QStringLiteral("%1, %2 triangles")
        .arg(model.name, QLocale(QLocale::English).toString(model.mesh->triangleCount()));
}

} // namespace autocuts::figures
