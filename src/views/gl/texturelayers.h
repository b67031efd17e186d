// Reads texture sets and packs their channels into the images that shaders read.
#pragma once

#include "model/document/texturesets.h"
#include "model/pictures/picturereading.h"

#include <QRgb>

namespace autocuts {

//! The pictures of a material.
struct TextureSetRequest
{
    struct Channel
    {
        PictureRequest picture; //!< empty: `entry.factor` everywhere
        ChannelPicture entry;
    };

    std::map<TextureChannel, Channel> channels;
    QRgb color = 0; //!< base colour where there is no picture; 0: a light grey
};

//! Reads all sets; takes long. All images get one size, such that together they take no more than 512 MB. A
//! grey picture of normals, and a height where there are no normals, become normals.
//! \param problems, stop as for readPictures() \returns a set with three layers for each request; empty where
//! it has no picture that can be shown
Pictures readTextureSets(const std::vector<TextureSetRequest> &requests, QStringList &problems,
                         const std::atomic<bool> *stop = nullptr);

//! A small picture of one channel. \param first the first image of a picture \returns null for channels that
//! the pictures do not have
QImage channelImage(const Pictures &pictures, int first, TextureChannel channel, int side);

} // namespace autocuts
