#include "model/transfer/positiontransfer.h"

#include "model/plain/polygonsides.h"
#include "model/plain/unionfind.h"
#include "model/plain/uvlayout.h"
#include "model/transfer/faceplacer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace autocuts::transfer {

namespace {

// Chosen by hand, on the models of the tests.
constexpr double collapsePrice = 2; // of a placing with faulty triangles, times the face's perimeter
constexpr int maxRounds = 16;       // of choosing among the placings; a few are enough
constexpr int wideningRounds = 2;   // a face's neighbour of its neighbour has its say in the second one
constexpr int facesPerReport = 64;

//! One transfer, step by step.
class Transfer
{
public:
    Transfer(const SourceSurface &source, const MeshData &mesh, const Frame &frame, const UvMatrix &uv,
             const std::vector<bool> &wanted, const TransferControl &control)
        : mSource(source), mMesh(mesh), mWanted(wanted), mPlacer(source, mesh, frame),
          mControl(control), mMap{mesh, mPlacer.positions(), mResult.placed, {}, uv, uv, {}, {}}
    {
        mResult.placed.assign(static_cast<std::size_t>(mesh.faceCount()), false);
        mMap.shape.resize(mResult.placed.size());
        mSeed.assign(mResult.placed.size(), -1);
        mDoubtfulOf.assign(mResult.placed.size(), -1);
    }

    PositionUvs run()
    {
        place();
        if (mResult.stopped)
            return std::move(mResult);
        findSides();
        choose();
        for (int round = 0; round < wideningRounds; ++round) {
            widenChoice();
            choose();
        }
        joinCorners();
        mendMap(mMap, mControl.stopped);
        mResult.stopped = mControl.isStopped();
        count();
        mResult.uv = std::move(mMap.uv);
        return std::move(mResult);
    }

private:
    //! A face that can be placed in more than one way.
    struct Doubtful
    {
        int face = 0;
        std::vector<FacePlacing> placings;
        std::vector<double> prices; //!< without those of the seams around it
        std::size_t chosen = 0;
    };

    void place()
    {
        double sum = 0, sumOfAll = 0;
        int samples = 0, all = 0;
        for (int f = 0; f < mMesh.faceCount(); ++f) {
            if (mControl.progress && f % facesPerReport == 0)
                mControl.progress(double(f) / mMesh.faceCount());
            if (!mWanted[f])
                continue;
            if (mControl.isStopped()) {
                mResult.stopped = true;
                return;
            }
            std::vector<FacePlacing> placings = mPlacer.placings(f);
            ++all;
            sumOfAll += mPlacer.centreDistance();
            if (placings.empty())
                continue;
            mResult.placed[f] = true;
            const auto add = [&](double distance) {
                sum += distance;
                ++samples;
                mResult.maxDistance = std::max(mResult.maxDistance, distance);
            };
            add(mPlacer.centreDistance());
            for (std::size_t i = 0; i < placings[0].distance.size(); ++i) {
                double nearest = placings[0].distance[i];
                for (const FacePlacing &placing : placings)
                    nearest = std::min(nearest, placing.distance[i]);
                add(nearest);
            }
            take(f, placings[0]);
            if (placings.size() > 1)
                addDoubtful(f, std::move(placings));
        }
        mResult.meanDistance = samples > 0 ? sum / samples : 0;
        mResult.meanOfAll = all > 0 ? sumOfAll / all : 0;
    }

    void take(int face, const FacePlacing &placing)
    {
        const int first = mMesh.faceStart[face];
        for (std::size_t i = 0; i < placing.uv.size(); ++i) {
            mMap.uv.row(first + static_cast<int>(i)) = placing.uv[i];
            mMap.continued.row(first + static_cast<int>(i)) = placing.continued[i];
        }
        mMap.shape[face] = placing.shape;
        mSeed[face] = placing.seed;
    }

    int faultsOf(int face) const
    {
        int faults = 0;
        for (int t : mMesh.trianglesOf(face))
            faults += faultOf(mMap, t) != Fault::None;
        return faults;
    }

    //! Takes the cheapest placing for now.
    void addDoubtful(int face, std::vector<FacePlacing> placings)
    {
        Doubtful doubtful{face, std::move(placings), {}};
        const int first = mMesh.faceStart[face], end = mMesh.faceStart[face + 1];
        double perimeter = 0;
        for (int c = first; c < end; ++c)
            perimeter += (mPlacer.position(c) - mPlacer.position(c + 1 < end ? c + 1 : first)).norm();
        for (const FacePlacing &placing : doubtful.placings) {
            take(face, placing);
            const double price = placing.beyond + (faultsOf(face) > 0 ? collapsePrice * perimeter : 0);
            doubtful.prices.push_back(price);
        }
        doubtful.chosen = static_cast<std::size_t>(
            std::min_element(doubtful.prices.begin(), doubtful.prices.end()) - doubtful.prices.begin());
        take(face, doubtful.placings[doubtful.chosen]);
        if (mDoubtfulOf[face] >= 0) {
            mDoubtful[mDoubtfulOf[face]] = std::move(doubtful);
            return;
        }
        mDoubtfulOf[face] = static_cast<int>(mDoubtful.size());
        mDoubtful.push_back(std::move(doubtful));
    }

    //! For every corner, the side of another face on the same edge as the side that starts there.
    void findSides()
    {
        mPartner.assign(static_cast<std::size_t>(mMesh.cornerCount()), -1);
        for (int p = 0; p < static_cast<int>(mMesh.edgePairs.size()); ++p) {
            if (mMesh.edgePairs[p].diagonal)
                continue;
            const SidePair sides = sidePair(mMesh, p);
            mPartner[sides.startCorner[0]] = sides.startCorner[1];
            mPartner[sides.startCorner[1]] = sides.startCorner[0];
        }
    }

    int next(int corner, int face) const
    {
        return corner + 1 < mMesh.faceStart[face + 1] ? corner + 1 : mMesh.faceStart[face];
    }

    //! How far two UVs of a side of this length in the map may be apart and still be joined.
    double tolerance(double uvLength) const { return 1e-7 * mSource.uvSize() + 1e-4 * uvLength; }

    //! The length of the seams around a face that is placed like this.
    double seamsAround(int face, const FacePlacing &placing) const
    {
        const int first = mMesh.faceStart[face], end = mMesh.faceStart[face + 1];
        double length = 0;
        for (int c = first; c < end; ++c) {
            const int other = mPartner[c];
            if (other < 0)
                continue;
            const int beyond = next(other, mMap.faceOf(other)), after = next(c, face);
            if (!mMap.uv.row(other).allFinite() || !mMap.uv.row(beyond).allFinite())
                continue;
            const Vec2 &here = placing.uv[c - first], &there = placing.uv[after - first];
            const double allowed = tolerance((there - here).norm());
            if ((mMap.uv.row(beyond).transpose() - here).norm() > allowed ||
                (mMap.uv.row(other).transpose() - there).norm() > allowed)
                length += (mPlacer.position(c) - mPlacer.position(after)).norm();
        }
        return length;
    }

    bool isSeam(int corner, int face) const
    {
        const int other = mPartner[corner];
        const int after = next(corner, face), beyond = next(other, mMap.faceOf(other));
        const double allowed = tolerance((mMap.uv.row(after) - mMap.uv.row(corner)).norm());
        return (mMap.uv.row(beyond) - mMap.uv.row(corner)).norm() > allowed ||
               (mMap.uv.row(other) - mMap.uv.row(after)).norm() > allowed;
    }

    //! Lets every face beside a seam join the part of the source's map that its neighbour is in.
    void widenChoice()
    {
        for (int f = 0; f < mMesh.faceCount() && !mControl.isStopped(); ++f) {
            std::vector<int> seeds;
            for (int c = mMesh.faceStart[f]; c < mMesh.faceStart[f + 1] && mResult.placed[f]; ++c) {
                const int other = mPartner[c] < 0 ? -1 : mMap.faceOf(mPartner[c]);
                if (other >= 0 && mSeed[other] >= 0 && isSeam(c, f))
                    seeds.push_back(mSeed[other]);
            }
            if (seeds.empty())
                continue;
            std::vector<FacePlacing> placings = mPlacer.placings(f, seeds);
            if (placings.size() > 1)
                addDoubtful(f, std::move(placings));
        }
    }

    //! Makes the seams short: each doubtful face in turn takes its best placing beside its neighbours.
    void choose()
    {
        bool changed = true;
        for (int round = 0; changed && round < maxRounds && !mControl.isStopped(); ++round) {
            changed = false;
            for (Doubtful &doubtful : mDoubtful) {
                const auto price = [&](std::size_t i) {
                    return doubtful.prices[i] + seamsAround(doubtful.face, doubtful.placings[i]);
                };
                std::size_t best = doubtful.chosen;
                double bestPrice = price(best) * (1 - 1e-9);
                for (std::size_t i = 0; i < doubtful.placings.size(); ++i) {
                    if (const double other = price(i); other < bestPrice) {
                        best = i;
                        bestPrice = other;
                    }
                }
                if (best == doubtful.chosen)
                    continue;
                doubtful.chosen = best;
                take(doubtful.face, doubtful.placings[best]);
                changed = true;
            }
        }
    }

    //! Gives corners that are one in the map the same bits.
    void joinCorners()
    {
        UnionFind roots(mMesh.cornerCount());
        for (int f = 0; f < mMesh.faceCount(); ++f) {
            for (int c = mMesh.faceStart[f]; c < mMesh.faceStart[f + 1]; ++c) {
                const int other = mPartner[c];
                if (other < 0)
                    continue;
                const int after = next(c, f), beyond = next(other, mMap.faceOf(other));
                const double allowed =
                    tolerance((mMap.uv.row(c) - mMap.uv.row(after)).norm()); // NaN: not joined
                for (const auto &[a, b] : {std::pair(c, beyond), std::pair(after, other)}) {
                    if ((mMap.uv.row(a) - mMap.uv.row(b)).norm() <= allowed)
                        roots.unite(a, b);
                }
            }
        }
        mMap.at.resize(static_cast<std::size_t>(mMesh.cornerCount()));
        mMap.root.resize(mMap.at.size());
        for (int c = 0; c < mMesh.cornerCount(); ++c) {
            mMap.root[c] = roots.find(c);
            mMap.at[mMap.root[c]].push_back(c);
        }
        for (const std::vector<int> &corners : mMap.at) {
            const auto known = std::find_if(corners.begin(), corners.end(),
                                            [&](int c) { return !mResult.placed[mMap.faceOf(c)]; });
            for (int c : corners) {
                if (mResult.placed[mMap.faceOf(c)])
                    mMap.uv.row(c) = mMap.uv.row(known != corners.end() ? *known : corners.front());
            }
        }
    }

    void count()
    {
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (!mResult.placed[mMesh.triangleFace[t]])
                continue;
            const Fault fault = faultOf(mMap, t);
            mResult.turnedOver += fault == Fault::TurnedOver;
            mResult.collapsed += fault == Fault::Collapsed;
        }
    }

    const SourceSurface &mSource;
    const MeshData &mMesh;
    const std::vector<bool> &mWanted;
    FacePlacer mPlacer;
    const TransferControl &mControl;
    PositionUvs mResult;
    TransferredMap mMap;
    std::vector<Doubtful> mDoubtful;
    std::vector<int> mDoubtfulOf; //!< per face: index in mDoubtful, -1: none
    std::vector<int> mSeed;       //!< per face: triangle of the source that its placing is around
    std::vector<int> mPartner; //!< per corner: start of the other side on the edge that starts there, or -1
};

} // namespace

PositionUvs takeByPosition(const SourceSurface &source, const MeshData &mesh, const Frame &frame,
                           const UvMatrix &uv, const std::vector<bool> &wanted,
                           const TransferControl &control)
{
    return Transfer(source, mesh, frame, uv, wanted, control).run();
}

} // namespace autocuts::transfer
