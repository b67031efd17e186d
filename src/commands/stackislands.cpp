#include "commands/stackislands.h"

#include "model/editing/similarislands.h"
#include "model/plain/chartcopies.h"
#include "model/plain/uvlayout.h"

#include <algorithm>
#include <map>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Gap between islands that are placed beside the map, as a share of the map's width. Chosen by hand.
constexpr double rowGap = 0.02;

bool isLocked(const Document &document, int island)
{
    return document.marks().flagsOf(document.islands().faces(island)).locked != 0;
}

std::vector<AlikeCharts> alike(const Document &document, const std::vector<int> &islands)
{
    return findAlikeCharts(document.mesh(), document.adjacency(), document.islands().charts(), islands);
}

//! True when an island lies in the map as a mirror image.
bool isMirrored(const Document &document, int island)
{
    double area = 0;
    for (const int face : document.islands().faces(island)) {
        const int first = document.mesh().faceStart[face], end = document.mesh().faceStart[face + 1];
        for (int c = first + 2; c < end; ++c) {
            area += cross2(Vec2(document.uv().row(first)), Vec2(document.uv().row(c - 1)),
                           Vec2(document.uv().row(c)));
        }
    }
    return area < 0;
}

void move(UvMatrix &uv, std::vector<UvPin> &pins, const Document &document, int corner, const Vec2 &place)
{
    uv.row(corner) = place.transpose();
    if (const UvPin *pin = document.constraints().pin(corner)) {
        pins.push_back(*pin);
        pins.back().position = place;
    }
}

//! True when each box contains the centre of the other.
bool cover(const Eigen::AlignedBox2d &a, const Eigen::AlignedBox2d &b)
{
    return a.contains(b.center()) && b.contains(a.center());
}

} // namespace

StackIslands::Found StackIslands::copiesAmong(const Document &document, const std::vector<int> &islands)
{
    std::vector<int> candidates = islands;
    if (candidates.size() == 1)
        candidates = similarIslands(document.mesh(), document.adjacency(), document.islands(),
                                    candidates.front(), Similarity::Shape);
    // Locked islands first, then by number.
    std::sort(candidates.begin(), candidates.end());
    std::stable_partition(candidates.begin(), candidates.end(),
                          [&](int island) { return isLocked(document, island); });
    Found found;
    for (const AlikeCharts &kind : alike(document, candidates)) {
        std::vector<int> stack{kind.original};
        for (const ChartCopy &copy : kind.copies) {
            if (isLocked(document, copy.chart))
                continue;
            stack.push_back(copy.chart);
            found.mirrored += copy.mirrored;
        }
        if (stack.size() > 1)
            found.stacks.push_back(std::move(stack));
    }
    return found;
}

std::unique_ptr<StackIslands> StackIslands::stack(Document &document,
                                                  const std::vector<std::vector<int>> &stacks)
{
    UvMatrix uv = document.uv();
    UvEditExtras extras;
    for (const std::vector<int> &stack : stacks) {
        for (const AlikeCharts &kind : alike(document, stack)) {
            for (const ChartCopy &copy : kind.copies) {
                for (std::size_t c = 0; c < copy.corner.size(); ++c)
                    move(uv, extras.pins, document, copy.corner[c],
                         document.uv().row(copy.source[c]).transpose());
                ++extras.count;
            }
        }
    }
    std::sort(extras.pins.begin(), extras.pins.end(),
              [](const UvPin &a, const UvPin &b) { return a.corner < b.corner; });
    return std::make_unique<StackIslands>(document,
                                          std::make_unique<SetUvs>(document, UvEdit::Move, uv, extras),
                                          SetIslandFlags::stackEach(document, stacks));
}

std::unique_ptr<StackIslands> StackIslands::unstack(Document &document, const std::vector<int> &islands)
{
    const Islands &all = document.islands();
    Eigen::AlignedBox2d map;
    std::map<int, std::vector<int>> stacks;
    for (int i = 0; i < all.count(); ++i) {
        map.extend(all.box(i));
        if (const int stack = document.marks().flagsOf(all.faces(i)).stack; stack != 0)
            stacks[stack].push_back(i);
    }
    UvMatrix uv = document.uv();
    UvEditExtras extras;
    const double gap = map.isEmpty() ? 0 : rowGap * map.sizes().x();
    double next = map.max().x() + gap;
    for (const auto &[number, stack] : stacks) {
        std::vector<int> staying;
        for (int island : stack) {
            const Eigen::AlignedBox2d &box = all.box(island);
            const bool leaves =
                std::find(islands.begin(), islands.end(), island) != islands.end() &&
                !isLocked(document, island) &&
                std::any_of(staying.begin(), staying.end(), [&](int s) { return cover(all.box(s), box); });
            if (!leaves) {
                staying.push_back(island);
                continue;
            }
            const Vec2 way(next - box.min().x(), map.min().y() - box.min().y());
            const bool turnsOver = isMirrored(document, island);
            for (int corner : all.corners(document.mesh(), {island})) {
                Vec2 place = uv.row(corner).transpose();
                if (turnsOver)
                    place.x() = box.min().x() + box.max().x() - place.x();
                move(uv, extras.pins, document, corner, place + way);
            }
            next += box.sizes().x() + gap;
            ++extras.count;
        }
    }
    std::sort(extras.pins.begin(), extras.pins.end(),
              [](const UvPin &a, const UvPin &b) { return a.corner < b.corner; });
    return std::make_unique<StackIslands>(
        document, std::make_unique<SetUvs>(document, UvEdit::Move, uv, extras),
        std::make_unique<SetIslandFlags>(document, SetIslandFlags::Edit::Unstack, islands));
}

StackIslands::StackIslands(Document &document, std::unique_ptr<SetUvs> uvs,
                           std::unique_ptr<SetIslandFlags> flags)
    : CommandGroup(document)
{
    add(std::move(uvs));
    add(std::move(flags));
}

void StackIslands::writePayload(QCborMap &map) const
{
    map["uvs"_L1] = payloadOf(0);
    map["flags"_L1] = payloadOf(1);
}

std::unique_ptr<StackIslands> StackIslands::fromCbor(Document &document, CborReader &reader)
{
    CborReader uvReader(reader.map("uvs"_L1)), flagReader(reader.map("flags"_L1));
    auto uvs = SetUvs::fromCbor(document, uvReader);
    auto flags = SetIslandFlags::fromCbor(document, flagReader);
    if (reader.failed() || !uvs || !flags)
        return nullptr;
    return std::make_unique<StackIslands>(document, std::move(uvs), std::move(flags));
}

} // namespace autocuts
