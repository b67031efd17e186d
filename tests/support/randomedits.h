// Random numbers, and random edits of a document.
#pragma once

#include "commands/documentcommand.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace autocuts::test {

//! Small deterministic random numbers (splitmix64).
class Random
{
public:
    explicit Random(std::uint64_t seed) : mState(seed) {}

    std::uint64_t next();
    //! In [0, bound). \pre bound > 0
    int below(int bound) { return static_cast<int>(next() % static_cast<std::uint64_t>(bound)); }
    //! In [0, 1).
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    bool oneIn(int n) { return below(n) == 0; }

private:
    std::uint64_t mState;
};

//! Makes random edits of all kinds, and random selections.
class RandomEdits
{
public:
    explicit RandomEdits(std::uint64_t seed) : mRandom(seed) {}

    Random &random() { return mRandom; }
    //! A command for the document as it is; it may change nothing. About half of them continue a gesture.
    std::unique_ptr<DocumentCommand> next(Document &document);
    void select(Document &document);

private:
    std::unique_ptr<DocumentCommand> make(Document &document, int kind);
    std::unique_ptr<DocumentCommand> seams(Document &document);
    std::unique_ptr<DocumentCommand> weights(Document &document);
    std::unique_ptr<DocumentCommand> pins(Document &document);
    std::unique_ptr<DocumentCommand> rectangles(Document &document);
    std::unique_ptr<DocumentCommand> uvs(Document &document);
    std::unique_ptr<DocumentCommand> islands(Document &document);
    std::unique_ptr<DocumentCommand> marks(Document &document);
    std::unique_ptr<DocumentCommand> settings(Document &document);
    std::unique_ptr<DocumentCommand> uvSets(Document &document);
    std::vector<int> someOf(int count);
    Vec2 point() { return {4 * mRandom.unit() - 2, 4 * mRandom.unit() - 2}; }

    Random mRandom;
    quint64 mGesture = 0;
    int mKind = 0;
};

} // namespace autocuts::test
