// Reads and writes picture files: textures, environments and what a bake makes.
#pragma once

#include "model/document/result.h"
#include "model/io/files/savefile.h"
#include "model/plain/picture.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace autocuts {

//! How the values of a picture are stored: whole numbers of 8 or 16 bits for 0 to 1, or float numbers.
enum class PictureDepth { Eight, Sixteen, Float };

//! A picture and how its file stores it.
struct DecodedPicture
{
    Picture picture;
    PictureDepth depth = PictureDepth::Eight; //!< Float for all formats of float numbers, half ones too
};

//! Reads PNG, JPEG, TGA, TIFF, OpenEXR, Radiance HDR and the other formats that Qt knows, told apart by their
//! content. Whole numbers become 0 to 1, float numbers stay as they are (they may be infinite or NaN); colour
//! spaces are not converted. Where alpha is small, colours of TIFF files with 8 bits are inexact. Of an
//! OpenEXR file the first part and in it the first layer of colours are read. Takes long for large pictures.
//! Errors: no such file, a folder, no permission, a damaged file, sides above maxPictureSide
//! (`pictures/picturesize.h`).
Result<Picture> readPicture(const QString &path);
//! The same, with how the file stores it.
Result<DecodedPicture> readDecodedPicture(const QString &path);

//! The same for the bytes of a file. \param path for messages; a suffix .tga tells that format
Result<DecodedPicture> decodePicture(const QByteArray &bytes, const QString &path);

//! The bytes of a regular file, for decodePicture().
Result<QByteArray> loadPictureFile(const QString &path);

//! The bytes of a picture's file, see addPicture().
Result<QByteArray> encodePicture(const Picture &picture, const QString &path, PictureDepth depth);

//! Adds a picture to files that are written together, in the format of the suffix: png, tif, tiff (8 and 16
//! bits), jpg, jpeg, tga (8 bits), exr (Sixteen: half, Float: float). Whole numbers are rounded and clamped
//! to 0 to 1, NaN becomes 0; alpha is lost in JPEG. Errors: a suffix that is unknown or cannot hold the
//! depth, an empty picture, and those of FileSet::add().
Result<Done> addPicture(const Picture &picture, const QString &path, PictureDepth depth, FileSet &files);

//! Writes a picture by itself. Errors: those of addPicture() and FileSet::putInPlace().
Result<Done> writePicture(const Picture &picture, const QString &path, PictureDepth depth);

//! How pictures with this suffix store their numbers. \param bits of each number: 8 and 16 for png, tif and
//! tiff, 8 for tga, 16 and 32 for exr; 0: 8, and 32 for exr. Error: the format has no such numbers.
Result<PictureDepth> pictureDepth(const QString &suffix, int bits);

//! Makes the folder that pictures go to. Error: it cannot be written.
Result<Done> makePictureFolder(const QString &folder);

//! Suffixes of the files that readPicture() reads, lower case, for dialogs.
QStringList pictureSuffixes();

} // namespace autocuts
