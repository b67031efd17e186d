#include "solver/search/trialsahead.h"

#include <algorithm>
#include <atomic>

namespace autocuts::search {

namespace {

//! Changes that a copy makes one by one; after more of them the whole map is copied. Chosen by hand.
constexpr std::size_t mostChanges = 64;

} // namespace

struct TrialsAhead::Copy
{
    explicit Copy(const CutState &map) : state(map), trial(state) {}

    CutState state;
    SeamTrial trial;
    int version = -1;
    std::size_t changes = 0; //!< of mChanges that it has made
};

TrialsAhead::TrialsAhead(const CutState &map, int threads) : mMap(map), mTeam(threads), mCopies(threads) {}

TrialsAhead::~TrialsAhead() = default;

std::vector<TrialOutcome> TrialsAhead::run(const std::vector<Task> &tasks)
{
    const int count = static_cast<int>(tasks.size());
    std::vector<TrialOutcome> outcomes(tasks.size());
    std::atomic<int> next = 0, firstKept = count;
    mTeam.run(std::min(threads(), count), [&](int thread) {
        for (int i = next++; i < firstKept; i = next++) {
            SeamTrial &trial = broughtUpToDate(static_cast<std::size_t>(thread)).trial;
            const int steps = trial.patch().steps();
            const long long work = trial.patch().work();
            tasks[i](trial, outcomes[i]);
            outcomes[i].steps = trial.patch().steps() - steps;
            outcomes[i].work = trial.patch().work() - work;
            for (int first = firstKept; outcomes[i].kept && i < first;) {
                if (firstKept.compare_exchange_weak(first, i))
                    break;
            }
        }
    });
    outcomes.resize(std::min(count, firstKept + 1));
    return outcomes;
}

TrialsAhead::Copy &TrialsAhead::broughtUpToDate(std::size_t thread)
{
    std::unique_ptr<Copy> &copy = mCopies[thread];
    if (!copy)
        copy = std::make_unique<Copy>(mMap);
    if (copy->version != mVersion) {
        copy->state = mMap;
        copy->trial.reset();
        copy->version = mVersion;
        copy->changes = mChanges.size();
    }
    while (copy->changes < mChanges.size())
        copy->trial.adopt(mChanges[copy->changes++]);
    return *copy;
}

void TrialsAhead::adopted(KeptChange change)
{
    mChanges.push_back(std::move(change));
    if (mChanges.size() > mostChanges)
        mapChanged();
}

void TrialsAhead::mapChanged()
{
    mChanges.clear();
    ++mVersion;
}

} // namespace autocuts::search
