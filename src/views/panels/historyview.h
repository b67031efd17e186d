// The list of the history panel.
#pragma once

#include "model/document/undostack.h"

#include <QPointer>
#include <QUndoView>

namespace autocuts {

//! A QUndoView with icons, in which released entries are grey and cannot be selected.
class HistoryView final : public QUndoView
{
    Q_OBJECT

public:
    explicit HistoryView(QWidget *parent = nullptr);

    void setHistory(UndoStack *stack);

protected:
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;

private:
    bool isReachable(const QModelIndex &index) const;

    QPointer<UndoStack> mStack;
};

} // namespace autocuts
