// Changes of things that have a key: what each was before and is after.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

namespace autocuts {

//! Before and after of each changed thing, rising by key; nothing stands for "not there". Things that end as
//! they began are left out, so an edit that returns to its start becomes empty.
template <typename Key, typename Value>
class KeyedChanges
{
public:
    struct Change
    {
        Key key;
        std::optional<Value> before, after;
    };

    bool isEmpty() const { return mChanges.empty(); }
    int count() const { return static_cast<int>(mChanges.size()); }
    const std::vector<Change> &changes() const { return mChanges; }

    //! Adds a change, or replaces what the thing is after when it is here already.
    void add(Change change)
    {
        const auto it = std::lower_bound(mChanges.begin(), mChanges.end(), change.key,
                                         [](const Change &c, const Key &key) { return c.key < key; });
        if (it != mChanges.end() && it->key == change.key) {
            it->after = std::move(change.after);
            if (it->before == it->after)
                mChanges.erase(it);
        } else if (change.before != change.after) {
            mChanges.insert(it, std::move(change));
        }
    }

    //! Becomes the change from this one's start to the newer one's end.
    void combine(const KeyedChanges &newer)
    {
        for (const Change &change : newer.mChanges)
            add(change);
    }

    void clear() { mChanges = {}; }

private:
    std::vector<Change> mChanges;
};

} // namespace autocuts
