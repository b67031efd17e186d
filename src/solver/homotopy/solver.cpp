#include "solver/homotopy/solver.h"

#include "solver/homotopy/initialuv.h"

#include <algorithm>
#include <stdexcept>

namespace autocuts::homotopy {

namespace {

std::unique_ptr<newton::NewtonDirection> makeDirection(const std::shared_ptr<const Soup> &soup,
                                                       SolverKind kind, const std::vector<Pin> &hardPins,
                                                       ThreadTeam *team)
{
    const int corners = soup->mesh->soupCornerCount();
    if (kind == SolverKind::Exact) {
        newton::UnknownMap map = newton::UnknownMap::identity(corners);
        for (const Pin &pin : hardPins)
            map.unknown[pin.soupCorner] = -1;
        int count = 0;
        for (int &u : map.unknown) {
            if (u >= 0)
                u = count++;
        }
        map.count = count;
        return newton::makeExactDirection(soup, std::move(map));
    }
    std::vector<bool> held;
    if (!hardPins.empty()) {
        held.assign(corners, false);
        for (const Pin &pin : hardPins)
            held[pin.soupCorner] = true;
    }
    return newton::makeHubDirection(soup, std::move(held), team);
}

std::vector<Pin> pinsOf(const Steering &steering, bool hard)
{
    std::vector<Pin> pins;
    std::copy_if(steering.pins.begin(), steering.pins.end(), std::back_inserter(pins),
                 [hard](const Pin &pin) { return pin.hard == hard; });
    return pins;
}

//! True when the settings differ at most in lambda and delta.
bool sameButBalance(SolveSettings a, const SolveSettings &b)
{
    a.lambda = b.lambda;
    a.delta = b.delta;
    return a == b;
}

bool sameCorners(const std::vector<Pin> &a, const std::vector<Pin> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Pin &p, const Pin &q) { return p.soupCorner == q.soupCorner; });
}

} // namespace

Solver::Solver() = default;
Solver::~Solver() = default;

void Solver::load(const Snapshot &snapshot)
{
    mSnapshot = snapshot;
    mSoup = Soup::build(snapshot.mesh);
    mX = initialUv(*mSoup, snapshot);
    mIteration = 0;
    if (!mTeam)
        mTeam = std::make_unique<ThreadTeam>();
    mHardPins = pinsOf(*snapshot.steering, true);
    mMinimizer = std::make_unique<newton::Minimizer>(
        mSoup, makeDirection(mSoup, snapshot.settings.solver, mHardPins, mTeam.get()), mTeam.get());
    rebuildTerms();
}

void Solver::update(const Snapshot &snapshot)
{
    if (!mSoup || snapshot.mesh != mSoup->mesh)
        throw std::invalid_argument("another mesh than the one loaded");
    if (snapshot.steering == mSnapshot.steering && sameButBalance(snapshot.settings, mSnapshot.settings)) {
        mSnapshot = snapshot;
        setBalance();
        mMinimizer->invalidate();
        return;
    }
    std::vector<Pin> hard = pinsOf(*snapshot.steering, true);
    const bool newUnknowns =
        snapshot.settings.solver != mSnapshot.settings.solver || !sameCorners(hard, mHardPins);
    mSnapshot = snapshot;
    mHardPins = std::move(hard);
    if (newUnknowns)
        mMinimizer = std::make_unique<newton::Minimizer>(
            mSoup, makeDirection(mSoup, snapshot.settings.solver, mHardPins, mTeam.get()), mTeam.get());
    rebuildTerms();
}

void Solver::rebuildTerms()
{
    const SolveSettings &settings = mSnapshot.settings;
    mDistortion = energy::makeDistortionTerm(mSoup, settings.energy, mTeam.get());
    mSeparation = std::make_unique<energy::SeparationTerm>(mSoup, mTeam.get());
    mSeparation->setWeights(energy::pairWeights(*mSoup, mSnapshot));
    setBalance();
    const Steering &steering = *mSnapshot.steering;
    mPins = std::make_unique<energy::PinTerm>(pinsOf(steering, false));
    mBoxes = std::make_unique<energy::BoxTerm>(steering.rectangles, settings.boxWeight);
    std::vector<const energy::EnergyTerm *> terms{mDistortion.get(), mSeparation.get()};
    if (!steering.pins.empty())
        terms.push_back(mPins.get());
    if (!steering.rectangles.empty())
        terms.push_back(mBoxes.get());
    mMinimizer->setTerms(std::move(terms));
}

void Solver::setBalance()
{
    mDistortion->setFactor(1 - mSnapshot.settings.lambda);
    mSeparation->setFactor(mSnapshot.settings.lambda);
    mSeparation->setDelta(mSnapshot.settings.delta);
}

//! Moves each hard-pinned corner towards its target as far as its own triangle allows.
void Solver::pullHardPins()
{
    for (const Pin &pin : mHardPins) {
        double *triangle = &mX[6 * static_cast<std::size_t>(pin.soupCorner / 3)];
        const int k = pin.soupCorner % 3;
        const Vec2 p(triangle[2 * k], triangle[2 * k + 1]);
        const Vec2 a(triangle[2 * ((k + 1) % 3)], triangle[2 * ((k + 1) % 3) + 1]);
        const Vec2 b(triangle[2 * ((k + 2) % 3)], triangle[2 * ((k + 2) % 3) + 1]);
        const double before = cross2(p, a, b);
        const double after = cross2(pin.target, a, b);
        // The area changes linearly with the movement; one step may take at most nine tenths of it.
        const double share = after >= 0.1 * before ? 1 : 0.9 * before / (before - after);
        const Vec2 moved = share == 1 ? pin.target : Vec2(p + share * (pin.target - p));
        triangle[2 * k] = moved.x();
        triangle[2 * k + 1] = moved.y();
    }
}

//! Value of a term whose factor is zero at present.
template <class Term>
double Solver::unweighted(Term &term) const
{
    term.setFactor(1);
    const double value = term.value(mX);
    term.setFactor(0);
    return value;
}

void Solver::setThreads(int threads)
{
    mTeam = std::make_unique<ThreadTeam>(threads);
}

StepResult Solver::step()
{
    pullHardPins();
    const newton::Minimizer::Step step = mMinimizer->step(mX);
    StepResult result;
    result.iteration = ++mIteration;
    result.energy = step.after;
    result.stepLength = step.length;
    const double lambda = mSnapshot.settings.lambda;
    result.distortion = lambda < 1 ? step.values[0] / (1 - lambda) : unweighted(*mDistortion);
    result.separation = lambda > 0 ? step.values[1] / lambda : unweighted(*mSeparation);
    return result;
}

void Solver::setCoordinates(std::vector<double> x)
{
    mX = std::move(x);
    mMinimizer->invalidate();
}

double finalDelta(const Soup &soup)
{
    std::vector<double> lengths = soup.pairLength;
    if (lengths.empty())
        return 0.09 * soup.meanEdgeLength * soup.meanEdgeLength;
    const auto fifth = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 20);
    std::nth_element(lengths.begin(), fifth, lengths.end());
    return std::min(0.09 * soup.meanEdgeLength * soup.meanEdgeLength, 0.25 * *fifth * *fifth);
}

} // namespace autocuts::homotopy
