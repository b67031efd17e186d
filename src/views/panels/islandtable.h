// The table model of the islands.
#pragma once

#include "views/control/figures/islandfigures.h"
#include "views/panels/figuretable.h"

namespace autocuts {

//! One row per island, in the order of Document::islands().
class IslandTable final : public FigureTable<IslandFigures>
{
    Q_OBJECT

public:
    enum Column { Number, Lock, Faces, Area, Density, Shown, Distortion, Stack, Group, ColumnCount };

    explicit IslandTable(QObject *parent = nullptr) : FigureTable(ColumnCount, parent) {}

    void setFigures(std::vector<IslandFigures> figures) { replaceFigures(std::move(figures)); }
    //! Whether any row has a text in the column.
    bool hasTexts(int column) const;

    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    //! Accepts only the check box of the lock, and emits lockRequested().
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

Q_SIGNALS:
    //! The lock of an island was clicked.
    void lockRequested(int island, bool locked);

private:
    QString text(const IslandFigures &figures, int island, int column) const;
    QVariant sortKey(const IslandFigures &figures, int island, int column) const;
};

} // namespace autocuts
