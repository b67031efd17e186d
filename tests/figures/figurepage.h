// The page with the paper's figures made by this program.
#pragma once

#include "model/document/scene.h"

#include <QStringList>
#include <QTextStream>

#include <memory>
#include <vector>

namespace autocuts::figures {

class FigurePage;

//! A figure of the paper, and how it is made here.
struct Figure
{
    int number;
    const char *file; //!< its picture, in the folder of the page
    const char *title;
    const char *paper; //!< what the paper's picture shows, with the paper's numbers
    const char *steps; //!< how it is made here
    void (*make)(FigurePage &page, const Figure &figure); //!< null: it is not made yet
};

//! The mesh of a figure.
struct Model
{
    QString name;
    std::shared_ptr<const MeshData> mesh;
};

//! Collects the pictures and numbers of all figures, and writes the page.
class FigurePage
{
public:
    //! \param meshes folder of organic/cathead.obj and the like; empty: the program's samples are used
    FigurePage(const QString &folder, const QString &meshes);

    //! Path of a mesh of the folder; empty when it is not there.
    QString meshPath(const QString &file) const;
    //! A mesh of the folder; the sample when it is not there. \throws std::runtime_error
    Scene scene(const QString &file, const QString &sample) const;
    Model model(const QString &file, const QString &sample) const;
    //! Where the picture of a figure goes.
    QString pathOf(const Figure &figure) const;
    //! Adds a figure. \param mesh one or several, as a sentence \param head names of the columns
    void add(const Figure &figure, const QString &mesh, const QStringList &head,
             const std::vector<QStringList> &rows);
    void write();

private:
    QString mFolder, mMeshes;
    QString mText;
    QTextStream mStream;
};

//! "planck1, 3,109 triangles"
QString described(const Model &model);

} // namespace autocuts::figures
