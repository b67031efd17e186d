// Draws what bench_solver --json has measured: two SVG pictures with logarithmic axes, cost of a step and
// time to a finished map against the number of triangles. Usage: plot_bench RESULTS.json FOLDER
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

struct Series
{
    QString key; //!< in the results
    QString label;
    QString color;
};

struct Plot
{
    QString file, title, unit;
    std::vector<Series> series;
};

constexpr double width = 640, height = 420, left = 70, right = 150, top = 40, bottom = 50;

//! Decades that an axis spans.
struct Axis
{
    double low = 0, high = 1; //!< logarithms to base 10

    static Axis around(const std::vector<double> &values)
    {
        Axis axis{1e9, -1e9};
        for (const double value : values) {
            axis.low = std::min(axis.low, std::floor(std::log10(value)));
            axis.high = std::max(axis.high, std::ceil(std::log10(value)));
        }
        if (!(axis.low < axis.high))
            axis.high = axis.low + 1;
        return axis;
    }
    double at(double value, double from, double to) const
    {
        return from + (to - from) * (std::log10(value) - low) / (high - low);
    }
};

QString number(double value)
{
    return value >= 1e6   ? QStringLiteral("%1M").arg(value / 1e6)
           : value >= 1e3 ? QStringLiteral("%1K").arg(value / 1e3)
                          : QString::number(value);
}

QString line(double x1, double y1, double x2, double y2, const QString &style)
{
    return QStringLiteral("<line x1='%1' y1='%2' x2='%3' y2='%4' %5/>\n")
        .arg(x1)
        .arg(y1)
        .arg(x2)
        .arg(y2)
        .arg(style);
}

QString text(double x, double y, const QString &content, const QString &style)
{
    return QStringLiteral("<text x='%1' y='%2' %3>%4</text>\n").arg(x).arg(y).arg(style, content);
}

QString axes(const Axis &x, const Axis &y, const Plot &plot)
{
    QString svg;
    const double floor = height - bottom, wall = width - right;
    for (double decade = x.low; decade <= x.high; ++decade) {
        const double at = x.at(std::pow(10, decade), left, wall);
        svg += line(at, top, at, floor, QStringLiteral("stroke='#ddd'"));
        svg += text(at, floor + 18, number(std::pow(10, decade)), QStringLiteral("text-anchor='middle'"));
    }
    for (double decade = y.low; decade <= y.high; ++decade) {
        const double at = y.at(std::pow(10, decade), floor, top);
        svg += line(left, at, wall, at, QStringLiteral("stroke='#ddd'"));
        svg += text(left - 8, at + 4, number(std::pow(10, decade)), QStringLiteral("text-anchor='end'"));
    }
    svg += text(left, top - 16, plot.title, QStringLiteral("font-weight='bold'"));
    svg += text((left + wall) / 2, height - 12, QStringLiteral("triangles"),
                QStringLiteral("text-anchor='middle'"));
    svg += text(left - 50, top - 16, plot.unit, {});
    return svg;
}

QString drawn(const Plot &plot, const QJsonArray &results)
{
    std::vector<double> xs, ys;
    for (const Series &series : plot.series) {
        for (const QJsonValue &result : results) {
            if (result[series.key].toDouble() > 0) {
                xs.push_back(result[QStringLiteral("triangles")].toDouble());
                ys.push_back(result[series.key].toDouble());
            }
        }
    }
    if (xs.empty())
        return {};
    const Axis x = Axis::around(xs), y = Axis::around(ys);
    QString svg =
        QStringLiteral(
            "<svg xmlns='http://www.w3.org/2000/svg' width='%1' height='%2' viewBox='0 0 %1 %2' "
            "font-family='sans-serif' font-size='13'>\n<rect width='%1' height='%2' fill='white'/>\n")
            .arg(width)
            .arg(height);
    svg += axes(x, y, plot);
    double legend = top + 10;
    for (const Series &series : plot.series) {
        std::vector<std::pair<double, double>> points;
        for (const QJsonValue &result : results) {
            const double value = result[series.key].toDouble();
            if (value > 0)
                points.emplace_back(x.at(result[QStringLiteral("triangles")].toDouble(), left, width - right),
                                    y.at(value, height - bottom, top));
        }
        if (points.empty())
            continue;
        std::sort(points.begin(), points.end());
        QString path;
        for (const auto &[px, py] : points) {
            path += QStringLiteral("%1,%2 ").arg(px).arg(py);
            svg += QStringLiteral("<circle cx='%1' cy='%2' r='3.5' fill='%3'/>\n")
                       .arg(px)
                       .arg(py)
                       .arg(series.color);
        }
        svg += QStringLiteral("<polyline points='%1' fill='none' stroke='%2' stroke-width='2'/>\n")
                   .arg(path.trimmed(), series.color);
        svg += line(width - right + 10, legend, width - right + 34, legend,
                    QStringLiteral("stroke='%1' stroke-width='2'").arg(series.color));
        svg += text(width - right + 40, legend + 4, series.label, {});
        legend += 22;
    }
    return svg + QStringLiteral("</svg>\n");
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 3) {
        std::fputs("usage: plot_bench RESULTS.json FOLDER\n", stderr);
        return 2;
    }
    QFile results(QString::fromLocal8Bit(argv[1]));
    if (!results.open(QIODevice::ReadOnly)) {
        std::fprintf(stderr, "plot_bench: cannot read %s\n", argv[1]);
        return 1;
    }
    const QJsonDocument document = QJsonDocument::fromJson(results.readAll());
    const QString folder = QString::fromLocal8Bit(argv[2]);
    const QString exactColor = QStringLiteral("#888888"), fastColor = QStringLiteral("#DB2512"),
                  soupColor = QStringLiteral("#1F77B4");
    const std::vector<Plot> plots{
        {QStringLiteral("step_cost.svg"),
         QStringLiteral("One solver step"),
         QStringLiteral("ms"),
         {{QStringLiteral("step_ms_exact"), QStringLiteral("exact Newton"), exactColor},
          {QStringLiteral("step_ms_fast"), QStringLiteral("fast"), fastColor}}},
        {QStringLiteral("map_time.svg"),
         QStringLiteral("Finished map"),
         QStringLiteral("CPU s"),
         {{QStringLiteral("exact_soup_map_seconds"), QStringLiteral("soup, exact"), exactColor},
          {QStringLiteral("soup_map_seconds"), QStringLiteral("soup, fast"), soupColor},
          {QStringLiteral("map_seconds"), QStringLiteral("automatic"), fastColor}}}};
    for (const Plot &plot : plots) {
        const QString svg = drawn(plot, document.array());
        if (svg.isEmpty())
            continue;
        QFile file(folder + QLatin1Char('/') + plot.file);
        if (!file.open(QIODevice::WriteOnly) || file.write(svg.toUtf8()) < 0) {
            std::fprintf(stderr, "plot_bench: cannot write %s\n", qPrintable(file.fileName()));
            return 1;
        }
    }
}
