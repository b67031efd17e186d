// What a scene knows of the file that it was read from: what writing it again needs, and what the formats of
// new files ask.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"
#include "model/io/formats/sourcecontents.h"
#include "model/plain/hardedges.h"

#include <QStringList>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace autocuts {

//! Writes a scene to a path.
using SceneWriter = Result<Done> (*)(const Scene &scene, const QString &path);

//! A mesh of a file, and the objects that show it.
struct SharedMesh
{
    struct Instance
    {
        int firstFace = 0;     //!< of the soup; the others follow in their order
        bool mirrored = false; //!< the corners of each face are in reverse order
    };
    int faceCount = 0;
    std::vector<Instance> instances;
};

//! Meshes by their places in a file: a mesh, and a part of it.
using MeshesByPlace = std::map<std::pair<std::size_t, std::size_t>, SharedMesh>;

//! Those that several objects show.
std::vector<SharedMesh> severalTimesShown(std::vector<SharedMesh> meshes);
std::vector<SharedMesh> severalTimesShown(MeshesByPlace meshes);

//! The block of a session that holds the file.
struct FileBlock
{
    const char *name = nullptr; //!< null: sessions hold the polygons only
    bool holdsPolygons = false; //!< those of the scene are not stored besides
};

//! One subclass per family of formats. The scenes that functions take are those of the source, with other
//! UVs.
struct FileSource : SceneSource
{
    SourceContents contents;

    //! True for the mesh that was read.
    virtual bool isOf(const MeshData &mesh) const = 0;

    //! Writes the file with the UVs of the scene and nothing else changed; null when it cannot be written so
    //! in a format. \param suffix lower-case
    virtual SceneWriter rewriter([[maybe_unused]] const QString &suffix) const { return nullptr; }
    //! What that loses, one line each.
    virtual QStringList rewritingLosses(const Scene & /*scene*/) const { return {}; }
    //! The scene with the UVs that the rewritten file has: objects that share a mesh get the map of the one
    //! that is written. \param tileHeight see tilescaling.h
    virtual Scene asRewritten(const Scene &scene, double tileHeight) const;

    //! The meshes that objects share. \param unique those only that uniqueMeshes() leaves shared
    virtual std::vector<SharedMesh> sharedMeshes(bool /*unique*/) const { return {}; }
    //! The source as if each object had had a mesh of its own; null: it stays as it is. \param path for
    //! messages
    virtual Result<std::shared_ptr<const FileSource>> withUniqueMeshes(const QString & /*path*/) const
    {
        return std::shared_ptr<const FileSource>();
    }

    //! One unit of the file in metres, with y up; nothing where that follows from its format.
    virtual std::optional<double> metres() const { return {}; }
    //! The normals and smoothing groups of the mesh, where no AssimpSource has them.
    virtual FileShading shading() const { return {}; }
    //! The UV sets as they were read; empty when they are not known any more.
    virtual std::vector<UvSet> uvSets(const Scene & /*scene*/) const { return {}; }
    //! The files that it was read from besides its own one and pictures.
    virtual QStringList filesBeside(const QString & /*path*/) const { return {}; }
    virtual FileBlock sessionBlock() const { return {}; }
    virtual QByteArray bytesForSession() const { return {}; } //!< of that block

    //! Whether Assimp reads the same polygons from the file.
    enum class ByAssimp { Never, Perhaps, Always };
    virtual ByAssimp readByAssimp() const { return ByAssimp::Always; }
    //! The scene as Assimp reads it from the same file, so that new files get what else is in it: skeletons,
    //! animations. Nothing when the scene has all of it, or when Assimp reads other polygons. Waits for the
    //! program that reads the file; not for the GUI thread.
    virtual std::optional<Scene> asAssimpReads(const Scene & /*scene*/) const { return {}; }
};

//! The source of the scene's mesh if it is of this kind, or null.
template <typename Source = FileSource>
const Source *sourceOf(const Scene &scene)
{
    const auto *source = dynamic_cast<const Source *>(scene.source.get());
    return source && source->isOf(*scene.mesh) ? source : nullptr;
}

} // namespace autocuts
