// Pictures of patterns that are made on another thread, once for all views.
#pragma once

#include "model/pictures/pictures.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>

namespace autocuts {

//! The pictures that a view shows as its pattern, such as those of a file. Reading or drawing them takes
//! long, so it is done on another thread; views that show the same ones share them.
class MadePictures final : public QObject
{
    Q_OBJECT

public:
    using Make = std::function<Pictures()>;

    explicit MadePictures(QObject *parent = nullptr);
    ~MadePictures() override;

    //! Asks for other pictures; nothing happens when they are those that are shown.
    //! \param key tells them from others; empty: none
    //! \param make called on another thread, unless another view has asked for the same or nobody wants them
    //! any more
    //! \param keep those before stay until the new ones are there
    void ask(const QString &key, const Make &make, bool keep);
    //! Ready for the upload. Empty until they are made, and when they cannot be made.
    const Pictures &pictures() const;

Q_SIGNALS:
    void changed();

private:
    struct Making;

    static std::shared_ptr<Making> making(const QString &key, const Make &make);
    void showNext();

    QString mKey;
    std::shared_ptr<Making> mShown, mNext; //!< null: none
};

//! The image file of a texture, or the files of its UDIM tiles. \param path empty for none
void askForTexture(MadePictures &pictures, const QString &path);
//! See letteredPattern(). Another number of cells takes the place of the one before when it is there.
void askForLetters(MadePictures &pictures, int cells);

} // namespace autocuts
