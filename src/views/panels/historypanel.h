// The panel of the undo history.
#pragma once

#include "views/panels/panel.h"

class QLabel;

namespace autocuts {

class HistoryView;

//! Lists the undo entries with a mark at the saved state. A click goes to an entry. Entries whose contents
//! were released to save memory are grey and cannot be selected.
class HistoryPanel final : public Panel
{
    Q_OBJECT

public:
    explicit HistoryPanel(const StudioContext &context, QWidget *parent = nullptr);

protected:
    void refresh() override;

private:
    void replaceStack();

    HistoryView *mView;
    QLabel *mMemory;
};

} // namespace autocuts
