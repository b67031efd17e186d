#include "model/io/fbx/fbxuvsets.h"

#include "model/document/documentstate.h"

namespace autocuts {

//! The set of a name that a geometry has not used yet: one that began with this name, or one that has joined
//! it.
int FbxUvSets::named(const QString &name, const std::set<int> &taken) const
{
    int found = -1;
    for (int s = 0; s < std::ssize(mSets) && !name.isEmpty(); ++s) {
        if (taken.contains(s) || !mSets[s].joined.contains(name))
            continue;
        if (mSets[s].name == name)
            return s;
        if (found < 0)
            found = s;
    }
    return found;
}

int FbxUvSets::added(const QString &name)
{
    if (mSets.size() >= maxSets)
        return -1;
    std::vector<UvSet> known;
    for (const Set &set : mSets)
        known.push_back({set.name, {}});
    const QString unique = uniqueUvSetName(known, name.isEmpty() ? QStringLiteral("UVMap") : name);
    mSets.push_back({unique, {name}});
    return static_cast<int>(mSets.size()) - 1;
}

std::vector<int> FbxUvSets::join(const std::vector<QString> &names)
{
    std::vector<int> result(names.size(), -1);
    std::set<int> taken;
    for (std::size_t n = 0; n < names.size(); ++n) {
        result[n] = named(names[n], taken);
        if (result[n] >= 0)
            taken.insert(result[n]);
    }
    for (std::size_t n = 0; n < names.size(); ++n) {
        if (result[n] >= 0)
            continue;
        const int place = static_cast<int>(n);
        if (place < std::ssize(mSets) && !taken.contains(place)) {
            mSets[n].joined.insert(names[n]);
            result[n] = place;
        } else {
            result[n] = added(names[n]);
        }
        taken.insert(result[n]);
    }
    return result;
}

std::vector<QString> FbxUvSets::names() const
{
    std::vector<QString> result;
    for (const Set &set : mSets)
        result.push_back(set.name);
    return result;
}

} // namespace autocuts
