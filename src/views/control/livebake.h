// A bake that follows the map while it changes.
#pragma once

#include "views/control/bakechoice.h"
#include "views/gl/pictures.h"

#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <memory>

namespace autocuts {

class ShownMap;
class Workspace;
struct LiveBakeModel;
struct MeshData;

//! Shows one map of a bake in the views. Rays are traced once, at points all over the surface, first few and
//! then more; whenever the shown map changes, what they found is laid into it anew. All work is done on other
//! threads. Ends when another model is opened.
class LiveBake final : public QObject
{
    Q_OBJECT

public:
    //! Texels along the longer side of the picture.
    static constexpr int size = 1024;

    LiveBake(const Workspace &workspace, const ShownMap &shownMap, QObject *parent = nullptr);
    ~LiveBake() override;

    //! \param map one of bakeMapNames(); the other maps and the files of the choice are not used
    void start(const BakeChoice &choice, const QString &map);
    void stop();

    bool isOn() const { return mStop != nullptr; }
    const QString &map() const { return mMap; }
    //! The points are not all traced yet.
    bool isRefining() const { return mRefining; }
    //! The picture for the tile of the packing settings; empty until there is one.
    const Pictures &pictures() const { return mPictures; }
    //! How often a picture was laid since the start; for measurements.
    int updates() const { return mUpdates; }

Q_SIGNALS:
    //! isOn(), isRefining() or pictures() changed.
    void changed();
    //! \param message translated
    void failed(const QString &message);

private:
    using StopFlag = std::shared_ptr<std::atomic<bool>>;

    void refine(std::shared_ptr<const LiveBakeModel> model, int pass);
    void takeOver(const StopFlag &flag, const std::shared_ptr<const LiveBakeModel> &model, int pass);
    void layAgain();
    void show(const StopFlag &flag, const QImage &picture, int tile);
    void fail(const StopFlag &flag, const QString &message);

    const Workspace &mWorkspace;
    const ShownMap &mShownMap;
    QThreadPool mThreads; //!< one traces, one lays
    StopFlag mStop;       //!< of what is under way; null: off
    QString mMap;
    bool mRefining = false, mLaying = false, mStale = false;
    std::shared_ptr<const LiveBakeModel> mModel; //!< with samples; null until the first ones are there
    Pictures mPictures;
    int mUpdates = 0;
};

} // namespace autocuts
