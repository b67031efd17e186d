#include "solver/packing/raster.h"

#include <algorithm>
#include <bit>

namespace autocuts::packing {

namespace {

//! Bitmap in which an item is drawn before its runs are read.
class Canvas
{
public:
    Canvas(int width, int rows) : mStride(width / 64 + 1), mRows(rows), mWidth(width)
    {
        mBits.assign(std::size_t(mStride) * rows, 0);
    }

    //! Sets the pixels whose centres lie in [x0, x1].
    void fill(int row, double x0, double x1)
    {
        const int begin = std::max(0, static_cast<int>(std::ceil(x0 - 0.5)));
        const int end = std::min(mWidth, static_cast<int>(std::floor(x1 - 0.5)) + 1);
        if (begin >= end)
            return;
        std::uint64_t *bits = mBits.data() + std::size_t(row) * mStride;
        const int first = begin >> 6, last = (end - 1) >> 6;
        const std::uint64_t head = ~0ULL << (begin & 63), tail = ~0ULL >> (63 - ((end - 1) & 63));
        if (first == last) {
            bits[first] |= head & tail;
            return;
        }
        bits[first] |= head;
        for (int w = first + 1; w < last; ++w)
            bits[w] = ~0ULL;
        bits[last] |= tail;
    }

    void readRuns(std::vector<PixelRun> &runs) const
    {
        for (int r = 0; r < mRows; ++r) {
            const std::uint64_t *bits = mBits.data() + std::size_t(r) * mStride;
            int x = 0;
            while ((x = next(bits, x, 0)) < mWidth) {
                const int end = std::min(mWidth, next(bits, x, ~0ULL));
                runs.push_back({r, x, end - x});
                x = end;
            }
        }
    }

    int rows() const { return mRows; }

private:
    //! The first pixel from x on that is set (invert = 0) or clear (invert = all ones).
    int next(const std::uint64_t *bits, int x, std::uint64_t invert) const
    {
        for (int w = x >> 6; w < mStride; ++w) {
            std::uint64_t word = bits[w] ^ invert;
            if (w == x >> 6)
                word &= ~0ULL << (x & 63);
            if (word)
                return 64 * w + std::countr_zero(word);
        }
        return 64 * mStride;
    }

    int mStride, mRows, mWidth;
    std::vector<std::uint64_t> mBits;
};

//! Fills the pixels whose centres are within `radius` of the segment a, b. Row centres are at integer + .5.
void drawCapsule(Canvas &canvas, const Vec2 &a, const Vec2 &b, double radius)
{
    const Vec2 d = b - a;
    const double length = d.norm();
    const Vec2 n = length > 0 ? Vec2(-d.y() / length * radius, d.x() / length * radius) : Vec2(0, 0);
    const int first = std::max(0, static_cast<int>(std::ceil(std::min(a.y(), b.y()) - radius - 0.5)));
    const int last =
        std::min(canvas.rows() - 1, static_cast<int>(std::floor(std::max(a.y(), b.y()) + radius - 0.5)));
    for (int row = first; row <= last; ++row) {
        const double y = row + 0.5;
        double x0 = 1e300, x1 = -1e300;
        for (const Vec2 &end : {a, b}) {
            const double h = radius * radius - (y - end.y()) * (y - end.y());
            if (h >= 0) {
                const double w = std::sqrt(h);
                x0 = std::min(x0, end.x() - w);
                x1 = std::max(x1, end.x() + w);
            }
        }
        if (d.y() != 0) {
            for (const double side : {-1.0, 1.0}) {
                const double t = (y - a.y() - side * n.y()) / d.y();
                if (t >= 0 && t <= 1) {
                    const double x = a.x() + side * n.x() + t * d.x();
                    x0 = std::min(x0, x);
                    x1 = std::max(x1, x);
                }
            }
        }
        canvas.fill(row, x0, x1);
    }
}

struct Crossing
{
    int row;
    double x;
    int winding;
};

//! Fills the pixels whose centres have a winding number other than zero.
void fillInside(Canvas &canvas, const Outline &outline, const std::vector<Vec2> &points, double &operations)
{
    static thread_local std::vector<Crossing> crossings;
    crossings.clear();
    for (const Outline::Edge &e : outline.edges) {
        const bool up = points[e.a].y() < points[e.b].y();
        const Vec2 &low = up ? points[e.a] : points[e.b];
        const Vec2 &high = up ? points[e.b] : points[e.a];
        if (e.winding == 0 || low.y() == high.y())
            continue;
        const double slope = (high.x() - low.x()) / (high.y() - low.y());
        const int last = std::min(canvas.rows() - 1, static_cast<int>(std::ceil(high.y() - 0.5)) - 1);
        for (int row = std::max(0, static_cast<int>(std::ceil(low.y() - 0.5))); row <= last; ++row)
            crossings.push_back({row, low.x() + (row + 0.5 - low.y()) * slope, up ? -e.winding : e.winding});
    }
    std::sort(crossings.begin(), crossings.end(), [](const Crossing &a, const Crossing &b) {
        return a.row < b.row || (a.row == b.row && a.x < b.x);
    });
    int winding = 0;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        if (i > 0 && crossings[i].row != crossings[i - 1].row)
            winding = 0;
        else if (i > 0 && winding != 0)
            canvas.fill(crossings[i].row, crossings[i - 1].x, crossings[i].x);
        winding += crossings[i].winding;
    }
    operations += 12 * static_cast<double>(crossings.size());
}

//! Puts runs into bit-reversed order: the first ones are spread over the item and soon meet an obstacle.
void bitReverse(std::vector<PixelRun> &runs)
{
    std::vector<PixelRun> result;
    result.reserve(runs.size());
    const auto size = std::bit_ceil(runs.size());
    const int bits = std::countr_zero(size);
    for (std::size_t i = 0; i < size; ++i) {
        std::size_t j = 0;
        for (int b = 0; b < bits; ++b)
            j |= ((i >> b) & 1) << (bits - 1 - b);
        if (j < runs.size())
            result.push_back(runs[j]);
    }
    runs.swap(result);
}

//! blocked |= row shifted down by `shift` bits.
inline void orShifted(std::uint64_t *__restrict blocked, const std::uint64_t *__restrict row, int shift,
                      int count)
{
    const std::uint64_t *source = row + (shift >> 6);
    const int low = shift & 63;
    if (low == 0) {
        for (int i = 0; i < count; ++i)
            blocked[i] |= source[i];
    } else {
        for (int i = 0; i < count; ++i)
            blocked[i] |= (source[i] >> low) | (source[i + 1] << (64 - low));
    }
}

} // namespace

ItemRaster rasterizeOutline(const Outline &outline, double angle, double pixelsPerUnit, double halfGutter,
                            double safety, WorkMeter &work)
{
    ItemRaster item;
    item.angle = angle;
    std::vector<Vec2> points;
    placePoints(outline, {angle, Vec2::Zero()}, pixelsPerUnit, points);
    Eigen::AlignedBox2d box;
    for (const Vec2 &p : points)
        box.extend(p);
    item.low = box.min();
    item.size = box.sizes();
    const Vec2 shift = Vec2::Constant(halfGutter + BinRaster::frame) - box.min();
    for (Vec2 &p : points)
        p += shift;
    const double radius = halfGutter + safety;
    const double extent = 2 * (halfGutter + BinRaster::frame);
    Canvas canvas(static_cast<int>(item.size.x() + extent) + 1, static_cast<int>(item.size.y() + extent) + 1);
    double operations = 300;
    fillInside(canvas, outline, points, operations);
    for (const Outline::Edge &e : outline.edges) {
        drawCapsule(canvas, points[e.a], points[e.b], radius);
        operations += 15 + 15 * (std::abs(points[e.a].y() - points[e.b].y()) + 2 * radius);
    }
    canvas.readRuns(item.runs);
    double pixels = 0;
    for (const PixelRun &run : item.runs) {
        item.rows = std::max(item.rows, run.row + 1);
        item.centroidRow += static_cast<double>(run.length) * run.row;
        pixels += run.length;
    }
    item.centroidRow /= std::max(1.0, pixels);
    bitReverse(item.runs);
    work.add(operations + 8 * static_cast<double>(item.runs.size()));
    return item;
}

BinRaster::BinRaster(int width, int height)
    : mWidth(width), mHeight(height), mRows(height + 2 * frame + 2),
      mLevels(std::bit_width(static_cast<unsigned>(width + 2 * frame))),
      // A shifted read goes up to one width beyond the row's end.
      mStride(2 * ((width + 2 * frame) / 64 + 1) + 1)
{
    clear();
}

void BinRaster::clear()
{
    mBits.assign(std::size_t(mRows) * mLevels * mStride, 0);
}

void BinRaster::setRun(int row, int begin, int end)
{
    std::uint64_t *bits = words(row, 0);
    for (int x = begin; x < end;) {
        const int stop = std::min(end, (x | 63) + 1);
        bits[x >> 6] |= (~0ULL << (x & 63)) & (~0ULL >> (63 - ((stop - 1) & 63)));
        x = stop;
    }
}

void BinRaster::rebuildLevels(int row)
{
    for (int k = 1; k < mLevels; ++k) {
        std::uint64_t *bits = words(row, k);
        const std::uint64_t *finer = words(row, k - 1);
        const int used = (mWidth + 2 * frame) / 64 + 1;
        std::copy(finer, finer + used, bits);
        orShifted(bits, finer, 1 << (k - 1), used);
    }
}

void BinRaster::occupy(const ItemRaster &item, int x, int y)
{
    for (const PixelRun &run : item.runs)
        setRun(run.row + y, run.begin + x, run.begin + x + run.length);
    for (int r = 0; r < item.rows; ++r)
        rebuildLevels(r + y);
}

void BinRaster::occupyClipped(const ItemRaster &item, int x, int y)
{
    for (const PixelRun &run : item.runs) {
        const int begin = std::max(0, run.begin + x),
                  end = std::min(mWidth + 2 * frame, run.begin + x + run.length);
        if (run.row + y >= 0 && run.row + y < mRows && begin < end)
            setRun(run.row + y, begin, end);
    }
    for (int r = std::max(0, y); r < std::min(mRows, y + item.rows); ++r)
        rebuildLevels(r);
}

int BinRaster::firstFree(const ItemRaster &item, int y, int lastX, WorkMeter &work) const
{
    constexpr int maxWords = 4096 / 64 + 2;
    std::uint64_t blocked[maxWords];
    const int count = lastX / 64 + 1;
    std::fill(blocked, blocked + count, 0);
    if ((lastX & 63) != 63)
        blocked[count - 1] = ~0ULL << ((lastX & 63) + 1);
    int used = 0;
    for (const PixelRun &run : item.runs) {
        const int level = std::bit_width(static_cast<unsigned>(run.length)) - 1;
        const std::uint64_t *row = words(run.row + y, level);
        const int second = run.length - (1 << level);
        orShifted(blocked, row, run.begin, count);
        if (second > 0)
            orShifted(blocked, row, run.begin + second, count);
        ++used;
        if (used % 2 == 0) {
            std::uint64_t all = ~0ULL;
            for (int i = 0; i < count; ++i)
                all &= blocked[i];
            if (all == ~0ULL)
                break;
        }
    }
    work.add(6 + used * (3 + 1.1 * count));
    for (int i = 0; i < count; ++i) {
        if (~blocked[i])
            return 64 * i + std::countr_zero(~blocked[i]);
    }
    return -1;
}

} // namespace autocuts::packing
