// Reads the pictures of textures, within limits of memory.
#pragma once

#include "views/gl/pictures.h"

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

//! Longest side and most pixels of a picture that is read; chosen by hand.
inline constexpr int maxPictureSide = 16384;
inline constexpr qint64 maxPicturePixels = qint64(16384) * 16384;

//! Reads all textures; takes long. Pictures are scaled down where together they would take more than 512 MB.
//! \param problems gets a line for each texture that cannot be shown, with its reason
//! \param stop ends it early when it becomes true; null: never
//! \returns a set for each request; empty where it cannot be shown
Pictures readPictures(const std::vector<PictureRequest> &requests, QStringList &problems,
                      const std::atomic<bool> *stop = nullptr);

} // namespace autocuts
