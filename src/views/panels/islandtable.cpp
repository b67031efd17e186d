#include "views/panels/islandtable.h"

#include "model/document/islandcolor.h"
#include "views/ui/icons.h"
#include "views/ui/numbertext.h"

#include <QStringList>

#include <cmath>

namespace autocuts {

bool IslandTable::hasTexts(int column) const
{
    for (int island = 0; island < rowCount(); ++island) {
        if (!text(figures()[island], island, column).isEmpty())
            return true;
    }
    return false;
}

QString IslandTable::text(const IslandFigures &figures, int island, int column) const
{
    switch (column) {
    case Number: {
        const QStringList names(figures.tags.begin(), figures.tags.end());
        return names.isEmpty()
                   ? QString::number(island + 1)
                   : QStringLiteral("%1 %2").arg(island + 1).arg(names.join(QStringLiteral(", ")));
    }
    case Faces:
        return countText(figures.faces);
    case Area:
        return percentText(figures.areaShare);
    case Density:
        return significantText(figures.texelDensity, 4);
    case Shown:
        return std::isfinite(figures.shownDensity) ? significantText(figures.shownDensity, 4) : QString();
    case Distortion:
        return fixedText(figures.distortion, 3);
    case Stack:
        return figures.flags.stack == 0 ? QString() : QString::number(figures.flags.stack);
    case Group:
        return figures.flags.group == 0 ? QString() : QString::number(figures.flags.group);
    default:
        return {};
    }
}

QVariant IslandTable::sortKey(const IslandFigures &figures, int island, int column) const
{
    switch (column) {
    case Faces:
        return figures.faces;
    case Area:
        return figures.areaShare;
    case Density:
        return sortable(figures.texelDensity);
    case Shown:
        return sortable(figures.shownDensity);
    case Distortion:
        return sortable(figures.distortion);
    case Lock:
        return figures.flags.locked;
    case Stack:
        return figures.flags.stack;
    case Group:
        return figures.flags.group;
    default:
        return island;
    }
}

QVariant IslandTable::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const IslandFigures &own = figures()[index.row()];
    switch (role) {
    case Qt::DisplayRole:
        return text(own, index.row(), index.column());
    case Qt::DecorationRole:
        return index.column() == Number ? QVariant(QColor(islandColor(index.row()))) : QVariant();
    case Qt::CheckStateRole:
        if (index.column() == Lock)
            return own.flags.locked ? Qt::Checked : Qt::Unchecked;
        return {};
    case Qt::TextAlignmentRole:
        return index.column() == Number
                   ? QVariant()
                   : QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    case Qt::ToolTipRole:
        return index.column() == Number ? QVariant(text(own, index.row(), Number)) : QVariant();
    case sortRole:
        return sortKey(own, index.row(), index.column());
    default:
        return {};
    }
}

QVariant IslandTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    const std::pair<QString, QString> titles[ColumnCount] = {
        {tr("Island"), tr("Colour, number and tags")},
        {QString(), tr("Locked islands are not moved")},
        {tr("Faces"), tr("Number of faces")},
        {tr("Area"), tr("Share of the model's surface")},
        {tr("px/unit"),
         tr("Texel density: texels per unit of the model at the texture size of the Packing panel, where the "
            "painted texel density weight is 1")},
        {tr("true px"), tr("Texels per unit of the model that the island has, with its painted weights")},
        {tr("D"),
         tr("Mean distortion of the island, whatever its size: symmetric Dirichlet energy, 4 where nothing "
            "is distorted")},
        {QString(), tr("Islands of one stack lie on top of each other")},
        {QString(), tr("Islands of one group move together")},
    };
    if (role == Qt::DisplayRole)
        return titles[section].first;
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
        return titles[section].second;
    if (role != Qt::DecorationRole)
        return {};
    switch (section) {
    case Lock:
        return icon(QStringLiteral("lock"));
    case Stack:
        return icon(QStringLiteral("stack"));
    case Group:
        return icon(QStringLiteral("group"));
    default:
        return {};
    }
}

Qt::ItemFlags IslandTable::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags common = QAbstractTableModel::flags(index);
    return index.column() == Lock ? common | Qt::ItemIsUserCheckable : common;
}

bool IslandTable::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::CheckStateRole || index.column() != Lock)
        return false;
    Q_EMIT lockRequested(index.row(), value.toInt() == Qt::Checked);
    // The row changes after the document has changed.
    return false;
}

} // namespace autocuts
