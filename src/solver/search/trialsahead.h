// Trials that are made ahead of their turn, on several threads.
#pragma once

#include "model/plain/parallel.h"
#include "solver/search/seamtrial.h"

#include <functional>
#include <memory>
#include <vector>

namespace autocuts::search {

//! The outcome of a list of trials, made one after another until one is kept.
struct TrialOutcome
{
    bool kept = false;
    int tried = 0;      //!< trials made
    SeamChange asked;   //!< the change of the last trial
    int end = -1;       //!< the vertex at the end of a seam that was stitched
    KeptChange change;  //!< what a copy of the map would keep, see SeamTrial::attempt()
    int steps = 0;      //!< Newton steps
    long long work = 0; //!< see Patch::work()
};

//! Most of what a search tries fails and leaves the map as it was. So what it would try next, should this
//! fail, is tried at the same time on copies of the map. The first trial that is kept counts, and what comes
//! after it is forgotten: the search finds the same map, to the last bit, as without threads.
class TrialsAhead
{
public:
    //! Tries something at a copy of the map and leaves it as it was. Called from any thread.
    using Task = std::function<void(SeamTrial &, TrialOutcome &)>;

    //! \param map must outlive this
    //! \param threads including the calling one
    TrialsAhead(const CutState &map, int threads);
    ~TrialsAhead();

    int threads() const { return mTeam.threads(); }
    //! \returns the outcomes of the first tasks, up to the first one that is kept
    std::vector<TrialOutcome> run(const std::vector<Task> &tasks);
    //! Must be called when the map has made such a change.
    void adopted(KeptChange change);
    //! Must be called when the map has changed in any other way.
    void mapChanged();

private:
    struct Copy;

    Copy &broughtUpToDate(std::size_t thread);

    const CutState &mMap;
    ThreadTeam mTeam;
    std::vector<std::unique_ptr<Copy>> mCopies; //!< per thread
    std::vector<KeptChange> mChanges;           //!< of the map since it was copied
    int mVersion = 0;                           //!< of the map before these changes
};

} // namespace autocuts::search
