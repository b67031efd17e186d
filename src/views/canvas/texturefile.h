// Loads the image file that is shown as a texture.
#pragma once

#include <QImage>
#include <QObject>
#include <QString>

namespace autocuts {

//! Reads the image on another thread, because large images take long.
class TextureFile final : public QObject
{
    Q_OBJECT

public:
    explicit TextureFile(QObject *parent = nullptr) : QObject(parent) {}

    const QString &path() const { return mPath; }
    //! Null until the image is loaded, and when it cannot be read.
    const QImage &image() const { return mImage; }
    //! \param path empty for none
    void setPath(const QString &path);

Q_SIGNALS:
    void changed();

private:
    QString mPath;
    QImage mImage;
};

} // namespace autocuts
