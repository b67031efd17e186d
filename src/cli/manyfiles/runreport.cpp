#include "cli/manyfiles/runreport.h"

#include "cli/manyfiles/filerunner.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>

namespace autocuts::manyfiles {

namespace {

using namespace Qt::Literals::StringLiterals;

//! The figures that the table and the page show, of those that there are.
QStringList shownFigures(const RunReport &report)
{
    static const QStringList all{u"triangles"_s,        u"charts"_s,        u"seam_length"_s,
                                 u"seam_norm"_s,        u"sym_dirichlet"_s, u"sym_dirichlet_max"_s,
                                 u"flipped"_s,          u"overlap_pairs"_s, u"packing_efficiency"_s,
                                 u"min_gutter_texels"_s};
    QStringList shown;
    for (const QString &name : all) {
        if (std::any_of(report.results.begin(), report.results.end(),
                        [&](const FileResult &result) { return result.figures.contains(name); }))
            shown << name;
    }
    return shown;
}

QString numberText(const QJsonValue &value)
{
    return value.isDouble() ? QString::number(value.toDouble(), 'g', 6) : QString();
}

QString csvCell(const QString &text)
{
    static const QStringList special{u","_s, u"\""_s, u"\n"_s, u"\r"_s};
    if (std::none_of(special.begin(), special.end(), [&](const QString &c) { return text.contains(c); }))
        return text;
    return u'"' + QString(text).replace(u'"', u"\"\""_s) + u'"';
}

//! 0 for the files to look at first.
int urgency(const FileResult &result)
{
    if (!result.succeeded())
        return 0;
    return result.status != u"done" || !result.warnings.isEmpty() ? 1 : 2;
}

constexpr const char *pageBegin = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Autocuts batch</title><style>
body { font: 14px system-ui, sans-serif; margin: 1.5em; color: #222; background: #fff }
table { border-collapse: collapse } th, td { padding: .3em .6em; border-bottom: 1px solid #ddd; text-align: right }
th { position: sticky; top: 0; background: #eee; cursor: pointer; white-space: nowrap }
td.text, th:nth-child(-n+4) { text-align: left } td img { display: block } td.text div { max-width: 30em; font-size: 90% }
tr.u0 { background: #fbe3e1 } tr.u1 { background: #fdf4d8 } small { color: #666; display: block }
th.up::after { content: " \25b2" } th.down::after { content: " \25bc" }
</style></head><body>
)";

constexpr const char *pageEnd = R"(</tbody></table><script>
const table = document.querySelector("table"), body = table.tBodies[0];
const key = (row, column) => row.cells[column].dataset.key ?? row.cells[column].textContent;
for (const head of table.querySelectorAll("th"))
    head.onclick = () => {
        const up = !head.classList.contains("up"), column = head.cellIndex;
        for (const other of table.querySelectorAll("th")) other.classList.remove("up", "down");
        head.classList.add(up ? "up" : "down");
        const rows = [...body.rows];
        rows.sort((a, b) => {
            const x = key(a, column), y = key(b, column);
            if ((x === "") !== (y === "")) return x === "" ? 1 : -1;
            const order = isNaN(x) || isNaN(y) ? x.localeCompare(y) : x - y;
            return up ? order : -order;
        });
        body.append(...rows);
    };
const find = document.querySelector("#find"), state = document.querySelector("#state");
find.oninput = state.onchange = () => {
    for (const row of body.rows)
        row.hidden = !row.textContent.toLowerCase().includes(find.value.toLowerCase()) ||
            (state.value !== "" && !row.classList.contains(state.value));
};
</script></body></html>
)";

QString heading(const QString &name)
{
    return u"<th>"_s + QString(name).replace(u'_', u' ') + u"</th>"_s;
}

//! A figure, and what has changed since the run before.
QString figureCell(const QJsonValue &value, const QJsonValue &before)
{
    QString cell = u"<td data-key=\"%1\">%2"_s.arg(
        value.isDouble() ? QString::number(value.toDouble(), 'g', 17) : QString(), numberText(value));
    if (value.isDouble() && before.isDouble() && value.toDouble() != before.toDouble()) {
        const double change = value.toDouble() - before.toDouble();
        cell += u"<small>%1%2</small>"_s.arg(change > 0 ? u"+"_s : QString(), numberText(change));
    }
    return cell + u"</td>"_s;
}

QString pictureCell(const RunReport &report, const FileResult &result)
{
    QFile file(QDir(report.pictures).filePath(FileRunner::pictureName(result.task)));
    if (!result.succeeded() || !file.open(QIODevice::ReadOnly))
        return u"<td></td>"_s;
    return u"<td><img alt=\"\" src=\"data:image/png;base64,"_s +
           QString::fromLatin1(file.readAll().toBase64()) + u"\"></td>"_s;
}

QString row(const RunReport &report, const QStringList &figures, const FileResult &result)
{
    const auto found = report.before.find(result.task.output);
    const FileResult before = found == report.before.end() ? FileResult() : found->second;
    QString out = u"<tr class=\"u%1\">"_s.arg(urgency(result)) + pictureCell(report, result) +
                  u"<td class=\"text\">"_s + result.task.input.toHtmlEscaped() + u"</td>"_s;
    out += u"<td class=\"text\">"_s + result.status;
    if (!before.status.isEmpty() && before.status != result.status)
        out += u"<small>was %1</small>"_s.arg(before.status.toHtmlEscaped());
    out += u"</td><td class=\"text\">"_s;
    for (const QString &line : QStringList{result.message} + result.warnings)
        out += line.isEmpty() ? QString() : u"<div>"_s + line.toHtmlEscaped() + u"</div>"_s;
    out += u"</td>"_s;
    for (const QString &name : figures)
        out += figureCell(result.figures[name], before.figures[name]);
    return out + figureCell(result.seconds, QJsonValue()) + u"</tr>\n"_s;
}

} // namespace

std::map<QString, int> countsOf(const std::vector<FileResult> &results)
{
    std::map<QString, int> counts;
    for (const FileResult &result : results)
        ++counts[result.status];
    return counts;
}

QByteArray csvReport(const RunReport &report)
{
    const QStringList figures = shownFigures(report);
    QString out =
        (QStringList{u"input"_s, u"output"_s, u"status"_s, u"message"_s, u"warnings"_s, u"seconds"_s} +
         figures)
            .join(u',') +
        u'\n';
    for (const FileResult &result : report.results) {
        QStringList cells{result.task.input,
                          result.task.output,
                          result.status,
                          result.message,
                          result.warnings.join(u"; "_s),
                          numberText(result.seconds)};
        for (const QString &name : figures)
            cells << numberText(result.figures[name]);
        std::transform(cells.begin(), cells.end(), cells.begin(), csvCell);
        out += cells.join(u',') + u'\n';
    }
    return out.toUtf8();
}

QByteArray jsonReport(const RunReport &report)
{
    QJsonArray files;
    for (const FileResult &result : report.results)
        files.append(result.toJson());
    QJsonObject counts;
    for (const auto &[status, count] : countsOf(report.results))
        counts.insert(status, count);
    return QJsonDocument(
               QJsonObject{{u"command"_s, report.choice.command}, {u"counts"_s, counts}, {u"files"_s, files}})
        .toJson();
}

QByteArray htmlReport(const RunReport &report)
{
    const QStringList figures = shownFigures(report);
    std::vector<FileResult> sorted = report.results;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const FileResult &a, const FileResult &b) { return urgency(a) < urgency(b); });
    QStringList counts;
    for (const auto &[status, count] : countsOf(report.results))
        counts << u"%1 %2"_s.arg(count).arg(status);
    QString out = QString::fromLatin1(pageBegin);
    out += u"<h1>autocuts-cli batch %1</h1>\n<p>%2 files: %3.%4</p>\n"_s.arg(
        (QStringList{report.choice.command} + report.choice.passed).join(u' ').toHtmlEscaped(),
        QString::number(report.results.size()), counts.join(u", "_s),
        report.before.empty() ? QString() : u" Small figures are the difference to the run before."_s);
    out +=
        u"<p><input id=\"find\" placeholder=\"Filter\"> <select id=\"state\"><option value=\"\">All</option>"
        "<option value=\"u0\">Failed</option><option value=\"u1\">With warnings</option>"
        "<option value=\"u2\">Fine</option></select></p>\n<table><thead><tr><th></th>"_s;
    for (const QString &name :
         QStringList{u"file"_s, u"status"_s, u"message"_s} + figures + QStringList{u"seconds"_s})
        out += heading(name);
    out += u"</tr></thead><tbody>\n"_s;
    QByteArray page = out.toUtf8(); // the rows have the pictures, which take most of the memory
    for (const FileResult &result : sorted)
        page += row(report, figures, result).toUtf8();
    return page + pageEnd;
}

} // namespace autocuts::manyfiles
