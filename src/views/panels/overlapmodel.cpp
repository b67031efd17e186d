#include "views/panels/overlapmodel.h"

#include "views/ui/numbertext.h"

namespace autocuts {

void OverlapModel::setRows(std::vector<OverlapRow> rows)
{
    beginResetModel();
    mRows = std::move(rows);
    endResetModel();
}

int OverlapModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(mRows.size());
}

QVariant OverlapModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || role != Qt::DisplayRole)
        return {};
    const OverlapRow &row = mRows[index.row()];
    // Shown numbers start at 1.
    const QString faces = tr("faces %1 and %2").arg(countText(row.faces[0] + 1), countText(row.faces[1] + 1));
    if (row.faces[0] == row.faces[1])
        return tr("Island %1: face %2 covers itself")
            .arg(countText(row.islands[0] + 1), countText(row.faces[0] + 1));
    if (row.islands[0] == row.islands[1])
        return tr("Island %1: %2").arg(countText(row.islands[0] + 1), faces);
    return tr("Islands %1 and %2: %3")
        .arg(countText(row.islands[0] + 1), countText(row.islands[1] + 1), faces);
}

} // namespace autocuts
