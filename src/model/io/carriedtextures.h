// Textures that are carried over to another map: which pictures, into which files, and the sets they make.
#pragma once

#include "model/document/documentstate.h"
#include "model/io/picturefiles.h"
#include "model/plain/shadedsurface.h"

#include <QString>
#include <QStringList>

#include <functional>

namespace autocuts {

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
    //! Goes to the end of the names, in place of one that ends so but for its number: "_uv2".
    QString suffix;
    bool tiled = false; //!< the new map has several UDIM tiles
    //! The format of the files ("png"); empty: that of each source. JPEG pictures become PNG, because they
    //! would lose by being compressed again, and so do formats that cannot be written.
    QString format;
};

//! What is to be carried.
struct CarryPlan
{
    std::vector<CarriedPicture> pictures;
    QStringList missing; //!< names of pictures that are not there, for messages
    //! The files of a picture that would be written, as far as they exist already.
    QStringList existingFiles() const;
    //! The first new file that is one of the sources; empty when there is none.
    QString overwrittenSource() const;
};

//! All pictures of the materials that faces have, each once: materials and channels that show the same
//! picture go on sharing one. Looks for files, but does not read them.
CarryPlan planCarrying(const DocumentState &state, const CarryTarget &target);
//! Single files, for all faces; what they hold is judged by their names.
CarryPlan planCarrying(const QStringList &files, const CarryTarget &target);

//! The first of _uv2, _uv3, ... with which no new file would exist yet. \param target its suffix does not
//! count
QString freeSuffix(const DocumentState &state, CarryTarget target);

//! The sets with the new pictures in place of the old ones, as DocumentState::textureSets.
std::vector<TextureSet> carriedSets(const DocumentState &state, const CarryPlan &plan);

//! A picture that was read, for a baker.
struct CarrySource
{
    TiledPicture picture;
    TextureKind kind = TextureKind::Linear;
    PictureDepth depth = PictureDepth::Eight;
    int width = 0, height = 0; //!< of the largest
    std::vector<bool> faces;   //!< that show it; empty: all
};

//! Makes the pictures of the tiles and gives each to the sink, which returns false to end it.
using CarryBaker = std::function<void(const CarrySource &source,
                                      const std::function<bool(int tile, const Picture &picture)> &sink)>;

//! How the pictures are made.
struct CarryControl
{
    std::function<bool()> stopped;
    std::function<void(int done)> pictureDone; //!< \param done how many
    bool needsAll = false; //!< a picture that cannot be read is an Error; else it is left out
};

//! What was written.
struct CarriedFiles
{
    bool stopped = false; //!< then nothing was written
    QStringList files;
    QStringList problems; //!< pictures that could not be read, with the reasons
    CarryPlan plan;       //!< what was made, without them; names are those of the files
};

//! Reads, bakes and writes all pictures of a plan. The files are put in their places when all of them are
//! finished: after an error or a stop everything is as before. Takes long.
//! \param faceMaterial of the model with the new map, see Scene::faceMaterial
Result<CarriedFiles> carryPictures(const CarryPlan &plan, const std::vector<int> &faceMaterial,
                                   const CarryBaker &bake, const CarryControl &control);

} // namespace autocuts
