// The pictures of textures, as the views draw them.
#pragma once

#include <QImage>
#include <QString>

#include <atomic>
#include <map>
#include <vector>

namespace autocuts {

//! Some pictures, and the textures that are made of them.
struct Pictures
{
    //! What all of them may take together, in pixels of four bytes; smaller copies for drawing take a third
    //! more. Chosen by hand.
    static constexpr double pixelBudget = 128.0 * (1 << 20);
    static constexpr int tilesPerRow = 10;

    //! A texture: one picture that repeats, or one for each UDIM tile.
    struct Set
    {
        int repeated = -1;        //!< index of the picture in all tiles; -1: there is none
        std::map<int, int> tiles; //!< picture by the tile's place: column + 10 * row

        bool isEmpty() const { return repeated < 0 && tiles.empty(); }
        bool operator==(const Set &) const = default;
    };

    //! Images of each picture, one after another; `repeated` and `tiles` name the first one. 1: a colour. 3:
    //! a texture set, all of one size: base colour and height; x and y of the normal, roughness, metalness;
    //! emission and occlusion. Colours are sRGB.
    int layers = 1;
    std::vector<QImage> images;
    std::vector<Set> sets;
    //! Of each image, smaller copies for drawing: each has half of the width and height of the one before,
    //! down to one pixel. Empty: they are made by the graphics driver.
    std::vector<std::vector<QImage>> smaller = {};

    //! One picture that repeats; nothing when the image is null.
    static Pictures of(const QImage &image)
    {
        return image.isNull() ? Pictures() : Pictures{1, {image}, {{0, {}}}};
    }
};

//! The size that all images are scaled to: that of the largest, or what there is room for.
//! \param largest the longest side that there may be
QSize commonSize(const std::vector<QImage> &images, int largest);
//! An image of that size, with the bytes of red, green, blue and alpha, as it is uploaded.
QImage readyForUpload(const QImage &image, const QSize &size);
//! The same for all images, with their smaller copies, so that only the upload is left. Takes long.
//! \param stop ends it early when it becomes true; null: never
Pictures readyForUpload(Pictures pictures, const std::atomic<bool> *stop = nullptr);

} // namespace autocuts
