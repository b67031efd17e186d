// The pictures of a pattern in graphics memory.
#pragma once

#include "model/pictures/pictures.h"
#include "views/gl/glbuffer.h"

#include <QOpenGLTexture>

#include <memory>

namespace autocuts {

//! An array of repeating textures with v pointing up, and a table of which set has which picture in which
//! tile; shaders read both by picture.glsl. Large pictures are uploaded in parts, so that the window can go
//! on meanwhile. The context must be current in all functions, including the destructor.
class PatternTexture final
{
public:
    explicit PatternTexture(GlFunctions &gl) : mGl(gl), mTable(gl) {}

    //! Begins to upload pictures, and gives up those under way. Pictures of different sizes are scaled to one
    //! size, and too large ones to what there is room for; see readyForUpload().
    //! \param keep those before are drawn until then; otherwise none are
    void begin(const Pictures &pictures, bool keep);
    bool isBusy() const { return mNext != nullptr && !mNext->isComplete(); }
    //! Makes room or uploads until the time is over, one part at least. What is drawn stays the same.
    void goOn(int milliseconds);
    //! Draws those that are complete from now on. \returns false when there are no others than before
    bool show();
    //! True when these are drawn, and no others are under way.
    bool has(const Pictures &pictures) const;
    bool isEmpty() const { return !mTexture; }
    //! As in Pictures.
    int layers() const { return mLayers; }
    //! Binds the pictures and the table to two texture units.
    void bind(int pictureUnit, int tableUnit);

private:
    //! Pictures that are being uploaded.
    struct Upload
    {
        Pictures pictures;
        std::vector<qint64> keys;                //!< of its images
        std::unique_ptr<QOpenGLTexture> texture; //!< null: there are no pictures, or no room for them yet
        int images = 0;                          //!< of which there is room
        int image = 0, level = 0, row = 0;       //!< next part

        bool isComplete() const { return image >= images; }
        const QImage &source() const;
        void uploadPart();
    };

    void allocate(Upload &upload);

    GlFunctions &mGl;
    GlTexelBuffer mTable;
    std::unique_ptr<QOpenGLTexture> mTexture;
    int mLayers = 1;
    std::vector<qint64> mImages; //!< keys of those that are drawn
    std::vector<Pictures::Set> mSets;
    std::unique_ptr<Upload> mNext; //!< null: nothing else is to be shown
};

} // namespace autocuts
