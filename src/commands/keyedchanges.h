// Changes of items that have a key, with their values before and after.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

namespace autocuts {

//! The values of all changed items before and after an edit, ascending by key; an empty value means that the
//! item does not exist. Items with equal values before and after are left out, so an edit that returns to its
//! start is empty.
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

    //! Adds a change; replaces the value after it when there is a change for the key already.
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

    //! Appends a newer edit: the result leads from the start of this one to the end of that one.
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
