// The data of a Collada file that saving preserves.
#pragma once

#include "model/document/result.h"
#include "model/io/assimp/assimpsource.h"
#include "model/io/collada/colladamesh.h"

#include <QByteArray>
#include <QStringList>

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
    std::vector<UvSet> uvSets;        //!< as they were read
};

//! The Collada source of the scene's mesh, or null.
const ColladaSource *colladaSourceOf(const Scene &scene);

//! Gives a scene that readWithAssimp() read from a .dae file a ColladaSource, when the polygons of the text
//! and of the scene are the same. Otherwise the scene stays as it is, and Assimp writes it.
void keepCollada(Scene &scene);

//! The source with a geometry of its own for each node, where the text of the node is known: the first node
//! keeps what they share, the others get copies of it.
std::shared_ptr<const ColladaSource> withUniqueGeometries(const ColladaSource &source);

//! Finds the places of ColladaPlace::url. \param pieces of the places
void findUrls(const ColladaFile &file, std::string_view text, const std::vector<AssimpPiece> &pieces,
              std::vector<ColladaPlace> &places);

//! The bytes of the file with the UVs of the scene; the same bytes when they are those of the file. The
//! numbers of UVs in <source> and <p> are replaced; a UV set that other things use as well, or that is new,
//! gets a new <source>. Corners without UV keep that of the file, or get 0 0. \pre colladaSourceOf(scene) ==
//! &source
QByteArray rewriteCollada(const ColladaSource &source, const Scene &scene);

//! What rewriteCollada() loses, one line each.
QStringList colladaLosses(const ColladaSource &source, const Scene &scene);

//! Writes rewriteCollada() atomically.
Result<Done> writeCollada(const Scene &scene, const QString &path);

} // namespace autocuts
