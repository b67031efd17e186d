// The textures of the open model: those that its file names, and those that the user chose.
#pragma once

#include "model/document/texturesets.h"
#include "model/pictures/pictures.h"
#include "views/control/pictures/scenelight.h"
#include "views/state/viewstate.h"
#include "views/ui/task.h"

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <atomic>
#include <memory>
#include <vector>

namespace autocuts {

class Workspace;
struct MeshData;

//! Loads the pictures of the materials on another thread, when they are to be shown: for Pattern::Materials
//! the base colours, for Pattern::Physical the whole sets. Loads them again when their files change.
class ModelPictures final : public QObject
{
    Q_OBJECT

public:
    ModelPictures(const Workspace &workspace, const ViewState &view, QObject *parent = nullptr);

    //! How many materials of the model have a texture, whether it can be shown or not.
    int count() const;
    //! True when a material has pictures of more than its base colour.
    bool hasSets() const;
    bool isLoading() const { return mLoading.isRunning(); }
    //! Empty until they are loaded; while they are loaded again, those from before.
    const Pictures &pictures() const { return mPictures; }
    //! True when a picture of normals is among those that are loaded.
    bool haveNormals() const { return mHaveNormals; }
    //! The set of each triangle, from 1; 0 where its material has none that can be shown.
    std::vector<quint32> triangleSets() const;
    //! The set behind the map: that of the first selected face; when nothing is selected, of the material
    //! that most faces have. -1: none.
    int shownSet() const;
    //! What is shown of a channel of a material (-1: of the faces without one), small; null when the sets are
    //! not loaded.
    QImage thumbnail(int material, TextureChannel channel, int side) const;
    const SceneLight &light() const { return mLight; }

Q_SIGNALS:
    void changed();
    //! isLoading() changed, or others are loaded.
    void loadingChanged();
    //! Some textures cannot be shown. Emitted once for the same ones. \param message translated
    void noticed(const QString &message);

private:
    struct Loaded;
    //! A file as it was when it was read.
    struct FileState
    {
        QString path;
        QDateTime time;
        qint64 size = 0;
        bool operator==(const FileState &) const = default;
    };
    struct Wanted;

    void forget();
    void loadIfShown();
    void takeOver(const Loaded &loaded);
    void watch(const QStringList &folders);
    void lookForChanges();
    void tellProblems(const QStringList &problems);
    static std::vector<FileState> statesOf(const QStringList &paths);
    int setOfMaterial(int material) const;
    int setOfFace(int face) const;

    const Workspace &mWorkspace;
    const ViewState &mView;
    SceneLight mLight;
    std::shared_ptr<const MeshData> mMesh; //!< of the model that they belong to; null: not asked for
    Pattern mPattern = Pattern::None;      //!< for which they were asked for
    bool mStale = false;                   //!< they are to be loaded again
    Task mLoading;
    Pictures mPictures;
    std::vector<int> mSetOfMaterial; //!< first of faces without a material; -1: none
    int mCommonSet = -1;             //!< of the material that most faces have
    bool mHaveNormals = false;
    QStringList mProblems; //!< that were told
    QFileSystemWatcher mWatcher;
    QTimer mLookTimer;              //!< programs write files in several steps
    QStringList mPaths;             //!< as textureTiles() takes them
    std::vector<FileState> mStates; //!< of the files when they were read
};

} // namespace autocuts
