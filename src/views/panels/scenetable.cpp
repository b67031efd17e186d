#include "views/panels/scenetable.h"

#include "views/ui/icons.h"
#include "views/ui/numbertext.h"

#include <cmath>
#include <numeric>
#include <utility>

namespace autocuts {

namespace {

//! A field of a CSV file (RFC 4180).
QString csvField(QString text)
{
    if (!text.contains(u'"') && !text.contains(u',') && !text.contains(u'\n'))
        return text;
    return u'"' + text.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

QString csvNumber(double value)
{
    return std::isfinite(value) ? QString::number(value, 'g', 7) : QString();
}

} // namespace

void SceneTable::setFigures(SceneKind kind, std::vector<SceneFigures> figures)
{
    const bool others = std::exchange(mKind, kind) != kind;
    replaceFigures(std::move(figures), others);
}

QString SceneTable::nameOf(int row) const
{
    const SceneGroup &group = figures()[static_cast<std::size_t>(row)].group;
    if (!group.name.isEmpty())
        return group.name;
    if (mKind == SceneKind::Objects)
        return group.number < 0 ? tr("(no object)") : tr("(object %1)").arg(group.number + 1);
    return group.number < 0 ? tr("(no material)") : tr("(material %1)").arg(group.number + 1);
}

QByteArray SceneTable::csv(const std::vector<int> &rows) const
{
    std::vector<int> chosen = rows;
    if (chosen.empty()) {
        chosen.resize(figures().size());
        std::iota(chosen.begin(), chosen.end(), 0);
    }
    QString text = QStringLiteral("name,faces,islands,distortion,texels_per_unit,efficiency\n");
    for (int row : chosen) {
        const SceneFigures &own = figures()[static_cast<std::size_t>(row)];
        text += csvField(nameOf(row)) + u',' + QString::number(own.group.faces.size()) + u',' +
                QString::number(own.islands) + u',' + csvNumber(own.distortion) + u',' +
                csvNumber(own.texelDensity) + u',' + csvNumber(own.share) + u'\n';
    }
    return text.toUtf8();
}

QString SceneTable::text(int row, int column) const
{
    const SceneFigures &own = figures()[static_cast<std::size_t>(row)];
    switch (column) {
    case Name:
        return nameOf(row);
    case Faces:
        return countText(own.group.faces.size());
    case Islands:
        return countText(own.islands);
    case Distortion:
        return fixedText(own.distortion, 3);
    case Density:
        return significantText(own.texelDensity, 4);
    case Share:
        return percentText(own.share);
    default:
        return {};
    }
}

QVariant SceneTable::sortKey(int row, int column) const
{
    const SceneFigures &own = figures()[static_cast<std::size_t>(row)];
    switch (column) {
    case Eye:
        return own.hiddenFaces > 0;
    case Name:
        return nameOf(row);
    case Faces:
        return own.group.faces.size();
    case Islands:
        return own.islands;
    case Distortion:
        return sortable(own.distortion);
    case Density:
        return sortable(own.texelDensity);
    default:
        return own.share;
    }
}

QVariant SceneTable::decoration(int row, int column) const
{
    const SceneFigures &own = figures()[static_cast<std::size_t>(row)];
    if (column == Eye)
        return icon(own.isHidden() ? QStringLiteral("hide") : QStringLiteral("show"));
    if (column == Name && mKind == SceneKind::Materials)
        return QColor(own.color);
    return {};
}

QString SceneTable::eyeText(const SceneFigures &figures) const
{
    return figures.isHidden()        ? tr("Hidden: a click shows it, with Alt it alone")
           : figures.hiddenFaces > 0 ? tr("%1 of its faces are hidden").arg(countText(figures.hiddenFaces))
                                     : tr("Shown: a click hides it, with Alt it alone is shown");
}

QVariant SceneTable::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const SceneFigures &own = figures()[static_cast<std::size_t>(index.row())];
    const bool leftAligned = index.column() <= Name;
    switch (role) {
    case Qt::DisplayRole:
        return text(index.row(), index.column());
    case Qt::DecorationRole:
        return decoration(index.row(), index.column());
    case Qt::TextAlignmentRole:
        return leftAligned ? QVariant()
                           : QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return index.column() == Eye    ? eyeText(own)
               : index.column() == Name ? nameOf(index.row())
                                        : QString();
    case sortRole:
        return sortKey(index.row(), index.column());
    default:
        return {};
    }
}

QVariant SceneTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    const std::pair<QString, QString> titles[ColumnCount] = {
        {QString(), tr("What is shown in the views")},
        {mKind == SceneKind::Objects ? tr("Object") : tr("Material"), tr("Name in the file")},
        {tr("Faces"), tr("Number of faces")},
        {tr("Islands"), tr("Number of islands of the map")},
        {tr("D"),
         tr("Mean distortion of its islands, each at its own size: symmetric Dirichlet energy, 4 where "
            "nothing is distorted")},
        {tr("px/unit"),
         tr("Texel density: texels per unit of the model at the texture size of the Packing panel")},
        {tr("Use"), tr("The part of a texture that its islands take")},
    };
    if (role == Qt::DisplayRole)
        return titles[section].first;
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
        return titles[section].second;
    if (role == Qt::DecorationRole && section == Eye)
        return icon(QStringLiteral("show"));
    return {};
}

} // namespace autocuts
