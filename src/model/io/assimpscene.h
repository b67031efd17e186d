// Scenes for Assimp's exporters, and what they lose.
#pragma once

#include "model/io/assimpsource.h"

#include <QStringList>

struct aiScene;

namespace autocuts {

//! What of the source is handed to an exporter. Assimp's exporters differ in what they get right.
struct ExportOptions
{
    bool triangulate = false; //!< as MeshData does, since Assimp's own split of concave polygons is poor
    bool animations = true;
    bool embeddedTextures = true;
    bool rootTransform = true; //!< false: the exporter ignores it, so it goes to a node below the root
};

//! The options for a format, a lower-case suffix.
ExportOptions exportOptions(const QString &format);

//! What is lost of the source when it is exported, one line each.
QStringList assimpLosses(const AssimpSource &source, const QString &format);

//! A scene for Assimp's exporters. Nodes and materials belong to the Scene it was made from, which must live
//! longer; meshes are its own, one per piece, with vertices split where a corner differs in UV or normal.
class ExportScene
{
public:
    ExportScene(const Scene &scene, const ExportOptions &options);
    ~ExportScene();
    ExportScene(const ExportScene &) = delete;
    ExportScene &operator=(const ExportScene &) = delete;

    const aiScene *get() const { return mScene; }

private:
    void borrow(const aiScene &from);
    void takeFromSource(const Scene &scene, const AssimpSource &source);
    void makePlain(const Scene &scene);

    aiScene *mScene;
    bool mBorrowed = false; //!< materials, textures, animations, cameras and lights are the source's
    ExportOptions mOptions;
};

} // namespace autocuts
