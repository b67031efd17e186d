#include "support/randomedits.h"

#include "commands/changesettings.h"
#include "commands/editmapseams.h"
#include "commands/editpins.h"
#include "commands/editrectangles.h"
#include "commands/edituvsets.h"
#include "commands/islandtransform.h"
#include "commands/keepstraight.h"
#include "commands/reset.h"
#include "commands/setislandflags.h"
#include "commands/setislandtag.h"
#include "commands/setseamstate.h"
#include "commands/setseamweights.h"
#include "support/editsupport.h"

#include <algorithm>
#include <set>

namespace autocuts::test {

using namespace Qt::Literals::StringLiterals;

std::uint64_t Random::next()
{
    std::uint64_t z = (mState += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
}

std::vector<int> RandomEdits::someOf(int count)
{
    std::set<int> chosen;
    const int wanted = count == 0 ? 0 : 1 + mRandom.below(mRandom.oneIn(10) ? std::min(count, 200) : 5);
    for (int i = 0; i < wanted; ++i)
        chosen.insert(mRandom.below(count));
    return {chosen.begin(), chosen.end()};
}

void RandomEdits::select(Document &document)
{
    const auto list = [&](int count) {
        const std::vector<int> chosen = someOf(count);
        return QList<int>(chosen.begin(), chosen.end());
    };
    Selection selection;
    selection.mode = static_cast<SelectionMode>(mRandom.below(4));
    selection.faces = list(document.mesh().faceCount());
    selection.edges = list(document.adjacency().edgeCount());
    selection.corners = list(document.mesh().cornerCount());
    document.setSelection(std::move(selection));
}

std::unique_ptr<DocumentCommand> RandomEdits::next(Document &document)
{
    if (mGesture == 0 || mRandom.oneIn(3)) {
        mGesture = document.undoStack().newGesture();
        mKind = mRandom.below(16);
    }
    auto command = make(document, mKind);
    if (command->gesture() == 0 && !mRandom.oneIn(3))
        command->setGesture(mGesture);
    return command;
}

std::unique_ptr<DocumentCommand> RandomEdits::make(Document &document, int kind)
{
    switch (kind) {
    case 0:
    case 1:
        return seams(document);
    case 2:
    case 3:
        return weights(document);
    case 4:
    case 5:
        return pins(document);
    case 6:
    case 7:
        return rectangles(document);
    case 8:
    case 9:
        return uvs(document);
    case 10:
    case 11:
        return islands(document);
    case 12:
        return marks(document);
    case 13:
        return settings(document);
    case 14:
        return uvSets(document);
    default:
        break;
    }
    if (mRandom.oneIn(4))
        return std::make_unique<Reset>(document, mRandom.below(Reset::Everything + 1));
    return seams(document);
}

std::unique_ptr<DocumentCommand> RandomEdits::seams(Document &document)
{
    if (mRandom.oneIn(4))
        return std::make_unique<KeepStraight>(
            document, mRandom.oneIn(2),
            cornerPairsOfEdges(document.mesh(), someOf(document.adjacency().edgeCount())));
    const auto edit = static_cast<SetSeamState::Edit>(mRandom.below(3));
    if (mRandom.oneIn(3))
        return std::make_unique<SetSeamState>(
            document, edit, IndexRanges::fromSorted(someOf(document.mesh().cornerPairCount())));
    const std::vector<int> edges = someOf(document.adjacency().edgeCount());
    return std::make_unique<SetSeamState>(document, edit, cornerPairsOfEdges(document.mesh(), edges));
}

std::unique_ptr<DocumentCommand> RandomEdits::weights(Document &document)
{
    const std::vector<int> pairs = someOf(document.mesh().cornerPairCount());
    std::vector<double> values;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        values.push_back(mRandom.oneIn(3) ? 1.0 : 10 * mRandom.unit() - 1);
    return std::make_unique<SetSeamWeights>(document, IndexRanges::fromSorted(pairs), values);
}

std::unique_ptr<DocumentCommand> RandomEdits::pins(Document &document)
{
    const std::vector<int> corners = someOf(document.mesh().cornerCount());
    if (mRandom.oneIn(4))
        return EditPins::unpin(document, corners);
    std::vector<UvPin> pins;
    for (int corner : corners)
        pins.push_back({corner, point(), mRandom.oneIn(2), mRandom.unit()});
    if (mRandom.oneIn(2)) {
        pins = document.constraints().pins;
        for (UvPin &pin : pins)
            pin.position = point();
        return std::make_unique<EditPins>(document, EditPins::Edit::Move, pins);
    }
    return std::make_unique<EditPins>(document, EditPins::Edit::Pin, pins);
}

std::unique_ptr<DocumentCommand> RandomEdits::rectangles(Document &document)
{
    std::vector<LayoutRectangle> all = document.constraints().rectangles;
    const std::vector<int> faces = someOf(document.mesh().faceCount());
    if (all.empty() || (all.size() < 6 && mRandom.oneIn(3))) {
        LayoutRectangle rectangle;
        rectangle.name = u"r%1"_s.arg(mRandom.below(100));
        rectangle.lower = point();
        rectangle.upper = point();
        rectangle.faces = QList<int>(faces.begin(), faces.end());
        return EditRectangles::add(document, rectangle);
    }
    LayoutRectangle &one = all[mRandom.below(static_cast<int>(all.size()))];
    if (mRandom.oneIn(4))
        return EditRectangles::remove(document, std::vector<int>{one.id});
    const auto edit = static_cast<EditRectangles::Edit>(2 + mRandom.below(6));
    one.lower = edit == EditRectangles::Edit::Move ? point() : one.lower;
    one.upper = edit == EditRectangles::Edit::Resize ? point() : one.upper;
    one.faces = edit == EditRectangles::Edit::Assign ? QList<int>(faces.begin(), faces.end()) : one.faces;
    one.name = edit == EditRectangles::Edit::Rename ? u"n%1"_s.arg(mRandom.below(100)) : one.name;
    one.color = edit == EditRectangles::Edit::Recolor ? QRgb(mRandom.next() & 0xffffffff) : one.color;
    one.hard = edit == EditRectangles::Edit::Change ? !one.hard : one.hard;
    return std::make_unique<EditRectangles>(document, edit, all);
}

std::unique_ptr<DocumentCommand> RandomEdits::uvs(Document &document)
{
    UvMatrix uv = document.uv();
    if (mRandom.oneIn(8)) {
        for (int corner : someOf(static_cast<int>(uv.rows())))
            uv.row(corner) = point().transpose();
        const auto edit = mRandom.oneIn(2) ? EditMapSeams::Edit::Rip : EditMapSeams::Edit::Stitch;
        return EditMapSeams::make(document, edit, uv,
                                  someOf(static_cast<int>(document.mesh().edgePairs.size())));
    }
    if (mRandom.oneIn(8)) {
        for (Eigen::Index i = 0; i < uv.rows(); ++i)
            uv.row(i) = point().transpose();
        UvEditExtras extras;
        extras.scale = 0.1 + mRandom.unit();
        return std::make_unique<SetUvs>(document, mRandom.oneIn(2) ? UvEdit::Finish : UvEdit::Solve, uv,
                                        extras);
    }
    if (mRandom.oneIn(8))
        uv = splitLayout(document.mesh());
    for (int corner : someOf(static_cast<int>(uv.rows())))
        uv.row(corner) = point().transpose();
    return std::make_unique<SetUvs>(document, static_cast<UvEdit>(mRandom.below(9)), uv);
}

std::unique_ptr<DocumentCommand> RandomEdits::islands(Document &document)
{
    // One after the other: the order in which arguments are evaluated is the compiler's choice.
    const auto edit = static_cast<UvEdit>(mRandom.below(3));
    const IslandTransform gesture(document, edit, someOf(document.islands().count()));
    const Vec2 shift = point();
    const double angle = mRandom.unit();
    const double size = 0.5 + mRandom.unit();
    const Eigen::Affine2d transform =
        Eigen::Translation2d(shift) * Eigen::Rotation2Dd(angle) * Eigen::Scaling(size);
    return gesture.command(transform);
}

std::unique_ptr<DocumentCommand> RandomEdits::marks(Document &document)
{
    const std::vector<int> chosen = someOf(document.islands().count());
    if (mRandom.oneIn(3)) {
        const QString name = u"tag%1"_s.arg(mRandom.below(4));
        const bool on = mRandom.oneIn(2);
        return std::make_unique<SetIslandTag>(document, name, chosen, on);
    }
    return std::make_unique<SetIslandFlags>(document, static_cast<SetIslandFlags::Edit>(mRandom.below(7)),
                                            chosen);
}

std::unique_ptr<DocumentCommand> RandomEdits::settings(Document &document)
{
    SolveSettings solve = document.solveSettings();
    PackingSettings packing = document.packingSettings();
    switch (mRandom.below(5)) {
    case 0:
        solve.lambda = mRandom.unit();
        break;
    case 1:
        solve.delta = mRandom.oneIn(2) ? solve.delta / 2 : 1;
        break;
    case 2:
        packing.margin = mRandom.below(32);
        break;
    case 3:
        solve.seams = static_cast<SeamMode>(mRandom.below(3));
        solve.givenSeams.hard = mRandom.oneIn(2);
        solve.givenSeams.sharpAngle = 180 * mRandom.unit();
        break;
    default:
        packing.textureSize = 1 << mRandom.below(14);
        packing.keepScale = mRandom.oneIn(2);
        break;
    }
    return std::make_unique<ChangeSettings>(document, solve, packing);
}

std::unique_ptr<DocumentCommand> RandomEdits::uvSets(Document &document)
{
    const int count = static_cast<int>(document.uvSets().size());
    const int index = mRandom.below(count);
    const QString name = u"set%1"_s.arg(mRandom.below(5));
    switch (mRandom.below(5)) {
    case 0:
        if (count < 4)
            return std::make_unique<AddUvSet>(document, name, mRandom.oneIn(3) ? -1 : index);
        return std::make_unique<DeleteUvSet>(document, index);
    case 1:
        return std::make_unique<DeleteUvSet>(document, index);
    case 2:
        return std::make_unique<RenameUvSet>(document, index, name);
    default:
        return std::make_unique<ChooseUvSet>(document, index);
    }
}

} // namespace autocuts::test
