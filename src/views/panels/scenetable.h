// The table model of the objects or materials.
#pragma once

#include "views/control/figures/scenefigures.h"
#include "views/panels/figuretable.h"

namespace autocuts {

//! One row per object or material.
class SceneTable final : public FigureTable<SceneFigures>
{
    Q_OBJECT

public:
    enum Column { Eye, Name, Faces, Islands, Distortion, Density, Share, ColumnCount };

    explicit SceneTable(QObject *parent = nullptr) : FigureTable(ColumnCount, parent) {}

    void setFigures(SceneKind kind, std::vector<SceneFigures> figures);
    //! The name in the file, or words for what has none.
    QString nameOf(int row) const;
    //! The rows as comma-separated values with a line of titles. \param rows all when empty
    QByteArray csv(const std::vector<int> &rows) const;

    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(int row, int column) const;
    QVariant sortKey(int row, int column) const;
    QVariant decoration(int row, int column) const;
    QString eyeText(const SceneFigures &figures) const;

    SceneKind mKind = SceneKind::Objects;
};

} // namespace autocuts
