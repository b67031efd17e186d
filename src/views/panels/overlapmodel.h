// The list model of overlaps.
#pragma once

#include <QAbstractListModel>

#include <array>
#include <vector>

namespace autocuts {

//! An overlap of two faces, with their islands.
struct OverlapRow
{
    std::array<int, 2> faces{}, islands{};
};

//! One row per overlapping pair of faces, in the given order.
class OverlapModel final : public QAbstractListModel
{
    Q_OBJECT

public:
    explicit OverlapModel(QObject *parent = nullptr) : QAbstractListModel(parent) {}

    void setRows(std::vector<OverlapRow> rows);
    const OverlapRow &row(int index) const { return mRows[index]; }

    int rowCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;

private:
    std::vector<OverlapRow> mRows;
};

} // namespace autocuts
