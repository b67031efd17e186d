#include "solver/bake/dilation.h"

#include "model/plain/parallel.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace autocuts::bake {

namespace {

constexpr int none = -1;
constexpr int rowsPerJob = 16;

//! Per texel of a row: the column of the nearest texel with a value in this row within the margin, or none.
//! Of two at the same distance, the left one.
void findInRow(const std::uint8_t *filled, int width, int margin, int *columns)
{
    int last = none;
    for (int x = 0; x < width; ++x) {
        if (filled[x])
            last = x;
        columns[x] = last != none && x - last <= margin ? last : none;
    }
    last = none;
    for (int x = width - 1; x >= 0; --x) {
        if (filled[x])
            last = x;
        if (last != none && last - x <= margin && (columns[x] == none || last - x < x - columns[x]))
            columns[x] = last;
    }
}

} // namespace

void dilate(Picture &picture, std::vector<std::uint8_t> &filled, int margin, const JobContext &job)
{
    const int width = picture.width, height = picture.height;
    if (margin < 1 || picture.isEmpty())
        return;
    std::vector<int> nearestColumn(filled.size());
    const int jobs = (height + rowsPerJob - 1) / rowsPerJob;
    const auto forRows = [&](auto &&work) {
        parallelFor(jobs, job.threads(), [&](int part) {
            for (int y = part * rowsPerJob; y < std::min(height, (part + 1) * rowsPerJob); ++y) {
                if (!job.stopped())
                    work(y);
            }
        });
    };
    forRows([&](int y) {
        findInRow(filled.data() + std::size_t(y) * width, width, margin,
                  nearestColumn.data() + std::size_t(y) * width);
    });
    std::vector<std::uint8_t> grown = filled;
    forRows([&](int y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t texel = std::size_t(y) * width + x;
            if (filled[texel])
                continue;
            int best = margin * margin + 1, fromX = 0, fromY = none;
            const auto look = [&](int row) {
                const int column =
                    row >= 0 && row < height ? nearestColumn[std::size_t(row) * width + x] : none;
                if (column == none)
                    return;
                const int squared = (column - x) * (column - x) + (row - y) * (row - y);
                if (squared < best) {
                    best = squared;
                    fromX = column;
                    fromY = row;
                }
            };
            look(y);
            for (int away = 1; away <= margin && away * away < best; ++away) {
                look(y - away);
                look(y + away);
            }
            if (fromY == none)
                continue;
            // Only texels that had a value before are read, and only others are written.
            std::ranges::copy(std::as_const(picture).at(fromX, fromY), picture.at(x, y).begin());
            grown[texel] = 1;
        }
    });
    filled = std::move(grown);
}

} // namespace autocuts::bake
