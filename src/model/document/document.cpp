#include "model/document/document.h"

#include "model/document/givenseams.h"
#include "model/plain/texelweights.h"
#include "model/plain/uvlayout.h"

#include <algorithm>
#include <atomic>

namespace autocuts {

namespace {

std::uint64_t newRevision()
{
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

//! True when the event changes something that the solver reads.
bool steers(const RectangleEvent &event)
{
    return (event.properties & ~(RectangleEvent::Name | RectangleEvent::Color)) != 0;
}

} // namespace

Document::Document(Scene scene) : Document(DocumentState::initial(std::move(scene))) {}

Document::Document(DocumentState state)
    : mState(std::move(state)), mToken{newRevision(), newRevision(), newRevision(), newRevision()}
{
    findHidden();
    mState.selection.removeHidden(mesh(), mHidden);
}

Document::~Document() = default;

Result<std::unique_ptr<Document>> Document::create(DocumentState state)
{
    if (const QString problem = state.validate(); !problem.isEmpty())
        return Error{problem, state.scene.path, 0, {}};
    return std::make_unique<Document>(std::move(state));
}

void Document::announce(const ChangeEvent &event)
{
    switch (event.type) {
    case ChangeEvent::Type::Model:
        mToken = {newRevision(), newRevision(), newRevision(), newRevision()};
        break;
    case ChangeEvent::Type::UvSet:
        mToken.topology = newRevision();
        break;
    case ChangeEvent::Type::Uv:
        mToken.uv = newRevision();
        break;
    case ChangeEvent::Type::Rectangle:
        if (!steers(static_cast<const RectangleEvent &>(event))) {
            mToken.layout = newRevision();
            break;
        }
        [[fallthrough]];
    case ChangeEvent::Type::Seam:
    case ChangeEvent::Type::Pin:
    case ChangeEvent::Type::TexelWeight:
    case ChangeEvent::Type::SolveSettings:
        mToken.steering = newRevision();
        break;
    case ChangeEvent::Type::IslandFlag:
    case ChangeEvent::Type::Tag:
    case ChangeEvent::Type::PackingSettings:
        mToken.layout = newRevision();
        break;
    case ChangeEvent::Type::Textures:
    case ChangeEvent::Type::SharedMeshes:
    case ChangeEvent::Type::Hidden: // no result depends on it
        break;
    }
    if (changesGivenSeams(event))
        mGivenSeams.reset();
    Q_EMIT changed(event);
}

const Islands &Document::islands() const
{
    if (!mIslands)
        mIslands = std::make_unique<const Islands>(mesh(), uv());
    return *mIslands;
}

const SoupMap &Document::soupMap() const
{
    if (!mSoupMap)
        mSoupMap = std::make_unique<const SoupMap>(SoupMap::of(mesh(), uv()));
    return *mSoupMap;
}

//! Of what is cached, what depends on the active map.
void Document::forgetMap()
{
    mIslands.reset();
    mSoupMap.reset();
}

std::vector<double> Document::texelWeights() const
{
    return mState.texelWeights.empty()
               ? std::vector<double>(static_cast<std::size_t>(mesh().faceCount()), 1.0)
               : mState.texelWeights;
}

const std::shared_ptr<const MeshData> &Document::weightedMesh() const
{
    if (!mWeightedMesh)
        mWeightedMesh = withTexelWeights(mState.scene.mesh, mState.texelWeights);
    return mWeightedMesh;
}

const std::vector<bool> &Document::givenSeams() const
{
    if (!mGivenSeams) {
        const SolveSettings &settings = solveSettings();
        mGivenSeams = settings.seams == SeamMode::Free
                          ? std::vector<bool>()
                          : autocuts::givenSeams(mState.scene, &uv(), seams().states, settings.givenSeams);
    }
    return *mGivenSeams;
}

const MeshAdjacency &Document::adjacency() const
{
    if (!mAdjacency)
        mAdjacency = std::make_unique<const MeshAdjacency>(mesh());
    return *mAdjacency;
}

void Document::setSelection(Selection selection)
{
    selection.normalize(mesh());
    selection.removeHidden(mesh(), mHidden);
    if (selection == mState.selection)
        return;
    mState.selection = std::move(selection);
    Q_EMIT selectionChanged();
}

void Document::findHidden()
{
    const QList<int> &faces = mState.hiddenFaces;
    mHidden.assign(faces.isEmpty() ? 0 : static_cast<std::size_t>(mesh().faceCount()), false);
    for (int face : faces)
        mHidden[static_cast<std::size_t>(face)] = true;
}

QString Document::validate() const
{
    if (mIslands && mIslands->faceCount() != mesh().faceCount())
        return QStringLiteral("The islands do not fit the mesh");
    return mState.validate();
}

} // namespace autocuts
