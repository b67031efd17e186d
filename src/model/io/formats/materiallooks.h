// What new files say of a scene's materials: colours, and pictures of their channels.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <QStringList>

#include <map>

namespace autocuts {

class FileSet;

//! The materials of a scene, for a file that is written.
class MaterialLooks final
{
public:
    //! \param output path of that file
    MaterialLooks(const Scene &scene, const QString &output) : mScene(scene), mOutput(output) {}

    //! The base colour as the scene's file has it, shares of red, green and blue: programs take the numbers
    //! of one format for those of another. \param material -1: of faces without one
    Vec3 color(int material) const;
    //! The picture of a channel; empty when there is none. \param material -1 has none
    ChannelPicture picture(int material, TextureChannel channel) const;
    //! The bytes of a picture, inside of the model's file or of its own; empty when it is not there.
    QByteArray contentOf(const SceneTexture &picture) const;
    //! How the new file calls a picture: by a path from its folder. A picture inside of the model's file gets
    //! a file beside the new one, see addFiles().
    QString fileOf(const SceneTexture &picture);
    //! Gives all pictures inside of the model's file a place. \returns the paths
    QStringList placeAll();
    //! The files that fileOf() has named and that are not there yet.
    Result<Done> addFiles(FileSet &files) const;
    //! Names of pictures that are neither in the model's file nor beside it.
    QStringList missing() const;

private:
    QString pathOf(const SceneTexture &picture) const;

    const Scene &mScene;
    QString mOutput;
    std::vector<std::pair<QString, QByteArray>> mFiles; //!< paths and contents of pictures to write
};

//! The suffix of a picture file of these bytes: png, jpg, or else that of its name.
QString pictureSuffix(const QByteArray &content, const QString &name);

} // namespace autocuts
