// Limits of the size of pictures, checked before memory is taken.
#pragma once

#include "model/document/result.h"

namespace autocuts {

//! Longest side and most pixels of a picture that is read; chosen by hand.
inline constexpr int maxPictureSide = 16384;
inline constexpr qint64 maxPicturePixels = qint64(16384) * 16384;

//! An error where a picture has no pixels or too many, or where its file is much too short for them.
//! \param fileBytes length of the compressed file
Result<Done> checkPictureSize(qint64 width, qint64 height, qint64 fileBytes, const QString &path);

//! Lets Qt read pictures of that size; its own limit refuses usual textures. It is one for the whole program
//! and is set once.
void allowLargePictures();

//! What a damaged file gets. \param reason in English or from a library; may be empty
Error brokenPicture(const QString &path, const QString &reason = {});

} // namespace autocuts
