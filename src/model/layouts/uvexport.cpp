#include "model/layouts/uvexport.h"

#include "model/layouts/layoutpaths.h"
#include "model/layouts/layoutstyle.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <limits>
#include <span>

namespace autocuts {

namespace {

Error layoutError(const QString &message)
{
    return {message, {}, 0, QStringLiteral("Choose a size from 16 to 16384 and a bleed from 0 to 256")};
}

using Loops = std::span<const LayoutPaths::Loop>;

//! QPainter's time for a path grows fast where it crosses itself: of more triangles, each is painted by
//! itself, and lines of such islands in pieces of so many points. Chosen by hand.
constexpr std::size_t mostAtOnce = 32;

//! Draws the paths with a QPainter, in pixels with v pointing up.
class LayoutPainter
{
public:
    LayoutPainter(QImage &image, const LayoutPaths &paths, const LayoutStyle &style, double tileHeight,
                  const std::atomic<bool> *stop)
        : mPainter(&image), mPaths(paths), mStyle(style), mStop(stop), mWidth(image.width()),
          mHeight(image.height()), mTop(tileHeight)
    {
        mPainter.setRenderHint(QPainter::Antialiasing);
    }

    void paint(const LayoutOptions &options)
    {
        paintFrame();
        if (options.fill)
            paintIslands(options.bleed);
        if (options.edges)
            paintEdges();
        paintOverlaps();
        if (options.seams)
            paintSeams();
    }

private:
    bool stopped() const { return mStop && *mStop; }

    QPointF pixel(const Vec2 &uv) const { return {uv.x() * mWidth, (mTop - uv.y()) * mWidth}; }

    QPainterPath path(Loops loops) const
    {
        QPainterPath result;
        result.setFillRule(Qt::WindingFill);
        for (const auto &loop : loops) {
            result.moveTo(pixel(loop.front()));
            for (std::size_t i = 1; i < loop.size(); ++i)
                result.lineTo(pixel(loop[i]));
            result.closeSubpath();
        }
        return result;
    }

    void drawPath(QPainter &painter, Loops loops, const QBrush &brush, double strokeWidth) const
    {
        if (strokeWidth > 0)
            painter.strokePath(path(loops),
                               QPen(brush, strokeWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        else
            painter.fillPath(path(loops), brush);
    }

    //! Paints the area of the loops, or of lines along them, once, however often they overlap.
    //! \param areTriangles there are no holes among them, so that each may be painted by itself
    //! \param replaces what was there is gone, also where the brush is transparent
    //! \param strokeWidth pixels; 0: the area
    void paintArea(const std::vector<LayoutPaths::Loop> &loops, bool areTriangles, const QBrush &brush,
                   bool replaces, double strokeWidth = 0)
    {
        if (!areTriangles || loops.size() <= mostAtOnce) {
            mPainter.setCompositionMode(replaces ? QPainter::CompositionMode_Source
                                                 : QPainter::CompositionMode_SourceOver);
            drawPath(mPainter, loops, brush, strokeWidth);
        } else {
            QImage area(static_cast<int>(mWidth), static_cast<int>(mHeight),
                        QImage::Format_ARGB32_Premultiplied);
            area.fill(Qt::transparent);
            QPainter painter(&area);
            painter.setRenderHint(QPainter::Antialiasing, strokeWidth > 0); // areas side by side: no gaps
            for (std::size_t i = 0; i < loops.size() && !stopped(); ++i)
                drawPath(painter, Loops(loops).subspan(i, 1), Qt::black, strokeWidth);
            mPainter.setCompositionMode(QPainter::CompositionMode_DestinationOut);
            if (replaces)
                mPainter.drawImage(0, 0, area);
            painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
            painter.fillRect(area.rect(), brush);
            painter.end();
            mPainter.setCompositionMode(QPainter::CompositionMode_SourceOver);
            mPainter.drawImage(0, 0, area);
        }
        mPainter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    }

    void paintFrame()
    {
        const double inset = mStyle.frameWidth / 2;
        mPainter.setPen(QPen(mStyle.frame, mStyle.frameWidth, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        mPainter.setBrush(Qt::NoBrush);
        mPainter.drawRect(QRectF(inset, inset, mWidth - 2 * inset, mHeight - 2 * inset));
    }

    void paintIslands(int bleed)
    {
        for (std::size_t i = 0; bleed > 0 && i < mPaths.islands.size() && !stopped(); ++i) {
            const QColor color = mStyle.islandColor(static_cast<int>(i));
            paintArea(mPaths.islands[i], mPaths.isTangle[i], color, false, 2.0 * bleed);
        }
        // With bleeding, islands replace what bled into them. Without it, overlapping islands are blended.
        for (std::size_t i = 0; i < mPaths.islands.size() && !stopped(); ++i)
            paintArea(mPaths.islands[i], mPaths.isTangle[i], mStyle.islandColor(static_cast<int>(i)),
                      bleed > 0);
    }

    void paintEdges()
    {
        mPainter.setPen(QPen(mStyle.edge, mStyle.edgeWidth, Qt::SolidLine, Qt::RoundCap));
        for (const auto &[a, b] : mPaths.innerEdges)
            mPainter.drawLine(pixel(a), pixel(b));
    }

    //! One tile of the diagonal hatching for overlaps.
    QImage hatchTile() const
    {
        const int side = static_cast<int>(mStyle.hatchSpacing);
        QImage tile(side, side, QImage::Format_ARGB32_Premultiplied);
        tile.fill(mStyle.overlapTint);
        QPainter painter(&tile);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(mStyle.overlap, mStyle.hatchWidth, Qt::SolidLine, Qt::FlatCap));
        for (int shift : {-side, 0, side})
            painter.drawLine(QPointF(shift - side, 2 * side), QPointF(shift + 2 * side, -side));
        return tile;
    }

    void paintOverlaps()
    {
        if (!mPaths.overlaps.empty())
            paintArea(mPaths.overlaps, true, QBrush(hatchTile()), false);
    }

    void paintSeams()
    {
        mPainter.setPen(QPen(mStyle.seam, mStyle.seamWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const bool hasTangles = std::ranges::find(mPaths.isTangle, true) != mPaths.isTangle.end();
        for (const auto &line : mPaths.borders) {
            QPolygonF polygon;
            for (const Vec2 &point : line.points)
                polygon << pixel(point);
            if (line.closed)
                polygon << polygon.first();
            const qsizetype step = hasTangles ? qsizetype(mostAtOnce) : polygon.size();
            for (qsizetype first = 0; first + 1 < polygon.size() && !stopped(); first += step)
                mPainter.drawPolyline(polygon.mid(first, step + 1));
        }
    }

    QPainter mPainter;
    const LayoutPaths &mPaths;
    const LayoutStyle &mStyle;
    const std::atomic<bool> *mStop;
    double mWidth, mHeight; //!< pixels
    double mTop;            //!< v of the upper border
};

//! Writes SVG directly: smaller than a recorded QPainter drawing, with named groups, and always the same
//! bytes.
class SvgWriter
{
public:
    SvgWriter(const LayoutPaths &paths, const LayoutStyle &style, const LayoutOptions &options)
        : mPaths(paths), mStyle(style), mOptions(options), mWidth(options.width()), mHeight(options.height())
    {}

    QByteArray write()
    {
        const QByteArray width = QByteArray::number(mWidth), height = QByteArray::number(mHeight);
        mText =
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
            width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + ' ' + height + "\">\n";
        writeHatch();
        if (mStyle.background.alpha() > 0)
            mText += "<rect width=\"100%\" height=\"100%\" fill=\"" + color(mStyle.background) + "\"/>\n";
        writeFrame();
        if (mOptions.fill && mOptions.bleed > 0)
            writeBleed(mOptions.bleed);
        if (mOptions.fill)
            writeIslands();
        if (mOptions.edges)
            writeEdges();
        writeOverlaps();
        if (mOptions.seams)
            writeSeams();
        mText += "</svg>\n";
        return mText;
    }

private:
    static QByteArray color(const QColor &c) { return c.name(QColor::HexRgb).toLatin1(); }

    static QByteArray number(double value)
    {
        QByteArray text = QByteArray::number(value, 'f', 2);
        while (text.endsWith('0'))
            text.chop(1);
        if (text.endsWith('.'))
            text.chop(1);
        return text == "-0" ? QByteArray("0") : text;
    }

    QByteArray point(const Vec2 &uv) const
    {
        return number(uv.x() * mWidth) + ' ' + number((mOptions.tileHeight - uv.y()) * mWidth);
    }

    void appendLine(const std::vector<Vec2> &points, bool closed)
    {
        mText += 'M' + point(points.front());
        for (std::size_t i = 1; i < points.size(); ++i)
            mText += 'L' + point(points[i]);
        if (closed)
            mText += 'Z';
    }

    void appendLoops(const std::vector<LayoutPaths::Loop> &loops)
    {
        for (const auto &loop : loops)
            appendLine(loop, true);
    }

    static QByteArray filling(const QColor &c)
    {
        QByteArray text = " fill=\"" + color(c) + '"';
        if (c.alpha() < 255)
            text += " fill-opacity=\"" + number(c.alphaF()) + '"';
        return text;
    }

    static QByteArray stroke(const QColor &c, double width)
    {
        QByteArray text = " fill=\"none\" stroke=\"" + color(c) + "\" stroke-width=\"" + number(width) + '"';
        if (c.alpha() < 255)
            text += " stroke-opacity=\"" + number(c.alphaF()) + '"';
        return text;
    }

    void writeHatch()
    {
        if (mPaths.overlaps.empty())
            return;
        const QByteArray side = number(mStyle.hatchSpacing);
        const QByteArray tile = "\" width=\"" + side + "\" height=\"" + side + '"';
        mText += "<defs><pattern id=\"hatch\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)" +
                 tile + "><rect" + tile.mid(1) + filling(mStyle.overlapTint) + "/><path d=\"M0 0V" + side +
                 '"' + stroke(mStyle.overlap, 2 * mStyle.hatchWidth) + "/></pattern></defs>\n";
    }

    void writeFrame()
    {
        const QByteArray inset = number(mStyle.frameWidth / 2);
        mText += "<rect id=\"frame\" x=\"" + inset + "\" y=\"" + inset + "\" width=\"" +
                 number(mWidth - mStyle.frameWidth) + "\" height=\"" + number(mHeight - mStyle.frameWidth) +
                 '"' + stroke(mStyle.frame, mStyle.frameWidth) + "/>\n";
    }

    void writeBleed(int bleed)
    {
        mText += "<g id=\"bleed\" stroke-linejoin=\"round\">\n";
        for (std::size_t i = 0; i < mPaths.islands.size(); ++i) {
            if (mPaths.islands[i].empty())
                continue;
            mText += "<path" + stroke(mStyle.islandColor(static_cast<int>(i)), 2.0 * bleed) + " d=\"";
            appendLoops(mPaths.islands[i]);
            mText += "\"/>\n";
        }
        mText += "</g>\n";
    }

    void writeIslands()
    {
        mText += "<g id=\"islands\" fill-rule=\"nonzero\">\n";
        for (std::size_t i = 0; i < mPaths.islands.size(); ++i) {
            if (mPaths.islands[i].empty())
                continue;
            const QColor fill = mStyle.islandColor(static_cast<int>(i));
            mText += "<path" + filling(fill) + " d=\"";
            appendLoops(mPaths.islands[i]);
            mText += "\"/>\n";
        }
        mText += "</g>\n";
    }

    void writeEdges()
    {
        mText += "<g id=\"edges\"" + stroke(mStyle.edge, mStyle.edgeWidth) +
                 " stroke-linecap=\"round\"><path d=\"";
        for (const auto &[a, b] : mPaths.innerEdges)
            mText += 'M' + point(a) + 'L' + point(b);
        mText += "\"/></g>\n";
    }

    void writeOverlaps()
    {
        if (mPaths.overlaps.empty())
            return;
        mText += "<g id=\"overlaps\" fill=\"url(#hatch)\" fill-rule=\"nonzero\"><path d=\"";
        appendLoops(mPaths.overlaps);
        mText += "\"/></g>\n";
    }

    void writeSeams()
    {
        mText += "<g id=\"seams\"" + stroke(mStyle.seam, mStyle.seamWidth) +
                 " stroke-linecap=\"round\" stroke-linejoin=\"round\"><path d=\"";
        for (const auto &line : mPaths.borders)
            appendLine(line.points, line.closed);
        mText += "\"/></g>\n";
    }

    const LayoutPaths &mPaths;
    const LayoutStyle &mStyle;
    const LayoutOptions &mOptions;
    int mWidth, mHeight;
    QByteArray mText;
};

} // namespace

UvMatrix withoutOtherFaces(const MeshData &mesh, const UvMatrix &uv, const std::vector<bool> &faces)
{
    UvMatrix some = uv;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        for (int corner = mesh.faceStart[face]; !faces[face] && corner < mesh.faceStart[face + 1]; ++corner)
            some.row(corner).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return some;
}

Result<QByteArray> layoutPng(const MeshData &mesh, const UvMatrix &uv, const LayoutOptions &options,
                             const std::atomic<bool> *stop)
{
    const QString problem = layoutOptionsProblem(options);
    if (!problem.isNull())
        return layoutError(problem);
    QImage image(options.width(), options.height(), QImage::Format_ARGB32_Premultiplied);
    if (image.isNull())
        return layoutError(QStringLiteral("there is not enough memory for a layout picture"));
    const LayoutPaths paths = layoutPaths(mesh, uv, options.tileHeight, options.overlapping);
    const LayoutStyle style(paths, options);
    image.fill(style.background);
    LayoutPainter(image, paths, style, options.tileHeight, stop).paint(options);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG"))
        return layoutError(QStringLiteral("the layout picture could not be encoded"));
    return bytes;
}

Result<QByteArray> layoutSvg(const MeshData &mesh, const UvMatrix &uv, const LayoutOptions &options)
{
    const QString problem = layoutOptionsProblem(options);
    if (!problem.isNull())
        return layoutError(problem);
    const LayoutPaths paths = layoutPaths(mesh, uv, options.tileHeight, options.overlapping);
    return SvgWriter(paths, LayoutStyle(paths, options), options).write();
}

} // namespace autocuts
