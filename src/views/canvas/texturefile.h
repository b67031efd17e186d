// Loads the image file that is shown as a texture, or the files of its UDIM tiles.
#pragma once

#include "views/gl/pictures.h"

#include <QObject>
#include <QString>

namespace autocuts {

//! Reads the images on another thread, because large images take long.
class TextureFile final : public QObject
{
    Q_OBJECT

public:
    explicit TextureFile(QObject *parent = nullptr) : QObject(parent) {}

    const QString &path() const { return mPath; }
    //! One set. Empty until the image is loaded, and when it cannot be read.
    const Pictures &pictures() const { return mPictures; }
    //! \param path empty for none
    void setPath(const QString &path);

Q_SIGNALS:
    void changed();

private:
    QString mPath;
    Pictures mPictures;
};

} // namespace autocuts
