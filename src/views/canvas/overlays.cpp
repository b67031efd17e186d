#include "views/canvas/overlays.h"

#include "model/plain/texelweights.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/studiocontext.h"
#include "views/control/session/workspace.h"
#include "views/gl/colormap.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <vector>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Translation context of the texts.
struct Overlays
{
    Q_DECLARE_TR_FUNCTIONS(Overlays)
};

//! The content of a legend.
struct Legend
{
    QString title, low, middle, high;
    QGradientStops stops;
};

Legend stretchLegend(const ViewOptions &options, bool colorBlind)
{
    const double factor = std::exp2(options.stretchClamp);
    return {Overlays::tr("Area in UV space"), u"\u00f7%1"_s.arg(factor, 0, 'g', 3), Overlays::tr("even"),
            u"\u00d7%1"_s.arg(factor, 0, 'g', 3), heatStops(HeatMap::SignedStretch, colorBlind)};
}

Legend magnitudeLegend(const ViewOptions &options, bool colorBlind)
{
    return {Overlays::tr("Distortion"), u"4"_s, u"%1"_s.arg(0.5 * (4 + options.magnitudeClamp), 0, 'g', 3),
            u"\u2265 %1"_s.arg(options.magnitudeClamp, 0, 'g', 3), heatStops(HeatMap::Magnitude, colorBlind)};
}

Legend densityLegend(const ViewOptions &options, bool colorBlind, double right)
{
    const double unit = options.densityPerCentimetre ? 1 / options.unitCentimetres : 1;
    const auto text = [unit](double density) {
        return std::isfinite(density) ? QString::number(unit * density, 'g', 4) : u"-"_s;
    };
    const QString title =
        options.densityPerCentimetre ? Overlays::tr("Texels per cm") : Overlays::tr("Texels per unit");
    if (const double tolerance = options.densityTolerance; tolerance > 0)
        return {title, u"< "_s + text(right * (1 - tolerance)), text(right),
                u"> "_s + text(right * (1 + tolerance)), bandedDensityStops()};
    const double factor = std::exp2(options.densityClamp);
    const QString middle = options.densityTarget > 0 ? Overlays::tr("target %1") : Overlays::tr("median %1");
    return {title, u"\u2264 "_s + text(right / factor), middle.arg(text(right)),
            u"\u2265 "_s + text(right * factor), heatStops(HeatMap::Density, colorBlind)};
}

Legend texelWeightLegend(bool colorBlind)
{
    return {Overlays::tr("Texel density weight"), u"\u00f7%1"_s.arg(1 / minTexelWeight), u"\u00d71"_s,
            u"\u00d7%1"_s.arg(maxTexelWeight), heatStops(HeatMap::Density, colorBlind)};
}

Legend paintLegend(const ViewColors &colors)
{
    Legend legend{
        Overlays::tr("Painted weights"), Overlays::tr("attract cuts"), {}, Overlays::tr("keep together"), {}};
    const QRgb neutral = colors.model.rgb();
    for (int i = 0; i <= 16; ++i) // factors from 0.01 to 100
        legend.stops << QGradientStop(i / 16.0, QColor(paintColor(std::pow(10, i / 4.0 - 2), neutral)));
    return legend;
}

void drawPanel(QPainter &painter, const QRectF &box, const ViewColors &colors)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors.panel);
    painter.drawRoundedRect(box, 5, 5);
}

} // namespace

void drawMessage(QPainter &painter, const QRect &view, const ViewColors &colors, const QString &title,
                 const QStringList &lines)
{
    constexpr int margin = 24, space = 4;
    struct Text
    {
        QFont font;
        QColor color;
        QString text;
        int height;
    };
    const QFont normal = painter.font();
    QFont large = normal;
    large.setPointSizeF(large.pointSizeF() * 1.5);
    large.setWeight(QFont::DemiBold);
    std::vector<Text> texts{{large, colors.text, title, 0}};
    for (const QString &line : lines)
        texts.push_back({normal, colors.dimText, line, 0});
    int widest = 0;
    for (const Text &text : texts)
        widest = std::max(widest, QFontMetrics(text.font).horizontalAdvance(text.text));
    // Long lines are broken where the view is narrow.
    const int width = std::min(widest + 1, view.width() - 2 * margin);
    const int flags = Qt::AlignHCenter | Qt::TextWordWrap;
    int height = 0;
    for (Text &text : texts) {
        text.height = QFontMetrics(text.font)
                          .boundingRect(QRect(0, 0, width, view.height()), flags, text.text)
                          .height();
        height += text.height + space;
    }
    QRect panel(0, 0, width + 2 * margin, height + margin);
    panel.moveCenter(view.center());
    drawPanel(painter, panel, colors);
    int y = panel.top() + margin / 2;
    for (const Text &text : texts) {
        painter.setFont(text.font);
        painter.setPen(text.color);
        painter.drawText(QRect(panel.left() + margin, y, width, text.height), flags, text.text);
        y += text.height + space;
    }
    painter.setFont(normal);
}

void drawBadge(QPainter &painter, const QRect &view, const ViewColors &colors, const QString &text)
{
    const QFontMetrics metrics = painter.fontMetrics();
    const QRectF box(view.left() + 12, view.top() + 12, metrics.horizontalAdvance(text) + 20,
                     metrics.height() + 8);
    drawPanel(painter, box, colors);
    painter.setPen(QPen(colors.hover, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box, 5, 5);
    painter.setPen(colors.text);
    painter.drawText(box, Qt::AlignCenter, text);
}

QRectF drawLegend(QPainter &painter, const QRect &view, const ViewColors &colors, const ViewOptions &options,
                  bool colorBlind, double rightDensity)
{
    if (options.coloring == Coloring::Plain || options.coloring == Coloring::Islands ||
        options.coloring == Coloring::VertexColors)
        return {};
    const Legend legend =
        options.coloring == Coloring::SignedStretch      ? stretchLegend(options, colorBlind)
        : options.coloring == Coloring::StretchMagnitude ? magnitudeLegend(options, colorBlind)
        : options.coloring == Coloring::Density          ? densityLegend(options, colorBlind, rightDensity)
        : options.coloring == Coloring::TexelWeights     ? texelWeightLegend(colorBlind)
                                                         : paintLegend(colors);
    const QFontMetrics metrics = painter.fontMetrics();
    const int needed =
        44 + metrics.horizontalAdvance(legend.low + legend.middle + legend.high); // with room between them
    const int width = std::min(std::max(230, needed), view.width() - 40);
    if (width < 120)
        return {};
    const int lineHeight = metrics.height();
    const QRectF panel(view.right() - width - 12, view.bottom() - 2 * lineHeight - 38, width,
                       2 * lineHeight + 26);
    drawPanel(painter, panel, colors);
    const QRectF inner = panel.adjusted(10, 6, -10, -6);
    painter.setPen(colors.text);
    painter.drawText(inner, Qt::AlignTop | Qt::AlignHCenter, legend.title);

    const QRectF bar(inner.left(), inner.top() + lineHeight + 3, inner.width(), 9);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    gradient.setStops(legend.stops);
    painter.fillRect(bar, gradient);

    const QRectF numbers(inner.left(), bar.bottom() + 2, inner.width(), lineHeight);
    painter.setPen(colors.dimText);
    painter.drawText(numbers, Qt::AlignLeft, legend.low);
    painter.drawText(numbers, Qt::AlignHCenter, legend.middle);
    painter.drawText(numbers, Qt::AlignRight, legend.high);
    return panel;
}

void drawStraightLegend(QPainter &painter, const QRect &view, const ViewColors &colors, const QRectF &legend)
{
    constexpr int lineLength = 22;
    const QString text = Overlays::tr("Kept straight");
    const QFontMetrics metrics = painter.fontMetrics();
    const int height = metrics.height() + 8;
    QRectF box(view.left() + 30, view.bottom() - height - 30,
               metrics.horizontalAdvance(text) + lineLength + 28, height);
    if (box.intersects(legend)) // in a narrow view
        box.moveBottom(legend.top() - 6);
    drawPanel(painter, box, colors);
    const auto style = static_cast<std::size_t>(SideStyle::Straight);
    painter.setPen(QPen(colors.sides[style], 0.5 * double(colors.sideWidths[style])));
    painter.drawLine(QPointF(box.left() + 10, box.center().y()),
                     QPointF(box.left() + 10 + lineLength, box.center().y()));
    painter.setPen(colors.text);
    painter.drawText(box.adjusted(lineLength + 18, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, text);
}

void drawHoverCorner(QPainter &painter, const ToolCanvas &canvas)
{
    const Document *document = canvas.studio().workspace.document();
    const int corner = canvas.studio().view.hover().corner;
    if (!document || corner < 0 || corner >= document->mesh().cornerCount() ||
        document->selection().mode != SelectionMode::Vertices)
        return;
    const MeshData &mesh = document->mesh();
    const int face = document->adjacency().faceOfCorner(corner);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(canvas.content().colors().hover, 2));
    for (const int s : mesh.soupCornersOf(face)) {
        if (mesh.cornerOfSoup(s) != corner)
            continue;
        if (const std::optional<QPointF> place = canvas.screenOf(s)) {
            painter.drawEllipse(*place, 6, 6);
            return;
        }
    }
}

} // namespace autocuts
