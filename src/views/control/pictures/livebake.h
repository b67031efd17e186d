// A bake that follows the map while it changes.
#pragma once

#include "jobs/bakechoice.h"
#include "model/pictures/pictures.h"
#include "model/plain/types.h"
#include "views/ui/task.h"

#include <QObject>

#include <functional>
#include <map>
#include <memory>

namespace autocuts {

class ShownMap;
class Workspace;
struct LiveBakeModel;
struct MeshData;

//! Shows one map of a bake in the views. Rays are traced once, at points all over the surface, first few and
//! then more; whenever the shown map changes, what they found is laid into it anew, into all UDIM tiles in
//! which it lies; normals are shown under light. Or it shows pictures that a job makes. All work is done on
//! other threads. Ends when another model is opened.
class LiveBake final : public QObject
{
    Q_OBJECT

public:
    //! Texels along the longer side of the picture of a tile.
    static constexpr int size = 1024;
    //! Texels of the pictures of all tiles. With more than 16 tiles in use the pictures are smaller, so that
    //! laying them stays quick.
    static constexpr int mostTexels = 16 * size * size;
    //! The texels along the longer side where so many tiles are in use.
    static int sizeFor(std::size_t tiles);

    //! Receives the picture of a tile, on any thread.
    using Receiver = std::function<void(int tile, const QImage &picture)>;

    LiveBake(const Workspace &workspace, const ShownMap &shownMap, QObject *parent = nullptr);

    //! \param map one of jobs::bakeMapNames(); the other maps and the files of the choice are not used
    void start(const jobs::BakeChoice &choice, const QString &map);
    //! Shows another map of the same bake. Does nothing unless a bake is shown.
    void choose(const QString &map);
    //! Shows the pictures that a job makes, each in place of the one before, as they are: without light.
    //! \returns what takes them; does nothing after the next start or stop, and may outlive this
    Receiver receive();
    void stop();

    bool isOn() const { return mOn; }
    //! Empty while received pictures are shown.
    const QString &map() const { return mMap; }
    bool isReceiving() const { return mReceived.isOpen(); }
    //! The points are not all traced yet.
    bool isRefining() const { return mRefining; }
    //! For the tiles in which the shown map lies; empty until there are some.
    //! Received ones belong to the document's map when the first of them came: while another one is shown,
    //! there are none.
    const Pictures &pictures() const;
    //! The pictures are a texture set with normals, to be shown under light.
    bool isLit() const { return mPictures.layers > 1; }
    //! How often a picture was laid since the start; for measurements.
    int updates() const { return mUpdates; }

Q_SIGNALS:
    //! isOn(), isRefining() or pictures() changed.
    void changed();
    //! A part of the surface found nothing of the detailed model. Emitted once for each start.
    //! \param message translated
    void noticed(const QString &message);
    //! \param message translated
    void failed(const QString &message);

private:
    using TilePictures = std::map<int, std::vector<QImage>>; //!< the layers of each tile, see Pictures

    void refine(std::shared_ptr<const LiveBakeModel> model, int pass);
    void takeOver(const std::shared_ptr<const LiveBakeModel> &model, int pass);
    void tellMissed(const LiveBakeModel &model);
    void layAgain();
    void show(const TilePictures &tiles);
    void showReceived(const std::map<int, QImage> &received);
    void followMap();
    void fail(const QString &message);

    const Workspace &mWorkspace;
    const ShownMap &mShownMap;
    bool mOn = false;
    Task mTracing;       //!< rays, from the surface
    Task mLaying;        //!< what they found, into the shown map
    bool mStale = false; //!< another map was shown since the laying began
    jobs::BakeChoice mChoice;
    QString mMap;
    bool mRefining = false, mTold = false;
    std::shared_ptr<const LiveBakeModel> mModel; //!< with samples; null until the first ones are there
    Inbox<std::map<int, QImage>> mReceived;      //!< the pictures of tiles; closed: nothing is received
    UvMatrix mReceivedFor;                       //!< the document's map that the received pictures are for
    bool mPicturesMatchMap = true;               //!< the shown map is that one
    Pictures mPictures;
    int mUpdates = 0;
};

} // namespace autocuts
