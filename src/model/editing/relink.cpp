#include "model/editing/relink.h"

#include "model/editing/newfaces.h"
#include "model/plain/polygonsides.h"
#include "model/plain/texelweights.h"
#include "model/plain/uvlayout.h"
#include "model/transfer/facematch.h"
#include "model/transfer/partmatch.h"
#include "model/transfer/positiontransfer.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

struct RelinkTexts
{
    Q_DECLARE_TR_FUNCTIONS(Relink)
};

bool areFew(const FaceMatch &match, const MeshData &before)
{
    return 2LL * match.count() < before.faceCount();
}

//! Where most faces lie elsewhere, by their vertices: the model was moved or deformed, and some faces are
//! gone or new.
FaceMatch matchVersions(const MeshData &before, const MeshData &after)
{
    FaceMatch match = matchFaces(before, after);
    if (!areFew(match, before))
        return match;
    FaceMatch byNumbers = matchFacesByNumbers(before, after);
    return areFew(byNumbers, before) ? match : byNumbers;
}

//! Transfers the parts of a state, one after the other.
class Carrier
{
public:
    Carrier(const DocumentState &from, Scene scene, const std::function<bool()> &stopped)
        : mFrom(from), mBefore(*from.scene.mesh), mAfter(*scene.mesh), mInPlace(scene.mesh),
          mMatch(matchVersions(mBefore, mAfter)), mStopped(stopped)
    {
        findPlacement();
        if (!mMatch.sameTopology)
            matchParts(mBefore, mAfter, mMatch);
        mTo.scene = std::move(scene);
        mTo.scene.uniqueMeshes = from.scene.uniqueMeshes;
        mReport.sameTopology = mMatch.sameTopology;
        std::vector<bool> known(static_cast<std::size_t>(mAfter.faceCount()), false);
        for (int face : mMatch.face) {
            ++(face >= 0 ? mReport.faces.kept : mReport.faces.lost);
            if (face >= 0)
                known[static_cast<std::size_t>(face)] = true;
        }
        for (int face = 0; face < mAfter.faceCount(); ++face) {
            if (!known[static_cast<std::size_t>(face)])
                mReport.newFaces << face;
        }
    }

    Relinked run()
    {
        carryUvs();
        carrySeams();
        carryPins();
        carryRectangles();
        carryMarks();
        carryTexelWeights();
        mTo.hiddenFaces = counterparts(mFrom.hiddenFaces, mMatch.face);
        carryTextureSets();
        mTo.solveSettings = mFrom.solveSettings;
        mTo.packingSettings = mFrom.packingSettings;
        mTo.viewState = mFrom.viewState;
        mTo.selection.mode = mFrom.selection.mode;
        mTo.selection.faces = counterparts(mFrom.selection.faces, mMatch.face);
        mTo.selection.corners = counterparts(mFrom.selection.corners, mMatch.corner);
        return {std::move(mTo), std::move(mReport)};
    }

private:
    //! Compares in other units and axes where most faces have no counterpart.
    void findPlacement()
    {
        const bool elsewhere = transfer::liesElsewhere(mAfter, mBefore);
        if (!areFew(mMatch, mBefore) && !elsewhere)
            return;
        for (const transfer::Placement &placement : transfer::likelyPlacements(mAfter, mBefore)) {
            const auto there = transfer::placed(mAfter, placement);
            FaceMatch match = matchFaces(mBefore, *there);
            const bool better = match.sameTopology || match.count() > mMatch.count();
            // Without counterparts the boxes decide, and only where it does not lie in its place.
            if (!better && !(elsewhere && mReport.placement.isIdentity() && mMatch.count() == 0))
                continue;
            mMatch = std::move(match);
            mInPlace = there;
            mReport.placement = placement;
            if (mMatch.sameTopology)
                return;
        }
    }

    //! Texture sets go with the names of their materials.
    void carryTextureSets()
    {
        const std::vector<QString> &from = mFrom.scene.materialNames, &to = mTo.scene.materialNames;
        std::map<QString, std::size_t> places; // the first of each name
        for (std::size_t material = 0; material < to.size(); ++material)
            places.try_emplace(to[material], material + 1);
        mTo.textureSets.assign(to.size() + 1, {});
        for (std::size_t set = 0; set < mFrom.textureSets.size(); ++set) {
            const auto found = set == 0 ? places.end() : places.find(from[set - 1]);
            if (set == 0)
                mTo.textureSets[0] = mFrom.textureSets[0];
            else if (found != places.end())
                mTo.textureSets[found->second] = mFrom.textureSets[set];
        }
        mTo.textureSets = withoutEmptyEnd(std::move(mTo.textureSets));
    }
    static QList<int> counterparts(const QList<int> &indices, const std::vector<int> &match)
    {
        QList<int> result;
        for (int index : indices) {
            if (match[index] >= 0)
                result.append(match[index]);
        }
        std::sort(result.begin(), result.end());
        return result;
    }

    //! The scale is the texture length of a unit in which the whole mesh has area pi, so it changes with the
    //! share of the kept faces in the whole area.
    double scaleFactor() const
    {
        double before = 0;
        double after = 0;
        for (int t = 0; t < mBefore.triangleCount(); ++t) {
            if (mMatch.face[mBefore.triangleFace[t]] >= 0)
                before += mBefore.triangleArea[t];
        }
        std::vector<bool> kept(static_cast<std::size_t>(mAfter.faceCount()), false);
        for (int face : mMatch.face) {
            if (face >= 0)
                kept[face] = true;
        }
        for (int t = 0; t < mAfter.triangleCount(); ++t) {
            if (kept[mAfter.triangleFace[t]])
                after += mAfter.triangleArea[t];
        }
        const double factor = std::sqrt(before / mBefore.area / (after / mAfter.area));
        return std::isfinite(factor) && factor > 0 ? factor : 1;
    }

    void carryUvs()
    {
        const double factor = mMatch.sameTopology ? 1 : scaleFactor();
        mTo.scene.uvSets.clear();
        for (const UvSet &set : mFrom.scene.uvSets) {
            UvSet carried{set.name, emptyLayout(mAfter)};
            for (int c = 0; c < mBefore.cornerCount(); ++c) {
                if (mMatch.corner[c] >= 0)
                    carried.uv.row(mMatch.corner[c]) = set.uv.row(c);
            }
            mTo.scene.uvSets.push_back(std::move(carried));
            placeNewFaces(set.uv);
        }
        for (double scale : mFrom.uvScales) {
            const double carried = scale * factor;
            mTo.uvScales.push_back(std::isfinite(carried) && carried > 0 ? carried : scale);
        }
        mTo.activeUvSet = mFrom.activeUvSet;
    }

    //! Gives the new faces UVs in the last UV set: those of the nearest points of the old model where that
    //! has faces that are gone. What is left, or would lie on other faces, goes beside the map.
    void placeNewFaces(const UvMatrix &before)
    {
        if (mReport.newFaces.isEmpty() || (mStopped && mStopped()))
            return;
        const transfer::Frame frame = transfer::frameOf(mBefore);
        const transfer::SourceSurface whole(mBefore, before, frame);
        if (whole.triangleCount() == 0)
            return;
        std::vector<bool> wanted(static_cast<std::size_t>(mAfter.faceCount()), false);
        for (int face : mReport.newFaces)
            wanted[face] = true;
        UvMatrix &uv = mTo.scene.uvSets.back().uv;
        const auto placedOf = [](const transfer::PositionUvs &uvs) {
            return static_cast<int>(std::count(uvs.placed.begin(), uvs.placed.end(), true));
        };
        transfer::PositionUvs found = takeByPosition(whole, *mInPlace, frame, uv, wanted, {mStopped, {}});
        if (found.stopped || transfer::isApart(mReport.faces.kept + placedOf(found), mAfter.faceCount()))
            return;
        // The places of faces that stay are taken.
        UvMatrix gone = before;
        for (int c = 0; c < mBefore.cornerCount(); ++c) {
            if (mMatch.corner[c] >= 0)
                gone.row(c).setConstant(std::numeric_limits<double>::quiet_NaN());
        }
        const transfer::SourceSurface free(mBefore, gone, frame);
        if (free.triangleCount() > 0)
            found = takeByPosition(free, *mInPlace, frame, uv, wanted, {mStopped, {}});
        if (found.stopped)
            return;
        if (free.triangleCount() > 0)
            uv = std::move(found.uv);
        const int beside = layBeside(*mInPlace, uv, wanted);
        if (static_cast<int>(mTo.scene.uvSets.size()) == mFrom.activeUvSet + 1) {
            mReport.besideFaces = beside;
            mReport.placedFaces = static_cast<int>(mReport.newFaces.size()) - beside;
        }
    }

    void carrySeams()
    {
        mTo.seams = Seams::allFree(mAfter);
        const std::vector<int> pairs = edgePairsBySide(mAfter);
        const Seams plain = Seams::allFree(mBefore);
        for (int p = 0; p < static_cast<int>(mBefore.edgePairs.size()); ++p) {
            const auto isPlain = [&](int pair) {
                return mFrom.seams.states[pair] == plain.states[pair] &&
                       mFrom.seams.weights[pair] == plain.weights[pair] &&
                       mFrom.seams.straight[pair] == plain.straight[pair];
            };
            if (isPlain(2 * p) && isPlain(2 * p + 1))
                continue;
            const SidePair before = sidePair(mBefore, p);
            const std::array<int, 2> corners{mMatch.corner[before.startCorner[0]],
                                             mMatch.corner[before.startCorner[1]]};
            const int pair = corners[0] >= 0 && corners[1] >= 0 ? pairs[corners[0]] : -1;
            if (pair < 0 || pairs[corners[1]] != pair) {
                ++mReport.seams.lost;
                continue;
            }
            const SidePair after = sidePair(mAfter, pair);
            const std::size_t swapped = after.startCorner[0] != corners[0];
            for (std::size_t end = 0; end < 2; ++end) {
                mTo.seams.states[after.cornerPair[end ^ swapped]] =
                    mFrom.seams.states[before.cornerPair[end]];
                mTo.seams.weights[after.cornerPair[end ^ swapped]] =
                    mFrom.seams.weights[before.cornerPair[end]];
                mTo.seams.straight[after.cornerPair[end ^ swapped]] =
                    mFrom.seams.straight[before.cornerPair[end]];
            }
            ++mReport.seams.kept;
        }
    }

    void carryPins()
    {
        auto &pins = mTo.constraints.pins;
        for (UvPin pin : mFrom.constraints.pins) {
            pin.corner = mMatch.corner[pin.corner];
            if (pin.corner >= 0)
                pins.push_back(pin);
            else
                ++mReport.pins.lost;
        }
        std::sort(pins.begin(), pins.end(),
                  [](const UvPin &a, const UvPin &b) { return a.corner < b.corner; });
        mReport.pins.kept = static_cast<int>(pins.size());
    }

    void carryRectangles()
    {
        for (LayoutRectangle rectangle : mFrom.constraints.rectangles) {
            const QList<int> faces = counterparts(rectangle.faces, mMatch.face);
            mReport.rectangleFaces.kept += static_cast<int>(faces.size());
            mReport.rectangleFaces.lost += static_cast<int>(rectangle.faces.size() - faces.size());
            rectangle.faces = faces;
            mTo.constraints.rectangles.push_back(std::move(rectangle));
        }
    }

    void carryMarks()
    {
        mTo.marks = IslandMarks::none(mAfter);
        for (int f = 0; f < mBefore.faceCount(); ++f) {
            const IslandFlags &flags = mFrom.marks.faceFlags[f];
            if (flags == IslandFlags())
                continue;
            if (mMatch.face[f] >= 0)
                mTo.marks.faceFlags[mMatch.face[f]] = flags;
            ++(mMatch.face[f] >= 0 ? mReport.markedFaces.kept : mReport.markedFaces.lost);
        }
        for (const IslandTag &tag : mFrom.marks.tags) {
            const QList<int> faces = counterparts(tag.faces, mMatch.face);
            if (faces.isEmpty())
                mReport.lostTags << tag.name;
            else
                mTo.marks.tags.push_back({tag.name, faces});
        }
    }

    void carryTexelWeights()
    {
        if (mFrom.texelWeights.empty())
            return;
        std::vector<double> weights(static_cast<std::size_t>(mAfter.faceCount()), 1.0);
        for (int f = 0; f < mBefore.faceCount(); ++f) {
            if (mFrom.texelWeights[f] == 1)
                continue;
            if (mMatch.face[f] >= 0)
                weights[mMatch.face[f]] = mFrom.texelWeights[f];
            ++(mMatch.face[f] >= 0 ? mReport.weightedFaces.kept : mReport.weightedFaces.lost);
        }
        mTo.texelWeights = storedTexelWeights(std::move(weights));
    }

    const DocumentState &mFrom;
    const MeshData &mBefore;
    const MeshData &mAfter;
    std::shared_ptr<const MeshData> mInPlace; //!< the new model where it is compared with the old one
    FaceMatch mMatch;
    const std::function<bool()> &mStopped;
    DocumentState mTo;
    RelinkReport mReport;
};

} // namespace

QStringList RelinkReport::lines() const
{
    QStringList lines;
    if (placement.scale != 1)
        lines << RelinkTexts::tr("the new model has other units: %1 of its units are one of the old model")
                     .arg(1 / placement.scale, 0, 'g', 4);
    if (placement.turn != 0)
        lines << RelinkTexts::tr("the new model has another axis up: it was turned to be compared");
    const auto add = [&](const Carried &carried, const QString &text) {
        if (carried.lost > 0)
            lines << text.arg(carried.lost).arg(carried.kept + carried.lost);
    };
    add(faces, placedFaces > 0
                   ? RelinkTexts::tr("%1 of %2 faces are not in the new model")
                   : RelinkTexts::tr("%1 of %2 faces are not in the new model: their UVs are lost"));
    if (placedFaces > 0)
        lines << RelinkTexts::tr("new faces with the UVs of the old model's nearest points: %1")
                     .arg(placedFaces);
    if (besideFaces > 0)
        lines << RelinkTexts::tr("new faces that lie flat beside the map and are still to be unwrapped: %1")
                     .arg(besideFaces);
    if (const auto bare = newFaces.size() - placedFaces - besideFaces; bare > 0)
        lines << RelinkTexts::tr("new faces without UVs: %1").arg(bare);
    add(seams, RelinkTexts::tr("%1 of %2 cut, joined, painted or straight edges are lost"));
    add(pins, RelinkTexts::tr("%1 of %2 pins are lost"));
    add(rectangleFaces, RelinkTexts::tr("%1 of %2 assignments of faces to rectangles are lost"));
    add(markedFaces, RelinkTexts::tr("%1 of %2 faces that are locked, stacked or grouped are lost"));
    add(weightedFaces, RelinkTexts::tr("%1 of %2 faces with a painted texel density are lost"));
    if (!lostTags.isEmpty())
        lines << RelinkTexts::tr("tags of which no face is left: %1").arg(lostTags.join(u", "_s));
    return lines;
}

Relinked relinkDocument(const DocumentState &state, Scene newScene, const std::function<bool()> &stopped)
{
    return Carrier(state, std::move(newScene), stopped).run();
}

Scene completedHanded(Scene handed, const Scene &own)
{
    const bool samePolygons =
        own.mesh->faceStart == handed.mesh->faceStart && own.mesh->cornerVertex == handed.mesh->cornerVertex;
    if (samePolygons)
        handed.cornerColors = own.cornerColors;
    if (samePolygons && handed.materialNames.empty()) {
        handed.materialNames = own.materialNames;
        handed.faceMaterial = own.faceMaterial;
        handed.materialTextures = own.materialTextures;
        handed.materialSets = own.materialSets;
    }
    if (own.materialNames == handed.materialNames)
        handed.materialColors = own.materialColors;
    return handed;
}

} // namespace autocuts
