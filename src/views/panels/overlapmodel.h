// The overlaps of a map as a list.
#pragma once

#include <QAbstractListModel>

#include <array>
#include <vector>

namespace autocuts {

//! One overlap: two faces, and the islands they are in.
struct OverlapRow
{
    std::array<int, 2> faces{}, islands{};
};

//! One row per overlapping pair of faces, in the order given.
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
