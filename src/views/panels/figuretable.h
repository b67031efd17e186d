// What the tables of islands and of the scene have in common.
#pragma once

#include <QAbstractTableModel>
#include <QItemSelection>
#include <QTableView>

#include <cmath>
#include <utility>
#include <vector>

namespace autocuts {

//! A table model with one row for each element of a vector. Does not use the document.
template <typename Figures>
class FigureTable : public QAbstractTableModel
{
public:
    static constexpr int sortRole = Qt::UserRole;

    const std::vector<Figures> &figures() const { return mFigures; }
    int rowCount(const QModelIndex &parent = {}) const final
    {
        return parent.isValid() ? 0 : static_cast<int>(mFigures.size());
    }
    int columnCount(const QModelIndex &parent = {}) const final { return parent.isValid() ? 0 : mColumns; }

protected:
    FigureTable(int columns, QObject *parent) : QAbstractTableModel(parent), mColumns(columns) {}

    //! \param others the rows are no longer about the same things
    void replaceFigures(std::vector<Figures> figures, bool others = false)
    {
        if (others || figures.size() != mFigures.size()) {
            beginResetModel();
            mFigures = std::move(figures);
            endResetModel();
            return;
        }
        mFigures = std::move(figures);
        if (!mFigures.empty())
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, mColumns - 1));
    }

    //! A sort key: NaN sorts before all other values.
    static double sortable(double value) { return std::isnan(value) ? -1 : value; }

private:
    const int mColumns;
    std::vector<Figures> mFigures;
};

//! Selects the wanted rows of a view, and no others. \param isWanted called with rows of the view
template <typename IsWanted>
void selectRowsOf(QTableView &view, IsWanted isWanted)
{
    const QAbstractItemModel &model = *view.model();
    QItemSelection selection;
    for (int first = 0; first < model.rowCount(); ++first) {
        if (!isWanted(first))
            continue;
        int last = first;
        while (last + 1 < model.rowCount() && isWanted(last + 1))
            ++last;
        selection.select(model.index(first, 0), model.index(last, model.columnCount() - 1));
        first = last;
    }
    view.selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
}

} // namespace autocuts
