// Maps and marks of a document as messages of the live link.
#pragma once

#include "link/linkmarks.h"
#include "link/linktextures.h"
#include "model/document/constraints.h"
#include "model/document/seams.h"

#include <memory>

namespace autocuts::link {

//! UVs of the corners as precise as modelling programs are, in a texture of 1 x 1.
using LinkUvs = Eigen::Matrix<float, Eigen::Dynamic, 2, Eigen::RowMajor>;

//! A model that a program and the studio share, and what the program has of it.
struct SharedModel
{
    int serial = 0; //!< number that the program gave it; 0: they share none
    std::shared_ptr<const MeshData> mesh;
    std::shared_ptr<const VertexPairs> edges; //!< of the mesh
    LinkUvs uvs;                              //!< of its active UV set; empty: unknown
    Marks marks;
    bool solving = false; //!< what it was told last with a map
    QJsonArray textures;  //!< as NamedTextures writes them
};

//! What a program is to get.
struct MapToSend
{
    //! Texture space of the document; empty: the map stays. Sent when it differs from what the program has.
    UvMatrix uv;
    double tileHeight = 1; //!< of the document's texture space
    QString uvSet;
    bool solving = false; //!< more maps will come
    bool always = false;  //!< the program has asked for it
    std::vector<PairState> states;
    std::vector<UvPin> pins;
    QList<int> faces;    //!< selected ones
    QJsonArray textures; //!< as NamedTextures writes them
};

//! Compares with what the program has, and notes what it will have. Takes as long as measuring a map: not for
//! the GUI thread. \returns the bytes of the messages
QByteArray messagesFor(SharedModel &model, const MapToSend &send);

LinkUvs toLinkUvs(const UvMatrix &uv, double tileHeight);
//! True when no UV differs; missing ones are equal.
bool sameUvs(const LinkUvs &a, const LinkUvs &b);
//! The marks of a document. \param send its states, pins and faces
Marks marksOf(const VertexPairs &edges, const MapToSend &send);

} // namespace autocuts::link
