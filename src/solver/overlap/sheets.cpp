#include "solver/overlap/sheets.h"

namespace autocuts::overlap {

SheetFinder::SheetFinder(const UnitGraph &graph)
    : mGraph(graph), mTaken(graph.conflicts.totalSize(), false), mFirstLayer(graph.unitCount, 0),
      mSecondLayer(graph.unitCount, 0)
{}

std::vector<Sheets> SheetFinder::find(const std::vector<int> &part, const std::vector<int> &members)
{
    for (int unit : members) {
        for (int other : mGraph.conflicts[unit])
            mTaken[mGraph.conflicts.find(unit, other)] = false;
    }
    std::vector<Sheets> found;
    for (int unit : members) {
        for (int other : mGraph.conflicts[unit]) {
            if (part[other] != part[unit] || mTaken[mGraph.conflicts.find(unit, other)])
                continue;
            found.push_back(grow(part, unit, other));
        }
    }
    return found;
}

Sheets SheetFinder::grow(const std::vector<int> &part, int first, int second)
{
    ++mCurrent;
    Sheets sheets;
    take(first, second);
    sheets.emplace_back(first, second);
    const auto tryPair = [&](int a, int b) {
        if (part[a] == part[first] && part[b] == part[first] && take(a, b))
            sheets.emplace_back(a, b);
    };
    for (std::size_t head = 0; head < sheets.size(); ++head) {
        const auto [a, b] = sheets[head];
        for (int c : mGraph.neighbours[a])
            tryPair(c, b);
        for (int d : mGraph.neighbours[b])
            tryPair(a, d);
        for (int c : mGraph.neighbours[a]) {
            for (int d : mGraph.neighbours[b])
                tryPair(c, d);
        }
    }
    return sheets;
}

//! Adds a pair to the current sheets if it overlaps, is in no sheets yet, and keeps the layers disjoint.
bool SheetFinder::take(int first, int second)
{
    const int place = mGraph.conflicts.find(first, second);
    if (place < 0 || mTaken[place] || mSecondLayer[first] == mCurrent || mFirstLayer[second] == mCurrent)
        return false;
    mTaken[place] = true;
    mTaken[mGraph.conflicts.find(second, first)] = true;
    mFirstLayer[first] = mCurrent;
    mSecondLayer[second] = mCurrent;
    return true;
}

} // namespace autocuts::overlap
