#include "views/gl/trianglesinstrip.h"

#include <algorithm>

namespace autocuts {

namespace {

//! What a triangle costs beside its pixels, in pixels. Measured with llvmpipe: 100,000 triangles smaller than
//! a pixel took as long as 1.5 million pixels.
constexpr double ownWeight = 16;
//! Triangles outside of the strip that are drawn with their neighbours, so that runs are long.
constexpr int mostBetween = 32;
//! Triangles that are looked at in one call: some two milliseconds. Chosen by hand.
constexpr int mostLookedAt = 40'000;

} // namespace

TriangleRuns trianglesInStrip(const MapOnPixels &map, double lowRow, double highRow, double mostWeight,
                              int &next)
{
    TriangleRuns runs;
    const double edge = 1; // a triangle may touch the pixels beside it
    int end = -1;          // of the last run
    const int stop = std::min(next + mostLookedAt, map.triangleCount());
    for (; next < stop && runs.weight < mostWeight; ++next) {
        const bool hovered = next >= map.hoverTriangles[0] && next < map.hoverTriangles[1];
        const int marks = map.faces[next].marks;
        if ((marks & FaceTexel::Hidden) || (!hovered && (marks & FaceTexel::Buried)))
            continue;
        const float *uv = &map.uvs[6 * static_cast<std::size_t>(next)];
        const auto [left, right] = std::minmax({uv[0], uv[2], uv[4]});
        const auto [low, high] = std::minmax({uv[1], uv[3], uv[5]});
        if (!(right < noUv))
            continue;
        const double width = std::min(double(right) * map.scale.x() + map.offset.x() + edge, map.width) -
                             std::max(double(left) * map.scale.x() + map.offset.x() - edge, 0.0);
        const double height = std::min(double(high) * map.scale.y() + map.offset.y() + edge, highRow) -
                              std::max(double(low) * map.scale.y() + map.offset.y() - edge, lowRow);
        if (width <= 0 || height <= 0)
            continue;
        const double weight = ownWeight + width * height;
        if (runs.weight > 0 && runs.weight + weight > mostWeight)
            break;
        if (end < 0 || next - end > mostBetween) {
            runs.first.push_back(3 * next);
            runs.count.push_back(0);
        }
        runs.weight += weight;
        end = next + 1;
        runs.count.back() = 3 * end - runs.first.back();
    }
    return runs;
}

} // namespace autocuts
