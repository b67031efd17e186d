// The definite map of a live solve on a thread of its own.
#pragma once

#include "solver/live/mailbox.h"
#include "solver/unwrap/livemap.h"

#include <QObject>
#include <QThread>

namespace autocuts::live {

//! Runs a LiveMap until told to stop. The functions may be called from any thread and return at once; of
//! several snapshots only the newest counts. Once an order is given, maps made before it that it invalidates
//! can no longer be taken. The keeper never sees the document.
class MapKeeper final : public QObject
{
    Q_OBJECT

public:
    //! \param threads number of threads of the search
    explicit MapKeeper(int threads = QThread::idealThreadCount());
    ~MapKeeper() override;

    //! Forgets the map and begins with that of the snapshot, or with none.
    void start(std::shared_ptr<const Snapshot> snapshot, const unwrap::LiveMapOptions &options);
    //! As LiveMap::steer().
    void update(std::shared_ptr<const Snapshot> snapshot, const unwrap::LiveMapOptions &options,
                bool pulled = false, std::shared_ptr<const unwrap::LiveMapResult> back = nullptr);
    //! The map was put into the document, which now has this token.
    void setToken(const StateToken &token);
    void run();
    //! Stops after the present step.
    void pause();

    //! The newest map that was not taken yet; null when there is none.
    std::shared_ptr<const unwrap::LiveMapResult> takeMap() { return mMailbox.takeResult(); }
    //! Why it failed, untranslated, one line.
    std::optional<QString> takeFailure() { return mMailbox.takeFailure(); }
    //! True, once, when nothing is left to gain and it was not told anything since.
    bool takeRest() { return mMailbox.takeRest(); }

Q_SIGNALS:
    //! A map is waiting. Sent once until it is taken.
    void mapReady();
    //! Nothing is left to gain. takeRest() tells whether that is still so.
    void rests();
    //! It failed and is over. takeFailure() says why, unless it was started again since.
    void failed();

private:
    struct Orders
    {
        bool start = false;
        std::shared_ptr<const Snapshot> snapshot;
        unwrap::LiveMapOptions options;
        bool pulled = false;
        std::shared_ptr<const unwrap::LiveMapResult> back;
        std::optional<StateToken> token;
        std::optional<bool> run;
    };

    template <class Change>
    void order(Change &&change);
    void work();
    void obey(Orders orders);
    void give(std::shared_ptr<const unwrap::LiveMapResult> map);

    Mailbox<Orders, unwrap::LiveMapResult> mMailbox;

    // Used by the keeper's thread only.
    const int mThreads;
    unwrap::LiveMap mMap;
    bool mRunning = false;
};

} // namespace autocuts::live
