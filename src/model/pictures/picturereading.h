// Reads the pictures of textures, within limits of memory.
#pragma once

#include "model/pictures/pictures.h"

#include <QByteArray>
#include <QStringList>

#include <atomic>

namespace autocuts {

//! A texture to be read.
struct PictureRequest
{
    QString path;       //!< as for textureTiles(); empty when there is no such file, or for a content
    QByteArray content; //!< the bytes of the picture, in place of a file
    QString name;       //!< for messages
};

//! What the numbers of a float picture become in an image of 8 bits: sRGB, or what they are.
enum class PictureNumbers { Color, Plain };

//! The picture of a file or a content, no longer than that many pixels; null with a problem. Also OpenEXR,
//! Radiance HDR and TGA.
QImage readImage(const PictureRequest &request, int longest, PictureNumbers numbers, QString &problem);

//! Why a file cannot be a picture, by its first bytes; empty when it can be one.
QString pictureProblem(const QString &path);

//! The longest side for that many images, all of which together fit into memory.
int longestSide(std::size_t images);

//! Reads all textures; takes long. Pictures are scaled down where together they would take more than 512 MB.
//! \param problems gets a line for each texture that cannot be shown, with its reason
//! \param stop ends it early when it becomes true; null: never
//! \returns a set for each request; empty where it cannot be shown
Pictures readPictures(const std::vector<PictureRequest> &requests, QStringList &problems,
                      const std::atomic<bool> *stop = nullptr);

} // namespace autocuts
