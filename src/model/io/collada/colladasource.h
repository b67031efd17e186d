// The data of a Collada file that saving preserves.
#pragma once

#include "model/document/result.h"
#include "model/io/assimp/assimpsource.h"
#include "model/io/collada/colladamesh.h"

#include <QByteArray>
#include <QStringList>

#include <atomic>
#include <vector>

namespace autocuts {

//! Which primitive of the file a piece of the soup is.
struct ColladaPlace
{
    std::size_t geometry = 0, primitive = 0; //!< in ColladaFile::geometries
    //! Where the node that shows it names the geometry, in the text; 0: not known, so that it cannot get
    //! another one.
    std::size_t url = 0;
};

//! A Collada file that Assimp has read, and whose text is known well enough to replace its UVs.
struct ColladaSource final : AssimpSource
{
    QByteArray bytes;
    std::vector<ColladaPlace> places; //!< of each piece
    std::vector<UvSet> setsInFile;    //!< as they were read

    // In colladaanswers.cpp.
    SceneWriter rewriter(const QString &suffix) const override;
    QStringList rewritingLosses(const Scene &scene) const override;
    std::vector<SharedMesh> sharedMeshes(bool unique) const override;
    Result<std::shared_ptr<const FileSource>> withUniqueMeshes(const QString &path) const override;
    std::vector<UvSet> uvSets(const Scene & /*scene*/) const override { return setsInFile; }
};

//! Reads a .dae file by Assimp. When the polygons of the text and of the scene are the same, it has a
//! ColladaSource; otherwise an AssimpSource. \param stop as for readMesh()
Result<Scene> readColladaFile(const QString &path, const std::atomic<bool> *stop);

//! The source with a geometry of its own for each node, where the text of the node is known: the first node
//! keeps what they share, the others get copies of it.
std::shared_ptr<const ColladaSource> withUniqueGeometries(const ColladaSource &source);

//! Finds the places of ColladaPlace::url. \param pieces of the places
void findUrls(const ColladaFile &file, std::string_view text, const std::vector<AssimpPiece> &pieces,
              std::vector<ColladaPlace> &places);

//! The bytes of the file with the UVs of the scene; the same bytes when they are those of the file. The
//! numbers of UVs in <source> and <p> are replaced; a UV set that other things use as well, or that is new,
//! gets a new <source>. Corners without UV keep that of the file, or get 0 0. \pre
//! sourceOf<ColladaSource>(scene)
//! == &source
QByteArray rewriteCollada(const ColladaSource &source, const Scene &scene);

} // namespace autocuts
