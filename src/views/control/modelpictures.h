// The textures that the open model names.
#pragma once

#include "views/gl/pictures.h"

#include <QObject>

#include <atomic>
#include <memory>
#include <vector>

namespace autocuts {

class ViewState;
class Workspace;
struct MeshData;

//! Loads the pictures of the materials' base colours on another thread, when they are to be shown.
class ModelPictures final : public QObject
{
    Q_OBJECT

public:
    ModelPictures(const Workspace &workspace, const ViewState &view, QObject *parent = nullptr);
    ~ModelPictures() override;

    //! How many materials of the model have a texture, whether it can be shown or not.
    int count() const;
    bool isLoading() const { return mLoading != nullptr; }
    //! Empty until they are loaded.
    const Pictures &pictures() const { return mPictures; }
    //! The set of each triangle, from 1; 0 where its material has none that can be shown.
    std::vector<quint32> triangleSets() const;
    //! The set behind the map: that of the first selected face; when nothing is selected, of the material
    //! that most faces have. -1: none.
    int shownSet() const;

Q_SIGNALS:
    void changed();
    //! Some textures cannot be shown. Emitted once for each model. \param message translated
    void noticed(const QString &message);

private:
    void forget();
    void loadIfShown();
    void takeOver(const Pictures &pictures, const QStringList &problems);
    int setOfFace(int face) const;

    const Workspace &mWorkspace;
    const ViewState &mView;
    std::shared_ptr<const MeshData> mMesh;       //!< of the model that they belong to; null: not asked for
    std::shared_ptr<std::atomic<bool>> mLoading; //!< ends the loading; null when nothing is loading
    Pictures mPictures;
    std::vector<int> mSetOfMaterial; //!< -1: none
    int mCommonSet = -1;             //!< of the material that most faces have
};

} // namespace autocuts
