// The table model of the objects or materials.
#pragma once

#include "views/control/scenefigures.h"

#include <QAbstractTableModel>

namespace autocuts {

//! One row per object or material. Does not use the document.
class SceneTable final : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Eye, Name, Faces, Islands, Distortion, Density, Share, ColumnCount };
    static constexpr int sortRole = Qt::UserRole;

    explicit SceneTable(QObject *parent = nullptr) : QAbstractTableModel(parent) {}

    void setFigures(SceneKind kind, std::vector<SceneFigures> figures);
    const std::vector<SceneFigures> &figures() const { return mFigures; }
    //! The name in the file, or words for what has none.
    QString nameOf(int row) const;
    //! The rows as comma-separated values with a line of titles. \param rows all when empty
    QByteArray csv(const std::vector<int> &rows) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(int row, int column) const;
    QVariant sortKey(int row, int column) const;
    QVariant decoration(int row, int column) const;
    QString eyeText(const SceneFigures &figures) const;

    SceneKind mKind = SceneKind::Objects;
    std::vector<SceneFigures> mFigures;
};

} // namespace autocuts
