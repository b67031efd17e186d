#include "support/commandcases.h"

#include "commands/editmapseams.h"
#include "commands/edittextures.h"
#include "commands/edituvsets.h"
#include "commands/hidefaces.h"
#include "commands/islandtransform.h"
#include "commands/keepstraight.h"
#include "commands/makeunique.h"
#include "commands/newmap.h"
#include "commands/reset.h"
#include "commands/setislandtag.h"
#include "commands/setseamweights.h"
#include "commands/settexelweights.h"
#include "commands/stackislands.h"
#include "support/editsupport.h"

#include <cmath>

namespace autocuts::test {

using namespace Qt::Literals::StringLiterals;

std::vector<int> plainEdges(const Document &document, int first, int count)
{
    std::vector<int> edges;
    for (int e = first; static_cast<int>(edges.size()) < count; ++e) {
        if (!document.mesh().edgePairs[e].diagonal)
            edges.push_back(e);
    }
    return edges;
}

Make seams(SetSeamState::Edit edit, int first, int count)
{
    return [=](Document &d) {
        const IndexRanges pairs = cornerPairsOfEdges(d.mesh(), plainEdges(d, first, count));
        return std::make_unique<SetSeamState>(d, edit, pairs);
    };
}

Make straight(bool on, int first, int count)
{
    return [=](Document &d) {
        const IndexRanges pairs = cornerPairsOfEdges(d.mesh(), plainEdges(d, first, count));
        return std::make_unique<KeepStraight>(d, on, pairs);
    };
}

Make paint(int firstPair, int count, double weight)
{
    return [=](Document &d) {
        IndexRanges pairs;
        pairs.append(IndexRange{firstPair, firstPair + count});
        return std::make_unique<SetSeamWeights>(d, pairs, std::vector<double>(count, weight));
    };
}

Make texelWeights(int firstFace, int count, double weight)
{
    return [=](Document &d) {
        IndexRanges faces;
        faces.append(IndexRange{firstFace, firstFace + count});
        return SetTexelWeights::uniform(d, faces, weight);
    };
}

Make rectangle(EditRectangles::Edit edit, int id, std::function<void(LayoutRectangle &)> change)
{
    return [=](Document &d) {
        LayoutRectangle r = *d.constraints().rectangle(id);
        change(r);
        return std::make_unique<EditRectangles>(d, edit, std::vector<LayoutRectangle>{r});
    };
}

LayoutRectangle named(const QString &name)
{
    LayoutRectangle r;
    r.name = name;
    return r;
}

Make pins(EditPins::Edit edit, std::vector<UvPin> values)
{
    return [=](Document &d) { return std::make_unique<EditPins>(d, edit, values); };
}

Make uvs(UvEdit edit, int corner, double u, UvEditExtras extras)
{
    return [=](Document &d) {
        UvMatrix uv = d.uv();
        uv(corner, 0) = u;
        return std::make_unique<SetUvs>(d, edit, uv, extras);
    };
}

Make transform(UvEdit edit, Eigen::Affine2d by, std::vector<int> islands)
{
    return [=](Document &d) { return IslandTransform(d, edit, islands).command(by); };
}

Make solve(std::function<void(SolveSettings &)> change)
{
    return [=](Document &d) {
        SolveSettings s = d.solveSettings();
        change(s);
        return std::make_unique<ChangeSettings>(d, s);
    };
}

Make packing(std::function<void(PackingSettings &)> change)
{
    return [=](Document &d) {
        PackingSettings s = d.packingSettings();
        change(s);
        return std::make_unique<ChangeSettings>(d, s);
    };
}

Make flags(SetIslandFlags::Edit edit, std::vector<int> islands)
{
    return [=](Document &d) { return std::make_unique<SetIslandFlags>(d, edit, islands); };
}

Make tag(QString name, std::vector<int> islands, bool on)
{
    return [=](Document &d) { return std::make_unique<SetIslandTag>(d, name, islands, on); };
}

Make hide(QList<int> faces)
{
    return [=](Document &d) { return HideFaces::change(d, faces, true); };
}

//! A picture of normals for the faces without a material; none for an empty name.
Make textures(const QString &file)
{
    return [=](Document &d) {
        TextureSet set;
        if (!file.isEmpty())
            set[TextureChannel::Normal] = {{file, {}}, -1, true, 0.5};
        return EditTextures::ofMaterial(d, -1, set);
    };
}

Make reset(int parts)
{
    return [=](Document &d) { return std::make_unique<Reset>(d, parts); };
}

Eigen::Affine2d moved(double u, double v)
{
    return Eigen::Affine2d(Eigen::Translation2d(u, v));
}

namespace {

// Of the two islands of gridDocument() the first one has a locked face; the second has the odd pairs of
// columns. Island 1 owns the corners 8-15, 24-31, 40-47 and 56-63, with a pin at 40.
const QString secondIsland = u"8-15,24-31,40-47,56-63"_s;

std::vector<Case> seamCases()
{
    using Edit = SetSeamState::Edit;
    return {
        {"cut",
         seams(Edit::Cut, 30, 4),
         "Cut 4 edges",
         {u"seam 1: 60-61,64-67,70-71"_s},
         seams(Edit::Cut, 30, 0)},
        {"cut one", seams(Edit::Cut, 30, 1), "Cut 1 edges", {u"seam 1: 60-61"_s}, nullptr},
        {"join",
         seams(Edit::Join, 30, 2),
         "Join 2 edges",
         {u"seam 1: 60-61,64-65"_s},
         seams(Edit::Join, 30, 0)},
        {"clear", seams(Edit::Clear, 0, 3), "Clear 3 edges", {}, seams(Edit::Clear, 30, 4)},
        {"keep straight", // of the four edges one is kept straight already
         straight(true, 30, 4),
         "Keep 3 edges straight",
         {u"seam 4: 60-61,64-65,70-71"_s},
         straight(true, 30, 0)},
        {"release",
         straight(false, 30, 4),
         "Release 1 straight edges",
         {u"seam 4: 66-67"_s},
         straight(false, 0, 3)},
        {"paint", paint(64, 3, 0.25), "Paint 2 edges", {u"seam 2: 64-66"_s}, paint(64, 3, 1)},
    };
}

//! A map in which corner 3, which has a pin, moves, and the edges of it.
Make mapSeams(EditMapSeams::Edit edit, double u, int first, int count)
{
    return [=](Document &d) {
        UvMatrix uv = d.uv();
        uv(3, 0) = u;
        return EditMapSeams::make(d, edit, uv, plainEdges(d, first, count));
    };
}

std::vector<Case> mapSeamCases()
{
    using Edit = EditMapSeams::Edit;
    return {
        {"rip",
         mapSeams(Edit::Rip, 3, 30, 2),
         "Rip 2 edges",
         {u"uv 1 set 0: 3-3"_s, u"pin 3-3"_s, u"seam 1: 60-61,64-65"_s},
         mapSeams(Edit::Rip, 0, 30, 0)},
        {"stitch", // of the two edges one was cut
         mapSeams(Edit::Stitch, 3, 30, 2),
         "Stitch 2 edges",
         {u"uv 1 set 0: 3-3"_s, u"pin 3-3"_s, u"seam 1: 64-65"_s},
         mapSeams(Edit::Stitch, 0, 0, 3)},
        {"tear",
         mapSeams(Edit::Tear, 3, 30, 2),
         "Tear 2 edges",
         {u"uv 1 set 0: 3-3"_s, u"pin 3-3"_s, u"seam 1: 60-61,64-65"_s},
         mapSeams(Edit::Tear, 0, 30, 0)},
    };
}

std::vector<Case> rectangleCases()
{
    using Edit = EditRectangles::Edit;
    const auto same = [](LayoutRectangle &) {};
    return {
        {"add rectangle",
         [](Document &d) { return EditRectangles::add(d, named(u"foot"_s)); },
         "Add rectangle",
         {u"rectangle 2: 1"_s},
         [](Document &d) {
             LayoutRectangle bad;
             bad.weight = -1;
             return EditRectangles::add(d, bad);
         }},
        {"remove rectangle",
         [](Document &d) {
             return EditRectangles::remove(d, std::vector<int>{1, 4});
         },
         "Remove 2 rectangles",
         {u"rectangle 1: 2"_s, u"rectangle 4: 2"_s},
         [](Document &d) { return EditRectangles::remove(d, std::vector<int>{3}); }},
        {"move rectangle",
         rectangle(Edit::Move, 1,
                   [](LayoutRectangle &r) {
                       r.lower = {1, 1}, r.upper = {2, 2};
                   }),
         "Move 1 rectangles",
         {u"rectangle 1: 4"_s},
         rectangle(Edit::Move, 1, same)},
        {"resize rectangle",
         rectangle(Edit::Resize, 1,
                   [](LayoutRectangle &r) {
                       r.lower = {0.9, 0.9};
                   }),
         "Resize 1 rectangles",
         {u"rectangle 1: 4"_s},
         rectangle(Edit::Resize, 1, same)},
        {"assign faces",
         rectangle(Edit::Assign, 4,
                   [](LayoutRectangle &r) {
                       r.faces = {2, 3};
                   }),
         "Assign faces to 1 rectangles",
         {u"rectangle 4: 8"_s},
         rectangle(Edit::Assign, 4,
                   [](LayoutRectangle &r) {
                       r.faces = {3, 2};
                   })},
        {"rename rectangle",
         rectangle(Edit::Rename, 4, [](LayoutRectangle &r) { r.name = u"arm"_s; }),
         "Rename 1 rectangles",
         {u"rectangle 4: 16"_s},
         rectangle(Edit::Rename, 4, same)},
        {"recolor rectangle",
         rectangle(Edit::Recolor, 4, [](LayoutRectangle &r) { r.color = 0xff000000; }),
         "Recolor 1 rectangles",
         {u"rectangle 4: 32"_s},
         rectangle(Edit::Recolor, 4, same)},
        {"harden rectangle",
         rectangle(Edit::Change, 1, [](LayoutRectangle &r) { r.hard = true; }),
         "Change 1 rectangles",
         {u"rectangle 1: 64"_s},
         rectangle(Edit::Change, 1, same)},
    };
}

std::vector<Case> pinCases()
{
    using Edit = EditPins::Edit;
    const UvPin old{3, {0.25, 0.5}, true, 1};
    return {
        {"pin",
         pins(Edit::Pin, {{5, {1, 2}, true, 1}, {6, {1, 3}, true, 1}}),
         "Pin 2 corners",
         {u"pin 5-5"_s, u"pin 6-6"_s},
         pins(Edit::Pin, {old, {64, {0, 0}, true, 1}})},
        {"unpin",
         [](Document &d) {
             return EditPins::unpin(d, std::vector<int>{3, 9});
         },
         "Unpin 1 corners",
         {u"pin 3-3"_s},
         [](Document &d) { return EditPins::unpin(d, std::vector<int>{9}); }},
        {"move pin",
         pins(Edit::Move, {{3, {0.5, 0.5}, true, 1}}),
         "Move 1 pins",
         {u"pin 3-3"_s},
         pins(Edit::Move, {old})},
        {"soften pin",
         pins(Edit::Change, {{3, {0.25, 0.5}, false, 4}}),
         "Change 1 pins",
         {u"pin 3-3"_s},
         pins(Edit::Change, {{3, {std::nan(""), 0}, false, 4}})},
    };
}

std::vector<Case> uvCases()
{
    const Eigen::Affine2d turned(Eigen::Rotation2Dd(1));
    const Eigen::Affine2d doubled(Eigen::Scaling(2.0));
    const QString second = u"uv 1 set 0: "_s + secondIsland;
    const auto stay = [](UvEdit edit) { return transform(edit, Eigen::Affine2d::Identity(), {1}); };
    const auto none = [](UvEdit edit) { return uvs(edit, 7, 0.25); };
    return {
        {"move islands",
         transform(UvEdit::Move, moved(0.5, 0.25), {1}),
         "Move 1 islands",
         {second, u"pin 40-40"_s},
         transform(UvEdit::Move, moved(1, 0), {1})},
        {"rotate islands",
         transform(UvEdit::Rotate, turned, {0, 1}),
         "Rotate 1 islands",
         {second, u"pin 40-40"_s},
         stay(UvEdit::Rotate)},
        {"scale islands", transform(UvEdit::Scale, doubled, {1}), "Scale 1 islands", {}, stay(UvEdit::Scale)},
        {"drag vertices",
         uvs(UvEdit::Drag, 7, 3, {1, {}, {}}),
         "Drag 1 vertices",
         {u"uv 1 set 0: 7-7"_s},
         none(UvEdit::Drag)},
        {"solver result", uvs(UvEdit::Solve, 7, 3), "Solve", {u"uv 1 set 0: 7-7"_s}, none(UvEdit::Solve)},
        {"unwrap", uvs(UvEdit::Unwrap, 7, 3), "Unwrap", {u"uv 1 set 0: 7-7"_s}, none(UvEdit::Unwrap)},
        {"finish",
         uvs(UvEdit::Finish, 7, 3, {0, 0.125, {}}),
         "Finish map",
         {u"uv 1 set 0: 7-7"_s, u"uv 2 set 0:"_s},
         none(UvEdit::Finish)},
        {"pack",
         uvs(UvEdit::Pack, 7, 3, {2, 0.25, {}}),
         "Pack 2 islands",
         {u"uv 1 set 0: 7-7"_s, u"uv 2 set 0:"_s},
         none(UvEdit::Pack)},
        {"separate",
         uvs(UvEdit::Separate, 7, 3),
         "Separate overlaps",
         {u"uv 1 set 0: 7-7"_s},
         none(UvEdit::Separate)},
        {"align to the axes", // the faces of the island count as aligned from then on
         [](Document &d) {
             UvMatrix uv = d.uv();
             uv(7, 0) = 3;
             std::vector<IslandFlags> flags = d.marks().faceFlags;
             flags[0].aligned = flags[1].aligned = 1;
             return newMapCommand(d, UvEdit::AlignToAxes, uv, 1, flags);
         },
         "Align 1 islands to the axes",
         {u"uv 1 set 0: 7-7"_s, u"flag 16: 0-1"_s, u"uv 2 set 0:"_s},
         [](Document &d) { return newMapCommand(d, UvEdit::AlignToAxes, d.uv(), 1); }},
        {"clear UVs", reset(Reset::Uvs), "Clear UVs", {u"uv 1 set 0: 0-63"_s, u"uv 2 set 0:"_s}, nullptr},
    };
}

std::vector<Case> settingsCases()
{
    return {
        {"lambda",
         solve([](SolveSettings &s) { s.lambda = 0.5; }),
         "Change lambda",
         {u"solve 1"_s},
         solve([](SolveSettings &s) { s.lambda = 2; })},
        {"delta",
         solve([](SolveSettings &s) { s.delta = 0.5; }),
         "Change delta",
         {u"solve 2"_s},
         solve([](SolveSettings &s) { s.delta = 0; })},
        {"several",
         solve([](SolveSettings &s) { s.seed = 2, s.energy = DistortionEnergy::Amips; }),
         "Change settings",
         {u"solve 136"_s},
         solve([](SolveSettings &) {})},
        {"whose seams",
         solve([](SolveSettings &s) { s.seams = SeamMode::Keep; }),
         "Change whose seams",
         {u"solve 4096"_s},
         solve([](SolveSettings &s) { s.seams = SeamMode(3); })},
        {"sources of seams",
         solve([](SolveSettings &s) { s.givenSeams.hard = true, s.givenSeams.map = false; }),
         "Change sources of given seams",
         {u"solve 8192"_s},
         solve([](SolveSettings &s) { s.givenSeams.cuts = true; })},
        {"sharp angle",
         solve([](SolveSettings &s) { s.givenSeams.sharpAngle = 45.5; }),
         "Change angle of sharp edges",
         {u"solve 16384"_s},
         solve([](SolveSettings &s) { s.givenSeams.sharpAngle = 181; })},
        {"margin",
         packing([](PackingSettings &s) { s.margin = 4; }),
         "Change margin",
         {u"packing 2"_s},
         packing([](PackingSettings &s) { s.margin = -1; })},
        {"tile",
         packing([](PackingSettings &s) { s.udimTile = 1012; }),
         "Change UDIM tile",
         {u"packing 4"_s},
         packing([](PackingSettings &s) { s.udimTile = 0; })},
    };
}

std::vector<Case> uvSetCases()
{
    return {
        {"choose UV set",
         [](Document &d) { return std::make_unique<ChooseUvSet>(d, 1); },
         "Choose UV set",
         {u"set 3 1"_s},
         [](Document &d) { return std::make_unique<ChooseUvSet>(d, 0); }},
        {"add UV set",
         [](Document &d) { return std::make_unique<AddUvSet>(d, u"first"_s); },
         "Add UV set",
         {u"set 0 2"_s, u"set 3 2"_s},
         nullptr},
        {"copy UV set",
         [](Document &d) { return std::make_unique<AddUvSet>(d, u"copy"_s, 0); },
         "Add UV set",
         {u"set 0 2"_s, u"set 3 2"_s},
         nullptr},
        {"rename UV set",
         [](Document &d) { return std::make_unique<RenameUvSet>(d, 1, u"bake"_s); },
         "Rename UV set",
         {u"set 2 1"_s},
         [](Document &d) { return std::make_unique<RenameUvSet>(d, 1, u"first"_s); }},
        {"delete UV set",
         [](Document &d) { return std::make_unique<DeleteUvSet>(d, 0); },
         "Delete UV set",
         {u"set 1 0"_s, u"set 3 0"_s},
         nullptr},
    };
}

std::vector<Case> markCases()
{
    using Edit = SetIslandFlags::Edit;
    return {
        {"lock",
         flags(Edit::Lock, {1}),
         "Lock 1 islands",
         {u"flag 1: 2-3,6-7,10-11,14-15"_s},
         flags(Edit::Lock, {})},
        {"unlock",
         flags(Edit::Unlock, {0, 1}),
         "Unlock 1 islands",
         {u"flag 1: 2-2"_s},
         flags(Edit::Unlock, {0})},
        {"stack", flags(Edit::Stack, {0, 1}), "Stack 2 islands", {u"flag 2: 0-15"_s}, flags(Edit::Stack, {})},
        {"stack copies",
         [](Document &d) {
             return StackIslands::stack(d, StackIslands::copiesAmong(d, {0, 1}).stacks);
         },
         "Stack 2 islands",
         {},
         [](Document &d) { return StackIslands::stack(d, {}); }},
        {"unstack", flags(Edit::Unstack, {1}), "Unstack 1 islands", {}, flags(Edit::Unstack, {0})},
        {"group",
         flags(Edit::Group, {0}),
         "Group 1 islands",
         {u"flag 4: 0-1,4-5,8-9,12-13"_s},
         flags(Edit::Group, {})},
        {"ungroup", flags(Edit::Ungroup, {1}), "Ungroup 1 islands", {}, flags(Edit::Ungroup, {0})},
        {"keep orientation",
         flags(Edit::KeepOrientation, {1}),
         "Keep orientation of 1 islands",
         {u"flag 8: 2-3,6-7,10-11,14-15"_s},
         flags(Edit::KeepOrientation, {})},
        {"free orientation",
         flags(Edit::FreeOrientation, {0, 1}),
         "Free orientation of 1 islands",
         {u"flag 8: 2-2"_s},
         flags(Edit::FreeOrientation, {0})},
        {"tag", tag(u"metal"_s, {1}, true), "Tag 1 islands", {u"tag metal"_s}, tag(u""_s, {1}, true)},
        {"texel weights",
         texelWeights(3, 4, 2.5),
         "Texel density weight of 4 faces",
         {u"texels 3-6"_s},
         texelWeights(3, 4, 1)},
        {"texel weight out of range",
         texelWeights(15, 1, 100),
         "Texel density weight of 1 faces",
         {u"texels 15-15"_s},
         texelWeights(0, 0, 2)},
        {"hide", hide({0, 1, 7}), "Hide 3 faces", {u"hidden"_s}, hide({})},
        {"textures",
         textures(u"/pictures/wood_Normal.<UDIM>.png"_s),
         "Add 1 textures",
         {u"textures"_s},
         textures({})},
        {"make unique",
         [](Document &d) { return std::make_unique<MakeUnique>(d); },
         "Make meshes unique",
         {u"shared meshes"_s},
         nullptr},
        {"untag",
         tag(u"skin"_s, {0}, false),
         "Untag 1 islands",
         {u"tag skin"_s},
         tag(u"metal"_s, {0}, false)},
    };
}

std::vector<Case> resetCases()
{
    return {
        {"reset seams", reset(Reset::SeamStates), "Reset seams", {}, nullptr},
        {"reset weights", reset(Reset::SeamWeights), "Reset painted weights", {}, nullptr},
        {"reset pins", reset(Reset::Pins), "Remove all pins", {u"pin 3-3"_s, u"pin 40-40"_s}, nullptr},
        {"reset rectangles",
         reset(Reset::Rectangles),
         "Remove all rectangles",
         {u"rectangle 1: 2"_s, u"rectangle 4: 2"_s},
         nullptr},
        {"reset marks",
         reset(Reset::Marks),
         "Reset island marks",
         {u"flag 1: 2-2"_s, u"tag skin"_s},
         nullptr},
        {"reset texel weights",
         reset(Reset::TexelWeights),
         "Reset texel density weights",
         {u"texels 5-5"_s},
         reset(0)},
        {"reset steering", reset(Reset::Steering), "Reset steering", {}, reset(Reset::Settings)},
        {"reset everything", reset(Reset::Everything), "Reset everything", {}, reset(0)},
    };
}

} // namespace

const std::vector<Case> &commandCases()
{
    static const std::vector<Case> all = [] {
        std::vector<Case> result;
        for (const auto &some : {seamCases(), mapSeamCases(), rectangleCases(), pinCases(), uvCases(),
                                 settingsCases(), uvSetCases(), markCases(), resetCases()})
            result.insert(result.end(), some.begin(), some.end());
        return result;
    }();
    return all;
}

std::unique_ptr<Document> startFor(const Case &c)
{
    DocumentState state = gridDocument()->state();
    const QByteArray name = c.name;
    if (name == "unstack" || name == "ungroup") {
        for (int face : {2, 3})
            state.marks.faceFlags[face].stack = state.marks.faceFlags[face].group = 3;
    }
    if (name == "move islands" || name == "rotate islands" || name == "scale islands")
        state.marks.faceFlags[0].locked = 1;
    if (name == "stitch")
        state.seams.states[64] = state.seams.states[65] = PairState::Cut;
    if (name == "reset texel weights") {
        state.texelWeights.assign(static_cast<std::size_t>(state.scene.mesh->faceCount()), 1.0);
        state.texelWeights[5] = 3;
    }
    state.marks.faceFlags[2].upright = name == "free orientation";
    state.marks.faceFlags[2].locked = name == "unlock" || name == "reset marks";
    return std::move(*Document::create(std::move(state)).operator->());
}

} // namespace autocuts::test
