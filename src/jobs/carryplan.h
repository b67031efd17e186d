// Textures that are carried over to another map: which pictures, into which files, and the sets they make.
#pragma once

#include "model/document/documentstate.h"
#include "model/pictures/picturefiles.h"
#include "model/plain/shadedsurface.h"

#include <QString>
#include <QStringList>

namespace autocuts::jobs {

//! A picture that is made new, and where it is shown.
struct CarriedPicture
{
    SceneTexture source; //!< its file is a path for textureTiles(), or there is a content
    TextureKind kind = TextureKind::Linear;
    std::vector<int> materials; //!< ascending, -1 for faces without one; empty: all faces
    std::vector<TextureChannel> channels;
    QString newFile; //!< path, with <UDIM> where it has several tiles
};

//! Where the new pictures go.
struct CarryTarget
{
    QString folder;
    //! Goes to the end of the names, such as "_uv2". It replaces one with another number, such as "_uv3".
    QString suffix;
    bool tiled = false; //!< the new map has several UDIM tiles
    //! The format of the files ("png"); empty: that of each source. JPEG pictures become PNG, because they
    //! would lose by being compressed again, and so do formats that cannot be written.
    QString format;
};

//! The pictures that are to be carried over, with their new files.
struct CarryPlan
{
    std::vector<CarriedPicture> pictures;
    QStringList missing; //!< names of pictures that are not there, for messages
    //! Those of the new files that exist already.
    QStringList existingFiles() const;
    //! The first new file that is one of the sources; empty when there is none.
    QString overwrittenSource() const;
};

//! The file of one tile. \param path of CarriedPicture::newFile
QString fileOfTile(QString path, int tile);

//! All pictures of the materials that faces have, each once: materials and channels that show the same
//! picture go on sharing one. Looks for files, but does not read them.
CarryPlan planCarrying(const DocumentState &state, const CarryTarget &target);
//! A plan for single files, which are for all faces. Their names tell what they hold.
CarryPlan planCarrying(const QStringList &files, const CarryTarget &target);

//! The first of _uv2, _uv3, ... with which no new file would exist yet. \param target its suffix does not
//! count
QString freeSuffix(const DocumentState &state, CarryTarget target);

//! The sets with the new pictures in place of the old ones, as DocumentState::textureSets.
std::vector<TextureSet> carriedSets(const DocumentState &state, const CarryPlan &plan);

} // namespace autocuts::jobs
